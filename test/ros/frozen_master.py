#!/usr/bin/env python3
"""The window and the recorder at a master that hangs: they end all the same. The test has a master of its own, which it may freeze."""
import os
import signal
import subprocess
import tempfile
import time
import unittest

import rosgraph
import rospy
import rostest

from wire import Node, free_port, wait_for


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


if __name__ == '__main__':
    rospy.init_node('frozen_master')
    rostest.rosrun('frontier_pilot', 'frozen_master', FrozenMaster)
