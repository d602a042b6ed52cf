"""The folder in which recorded runs are kept: each in a folder of its own, named by the date and time of its start."""
import datetime
import os
import re
import stat

from . import free_name

BAG = 'run'  # rosbag adds the number of the part
REPORT = 'report.html'  # what the report adds
NAME = re.compile(r'^\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d(_\d+)?$')
# The number of the stretch, unless it is the first, and of the part.
PART = re.compile(r'^%s_(?:(\d+)_)?(\d+)\.bag(\.active)?$' % BAG)
# An empty file that says that run_recorder has made this folder, and when, by a number.
MARKER = re.compile(r'^made_by_run_recorder\.(\d+)$')


def default_folder():
    """ROS_HOME/frontier_pilot/runs."""
    ros_home = os.environ.get('ROS_HOME') or os.path.join(os.path.expanduser('~'), '.ros')
    return os.path.join(ros_home, 'frontier_pilot', 'runs')


def all_runs(folder):
    """The folders of the recorded runs in the order in which they began. The date in the name says it only of those of earlier
    versions, which come first: clocks are put back."""
    try:
        names = sorted(name for name in os.listdir(folder) if NAME.match(name))
    except (FileNotFoundError, NotADirectoryError):
        return []
    paths = [os.path.join(folder, name) for name in names]
    return sorted((path for path in paths if os.path.isdir(path) and not os.path.islink(path)), key=number_of)


def begin(folder, now=None):
    """Creates the folder of a new run and returns its path. Throws OSError."""
    name = (now or datetime.datetime.now()).strftime('%Y-%m-%d_%H-%M-%S')
    os.makedirs(folder, exist_ok=True)
    return _marked(free_name.take(os.path.join(folder, name), os.mkdir))


def _marked(run):
    """Marks a folder that has just been made; one that cannot be marked is removed."""
    number = 1 + max(map(number_of, all_runs(os.path.dirname(run))), default=0)
    try:
        with open(os.path.join(run, 'made_by_run_recorder.%d' % number), 'x'):
            return run
    except OSError:
        os.rmdir(run)
        raise


def _names_in(run):
    try:
        return os.listdir(run)
    except OSError:  # another recorder has just removed it, or it belongs to somebody else
        return []


def markers_of(run):
    """The empty files that mark a folder as one of the recorder. What only has such a name is somebody else's."""
    return [path for path in (os.path.join(run, name) for name in _names_in(run) if MARKER.match(name)) if _is_empty_file(path)]


def _is_empty_file(path):
    try:
        status = os.lstat(path)
    except OSError:
        return False
    return stat.S_ISREG(status.st_mode) and status.st_size == 0


def number_of(run):
    """Greater than that of every run which was there when this one began; 0 if that is not known."""
    return max([int(MARKER.match(os.path.basename(marker)).group(1)) for marker in markers_of(run)], default=0)


def held(run):
    """While what this gives is open, the run counts as being recorded, also while there is no bag. A context. Throws OSError."""
    markers = markers_of(run)
    if not markers:
        raise FileNotFoundError('%s is gone' % run)
    return open(markers[0])


def give_up(run):
    """Removes a run in which nothing was recorded. Throws OSError if there is something in its folder all the same."""
    for marker in markers_of(run):
        os.remove(marker)
    os.rmdir(run)


def is_ours(run):
    """Whether the recorder has made this folder: it is marked, or, as one of an older recorder, holds nothing but bags and their
    report."""
    names = _names_in(run)
    bags = [name for name in names if PART.match(name)]
    return bool(markers_of(run)) or bool(bags) and set(names) <= {REPORT, *bags}


def keep_newest(folder, count, spared=()):
    """Removes all runs but the newest `count`; never those in `spared`, nor one that is still being recorded, nor a folder that
    somebody else has made. Returns what was removed."""
    removed = []
    for path in [run for run in all_runs(folder) if is_ours(run)][:-count or None]:
        if path not in spared and not is_being_recorded(path):
            _remove(path)
            removed.append(path)
    return removed


def _remove(run):
    """Removes what the recorder and the report have written, and the folder if nothing else is in it: somebody may keep a map or notes
    there. The marks go last, so that a run of which only a part could be removed is one still."""
    try:
        for name in _names_in(run):
            if PART.match(name) or name == REPORT:
                os.remove(os.path.join(run, name))
        give_up(run)
    except OSError:  # there is something else in it, or it is not to be written
        pass


def bag_of(run, stretch):
    """What rosbag is told to write. Each time that it is started in the same run it writes a stretch of its own, because it
    numbers its parts from zero. The first stretch has the number 1."""
    return os.path.join(run, BAG + ('_%d' % stretch if stretch > 1 else ''))


def stretch_of(part):
    """The number of the stretch to which a bag belongs; 1 for one that the recorder has not written."""
    match = PART.match(os.path.basename(part))
    return int(match.group(1) or 1) if match else 1


def is_first_part(path):
    """Whether this is the bag with which the recorder began a run; one that the recorder has not written counts as such."""
    match = PART.match(os.path.basename(path))
    return not match or (match.group(1) is None and match.group(2) == '0')


def parts_of(run):
    """The bags of a run in the order in which they were written. One that is open or was not closed ends with .active, which
    can be the last one of each stretch."""
    names = [(int(match.group(1) or 1), int(match.group(2)), match.group(0)) for match in map(PART.match, os.listdir(run)) if match]
    return [os.path.join(run, name) for _, _, name in sorted(names)]


def is_being_recorded(run):
    """Whether a process has its mark or a part of it open."""
    return any(map(is_open, markers_of(run) + [part for part in parts_of(run) if part.endswith('.active')]))


def is_open(path):
    """Whether a process has this file open."""
    path = os.path.realpath(path)
    return any(path == link for process in filter(str.isdigit, os.listdir('/proc')) for link in _open_files(process))


def _open_files(process):
    folder = '/proc/%s/fd' % process
    try:
        numbers = os.listdir(folder)
    except OSError:  # it has ended, or belongs to somebody else
        return
    for number in numbers:
        try:
            yield os.readlink(os.path.join(folder, number))
        except OSError:
            pass
