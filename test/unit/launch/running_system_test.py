#!/usr/bin/env python3
"""Whether something already runs at a ROS master, as scripts/run asks before it launches."""
import contextlib
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import xmlrpc.server
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'scripts'))
import running_system  # noqa: E402


@contextlib.contextmanager
def master_that_lists(*publishers, subscribers=(), types=(), answer=None):
    """The address of a master that lists these topics with their publishers, subscribers and types, or answers something else."""
    with xmlrpc.server.SimpleXMLRPCServer(('127.0.0.1', 0), logRequests=False, allow_none=True) as server:
        server.register_function(lambda _: answer or [1, 'current system state', [publishers, subscribers, []]], 'getSystemState')
        server.register_function(lambda _: [1, 'current topics', types], 'getTopicTypes')
        threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True).start()
        try:
            yield 'http://127.0.0.1:%d' % server.server_address[1]
        finally:
            server.shutdown()


class Masters(unittest.TestCase):
    def problem_of(self, *publishers, **listed):
        """What is said of a master that lists this."""
        with master_that_lists(*publishers, **listed) as uri:
            return running_system.problem_at(uri)

    def test_a_robot_or_a_simulation_is_named_with_what_to_do(self):
        """[FLT-1]"""
        for topic in ('/clock', '/map', '/odom', '/scan', '/robot1/scan', '/a/b/map'):
            with self.subTest(topic=topic):
                said = self.problem_of(['/rosout_agg', ['/rosout']], [topic, ['/base']])
                self.assertRegex(said, '^/base publishes %s at the ROS master http://127.0.0.1:[0-9]+, .* ROS_MASTER_URI=' % topic)
                self.assertNotIn('\n', said)

    def test_a_robot_whose_topics_have_other_names_is_known_by_their_types(self):
        """[FLT-1]"""
        for topic, kind in (('/base_scan', 'sensor_msgs/LaserScan'), ('/odometry/filtered', 'nav_msgs/Odometry')):
            with self.subTest(topic=topic):
                said = self.problem_of(['/points', ['/lidar']], [topic, ['/driver']],
                                       types=[['/points', 'sensor_msgs/PointCloud2'], [topic, kind]])
                self.assertRegex(said, '^/driver publishes %s at the ROS master ' % topic)

    def test_a_base_is_known_by_the_commands_that_it_listens_to(self):
        """[FLT-1]"""
        for topic in ('/cmd_vel', '/robot1/cmd_vel'):
            with self.subTest(topic=topic):
                said = self.problem_of(['/tf', ['/base']], subscribers=[[topic, ['/rostopic_1_2', '/base']]])
                self.assertRegex(said, '^/base listens to %s at the ROS master ' % topic)
        self.assertEqual(self.problem_of(subscribers=[['/cmd_vel', ['/rostopic_1_2', '/rqt_plot']], ['/cmd', ['/a']]]), '')

    def test_a_window_of_the_operator_that_shows_the_commands_is_no_base(self):
        for window in ('/teleop_gui', '/robot1/teleop_gui', '/rviz', '/x/rviz', '/x/rviz_1700000000'):
            with self.subTest(window=window):
                self.assertEqual(self.problem_of(subscribers=[['/cmd_vel', [window]]]), '')
        self.assertIn('/rviz/base listens', self.problem_of(subscribers=[['/cmd_vel', ['/teleop_gui', '/rviz/base']]]))

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


class ImagesCommand(unittest.TestCase):
    """What a container of the image runs if no command is given, with the files where the image has them."""

    def command_at(self, *publishers):
        with tempfile.TemporaryDirectory() as folder, master_that_lists(*publishers) as uri:
            for path in ('docker/explore', 'scripts/running_system.py', 'scripts/command_line.py'):
                shutil.copy(ROOT / path, folder)
            launcher = pathlib.Path(folder) / 'roslaunch'
            launcher.write_text('#!/bin/sh\necho launched "$@"\n')
            launcher.chmod(0o755)
            environment = dict(os.environ, ROS_MASTER_URI=uri, PATH=folder + ':/usr/bin:/bin')
            return subprocess.run([folder + '/explore'], env=environment, capture_output=True, text=True, timeout=60)

    def test_it_simulates_only_where_no_robot_runs(self):
        """[FLT-1]"""
        done = self.command_at(['/rosout_agg', ['/rosout']])
        self.assertEqual((done.returncode, done.stderr), (0, ''))
        self.assertRegex(done.stdout, '^launched frontier_pilot system.launch explore:=true')
        done = self.command_at(['/scan', ['/lidar']])
        self.assertEqual((done.returncode, done.stdout), (1, ''))
        self.assertRegex(done.stderr, '^explore: /lidar publishes /scan at the ROS master ')

    def test_the_image_holds_what_it_needs(self):
        recipe = (ROOT / 'Dockerfile').read_text()
        self.assertIn('COPY docker/entry_point docker/explore scripts/running_system.py scripts/command_line.py /usr/local/bin/', recipe)
        self.assertIn('CMD ["explore"]', recipe)


if __name__ == '__main__':
    unittest.main()
