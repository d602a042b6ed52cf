#!/usr/bin/env python3
"""The mapper with the simulator's bad odometry, once around the loop: what the robot thinks of where it is."""
import math
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Twist
from nav_msgs.msg import OccupancyGrid, Odometry

from wire import Record, wait_for

CORNERS = ((22.1, 2.3), (22.1, 15.1), (2.3, 15.1), (2.3, 2.3), (10.0, 2.3))
NEAR = 0.4  # [m]


def yaw_of(quaternion):
    return 2.0 * math.atan2(quaternion.z, quaternion.w)


def wrapped(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


class Pilot:
    """Steers along the corners by the true pose."""

    def __init__(self):
        self.corners = list(CORNERS)
        self.command = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        self.truth = rospy.Subscriber('base_pose_ground_truth', Odometry, self.steer, queue_size=1)

    def steer(self, truth):
        at, yaw = truth.pose.pose.position, yaw_of(truth.pose.pose.orientation)
        while self.corners and math.hypot(self.corners[0][0] - at.x, self.corners[0][1] - at.y) < NEAR:
            self.corners.pop(0)
        twist = Twist()
        if self.corners:
            error = wrapped(math.atan2(self.corners[0][1] - at.y, self.corners[0][0] - at.x) - yaw)
            twist.linear.x = 1.0 if abs(error) < 0.3 else 0.0
            twist.angular.z = max(-1.5, min(1.5, 3.0 * error))
        self.command.publish(twist)


class MapperAroundTheLoop(unittest.TestCase):
    def setUp(self):
        rospy.init_node('mapper_loop')
        self.tf = tf2_ros.Buffer(rospy.Duration(100.0))
        self.listener = tf2_ros.TransformListener(self.tf)
        self.diagnostics = Record('/diagnostics', DiagnosticArray)
        self.truth = Record('base_pose_ground_truth', Odometry)
        self.map = Record('map', OccupancyGrid)

    def diagnostic(self, key):
        for array in reversed([message for _, message in list(self.diagnostics.items)]):
            for status in array.status:
                values = {value.key: value.value for value in status.values}
                if key in values:
                    return values[key]
        return None

    def error(self):
        """How far the robot thinks it is from where it is [m]: world -> map is exact in the simulator."""
        truth = self.truth.last
        try:
            thought = self.tf.lookup_transform('world', 'base_footprint', truth.header.stamp, rospy.Duration(1.0))
        except tf2_ros.TransformException:
            return math.inf
        return math.hypot(thought.transform.translation.x - truth.pose.pose.position.x,
                          thought.transform.translation.y - truth.pose.pose.position.y)

    def test_map_to_odom_takes_back_what_odometry_gets_wrong_and_a_loop_is_closed(self):
        """[MAP-1]"""
        pilot = Pilot()
        self.assertTrue(wait_for(lambda: not pilot.corners, 150.0), 'still on the way to %s' % pilot.corners)
        self.assertTrue(wait_for(lambda: int(self.diagnostic('loops closed') or 0) > 0, 20.0), 'no loop was closed')
        self.assertTrue(wait_for(lambda: self.error() < 0.15, 10.0), 'off by %.2f m' % self.error())
        odom = self.tf.lookup_transform('map', 'odom', rospy.Time(0)).transform
        correction = math.hypot(odom.translation.x, odom.translation.y) + abs(yaw_of(odom.rotation))
        self.assertGreater(correction, 0.2, 'the odometry was good enough without')
        self.assertGreater(int(self.diagnostic('poses, matched')), 100)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'mapper_loop', MapperAroundTheLoop)
