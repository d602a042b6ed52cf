#!/usr/bin/env python3
"""What would not survive a node, and what did not survive the one before it, is in its diagnostics."""
import glob
import os
import shutil
import signal
import tempfile
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from frontier_pilot.msg import ArbiterStatus, ExplorerStatus
from std_srvs.srv import SetBool, Trigger

from wire import Node, Record, call, wait_for

KEEPERS = {'cmd_vel_arbiter': ['an emergency stop', 'nav_disabled'], 'frontier_explorer': ['exploration_paused'],
           'obstacle_avoider': ['avoider_enabled'], 'mapper': ['the map']}


class LostMemory(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.home = os.path.join(self.folder, 'home')
        self.runtime = '/proc/nowhere'  # no spare place for a stop
        self.diagnostics = Record('/diagnostics', DiagnosticArray)

    def start(self, executable, *arguments):
        node = Node(executable, *arguments, environment=dict(os.environ, ROS_HOME=self.home, XDG_RUNTIME_DIR=self.runtime))
        self.addCleanup(node.end)
        return node

    def memory(self, node):
        """What a node says last of its memory."""
        return next((part for _, message in reversed(self.diagnostics.items) for part in message.status
                     if part.name == node + ': memory'), None)

    def says(self, node, level, *texts):
        def said():
            memory = self.memory(node)
            words = memory and memory.message + ''.join(value.key for value in memory.values)
            return memory is not None and memory.level == level and all(text in words for text in texts)
        return wait_for(said, 8.0)

    # [FLT-1] [FLT-2]
    def test_a_folder_that_cannot_be_written_is_a_warning_from_the_start_until_it_can(self):
        with open(self.home, 'w'):
            pass  # a file, under which even root makes no folder
        for node in KEEPERS:
            self.start(node)
        for node, what in KEEPERS.items():
            self.assertTrue(self.says(node, DiagnosticStatus.WARN, 'would not survive', *what),
                            '%s: %s [FLT-1]' % (node, self.memory(node)))
        self.assertIn('would not survive', call('set_nav_enabled', SetBool, False).message)
        os.remove(self.home)
        for node in KEEPERS:
            self.assertTrue(self.says(node, DiagnosticStatus.OK), '%s: %s' % (node, self.memory(node)))
        # A node may make its folder anew meanwhile.
        self.assertTrue(wait_for(lambda: shutil.rmtree(self.home, ignore_errors=True) or not os.path.exists(self.home)))
        with open(self.home, 'w'):
            pass
        for node, what in KEEPERS.items():
            self.assertTrue(self.says(node, DiagnosticStatus.WARN, *what), '%s: %s' % (node, self.memory(node)))

    # [FLT-1]
    def test_what_cannot_be_kept_is_said_once_in_the_log(self):
        with open(self.home, 'w'):
            pass
        arbiter = self.start('cmd_vel_arbiter')
        self.assertTrue(self.says('cmd_vel_arbiter', DiagnosticStatus.WARN, 'would not survive'))
        call('set_nav_enabled', SetBool, False)
        rospy.sleep(4.0)  # that nothing more is said can only be seen by waiting
        # An earlier warning may have had another reason, a disk that was slow to answer.
        self.assertEqual(arbiter.said().count('nav_disabled would not survive this node: cannot write'), 1, arbiter.said())

    # [ARB-7]
    def test_a_stop_and_the_count_of_stops_are_kept_although_the_home_cannot_be_written(self):
        with open(self.home, 'w'):
            pass
        self.runtime = self.folder
        arbiter = self.start('cmd_vel_arbiter')
        answer = call('emergency_stop', Trigger)
        self.assertNotIn('would not survive', answer.message)
        call('emergency_stop', Trigger)
        self.assertTrue(glob.glob(self.runtime + '/frontier_pilot/*/count_of_stops*'))
        arbiter.signal(signal.SIGKILL)
        arbiter.finish()
        self.start('cmd_vel_arbiter')
        status = Record('cmd_vel_arbiter/status', ArbiterStatus)
        self.assertTrue(wait_for(lambda: status.last is not None and status.last.emergency_stop))
        self.assertGreaterEqual(status.last.stops, 2, '[ARB-8]')
        self.assertTrue(call('set_emergency_stop', SetBool, False).success)

    # [ARB-7] [FLT-1]
    def test_a_cleared_stop_that_would_come_back_is_said(self):
        self.runtime = self.folder
        self.start('cmd_vel_arbiter')
        status = Record('cmd_vel_arbiter/status', ArbiterStatus)
        self.assertTrue(call('emergency_stop', Trigger).success)
        kept = glob.glob(self.home + '/frontier_pilot/**/*stopped*', recursive=True)
        self.assertTrue(kept, os.listdir(self.home))
        shutil.rmtree(os.path.dirname(kept[0]))
        with open(os.path.dirname(kept[0]), 'w'):
            pass  # a file in the place of the folder: nothing in it can be removed
        self.assertIn('would come back with the next start', call('set_emergency_stop', SetBool, False).message)
        self.assertTrue(wait_for(lambda: any('the stop that was cleared would come back' in problem for problem in status.last.problems)),
                        status.last)

    # [FLT-2]
    def test_a_pause_is_kept_although_the_home_cannot_be_written(self):
        with open(self.home, 'w'):
            pass
        self.runtime = self.folder
        status = Record('frontier_explorer/status', ExplorerStatus)
        explorer = self.start('frontier_explorer', '_autostart:=true')
        self.assertNotIn('would not survive', call('set_exploration_enabled', SetBool, False).message)
        self.assertTrue(glob.glob(self.runtime + '/frontier_pilot/*/exploration_paused*'))
        explorer.signal(signal.SIGKILL)
        explorer.finish()
        status.items.clear()
        self.start('frontier_explorer', '_autostart:=true')
        self.assertTrue(wait_for(lambda: status.last is not None and status.last.reason == ExplorerStatus.PAUSED), status.last)

    def mapper_without_its_map(self):
        """One whose predecessor died, and left a map that cannot be read."""
        mapper = self.start('mapper')
        sessions = os.path.join(self.home, 'frontier_pilot', '*')
        self.assertTrue(wait_for(lambda: glob.glob(sessions)))
        self.assertTrue(self.says('mapper', DiagnosticStatus.OK))
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        for session in glob.glob(sessions):
            with open(os.path.join(session, 'kept_map.mapper'), 'w') as file:
                file.write('nowhere\n')
        self.diagnostics.items.clear()
        mapper = self.start('mapper')
        self.assertTrue(self.says('mapper', DiagnosticStatus.ERROR, 'was lost', 'cannot be read'),
                        '%s [FLT-2]' % self.memory('mapper'))

    # [FLT-2]
    def test_a_map_that_was_lost_is_an_error_until_the_map_is_reset(self):
        self.mapper_without_its_map()
        self.assertTrue(call('mapper/reset', Trigger).success)
        self.assertTrue(self.says('mapper', DiagnosticStatus.OK), self.memory('mapper'))


if __name__ == '__main__':
    rospy.init_node('lost_memory_test')
    rostest.rosrun('frontier_pilot', 'lost_memory', LostMemory)
