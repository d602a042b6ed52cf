#!/usr/bin/env python3
"""The window when its display server dies, or is not there: it ends, and without an abort."""
import os
import shutil
import subprocess
import tempfile
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist

from screen import Screen
from wire import Record, find_node, wait_for

ROUNDS = 6


class LostDisplay(unittest.TestCase):
    def setUp(self):
        if shutil.which('Xvfb') is None:
            self.skipTest('needs Xvfb')
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.manual = Record('cmd_vel_manual', Twist)

    def lose(self):
        """Starts a window and kills its display. Gives the exit code of the window and what it wrote."""
        screen = Screen(self.folder)
        self.addCleanup(screen.end)
        window = subprocess.Popen([find_node('frontier_pilot', 'teleop_gui'), '__name:=window_to_lose'],
                                  env=screen.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(window.kill)
        # Before the window is drawn, Mesa crashes without its display. Afterwards the event loop sends the velocities.
        self.manual.items.clear()
        self.assertTrue(wait_for(lambda: len(self.manual.items) > 3, 20.0))
        screen.end()
        written, _ = window.communicate(timeout=20.0)
        return window.returncode, written

    def test_a_window_whose_display_dies_ends_without_an_abort(self):
        """[FLT-1]"""
        for _ in range(ROUNDS):
            code, written = self.lose()
            self.assertEqual(code, 1, written)
            self.assertNotIn('terminate called', written)

    def test_a_window_without_a_display_says_why_it_ends_in_one_line(self):
        """[FLT-1]"""
        for platform, words in (('xcb', 'display'), ('nosuch', 'nosuch')):
            environment = dict(os.environ, QT_QPA_PLATFORM=platform, DISPLAY=':98765')
            window = subprocess.run([find_node('frontier_pilot', 'teleop_gui'), '__name:=window_without_display'], env=environment,
                                    stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, timeout=30.0)
            self.assertEqual(window.returncode, 1, window.stderr)
            self.assertRegex(window.stderr, '^teleop_gui: no window can be opened: [^\n]*%s[^\n]*\n$' % words)


if __name__ == '__main__':
    rospy.init_node('lost_display', disable_rostime=True)
    rostest.rosrun('frontier_pilot', 'lost_display', LostDisplay)
