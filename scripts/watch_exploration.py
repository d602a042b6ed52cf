#!/usr/bin/env python3
"""Watches an exploration, prints its progress periodically, and saves the map when it is done.

Exit code: 0 when everything within reach was explored and the map was saved, 1 otherwise.
"""
import argparse
import datetime
import os
import sys
import time

import rospy
from frontier_pilot.msg import ExplorerStatus
from frontier_pilot.srv import SaveMap


# The ends that the stopping rules of the explorer have asked for.
ASKED_FOR = (ExplorerStatus.UNTIL_AREA, ExplorerStatus.UNTIL_TIME, ExplorerStatus.UNTIL_DISTANCE)


class Watcher:
    """Keeps the explorer's latest status and prints it as progress lines."""

    def __init__(self, period):
        self.period = period  # of the progress lines, in seconds of wall time
        self.status = None
        self.started = None  # when the first goal was sent, in simulated time
        self.printed = 0.0
        rospy.Subscriber('frontier_explorer/status', ExplorerStatus, self.on_status, queue_size=10)

    def on_status(self, status):
        if self.started is None and status.goals_sent > 0:
            self.started = status.header.stamp.to_sec()
        self.status = status

    def elapsed(self):
        """Simulated seconds since the first goal was sent."""
        return 0.0 if self.started is None else self.status.header.stamp.to_sec() - self.started

    def line(self):
        status = self.status
        return '%6.0f s  explored %7.1f m2  driven %6.1f m  frontiers %3d  goals %d sent, %d reached, %d failed  %s: %s' % (
            self.elapsed(), status.explored_area, status.distance_travelled, status.frontiers_selectable, status.goals_sent,
            status.goals_reached, status.goals_failed, status.state_text, status.reason_text)

    def done(self):
        return self.status is not None and self.status.state == ExplorerStatus.DONE

    def progress(self):
        if time.monotonic() - self.printed < self.period:
            return
        self.printed = time.monotonic()
        print('waiting for the explorer' if self.status is None else self.line(), flush=True)


def default_prefix():
    return os.path.join('maps', datetime.datetime.now().strftime('%Y-%m-%d_%H-%M-%S'))


def save_map(prefix):
    """Returns whether the mapper has written the map, and prints where, or why not."""
    path = os.path.abspath(prefix or default_prefix())
    os.makedirs(os.path.dirname(path), exist_ok=True)
    try:
        rospy.wait_for_service('mapper/save_map', timeout=10.0)
        answer = rospy.ServiceProxy('mapper/save_map', SaveMap)(path)
    except (rospy.ROSException, rospy.ServiceException) as error:
        print('The map could not be saved: %s' % error, file=sys.stderr)
        return False
    if not answer.success:
        print('The map could not be saved: %s' % answer.message, file=sys.stderr)
        return False
    print('Map saved: %s.pgm, .yaml and .bt' % path)
    return True


def master_is_up():
    try:
        rospy.get_master().getPid()
        return True
    except OSError:
        return False


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--map', default='', help='where to save it, without extension (maps/<date and time>)')
    parser.add_argument('--period', type=float, default=5.0, help='seconds between two progress lines')
    arguments = parser.parse_args(rospy.myargv()[1:])
    while not master_is_up():
        time.sleep(0.2)
    # Periods are on the steady clock, because simulated time may stand still or run at any speed.
    # A name from outside could be that of a running node, which ROS would then shut down.
    words = [word for word in sys.argv if not word.startswith('__name:=')]
    rospy.init_node('watch_exploration', argv=words, anonymous=True)
    began = time.monotonic()
    watcher = Watcher(arguments.period)
    while not rospy.is_shutdown() and not watcher.done():
        watcher.progress()
        time.sleep(0.2)
    if not watcher.done():
        return 1
    status = watcher.status
    complete = status.reason == ExplorerStatus.NO_REACHABLE_FRONTIER
    print(watcher.line())
    print('Exploration %s: %s' % ('complete' if complete else 'ended', status.reason_text))
    print('Explored %.1f m2 in %.0f s of the robot\'s time (%.0f s here), driving %.1f m to %d goals.' % (
        status.explored_area, watcher.elapsed(), time.monotonic() - began, status.distance_travelled, status.goals_sent))
    return 0 if save_map(arguments.map) and (complete or status.reason in ASKED_FOR) else 1


if __name__ == '__main__':
    sys.exit(main())
