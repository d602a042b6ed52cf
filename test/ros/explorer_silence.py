#!/usr/bin/env python3
"""An explorer whose odometry falls silent, whatever its stamps were, or whose navigation cannot drive."""
import rospy
import rostest
from frontier_pilot.msg import ArbiterSource, ArbiterStatus
from frontier_pilot.msg import ExplorerStatus as Status

from explorer_case import ExplorerCase


class ExplorerSilence(ExplorerCase):
    def hold_the_robot(self, ahead=0.0):
        """It reaches no goal; its odometry lives, with stamps that are `ahead` [s] of the clock."""
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.robot.odometry_lives, self.robot.odometry_ahead = True, ahead

    def repeat(self, status):
        """Publishes `status`, which the test may change, as that of an arbiter."""
        arbiter = rospy.Publisher('cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        timer = rospy.Timer(rospy.Duration(0.5), lambda _: arbiter.publish(status))
        self.addCleanup(timer.shutdown)

    def expect_that_it_waits_for_odometry(self, ahead):
        self.hold_the_robot(ahead)
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

    # [EXP-8]
    def test_it_waits_for_a_navigation_that_has_no_scan(self):
        self.hold_the_robot()
        self.robot.trouble = 'no scan'
        self.addCleanup(setattr, self.robot, 'trouble', '')
        self.explore()
        self.expect_reason(Status.NAVIGATION_UNABLE)
        self.assertIn('no scan', self.status.last.reason_text)
        self.assertEqual(0, self.status.last.goals_failed)
        self.robot.trouble = ''
        self.status.items.clear()
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING, 20.0), self.status.last)

    # [EXP-8]
    def test_it_waits_while_the_arbiter_ignores_the_navigation(self):
        self.hold_the_robot()
        nav = ArbiterSource(name='nav', topic='/cmd_vel_nav', enabled=False)
        self.repeat(ArbiterStatus(sources=[nav]))
        self.explore()
        self.assertTrue(self.comes(lambda status: 'source nav' in status.reason_text), self.status.last)
        nav.enabled = True
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING), self.status.last)
        nav.enabled = False
        self.expect_reason(Status.NAVIGATION_DISABLED)

    # [EXP-8] [ARB-12]
    def test_it_waits_while_the_arbiter_stands_because_a_stranger_offers_its_services(self):
        self.hold_the_robot()
        nav = ArbiterSource(name='nav', topic='/cmd_vel_nav', enabled=True)
        status = ArbiterStatus(state=ArbiterStatus.CONTESTED, sources=[nav])
        self.repeat(status)
        self.explore()
        self.expect_reason(Status.NAVIGATION_DISABLED)
        self.assertIn('emergency stop', self.status.last.reason_text)
        self.assertEqual(0, self.status.last.goals_failed)
        status.state = ArbiterStatus.IDLE
        self.status.items.clear()
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING), self.status.last)


if __name__ == '__main__':
    rospy.init_node('explorer_silence_test')
    rostest.rosrun('frontier_pilot', 'explorer_silence', ExplorerSilence)
