#!/usr/bin/python3
"""A second publisher of /clock, a million seconds ahead for one second: every node says so and comes back. [FLT-1]"""
import os
import sys
import threading
import time
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Clock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from system_watch import SystemWatch, pid_of, subscribers, wait_until  # noqa: E402

AHEAD = 1e6
NODES = ('cmd_vel_arbiter', 'mapper', 'navigator', 'frontier_explorer', 'behavior_server', 'patrol_server',
         'obstacle_avoider')


def known(grid):
    """How many cells of a map are known."""
    return sum(cell >= 0 for cell in grid.data)


class ClockJump(unittest.TestCase):
    def setUp(self):
        self.watch = SystemWatch()
        self.said = set()  # the nodes whose diagnostics mention a jump
        rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        self.buffer = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.buffer)

    def on_diagnostics(self, msg):
        for status in msg.status:
            if 'the clock jumped by' in status.message:
                self.said.add(status.name.split(':')[0].strip('/'))

    def speak(self, ahead, seconds):
        """Says a time of its own on /clock for so long, as the simulator does, and falls silent."""
        publisher = rospy.Publisher('/clock', Clock, queue_size=10)
        everyone = {'/' + name for name in NODES}
        self.assertTrue(wait_until(lambda: subscribers('/clock') >= everyone, 20.0), everyone - subscribers('/clock'))
        pace, start, end = threading.Event(), self.watch.time + ahead, time.monotonic() + seconds
        while time.monotonic() < end:
            publisher.publish(Clock(rospy.Time.from_sec(start + seconds - (end - time.monotonic()))))
            pace.wait(0.01)
        publisher.unregister()

    def knows_where_it_is(self):
        """Whether `map -> base_footprint` is there, and of now, for one who has heard nothing of the future."""
        try:
            stamp = self.buffer.lookup_transform('map', 'base_footprint', rospy.Time()).header.stamp.to_sec()
        except tf2_ros.TransformException:
            return False
        return abs(stamp - self.watch.time) < 1.0

    def jump(self, ahead):
        watch = self.watch
        moves = lambda: watch.speed is not None and watch.speed > 0.1
        self.assertTrue(wait_until(lambda: moves() and watch.map is not None and known(watch.map) > 5000, 120.0),
                        watch.describe())
        before, pids = known(watch.map), {name: pid_of('/' + name) for name in NODES}
        self.said.clear()
        self.speak(ahead, 1.0)
        self.buffer.clear()
        silent = time.monotonic()
        self.assertTrue(wait_until(self.knows_where_it_is, 5.0), 'map -> base does not come back')
        driven = watch.distance
        self.assertTrue(wait_until(lambda: watch.distance > driven + 0.05, max(0.0, silent + 5.0 - time.monotonic())),
                        'does not move again\n' + watch.describe())
        print('%+.0f s: moves again after %.2f s' % (ahead, time.monotonic() - silent))
        self.assertTrue(wait_until(lambda: self.said >= set(NODES), 5.0), set(NODES) - self.said)
        self.assertEqual({name: pid_of('/' + name) for name in NODES}, pids, 'a node has died')
        stamp = watch.map.header.stamp
        self.assertTrue(wait_until(lambda: watch.map.header.stamp != stamp, 120.0), 'no map any more')
        self.assertGreaterEqual(known(watch.map), before - 20, 'the map is kept')
        self.assertLess(abs(watch.map.header.stamp.to_sec() - watch.time), 10.0)

    def test_a_second_clock_for_a_second(self):
        for ahead in (AHEAD, 100.0):
            self.jump(ahead)
        self.assertEqual(0, self.watch.contacts)


if __name__ == '__main__':
    rospy.init_node('clock_jump_test')
    rostest.rosrun('frontier_pilot', 'clock_jump', ClockJump)
