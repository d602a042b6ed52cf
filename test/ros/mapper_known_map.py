#!/usr/bin/env python3
"""Loading a saved map on the wire: going on with it, and only saying where the robot is on it."""
import math
import os
import re
import shutil
import tempfile
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.srv import LoadMap, SaveMap
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from nav_msgs.msg import OccupancyGrid, Odometry
from nav_msgs.srv import GetMap
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, String
from std_srvs.srv import Trigger

from wire import Record, wait_for

ROOM = (-2.0, -1.5, 4.0, 2.5)  # where the walls are [m]
PILLAR = (3.0, -0.8, 0.6)  # its middle and radius [m]: without it the room would look the same from both ends
BEAMS = 360


def ranges_from(x, y, yaw):
    """What a scanner sees of the room."""
    ranges = []
    for beam in range(BEAMS):
        c, s = math.cos(yaw - math.pi + beam * 2.0 * math.pi / BEAMS), math.sin(yaw - math.pi + beam * 2.0 * math.pi / BEAMS)
        along_x = ((ROOM[2] if c > 0.0 else ROOM[0]) - x) / c if abs(c) > 1e-9 else math.inf
        along_y = ((ROOM[3] if s > 0.0 else ROOM[1]) - y) / s if abs(s) > 1e-9 else math.inf
        ranges.append(min(along_x, along_y, to_pillar(x, y, c, s)))
    return ranges


def to_pillar(x, y, c, s):
    ahead = (PILLAR[0] - x) * c + (PILLAR[1] - y) * s
    aside = (PILLAR[0] - x) * s - (PILLAR[1] - y) * c
    if ahead <= 0.0 or abs(aside) >= PILLAR[2]:
        return math.inf
    return ahead - math.sqrt(PILLAR[2] ** 2 - aside ** 2)


class Robot:
    """Its scanner and its odometry, on the topics of one mapper; odometry begins where the robot is put."""

    def __init__(self, namespace, odom_frame):
        self.odom_frame = odom_frame
        self.scan = rospy.Publisher(namespace + 'scan', LaserScan, queue_size=10)
        self.odom = rospy.Publisher(namespace + 'odom', Odometry, queue_size=10)

    def look_from(self, x, y, yaw, driven=0.0):
        """From a pose in the room, `driven` metres from where odometry began."""
        now = rospy.Time.now()
        odom = Odometry()
        odom.header.stamp, odom.header.frame_id = now, self.odom_frame
        odom.pose.pose.position.x = driven
        odom.pose.pose.orientation.w = 1.0
        self.odom.publish(odom)
        scan = LaserScan()
        scan.header.stamp, scan.header.frame_id = now, 'base_scan'
        scan.angle_min, scan.angle_increment = -math.pi, 2.0 * math.pi / BEAMS
        scan.angle_max = scan.angle_min + (BEAMS - 1) * scan.angle_increment
        scan.range_min, scan.range_max = 0.12, 8.0
        scan.ranges = ranges_from(x + driven * math.cos(yaw), y + driven * math.sin(yaw), yaw)
        self.scan.publish(scan)


class KnownMap(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('mapper_known_map')
        cls.mount = tf2_ros.StaticTransformBroadcaster()
        mount = TransformStamped()
        mount.header.frame_id, mount.child_frame_id = 'base_footprint', 'base_scan'
        mount.transform.rotation.w = 1.0
        cls.mount.sendTransform(mount)
        cls.tf = tf2_ros.Buffer()
        cls.listener = tf2_ros.TransformListener(cls.tf)
        cls.diagnostics = Record('/diagnostics', DiagnosticArray)
        cls.map = Record('map', OccupancyGrid)
        cls.log = Record('/rosout', Log)
        cls.localized = Record('localizer/mapper/localized', Bool)
        cls.robot = Robot('', 'odom')
        cls.lost_robot = Robot('localizer/', 'wheel_odom')
        cls.initial_pose = rospy.Publisher('localizer/initialpose', PoseWithCovarianceStamped, queue_size=1)
        cls.folder = tempfile.mkdtemp()
        cls.saved = os.path.join(cls.folder, 'room')
        cls.make_map()

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def make_map(cls):
        steps = iter(range(100000))

        def mapped():
            cls.robot.look_from(0.0, 0.0, 0.0, 0.02 * min(next(steps) * 0.05, 20.0))
            return cls.map.last is not None and cls.value_at(cls.map.last, -2.02, 0.5) == 100
        assert wait_for(mapped, 30.0), 'there is no map'
        answer = rospy.ServiceProxy('mapper/save_map', SaveMap)(cls.saved)
        assert answer.success, answer.message

    @staticmethod
    def value_at(grid, x, y):
        column = math.floor((x - grid.info.origin.position.x) / grid.info.resolution)
        row = math.floor((y - grid.info.origin.position.y) / grid.info.resolution)
        inside = 0 <= column < grid.info.width and 0 <= row < grid.info.height
        return grid.data[row * grid.info.width + column] if inside else -1

    @staticmethod
    def map_of(namespace):
        return rospy.ServiceProxy(namespace + 'dynamic_map', GetMap)().map

    def correction(self, map_frame='known_map', odom_frame='wheel_odom'):
        try:
            transform = self.tf.lookup_transform(map_frame, odom_frame, rospy.Time(0)).transform
        except tf2_ros.TransformException:
            return (math.inf, math.inf, math.inf)
        return (transform.translation.x, transform.translation.y,
                2.0 * math.atan2(transform.rotation.z, transform.rotation.w))

    def says_localised(self, node, words):
        """Whether the log of a mapper says that the robot was found there."""
        return wait_for(lambda: any(line.name == node and re.match(words, line.msg) for _, line in list(self.log.items)), 20.0)

    def say_where(self, x, y, yaw, frame='known_map'):
        msg = PoseWithCovarianceStamped()
        msg.header.frame_id = frame
        msg.pose.pose.position.x, msg.pose.pose.position.y = x, y
        msg.pose.pose.orientation.z, msg.pose.pose.orientation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
        msg.pose.covariance[0] = msg.pose.covariance[7] = 0.1
        msg.pose.covariance[35] = 0.05
        self.initial_pose.publish(msg)

    def test_a_broken_file_is_refused_with_a_reason_and_nothing_is_lost(self):
        """[MAP-5]"""
        load = rospy.ServiceProxy('mapper/load_map', LoadMap)
        before = self.map_of('').data
        answer = load(os.path.join(self.folder, 'none'))
        self.assertFalse(answer.success)
        self.assertIn('none.bt: no such file', answer.message)
        with open(os.path.join(self.folder, 'broken.bt'), 'w') as broken:
            broken.write('no octree')
        answer = load(os.path.join(self.folder, 'broken.bt'))
        self.assertFalse(answer.success)
        self.assertIn('broken.bt: no octree', answer.message)
        self.assertFalse(load('').success)
        self.assertEqual(before, self.map_of('').data)

    def test_mapping_goes_on_upon_a_loaded_map(self):
        """[MAP-5]"""
        replaced = Record('mapper/replaced', String)
        self.assertTrue(wait_for(lambda: replaced.subscriber.get_num_connections() > 0))
        self.assertTrue(rospy.ServiceProxy('mapper/reset', Trigger)().success)
        answer = rospy.ServiceProxy('mapper/load_map', LoadMap)(self.saved)
        self.assertTrue(answer.success, answer.message)
        self.assertFalse(rospy.ServiceProxy('mapper/load_map', LoadMap)('').success)
        self.assertTrue(wait_for(lambda: len(replaced.items) == 2), replaced.items)
        self.assertEqual([text.data for _, text in replaced.items], ['the map is cleared', answer.message])
        self.assertEqual(100, self.value_at(self.map_of(''), -2.02, 0.5))
        inserted = self.count('scans, inserted')

        def goes_on():
            self.robot.look_from(0.0, 0.0, 0.0)
            return self.count('scans, inserted') > inserted
        self.assertTrue(wait_for(goes_on, 20.0))
        self.assertEqual(100, self.value_at(self.map_of(''), -2.02, 0.5))

    def count(self, key):
        for array in reversed([message for _, message in list(self.diagnostics.items)]):
            for status in array.status:
                values = {value.key: value.value for value in status.values}
                if key in values and 'localizer' not in status.name + status.hardware_id:
                    return int(values[key])
        return 0

    def test_localises_only_from_where_rviz_says(self):
        """[MAP-5]"""
        answer = rospy.ServiceProxy('localizer/mapper/load_map', LoadMap)(self.saved)
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(wait_for(lambda: self.localized.last is not None and not self.localized.last.data), 'not before a scan')
        before = self.map_of('localizer/').data
        at = (1.5, 0.6, 0.4)

        def found():
            self.lost_robot.look_from(*at)
            return all(abs(a - b) < 0.06 for a, b in zip(self.correction(), at))
        self.assertTrue(wait_for(lambda: self.initial_pose.get_num_connections() > 0))
        self.say_where(-1.0, -1.0, 0.0, frame='somewhere')  # refused: another frame
        self.say_where(1.3, 0.8, 0.2)
        # A pose that is heard after a scan has found the robot lets it be looked for again.
        self.assertTrue(wait_for(lambda: found() and self.localized.last.data, 20.0), self.correction())
        self.assertTrue(self.says_localised('/localizer/mapper', r'localised: the robot is at 1\.[45]'), self.log.items)
        self.assertEqual(before, self.map_of('localizer/').data)
        self.assertFalse(rospy.ServiceProxy('localizer/mapper/reset', Trigger)().success)

    def test_is_found_anywhere_on_the_map_when_asked(self):
        """[MAP-5]"""
        localize = rospy.ServiceProxy('searcher/mapper/localize', Trigger)
        robot = Robot('searcher/', 'far_odom')
        at = (1.2, -0.3, -2.0)
        answer = localize()
        self.assertFalse(answer.success)
        self.assertIn('there is no map', answer.message)
        answer = rospy.ServiceProxy('searcher/mapper/load_map', LoadMap)(self.saved)
        self.assertTrue(answer.success, answer.message)

        def found():
            robot.look_from(*at)
            self.answer = localize()
            return self.answer.success
        self.assertTrue(wait_for(found, 20.0), self.answer.message)
        self.assertIn('found the robot at 1.2', self.answer.message)

        def corrected():
            robot.look_from(*at)
            return all(abs(a - b) < 0.06 for a, b in zip(self.correction('far_map', 'far_odom'), at))
        self.assertTrue(wait_for(corrected, 20.0), self.correction('far_map', 'far_odom'))
        self.assertTrue(self.says_localised('/searcher/mapper', r'localised: the robot is at 1\.[12]'), self.log.items)

    def test_says_that_it_needs_a_pose(self):
        """[MAP-5]"""
        def told():
            self.lost_robot.look_from(3.0, 1.8, 1.5)
            return any('not localised' in value.value or 'not localised' in status.message
                       for _, message in self.diagnostics.items for status in message.status for value in status.values)
        rospy.ServiceProxy('localizer/mapper/load_map', LoadMap)(self.saved)
        self.assertTrue(wait_for(told, 20.0))
        self.assertTrue(wait_for(lambda: not self.localized.last.data))
        stranger = rospy.Publisher('localizer/mapper/localized', Bool, queue_size=1)
        self.assertTrue(wait_for(lambda: stranger.publish(True) or self.localized.last.data))
        self.assertTrue(wait_for(lambda: not self.localized.last.data, 3.0), 'what another node says does not stay')


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'mapper_known_map', KnownMap)
