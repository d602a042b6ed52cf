#!/usr/bin/env python3
"""frontier_pilot/PilotPanel inside a real rviz under Xvfb: it loads, listens, is silent unless driven, and closes."""
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import rosgraph
import rospy
import rostest
import yaml

from screen import Screen

CONFIG = {
    'Panels': [{'Class': 'frontier_pilot/PilotPanel', 'Name': 'Pilot'}],
    'Visualization Manager': {'Class': '', 'Displays': [], 'Tools': [{'Class': 'frontier_pilot/Inspect'}],
                              'Global Options': {'Fixed Frame': 'map'}, 'Name': 'root'},
    'Window Geometry': {'Width': 1000, 'Height': 700, 'X': 0, 'Y': 0},
}
NODE = '/rviz_with_panel'


def waited_for(condition, seconds=40.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.1)
    return False


def topics_of(node):
    """What a node publishes and listens to, as the master knows it."""
    publishers, subscribers, _ = rosgraph.Master('/rviz_panel_test').getSystemState()
    return ({topic for topic, nodes in publishers if node in nodes},
            {topic for topic, nodes in subscribers if node in nodes})


class RvizPanel(unittest.TestCase):
    def setUp(self):
        if shutil.which('Xvfb') is None or shutil.which('rviz') is None:
            self.skipTest('needs Xvfb and rviz')
        self.folder = tempfile.mkdtemp()
        self.screen = self.rviz = None

    def start(self):
        config = os.path.join(self.folder, 'panel.rviz')
        with open(config, 'w') as file:
            yaml.safe_dump(CONFIG, file)
        self.screen = Screen(self.folder)
        self.log = open(os.path.join(self.folder, 'log'), 'w+')
        self.rviz = subprocess.Popen(['rviz', '-d', config, '__name:=' + NODE[1:]], env=self.screen.environment,
                                     stdout=self.log, stderr=subprocess.STDOUT)

    def tearDown(self):
        if self.rviz is not None:
            if self.rviz.poll() is None:
                self.rviz.kill()
            self.rviz.wait()
        if self.screen is not None:
            self.screen.end()
        self.log.close()
        shutil.rmtree(self.folder)

    def loads(self):
        """Whether the panel listens to what the window shows."""
        wanted = {'/cmd_vel_arbiter/status', '/emergency_stop_state', '/scan', '/obstacle_avoider/status',
                  '/frontier_explorer/status', '/turtlebot3/feedback'}
        return waited_for(lambda: wanted <= topics_of(NODE)[1] or self.rviz.poll() is not None) \
            and self.rviz.poll() is None

    def test_parameters_that_are_none_leave_the_defaults(self):
        """[FLT-1]"""
        rospy.set_param('/teleop_gui', 5)
        self.addCleanup(rospy.delete_param, '/teleop_gui')
        self.start()
        self.assertTrue(self.loads(), self.output())
        self.assertIn('single value', self.output())

    def test_the_panel_loads_listens_keeps_silent_and_closes(self):
        """[GUI-2] what the window shows is heard by the panel too; [GUI-3] it leaves without hanging."""
        self.start()
        self.assertTrue(self.loads(), self.output())
        time.sleep(1.0)  # that nothing comes can only be seen by waiting
        self.assertNotIn('/cmd_vel_manual', topics_of(NODE)[0], 'a panel that nobody drives with must not speak')
        self.assertNotIn('PilotPanel', self.output(), 'rviz complains of the panel')
        self.rviz.send_signal(signal.SIGINT)
        self.assertTrue(waited_for(lambda: self.rviz.poll() is not None, 20.0), 'rviz does not close')

    def output(self):
        self.log.flush()
        with open(self.log.name) as file:
            return file.read()


if __name__ == '__main__':
    rospy.init_node('rviz_panel_test', disable_rostime=True)
    rostest.rosrun('frontier_pilot', 'rviz_panel', RvizPanel)
