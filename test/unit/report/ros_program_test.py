#!/usr/bin/env python3
"""Words of the command line that are for ROS, as the Python programs check them."""
import io
import socket
import unittest
from unittest import mock

import folder_case  # noqa: F401: finds the scripts
from command_line import exit_with
from ros_program import init_node, problem_of


class Words(unittest.TestCase):
    # [FLT-1]
    def test_a_value_that_no_parameter_can_have_is_named(self):
        for value in ('2026-11-27', '20261127101010', '[null]', '{1: 2}', '&a [*a, *a]', '"\\ud800"', '"\\u0001"'):
            with self.subTest(value=value):
                self.assertRegex(problem_of('_bag:=' + value), 'cannot be a parameter')
        self.assertRegex(problem_of('_bag:={'), 'is not YAML')
        self.assertRegex(problem_of('_bag:=a:=b'), 'holds := twice')

    def test_what_a_parameter_can_be_is_no_problem(self):
        for value in ('', '/a/b.bag', '5', '2.5', 'true', '[1, 2]', '{a: 1}', '"2026-11-27"', 'K\u00fcche'):
            with self.subTest(value=value):
                self.assertEqual(problem_of('_bag:=' + value), '')


class Masters(unittest.TestCase):
    # [FLT-1]
    def test_a_master_that_ends_meanwhile_is_said_in_one_line(self):
        said = io.StringIO()
        with mock.patch('sys.stderr', said), self.assertRaises(SystemExit) as end:
            exit_with(lambda: socket.create_connection(('127.0.0.1', 9)))
        self.assertEqual(end.exception.code, 1)
        self.assertRegex(said.getvalue(), '^[^\n]*: the ROS master has ended\n$')

    # [FLT-1]
    def test_a_master_that_refuses_the_node_is_said_in_one_line(self):
        said = io.StringIO()
        with mock.patch('sys.stderr', said), mock.patch('rospy.init_node', side_effect=ValueError('a\nb')), \
                self.assertRaises(SystemExit) as end:
            init_node('player', {})
        self.assertEqual(end.exception.code, 1)
        self.assertEqual(said.getvalue(), 'player: cannot be a node of the ROS master: a\\nb\n')


if __name__ == '__main__':
    unittest.main()
