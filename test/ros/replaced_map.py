#!/usr/bin/env python3
"""A goal ends with the map that it was meant for, and outlives a restart of the node that publishes the map."""
import os
import signal
import subprocess
import sys
import unittest

import actionlib
import rospy
import rostest
import tf2_ros
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, TransformStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Odometry
from std_msgs.msg import String

from wire import Record, wait_for

FAR = (3.3, 2.4)  # in the other room


class ReplacedMap(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('replaced_map')
        cls.odom = Record('odom', Odometry)
        cls.status = Record('navigator/status', String)
        cls.frames = tf2_ros.StaticTransformBroadcaster()
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'map', 'odom'
        transform.transform.rotation.w = 1.0
        cls.frames.sendTransform(transform)
        cls.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        assert cls.client.wait_for_server(rospy.Duration(30.0))

    def publish_map(self, name):
        path = os.path.join(os.path.dirname(os.path.realpath(__file__)), 'floor.py')
        process = subprocess.Popen([sys.executable, path, '__name:=' + name])
        self.addCleanup(self.kill, process)
        return process

    @staticmethod
    def kill(process):
        process.send_signal(signal.SIGKILL)
        process.wait()

    def is_driven(self):
        drives = self.odom.last is not None and self.odom.last.twist.twist.linear.x > 0.1
        return drives and 'on the way' in self.status.last.data

    def lacks_a_map(self):
        return 'no map' in self.status.last.data

    def test_ends_the_goal_if_it_is_of_another_node_and_not_after_a_restart(self):  # [NAV-1] [MAP-5] [FLT-2]
        first = self.publish_map('first_floor')
        goal = MoveBaseGoal(target_pose=PoseStamped())
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.position.y = FAR
        goal.target_pose.pose.orientation.w = 1.0
        self.client.send_goal(goal)
        self.assertTrue(wait_for(self.is_driven, 30.0), self.status.last)
        self.kill(first)
        self.assertTrue(wait_for(self.lacks_a_map), self.status.last)
        first = self.publish_map('first_floor')
        self.assertTrue(wait_for(self.is_driven, 30.0), self.status.last)
        self.assertEqual(GoalStatus.ACTIVE, self.client.get_state())
        self.kill(first)
        self.assertTrue(wait_for(self.lacks_a_map), self.status.last)
        self.publish_map('second_floor')
        self.assertTrue(wait_for(lambda: self.client.simple_state == actionlib.SimpleGoalState.DONE, 40.0), self.status.last)
        self.assertEqual(GoalStatus.ABORTED, self.client.get_state())
        self.assertEqual('the map was replaced', self.client.get_goal_status_text())


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'replaced_map', ReplacedMap)
