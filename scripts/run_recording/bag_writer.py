"""The rosbag processes that write a run one after the other, and what is wrong with them."""
import os
import shutil
import signal
import subprocess
import time

import roslib.packages

from .registration import Registration
from .runs import bag_of, parts_of, stretch_of

PARTS = 8  # in which a run is written, besides the open one: when the run is full, the oldest is removed
MEGA = 1 << 20
PATIENCE = 8.0  # for rosbag to close its file [s]
GONE = 20.0  # without the open bag until somebody has removed it [s]
PAUSE = 10.0  # between two starts of rosbag, in case that it always ends at once [s]


def part_size(limit):
    """How large a part may be [MB], for a run of at most `limit` MB."""
    return max(1, int(limit) // (PARTS + 1))


def command_of(topics, bag, limit, min_space, node):
    """The command line of rosbag, as the node with this full name."""
    namespace, name = node.rsplit('/', 1)
    found = roslib.packages.find_node('rosbag', 'record')
    if not found:
        raise OSError('rosbag has no program to record with: install it (on Debian python3-rosbag)')
    # The signal is for the case that the recorder is killed: nobody else would then end rosbag.
    return ['setpriv', '--pdeathsig', 'INT', '--', found[0],
            '--quiet', '--split', '--size=%d' % part_size(limit), '--max-splits=%d' % PARTS, '--repeat-latched', '--lz4',
            '--chunksize=256', '--buffsize=64', '--min-space=%dM' % min_space, '-O', bag, *topics, '__ns:=%s/' % namespace,
            '__name:=' + name]


def free_on_the_disk_of(folder):
    """[bytes]. Throws OSError."""
    return shutil.disk_usage(folder).free


def start_in_a_session_of_its_own(command):
    """So that a Ctrl-C reaches the recorder first."""
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, start_new_session=True)


class BagWriter:
    """Runs rosbag while there is room. rosbag ends when the disk is full; then it is started again once a whole part fits, and
    writes a further stretch of the run. `node` is the name that rosbag has as a node."""

    def __init__(self, topics, run, limit, min_space, node, free=free_on_the_disk_of, start=start_in_a_session_of_its_own,
                 clock=time.monotonic):
        self.run, self.limit, self.min_space = run, limit, min_space
        self.free, self.start, self.clock = free, start, clock
        self.command = lambda bag: command_of(topics, bag, limit, min_space, node)
        self.new_registration = lambda: Registration(node, subscriptions=topics)
        self.registration, self.process = None, None
        self.stretch = 0  # the one that is written, or was written last
        self.started = -PAUSE
        self.seen = None  # when the open bag was there last; rosbag opens it only once there is a clock
        self.room = min_space  # that has to be free before rosbag is started [MB]
        self.why_ended = ''
        self.problem()

    def problem(self):
        """Why nothing is written; empty if all is well. Starts rosbag as soon as there is room. To be called now and then."""
        if not self.process:
            return self._begin()
        code = self.process.poll()
        if code is None:
            try:
                lost = self._replace_a_lost_bag()
                if not lost:
                    self._keep_to_the_limit()
                return lost
            except OSError as error:
                return 'the folder of the record is gone: %s' % error
        if code == 0:  # by rosnode kill for example
            return 'somebody has ended rosbag: nothing is recorded any more'
        self.process, self.registration = None, None
        self.room = self.min_space + part_size(self.limit)  # with less it would soon end again
        self.why_ended = 'rosbag has ended (exit code %d), so nothing is recorded until it is started again' % code
        return self._shortage() or self.why_ended

    def _begin(self):
        """Starts rosbag, if it may be. Returns why not."""
        shortage = self._shortage()
        if shortage or self.clock() - self.started < PAUSE:
            return shortage or self.why_ended
        self.started = self.clock()
        try:
            self.process = self.start(self.command(bag_of(self.run, self.stretch + 1)))
        except OSError as error:
            self.why_ended = 'rosbag cannot be started, so nothing is recorded: %s' % error
            return self.why_ended
        self.stretch += 1
        self.seen = None
        self.registration = self.new_registration()
        return ''

    def _shortage(self):
        """What is wrong with the disk; empty if there is room."""
        try:
            if self.free(self.run) >= self.room * MEGA:
                return ''
        except OSError as error:
            return 'the folder of the record is gone: %s' % error
        return 'the disk of %s is full: less than %d MB are free (min_space is %d MB), so nothing is recorded until there is room' \
            % (self.run, self.room, self.min_space)

    def _replace_a_lost_bag(self):
        """rosbag goes on writing to a file that somebody has removed. It is ended then, and a further stretch begins. (Between two
        parts there is none for a moment.) Returns what is wrong."""
        if any(part.endswith('.active') and stretch_of(part) == self.stretch for part in parts_of(self.run)):
            self.seen = self.clock()
        if self.seen is None or self.clock() - self.seen < GONE:
            return ''
        self.end()
        self.process, self.registration = None, None
        self.why_ended = 'the bag that was being written is gone, and another one begins'
        return self.why_ended

    def _keep_to_the_limit(self):
        """Removes the oldest parts of earlier stretches, because rosbag knows only those that it has written itself."""
        for part in parts_of(self.run):
            if stretch_of(part) == self.stretch or self.size() <= self.limit * MEGA:
                break
            os.remove(part)

    def stay_registered(self):
        """To be called now and then: a new master does not know rosbag."""
        if self.registration:
            self.registration.keep()

    def size(self):
        """What the record has on the disk [bytes]."""
        try:
            return sum(os.path.getsize(part) for part in parts_of(self.run))
        except OSError:  # a part has just been renamed or removed
            return 0

    def end(self):
        """Closes the bag. rosbag is killed if it does not end; what it has written until then can be read all the same."""
        if self.process and self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
