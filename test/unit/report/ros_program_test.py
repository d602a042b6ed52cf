#!/usr/bin/env python3
"""Words of the command line that are for ROS, as the Python programs check them."""
import contextlib
import io
import itertools
import os
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest
from unittest import mock

import folder_case  # noqa: F401: finds the scripts
from command_line import exit_with
import ros_program
from ros_program import init_node, note_interrupts, problem_of


class Output(unittest.TestCase):
    # [FLT-1]
    def test_a_letter_that_it_cannot_take_is_printed_by_its_number(self):
        words = 'from command_line import say; say("Map saved: K\\u00fcche \\udcff")'
        for encoding, printed in (('ascii', b'Map saved: K\\xfcche \\udcff\n'), ('utf-8', b'Map saved: K\xc3\xbcche \xff\n')):
            with self.subTest(encoding=encoding):
                done = subprocess.run([sys.executable, '-c', words], timeout=60, capture_output=True,
                                      env=dict(os.environ, PYTHONIOENCODING=encoding, PYTHONPATH=os.pathsep.join(sys.path)))
                self.assertEqual((done.returncode, done.stdout), (0, printed), done.stderr)


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
            init_node('player', {}, [])
        self.assertEqual(end.exception.code, 1)
        self.assertEqual(said.getvalue(), 'player: cannot be a node of the ROS master: a\\nb\n')


class HangingMasters(unittest.TestCase):
    def setUp(self):
        listener = socket.create_server(('127.0.0.1', 0))  # which takes connections, and never answers
        self.addCleanup(listener.close)
        environment = {'ROS_MASTER_URI': 'http://127.0.0.1:%d' % listener.getsockname()[1]}
        for patch in (mock.patch.dict(os.environ, environment), mock.patch('ros_program.PATIENCE', 0.2)):
            patch.start()
            self.addCleanup(patch.stop)

    # [FLT-1]
    def test_an_answer_is_not_waited_for_for_ever(self):
        with self.assertRaises(ros_program.FAILURES):
            ros_program.master('/test').getSystemState()

    # [FLT-1]
    def test_no_node_is_known_to_live(self):
        self.assertFalse(ros_program.lives('/test'))

    # [FLT-1]
    def test_a_program_that_waits_for_one_says_so_and_ends_when_it_is_not_wanted_any_more(self):
        looks, said = itertools.chain((True, True), itertools.repeat(False)), io.StringIO()
        with mock.patch.object(sys, 'argv', ['player']), mock.patch('ros_program.POLL', 0.0), contextlib.redirect_stderr(said):
            self.assertFalse(ros_program.begin('player', wanted=lambda: next(looks)))
        self.assertIn('player: no ROS master answers at http://127.0.0.1:', said.getvalue())

    # [FLT-1]
    def test_leaving_ros_is_not_waited_for_for_ever(self):
        goes_on = threading.Event()
        self.addCleanup(goes_on.set)
        with mock.patch('rospy.signal_shutdown', side_effect=lambda _: goes_on.wait()), mock.patch('os._exit') as end, \
                mock.patch('ros_program.GOODBYE', 0.1):
            ros_program.leave(3)
        end.assert_called_once_with(3)

    # [FLT-1]
    def test_a_master_that_answers_is_left_as_ever(self):
        with mock.patch('rospy.signal_shutdown') as shutdown, mock.patch('os._exit') as end:
            self.assertEqual(ros_program.leave(3), 3)
        shutdown.assert_called_once_with('ended')
        end.assert_not_called()


class Interrupts(unittest.TestCase):
    def ended_by(self, init):
        """The exit code of a program whose rospy.init_node is `init`."""
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        interrupts = note_interrupts()
        with mock.patch('rospy.init_node', side_effect=init), self.assertRaises(SystemExit) as end:
            init_node('player', {}, interrupts)
        return end.exception.code

    # [FLT-1]
    def test_a_ctrl_c_that_rospy_swallows_ends_the_program(self):
        def swallowing(_name):
            try:
                os.kill(os.getpid(), signal.SIGINT)
                time.sleep(1.0)
            except KeyboardInterrupt:
                pass

        self.assertEqual(self.ended_by(swallowing), 130)

    # [FLT-1]
    def test_a_ctrl_c_that_makes_rospy_fail_is_no_failure(self):
        def failing(_name):
            try:
                os.kill(os.getpid(), signal.SIGINT)
                time.sleep(1.0)
            except KeyboardInterrupt:
                raise ValueError('init_node interrupted before it could complete')

        self.assertEqual(self.ended_by(failing), 130)


class Exceptions(unittest.TestCase):
    # [FLT-1]
    def test_an_exception_that_nobody_expects_is_said_in_one_line(self):
        said = io.StringIO()
        with mock.patch('sys.stderr', said), self.assertRaises(SystemExit) as end:
            exit_with(lambda: {}['a\nb'])
        self.assertEqual(end.exception.code, 1)
        self.assertRegex(said.getvalue(), '^[^\n]*: failed with KeyError: [^\n]*FRONTIER_PILOT_TRACEBACK[^\n]*\n$')


if __name__ == '__main__':
    unittest.main()
