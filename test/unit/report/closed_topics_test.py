#!/usr/bin/env python3
"""rosnode kill closes the topics of a node that is about to publish, before rospy.is_shutdown says so."""
import unittest
from unittest import mock

import rospy

import folder_case  # noqa: F401: finds the scripts
import bag_player
from run_recorder_test import load


def closed_topic():
    return mock.Mock(**{'publish.side_effect': rospy.ROSException('publish() to a closed topic')})


class ClosedTopics(unittest.TestCase):
    def setUp(self):
        for name, value in (('rospy.Time.now', rospy.Time(5)), ('rospy.get_name', '/node'), ('rospy.get_namespace', '/')):
            patch = mock.patch(name, return_value=value)
            patch.start()
            self.addCleanup(patch.stop)

    def while_shutting_down(self, asked):
        return mock.patch('rospy.core.is_shutdown_requested', return_value=asked)

    def player(self):
        player = bag_player.Player.__new__(bag_player.Player)
        player.now, player.clock, player.tf_static = 3.0, closed_topic(), closed_topic()
        player.drive = mock.Mock(fixed={})
        return player

    def recorder(self):
        program = load()
        recorder = program.RunRecorder.__new__(program.RunRecorder)
        recorder.registration, recorder.nodes, recorder.meter = mock.MagicMock(), mock.MagicMock(), mock.MagicMock()
        recorder.registration.keep.return_value = False
        recorder.nodes.master.getParam.return_value = {}
        recorder.info, recorder.load, recorder.diagnostics = closed_topic(), closed_topic(), closed_topic()
        recorder.run, recorder.names, recorder.parameters, recorder.problem = '/', {}, {'robot': ''}, ''
        recorder.writer = mock.Mock(**{'problem.return_value': '', 'size.return_value': 1e6})
        return program, recorder

    def test_a_player_that_is_killed_ends_without_an_error(self):
        """[FLT-1]"""
        with self.while_shutting_down(True):
            self.player().tick(0.1)
            with mock.patch('rospy.is_shutdown', return_value=True), mock.patch('rospy.logwarn'):
                self.player().await_mapper()

    def test_a_recorder_that_is_killed_ends_the_record_all_the_same(self):
        """[FLT-1] [REC-1]"""
        program, recorder = self.recorder()
        with self.while_shutting_down(True), mock.patch.object(program, 'GOODBYE', 0.0), \
                mock.patch.object(program.runs, 'parts_of', return_value=['run_0.bag']), mock.patch.object(program, 'say') as said:
            recorder.look()
            recorder.end()
        recorder.writer.end.assert_called_once_with()
        said.assert_called_once_with('run_recorder: recorded 1.0 MB in /')

    def test_a_topic_that_is_closed_while_the_node_lives_is_an_error(self):
        with self.while_shutting_down(False), self.assertRaises(rospy.ROSException):
            self.player().tick(0.1)


if __name__ == '__main__':
    unittest.main()
