#!/usr/bin/env python3
"""A patrol looks at the scan of a scanner that is there, whatever else hides it. [PAT-7]"""
import math
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
from sensor_msgs.msg import LaserScan

from frontier_pilot.msg import ArbiterSource, ArbiterStatus, PatrolAction, PatrolGoal
from wire import Node, Record, Stranger, moves, wait_for

WALL = 0.15  # [m] ahead of the origin of the robot, whose front is 0.1 m ahead of it


def publishers_of(topic):
    return dict(rosgraph.Master('/test').getSystemState()[0]).get(topic, [])


class PatrolLook(unittest.TestCase):
    def setUp(self):
        self.odometry = rospy.Publisher('odom', Odometry, queue_size=1)
        self.addCleanup(self.odometry.unregister)
        self.tell = []  # what else is published with odometry
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
        for tell in self.tell:
            tell()

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

    def wall_ahead(self):
        step = math.pi / 180.0
        scan = LaserScan(angle_min=-math.pi, angle_max=math.pi - step, angle_increment=step, range_min=0.1, range_max=3.5)
        scan.header.frame_id, scan.header.stamp = 'base_footprint', rospy.Time.now()
        ahead = [math.cos(scan.angle_min + beam * step) for beam in range(360)]
        scan.ranges = [WALL / share if share > 0.01 else math.inf for share in ahead]
        return scan

    def test_a_patrol_looks_while_it_drives_itself_by_whatever_name_the_arbiter_has_for_it(self):
        scans = rospy.Publisher('scan', LaserScan, queue_size=1)
        arbiter = rospy.Publisher('cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        for publisher in (scans, arbiter):
            self.addCleanup(publisher.unregister)
        status = ArbiterStatus(state=ArbiterStatus.DRIVING, active_source='patrolling')
        status.sources = [ArbiterSource(name='patrolling', topic='/cmd_vel_patrol', enabled=True)]
        self.tell = [lambda: scans.publish(self.wall_ahead()), lambda: arbiter.publish(status)]
        self.start_server()
        for publisher in (scans, arbiter):
            self.assertTrue(wait_for(lambda: publisher.get_num_connections() > 0, 30.0), publisher.name)
        self.assert_stands('not free ahead: an obstacle')


if __name__ == '__main__':
    rospy.init_node('patrol_look_test')
    rostest.rosrun('frontier_pilot', 'patrol_look', PatrolLook)
