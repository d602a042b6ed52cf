#!/usr/bin/env python3
"""What a robot does that is found on its map somewhere else than where it was believed. [MAP-5] [NAV-1]"""
import math
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseWithCovarianceStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Odometry
from std_msgs.msg import Bool
from std_srvs.srv import Trigger

from wire import Record, wait_for

BELIEVED = (1.0, 3.0)  # [m]


class FoundRobot(unittest.TestCase):
    def setUp(self):
        self.localized = Record('mapper/localized', Bool)
        self.truth = Record('base_pose_ground_truth', Odometry)
        self.navigation = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        self.assertTrue(self.navigation.wait_for_server(rospy.Duration(30)))

    def be_believed_at(self, x, y):
        poses = rospy.Publisher('initialpose', PoseWithCovarianceStamped, queue_size=1)
        self.assertTrue(wait_for(lambda: poses.get_num_connections() > 0))
        pose = PoseWithCovarianceStamped()
        pose.header.frame_id = 'map'
        pose.pose.pose.position.x, pose.pose.pose.position.y = x, y
        pose.pose.pose.orientation.w = 1.0
        poses.publish(pose)

    def distance_from_goal(self):
        place = self.truth.last.pose.pose.position
        return math.hypot(place.x - BELIEVED[0], place.y - BELIEVED[1])

    def test_a_goal_where_the_robot_was_believed_is_reached_only_by_driving_there(self):  # [MAP-5] [NAV-1]
        self.assertTrue(wait_for(lambda: self.truth.last and self.localized.last, 30.0))
        self.be_believed_at(*BELIEVED)
        self.assertTrue(wait_for(lambda: not self.localized.last.data, 30.0))
        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.position.y = BELIEVED
        goal.target_pose.pose.orientation.w = 1.0
        self.navigation.send_goal(goal)
        rospy.sleep(1.0)
        self.assertGreater(self.distance_from_goal(), 3.0)
        answer = rospy.ServiceProxy('mapper/localize', Trigger)()
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(self.navigation.wait_for_result(rospy.Duration(60)))
        self.assertEqual(self.navigation.get_state(), GoalStatus.SUCCEEDED, self.navigation.get_goal_status_text())
        self.assertLess(self.distance_from_goal(), 0.5)


if __name__ == '__main__':
    rospy.init_node('found_robot_test')
    rostest.rosrun('frontier_pilot', 'found_robot', FoundRobot)
