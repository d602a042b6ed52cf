#!/usr/bin/env python3
"""The navigator whose map's publisher is killed: it says no goodbye, and roscpp goes on trying to connect to it."""
import math
import subprocess
import sys
import unittest

import actionlib
import rospy
import rostest
import tf2_ros
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid, Odometry
from nav_msgs.srv import GetPlan
from std_msgs.msg import String

from wire import Record, call, moves, wait_for

START = (0.7, 0.8)  # in the world; the origin of map and odom
FAR = (3.3, 2.4)    # in the other room


def publish_map():
    """What the process does that is killed."""
    rospy.init_node('map_source')
    world = Record('simulator/world', OccupancyGrid)
    assert wait_for(lambda: world.last is not None, 60.0)
    grid = world.last
    grid.header.frame_id = 'map'
    grid.info.origin.position.x, grid.info.origin.position.y = -START[0], -START[1]
    maps = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
    maps.publish(grid)
    rospy.spin()


class KilledMap(unittest.TestCase):
    def setUp(self):
        rospy.init_node('killed_map')
        self.commands = Record('cmd_vel_nav', Twist)
        self.odom = Record('odom', Odometry)
        self.status = Record('navigator/status', String)
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'map', 'odom'
        transform.transform.rotation.w = 1.0
        self.frames = tf2_ros.StaticTransformBroadcaster()
        self.frames.sendTransform(transform)
        self.source = None
        self.addCleanup(self.kill_map)
        self.start_map()
        self.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(60.0)))
        self.assertTrue(wait_for(self.can_plan, 60.0), self.status.last)

    @staticmethod
    def can_plan():
        here, there = PoseStamped(), PoseStamped()
        there.header.frame_id = 'map'
        there.pose.position.x, there.pose.position.y = FAR
        there.pose.orientation.w = 1.0
        try:
            return bool(call('make_plan', GetPlan, here, there, 0.0).plan.poses)
        except rospy.ServiceException:  # as long as it does not know where the robot is
            return False

    def start_map(self):
        self.source = subprocess.Popen([sys.executable, __file__, 'publish'])

    def kill_map(self):
        self.source.kill()  # SIGKILL
        self.source.wait()

    def test_the_robot_stands_until_the_map_has_a_living_publisher_again(self):  # [FLT-1] [NAV-1]
        goal = PoseStamped()
        goal.header.frame_id = 'map'
        goal.pose.position.x, goal.pose.position.y = FAR
        goal.pose.orientation.w = 1.0
        self.client.send_goal(MoveBaseGoal(target_pose=goal))
        self.assertTrue(wait_for(lambda: self.commands.last and self.commands.last.linear.x > 0.1, 60.0), self.status.last)
        self.kill_map()
        self.assertTrue(wait_for(lambda: 'no map' in self.status.last.data, 15.0), self.status.last)
        self.assertTrue(wait_for(lambda: not moves(self.commands.last)))
        self.assertTrue(wait_for(lambda: abs(self.odom.last.twist.twist.linear.x) < 1e-6))
        at = self.odom.last.pose.pose.position
        self.assertGreater(math.hypot(at.x - FAR[0], at.y - FAR[1]), 0.5, 'far from its goal')
        self.start_map()
        self.assertTrue(wait_for(lambda: self.client.simple_state == actionlib.SimpleGoalState.DONE, 90.0), self.status.last)
        self.assertEqual(self.client.get_state(), GoalStatus.SUCCEEDED, self.client.get_goal_status_text())


if __name__ == '__main__':
    if sys.argv[1:2] == ['publish']:
        publish_map()
    else:
        rostest.rosrun('frontier_pilot', 'killed_map', KilledMap)
