#!/usr/bin/env python3
"""What a master that hangs, or is gone, must not change: the window and the recorder end all the same, and a map keeps its owner. The test
has a master of its own, which it may freeze."""
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import rosgraph
import rospy
import rostest

from wire import Node, free_port, wait_for

# Publishes a map of some side: at first once, and each half second with a third argument.
MAP = """
import sys
import rospy
from nav_msgs.msg import OccupancyGrid
rospy.init_node(sys.argv[1])
map = OccupancyGrid()
map.header.frame_id = 'map'
map.info.resolution, map.info.width, map.info.height = 0.05, int(sys.argv[2]), int(sys.argv[2])
map.info.origin.orientation.w = 1.0
map.data = [0] * int(sys.argv[2]) ** 2
topic = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
topic.publish(map)
while len(sys.argv) > 3 and not rospy.is_shutdown():
    rospy.rostime.wallsleep(0.5)
    topic.publish(map)
rospy.spin()
"""


class FrozenMaster(unittest.TestCase):
    def setUp(self):
        port = free_port()
        self.uri = 'http://127.0.0.1:%d' % port
        self.master = subprocess.Popen(['rosmaster', '--core', '-p', str(port)], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        self.addCleanup(self.master.wait)
        self.addCleanup(self.master.kill)
        self.assertTrue(wait_for(lambda: self.publishers() is not None, 20.0))

    def publishers(self):
        return self.state(0)

    def state(self, kind):
        try:
            return dict(rosgraph.Master('/test', master_uri=self.uri).getSystemState()[kind])
        except (OSError, rosgraph.MasterException):
            return None

    def test_the_window_ends_while_the_master_hangs(self):
        """[FLT-1] [GUI-3]"""
        environment = dict(os.environ, ROS_MASTER_URI=self.uri, QT_QPA_PLATFORM='offscreen')
        window = Node('teleop_gui', environment=environment)
        self.addCleanup(window.process.kill)
        self.assertTrue(wait_for(lambda: '/cmd_vel_manual' in (self.publishers() or {}), 20.0))
        self.master.send_signal(signal.SIGSTOP)
        time.sleep(2.0)  # until it is under way to ask the master again, as it does each second
        window.signal(signal.SIGTERM)
        self.assertTrue(wait_for(window.has_ended, 20.0), 'it waits for the master')

    def test_the_recorder_ends_while_the_master_hangs(self):
        """[FLT-1] [REC-1]"""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        environment = dict(os.environ, ROS_MASTER_URI=self.uri)
        recorder = Node('run_recorder', '_folder:=' + folder.name, '_min_space:=1', '_period:=0.5', environment=environment)
        self.addCleanup(recorder.process.kill)
        self.assertTrue(wait_for(lambda: '/run_recorder_rosbag' in (self.state(1) or {}).get('/tf_static', []), 30.0))
        time.sleep(1.0)  # until the recorder has looked at the master again
        self.master.send_signal(signal.SIGSTOP)
        time.sleep(3.0)  # until it is under way to ask the master again
        recorder.signal(signal.SIGTERM)
        self.assertTrue(wait_for(recorder.has_ended, 25.0), 'it waits for the master')
        code, said = recorder.finish()
        self.assertEqual(code, 0, said)
        self.assertIn('run_recorder: recorded', said)

    def map_is_heard(self):
        return all(node in dict(self.state(part) or {}).get('/map', []) for part, node in ((0, '/owner'), (1, '/navigator')))

    def start_map(self, *arguments):
        process = subprocess.Popen([sys.executable, '-c', MAP, *arguments], env=dict(os.environ, ROS_MASTER_URI=self.uri))
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)

    def test_a_silent_owner_keeps_its_map_while_the_master_hangs_and_after_it_has_died(self):
        """[FLT-1]"""
        navigator = Node('navigator', environment=dict(os.environ, ROS_MASTER_URI=self.uri))
        self.addCleanup(navigator.process.kill)
        self.start_map('owner', '20')
        self.assertTrue(wait_for(self.map_is_heard, 30.0))
        time.sleep(2.0)  # until its map has arrived
        self.start_map('stranger', '10', 'again')  # a map that is smaller, again and again
        self.assertTrue(wait_for(lambda: 'while /owner publishes the map' in navigator.said(), 20.0), navigator.said())
        for what in (signal.SIGSTOP, signal.SIGKILL):
            self.master.send_signal(what)
            time.sleep(8.0)  # an owner is asked about once it was silent for five seconds
            self.assertNotIn('map shrank', navigator.said(), "the stranger's map replaced that of the owner, which lives")


if __name__ == '__main__':
    rospy.init_node('frozen_master')
    rostest.rosrun('frontier_pilot', 'frozen_master', FrozenMaster)
