#!/usr/bin/env python3
"""How scripts/run ends when a signal comes while it makes the report, and what it says of a map that was not saved."""
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest

RUN = pathlib.Path(__file__).resolve().parents[3] / 'scripts/run'
# The clock of the script stands still, so that no signal comes late on a busy computer.
PATIENT = 'unset SECONDS; SECONDS=0; say() { echo "$1"; }\n'
# Each word takes so long that the first signal after it is an impatient one.
IMPATIENT = 'say() { echo "$1"; SECONDS=$((SECONDS + 2)); }\n'
BEFORE = 'set -euo pipefail; root=. claim=claim record=true\n'
AFTER = '\nlogs=. log=log; heed_signals; trap end_by_itself EXIT; exit "$1"'
# In place of scripts/report: it ends when a file `enough` is there.
REPORT = '''#!/bin/bash
trap 'exit 129' HUP
echo $$ >number
while [ ! -e enough ]; do sleep 0.05; done
echo page.html
'''


class RunEnd(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / 'recorded').symlink_to(self.folder)
        self.report = self.folder / 'scripts/report'
        self.report.parent.mkdir()
        self.report.write_text(REPORT)
        self.report.chmod(0o755)

    def making_the_report(self, code, clock=PATIENT):
        """The end of the script after an exploration that ended with this code, and the number of the process that makes its report."""
        functions = re.search(r'^launch=0 watch=0.*?(?=^hold_signals\n)', RUN.read_text(), re.M | re.S).group()
        script = subprocess.Popen(['bash', '-c', clock + BEFORE + functions + AFTER, 'run', str(code)], cwd=self.folder, text=True,
                                  preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        number = self.folder / 'number'
        while not number.exists() or not number.read_text():
            if script.poll() is not None and not number.exists():
                self.fail('it made no report: %s%s' % script.communicate())
            time.sleep(0.01)
        return script, int(number.read_text())

    def ended(self, script):
        out, err = script.communicate(timeout=60)
        return script.returncode, out.splitlines()[-1], err

    def test_a_signal_is_told_by_the_exit_code_although_the_report_is_made(self):
        for code, number, told in ((0, signal.SIGINT, 130), (0, signal.SIGTERM, 143), (0, signal.SIGHUP, 129), (1, signal.SIGINT, 1)):
            with self.subTest(code=code, signal=number.name):
                script, _ = self.making_the_report(code)
                script.send_signal(number)
                (self.folder / 'enough').touch()
                self.assertEqual(self.ended(script), (told, 'Report: page.html', ''))
                (self.folder / 'enough').unlink()
                (self.folder / 'number').unlink()

    def test_without_a_signal_the_exit_code_is_that_of_the_exploration(self):
        (self.folder / 'enough').touch()
        for code in (0, 1):
            self.assertEqual(self.ended(self.making_the_report(code)[0]), (code, 'Report: page.html', ''))

    def test_a_terminal_that_is_closed_ends_the_report_and_it_is_said_how_to_make_it(self):
        script, report = self.making_the_report(0)
        script.send_signal(signal.SIGHUP)
        subprocess.run(['kill', '-HUP', str(report)], check=True)
        code, _, err = self.ended(script)
        self.assertEqual((code, err), (129, "scripts/run: gave up making the report; 'rosrun frontier_pilot report latest' makes it\n"))

    def test_a_page_that_was_made_when_somebody_did_not_wait_for_it_is_named(self):
        for at_sigterm, code, said in (('echo page.html; exit', 130, 'Report: page.html'), ('exit 143', 130, 'Making the report ...')):
            with self.subTest(at_sigterm=at_sigterm):
                self.report.write_text(REPORT.replace("trap 'exit 129' HUP", "trap '%s' TERM" % at_sigterm))
                script, _ = self.making_the_report(0, IMPATIENT)
                script.send_signal(signal.SIGINT)
                self.assertEqual(self.ended(script)[:2], (code, said))
                (self.folder / 'number').unlink()

    def test_it_ends_although_the_report_cannot_be_killed(self):
        """[FLT-1]"""
        script, report = self.making_the_report(0, IMPATIENT + 'kill() { [ "$1" = -0 ] || return 0; command kill "$@"; }\n')
        self.addCleanup(os.kill, report, signal.SIGKILL)
        script.send_signal(signal.SIGINT)
        code, _, err = self.ended(script)
        self.assertEqual((code, err), (130, "scripts/run: gave up making the report; 'rosrun frontier_pilot report latest' makes it\n"))

    def saying_what_is_kept(self, log, meanwhile=''):
        """What the end of a run without a report says on stderr, in which the nodes have said this, and this was done meanwhile."""
        (self.folder / 'log').write_text('... logging to /home/me/.ros/log/launch-1/roslaunch-computer-42.log\n' + log)
        functions = re.search(r'^launch=0 watch=0.*?(?=^hold_signals\n)', RUN.read_text(), re.M | re.S).group()
        words = PATIENT + BEFORE + 'record=false\n' + functions + AFTER.replace('heed_signals', meanwhile + 'heed_signals')
        return subprocess.run(['bash', '-c', words, 'run', '1'], cwd=self.folder, text=True, capture_output=True, timeout=60,
                              env=dict(os.environ, ROS_HOME=str(self.folder))).stderr

    def test_the_copy_of_a_mapper_that_was_killed_is_named(self):
        copy = self.folder / 'frontier_pilot/launch-1/kept_map.mapper.yaml'
        self.assertEqual(self.saying_what_is_kept(''), '')
        copy.parent.mkdir(parents=True)
        copy.touch()
        self.assertIn('map_file:=%s begins with it' % copy, self.saying_what_is_kept(''))

    def test_the_copy_of_a_mapper_that_was_killed_is_named_also_after_a_long_run(self):
        copy = self.folder / 'frontier_pilot/launch-1/kept_map.mapper.yaml'
        copy.parent.mkdir(parents=True)
        copy.touch()
        watch = re.search(r'^await_refusal\(\) \{\n.*?^\}\n', RUN.read_text(), re.M | re.S).group()
        # The first minute passes at once, and then the log holds only what was said last.
        a_long_run = '\n' + watch.replace('exec tail', 'return; exec tail') + 'sleep() { :; }; await_refusal; echo later >log; unset -f sleep\n'
        self.assertIn('map_file:=%s begins with it' % copy, self.saying_what_is_kept('', a_long_run))

    def test_what_the_mapper_said_of_its_copy_is_repeated(self):
        said = 'the map was not saved, because of this; its copy is kept: map_file:=/lost/map.yaml begins with it'
        self.assertEqual(self.saying_what_is_kept('\x1b[33m[ WARN] [1.0] [/mapper]: %s\x1b[0m\n' % said), 'scripts/run: %s\n' % said)

    def test_what_a_mapper_said_before_another_one_was_started_in_its_place_is_not_repeated(self):
        said = 'the map was not saved, because of %s; its copy is kept: map_file:=/lost/map.yaml begins with it'
        log = '[ WARN] [1.0] [/mapper]: %s\n\x1b[1mprocess[mapper-3]: started with pid [7]\x1b[0m\n' % (said % 'this')
        self.assertEqual(self.saying_what_is_kept(log), '')
        self.assertEqual(self.saying_what_is_kept(log + '[ WARN] [2.0] [/mapper]: %s\n' % (said % 'that')), 'scripts/run: %s\n' % (said % 'that'))
        (self.folder / 'log.1').write_text('[ WARN] [3.0] [/mapper]: %s\n' % (said % 'this'))
        self.assertEqual(self.saying_what_is_kept('process[run_recorder-9]: started with pid [8]\n'), 'scripts/run: %s\n' % (said % 'this'))


if __name__ == '__main__':
    unittest.main()
