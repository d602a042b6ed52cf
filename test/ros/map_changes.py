#!/usr/bin/env python3
"""Maps in few bytes on the wire: who reads and who publishes `map_changes`, and who falls back on `map`. [MUL-1]"""
import unittest
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
import rostest
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid

from frontier_pilot.msg import MapChanges
from map_changes_code import Copy, changes_of
from wire import Node, Record, wait_for

SIDE = 100  # [cells]


def empty_map():
    grid = OccupancyGrid()
    grid.header.frame_id, grid.header.stamp = 'only/map', rospy.Time.now()
    grid.info.resolution, grid.info.width, grid.info.height = 0.05, SIDE, SIDE
    grid.info.origin.orientation.w = 1.0
    grid.data = [0] * SIDE * SIDE
    return grid


class Greeter(rospy.SubscribeListener):
    """Counts new subscribers of `map_changes`, and sends each of them the whole map."""

    def __init__(self, mapper):
        self.mapper, self.count = mapper, 0

    def peer_subscribe(self, topic_name, topic_publish, peer_publish):
        self.count += 1
        peer_publish(changes_of(self.mapper.grid, self.mapper.sequence))


class Mapper:
    """A mapper that offers its map by all topics."""

    def __init__(self):
        self.grid, self.sequence = empty_map(), 1
        self.greeter = Greeter(self)
        self.changes = rospy.Publisher('only/map_changes', MapChanges, subscriber_listener=self.greeter, queue_size=10)
        self.maps = rospy.Publisher('only/map', OccupancyGrid, queue_size=1, latch=True)
        self.updates = rospy.Publisher('only/map_updates', OccupancyGridUpdate, queue_size=10)
        self.maps.publish(self.grid)

    def build_a_wall(self, x, lose=False):
        """Five cells in the middle of the map; `lose`: nobody is told."""
        cells = list(self.grid.data)
        for row in range(50, 55):
            cells[row * SIDE + x] = 100
        self.grid.data = cells
        self.sequence += 1
        if not lose:
            self.changes.publish(changes_of(self.grid, self.sequence, [(x, 50, 1, 5)]))

    def end(self):
        for publisher in (self.changes, self.maps, self.updates):
            publisher.unregister()


class MapChangesOnTheWire(unittest.TestCase):
    def setUp(self):
        rospy.set_param('/map_merger/robots', [{'name': 'only'}])
        self.mapper = Mapper()
        self.record = Record('/only/merged_map_changes', MapChanges)
        self.node = Node('map_merger')
        self.addCleanup(self.end)
        self.assertTrue(wait_for(self.reads_changes_alone, 30.0), self.node.said())

    def end(self):
        self.mapper.end()
        self.node.end()
        self.record.subscriber.unregister()

    def reads_changes_alone(self):
        counts = [topic.get_num_connections() for topic in (self.mapper.changes, self.mapper.maps, self.mapper.updates)]
        return counts == [1, 0, 0]

    def has_wall(self, x):
        """Whether a subscriber of the view's changes knows a wall at this column of the robot's map."""
        copy = Copy()
        for _, message in list(self.record.items):
            copy.take(message)
        if copy.info is None:
            return False
        column = x + round(-copy.info.origin.position.x / 0.05)
        row = 52 + round(-copy.info.origin.position.y / 0.05)
        return copy.cells[row * copy.info.width + column] == 100

    def test_a_change_passes_through_in_a_few_hundred_bytes(self):
        self.assertTrue(wait_for(lambda: self.record.last is not None and self.record.last.whole))
        self.mapper.build_a_wall(20)
        self.assertTrue(wait_for(lambda: self.has_wall(20)))
        self.assertFalse(self.record.last.whole)
        self.assertLess(len(self.record.last.runs), 100)

    def test_the_changes_are_the_map(self):
        for x in (10, 30, 70):
            self.mapper.build_a_wall(x)
            self.assertTrue(wait_for(lambda: self.has_wall(x)))
        view = Record('/only/merged_map', OccupancyGrid)
        self.addCleanup(view.subscriber.unregister)
        copy = Copy()
        for _, message in list(self.record.items):
            copy.take(message)
        self.assertTrue(wait_for(lambda: view.last is not None and list(view.last.data) == copy.cells, 20.0))

    def test_a_new_subscriber_is_sent_the_whole_map(self):
        self.mapper.build_a_wall(40)
        self.assertTrue(wait_for(lambda: self.has_wall(40)))
        self.record.subscriber.unregister()
        self.record = Record('/only/merged_map_changes', MapChanges)
        self.assertTrue(wait_for(lambda: self.has_wall(40)))

    def test_the_map_is_asked_for_again_when_a_message_was_lost(self):
        """[FLT-1]"""
        before = self.mapper.greeter.count
        self.mapper.build_a_wall(20, lose=True)
        self.mapper.build_a_wall(60)
        self.assertTrue(wait_for(lambda: self.has_wall(60)))
        self.assertTrue(wait_for(lambda: self.has_wall(20), 20.0), self.node.said())
        self.assertEqual(self.mapper.greeter.count, before + 1)
        self.assertTrue(wait_for(self.reads_changes_alone))

    def test_a_foreign_mapper_that_takes_its_place_is_read_by_its_map(self):
        self.mapper.end()
        grid = empty_map()
        cells = list(grid.data)
        cells[52 * SIDE + 80] = 100
        grid.data = cells
        foreign = rospy.Publisher('only/map', OccupancyGrid, queue_size=1, latch=True)
        self.addCleanup(foreign.unregister)
        foreign.publish(grid)
        self.assertTrue(wait_for(lambda: self.has_wall(80), 20.0), self.node.said())

    def test_a_map_that_came_before_the_end_of_the_changes_is_asked_for_again(self):
        """The master's list of publishers may be known earlier than the master's word to the subscriber."""
        master = rosgraph.Master(rospy.get_name())
        merger = ServerProxy(master.lookupNode('/map_merger'))
        master.unregisterPublisher('/only/map_changes', rospy.get_node_uri())
        self.assertTrue(wait_for(lambda: self.mapper.changes.get_num_connections() == 0))
        merger.publisherUpdate('/master', '/only/map_changes', [rospy.get_node_uri()])
        self.assertTrue(wait_for(lambda: self.mapper.greeter.count == 2))
        self.mapper.build_a_wall(80, lose=True)
        self.mapper.maps.publish(self.mapper.grid)
        self.assertTrue(wait_for(lambda: self.mapper.maps.get_num_connections() == 1, 20.0), self.node.said())
        rospy.sleep(1.0)  # the latched map is sent, and left aside
        merger.publisherUpdate('/master', '/only/map_changes', [])
        self.assertTrue(wait_for(lambda: self.has_wall(80), 20.0), self.node.said())

    def test_malformed_changes_are_refused_and_the_map_stays(self):
        """[FLT-1]"""
        self.mapper.build_a_wall(20)
        self.assertTrue(wait_for(lambda: self.has_wall(20)))
        count = len(self.record.items)
        for runs in (b'', b'\x3f\xff\xff\xff\xff', b'\xc0\x80', b'\xff' * 100000):
            message = changes_of(self.mapper.grid, self.mapper.sequence)
            message.runs = runs
            self.mapper.changes.publish(message)
        self.mapper.build_a_wall(60)
        self.assertTrue(wait_for(lambda: self.has_wall(60)), self.node.said())
        self.assertTrue(self.has_wall(20))
        self.assertFalse(any(message.whole for _, message in self.record.items[count:]), 'the view is the same size')


if __name__ == '__main__':
    rospy.init_node('map_changes_test')
    rostest.rosrun('frontier_pilot', 'map_changes', MapChangesOnTheWire)
