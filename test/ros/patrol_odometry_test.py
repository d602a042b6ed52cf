#!/usr/bin/env python3
"""What odometry that is missing, malformed or jumps does to a patrol. [PAT-4]"""
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

from frontier_pilot.msg import ArbiterStatus, PatrolAction, PatrolGoal
from wire import wait_for


class PatrolOdometryTest(unittest.TestCase):
    def setUp(self):
        self.commands = []
        self.odometry = Odometry()
        self.odometry.header.frame_id, self.odometry.child_frame_id = 'odom', 'base_footprint'
        self.odometry.pose.pose.orientation.w = 1.0
        self.publishing = False
        self.stamps = rospy.Time.now
        self.publisher = rospy.Publisher('odom', Odometry, queue_size=1)
        self.subscriber = rospy.Subscriber('cmd_vel_patrol', Twist, self.commands.append, queue_size=1000)
        self.timer = rospy.Timer(rospy.Duration(0.03), self.publish)
        self.client = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(30)))
        for end in (self.publisher, self.subscriber):
            self.assertTrue(wait_for(lambda: end.get_num_connections() > 0), end.name)

    def tearDown(self):
        self.client.cancel_all_goals()
        self.timer.shutdown()
        self.timer.join()
        self.subscriber.unregister()

    def publish(self, _):
        if self.publishing:
            self.odometry.header.stamp = self.stamps()
            self.publisher.publish(self.odometry)

    def start(self):
        msg = PatrolGoal()
        msg.goal.x, msg.goal.y, msg.goal.z = 1, 1.0, 1
        self.client.send_goal(msg)

    def start_moving(self):
        """A goal that comes before the first odometry is aborted, and sent again."""
        self.publishing = True

        def moving():
            if self.client.simple_state == actionlib.SimpleGoalState.DONE:
                self.start()
            return any(command.linear.x > 0.0 for command in self.commands)
        self.assertTrue(wait_for(moving, 20.0))

    def assert_aborted(self, text):
        self.assertTrue(self.client.wait_for_result(rospy.Duration(20)))
        self.assertEqual(self.client.get_state(), GoalStatus.ABORTED)
        self.assertIn(text, self.client.get_result().result)
        # The result and the last command come by different connections.
        self.assertTrue(wait_for(lambda: self.commands and self.commands[-1].linear.x == 0.0))

    def test_none_at_all(self):
        self.start()
        self.assert_aborted('no odometry for 0.5 s')
        self.assertTrue(all(command.linear.x == 0.0 for command in self.commands))

    def test_it_falls_silent(self):
        self.start_moving()
        self.publishing = False
        self.assert_aborted('no odometry for 0.5 s')

    def test_the_same_message_again_and_again_is_none(self):
        """As by a relay that hangs: what the robot has driven since is not in it."""
        self.start_moving()
        last = rospy.Time.now()
        self.stamps = lambda: last
        self.assert_aborted('no odometry for 0.5 s')

    def test_a_base_that_sets_no_stamps_is_followed_by_the_arrival_of_its_messages(self):
        self.stamps = rospy.Time
        self.start_moving()
        driven = len(self.commands)
        self.assertTrue(wait_for(lambda: len(self.commands) > driven + 40))
        self.assertEqual(self.client.get_state(), GoalStatus.ACTIVE)

    def test_a_source_of_which_nothing_is_heard_any_more_does_not_hold_the_wheels(self):
        arbiter = rospy.Publisher('cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        self.addCleanup(arbiter.unregister)
        self.assertTrue(wait_for(lambda: arbiter.get_num_connections() > 0))
        self.publishing = True
        arbiter.publish(ArbiterStatus(state=ArbiterStatus.DRIVING, active_source='nav'))
        self.start_moving()
        self.assert_aborted('no progress')

    def test_a_quaternion_of_no_length(self):
        self.start_moving()
        self.odometry.pose.pose.orientation.w = 0.0
        self.assert_aborted('bad odometry')

    def test_a_jump(self):
        self.start_moving()
        self.odometry.pose.pose.position.x = 5.0
        self.assert_aborted('odometry jumped')

    def test_a_position_that_is_not_a_number(self):
        self.start_moving()
        self.odometry.pose.pose.position.y = float('nan')
        self.assert_aborted('bad odometry')


if __name__ == '__main__':
    rospy.init_node('patrol_odometry_test')
    rostest.rosrun('frontier_pilot', 'patrol_odometry', PatrolOdometryTest)
