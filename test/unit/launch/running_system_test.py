#!/usr/bin/env python3
"""Whether something already runs at a ROS master, as scripts/run asks before it launches."""
import pathlib
import socket
import sys
import threading
import time
import unittest
import xmlrpc.server
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'scripts'))
import running_system  # noqa: E402


class Masters(unittest.TestCase):
    def problem_of(self, *publishers, answer=None):
        """What is said of a master that lists these topics and their publishers."""
        with xmlrpc.server.SimpleXMLRPCServer(('127.0.0.1', 0), logRequests=False, allow_none=True) as server:
            server.register_function(lambda _: answer or [1, 'current system state', [publishers, [], []]], 'getSystemState')
            threading.Thread(target=server.handle_request, daemon=True).start()
            return running_system.problem_at('http://127.0.0.1:%d' % server.server_address[1])

    def test_a_robot_or_a_simulation_is_named_with_what_to_do(self):
        """[FLT-1]"""
        for topic in ('/clock', '/map', '/odom', '/scan', '/robot1/scan', '/a/b/map'):
            with self.subTest(topic=topic):
                said = self.problem_of(['/rosout_agg', ['/rosout']], [topic, ['/base']])
                self.assertRegex(said, '^/base publishes %s at the ROS master http://127.0.0.1:[0-9]+, .* ROS_MASTER_URI=' % topic)
                self.assertNotIn('\n', said)

    def test_a_roscore_rviz_and_rqt_are_no_reason(self):
        self.assertEqual(self.problem_of(['/rosout_agg', ['/rosout']], ['/initialpose', ['/rviz']], ['/map_updates', ['/rqt']],
                                         ['/scan', []], ['/bitmap', ['/rqt']]), '')

    def test_where_nothing_or_no_master_answers_roslaunch_finds_out_itself(self):
        with socket.socket() as probe:
            probe.bind(('127.0.0.1', 0))
            self.assertEqual(running_system.problem_at('http://127.0.0.1:%d' % probe.getsockname()[1]), '')
        for uri in ('nonsense', '', 'http://', 'ftp://127.0.0.1:1', 'http://no.such.host.invalid:1'):
            self.assertEqual(running_system.problem_at(uri), '', uri)
        for answer in ([1, 'state', 5], 'text', [1, 'state', [[5]]]):
            self.assertEqual(self.problem_of(answer=answer), '', answer)

    def test_a_master_that_hangs_holds_nobody_up_and_is_not_joined(self):
        """[FLT-1]"""
        with socket.create_server(('127.0.0.1', 0)) as server, mock.patch.object(running_system, 'PATIENCE', 0.3):
            began = time.monotonic()
            said = running_system.problem_at('http://127.0.0.1:%d' % server.getsockname()[1])
            self.assertLess(time.monotonic() - began, 5.0)
            self.assertIn('does not answer', said)

    def test_names_are_printed_without_control_characters(self):
        said = self.problem_of(['/a\x7f/map', ['/x' * 1000]])
        self.assertTrue(said.isprintable())
        self.assertLess(len(said), 700)


if __name__ == '__main__':
    unittest.main()
