#!/usr/bin/env python3
"""A patrol looks at the scan of a scanner that is there, whatever else hides it. [PAT-7]"""
import os
import signal
import unittest

import actionlib
import rosgraph
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

from frontier_pilot.msg import PatrolAction, PatrolGoal
from wire import Node, Record, Stranger, moves, wait_for


def publishers_of(topic):
    return dict(rosgraph.Master('/test').getSystemState()[0]).get(topic, [])


class PatrolLook(unittest.TestCase):
    def setUp(self):
        self.odometry = rospy.Publisher('odom', Odometry, queue_size=1)
        self.addCleanup(self.odometry.unregister)
        self.timer = rospy.Timer(rospy.Duration(0.03), self.publish)

    def tearDown(self):
        self.timer.shutdown()
        self.timer.join()

    def publish(self, _):
        """The robot stands."""
        odometry = Odometry()
        odometry.header.frame_id, odometry.child_frame_id = 'odom', 'base_footprint'
        odometry.header.stamp, odometry.pose.pose.orientation.w = rospy.Time.now(), 1.0
        self.odometry.publish(odometry)

    def start_server(self):
        server = Node('patrol_server')
        self.addCleanup(server.end)
        self.client = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(60)))
        self.commands = Record('cmd_vel_patrol', Twist)
        self.addCleanup(self.commands.subscriber.unregister)
        for end in (self.odometry, self.commands.subscriber):
            self.assertTrue(wait_for(lambda: end.get_num_connections() > 0, 30.0), end.name)

    def assert_stands(self, reason):
        """A patrol does not move the robot, and ends for `reason`; one that comes before the first odometry is sent again."""
        goal = PatrolGoal()
        goal.goal.x, goal.goal.y, goal.goal.z = 1, 1.0, 1

        def ended_otherwise():
            self.client.send_goal(goal)
            self.assertTrue(self.client.wait_for_result(rospy.Duration(60)))
            return 'no odometry' not in self.client.get_result().result
        self.assertTrue(wait_for(ended_otherwise, 30.0))
        self.assertEqual((self.client.get_state(), self.client.get_result().result), (GoalStatus.ABORTED, 'aborted: ' + reason))
        self.assertTrue(self.commands.items)
        self.assertFalse(any(moves(command) for _, command in self.commands.items))

    def test_no_patrol_drives_without_looking_while_the_publisher_of_the_scan_hangs(self):
        """The server is not connected to it, although it is there."""
        scanner = Stranger(self, 'scanner', "from sensor_msgs.msg import LaserScan\n"
                                            "scans = rospy.Publisher('scan', LaserScan, queue_size=1)")
        self.assertTrue(wait_for(lambda: '/scanner' in publishers_of('/scan'), 30.0))
        os.kill(scanner.process.pid, signal.SIGSTOP)
        self.addCleanup(os.kill, scanner.process.pid, signal.SIGCONT)
        self.start_server()
        self.assert_stands('not free ahead: no fresh scan')


if __name__ == '__main__':
    rospy.init_node('patrol_look_test')
    rostest.rosrun('frontier_pilot', 'patrol_look', PatrolLook)
