#!/usr/bin/env python3
"""A robot that publishes its odometry as a transform alone is mapped with, patrolled, and explored with."""
import unittest

import rospy
import rostest
from frontier_pilot.msg import ExplorerStatus, PatrolActionGoal, PatrolActionResult
from geometry_msgs.msg import Twist
from nav_msgs.msg import OccupancyGrid
from std_srvs.srv import SetBool

from wire import Record, call, moves, wait_for


class TransformOdometry(unittest.TestCase):
    # [ROB-1] [MAP-1]
    def test_the_mapper_takes_scans_in(self):
        maps = Record('map', OccupancyGrid)
        self.assertTrue(wait_for(lambda: maps.last is not None and 100 in maps.last.data, 20.0), '[ROB-1]')

    # [ROB-1] [PAT-1]
    def test_a_patrol_drives(self):
        wheels = Record('cmd_vel_patrol', Twist)
        results = Record('turtlebot3/result', PatrolActionResult)
        goals = rospy.Publisher('turtlebot3/goal', PatrolActionGoal, queue_size=1)
        self.assertTrue(wait_for(lambda: goals.get_num_connections() > 0))
        goal = PatrolActionGoal()
        goal.goal.goal.x, goal.goal.goal.y, goal.goal.goal.z = 1, 0.1, 1
        goals.publish(goal)
        self.assertTrue(wait_for(lambda: any(moves(message) for _, message in wheels.items)),
                        [message.result.result for _, message in results.items])

    # [ROB-1] [EXP-8]
    def test_the_explorer_misses_no_odometry(self):
        status = Record('frontier_explorer/status', ExplorerStatus)
        self.assertTrue(wait_for(lambda: status.last is not None))
        call('set_exploration_enabled', SetBool, True)
        self.assertTrue(wait_for(lambda: status.last.state == ExplorerStatus.NAVIGATING, 20.0), status.last)
        call('set_exploration_enabled', SetBool, False)


if __name__ == '__main__':
    rospy.init_node('transform_odometry_test')
    rostest.rosrun('frontier_pilot', 'transform_odometry', TransformOdometry)
