#!/usr/bin/env python3
"""What watch_exploration.py takes, and what it says of the map."""
import io
import pathlib
import subprocess
import sys
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'scripts'))
import watch_exploration  # noqa: E402
from frontier_pilot.srv import SaveMapResponse  # noqa: E402


class Words(unittest.TestCase):
    def test_a_period_in_which_no_line_can_be_printed_is_refused(self):
        """[FLT-1]"""
        for period in ('nan', 'inf', '-1', '0.1', '3601', 'often'):
            with self.subTest(period=period):
                done = subprocess.run([str(ROOT / 'scripts/watch_exploration.py'), '--period=' + period, '__master:=nowhere'], timeout=60,
                                      stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                self.assertEqual((done.returncode, done.stdout), (2, ''))
                self.assertRegex(done.stderr, '^watch_exploration.py: argument --period: .*%s.*\n$' % period.lstrip('-'))


class Map(unittest.TestCase):
    def said(self, answer, path):
        with mock.patch('sys.stdout', io.StringIO()) as out, mock.patch('sys.stderr', out), \
                mock.patch('rospy.wait_for_service'), mock.patch('rospy.ServiceProxy', return_value=lambda _: answer):
            watch_exploration.save_map(path)
        return out.getvalue()

    def test_the_files_are_named_as_the_mapper_has_written_them(self):
        answer = SaveMapResponse(success=True, message='saved /tmp/floor.pgm, .yaml and .bt')
        self.assertEqual(self.said(answer, '/tmp/floor.yaml'), 'Map saved: /tmp/floor.pgm, .yaml and .bt\n')

    def test_why_no_map_was_saved_is_said(self):
        answer = SaveMapResponse(success=False, message='the disk is full')
        self.assertEqual(self.said(answer, '/tmp/floor'), 'The map could not be saved: the disk is full\n')


if __name__ == '__main__':
    unittest.main()
