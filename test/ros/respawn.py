#!/usr/bin/env python3
"""A node that is started again finds what the operator said to the one before it, and one that runs stays."""
import contextlib
import functools
import glob
import os
import signal
import socket
import subprocess
import threading
import unittest

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.msg import ArbiterStatus, AvoiderStatus, PatrolActionGoal
from std_srvs.srv import SetBool, Trigger

from wire import Node, Record, call, clear, use_a_home_of_its_own, wait_for


def lookup(master, node):
    """Empty while the master does not know the node."""
    try:
        return master.lookupNode(node)
    except rosgraph.MasterError:
        return ''


ROSLAUNCH = ['bash', '-c', '"$0" "$@"; exit $?  # stands for a roslaunch: a node looks for that word above it']


class Respawn(unittest.TestCase):
    def start(self, executable, *arguments):
        node = Node(executable, *arguments)
        self.addCleanup(node.end)
        return node

    def started_again(self, executable, number=signal.SIGKILL, *arguments):
        """The node is ended by that signal and started again, as roslaunch does with respawn."""
        self.node.signal(number)
        self.node.finish()
        self.node = self.start(executable, *arguments)

    # [FLT-2]
    def test_a_node_is_started_again_although_another_process_has_the_port_of_the_one_that_was_killed(self):
        self.node = self.start('obstacle_avoider')
        call('set_obstacle_avoid_enabled', SetBool, False)
        uri = rosgraph.Master('/test').lookupNode('/obstacle_avoider')
        self.node.signal(signal.SIGKILL)
        self.node.finish()
        heard = []
        with socket.create_server(('127.0.0.1', int(uri.rstrip('/').rsplit(':', 1)[1]))) as other:
            threading.Thread(target=self.answer, args=(other, heard), daemon=True).start()
            self.node = self.start('obstacle_avoider')
            master = rosgraph.Master('/test')
            self.assertTrue(wait_for(lambda: lookup(master, '/obstacle_avoider') not in ('', uri)), self.node.said())
            rospy.sleep(1.0)  # the master would send it within 0.1 s
            self.assertIsNone(self.node.process.poll())
            self.assertTrue(heard)
            self.assertFalse([text for text in heard if b'shutdown' in text], 'another node would end')

    @staticmethod
    def answer(server, heard):
        """Notes what each caller sends, until the server is closed."""
        try:
            while True:
                with server.accept()[0] as caller:
                    caller.settimeout(0.3)
                    heard.append(b'')
                    with contextlib.suppress(OSError):
                        for part in iter(functools.partial(caller.recv, 4096), b''):
                            heard[-1] += part
        except OSError:
            pass

    def switch(self, service, on):
        self.assertTrue(call(service, SetBool, on).success)

    # [ARB-6] [FLT-2]
    def test_a_source_that_was_switched_off_stays_off_until_it_is_switched_on(self):
        status = Record('cmd_vel_arbiter/status', ArbiterStatus)

        def nav_is(enabled):
            if status.last is None:
                return False
            return [source.enabled for source in status.last.sources if source.name == 'nav'] == [enabled]
        self.node = self.start('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: nav_is(True)))
        self.switch('set_nav_enabled', False)
        for number in [signal.SIGKILL, signal.SIGTERM]:
            self.started_again('cmd_vel_arbiter', number)
            status.items.clear()
            self.assertTrue(wait_for(lambda: status.last is not None))
            self.assertTrue(nav_is(False), '[FLT-2]')
        self.switch('set_nav_enabled', True)
        self.started_again('cmd_vel_arbiter')
        status.items.clear()
        self.assertTrue(wait_for(lambda: status.last is not None))
        self.assertTrue(nav_is(True), '[FLT-2]')

    # [ARB-7] [FLT-2]
    def test_a_stop_whose_file_is_deleted_is_written_again(self):
        self.node = self.start('cmd_vel_arbiter')
        call('emergency_stop', Trigger)
        home = os.environ.get('ROS_HOME', os.path.expanduser('~/.ros'))

        def files():
            return [f for f in glob.glob(home + '/frontier_pilot/*/stopped.emergency_stop~*')
                    if open(f).read().split('\n')[1].split()[:1] == [str(self.node.process.pid)]]
        self.assertTrue(files())
        for file in files():
            os.remove(file)
        self.assertTrue(wait_for(files, 5.0), '[ARB-7]')
        self.assertTrue(clear())
        self.assertFalse(files())

    # [ARB-7] [FLT-2]
    def test_a_stop_whose_files_were_damaged_holds_and_says_that_its_cause_cannot_be_read(self):
        status = Record('cmd_vel_arbiter/status', ArbiterStatus)
        self.node = self.start('cmd_vel_arbiter')
        call('emergency_stop', Trigger)
        self.node.signal(signal.SIGKILL)
        self.node.finish()
        spare = os.environ.get('XDG_RUNTIME_DIR', '/dev/shm/frontier_pilot-%d' % os.getuid())
        files = [f for folder in (os.environ['ROS_HOME'], spare)
                 for f in glob.glob(folder + '/frontier_pilot/*/stopped.emergency_stop~%d' % self.node.process.pid)]
        self.assertTrue(files)
        for file in files:
            os.truncate(file, 0)
        self.node = self.start('cmd_vel_arbiter')
        cause = 'from before a restart: the file that keeps its cause cannot be read'
        # The last status of the one that was killed may arrive after it.
        self.assertTrue(wait_for(lambda: status.last is not None and status.last.emergency_stop_cause == cause), status.last)
        self.assertTrue(status.last.emergency_stop, '[ARB-7]')
        self.assertTrue(clear())

    # [ARB-7] [FLT-2]
    def test_the_cause_of_a_stop_is_the_same_after_many_restarts(self):
        status = Record('cmd_vel_arbiter/status', ArbiterStatus)
        self.node = self.start('cmd_vel_arbiter')
        call('emergency_stop', Trigger)
        for _ in range(2):
            self.started_again('cmd_vel_arbiter')
            call('emergency_stop', Trigger)  # which is remembered once more
        status.items.clear()
        self.assertTrue(wait_for(lambda: status.last is not None))
        self.assertEqual(status.last.emergency_stop_cause.count('from before a restart'), 1,
                         status.last.emergency_stop_cause)
        self.assertTrue(clear())

    # [EXP-8] [FLT-2]
    def test_an_exploration_goes_on_or_stays_paused_as_it_was(self):
        self.node = self.start('frontier_explorer')
        for on in [True, False]:
            self.switch('set_exploration_enabled', on)
            self.started_again('frontier_explorer')
            self.assertIn('already: nothing changed', call('set_exploration_enabled', SetBool, on).message, '[FLT-2]')

    # [EXP-8] [FLT-2]
    def test_an_exploration_of_a_launch_that_is_over_is_not_taken_up(self):
        self.node = self.start('frontier_explorer')
        self.switch('set_exploration_enabled', True)
        self.started_again('frontier_explorer', signal.SIGINT)
        self.assertIn('already: nothing changed', call('set_exploration_enabled', SetBool, False).message, '[FLT-2]')

    # [EXP-8] [FLT-2]
    def test_an_exploration_of_another_launch_that_was_killed_is_not_taken_up_but_its_pause_is(self):
        self.addCleanup(rospy.delete_param, 'frontier_explorer/autostart')
        for on, is_taken_up in [(False, True), (True, False)]:
            self.node = self.start('frontier_explorer')
            self.switch('set_exploration_enabled', on)
            self.node.signal(signal.SIGKILL)
            self.node.finish()
            self.node = Node('frontier_explorer', '_autostart:=%s' % (not on), starter=ROSLAUNCH)
            self.addCleanup(self.node.end)
            answer = call('set_exploration_enabled', SetBool, on).message
            self.assertEqual(is_taken_up, 'already: nothing changed' in answer, answer + ' [FLT-2]')
            self.node.end()

    # [FLT-2]
    def test_an_avoider_that_was_switched_on_stays_on(self):
        rospy.set_param('obstacle_avoider/enabled', False)
        self.addCleanup(rospy.delete_param, 'obstacle_avoider/enabled')
        status = Record('obstacle_avoider/status', AvoiderStatus)
        self.node = self.start('obstacle_avoider')
        self.assertTrue(wait_for(lambda: status.last is not None and status.last.state == AvoiderStatus.IDLE))
        self.switch('set_obstacle_avoid_enabled', True)
        self.started_again('obstacle_avoider')
        status.items.clear()
        self.assertTrue(wait_for(lambda: status.last is not None))
        self.assertNotEqual(status.last.state, AvoiderStatus.IDLE, '[FLT-2]')

    # [ARB-8] [FLT-2]
    def test_a_goal_that_is_latched_is_old_to_a_node_that_is_started_again(self):
        latched = rospy.Publisher('turtlebot3/goal', PatrolActionGoal, queue_size=1, latch=True)
        self.addCleanup(latched.unregister)
        goal = PatrolActionGoal()
        goal.goal.goal.x, goal.goal.goal.y, goal.goal.goal.z = 3.0, 0.15, 1.0
        latched.publish(goal)
        self.node = self.start('patrol_server')
        self.assertTrue(wait_for(lambda: 'patrol requested' in self.node.said()), 'the first one has not had it')
        for number in (signal.SIGKILL, signal.SIGTERM):
            self.started_again('patrol_server', number)
            self.assertTrue(wait_for(lambda: 'is ignored: it was published before' in self.node.said()), self.node.said())
            self.assertNotIn('patrol requested', self.node.said(), '[ARB-8]')

    # [ARB-8] [FLT-2]
    def test_a_goal_that_is_latched_is_old_also_if_its_publisher_hung_while_the_node_was_started_again(self):
        latcher = subprocess.Popen(['rostopic', 'pub', '-l', 'turtlebot3/goal', 'frontier_pilot/PatrolActionGoal',
                                    '{goal: {goal: {x: 3.0, y: 0.15, z: 1.0}}}'], stdout=subprocess.DEVNULL)
        self.addCleanup(latcher.wait)
        self.addCleanup(latcher.kill)
        self.node = self.start('patrol_server', '__name:=another_server')
        self.assertTrue(wait_for(lambda: 'patrol requested' in self.node.said()), 'the first one has not had it')
        latcher.send_signal(signal.SIGSTOP)
        self.started_again('patrol_server', signal.SIGKILL, '__name:=another_server')
        self.assertTrue(wait_for(lambda: 'but this node is not connected to it' in self.node.said(), 15.0), self.node.said())
        latcher.send_signal(signal.SIGCONT)
        self.assertTrue(wait_for(lambda: 'is ignored: it was published before' in self.node.said()), self.node.said())
        self.assertNotIn('patrol requested', self.node.said(), '[ARB-8]')

    # [FLT-1] [FLT-2]
    def test_a_period_of_the_diagnostics_neither_silences_a_node_nor_keeps_it_from_being_started_again(self):
        words = Record('/diagnostics', DiagnosticArray)
        self.node = self.start('obstacle_avoider')

        def comes(count):
            words.items.clear()
            own = lambda: [word for _, word in words.items if word.status[0].name.startswith('obstacle_avoider: ')]
            return wait_for(lambda: len(own()) >= count)
        self.assertTrue(comes(1))
        rospy.set_param('obstacle_avoider/diagnostic_period', 1e300)
        self.addCleanup(rospy.delete_param, 'obstacle_avoider/diagnostic_period')
        self.assertTrue(comes(3), '[FLT-1]')
        self.started_again('obstacle_avoider')
        self.assertTrue(comes(1), '[FLT-2]')
        self.assertIn('/obstacle_avoider/diagnostic_period is ignored', self.node.said())

    # [FLT-2]
    def test_a_second_node_of_a_name_does_not_start_and_the_first_goes_on(self):
        for executable in ['mapper', 'frontier_explorer', 'navigator']:
            first = self.start(executable)
            master = rosgraph.Master('/test')
            self.assertTrue(wait_for(lambda: '/' + executable in str(master.getSystemState()[0]), 15.0))
            code, said = self.start(executable).finish(20.0)
            self.assertEqual(code, 1, said)
            self.assertIn('/%s is already running' % executable, said)
            code, said = self.start('patrol_client', 'square', '__name:=' + executable).finish(20.0)
            self.assertEqual(code, 2, said)
            self.assertIn('/%s is already running' % executable, said)
            self.assertFalse(first.has_ended(), '[FLT-2]')
            first.end()


if __name__ == '__main__':
    use_a_home_of_its_own()
    rospy.init_node('respawn_test')
    rostest.rosrun('frontier_pilot', 'respawn', Respawn)
