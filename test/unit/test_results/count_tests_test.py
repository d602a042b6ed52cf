#!/usr/bin/env python3
"""Tests are counted from their files of results, and one that died before it had written its file is found."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[3] / 'scripts'

CASES = ('<testsuite><testcase classname="Doors" name="open" /><testcase classname="Doors" name="close"><failure /></testcase>'
         '<testcase classname="Doors" name="creak" status="notrun" /></testsuite>')
ROSTEST = ('<testsuite><testcase classname="rostest" name="testdoors" /><system-out>results are in [%s]</system-out>'
           '<system-err>%s</system-err></testsuite>')
DIED = '[31m[doors-7] process has died [pid 42, exit code %s, cmd doors.py --gtest_output=xml:x __name:=doors].\nlog file: %s/doors-7*.log[0m'
LOG = '''1/2 Testing: _ctest_frontier_pilot_rostest_test_ros_doors.test
Fatal Python error: Segmentation fault
  File "doors.py", line 9 in test_open
%s
Test Passed.
2/2 Testing: _ctest_frontier_pilot_rostest_test_ros_windows.test
a pane
''' % '\n'.join('noise %d' % number for number in range(100))


class Results(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = pathlib.Path(folder.name)
        self.write('test_results/frontier_pilot/gtest-doors.xml', CASES)

    def write(self, path, text):
        path = self.build / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def write_dead(self, said):
        """The files of the ROS test test/ros/doors.test, whose program died."""
        dead = self.write('test_results/frontier_pilot/rosunit-doors.xml', '')
        self.write('test_results/frontier_pilot/rostest-test_ros_doors.xml', ROSTEST % (dead, said))
        self.write('test_results/frontier_pilot/rostest-test_ros_windows.xml', ROSTEST % ('/rosunit-windows.xml', ''))

    def said(self, script, argument):
        return subprocess.run([sys.executable, SCRIPTS / script, argument], check=True, capture_output=True, text=True).stdout

    def counted(self):
        return self.said('count_tests.py', self.build / 'test_results').splitlines()

    def test_a_case_that_did_not_run_is_not_counted(self):
        self.assertEqual(self.counted(), ['1 1', 'Doors.close'])

    def test_a_test_that_died_is_named_with_the_signal_that_ended_it(self):
        self.write_dead(DIED % (-11, self.build))
        self.assertEqual(self.counted(), ['1 2', 'Doors.close', 'rosunit-doors.xml: not readable: test_ros_doors ended by SIGSEGV '
                                          'before it had written its results'])

    def test_a_test_that_left_early_is_named_with_its_exit_code(self):
        for said, code in ((DIED % (3, self.build), 3), ('[doors-7] process has finished cleanly\nlog file: x/doors-7*.log', 0)):
            self.write_dead(said)
            self.assertIn('test_ros_doors ended with exit code %d before' % code, self.counted()[-1])

    def test_a_test_whose_end_nobody_tells_of_is_named_by_its_file(self):
        self.write('test_results/frontier_pilot/rosunit-doors.xml', '')
        self.assertEqual(self.counted()[-1], 'rosunit-doors.xml: not readable: doors ended before it had written its results')

    def test_the_trace_and_the_last_words_of_a_test_that_died_are_shown(self):
        self.write_dead(DIED % (-9, self.build))
        self.write('Testing/Temporary/LastTest.log', LOG)
        self.write('doors-7-stdout.log', 'a door creaks\n')
        said = self.said('dead_tests.py', self.build)
        for words in ('test_ros_doors ended by SIGKILL', 'line 9 in test_open', 'noise 99\nTest Passed.', 'doors-7-stdout.log\na door creaks'):
            self.assertIn(words, said)
        for words in ('noise 40\n', 'a pane'):
            self.assertNotIn(words, said)

    def test_nothing_is_shown_if_no_test_died(self):
        self.assertEqual(self.said('dead_tests.py', self.build), '')


if __name__ == '__main__':
    unittest.main()
