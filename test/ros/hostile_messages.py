#!/usr/bin/env python3
"""Messages and calls whose numbers would size memory or work: each is refused by name, and every node answers on."""
import io
import math
import struct
import time
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from frontier_pilot.msg import ArbiterStatus, MapBlock, MapChanges
from frontier_pilot.srv import RemoveObstacle, SetPose, SpawnObstacle
from geometry_msgs.msg import Pose2D, PoseStamped, PoseWithCovarianceStamped, TransformStamped
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid, Odometry
from nav_msgs.srv import GetPlan
from rosgraph_msgs.msg import Clock, Log
from sensor_msgs.msg import LaserScan

from wire import Record, assert_memory_below, call, memory_of, pid_of, wait_for

MAP_READERS = ('reader/navigator', 'reader/frontier_explorer')
SCAN_READERS = ('mapper', 'obstacle_avoider', 'behavior_server', 'reader/navigator')
ODOMETRY_READERS = ('mapper', 'patrol_server') + MAP_READERS
NODES = SCAN_READERS + ('reader/frontier_explorer', 'patrol_server', 'simulator')
MOST_MEMORY = 700.0  # [MB], at any time: the largest map that is taken, and a message of 64 MB that is not
MOST_SILENCE = 10.0  # [s] of a node on a busy machine


class Stub(LaserScan):
    """A message that ends before its first field does."""

    def serialize(self, buff):
        buff.write(b'abc')


def empty(kind):
    """A message of no byte at all, of a type that has fields."""
    return type('Empty', (kind,), {'serialize': lambda self, buff: None})()


class BigMap(OccupancyGrid):
    """A map of one value that is not a Python object for each cell."""

    def __init__(self, width, height, value=0, resolution=0.05):
        super().__init__()
        self.header.frame_id = 'map'
        self.info.width, self.info.height, self.info.resolution = width, height, resolution
        self.info.origin.orientation.w = 1.0
        self.cells = bytes([value]) * (width * height)

    def serialize(self, buff):
        head = io.BytesIO()
        super().serialize(head)
        buff.write(head.getvalue()[:-4] + struct.pack('<I', len(self.cells)) + self.cells)


def map_of(cells, width, resolution=0.05, frame='map'):
    msg = OccupancyGrid()
    msg.header.frame_id = frame
    msg.info.width, msg.info.height, msg.info.resolution = width, len(cells) // width, resolution
    msg.info.origin.orientation.w = 1.0
    msg.data = cells
    return msg


def box_in_a_room():
    """10 m x 10 m of floor with a solid box in the middle."""
    return [100 if 60 <= i % 200 < 140 and 60 <= i // 200 < 140 else 0 for i in range(200 * 200)]


def update(x, y, width=1, height=1):
    msg = OccupancyGridUpdate(x=x, y=y, width=width, height=height, data=[0] * (width * height))
    msg.header.frame_id = 'map'
    return msg


def scan(ranges, frame='base_scan', range_max=3.5):
    msg = LaserScan(angle_min=-math.pi, angle_max=math.pi, range_min=0.12, range_max=range_max, ranges=ranges)
    msg.angle_increment = 2 * math.pi / max(1, len(ranges) - 1)
    msg.header.frame_id = frame
    msg.header.stamp = rospy.Time.now()
    return msg


def pose(x, y=0.0, frame='map'):
    msg = PoseStamped()
    msg.header.frame_id = frame
    msg.pose.position.x, msg.pose.position.y, msg.pose.orientation.w = x, y, 1.0
    return msg


class HostileMessages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('hostile_messages')
        cls.words = Record('/diagnostics', DiagnosticArray)
        assert wait_for(lambda: all(cls.said(node) for node in NODES), 60.0)
        cls.pids = {node: pid_of('/' + node) for node in NODES}
        cls.frames = tf2_ros.StaticTransformBroadcaster()
        cls.maps = rospy.Publisher('/reader/map', OccupancyGrid, queue_size=5, latch=True)
        cls.updates = rospy.Publisher('/reader/map_updates', OccupancyGridUpdate, queue_size=100)
        cls.changes = rospy.Publisher('/reader/map_changes', MapChanges, queue_size=5)
        cls.goals = rospy.Publisher('/reader/move_base_simple/goal', PoseStamped, queue_size=5)
        cls.scans = rospy.Publisher('/scan', LaserScan, queue_size=5)
        cls.odometry = rospy.Publisher('/odom', Odometry, queue_size=5)
        cls.poses = rospy.Publisher('/initialpose', PoseWithCovarianceStamped, queue_size=5)
        connections = ((cls.maps, 2), (cls.updates, 2), (cls.changes, 2), (cls.goals, 1), (cls.scans, 4), (cls.odometry, 4),
                       (cls.poses, 1))
        assert wait_for(lambda: all(topic.get_num_connections() >= count for topic, count in connections), 30.0)
        cls.maps.publish(map_of(box_in_a_room(), 200))

    @classmethod
    def said(cls, node, since=0.0):
        """The last diagnostics of a node as a dictionary, empty if there are none since then."""
        for message in reversed(cls.words.since(since)):
            for status in message.status:
                if status.name.startswith(node + ':'):
                    return dict({pair.key: pair.value for pair in status.values}, level=status.level)
        return {}

    @classmethod
    def connections(cls, node, since=0.0):
        """The last that a node says of its connections: the status's text and its values."""
        for message in reversed(cls.words.since(since)):
            for status in message.status:
                if status.name == node + ': connections':
                    return status, {pair.key: pair.value for pair in status.values}
        return DiagnosticStatus(), {}

    @classmethod
    def refused(cls, node, what, why):
        """How many inputs a node has refused for a reason. The mapper says of a scan first what became of it."""
        return sum(int(count) for key, count in cls.said(node).items()
                   if key.startswith(what + ' refused: ') and key.endswith(why))

    def tearDown(self):
        start = time.monotonic()
        for node in NODES:
            self.assertTrue(wait_for(lambda: self.said(node, start), MOST_SILENCE), node + ' answers no more [FLT-1]')
            self.assertEqual(pid_of('/' + node), self.pids[node], node + ' is another one [FLT-1]')
            assert_memory_below(self, memory_of(self.pids[node])[1], MOST_MEMORY, node + ' [MB] [FLT-1]')

    def expect_refusal(self, nodes, what, why, send):
        """That each of `nodes` counts one more for the message that is sent."""
        counts = {node: self.refused(node, what, why) for node in nodes}

        def lacking():
            return [node for node, count in counts.items() if self.refused(node, what, why) <= count]
        end = time.monotonic() + MOST_SILENCE
        while lacking() and time.monotonic() < end:
            send()  # once more where a node that was busy has only kept the message after it
            wait_for(lambda: not lacking(), 3.0)
        for node in lacking():
            self.fail('%s: %s refused: %s [FLT-1], but %s' % (node, what, why, self.said(node)))

    def test_an_update_at_the_end_of_an_int(self):  # [FLT-1]
        for x, y in ((2147483647, 0), (0, 2147483647), (2147483647, 2147483647)):
            self.expect_refusal(MAP_READERS, 'map message', 'update reaches beyond any map',
                                lambda: self.updates.publish(update(x, y)))
        self.expect_refusal(MAP_READERS, 'map message', 'update reaches beyond the map',
                            lambda: self.updates.publish(update(199, 199, 2, 1)))

    def test_cells_too_small(self):  # [FLT-1]
        for resolution in (1e-10, 1e-40, 1e30):
            self.expect_refusal(MAP_READERS, 'map message', 'resolution not within 0.01 m ... 10 m',
                                lambda: self.maps.publish(map_of([0] * 100, 10, resolution)))

    def test_maps_too_large(self):  # [FLT-1]
        text = 'map of more than 40000000 cells: make its cells larger, or leave out what nobody drives in'
        before = {node: memory_of(self.pids[node])[0] for node in MAP_READERS}
        self.expect_refusal(MAP_READERS, 'map message', text, lambda: self.maps.publish(BigMap(8000, 8000)))
        for node in MAP_READERS:
            more = memory_of(self.pids[node])[0] - before[node]
            assert_memory_below(self, more, 250.0, node + ' keeps nothing of it [MB] [FLT-1]')

    def test_a_few_bytes_that_stand_for_too_many_cells(self):  # [FLT-1]
        before = {node: memory_of(self.pids[node])[0] for node in MAP_READERS}
        for width, blocks, text in ((65536, [], 'map of more than 20000 cells along a side'),
                                    (6000, [], 'runs malformed, or not as many cells as the blocks have'),
                                    (6000, [MapBlock(0, 0, 6000, 6000)] * 2, 'blocks of more cells than the map has')):
            msg = MapChanges(whole=not blocks, blocks=blocks, runs=b'\x3f\xff\xff\xff\xff' * 3)
            msg.header.frame_id = 'map'
            msg.info = map_of([0] * width, width).info
            msg.info.height = width
            self.expect_refusal(MAP_READERS, 'map message', text, lambda: self.changes.publish(msg))
        for node in MAP_READERS:
            more = memory_of(self.pids[node])[0] - before[node]
            assert_memory_below(self, more, 30.0, node + ' decodes nothing of it [MB] [FLT-1]')

    def test_the_largest_maps_that_are_taken(self):  # [FLT-1]
        before = {node: memory_of(self.pids[node])[0] for node in MAP_READERS}
        refused = {node: self.said(node).get('map message refused') for node in MAP_READERS}
        self.maps.publish(BigMap(4000, 4000))

        def plan():
            return call('/reader/make_plan', GetPlan, pose(150.0, 150.0), pose(190.0, 190.0), 0.0).plan.poses
        self.assertTrue(wait_for(lambda: self.planned(plan), 30.0), 'where only the large map has floor')
        start = time.monotonic() + 2.0
        for node in MAP_READERS:
            self.assertTrue(wait_for(lambda: self.said(node, start), 30.0), node)
            now, most = memory_of(self.pids[node])
            for_each = (now - before[node]) * 1024 * 1024 / 16e6
            print('%s: %.1f bytes for each cell, at most %.0f MB' % (node, for_each, most))
            assert_memory_below(self, for_each, 30.0, node + ' [FLT-1]')
            self.assertEqual(self.said(node).get('map message refused'), refused[node])
        self.maps.publish(map_of(box_in_a_room(), 200))

    @staticmethod
    def planned(plan):
        """Whether a plan is found; a call for one outside of the map that is there yet gives none."""
        try:
            return len(plan()) > 5
        except rospy.ServiceException:
            return False

    def test_scans_too_large(self):  # [FLT-1]
        self.expect_refusal(SCAN_READERS, 'scan', 'more than 36000 ranges',
                            lambda: self.scans.publish(scan([1.0] * 1000000)))

    def test_numbers_of_a_scan(self):  # [FLT-1]
        self.expect_refusal(SCAN_READERS, 'scan', 'range limit beyond 1000 m',
                            lambda: self.scans.publish(scan([1.0] * 360, range_max=1e30)))
        fine = scan([1.0])
        fine.angle_max, fine.angle_increment = fine.angle_min, 1e-30
        self.expect_refusal(SCAN_READERS, 'scan', 'angle increment too small', lambda: self.scans.publish(fine))

    def test_messages_that_cannot_be_read(self):  # [FLT-1]
        log, count = Record('/rosout', Log), 'message of scan refused: shorter than its fields'
        stub = Stub()

        def counted():
            return [int(self.connections(node)[1].get(count, 0)) for node in SCAN_READERS]
        start = time.monotonic()
        while time.monotonic() < start + 10.0:  # so that more than one line at most may come of it
            self.scans.publish(stub)
            rospy.rostime.wallsleep(0.005)
        wait_for(lambda: min(counted()) > 100, MOST_SILENCE)
        self.assertGreater(min(counted()), 100, '%s of %s [FLT-1]' % (counted(), SCAN_READERS))
        lines = [line for _, line in list(log.items) if line.name.strip('/') in SCAN_READERS
                 and ('deserializ' in line.msg or 'message of scan' in line.msg)]
        for node in SCAN_READERS:
            said = [line.msg for line in lines if line.name.strip('/') == node]
            self.assertIn(len(said), (1, 2, 3, 4), '%s: %s [FLT-1]' % (node, said[:5]))
            self.assertIn('shorter than its fields', said[0])

    def test_empty_messages_where_a_node_listens_twice(self):  # [FLT-1]
        count = 'message of cmd_vel_arbiter/status refused: shorter than its fields'
        nodes = ('obstacle_avoider', 'patrol_server', 'reader/frontier_explorer')
        pids = {node: pid_of(node) for node in NODES}
        publishers = [(rospy.Publisher(topic, kind, queue_size=10), empty(kind)) for topic, kind in (
            ('cmd_vel_arbiter/status', ArbiterStatus), ('reader/cmd_vel_arbiter/status', ArbiterStatus), ('/clock', Clock))]

        def counted():
            return [int(self.connections(node)[1].get(count, 0)) for node in nodes]
        start = time.monotonic()
        while time.monotonic() < start + 10.0:
            for publisher, message in publishers:
                publisher.publish(message)
            rospy.rostime.wallsleep(0.005)
        for publisher, _ in publishers:
            publisher.unregister()
        wait_for(lambda: min(counted()) > 50, MOST_SILENCE)
        self.assertGreater(min(counted()), 50, '%s of %s [FLT-1]' % (counted(), nodes))
        self.assertEqual({node: pid_of(node) for node in NODES}, pids)

    def expect_named(self, nodes, topic, send):
        """That each of `nodes` says who publishes `topic`, as long as a second one does."""
        def silent(node):
            return 'several nodes' not in self.connections(node)[0].message

        def named(node):
            status = self.connections(node)[0]
            return (status.level == DiagnosticStatus.WARN and 'several nodes publish %s: ' % topic in status.message
                    and '/simulator' in status.message and '/hostile_messages' in status.message)
        self.assertTrue(wait_for(lambda: all(map(silent, nodes)), MOST_SILENCE))
        end = time.monotonic() + MOST_SILENCE
        while not all(map(named, nodes)) and time.monotonic() < end:
            send()
            wait_for(lambda: all(map(named, nodes)), 0.2)
        for node in nodes:
            self.assertTrue(named(node), '%s: %s [FLT-1]' % (node, self.connections(node)[0].message))
        self.assertTrue(wait_for(lambda: all(map(silent, nodes)), MOST_SILENCE), 'and forgotten [FLT-1]')

    def test_a_second_publisher_of_scans_or_odometry_is_named(self):  # [FLT-1]
        self.expect_named(SCAN_READERS, 'scan', lambda: self.scans.publish(scan([1.0] * 360)))
        odometry = Odometry()
        odometry.header.frame_id, odometry.pose.pose.orientation.w = 'odom', 2.0  # refused: the robot stays where it is
        self.expect_named(ODOMETRY_READERS, 'odom', lambda: self.odometry.publish(odometry))

    def test_a_scanner_far_away(self):  # [FLT-1]
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'base_footprint', 'far_scanner'
        transform.transform.translation.x, transform.transform.rotation.w = 9e5, 1.0
        self.frames.sendTransform(transform)
        text = 'scanner mounted farther than 10 m from the base'

        def refused():
            return all(self.refused(node, 'scan', text) > 0 for node in SCAN_READERS)
        end = time.monotonic() + MOST_SILENCE
        while not refused() and time.monotonic() < end:  # the transform may come after the first scan
            self.scans.publish(scan([1.0] * 360, 'far_scanner'))
            wait_for(refused, 0.5)
        self.assertTrue(refused(), '[FLT-1]')

    def test_the_densest_scans_that_are_taken(self):  # [FLT-1]
        for _ in range(3):
            self.scans.publish(scan([0.13] * 36000))

    def test_poses_far_away(self):  # [FLT-1]
        far = 'position farther than 1000 km from the origin'
        msg = PoseWithCovarianceStamped()
        msg.header.frame_id = 'map'
        msg.pose.pose = pose(1e300).pose
        self.expect_refusal(('mapper',), 'initial pose', far, lambda: self.poses.publish(msg))
        self.expect_refusal(('reader/navigator',), 'goal of move_base_simple', far,
                            lambda: self.goals.publish(pose(1e300)))
        odometry = Odometry()
        odometry.header.frame_id, odometry.header.stamp = 'odom', rospy.Time.now()
        odometry.pose.pose = pose(1e300).pose
        self.expect_refusal(ODOMETRY_READERS, 'odometry', far,
                            lambda: self.odometry.publish(odometry))

    def test_frames_that_nobody_knows_do_not_pile_up(self):  # [FLT-1]
        for i in range(200):
            msg = update(0, 0)
            msg.header.frame_id = 'frame_%d' % i + 1000 * 'x'
            self.updates.publish(msg)
            rospy.rostime.wallsleep(0.002)
        for node in MAP_READERS:
            self.assertTrue(wait_for(lambda: self.refused(node, 'map message', 'for other reasons') > 50,
                                     MOST_SILENCE), node)
            self.assertLess(len(self.said(node)), 60, node + ' [FLT-1]')
            self.assertLess(max(len(key) for key in self.said(node)), 300, node + ' [FLT-1]')

    def test_frames_that_speak_to_whoever_reads_of_them(self):  # [FLT-1]
        frame, shown = 'map\n[ERROR] forged\x1b[2J\x9b\u2028', 'map\\n[ERROR] forged\\x1b[2J\\u009b\\u2028'
        start, log = time.monotonic(), Record('/rosout', Log)
        msg = update(0, 0)
        msg.header.frame_id = frame

        def named(node):
            return any(shown in key for key in self.said(node))
        end = time.monotonic() + MOST_SILENCE
        while not all(map(named, MAP_READERS + SCAN_READERS)) and time.monotonic() < end:
            self.updates.publish(msg)
            self.scans.publish(scan([1.0] * 360, frame))
            wait_for(lambda: all(map(named, MAP_READERS + SCAN_READERS)), 0.5)
        for node in MAP_READERS + SCAN_READERS:
            self.assertTrue(named(node), '%s [FLT-1]: %s' % (node, self.said(node)))
        texts = [line.msg for _, line in list(log.items) if not line.name.startswith('/hostile_messages')]
        for message in self.words.since(start):
            for status in message.status:
                texts += [status.message] + [text for pair in status.values for text in (pair.key, pair.value)]
        self.assertEqual([text for text in texts if any(c in text for c in '\n\x1b\x9b\u2028')], [], '[FLT-1]')

    def test_a_plan_to_anywhere(self):  # [FLT-1]
        def plan():
            return call('/reader/make_plan', GetPlan, pose(1.0, 1.0), pose(5.0, 5.0), 1e30).plan.poses
        self.maps.publish(map_of(box_in_a_room(), 200))
        self.assertTrue(wait_for(lambda: self.planned(plan), MOST_SILENCE), 'beside the box')

    def test_obstacles_too_many_or_too_large(self):  # [FLT-1]
        def spawn(name, x, radius):
            return call('/simulator/spawn_obstacle', SpawnObstacle, name, Pose2D(x, 1e5, 0.0), radius).message
        self.assertIn('at most 256 characters', spawn('x' * 1000000, 1.0, 0.1))
        self.assertIn('farther than 1000 km', spawn('far', 1e300, 0.1))
        self.assertIn('at most 10 m', spawn('wide', 1.0, 1e300))
        self.assertIn('no robot', call('/simulator/set_pose', SetPose, 'x' * 1000000, Pose2D()).message)
        self.assertIn('outside', call('/simulator/set_pose', SetPose, '', Pose2D(1e300, 0.0, 0.0)).message)
        spawn_obstacle = rospy.ServiceProxy('/simulator/spawn_obstacle', SpawnObstacle, persistent=True)
        names = ['box%d' % i for i in range(1001)]
        answers = [spawn_obstacle(name, Pose2D(1.0, 1e5, 0.0), 0.1).message for name in names]
        self.assertEqual(answers[:1000], ['done'] * 1000)
        self.assertIn('1000 obstacles already', answers[1000])
        remove_obstacle = rospy.ServiceProxy('/simulator/remove_obstacle', RemoveObstacle, persistent=True)
        self.assertTrue(all(remove_obstacle(name).success for name in names[:1000]))


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'hostile_messages', HostileMessages)
