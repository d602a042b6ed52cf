#!/usr/bin/env python3
"""Two whole robots in one world: each has its own scan, map, frames and arbiter, and is an obstacle to the other. Their maps are
put together."""
import math
import unittest

import actionlib
import rospy
import rostest
from frontier_pilot.msg import ArbiterStatus, SpinAction, SpinGoal
from geometry_msgs.msg import Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from sensor_msgs.msg import LaserScan

from system_watch import wait_until

RADIUS = 0.105  # [m]
TOPICS = {'scan': LaserScan, 'odom': Odometry, 'base_pose_ground_truth': Odometry, 'map': OccupancyGrid,
          'merged_map': OccupancyGrid, 'cmd_vel_arbiter/status': ArbiterStatus}


class Robot:
    """The latest of each topic of one robot."""

    def __init__(self, name):
        self.name = name
        self.latest = {}
        for topic, kind in TOPICS.items():
            rospy.Subscriber('/' + name + '/' + topic if name else '/' + topic, kind, self.keep, topic, buff_size=1 << 22)
        self.manual = rospy.Publisher(name + '/cmd_vel_manual', Twist, queue_size=1)

    def keep(self, message, topic):
        self.latest[topic] = message

    def known(self, topic, place):
        """Points that a map of this robot knows, in the frame in which that map begins at `place` (x, y, yaw)."""
        grid = self.latest[topic]
        corner, width, step = grid.info.origin.position, grid.info.width, grid.info.resolution
        points = set()
        for i, value in enumerate(grid.data):
            if value >= 0:
                x, y = corner.x + (i % width + 0.5) * step, corner.y + (i // width + 0.5) * step
                points.add((place[0] + math.cos(place[2]) * x - math.sin(place[2]) * y,
                            place[1] + math.sin(place[2]) * x + math.cos(place[2]) * y))
        return points

    def silent(self):
        return set(TOPICS) - set(self.latest)

    def position(self):
        return self.latest['base_pose_ground_truth'].pose.pose.position

    def yaw(self):
        q = self.latest['base_pose_ground_truth'].pose.pose.orientation
        return 2.0 * math.atan2(q.z, q.w)

    def ahead(self):
        """How far the middle beam sees [m]."""
        return self.latest['scan'].ranges[0]

    def forward(self, speed):
        command = Twist()
        command.linear.x = speed
        self.manual.publish(command)


class SeveralRobots(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('robots_test')
        cls.one, cls.two = Robot('robot1'), Robot('robot2')

    def setUp(self):
        self.assertTrue(wait_until(lambda: not self.one.silent() and not self.two.silent(), 60),
                        (self.one.silent(), self.two.silent()))

    def test_a_each_has_frames_of_its_own(self):
        for robot in (self.one, self.two):
            self.assertEqual(robot.latest['scan'].header.frame_id, robot.name + '/base_scan')
            self.assertEqual(robot.latest['odom'].header.frame_id, robot.name + '/odom')
            self.assertEqual(robot.latest['map'].header.frame_id, robot.name + '/map')

    def test_a_each_has_the_scanner_of_its_kind_and_its_nodes_know_its_limits(self):
        """[MUL-1] [ROB-1]"""
        for robot, farthest, limits in ((self.one, 3.5, None), (self.two, 8.0, {'max_linear': 0.5, 'max_angular': 1.5})):
            self.assertAlmostEqual(robot.latest['scan'].range_max, farthest, places=5)
            self.assertEqual(rospy.get_param('/%s/navigator/robot/limits' % robot.name, None), limits)

    def test_b_each_sees_the_other_and_its_arbiter_drives_it_alone(self):
        """[SIM-2]"""
        gap = self.two.position().x - self.one.position().x - RADIUS
        for robot in (self.one, self.two):
            self.assertTrue(wait_until(lambda: abs(robot.ahead() - gap - 0.032) < 0.1, 10), (robot.name, robot.ahead()))
        start, other = self.one.position().x, self.two.position().x

        def driven():
            self.one.forward(0.1)
            return self.one.position().x > start + 0.3
        self.assertTrue(wait_until(driven, 30), self.one.position())
        self.assertEqual(self.two.position().x, other)
        self.assertEqual(self.two.latest['cmd_vel_arbiter/status'].active_source, '')
        self.assertTrue(wait_until(lambda: self.two.ahead() < gap - 0.2, 10), self.two.ahead())

    def test_c_each_has_behaviours_of_its_own(self):
        """[SPN-1]"""
        standing = self.one.yaw()
        before = self.two.yaw()
        client = actionlib.SimpleActionClient('robot2/spin', SpinAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(30)))

        def spun():
            """A server that has just begun, or waits for the CPU, refuses as long as it has no fresh scan."""
            client.send_goal(SpinGoal(target_yaw=1.0))
            self.assertTrue(wait_until(lambda: client.get_result() is not None, 30))
            return 'no fresh scan' not in client.get_result().error_msg
        self.assertTrue(wait_until(spun, 20), client.get_result().error_msg)
        self.assertEqual(client.get_result().error_code, 0, client.get_result().error_msg)
        turned = (self.two.yaw() - before + math.pi) % (2.0 * math.pi) - math.pi
        self.assertAlmostEqual(turned, 1.0, delta=0.1)
        self.assertAlmostEqual(self.one.yaw(), standing, places=6)

    def test_d_the_common_map_and_each_robots_view_show_what_both_know(self):
        """[MUL-1]"""
        whole = Robot('')
        self.assertTrue(wait_until(lambda: 'map' in whole.latest, 30))
        places = {self.one: (0.0, 0.0, 0.0), self.two: (1.0, 0.0, math.pi)}
        shows = {'/map': lambda: whole.known('map', places[self.one]),
                 'view of robot1': lambda: self.one.known('merged_map', places[self.one]),
                 'view of robot2': lambda: self.two.known('merged_map', places[self.two])}

        def cells(points):
            return {(math.floor(x / 0.1), math.floor(y / 0.1)) for x, y in points}
        for name, show in shows.items():
            for robot, place in places.items():
                def covered():
                    own = cells(robot.known('map', place))
                    return len(own & cells(show())) >= 0.98 * len(own)
                self.assertTrue(wait_until(covered, 30), (name, robot.name))


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'robots', SeveralRobots)
