#!/usr/bin/env python3
"""An explorer whose odometry falls silent, whatever its stamps were."""
import rospy
import rostest
from frontier_pilot.msg import ExplorerStatus as Status

from explorer_case import ExplorerCase


class ExplorerSilence(ExplorerCase):
    def expect_that_it_waits_for_odometry(self, ahead):
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.robot.odometry_lives, self.robot.odometry_ahead = True, ahead
        self.explore()
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING, 20.0), self.status.last)
        self.status.items.clear()
        self.robot.odometry_lives = False
        self.assertTrue(self.comes(lambda status: status.state == Status.IDLE and 'odometry' in status.reason_text, 5.0), self.status.last)

    def test_it_waits_for_it(self):
        self.expect_that_it_waits_for_odometry(0.0)

    # [FLT-1]
    def test_it_waits_for_it_as_soon_where_its_stamps_were_ahead_of_the_clock(self):
        self.expect_that_it_waits_for_odometry(8.0)


if __name__ == '__main__':
    rospy.init_node('explorer_silence_test')
    rostest.rosrun('frontier_pilot', 'explorer_silence', ExplorerSilence)
