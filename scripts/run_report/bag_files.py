"""The bags of a run: where they are, and their messages, also those of a bag that was not closed or is damaged."""
import contextlib
import os
import shutil
import tempfile

import rosbag

from readable_bag import DAMAGE, is_of_the_system, why_no_bag
from run_recording import runs

from .drawing import clock


class ReportError(Exception):
    """Why no report can be made, in words for the user."""


def find_parts(word, folder):
    """The bags that `word` means: `latest` (in the folder of runs), the folder of a run, or a bag."""
    if word == 'latest':
        recorded = [run for run in runs.all_runs(folder) if runs.parts_of(run)]
        if not recorded:
            raise ReportError('no run is recorded in %s; record:=true with a launch file records one' % folder)
        return runs.parts_of(recorded[-1])
    if os.path.isdir(word):
        names = runs.parts_of(word) or sorted(
            os.path.join(word, name) for name in os.listdir(word) if name.endswith(('.bag', '.bag.active')))
        if not names:
            raise ReportError('%s: there is no bag in this folder' % word)
        return names
    if not os.path.exists(word):
        raise ReportError("%s: there is no such bag; 'latest' is the last one that was recorded" % word)
    return [word]


class BagFiles:
    """The messages of several bags in the order of their times, and `notes` of what could not be read. A context: bags that
    had to be repaired are copies in a temporary folder, and the originals stay as they are."""

    def __init__(self, paths):
        self.paths, self.notes, self.bags = paths, [], []
        self.stretches = {}  # of a run to which the bags belong
        self.damaged_at = []  # the times after which something is left out [s]
        self.unreadable = False  # whether nothing of a bag is there
        self.closer = contextlib.ExitStack()

    def __enter__(self):
        with self.closer as opened:
            for path in self.paths:
                self._take(path)
            self.bags.sort(key=lambda bag: bag.get_start_time())
            if not self.bags:
                raise ReportError('; '.join(self.notes) or 'the bag is empty')
            self.notes += self._gaps()
            self.closer = opened.pop_all()  # nothing went wrong: they stay open
        return self

    def __exit__(self, *_):
        self.closer.close()

    def _take(self, path):
        name = os.path.basename(path)
        why = why_no_bag(path)
        if why:
            self.unreadable = True
            return self.notes.append('%s: it cannot be read: %s' % (name, why))
        try:
            bag = self._open(path, name)
            if bag.get_message_count() == 0:
                self.unreadable = True
                return self.notes.append('%s: it holds no message' % name)
            self.closer.enter_context(bag)
            self.bags.append(bag)
            self.stretches[bag] = runs.stretch_of(path)
            if bag.filename != path:
                self.damaged_at.append(bag.get_end_time())  # a copy that was mended
        except DAMAGE as error:
            if is_of_the_system(error):
                raise
            self.unreadable = True
            self.notes.append('%s: it cannot be read: %s' % (name, str(error) or type(error).__name__))

    def _open(self, path, name):
        try:
            bag = rosbag.Bag(path)
            if not path.endswith('.active'):
                return bag
            bag.close()
        except rosbag.ROSBagUnindexedException:
            pass
        if runs.is_open(path):
            self.notes.append('%s is still being recorded: the page shows what was on the disk' % name)
        else:
            self.notes.append('%s was not closed, because the recorder was killed or the computer switched off, or it is damaged: '
                              'some of it may be missing' % name)
        copy = os.path.join(self.closer.enter_context(tempfile.TemporaryDirectory()), 'copy.bag')
        try:
            shutil.copyfile(path, copy)
            with rosbag.Bag(copy, 'a', allow_unindexed=True) as broken:
                for _ in broken.reindex():
                    pass
        except OSError as error:
            if not is_of_the_system(error):
                raise
            raise ReportError('%s cannot be copied to %s, to be read from there: %s; TMPDIR=FOLDER takes another folder' % (
                name, os.path.dirname(copy), error.strerror)) from error
        return rosbag.Bag(copy)

    def _breaks(self):
        """Where the recorder had to begin again: the times of its last message before and of its first one after it [s]."""
        return [(before.get_end_time(), after.get_start_time()) for before, after in zip(self.bags, self.bags[1:])
                if self.stretches[before] != self.stretches[after]]

    def _gaps(self):
        first, _ = self.span()
        return ['Nothing was recorded from %s to %s: the disk was full, or rosbag had ended for another reason.' % (
            clock(end - first), clock(begin - first)) for end, begin in self._breaks()]

    def has_a_break(self, begin, end):
        """Whether the recorder began again between these times [s], or something that it wrote then could not be read."""
        return self.unreadable or any(begin <= time < end for time in self.damaged_at) or \
            any(begin <= last and first <= end for last, first in self._breaks())

    def has_the_first_part(self):
        """Whether the oldest of the bags is where the recorder began, or a single bag that it did not write."""
        return any(runs.is_first_part(path) for path in self.paths)

    def topics(self):
        """The types of the topics, by name."""
        return {name: info.msg_type for bag in self.bags for name, info in bag.get_type_and_topic_info().topics.items()}

    def span(self):
        """The times of the first and of the last message [s]."""
        return min(bag.get_start_time() for bag in self.bags), max(bag.get_end_time() for bag in self.bags)

    def messages(self, topics):
        """(topic, message, time [s]) of these topics. After damaged data the rest of a bag is left out, with a note."""
        if not topics:
            return  # rosbag would take that for all topics
        for bag in self.bags:
            last = bag.get_start_time()
            try:
                for topic, message, time in bag.read_messages(topics=topics):
                    last = time.to_sec()
                    yield topic, message, last
            except DAMAGE as error:
                if is_of_the_system(error):
                    raise
                self.damaged_at.append(last)
                note = '%s is damaged after %.0f s: %s' % (os.path.basename(bag.filename), last - self.span()[0],
                                                           str(error) or type(error).__name__)
                if note not in self.notes:
                    self.notes.append(note)
