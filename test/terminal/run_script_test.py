#!/usr/bin/env python3
"""scripts/run: what it refuses, what its last line says, and what it leaves behind.

Usage: run_script_test.py BUILD, the folder of a build with the nodes.
"""
import glob
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
import unittest
import xmlrpc.server
from unittest import mock

from run_of_the_script import ROOT, RUN, RunTestCase, command_of, environment, heed_ctrl_c


class RunScript(RunTestCase):
    def test_it_refuses_what_the_launch_file_does_not_have_and_says_what_there_is(self):
        pathlib.Path(self.folder.name, 'my_robot').write_text('disc_radius: 0.2\n')  # only with a / or .yaml it is a file
        for word, words in (('wrld:=x', 'world'), ('world:=nowhere.yaml', 'office'), ('world:=nowhere', 'office'), ('robot:=tank', 'waffle'), ('robot:=my_robot', 'waffle'),
                            ('limits:=slow', 'burger'), ('speed:=fast', '1 for real time'), ('gui:=yes', 'true or false'),
                            ('x:=left', 'number'), ('map:=/proc/nowhere/floor', "there is no folder '/proc/nowhere'"), ('map:=/tmp', 'is a folder'),
                            ('map:=/tmp/none/', 'is a folder'),
                            ('map:=a\tb', 'control character'), ('map:=/tmp/\udcff', 'UTF-8'), ('world:=/$(x)/a.yaml', 'substitution'),
                            ('map:=/tmp/a:=b', "must not contain ':='"), ('world:=a:=b', "must not contain ':='"),
                            ('seed:=3000000000', 'seed: must be'), ('seed:=-1', 'seed: must be'), ('seed:=' + 30 * '9', 'seed: must be'),
                            ('x:=1' + 300 * '0', 'at most nine digits'), ('speed:=1' + 300 * '0', 'at most nine digits'),
                            ('speed:=0', 'for the simulator alone'), ('speed:=0.00', 'for the simulator alone'),
                            ('map:=' + 251 * 'x', 'too long'), ('map_file:=nowhere', 'no saved map'),
                            ('localize_only:=true', 'map_file'), ('localize_only:=true map_file:=none', 'map_file'), ('office', 'unknown argument'), ('--nonsense', 'unknown argument')):
            with self.subTest(word=word):
                code, out, err = self.run_to_the_end(*word.split(' '))
                self.assertEqual((code, out), (2, ''), err)
                self.assertIn(words, err)
                self.assertEqual(err.strip().count('\n'), 0, err)

    def test_it_does_not_replace_the_world_by_the_map(self):
        """[MAP-5]"""
        drawing = pathlib.Path(self.folder.name, 'drawing.pgm')
        shutil.copy(ROOT / 'config/worlds/small.pgm', drawing)
        for picture in ('drawing.pgm\r', 'drawing.pgm  # mine', '"drawing.pgm"  # mine', str(drawing)):
            pathlib.Path(self.folder.name, 'floor.yaml').write_text('image: %s\nresolution: 0.05\norigin: [0, 0, 0]\n' % picture)
            for name in ('floor', 'floor.yaml', 'drawing', './drawing.bt'):
                with self.subTest(picture=picture, map=name):
                    code, out, err = self.run_to_the_end('world:=floor.yaml', 'map:=' + name)
                    self.assertEqual((code, out), (2, ''))
                    self.assertIn('is the world, which the map would replace', err)
        code, _, err = self.run_to_the_end('map:=%s/config/worlds/flat' % ROOT)
        self.assertEqual(code, 2)
        self.assertIn('is the world', err)

    def test_a_folder_that_was_removed_is_refused_before_anything_is_built(self):
        gone = os.path.join(self.folder.name, 'gone')
        done = subprocess.run(['bash', '-c', 'mkdir "$1" && cd "$1" && rmdir "$1" && "$2"', 'bash', gone, RUN], timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        self.assertEqual((done.returncode, done.stdout), (1, ''))
        self.assertIn('scripts/run: this folder is not there any more', done.stderr)

    def test_it_may_be_called_by_a_link(self):
        link = os.path.join(self.folder.name, 'explore')
        os.symlink(RUN, link)
        done = subprocess.run([link, 'wrld:=x'], timeout=60, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no argument 'wrld'", done.stderr)

    def test_it_refuses_too_few_open_files(self):
        process = self.start(preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (64, 64)))
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (1, ''))
        self.assertRegex(err, "^scripts/run: only 64 files may be open at once, .* 'ulimit -n 1024' allows more\n$")

    def test_surroundings_with_which_ros_cannot_work_are_refused_before_anything_is_built(self):
        unwritable = os.path.join(self.folder.name, 'old')  # where the log of a build cannot be opened
        os.makedirs(os.path.join(unwritable, 'build.log'))
        address = 'ROS_MASTER_URI is %s, which is not the address of a ROS master, such as http://localhost:11311'
        for name, value, words in (
                ('HOME', '/proc/nobody', "ROS cannot write its logs to /proc/nobody/.ros; 'export ROS_HOME=FOLDER' takes another folder"),
                ('TMPDIR', '/nowhere', "temporary files cannot be made in /nowhere; 'export TMPDIR=FOLDER' takes another folder"),
                ('FRONTIER_PILOT_BUILD', '/proc/nowhere', "nothing can be written to /proc/nowhere/build.log, in the folder of the build; "
                 "'export FRONTIER_PILOT_BUILD=FOLDER' takes another folder"),
                ('FRONTIER_PILOT_BUILD', unwritable, "nothing can be written to %s/build.log, in the folder of the build; "
                 "'export FRONTIER_PILOT_BUILD=FOLDER' takes another folder" % unwritable),
                ('ROS_MASTER_URI', 'robot', address % "'robot'"), ('ROS_MASTER_URI', 'http://robot', address % "'http://robot'"),
                ('ROS_MASTER_URI', 'http://robot:99999', address % "'http://robot:99999'"),
                ('ROS_MASTER_URI', 'http://robot:0', address % "'http://robot:0'")):
            with self.subTest(name=name, value=value):
                surroundings = environment(self.port, '')  # an empty ROS_HOME is none
                process = self.start(env=dict(surroundings, **{name: value}))
                out, err = process.communicate(timeout=60)
                self.assertEqual((process.returncode, out, err), (1, '', 'scripts/run: %s\n' % words))

    def test_a_launch_that_cannot_begin_ends_with_the_reason_and_leaves_no_master(self):
        world = pathlib.Path(self.folder.name, 'broken.yaml')
        world.write_text('image: nowhere.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n')
        generated = pathlib.Path(os.environ['FRONTIER_PILOT_BUILD'], 'CMakeFiles/TargetDirectories.txt')
        before = generated.stat().st_mtime
        slow = pathlib.Path(self.folder.name, 'slow_kill')  # what is killed has ended before the script goes on
        slow.write_text('find() { command find "$@"; return 1; }\n'  # as when a folder of another program is removed
                        'kill() { builtin kill "$@" || return; [ "$1" != -KILL ] || while builtin kill -0 "$2" 2>/dev/null; do :; done; }\n')
        with mock.patch.dict(os.environ, BASH_ENV=str(slow)):
            code, _, err = self.run_to_the_end('world:=broken.yaml')
        self.assertEqual(code, 1)
        self.assertNotIn('Killed', err)
        self.assertRegex(err.strip().split('\n')[-1], r'^scripts/run: simulator: .*nowhere\.pgm does not exist')
        self.assertEqual(generated.stat().st_mtime, before, 'it configured the build again')
        self.assert_nothing_is_left()
        silent = self.start('world:=broken.yaml', stdout=None, preexec_fn=lambda: (heed_ctrl_c(), os.close(1)))
        silent_err = silent.communicate(timeout=300)[1]
        # That the master is late on a busy computer is said as well.
        lines, silent_lines = ([line for line in said.strip().split('\n') if 'no ROS master answers' not in line]
                               for said in (err, silent_err))
        self.assertEqual((len(silent_lines), silent_lines[-1]), (len(lines), lines[-1]),
                         'with a standard output that is closed: ' + silent_err + 'instead of: ' + err)

    def test_the_reason_of_a_parameter_that_cannot_be_is_said(self):
        pathlib.Path(self.folder.name, 'damaged.yaml').write_text('image: a.pgm\noctree: {file: damaged.bt}\n')
        pathlib.Path(self.folder.name, 'robot.yaml').write_text('radius: [0.1\n')
        for word, reason in (('speed:=20000', 'simulator: .*speed: must be >= 0 and <= 10000, is 20000'),
                             ('robot:=robot.yaml', r'.*/robot\.yaml contains invalid YAML: while parsing'),
                             ('map_file:=damaged', r'mapper: .*/damaged\.bt: no such file')):
            code, _, err = self.run_to_the_end(word)
            self.assertEqual(code, 1)
            self.assertRegex(err.strip().split('\n')[-1], '^scripts/run: ' + reason)
            self.assert_nothing_is_left()

    def test_the_reason_of_surroundings_with_which_roslaunch_cannot_work_is_said(self):
        for name, value, reason in (('ROS_IP', '10.255.255.1', 'RLException: Unable to contact my own server'),
                                    ('ROS_LOG_DIR', '/dev/null', "NotADirectoryError: .*'/dev/null/")):
            with self.subTest(name):
                process = self.start(env=dict(environment(self.port, self.folder.name), **{name: value}))
                _, err = process.communicate(timeout=120)
                self.assertEqual(process.returncode, 1)
                self.assertRegex(err.strip().split('\n')[-1], '^scripts/run: ' + reason)

    def test_of_two_that_begin_at_the_same_moment_one_is_refused(self):
        """[FLT-1]"""
        first = self.start_with('() { sleep 90; }')  # its nodes have not begun yet
        code, _, err = self.run_to_the_end()
        os.killpg(first.pid, signal.SIGINT)
        self.assertEqual(first.wait(40), 130)
        self.assertEqual(code, 1)
        self.assertRegex(err, '^scripts/run: another scripts/run at the ROS master .* is about to begin or to end')
        self.assert_nothing_is_left()

    def test_it_ends_at_once_also_if_roslaunch_has_lost_the_ctrl_c(self):
        lost = 'import signal, time; signal.signal(signal.SIGINT, signal.SIG_IGN); time.sleep(90)'
        process = self.start_with('() { exec /usr/bin/python3 -c "' + lost + '"; }')
        time.sleep(0.5)
        begin = time.monotonic()
        os.killpg(process.pid, signal.SIGINT)
        self.assertEqual(process.wait(40), 130)
        self.assertLess(time.monotonic() - begin, 30.0, 'it waited until roslaunch would end')
        self.assertNotIn('Traceback', process.stderr.read())
        self.assert_nothing_is_left()

    def test_it_does_not_join_a_master_at_which_a_robot_runs(self):
        """[FLT-1]"""
        with xmlrpc.server.SimpleXMLRPCServer(('127.0.0.1', self.port), logRequests=False) as master:
            master.register_function(lambda _: [1, 'current system state', [[['/robot1/odom', ['/robot1/base']]], [], []]],
                                     'getSystemState')
            threading.Thread(target=master.handle_request, daemon=True).start()
            code, out, err = self.run_to_the_end()
        self.assertEqual(code, 1)
        self.assertRegex(err, '^scripts/run: /robot1/base publishes /robot1/odom at the ROS master http://127.0.0.1:%d, .* export '
                              'ROS_MASTER_URI=http://127.0.0.1:PORT\n$' % self.port)
        self.assertNotIn('Launching', out)

    def start_exploring(self, prefix, start=None):
        """The running script, once something is explored, and what it has said."""
        process = (start or self.start)('map:=' + prefix, 'world:=' + str(ROOT / 'config/worlds/office.yaml'), 'speed:=2')
        said = ''
        end = time.monotonic() + 240.0
        while not re.search(r'explored +[1-9]', said) and time.monotonic() < end:
            line = process.stdout.readline()
            self.assertTrue(line, said)
            said += line
        return process, said

    def test_ctrl_c_saves_the_map_and_leaves_nothing_behind(self):
        prefix = os.path.join(self.folder.name, 'floor')
        process, said = self.start_exploring(prefix)
        while not re.search(r'driven +(0\.[1-9]|[1-9])', said):
            said += process.stdout.readline()
            self.assertIsNone(process.poll(), said)
        self.assertTrue(glob.glob(self.folder.name + '/frontier_pilot/runs/*/run_0.bag.active'),
                        'it explores before its recorder is ready')
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGINT)  # an impatient operator presses it twice
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130, said + out + err)
        self.assertIn('Map saved: %s.pgm' % prefix, out, err)
        self.assertTrue(os.path.exists(prefix + '.yaml'))
        report = re.fullmatch(r'Report: (/.*\.html)', out.strip().split('\n')[-1])
        self.assertTrue(report, out + err)
        self.assertIn('The exploration was not finished', pathlib.Path(report.group(1)).read_text())
        self.assert_nothing_is_left()

    def test_ctrl_c_just_after_the_start_of_the_watcher_leaves_nothing_behind(self):
        early = pathlib.Path(self.folder.name, 'early')
        early.write_text("trap 'case $BASH_COMMAND in watch=*\\!) kill -INT $$ ;; esac' DEBUG\n")
        with mock.patch.dict(os.environ, BASH_ENV=str(early)):
            process = self.start('gui:=false', 'rviz:=false')
        _, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn('there is no report: the run ended before its recorder had begun', err)
        self.assert_nothing_is_left()

    def test_it_says_why_nothing_is_recorded(self):
        runs = pathlib.Path(self.folder.name, 'frontier_pilot/runs')
        runs.parent.mkdir()
        runs.write_text('')
        process = self.start('gui:=false', 'rviz:=false')
        said = ''
        while 'The recorder has not begun' not in said:
            said += process.stdout.readline()
            self.assertIsNone(process.poll(), said)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=120)
        self.assertRegex(err, 'there is no report: nothing is recorded: .*' + re.escape(str(runs)))
        self.assert_nothing_is_left()

    def test_a_report_that_takes_too_long_may_remove_its_copy_of_the_bag_before_it_is_killed(self):
        functions = re.findall(r'^(?:await_end|kill_and_wait|make_report)\(\) \{\n.*?^\}\n', pathlib.Path(RUN).read_text(), re.M | re.S)
        give_up = 'set -euo pipefail; say() { echo "$1"; }; trap impatient=true INT; root=. logs=. record=true\n'
        folder = pathlib.Path(self.folder.name)
        copy, report = folder / 'copy', folder / 'scripts/report'
        report.parent.mkdir()
        (folder / 'recorded').symlink_to(folder)
        for on_term in ('rm copy; exit 143', ''):  # and one that hangs
            report.write_text("#!/bin/bash\ntrap '%s' TERM; echo $$ >copy; while :; do sleep 0.05; done\n" % on_term)
            report.chmod(0o755)
            process = subprocess.Popen(['bash', '-c', give_up + ''.join(functions) + 'make_report'], cwd=folder, preexec_fn=heed_ctrl_c,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
            while not copy.exists() or not copy.read_text():
                time.sleep(0.01)
            number = int(copy.read_text())
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=60)
            self.assertEqual((process.returncode, out), (0, 'Making the report ...\n'))
            self.assertRegex(err, r"^scripts/run: gave up making the report; 'rosrun frontier_pilot report latest' makes it\n$")
            self.assertEqual(copy.exists(), on_term == '')
            self.assertFalse(os.path.exists('/proc/%d' % number), 'it goes on')

    def assert_the_map_is_saved(self, process, prefix, code):
        self.assertEqual(process.wait(timeout=120), code)
        self.assertTrue(os.path.exists(prefix + '.yaml'))
        self.assert_nothing_is_left()

    def test_the_map_is_saved_although_ctrl_c_also_ended_the_program_that_reads_what_it_says(self):
        prefix = os.path.join(self.folder.name, 'floor')
        # What the caller's shell exports must not matter.
        exported = {'SHELLOPTS': 'noglob:noclobber', 'FUNCNEST': '1'}
        with mock.patch.dict(os.environ, exported):
            process, _ = self.start_exploring(prefix)
        process.stdout.close()
        process.stderr.close()
        process.send_signal(signal.SIGINT)
        self.assert_the_map_is_saved(process, prefix, 130)

    def test_the_map_is_saved_when_the_terminal_is_closed(self):
        process, _ = self.start_exploring('-floor', self.start_in_terminal)  # a name that looks like an option is as good as any
        process.stdout.close()
        self.assert_the_map_is_saved(process, os.path.join(self.folder.name, '-floor'), 129)

    def test_another_ctrl_c_ends_everything_although_the_mapper_hangs(self):
        process, said = self.start_exploring(os.path.join(self.folder.name, 'floor'))
        mapper, = [process for process in self.processes() if command_of(process).split()[0].endswith(b'/mapper')]
        os.kill(mapper, signal.SIGSTOP)
        for _ in range(20):
            process.send_signal(signal.SIGINT)
            try:
                out, err = process.communicate(timeout=4)
                break
            except subprocess.TimeoutExpired:
                pass
        else:
            self.fail('it does not end')
        self.assertEqual(process.returncode, 130, said + out + err)
        self.assertIn('gave up waiting', err)
        self.assert_nothing_is_left()


if __name__ == '__main__':
    os.environ['FRONTIER_PILOT_BUILD'] = os.path.abspath(sys.argv.pop(1))
    unittest.main()
