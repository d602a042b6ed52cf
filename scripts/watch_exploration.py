#!/usr/bin/python3
"""Watches an exploration, which it can also start, prints its progress periodically, and saves the map when it is done, on Ctrl-C,
or when its terminal or what reads its output has been closed. A second Ctrl-C does not wait until it is saved. It waits for an
explorer that has died, unless the program that started it has ended too.

Exit code: 0 when no reachable frontier is left, or a stopping rule has ended the exploration, and the map was saved where it was to be,
130 after Ctrl-C, 143 after SIGTERM, 129 when the terminal was closed, 141 when nobody reads the output any more, 3 when the exploration
has ended, or the map was only to be saved, and it could not be saved anywhere, 1 otherwise.
"""
import argparse
import math
import os
import signal
import sys
import time

if __name__ == '__main__':
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # until main: a Ctrl-C while the rest is imported prints no traceback

import rosgraph  # noqa: E402
import rospy  # noqa: E402
from frontier_pilot.msg import ExplorerStatus  # noqa: E402
from std_msgs.msg import Bool  # noqa: E402
from std_srvs.srv import SetBool  # noqa: E402

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))  # catkin starts this file by way of another one
import ros_program  # noqa: E402
from command_line import CommandLine, exit_with, say  # noqa: E402
from run_recording.topics import TOPICS  # noqa: E402
from run_report.progress import Counts  # noqa: E402
from saved_maps import Saved, save_map  # noqa: E402

RECORDER_START = 30.0  # [s], for which the exploration waits for the recorder
MASTER_START = 10.0  # [s], within which a roslaunch that was started beside it has its master
LEAST_CHANGE, LEAST_WAY = 0.1, 0.2  # of the explored area [m^2] and of the way [m], with which a map is saved again
SILENCE = 10.0  # [s], after which an explorer that is not heard is said to be silent
FAREWELL = 30.0  # [s] of silence after which an explorer counts as dead, once the program that started this one has ended
PERIODS = 0.2, 3600.0  # of the progress lines [s]
NOT_SAVED = 3  # the exit code
TOGETHER = 0.5  # [s], within which two signals are one

# The ends that the stopping rules of the explorer have asked for.
ASKED_FOR = (ExplorerStatus.UNTIL_AREA, ExplorerStatus.UNTIL_TIME, ExplorerStatus.UNTIL_DISTANCE, ExplorerStatus.UNTIL_SHARE,
             ExplorerStatus.UNTIL_BATTERY)


def estimate_of(status):
    """The explored share of the whole floor and the time that is left, as far as they can be told."""
    if status.state == ExplorerStatus.DONE or math.isnan(status.share_explored):
        return ''
    words = ', about %.0f %%' % (100.0 * status.share_explored)
    if math.isnan(status.time_left):
        return words
    if status.time_left < 90.0:
        return words + ', %.0f s left' % status.time_left
    return words + ', %.0f min left' % (status.time_left / 60.0)


def goals_of(status):
    """What became of the goals. Most are not reached: once nothing is left to see from there, they are dropped."""
    dropped = status.goals_sent - status.goals_reached - status.goals_failed
    under_way = 1 if status.state == ExplorerStatus.NAVIGATING else 0
    return '%d dropped on the way, %d reached, %d failed' % (max(0, dropped - under_way), status.goals_reached, status.goals_failed)


class Watcher:
    """Keeps the explorer's latest status and prints it as progress lines."""

    def __init__(self, period):
        self.period = period  # of the progress lines, in seconds of wall time
        self.starter = None  # which starts the exploration, if this program is to
        self.status = None
        self.counts = Counts()  # an explorer that died counts anew
        self.started = None  # when the first goal was sent, in simulated time
        self.printed = 0.0
        self.heard = time.monotonic()  # when the explorer was last heard, by the steady clock; until then when this began
        self.looked = self.heard  # when the master was last asked for in a silence, by the steady clock
        self.master_answers = True
        self.subscriber = None
        self.listen()

    def stay_connected(self):
        """Listens again while the explorer is silent, because rospy does not notice that the master was started again, and would never
        hear the next explorer. To be called often."""
        now = time.monotonic()
        if self.silence() < SILENCE or now - self.looked < self.period:
            return
        self.looked = now
        self.master_answers = ros_program.is_master_online(rospy.get_name())
        if self.master_answers:
            self.listen()

    def listen(self):
        if self.subscriber:
            self.subscriber.unregister()
        self.subscriber = rospy.Subscriber('frontier_explorer/status', ExplorerStatus, self.on_status, queue_size=10)

    def on_status(self, status):
        if self.started is None and status.goals_sent > 0:
            self.started = status.header.stamp.to_sec()
        if self.status is None or status.header.stamp != self.status.header.stamp:  # not its last one once more
            self.heard = time.monotonic()
        for name, count in self.counts.take(status).items():
            setattr(status, name, count)
        self.status = status

    def silence(self):
        """Seconds of wall time since the explorer was heard."""
        return time.monotonic() - self.heard

    def elapsed(self):
        """Simulated seconds since the first goal was sent."""
        return 0.0 if self.started is None else self.status.header.stamp.to_sec() - self.started

    def line(self):
        status = self.status
        return '%6.0f s  explored %7.1f m2%s  driven %6.1f m  frontiers %3d  goals: %s  %s: %s%s' % (
            self.elapsed(), status.explored_area, estimate_of(status), status.distance_travelled, status.frontiers_selectable,
            goals_of(status), status.state_text, self.reason(), self.way_out_of_a_pause())

    def reason(self):
        """Why the explorer is in its state; of a pause in which the exploration has not begun the starter knows more."""
        waits = self.starter and not self.starter.settled and self.status.reason == ExplorerStatus.PAUSED
        return 'waiting for the recorder' if waits else self.status.reason_text

    def way_out_of_a_pause(self):
        """How an exploration that had begun goes on after it was paused, by somebody or because a stop was cleared."""
        if self.started is None or self.status.reason != ExplorerStatus.PAUSED:
            return ''
        return '; "rosservice call %s true" resumes it' % rospy.resolve_name('set_exploration_enabled')

    def knows_a_map(self):
        return self.status is not None and self.status.explored_area > 0.0

    def done(self):
        return self.status is not None and self.status.state == ExplorerStatus.DONE

    def progress(self):
        """Returns whether somebody reads it."""
        self.stay_connected()
        if time.monotonic() - self.printed < self.period:
            return True
        self.printed = time.monotonic()
        if self.silence() < SILENCE:
            return say('waiting for the explorer' if self.status is None else self.line())
        words = 'the explorer has not been heard for %.0f s' % self.silence()
        return say(words if self.master_answers else words + ': no ROS master answers at ' + rosgraph.get_master_uri())


class Starter:
    """Starts the exploration when the recorder of the run is ready, or after RECORDER_START without it; not once the robot was stopped.
    A pause cannot be respected: nothing that the explorer publishes tells it from the pause in which it was launched."""

    def __init__(self):
        self.heard = None  # when the explorer was first heard, by the steady clock
        self.asked = -1.0  # when the master or the explorer was last asked, by the steady clock
        self.settled = False  # whether there is nothing to start any more
        self.stopped = False  # also if that was cleared
        rospy.Subscriber('emergency_stop_state', Bool, self.on_stop_state)

    def on_stop_state(self, stopped):
        self.stopped = self.stopped or stopped.data

    def go_on(self, status):
        """To be called often, with the latest status of the explorer or None."""
        now = time.monotonic()
        if self.settled or status is None or now - self.asked < 1.0:
            return
        self.asked = now
        self.heard = self.heard or now
        if status.state != ExplorerStatus.IDLE:
            self.settled = True  # somebody else has started it
        elif self.stopped:
            self.settled = True
            say('The robot was stopped: the exploration is not started any more; when the stop is cleared, "rosservice call %s true" '
                'starts it' % rospy.resolve_name('set_exploration_enabled'))
        elif self.recorder_is_ready():
            self.start()
        elif now - self.heard > RECORDER_START:
            say('The recorder has not begun within %.0f s: the exploration starts without it' % RECORDER_START)
            self.start()

    @staticmethod
    def recorder_is_ready():
        """Whether it has subscribed to the last of its topics; it subscribes in the order of their names."""
        last = max(rospy.resolve_name(topic) for topic in TOPICS)
        try:
            listeners = dict(ros_program.master(rospy.get_name()).getSystemState()[1])
        except ros_program.FAILURES:
            return False
        return rospy.resolve_name('run_recorder_rosbag') in listeners.get(last, [])

    def start(self):
        try:
            self.settled = rospy.ServiceProxy('set_exploration_enabled', SetBool)(True).success
        except rospy.ServiceException as error:
            say('The exploration could not be started, it is tried again: %s' % error)


def save_at_the_end(watcher, interrupt, prefix, saved_already):
    """Waits without a word until it is told to end, and saves the map then; if it was saved already, only if it may have changed
    meanwhile, and under a name that no map has. It ends with the process that has started it."""
    begin, parent = None, os.getppid()
    while not rospy.is_shutdown() and not interrupt.number and os.getppid() == parent:
        watcher.stay_connected()
        begin = begin or watcher.status
        time.sleep(0.2)
    if not saved_already:
        save_what_is_there(watcher, 'It is not saved yet', prefix)
    elif begin and has_changed(begin, watcher.status):
        say('\nThe robot has driven on since the map was saved: saving it again ...')
        save_map(prefix, beside=True)
    return 128 + interrupt.number


def is_abandoned(parent, heard):
    """Whether the process that started this program has ended, and nothing was heard for FAREWELL."""
    return os.getppid() != parent and time.monotonic() - heard > FAREWELL


def save_what_is_there(watcher, why, prefix):
    if watcher.knows_a_map():
        say('\n%s: saving the map ...' % why)
        save_map(prefix)


def has_changed(before, now):
    return (abs(now.explored_area - before.explored_area) > LEAST_CHANGE or
            abs(now.distance_travelled - before.distance_travelled) > LEAST_WAY)


class Interrupt:
    """The signal that has asked this program to end, or SIGPIPE if nobody reads its output. The second Ctrl-C or SIGTERM ends it at
    once, whatever it waits for, unless both came together, as from `timeout`. The terminal or the reader may be gone before or after
    the first one, by the same Ctrl-C."""

    def __init__(self):
        self.number = 0
        self.at = 0.0  # when the first Ctrl-C or SIGTERM came, by the steady clock
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self.take)
        if signal.getsignal(signal.SIGHUP) != signal.SIG_IGN:  # which nohup has set
            signal.signal(signal.SIGHUP, self.lose)

    def take(self, number, _):
        if self.number not in (signal.SIGINT, signal.SIGTERM):
            self.number, self.at = number, time.monotonic()
        elif time.monotonic() - self.at > TOGETHER:
            os._exit(128 + number)

    def lose(self, number, _=None):
        """The terminal, or what reads the output, is gone."""
        self.number = self.number or number


def say_the_end(watcher, began):
    """Whether the exploration ended as it was asked to."""
    status = watcher.status
    complete = status.reason == ExplorerStatus.NO_REACHABLE_FRONTIER
    say(watcher.line())
    say('Explored %.1f m2 in %.0f s of the robot\'s time (%.0f s here), driving %.1f m.' % (
        status.explored_area, watcher.elapsed(), time.monotonic() - began, status.distance_travelled))
    say('Exploration %s: %s' % ('complete' if complete else 'ended', status.reason_text))
    return complete or status.reason in ASKED_FOR


def period_in(text):
    period = float(text)
    if not PERIODS[0] <= period <= PERIODS[1]:
        raise argparse.ArgumentTypeError('must be from %g to %g s, not %g' % (*PERIODS, period))
    return period


def map_in(text):
    path = os.path.expanduser(text)
    if path.endswith('/') or os.path.isdir(path):
        raise argparse.ArgumentTypeError('%r is a folder; give the path of the map\'s files, such as %s' % (text, os.path.join(path, 'floor')))
    return path


def warn_of_a_missing_folder(prefix):
    folder = os.path.dirname(os.path.abspath(prefix))
    if prefix and not os.path.isdir(folder):
        say('watch_exploration: there is no folder %s here; make it before the map is saved, unless the computer of the mapper has it'
            % folder, sys.stderr)


def main():
    parser = CommandLine(__doc__, 'rosrun frontier_pilot watch_exploration.py --map /tmp/floor')
    parser.add_argument('--map', type=map_in, default='', help='where to save it, without extension (maps/<date and time>)')
    parser.add_argument('--start-when-recorded', action='store_true',
                        help='start the exploration as soon as the run is recorded, or after %.0f s without that' % RECORDER_START)
    parser.add_argument('--saved-already', action='store_true',
                        help='only wait until it is told to end, and save the map beside the one of before if it has changed since')
    parser.add_argument('--save-at-end', action='store_true', help='only wait until it is told to end, and save the map then')
    parser.add_argument('--save-now', action='store_true', help='only save the map, beside one of that name if there is one')
    parser.add_argument('--period', type=period_in, default=5.0,
                        help='seconds between two progress lines, from %g to %g (5)' % PERIODS)
    arguments = parser.parse_args(rospy.myargv()[1:])
    interrupt, parent = Interrupt(), os.getppid()
    # Periods are on the steady clock, because simulated time may stand still or run at any speed.
    # A name from outside could be that of a running node, which ROS would then shut down.
    words = [word for word in sys.argv if not word.startswith('__name:=')]
    began = time.monotonic()
    if not ros_program.begin('watch_exploration', lambda: not interrupt.number and not is_abandoned(parent, began), silent_for=MASTER_START,
                             argv=words, anonymous=True, disable_signals=True):
        return 128 + interrupt.number if interrupt.number else 1
    if arguments.save_now:
        return NOT_SAVED if save_map(arguments.map, beside=True) is Saved.NOWHERE else 0
    warn_of_a_missing_folder(arguments.map)
    watcher = Watcher(arguments.period)
    if arguments.saved_already or arguments.save_at_end:
        return save_at_the_end(watcher, interrupt, arguments.map, arguments.saved_already)
    starter = watcher.starter = Starter() if arguments.start_when_recorded else None
    while not rospy.is_shutdown() and not watcher.done() and not interrupt.number:
        if not watcher.progress():
            interrupt.lose(signal.SIGPIPE)
        if starter:
            starter.go_on(watcher.status)
        if is_abandoned(parent, watcher.heard):
            save_what_is_there(watcher, 'The explorer is gone, and so is the program that has started this one', arguments.map)
            return 1
        time.sleep(0.2)
    if interrupt.number:
        save_what_is_there(watcher, 'Interrupted', arguments.map)
        return 128 + interrupt.number
    if not watcher.done():
        return 1
    as_asked = say_the_end(watcher, began)
    saved = save_map(arguments.map)
    if saved is Saved.NOWHERE:
        return NOT_SAVED
    return 0 if saved is Saved.WHERE_ASKED and as_asked else 1


if __name__ == '__main__':
    exit_with(main)
