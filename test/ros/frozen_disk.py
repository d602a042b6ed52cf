#!/usr/bin/env python3
"""A disk under ROS_HOME that hangs, as one of a server that is away, holds up no zeros and no stop."""
import glob
import os
import pathlib
import shutil
import signal
import tempfile
import unittest

import rospy
import rostest
from frontier_pilot.msg import ArbiterStatus
from geometry_msgs.msg import Twist
from std_srvs.srv import SetBool, Trigger

from wire import SANITIZED, Node, Record, Source, call, find_node, moves, wait_for

LIBRARY = os.path.join(os.path.dirname(find_node('frontier_pilot', 'cmd_vel_arbiter')), '..', 'libhanging_disk.so')


@unittest.skipIf(SANITIZED, 'no library may be loaded before that of the sanitizer')
class FrozenDisk(unittest.TestCase):
    def setUp(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        self.home = os.path.join(folder, 'home')
        self.hangs = pathlib.Path(self.home + '.hangs')
        self.addCleanup(lambda: self.hangs.unlink() if self.hangs.exists() else None)
        self.environment = dict(os.environ, ROS_HOME=self.home, XDG_RUNTIME_DIR=os.path.join(folder, 'spare'),
                                HANGING_DISK=self.home, LD_PRELOAD=LIBRARY)
        os.mkdir(self.environment['XDG_RUNTIME_DIR'])
        self.out = Record('cmd_vel', Twist)
        self.status = Record('cmd_vel_arbiter/status', ArbiterStatus)

    def start(self):
        node = Node('cmd_vel_arbiter', environment=self.environment)
        self.addCleanup(node.end)
        self.status.items.clear()
        self.assertTrue(wait_for(lambda: self.status.last is not None), node.said())
        return node

    def kept(self):
        return glob.glob(self.home + '/frontier_pilot/*/stopped.*')

    def sends(self):
        """Whether the arbiter sends on."""
        count = len(self.out.items)
        return wait_for(lambda: len(self.out.items) > count + 40)

    # [ARB-7] [FLT-2]
    def test_commands_stops_and_switches_go_on_while_it_hangs_and_the_stop_is_kept(self):
        arbiter = self.start()
        manual = Source('cmd_vel_manual').connect().start(0.1)
        self.addCleanup(manual.close)
        self.assertTrue(wait_for(lambda: moves(self.out.last)))
        self.hangs.touch()
        self.assertTrue(self.sends(), 'the arbiter is silent while the disk hangs [FLT-2]')
        self.assertTrue(moves(self.out.last), 'commands go on [FLT-2]')
        self.assertTrue(call('set_nav_enabled', SetBool, False).success)
        self.assertTrue(call('emergency_stop', Trigger).success)
        self.assertTrue(self.sends(), 'the arbiter is silent after a stop while the disk hangs [FLT-2]')
        self.assertFalse(moves(self.out.last), '[ARB-7]')
        self.assertEqual(self.kept(), [])
        self.hangs.unlink()
        self.assertTrue(wait_for(self.kept), 'the stop is kept on the disk once it answers [ARB-7]')
        self.hangs.touch()
        self.assertTrue(self.sends())
        arbiter.signal(signal.SIGKILL)
        arbiter.finish()
        self.hangs.unlink()
        self.start()
        self.assertTrue(self.status.last.emergency_stop, '[ARB-7]')


if __name__ == '__main__':
    rospy.init_node('frozen_disk')
    rostest.rosrun('frontier_pilot', 'frozen_disk', FrozenDisk)
