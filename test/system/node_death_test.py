#!/usr/bin/python3
"""Navigator and mapper are killed in the middle: the robot stands, the status says why, and the exploration goes on."""
import os
import signal
import sys
import unittest

import rospy
import rostest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from system_watch import SystemWatch, pid_of, wait_until  # noqa: E402
from frontier_pilot.msg import ExplorerStatus as Status  # noqa: E402


class NodeDeath(unittest.TestCase):
    watch = None

    def kill_while_driving(self, node, reasons):
        """Kills `node` in mid-motion, and gives how long the robot went on moving [s of simulated time]."""
        watch = self.watch
        self.assertTrue(wait_until(lambda: watch.speed is not None and watch.speed > 0.1, 90.0), watch.describe())
        pid, killed_at, seen = pid_of(node), watch.time, len(watch.reasons)
        self.assertIsNotNone(pid)
        os.kill(pid, signal.SIGKILL)
        self.assertTrue(wait_until(lambda: watch.speed == 0.0, 10.0), 'still moving\n' + watch.describe())
        coasted = watch.time - killed_at
        self.assertTrue(wait_until(lambda: set(watch.reasons[seen - 1:]) & reasons, 30.0),
                        'the status does not say it\n' + watch.describe())
        self.assertTrue(wait_until(lambda: pid_of(node) not in (None, pid), 20.0), '%s did not come back' % node)
        driven = watch.distance
        self.assertTrue(wait_until(lambda: watch.distance > driven + 0.3 or watch.done(), 90.0),
                        'does not go on\n' + watch.describe())
        return coasted

    def test_the_robot_stands_and_the_exploration_goes_on(self):  # [EXP-8]
        NodeDeath.watch = watch = SystemWatch()
        for node, reasons in (('/navigator', {Status.NAVIGATION_GONE}),
                              ('/mapper', {Status.MAP_GONE, Status.POSE_GONE})):
            coasted = self.kill_while_driving(node, reasons)
            print('%s killed: the robot stood after %.2f s' % (node, coasted))
            self.assertLess(coasted, 2.0)
        self.assertTrue(wait_until(watch.done, 300.0), 'not done in time\n' + watch.describe())
        self.assertEqual(0, watch.contacts)


if __name__ == '__main__':
    rospy.init_node('node_death_test')
    rostest.rosrun('frontier_pilot', 'node_death', NodeDeath)
