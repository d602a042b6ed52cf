#!/usr/bin/env python3
"""A recorded drive is mapped as if the robot drove now, whatever else its bag holds."""
import math
import os
import shutil
import signal
import struct
import tempfile
import unittest

import rosbag
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from nav_msgs.srv import GetMap
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

from wire import Node, Record, wait_for

RECORDED = 1.5e9  # when the recording began [s]
LEAD = 30.0  # of the stamps [s]
SECONDS = 40.0
HOLE = (18.0, 24.0)
UNSTAMPED = 10.0  # when a scan without a stamp was recorded [s]
ASTRAY = {12.0: 3e9, 13.0: 100.0}  # when scans were recorded whose stamps are false [s], and these stamps [s]
SPEED = 0.15  # of the robot [m/s]
START = (-2.0, 0.0)
WALLS = ((-4.0, -2.0, 5.0, -2.0), (5.0, -2.0, 5.0, 3.0), (5.0, 3.0, -4.0, 3.0), (-4.0, 3.0, -4.0, -2.0),
         (1.0, 1.5, 2.0, 1.5), (2.0, 1.5, 2.0, 3.0), (-1.0, -2.0, -1.0, -1.0))


class NobodyHasThis:
    """A message of a type that is installed nowhere."""
    _type, _md5sum, _full_text = 'strange_msgs/Strange', '381e9a0903b9afde436f814c85f74ebc', 'float64 strangeness\n'


def range_from(x, y, angle):
    """The distance to the nearest wall."""
    c, s = math.cos(angle), math.sin(angle)
    nearest = math.inf
    for x1, y1, x2, y2 in WALLS:
        dx, dy = x2 - x1, y2 - y1
        cross = c * dy - s * dx
        if abs(cross) < 1e-9:
            continue
        along = ((x1 - x) * dy - (y1 - y) * dx) / cross
        share = ((x1 - x) * s - (y1 - y) * c) / cross
        if along > 0.0 and 0.0 <= share <= 1.0:
            nearest = min(nearest, along)
    return nearest


def position(seconds):
    return START[0] + SPEED * seconds, START[1]


def scan_at(seconds, stamp, frame, beams, field):
    scan = LaserScan()
    scan.header.stamp, scan.header.frame_id = stamp, frame
    scan.angle_min, scan.angle_increment = -0.5 * field, field / beams
    scan.angle_max = scan.angle_min + (beams - 1) * scan.angle_increment
    scan.range_min, scan.range_max = 0.12, 8.0
    x, y = position(seconds)
    scan.ranges = [range_from(x, y, scan.angle_min + i * scan.angle_increment) for i in range(beams)]
    return scan


def transform(stamp, parent, child, x=0.0):
    msg = TransformStamped()
    msg.header.stamp, msg.header.frame_id, msg.child_frame_id = stamp, parent, child
    msg.transform.translation.x, msg.transform.rotation.w = x, 1.0
    return msg


def write_bag(path):
    with rosbag.Bag(path, 'w') as bag:
        bag.write('/tf_static', TFMessage([transform(rospy.Time(0), 'base_footprint', 'base_scan')]), rospy.Time(RECORDED))
        for tick in range(int(SECONDS * 20)):
            seconds = tick / 20.0
            recorded, stamp = rospy.Time(RECORDED + seconds), rospy.Time(RECORDED + seconds + LEAD)
            strange = (NobodyHasThis._type, struct.pack('<d', seconds), NobodyHasThis._md5sum, NobodyHasThis)
            bag.write('/strange', strange, recorded, raw=True)
            bag.write('/tf', TFMessage([transform(stamp, 'map', 'odom', 7.0)]), recorded)
            if HOLE[0] < seconds < HOLE[1]:
                continue
            odom = Odometry()
            odom.header.stamp, odom.header.frame_id, odom.child_frame_id = stamp, 'odom', 'base_footprint'
            odom.pose.pose.position.x, odom.pose.pose.orientation.w = SPEED * seconds, 1.0
            odom.twist.twist.linear.x = SPEED
            bag.write('/odom', odom, recorded)
            bag.write('/tf', TFMessage([transform(stamp, 'odom', 'base_footprint', SPEED * seconds)]), recorded)
            if tick % 4 == 0:
                bag.write('/camera/scan', scan_at(seconds, stamp, 'camera', 60, 1.0), recorded)
                stamp = stamp if seconds != UNSTAMPED else rospy.Time(0)
                stamp = rospy.Time(ASTRAY[seconds]) if seconds in ASTRAY else stamp
                bag.write('/lidar', scan_at(seconds, stamp, 'base_scan', 360, 2.0 * math.pi), recorded)


class PlayBag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('play_bag')
        cls.folder = tempfile.mkdtemp()
        cls.bag = os.path.join(cls.folder, 'drive.bag')
        cls.saved = os.path.join(cls.folder, 'mapped')
        write_bag(cls.bag)
        cls.clock = Record('/clock', Clock)
        cls.scans = Record('scan', LaserScan)
        cls.transforms = Record('/tf', TFMessage)
        cls.player = Node('bag_player.py', '_bag:=' + cls.bag, '_speed:=2.0', '_save_map:=' + cls.saved)
        cls.said = ''
        assert wait_for(cls.has_ended, 180.0), cls.said
        cls.exit_code = cls.player.process.returncode

    @classmethod
    def has_ended(cls):
        cls.said = cls.player.said()
        return cls.player.has_ended()

    @classmethod
    def tearDownClass(cls):
        cls.player.end()
        shutil.rmtree(cls.folder)

    def expect_said(self, *words):
        said = self.player.said()
        for word in words:
            self.assertIn(word, said)

    def test_plays_to_the_end_and_saves_the_map(self):
        self.assertEqual(0, self.exit_code, self.player.said())
        self.expect_said('end of the bag', 'Map saved: ' + self.saved)
        for extension in ('.pgm', '.yaml', '.bt'):
            self.assertTrue(os.path.exists(self.saved + extension))

    def test_says_what_it_chose_and_what_it_left_out(self):
        self.expect_said('scans from /lidar: of 2 LaserScan topics the widest field of view', 'not /camera/scan',
                         'odometry from /odom', 'not played: /strange (strange_msgs/Strange)',
                         'stamps are 30.0 s ahead of the time of recording', 'nothing for 6.',
                         'left out: 2 messages whose stamps are more than an hour away from those of the scans',
                         'recorded transforms map -> odom of another mapper')

    def test_no_scan_is_ahead_of_the_clock_and_the_clock_never_jumps(self):
        times = [message.clock.to_sec() for _, message in self.clock.items]
        self.assertTrue(all(0.0 <= b - a <= 0.5 for a, b in zip(times, times[1:])))
        self.assertGreater(len(self.scans.items), 100)
        for arrived, scan in self.scans.items:
            self.assertEqual(scan.header.frame_id, 'base_scan')
            before = [message.clock.to_sec() for at, message in self.clock.items if at <= arrived + 0.2]
            self.assertLessEqual(scan.header.stamp.to_sec(), max(before) + 0.01)

    def test_a_scan_without_a_stamp_is_played_when_it_was_recorded(self):
        stamps = [scan.header.stamp.to_sec() - RECORDED - LEAD for _, scan in self.scans.items]
        self.assertTrue(any(abs(stamp - UNSTAMPED) < 0.001 for stamp in stamps))
        self.assertGreaterEqual(min(stamps), 0.0)
        self.assertGreater(self.clock.items[0][1].clock.to_sec(), RECORDED, 'the clock begins with the bag')

    def test_what_cannot_be_understood_is_said_and_nothing_is_played(self):
        for option, words in (('_speed:=0', 'the speed must be greater than 0'),
                              ('_speed:=fast', "speed:='fast' is not understood"),
                              ('_mount:=1 2', "mount:='1 2' is not understood"),
                              ('_mount:=a b c', "mount:='a b c' is not understood"),
                              ('_save_map:=%s/floor' % self.bag, 'there is no folder'),
                              ('_save_map:=%s/nowhere/floor' % self.folder, 'there is no folder %s/nowhere; make it first' % self.folder),
                              ('_save_map:=%s/' % self.folder, 'not the name of a file'),
                              ('_save_map:=/tmp/' + 251 * 'x', 'not the name of a file')):
            player = Node('bag_player.py', '_bag:=' + self.bag, '_speed:=2.0', '__name:=another_player', option)
            self.assertTrue(wait_for(player.has_ended, 60.0), option)
            rospy.delete_param('/another_player')
            self.assertEqual(1, player.process.returncode, player.said())
            self.assertIn(words, player.said())
            self.assertNotIn('Traceback', player.said())

    def test_who_ends_it_before_the_end_of_the_bag_is_told_that_no_map_is_saved(self):
        path = os.path.join(self.folder, 'unsaved')
        self.clock.items.clear()
        player = Node('bag_player.py', '_bag:=' + self.bag, '_save_map:=' + path, '__name:=another_player')
        self.assertTrue(wait_for(lambda: self.clock.items, 60.0))
        player.signal(signal.SIGINT)
        self.assertTrue(wait_for(player.has_ended, 20.0))
        rospy.delete_param('/another_player')
        self.assertIn('no map is saved as ' + path, player.said())
        self.assertNotIn('does not listen', player.said())
        self.assertFalse(os.path.exists(path + '.yaml'))

    def test_nothing_is_played_beside_a_robot(self):  # [FLT-1]
        for topic, kind in (('/clock', Clock), ('/robot1/scan', LaserScan), ('odom', Odometry)):
            publisher = rospy.Publisher(topic, kind, queue_size=1)
            player = Node('bag_player.py', '_bag:=' + self.bag, '__name:=another_player')
            self.assertTrue(wait_for(player.has_ended, 60.0), topic)
            rospy.delete_param('/another_player')
            self.assertEqual(1, player.process.returncode, player.said())
            self.assertIn('/play_bag publishes %s at this master' % rospy.resolve_name(topic), player.said())
            publisher.unregister()

    def test_what_is_no_bag_is_named_and_not_waited_for(self):  # [FLT-1]
        pipe, junk = os.path.join(self.folder, 'pipe.bag'), os.path.join(self.folder, 'junk.bag')
        os.mkfifo(pipe)
        with open(junk, 'wb') as file:
            file.write(b'#ROSBAG V2.0\n' + bytes(range(256)) * 40)
        for path, words in ((pipe, 'is not a regular file'), (junk, junk)):
            player = Node('bag_player.py', '_bag:=' + path, '__name:=another_player')
            self.assertTrue(wait_for(player.has_ended, 60.0), path)
            self.assertEqual(1, player.process.returncode, player.said())
            self.assertIn(words, player.said())
            self.assertNotIn('Traceback', player.said())

    def test_the_recorded_correction_of_another_mapper_is_not_published(self):
        corrections = [transform for _, message in self.transforms.items for transform in message.transforms
                       if transform.child_frame_id == 'odom']
        self.assertTrue(corrections, "our mapper's")
        self.assertTrue(all(abs(transform.transform.translation.x) < 1.0 for transform in corrections))

    def test_the_map_is_that_of_the_world(self):
        """[MAP-1]"""
        grid = rospy.ServiceProxy('dynamic_map', GetMap)().map
        occupied = self.share(grid, self.points_on_walls(), lambda value: value >= 65, reach=2)
        self.assertGreater(occupied, 0.9)
        way = [(SPEED * seconds, 0.0) for seconds in range(int(SECONDS))]
        self.assertGreater(self.share(grid, way, lambda value: 0 <= value < 25, reach=0), 0.98)

    @staticmethod
    def points_on_walls():
        """In the map's frame, which begins where the robot does."""
        return [(x1 + (x2 - x1) * k / 50.0 - START[0], y1 + (y2 - y1) * k / 50.0 - START[1])
                for x1, y1, x2, y2 in WALLS for k in range(1, 50)]

    @staticmethod
    def share(grid, points, is_it, reach):
        """Of the points that have such a cell within `reach` cells."""
        info = grid.info

        def near(x, y):
            column = int((x - info.origin.position.x) / info.resolution)
            row = int((y - info.origin.position.y) / info.resolution)
            return any(is_it(grid.data[r * info.width + c])
                       for r in range(max(0, row - reach), min(info.height, row + reach + 1))
                       for c in range(max(0, column - reach), min(info.width, column + reach + 1)))
        return sum(near(x, y) for x, y in points) / float(len(points))


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'play_bag', PlayBag)
