#!/usr/bin/env python3
"""The window when its display server dies: it ends, and without an abort."""
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


if __name__ == '__main__':
    rospy.init_node('lost_display', disable_rostime=True)
    rostest.rosrun('frontier_pilot', 'lost_display', LostDisplay)
