#!/usr/bin/python3
"""Nodes are killed, and stopped for a while, in the middle of an exploration: the robot stands where it cannot know what
it drives into, the status says why, nothing is touched, and the exploration goes on. The arbiter has a test of its own."""
import os
import signal
import sys
import unittest

import rospy
import rostest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from system_watch import SystemWatch, pid_of, wait_until  # noqa: E402
from frontier_pilot.msg import ExplorerStatus as Status  # noqa: E402


def known(grid):
    """How many cells of a map are known."""
    return sum(cell >= 0 for cell in grid.data)


class NodeDeath(unittest.TestCase):
    watch = None

    def wait_until_driving(self):
        self.assertTrue(wait_until(lambda: self.watch.speed is not None and self.watch.speed > 0.1, 90.0),
                        self.watch.describe())

    def until_it_stands(self, since):
        """How long the robot went on moving [s of simulated time]."""
        self.assertTrue(wait_until(lambda: self.watch.speed == 0.0, 10.0), 'still moving\n' + self.watch.describe())
        return self.watch.time - since

    def goes_on(self, node):
        driven = self.watch.distance
        self.assertTrue(wait_until(lambda: self.watch.distance > driven + 0.3 or self.watch.done(), 90.0),
                        '%s is back, but it does not go on\n%s' % (node, self.watch.describe()))

    def is_back(self, node, pid):
        self.assertTrue(wait_until(lambda: pid_of(node) not in (None, pid), 20.0), '%s did not come back' % node)

    def keeps_the_map(self, before, share=0.98):
        stamp = self.watch.map.header.stamp
        self.assertTrue(wait_until(lambda: self.watch.map.header.stamp != stamp or self.watch.done(), 60.0))
        self.assertGreater(known(self.watch.map), share * before, 'the map is kept')

    def kill_while_driving(self, node, reasons):
        """Kills `node`, which the robot cannot drive without, and gives how long the robot went on moving."""
        watch = self.watch
        self.wait_until_driving()
        before, pid, killed_at, seen = known(watch.map), pid_of(node), watch.time, len(watch.reasons)
        self.assertIsNotNone(pid)
        os.kill(pid, signal.SIGKILL)
        coasted = self.until_it_stands(killed_at)
        self.assertTrue(wait_until(lambda: set(watch.reasons[seen - 1:]) & reasons, 30.0),
                        'the status does not say it\n' + watch.describe())
        self.is_back(node, pid)
        self.goes_on(node)
        self.keeps_the_map(before, 0.9)  # a mapper that was killed has that of two seconds before
        return coasted

    def stop_while_driving(self, node):
        """The same with one that hangs until the robot stands."""
        self.wait_until_driving()
        before, pid, stopped_at = known(self.watch.map), pid_of(node), self.watch.time
        os.kill(pid, signal.SIGSTOP)
        try:
            coasted = self.until_it_stands(stopped_at)
        finally:
            os.kill(pid, signal.SIGCONT)
        self.goes_on(node)
        self.assertEqual(pid_of(node), pid, 'it has died of it')
        self.keeps_the_map(before)
        return coasted

    def do_without(self, node):
        """Kills `node`, which the robot can drive on without for a while, and stops it when it is back."""
        self.wait_until_driving()
        before, pid = known(self.watch.map), pid_of(node)
        os.kill(pid, signal.SIGKILL)
        self.is_back(node, pid)
        self.goes_on(node)
        pid = pid_of(node)
        os.kill(pid, signal.SIGSTOP)
        since = self.watch.time
        try:
            self.assertTrue(wait_until(lambda: self.watch.time > since + 2.0, 10.0))
        finally:
            os.kill(pid, signal.SIGCONT)
        self.goes_on(node)
        self.assertEqual(pid_of(node), pid, 'it has died of it')
        self.keeps_the_map(before)

    def test_the_robot_stands_and_the_exploration_goes_on(self):  # [EXP-8] [FLT-2]
        NodeDeath.watch = watch = SystemWatch()
        self.assertTrue(wait_until(lambda: watch.map is not None, 60.0), 'a map')
        for node, reasons in (('/navigator', {Status.NAVIGATION_GONE}),
                              ('/mapper', {Status.MAP_GONE, Status.POSE_GONE})):
            coasted = self.stop_while_driving(node)
            print('%s stopped: the robot stood after %.2f s' % (node, coasted))
            self.assertLess(coasted, 2.0)
            coasted = self.kill_while_driving(node, reasons)
            print('%s killed: the robot stood after %.2f s' % (node, coasted))
            self.assertLess(coasted, 2.0)
        for node in ('/frontier_explorer', '/behavior_server', '/patrol_server', '/obstacle_avoider'):
            self.do_without(node)
        self.assertTrue(wait_until(watch.done, 300.0), 'not done in time\n' + watch.describe())
        self.assertEqual(0, watch.contacts)


if __name__ == '__main__':
    rospy.init_node('node_death_test')
    rostest.rosrun('frontier_pilot', 'node_death', NodeDeath)
