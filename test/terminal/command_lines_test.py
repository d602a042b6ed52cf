#!/usr/bin/env python3
"""Every program answers --help, and says what is wrong with an argument, in a world without a ROS master.

Usage: command_lines_test.py BUILD, the folder of a build; it has to be sourced.
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / 'build'
# Scripts without a command line of their own: they are imported.
MODULES = {'bag_drive.py', 'bag_topics.py', 'command_line.py', 'readable_bag.py', 'ros_program.py'}


def call(program, *words, master='http://127.0.0.1:9'):
    """The exit code, and what was printed on stdout and on stderr."""
    environment = dict(os.environ, ROS_MASTER_URI=master, ROS_IP='127.0.0.1', QT_QPA_PLATFORM='offscreen')
    done = subprocess.run([str(program), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment, timeout=60,
                          stdin=subprocess.DEVNULL, universal_newlines=True)
    return done.returncode, done.stdout, done.stderr


def installed():
    """The nodes and scripts that rosrun finds."""
    return sorted(path for path in (BUILD / 'devel/lib/frontier_pilot').iterdir() if os.access(path, os.X_OK) and path.is_file()
                  and not path.name.endswith('_test') and path.name not in MODULES)


def benchmarks():
    programs = [BUILD / 'bin' / path.stem for path in sorted((ROOT / 'bench').glob('*.cpp'))]
    return [path for path in programs if path.exists()] + sorted((ROOT / 'bench').glob('*.py'))


def scripts():
    return sorted(path for path in (ROOT / 'scripts').iterdir() if path.is_file() and os.access(path, os.X_OK))


def rows_of_nodes():
    """The names of topics, services and actions of each node in the table of docs/nodes.md."""
    table = (ROOT / 'docs/nodes.md').read_text().split('\n## Nodes\n')[1].split('\n## ')[0]
    for row in re.findall(r'^\| (`.*?)\|(.*)\|$', table, re.MULTILINE):
        names = [name for name in re.findall(r'`([^`]+)`', row[1]) if re.match(r'/?[a-z][a-z0-9_/]*$', name)]
        for node in re.findall(r'`(\w+)`', row[0]):
            yield node, names


class CommandLines(unittest.TestCase):
    def test_help_is_printed_without_a_master(self):
        for program in installed() + benchmarks() + scripts():
            for word in ('--help', '-h'):
                with self.subTest(program=program.name, word=word):
                    code, out, err = call(program, word)
                    self.assertEqual((code, err), (0, ''))
                    self.assertRegex(out, r'(?m)^\s*[Uu]sage: .*' + re.escape(program.name.split('.')[0]))

    # [FLT-1]
    def test_a_name_or_a_master_that_cannot_be_one_ends_a_node_with_the_reason(self):
        for name in ('mapper', 'cmd_vel_arbiter', 'patrol_client', 'check_robot'):
            node = BUILD / 'devel/lib/frontier_pilot' / name
            words = ['square'] if name == 'patrol_client' else []
            with self.subTest(program=name):
                for word in ('__name:=9', '__ns:=a b', 'scan:=9'):
                    code, _, err = call(node, *words, word)
                    self.assertEqual(code, 2, word)
                    self.assertRegex(err, '[Nn]ame')
                for master in ('nowhere', 'http://localhost:abc', 'http://localhost:0', 'http://localhost:70000', 'http://localhost:'):
                    code, _, err = call(node, *words, master=master)
                    self.assertEqual(code, 2)
                    self.assertIn('ROS_MASTER_URI is not an address', err)

    def first_words_without_a_master(self, **environment):
        """The first line of a node that waits for a master, on stdout or stderr."""
        node = subprocess.Popen([BUILD / 'devel/lib/frontier_pilot/simulator'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True, env=dict(os.environ, ROS_MASTER_URI='http://127.0.0.1:9', **environment))
        try:
            return node.stdout.readline()
        finally:
            node.kill()
            node.communicate()

    def test_a_node_says_that_it_waits_for_a_master_and_each_line_names_the_node(self):
        self.assertRegex(self.first_words_without_a_master(), r'\[ WARN\] \[[0-9.]+\] \[/simulator\]: no ROS master answers at '
                                                              r'http://127.0.0.1:9.*roscore')

    def test_a_format_of_the_users_own_is_kept(self):
        self.assertRegex(self.first_words_without_a_master(ROSCONSOLE_FORMAT='mine ${message}'), '^(\x1b.*?m)?mine no ROS master')

    # [FLT-1]
    def test_words_for_ros_that_it_cannot_use_are_named_in_one_line(self):
        of_python = ['_x:={', '__name:=a b', 'scan:=9x', 'scan:=', 'scan:=/']
        for name, more in (('run_recorder', of_python), ('bag_player.py', of_python), ('watch_exploration.py', []), ('simulator', []), ('check_robot', [])):
            program = BUILD / 'devel/lib/frontier_pilot' / name
            for word in ['__master:=nowhere', '__master:=http://', '__master:='] + more:
                with self.subTest(program=name, word=word):
                    code, out, err = call(program, word)
                    self.assertEqual(code, 2)
                    self.assertRegex(out + err, re.escape(word) + ' is not|is not an address')
                    self.assertLess(len((out + err).splitlines()), 4, out + err)
            self.assertIn('ROS_MASTER_URI is not an address', call(program, master='nowhere')[2])

    # [FLT-1]
    def test_a_remapping_to_nothing_ends_a_node_with_the_reason(self):
        for name in ('simulator', 'mapper', 'check_robot', 'teleop_gui'):
            with self.subTest(program=name):
                for word in ('map:=/', 'map:=///', 'map:='):
                    code, _, err = call(BUILD / 'devel/lib/frontier_pilot' / name, word)
                    self.assertEqual(code, 2)
                    self.assertIn(word + ' is not a remapping', err)

    # Qt reads any file as a style sheet, and crashes on one that has no end.
    def test_the_window_does_not_take_a_style_sheet(self):
        code, _, err = call(BUILD / 'devel/lib/frontier_pilot/teleop_gui', '-stylesheet', '/dev/zero')
        self.assertEqual(code, 2)
        self.assertIn('-stylesheet', err)

    def test_a_program_says_that_its_output_cannot_be_written_in_one_line(self):
        buffered = {name: value for name, value in os.environ.items() if name != 'PYTHONUNBUFFERED'}
        for name in ('run_recorder', 'bag_player.py', 'robots_launcher.py', 'fitted_rviz.py', 'watch_exploration.py', 'report', 'map_log', 'mapper',
                     'check_robot', 'patrol_client', 'teleop_gui'):
            with self.subTest(program=name), open('/dev/full', 'w') as full:
                done = subprocess.run([str(BUILD / 'devel/lib/frontier_pilot' / name), '--help'], stdout=full, stderr=subprocess.PIPE,
                                      timeout=60, stdin=subprocess.DEVNULL, universal_newlines=True)
                self.assertEqual((done.returncode, done.stderr), (1, '%s: cannot write its output: No space left on device\n' % name))
                done = subprocess.run([str(BUILD / 'devel/lib/frontier_pilot' / name), '--help'], stdout=full, stderr=full, timeout=60,
                                      stdin=subprocess.DEVNULL, env=buffered)
                self.assertEqual(done.returncode, 1)

    def test_a_python_program_answers_help_also_with_closed_streams(self):
        for name in ('run_recorder', 'bag_player.py', 'robots_launcher.py', 'fitted_rviz.py', 'watch_exploration.py', 'report'):
            for closed in (0, 1):
                with self.subTest(program=name, closed=closed):
                    done = subprocess.run([str(BUILD / 'devel/lib/frontier_pilot' / name), '--help'], stderr=subprocess.PIPE, timeout=60,
                                          preexec_fn=lambda: os.close(closed), stdout=subprocess.DEVNULL, universal_newlines=True)
                    self.assertEqual((done.returncode, done.stderr), (0, ''))

    def test_map_log_makes_a_map_also_if_all_its_streams_are_closed(self):
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, 'drive.log')
            with open(log, 'w') as file:
                for i in range(20):
                    file.write('FLASER 3 2.0 2.0 2.0 %.1f 0 0 %.1f 0 0 %d host %d\n' % (0.1 * i, 0.1 * i, i, i))
            done = subprocess.run([str(BUILD / 'devel/lib/frontier_pilot/map_log'), log, '--out', os.path.join(folder, 'map')],
                                  preexec_fn=lambda: os.closerange(0, 3), timeout=60)
            self.assertEqual(done.returncode, 0)
            self.assertTrue(os.path.exists(os.path.join(folder, 'map.yaml')))

    def test_a_python_node_waits_for_a_master_also_if_nothing_can_be_said(self):
        environment = dict(os.environ, ROS_MASTER_URI='http://127.0.0.1:9', ROS_IP='127.0.0.1')
        with open('/dev/full', 'w') as full:
            nodes = [subprocess.Popen([str(BUILD / 'devel/lib/frontier_pilot' / name)], stdout=full, stderr=full, env=environment,
                                      stdin=subprocess.DEVNULL) for name in ('run_recorder', 'bag_player.py', 'watch_exploration.py')]
        time.sleep(8.0)
        for node in nodes:
            self.assertIsNone(node.poll(), node.args)
            node.kill()
            node.wait()

    def test_help_of_a_node_has_an_example(self):
        for program in installed():
            with self.subTest(program=program.name):
                self.assertRegex(call(program, '--help')[1], r'(?im)^example')

    def test_help_names_the_topics_services_and_actions_in_the_table_of_nodes(self):
        nodes = {path.name for path in installed()}
        rows = list(rows_of_nodes())
        self.assertGreater(len(rows), 8)
        for node, names in rows:
            self.assertIn(node, nodes)
            words = set(call(BUILD / 'devel/lib/frontier_pilot' / node, '--help')[1].split())
            if node == 'patrol_client':  # it shares a row with its server
                names = ['turtlebot3']
            for name in names:
                with self.subTest(node=node, name=name):
                    self.assertIn(name, words)

    def test_a_wrong_argument_is_named_in_one_line(self):
        for program in installed() + benchmarks() + scripts():
            with self.subTest(program=program.name):
                code, out, err = call(program, '--nonsense')
                self.assertEqual((code, out), (2, ''), err)
                self.assertIn('--nonsense', err)
                self.assertEqual(err.strip().count('\n'), 0, err)

    def test_the_launch_files_of_the_simulation_need_no_argument(self):
        for name in ('system', 'simulator'):
            words = call('/usr/bin/roslaunch', 'frontier_pilot', name + '.launch', '--ros-args')[1]
            self.assertIn('Optional Arguments', words)
            self.assertNotIn('Required Arguments', words)
            self.assertIn('yaw (default "auto")', words)

    def test_runs_that_end_in_the_same_second_save_their_maps_under_different_names(self):
        sys.path.insert(0, str(ROOT / 'scripts'))
        import saved_maps
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(saved_maps, 'datetime') as clock:
            clock.datetime.now.return_value.strftime.return_value = 'now'
            before = os.getcwd()
            self.addCleanup(os.chdir, before)
            os.chdir(folder)
            self.assertEqual([os.path.basename(saved_maps.default_prefix()) for _ in range(3)], ['now', 'now_1', 'now_2'])
            os.chdir(before)

    def test_an_interrupt_while_a_program_is_loaded_prints_no_traceback(self):
        for program in ('run_recorder', 'bag_player.py', 'robots_launcher.py', 'watch_exploration.py'):
            with self.subTest(program=program), tempfile.TemporaryDirectory() as slow:
                for module in ('rospy', 'rosgraph'):  # one of them is the first that takes its time
                    pathlib.Path(slow, module + '.py').write_text("import time\nprint('loads', flush=True)\ntime.sleep(20)\n")
                path = slow + ':' + os.environ.get('PYTHONPATH', '')
                # A shell starts what runs in its background with SIGINT ignored.
                started = subprocess.Popen([str(BUILD / 'devel/lib/frontier_pilot' / program)], text=True, stdin=subprocess.DEVNULL,
                                           env=dict(os.environ, PYTHONPATH=path), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                           preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
                self.addCleanup(started.kill)
                self.assertEqual(started.stdout.readline(), 'loads\n')
                started.send_signal(signal.SIGINT)
                _, err = started.communicate(timeout=10.0)
                self.assertEqual((started.returncode, err), (-signal.SIGINT, ''))

    def test_remappings_parameters_and_names_are_no_wrong_arguments(self):
        for program in installed():
            with self.subTest(program=program.name):
                words = ('scan:=/lidar', '_some_parameter:=1', '__name:=other', '__log:=/tmp/other.log')
                self.assertEqual(call(program, *words, '--help')[0], 0)
                self.assertIn('--nonsense', call(program, *words, '--nonsense')[2])


if __name__ == '__main__':
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
