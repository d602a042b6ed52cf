#!/usr/bin/env python3
"""The node map_merger on the wire: two robots' maps become one, and each robot's view of it. [MUL-1]"""
import math
import os
import random
import signal
import tempfile
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid

from frontier_pilot.srv import SaveMap
from wire import Node, Record, wait_for

RESOLUTION = 0.05
SIDE = 60  # [cells]
STARTS = {'left': (2.0, 1.0, 0.0), 'right': (2.0, 3.5, math.pi / 2)}  # so right's map lies at (0, 2.5), turned to the left
BLOCKS = {'left': (10, 20), 'right': (30, 40)}  # where each robot alone sees a pillar of 5 x 5 cells
ALL = {'/map': 'map', '/left/merged_map': 'left/map', '/right/merged_map': 'right/map'}


def between(target, source, point):
    """A point of `source` in `target`, each (x, y, yaw) in a frame that they have in common."""
    x = source[0] + math.cos(source[2]) * point[0] - math.sin(source[2]) * point[1] - target[0]
    y = source[1] + math.sin(source[2]) * point[0] + math.cos(source[2]) * point[1] - target[1]
    return math.cos(target[2]) * x + math.sin(target[2]) * y, math.cos(target[2]) * y - math.sin(target[2]) * x


def value_at(grid, point):
    column = math.floor((point[0] - grid.info.origin.position.x) / grid.info.resolution)
    row = math.floor((point[1] - grid.info.origin.position.y) / grid.info.resolution)
    inside = 0 <= column < grid.info.width and 0 <= row < grid.info.height
    return grid.data[row * grid.info.width + column] if inside else -1


def middle(block):
    return (block[0] + 2.5) * RESOLUTION, (block[1] + 2.5) * RESOLUTION


class Mapper:
    """Publishes the map of one robot: free floor with a pillar."""

    def __init__(self, robot):
        self.robot = robot
        self.maps = rospy.Publisher(robot + '/map', OccupancyGrid, queue_size=1, latch=True)
        self.updates = rospy.Publisher(robot + '/map_updates', OccupancyGridUpdate, queue_size=10)
        self.maps.publish(self.map())

    def map(self):
        grid = OccupancyGrid()
        grid.header.frame_id = self.robot + '/map'
        grid.header.stamp = rospy.Time.now()
        grid.info.resolution = RESOLUTION
        grid.info.width = grid.info.height = SIDE
        grid.info.origin.orientation.w = 1.0
        left, below = BLOCKS[self.robot]
        grid.data = [100 if left <= i % SIDE < left + 5 and below <= i // SIDE < below + 5 else 0 for i in range(SIDE * SIDE)]
        return grid

    def build_a_pillar(self, block):
        update = OccupancyGridUpdate(x=block[0], y=block[1], width=5, height=5, data=[100] * 25)
        update.header.frame_id = self.robot + '/map'
        update.header.stamp = rospy.Time.now()
        self.updates.publish(update)

    def end(self):
        self.maps.unregister()
        self.updates.unregister()


class MapMerger(unittest.TestCase):
    def setUp(self):
        robots = [{'name': name, 'x': x, 'y': y, 'yaw': yaw} for name, (x, y, yaw) in STARTS.items()]
        rospy.set_param('/map_merger/robots', robots)
        self.mappers = {name: Mapper(name) for name in STARTS}
        self.records = {topic: Record(topic, OccupancyGrid) for topic in ALL}
        self.changes = Record('/map_updates', OccupancyGridUpdate)
        self.diagnostics = Record('/diagnostics', DiagnosticArray)
        self.node = Node('map_merger')
        self.addCleanup(self.end)
        self.assertTrue(wait_for(lambda: self.is_connected() and self.is_complete(), 30.0), self.node.said())

    def is_connected(self):
        """Maps are latched, changes are not: they reach only who is connected."""
        return self.changes.subscriber.get_num_connections() > 0 and all(
            mapper.updates.get_num_connections() > 0 for mapper in self.mappers.values())

    def end(self):
        for mapper in self.mappers.values():
            mapper.end()
        self.node.end()
        for record in list(self.records.values()) + [self.changes, self.diagnostics]:
            record.subscriber.unregister()

    def shows(self, topic, robot, point):
        """What the last map of a topic says of a point in the map of `robot`."""
        grid = self.records[topic].last
        target = STARTS['right' if topic.startswith('/right') else 'left']
        return None if grid is None else value_at(grid, between(target, STARTS[robot], point))

    def is_complete(self):
        return all(self.shows(topic, robot, middle(block)) == 100 for topic in ALL for robot, block in BLOCKS.items())

    def said(self):
        """The last status of the node, as one text."""
        found = [status for _, array in list(self.diagnostics.items) for status in array.status if status.name.endswith('merging')]
        return '' if not found else found[-1].message + str([(pair.key, pair.value) for pair in found[-1].values])

    def test_shows_both_robots_maps_in_every_frame(self):
        for topic, frame in ALL.items():
            self.assertEqual(self.records[topic].last.header.frame_id, frame)
            for robot in STARTS:
                self.assertEqual(self.shows(topic, robot, (2.7, 0.3)), 0, (topic, robot))
        self.assertEqual(self.shows('/map', 'left', (-5.0, 0.0)), -1)
        self.assertTrue(wait_for(lambda: '2 of 2 robots merged' in self.said()), self.said())

    def test_publishes_where_the_robots_maps_lie(self):
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        self.assertTrue(wait_for(lambda: all(buffer.can_transform('map', name + '/map', rospy.Time(0)) for name in STARTS)))
        place = buffer.lookup_transform('map', 'right/map', rospy.Time(0)).transform
        self.assertAlmostEqual(place.translation.x, 0.0)
        self.assertAlmostEqual(place.translation.y, 2.5)
        self.assertAlmostEqual(2.0 * math.atan2(place.rotation.z, place.rotation.w), math.pi / 2)
        listener.unregister()

    def test_passes_changes_on_as_changes(self):
        block = (5, 50)
        self.mappers['right'].build_a_pillar(block)

        def passed_on():
            return any(update.width <= 7 and update.height <= 7 and max(update.data) == 100
                       for _, update in list(self.changes.items))
        self.assertTrue(wait_for(passed_on), self.changes.last)

    def test_keeps_the_map_of_a_robot_that_is_gone(self):
        self.mappers['right'].end()
        self.mappers['left'].build_a_pillar((40, 5))
        self.assertTrue(wait_for(lambda: self.shows('/map', 'left', middle((40, 5))) == 100, 30.0))
        self.assertEqual(self.shows('/map', 'right', middle(BLOCKS['right'])), 100)

    def test_refuses_what_is_no_map_of_the_robot_and_names_it(self):
        """[FLT-1]"""
        spoiled = {'in frame': lambda grid: setattr(grid.header, 'frame_id', 'map'),
                   'origin': lambda grid: setattr(grid.info.origin.position, 'x', math.nan),
                   'resolution': lambda grid: setattr(grid.info, 'resolution', 0.0),
                   'cells': lambda grid: setattr(grid.info, 'width', 1 << 31)}
        for spoil in spoiled.values():
            grid = self.mappers['right'].map()
            spoil(grid)
            self.mappers['right'].maps.publish(grid)
            rospy.sleep(0.2)  # a latched topic keeps the last message alone
        self.assertTrue(wait_for(lambda: 'in frame' in self.said()), self.said())
        self.assertTrue(wait_for(lambda: self.said().count('map message refused: ') >= len(spoiled)), self.said())
        self.assertTrue(self.is_complete())

    def test_saves_the_common_map(self):
        with tempfile.TemporaryDirectory() as folder:
            save = rospy.ServiceProxy('map_merger/save_map', SaveMap)
            self.assertFalse(save(folder + '/nowhere/fleet').success)
            answer = save(folder + '/fleet')
            self.assertTrue(answer.success, answer.message)
            self.assertEqual(sorted(os.listdir(folder)), ['fleet.bt', 'fleet.pgm', 'fleet.yaml'])
            with open(folder + '/fleet.pgm', 'rb') as picture:
                black = picture.read().partition(b'\n255\n')[2].count(0)
        self.assertGreaterEqual(black, 40, 'two pillars of 25 cells, one of them turned')

    def test_a_restarted_node_goes_on_where_the_dead_one_was(self):
        """[FLT-2]"""
        self.node.signal(signal.SIGKILL)
        self.node.finish()
        for record in self.records.values():
            record.items.clear()
        self.node = Node('map_merger')
        self.assertTrue(wait_for(self.is_complete, 30.0), self.node.said())


class Hall:
    """The maps that two robots have of one hall with boxes, each in the frame of its own start."""
    SIDE = 200  # [cells] of a robot's map, which lies around its start
    STARTS = {'left': (4.0, 5.0, 0.3), 'right': (7.0, 6.0, 2.0)}

    def __init__(self):
        draw = random.Random(5)
        self.boxes = [(draw.uniform(0.5, 11.0), draw.uniform(0.5, 11.0), draw.uniform(0.2, 1.0), draw.uniform(0.2, 1.0))
                      for _ in range(30)]

    def is_occupied(self, x, y):
        return not (0.2 < x < 12.0 and 0.2 < y < 12.0) or any(
            left < x < left + width and below < y < below + height for left, below, width, height in self.boxes)

    def publish(self, robot):
        grid = OccupancyGrid()
        grid.header.frame_id, grid.header.stamp = robot + '/map', rospy.Time.now()
        grid.info.resolution, grid.info.width, grid.info.height = RESOLUTION, self.SIDE, self.SIDE
        grid.info.origin.position.x = grid.info.origin.position.y = -0.5 * self.SIDE * RESOLUTION
        grid.info.origin.orientation.w = 1.0
        centres = [(i + 0.5 - 0.5 * self.SIDE) * RESOLUTION for i in range(self.SIDE)]
        cells = (between((0.0, 0.0, 0.0), self.STARTS[robot], (x, y)) for y in centres for x in centres)
        grid.data = [100 if self.is_occupied(*cell) else 0 for cell in cells]
        publisher = rospy.Publisher(robot + '/map', OccupancyGrid, queue_size=1, latch=True)
        publisher.publish(grid)
        return publisher


class UnknownStarts(unittest.TestCase):
    def test_are_found_once_the_maps_overlap(self):
        rospy.set_param('/map_merger', {'known_starts': False, 'robots': [{'name': name} for name in Hall.STARTS]})
        publishers = [Hall().publish(name) for name in Hall.STARTS]
        diagnostics = Record('/diagnostics', DiagnosticArray)
        node = Node('map_merger')
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        for end in [node.end, listener.unregister, diagnostics.subscriber.unregister] + [each.unregister for each in publishers]:
            self.addCleanup(end)
        self.assertTrue(wait_for(lambda: buffer.can_transform('map', 'right/map', rospy.Time(0)), 60.0), node.said())
        place = buffer.lookup_transform('map', 'right/map', rospy.Time(0)).transform
        x, y = between(Hall.STARTS['left'], Hall.STARTS['right'], (0.0, 0.0))
        self.assertLess(math.hypot(place.translation.x - x, place.translation.y - y), 0.05)
        self.assertAlmostEqual(2.0 * math.atan2(place.rotation.z, place.rotation.w), 1.7, delta=0.009)

        def told():
            return [pair.value for _, array in list(diagnostics.items) for status in array.status
                    for pair in status.values if pair.key == 'right']
        expected = ('parts of its map and of another lead', 'overlap')
        self.assertTrue(wait_for(lambda: any(all(words in text for words in expected) for text in told())), told())


class RefusesToStart(unittest.TestCase):
    def test_with_a_list_that_makes_no_sense(self):
        rospy.set_param('/bad_merger/robots', [{'name': 'one'}, {'name': 'one'}, {'name': 'no robot'}])
        code, said = Node('map_merger', '__name:=bad_merger').finish(30.0)
        self.assertNotEqual(code, 0)
        self.assertIn("'one' is there twice", said)
        self.assertIn('no robot', said)


class All(unittest.TestSuite):
    def __init__(self):
        load = unittest.TestLoader().loadTestsFromTestCase
        super().__init__([load(MapMerger), load(UnknownStarts), load(RefusesToStart)])


if __name__ == '__main__':
    rospy.init_node('map_merger_test')
    rostest.rosrun('frontier_pilot', 'map_merger', 'map_merger.All')
