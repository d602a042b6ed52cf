"""The rosbag process that writes a run, and what is wrong with it."""
import os
import shutil
import signal
import subprocess

import rosgraph
import roslib.packages

from .registration import Registration
from .runs import BAG, parts_of

PARTS = 8  # in which a run is written, besides the open one: when the run is full, the oldest is removed
MEGA = 1 << 20
PATIENCE = 8.0  # for rosbag to close its file [s]


def part_size(limit):
    """How large a part may be [MB], for a run of at most `limit` MB."""
    return max(1, int(limit) // (PARTS + 1))


def command_of(topics, run, limit, min_space, name):
    """The command line of rosbag."""
    found = roslib.packages.find_node('rosbag', 'record')
    if not found:
        raise OSError('rosbag has no program to record with: install it (on Debian python3-rosbag)')
    # The signal is for the case that the recorder is killed: nobody else would then end rosbag.
    return ['setpriv', '--pdeathsig', 'INT', '--', found[0],
            '--quiet', '--split', '--size=%d' % part_size(limit), '--max-splits=%d' % PARTS, '--repeat-latched', '--lz4',
            '--chunksize=256', '--buffsize=64', '--min-space=%dM' % min_space, '-O', os.path.join(run, BAG),
            *topics, '__name:=' + name]


class BagWriter:
    """Runs rosbag in a session of its own, so that a Ctrl-C reaches the recorder first. rosbag would end if there were no room
    when it begins, so it is started once there is."""

    def __init__(self, topics, run, limit, min_space, name):
        self.run, self.min_space = run, min_space
        self.command = command_of(topics, run, limit, min_space, name)
        self.registration = Registration(rosgraph.names.resolve_name(name, rosgraph.names.get_ros_namespace()),
                                         subscriptions=topics)
        self.process = None
        self.problem()

    def problem(self):
        """Why nothing is written; empty if all is well. Starts rosbag as soon as there is room."""
        code = self.process.poll() if self.process else None
        if code is not None:
            return 'rosbag has ended (exit code %d): nothing is recorded any more' % code
        try:
            free = shutil.disk_usage(self.run).free
        except OSError as error:
            return 'the folder of the record is gone: %s' % error
        if free < self.min_space * MEGA:
            return 'the disk of %s is full: %d MB are free, less than min_space (%d MB), so nothing is recorded until there ' \
                   'is room' % (self.run, free // MEGA, self.min_space)
        if not self.process:
            self.process = subprocess.Popen(self.command, stdin=subprocess.DEVNULL, start_new_session=True)
        return ''

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
