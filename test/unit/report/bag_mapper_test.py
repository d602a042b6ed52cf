#!/usr/bin/env python3
"""The player of a recorded drive knows whether the mapper hears it."""
import unittest
from unittest import mock

import folder_case  # noqa: F401: finds the scripts
import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

import bag_mapper


class Connections:
    """Of a publisher, by the names of the nodes that hear it."""

    def __init__(self, nodes):
        self.nodes = nodes

    @property
    def connections(self):
        return [mock.Mock(endpoint_id=node) for node in self.nodes]

    def has_connection(self, node):
        return node in self.nodes

    def remove_connection(self, connection):
        self.nodes.remove(connection.endpoint_id)


class Mapper(unittest.TestCase):
    def setUp(self):
        self.master, self.now = mock.Mock(), 100.0
        self.master.getSystemState.return_value = [[], [], [['/dynamic_map', ['/mapper']]]]
        self.master.lookupNode.return_value = 'http://robot:1'
        for name, value in (('bag_mapper.ros_program.master', lambda _: self.master), ('bag_mapper.time.monotonic', lambda: self.now),
                            ('rospy.get_name', lambda: '/bag_player'), ('rospy.resolve_name', lambda name: '/' + name),
                            ('rospy.logwarn', mock.Mock()), ('rospy.loginfo', mock.Mock())):
            patch = mock.patch(name, value)
            patch.start()
            self.addCleanup(patch.stop)
        self.heard_by = {'clock': {'/mapper'}, 'scan': {'/mapper', '/rviz'}, 'odom': {'/mapper', '/rviz'}}
        self.played = {'scan': 0}
        publishers = [mock.Mock(impl=Connections(nodes)) for nodes in self.heard_by.values()]
        self.mapper = bag_mapper.BagMapper(self.played, *publishers)

    def listen_again(self, *topics):
        for topic in topics:
            self.heard_by[topic].add('/mapper')

    def look(self, after=1.0):
        self.now += after
        return self.mapper.is_away()

    def test_rviz_may_come_and_go(self):
        self.assertTrue(self.mapper.find())
        self.heard_by['scan'].remove('/rviz')
        self.assertFalse(self.look())

    def test_a_player_that_found_no_mapper_waits_for_none(self):
        self.master.getSystemState.return_value = [[], [], []]
        self.assertFalse(self.mapper.find())
        self.assertFalse(self.look())
        self.assertFalse(self.mapper.is_lost())

    def test_a_player_that_is_shut_down_misses_nobody(self):
        self.mapper.find()
        self.heard_by['clock'].clear()
        with mock.patch('rospy.core.is_shutdown_requested', return_value=True):
            self.assertFalse(self.look())
        rospy.logwarn.assert_not_called()
        self.assertTrue(self.look())

    def test_a_mapper_that_died_is_away_until_another_process_hears_everything(self):  # [FLT-2]
        self.mapper.find()
        self.heard_by['clock'].clear()
        self.assertTrue(self.look())
        self.played['scan'] = 7
        self.master.lookupNode.return_value = 'http://robot:2'
        self.listen_again('clock')
        self.assertTrue(self.look(), 'what is left of the connections of the dead one does not count')
        self.listen_again('scan', 'odom')
        self.assertFalse(self.look())
        self.assertEqual((self.mapper.starts, self.mapper.played_before), (1, 7))

    def test_a_mapper_that_was_only_cut_off_has_not_ended(self):
        self.mapper.find()
        self.heard_by['odom'].remove('/mapper')
        self.assertTrue(self.look())
        self.assertEqual(self.heard_by['scan'], {'/rviz'})
        self.listen_again('clock', 'scan', 'odom')
        self.assertFalse(self.look())
        self.assertEqual(self.mapper.starts, 0)
        self.mapper.say_loss()
        self.assertEqual(rospy.logwarn.call_count, 1, 'that the bag waits')

    def test_a_mapper_that_stays_away_is_lost_unless_it_may_end(self):
        self.mapper.find()
        self.heard_by['scan'].clear()
        self.assertTrue(self.look())
        self.assertFalse(self.mapper.is_lost())
        self.assertTrue(self.look(after=31.0))
        self.assertTrue(self.mapper.is_lost())
        self.mapper.leave()
        self.assertFalse(self.look())
        self.assertFalse(self.mapper.is_lost())

    def test_scans_that_were_refused_are_not_in_the_map(self):
        self.mapper.find()
        values = [KeyValue('scans, inserted', '3'), KeyValue('scans, not moved', '2'), KeyValue('scans, fits nowhere', '60')]
        other = DiagnosticStatus(name='mapper: memory', values=values)
        with mock.patch('rospy.wait_for_message', side_effect=[DiagnosticArray(status=[other]), DiagnosticArray(
                status=[other, DiagnosticStatus(name='mapper: mapping', values=values)])]):
            self.assertEqual(self.mapper.taken(), 5)
        with mock.patch('rospy.wait_for_message', side_effect=rospy.ROSException):
            self.assertIsNone(self.mapper.taken())


if __name__ == '__main__':
    unittest.main()
