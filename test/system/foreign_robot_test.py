#!/usr/bin/python3
"""The whole system on a robot that has only base_link, odometry as a transform, and /base_scan with late stamps
and a frame that begins with a slash, as in the time of tf1."""
import os
import sys
import unittest

import rospy
import rostest
import tf2_ros
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from explored_share import World, explored_share  # noqa: E402
from system_watch import SystemWatch, wait_until  # noqa: E402

LATE = rospy.Duration(0.1)
ENOUGH = 0.95  # share of the floor
LIMIT = 150.0  # seconds of wall time; 20 are enough on an idle machine


class LateScanner:
    """Passes the scans of the simulator on as a foreign driver would."""

    def __init__(self):
        self.publisher = rospy.Publisher('/base_scan', LaserScan, queue_size=10, tcp_nodelay=True)
        rospy.Subscriber('scan', LaserScan, self.pass_on, tcp_nodelay=True)

    def pass_on(self, scan):
        scan.header.stamp -= LATE
        scan.header.frame_id = '/' + scan.header.frame_id
        self.publisher.publish(scan)


class ForeignRobot(unittest.TestCase):
    def test_it_is_explored_with(self):
        """[ROB-2]"""
        frames = tf2_ros.Buffer()
        tf2_ros.TransformListener(frames)
        odometry = []
        rospy.Subscriber('odom', Odometry, odometry.append)
        watch = SystemWatch()
        scanner = LateScanner()
        world = World(rospy.get_param('simulator/world'))
        floor = world.reachable_floor(world.start, radius=0.15)
        shares = {}  # by the stamp of the map

        def explored():
            if watch.map is not None and watch.map.header.stamp not in shares:
                shares[watch.map.header.stamp] = explored_share(floor, world.start, watch.map)
            return max(shares.values(), default=0.0) >= ENOUGH

        self.assertTrue(wait_until(explored, LIMIT), '%s explored\n%s' % (list(shares.values())[-1:], watch.describe()))
        print('explored %.0f %% after driving %.1f m' % (100 * max(shares.values()), watch.distance))
        self.assertEqual(0, watch.contacts)
        self.assertGreater(watch.status.goals_sent, 0)
        self.assertIsNotNone(scanner.publisher)
        for name in 'base_footprint', 'odom':
            self.assertNotIn(name, frames.all_frames_as_string())
        self.assertEqual(odometry, [])


if __name__ == '__main__':
    rospy.init_node('foreign_robot_test')
    rostest.rosrun('frontier_pilot', 'foreign_robot', ForeignRobot)
