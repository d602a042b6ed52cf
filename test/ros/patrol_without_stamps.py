#!/usr/bin/env python3
"""A patrol of a base whose odometry has no stamps looks ahead from where the robot is."""
import math
import unittest

import actionlib
import rospy
import rostest
from frontier_pilot.msg import PatrolAction, PatrolGoal
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

from wire import Record, wait_for

LEG = 1.0  # [m]
WALL = LEG + 0.35  # [m] from where the robot begins; its front is 0.1 m ahead of its origin


class PatrolWithoutStamps(unittest.TestCase):
    def setUp(self):
        self.x, self.driven = 0.0, rospy.Time.now()
        self.wheels = Record('cmd_vel_patrol', Twist)
        self.odometry = rospy.Publisher('odom', Odometry, queue_size=1)
        self.scans = rospy.Publisher('scan', LaserScan, queue_size=1)
        self.client = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(30)))
        for end in (self.odometry, self.scans, self.wheels.subscriber):
            self.assertTrue(wait_for(lambda: end.get_num_connections() > 0), end.name)
        self.timer = rospy.Timer(rospy.Duration(0.03), self.drive)

    def tearDown(self):
        self.client.cancel_all_goals()
        self.timer.shutdown()
        self.timer.join()

    def drive(self, _):
        """The robot obeys along the x axis, and sees a wall across it."""
        now = rospy.Time.now()
        self.x += (now - self.driven).to_sec() * (self.wheels.last.linear.x if self.wheels.last else 0.0)
        self.driven = now
        odometry = Odometry()
        odometry.header.frame_id, odometry.child_frame_id = 'odom', 'base_footprint'
        odometry.pose.pose.position.x, odometry.pose.pose.orientation.w = self.x, 1.0
        self.odometry.publish(odometry)
        step = math.pi / 180.0
        scan = LaserScan(angle_min=-math.pi, angle_max=math.pi - step, angle_increment=step, range_min=0.1, range_max=3.5)
        scan.header.frame_id, scan.header.stamp = 'base_footprint', now
        ahead = [math.cos(scan.angle_min + beam * step) for beam in range(360)]
        scan.ranges = [(WALL - self.x) / share if share > 0.01 else math.inf for share in ahead]
        self.scans.publish(scan)

    def start(self):
        goal = PatrolGoal()
        goal.goal.x, goal.goal.y, goal.goal.z = 1, LEG, 1
        self.client.send_goal(goal)

    # [PAT-7]
    def test_a_wall_beyond_the_end_of_a_leg_is_not_taken_for_nearer_than_it_is(self):
        def moving():
            if self.client.simple_state == actionlib.SimpleGoalState.DONE:
                self.start()  # the goal before came earlier than the first odometry or scan
            return self.x > 0.1
        self.assertTrue(wait_for(moving, 40.0), self.x)
        self.assertTrue(wait_for(lambda: self.x > LEG - 0.05 or self.client.get_result(), 60.0), self.x)
        self.assertGreater(self.x, LEG - 0.05, self.client.get_result())


if __name__ == '__main__':
    rospy.init_node('patrol_without_stamps_test')
    rostest.rosrun('frontier_pilot', 'patrol_without_stamps', PatrolWithoutStamps)
