#!/usr/bin/env python3
"""Nodes whose registration at the master is lost register again: a new master, a second node that took their services."""
import glob
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
import xmlrpc.client
from collections import namedtuple
from xmlrpc.server import SimpleXMLRPCServer

import rosbag
import roslib.packages
import rosgraph
import rospy
import rostest

from wire import Stranger, free_port, time_until, use_a_home_of_its_own, wait_for

Answer = namedtuple('Answer', 'success message')

OFFERS = """
from std_srvs.srv import Trigger
service = rospy.Service('%s', Trigger, lambda _: (True, ''))
"""


class Registration(unittest.TestCase):
    """The nodes here have a master of their own, which is killed and comes back empty."""

    def setUp(self):
        self.uri = 'http://127.0.0.1:%d' % free_port()
        self.environment = dict(os.environ, ROS_MASTER_URI=self.uri)
        self.processes = []
        self.master = self.new_master()

    def tearDown(self):
        for process in reversed(self.processes):
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
        for process in reversed(self.processes):
            try:
                process.wait(10.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def new_master(self):
        process = subprocess.Popen(['rosmaster', '--core', '-p', self.uri.rsplit(':', 1)[1]],
                                   env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.processes.append(process)
        self.assertTrue(wait_for(lambda: self.state() is not None, 15.0))
        return process

    def replace_master(self):
        self.master.kill()
        self.master.wait()
        self.master = self.new_master()

    def stopped_arbiter_at_a_new_master(self):
        arbiter = self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.assertTrue(self.call('/emergency_stop').success)
        self.replace_master()
        return arbiter

    def node(self, executable, *arguments):
        path = roslib.packages.find_node('frontier_pilot', executable)[0]
        process = subprocess.Popen([path, *arguments], env=self.environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.processes.append(process)
        return process

    def is_connected(self, node, topic):
        """Whether that node has a connection for that topic."""
        try:
            uri = rosgraph.Master('/test', master_uri=self.uri).lookupNode(node)
            return topic in {words[4] for words in xmlrpc.client.ServerProxy(uri).getBusInfo('/test')[2]}
        except (OSError, rosgraph.MasterException):
            return False

    def state(self):
        try:
            return rosgraph.Master('/test', master_uri=self.uri).getSystemState()
        except (OSError, rosgraph.MasterException):
            return None

    def stop_is_stored_for(self, session):
        home = os.environ.get('ROS_HOME', os.path.expanduser('~/.ros'))
        return bool(glob.glob(os.path.join(home, 'frontier_pilot', session + '-*', 'stopped.emergency_stop~*')))

    def call(self, service, *arguments):
        """The answer of a service at the master of this test, as a line that rosservice prints."""
        done = subprocess.run(['rosservice', 'call', service, *arguments], env=self.environment, capture_output=True,
                              text=True, timeout=20.0)
        return Answer('success: True' in done.stdout, done.stdout + done.stderr)

    def services(self):
        state = self.state()
        return {name: nodes for name, nodes in state[2]} if state else {}

    # [ARB-12]
    def test_the_stop_is_registered_again_within_2_s_of_a_new_master(self):
        self.node('cmd_vel_arbiter')

        def is_registered():
            return {'/emergency_stop', '/set_nav_enabled'} <= set(self.services())
        self.assertTrue(wait_for(is_registered, 20.0))
        took = []
        for _ in range(3):  # the best counts: the machine may be busy
            self.replace_master()
            took.append(time_until(is_registered))
        self.assertLess(min(took), 2.0, '[ARB-12]')

    # [ARB-12] [FLT-1]
    def test_every_node_is_registered_again_at_a_new_master(self):
        wanted = {'/emergency_stop': 'cmd_vel_arbiter', '/set_nav_enabled': 'cmd_vel_arbiter',
                  '/set_obstacle_avoid_enabled': 'obstacle_avoider', '/mapper/reset': 'mapper',
                  '/make_plan': 'navigator', '/set_exploration_enabled': 'frontier_explorer'}
        for node in sorted(set(wanted.values())) + ['patrol_server', 'behavior_server']:
            self.node(node)
        self.assertTrue(wait_for(lambda: set(wanted) <= set(self.services()), 20.0))
        self.replace_master()
        self.assertTrue(wait_for(lambda: set(wanted) <= set(self.services()), 20.0), '[FLT-1]')
        for service, node in wanted.items():
            self.assertEqual(self.services()[service], ['/' + node])

        def known(part, topic):
            return [node for name, nodes in self.state()[part] if name == topic for node in nodes]
        self.assertTrue(wait_for(lambda: known(0, '/cmd_vel') == ['/cmd_vel_arbiter']), '[ARB-12]')
        self.assertTrue(wait_for(lambda: known(1, '/cmd_vel_nav') == ['/cmd_vel_arbiter']), '[ARB-12]')
        self.assertTrue(wait_for(lambda: '/patrol_server' in known(1, '/turtlebot3/goal')), '[FLT-1]')

    # [REC-1] [FLT-1]
    def test_the_recorder_records_what_begins_after_a_new_master(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        recorder = self.node('run_recorder', '_folder:=' + folder.name, '_period:=0.5', '_min_space:=1')
        topic = '/obstacle_avoider/status'

        def are_known():
            state = self.state()
            return bool(state) and {'/run_recorder', '/run_recorder_rosbag'} <= {
                node for name, nodes in state[1] + state[0] if name in (topic, '/run_recorder/load') for node in nodes}
        self.assertTrue(wait_for(are_known, 30.0))
        self.processes.append(subprocess.Popen(['rostopic', 'pub', '-r', '10', '/odom', 'nav_msgs/Odometry', '{}'], env=self.environment,
                                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        self.assertTrue(wait_for(lambda: self.is_connected('/run_recorder_rosbag', '/odom'), 20.0))
        time.sleep(1.0)  # it has looked once where rosbag is
        self.replace_master()
        self.assertTrue(wait_for(are_known, 15.0))
        known = time.time()
        self.node('obstacle_avoider')
        self.assertTrue(wait_for(lambda: self.is_connected('/run_recorder_rosbag', topic), 20.0))
        time.sleep(1.5)  # in which it says more than one status
        recorder.send_signal(signal.SIGINT)
        recorder.wait(30.0)
        recorded = set()
        for part in glob.glob(folder.name + '/*/*.bag'):
            with rosbag.Bag(part) as bag:
                recorded |= {name for name, _, at in bag.read_messages(topics=[topic, '/odom']) if at.to_sec() > known}
        self.assertEqual(recorded, {topic, '/odom'}, 'and what was connected, although the new master does not know its publisher')

    # [ARB-7] [ARB-12]
    def test_a_stop_that_has_outlived_its_master_is_remembered_under_the_new_one(self):
        arbiter = self.stopped_arbiter_at_a_new_master()
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 10.0), '[ARB-12]')
        # Once the stop is stored for the new session an arbiter that is killed comes up with it.
        self.assertTrue(wait_for(lambda: self.stop_is_stored_for('master-%d' % self.processes[-1].pid)), '[ARB-7]')
        arbiter.kill()
        arbiter.wait()
        self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: 'stopped already' in self.call('/emergency_stop').message, 20.0))

    # [ARB-7] [FLT-2]
    def test_a_stop_outlives_a_master_and_an_arbiter_that_die_together(self):
        arbiter = self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.assertTrue(self.call('/emergency_stop').success)
        self.master.kill()
        self.master.wait()
        arbiter.kill()
        arbiter.wait()
        self.node('cmd_vel_arbiter')  # which waits for the master
        time.sleep(1.0)  # the arbiter that roslaunch starts again is there before somebody starts a master
        self.new_master()
        self.assertTrue(wait_for(lambda: 'stopped already' in self.call('/emergency_stop').message, 20.0), '[ARB-7]')

    # [ARB-7]
    def test_a_stop_is_remembered_though_the_name_of_the_session_is_deleted(self):
        server = rosgraph.Master('/test', master_uri=self.uri)
        server.setParam('/run_id', 'first')
        arbiter = self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.assertTrue(self.call('/emergency_stop').success)
        server.deleteParam('/run_id')
        arbiter.kill()
        arbiter.wait()
        self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: 'stopped already' in self.call('/emergency_stop').message, 20.0), '[ARB-7]')

    # [FLT-1] [FLT-2]
    def test_a_new_master_gets_the_parameters_of_the_nodes_again(self):
        server = rosgraph.Master('/test', master_uri=self.uri)
        server.setParam('/use_sim_time', True)
        server.setParam('/cmd_vel_arbiter', {'limits': {'max_linear': 0.17}})
        self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.replace_master()
        self.assertTrue(wait_for(lambda: server.hasParam('/cmd_vel_arbiter/limits/max_linear'), 10.0), '[FLT-2]')
        self.assertEqual(server.getParam('/cmd_vel_arbiter'), {'limits': {'max_linear': 0.17}})
        self.assertTrue(wait_for(lambda: server.hasParam('/use_sim_time') and server.getParam('/use_sim_time')))

    # [FLT-1] [FLT-2]
    def test_a_new_master_gets_what_was_changed_while_the_node_ran_and_the_service_that_changes_it(self):
        server = rosgraph.Master('/test', master_uri=self.uri)
        server.setParam('/cmd_vel_arbiter', {'limits': {'max_linear': 0.17, 'max_angular': 2.0}})
        self.node('cmd_vel_arbiter')
        service = '/cmd_vel_arbiter/set_parameters'
        self.assertTrue(wait_for(lambda: service in self.services(), 20.0))
        change = ['rosservice', 'call', service, 'config: {doubles: [{name: limits/max_angular, value: %s}]}']
        subprocess.run(change[:3] + [change[3] % 1.5], env=self.environment, stdout=subprocess.DEVNULL, check=True, timeout=20.0)
        self.assertTrue(wait_for(lambda: server.getParam('/cmd_vel_arbiter/limits/max_angular') == 1.5, 5.0))
        self.replace_master()
        self.assertTrue(wait_for(lambda: service in self.services(), 10.0), '[FLT-1]')
        expected = {'limits': {'max_linear': 0.17, 'max_angular': 1.5}}
        self.assertTrue(wait_for(lambda: server.hasParam('/cmd_vel_arbiter/limits/max_linear')
                                 and server.getParam('/cmd_vel_arbiter') == expected, 10.0), '[FLT-2]')
        subprocess.run(change[:3] + [change[3] % 1.0], env=self.environment, stdout=subprocess.DEVNULL, check=True, timeout=20.0)
        self.assertTrue(wait_for(lambda: server.getParam('/cmd_vel_arbiter/limits/max_angular') == 1.0, 5.0))

    # [FLT-1] [FLT-2]
    def test_a_node_that_died_together_with_the_master_gets_its_parameters_and_its_clock_again(self):
        server = rosgraph.Master('/test', master_uri=self.uri)
        server.setParam('/use_sim_time', True)
        server.setParam('/cmd_vel_arbiter', {'limits': {'max_linear': 0.17}})
        log = '__log:=/dev/null'  # as roslaunch gives one
        arbiter = self.node('cmd_vel_arbiter', log)
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.master.kill()
        arbiter.kill()
        arbiter.wait()
        self.master.wait()
        arbiter = self.node('cmd_vel_arbiter', log)  # waits for the master
        self.new_master()
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.assertEqual(server.getParam('/cmd_vel_arbiter'), {'limits': {'max_linear': 0.17}}, '[FLT-2]')
        self.assertTrue(server.getParam('/use_sim_time'), '[FLT-2]')
        subscribed = [topic for topic, nodes in self.state()[1] if '/cmd_vel_arbiter' in nodes]
        self.assertIn('/clock', subscribed, 'it follows the clock of the simulation')
        server.deleteParam('/cmd_vel_arbiter')
        before = server.lookupService('/emergency_stop')
        arbiter.kill()
        arbiter.wait()
        self.node('cmd_vel_arbiter', log)

        def is_another():
            try:
                return server.lookupService('/emergency_stop') != before
            except rosgraph.MasterException:
                return False
        self.assertTrue(wait_for(is_another, 20.0))
        self.assertFalse(server.hasParam('/cmd_vel_arbiter'), 'the same master: somebody wanted the defaults')

    # [FLT-1] [FLT-2]
    def test_a_node_that_is_started_by_hand_at_a_new_master_has_no_parameters_of_a_dead_one(self):
        server = rosgraph.Master('/test', master_uri=self.uri)
        server.setParam('/cmd_vel_arbiter', {'limits': {'max_linear': 0.17}})
        arbiter = self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        arbiter.kill()
        arbiter.wait()
        self.replace_master()
        self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.assertFalse(server.hasParam('/cmd_vel_arbiter'))

    # [FLT-1]
    def test_a_node_ends_although_the_master_hangs(self):
        arbiter = self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        self.master.send_signal(signal.SIGSTOP)
        self.addCleanup(self.master.send_signal, signal.SIGCONT)
        arbiter.send_signal(signal.SIGTERM)
        arbiter.wait(15.0)

    # [ARB-12] [FLT-1]
    def test_a_service_whose_calls_the_master_sends_elsewhere_is_taken_back(self):
        self.node('cmd_vel_arbiter')
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 20.0))
        server = rosgraph.Master('/cmd_vel_arbiter', master_uri=self.uri)
        own = server.lookupService('/emergency_stop')
        stranger = 'rosrpc://127.0.0.1:%d' % free_port()
        server.registerService('/emergency_stop', stranger, server.lookupNode('/cmd_vel_arbiter'))
        self.assertEqual(server.lookupService('/emergency_stop'), stranger)
        self.assertTrue(wait_for(lambda: server.lookupService('/emergency_stop') == own), '[ARB-12]')

    # [FLT-2]
    def test_a_second_copy_does_not_start_at_a_new_master_that_does_not_know_the_first_yet(self):
        first = self.stopped_arbiter_at_a_new_master()
        path = roslib.packages.find_node('frontier_pilot', 'cmd_vel_arbiter')[0]
        second = subprocess.run([path], env=self.environment, capture_output=True, text=True, timeout=20.0)
        self.assertEqual(second.returncode, 1)
        self.assertIn('/cmd_vel_arbiter is already running as process %d' % first.pid, second.stderr)
        self.assertIsNone(first.poll())
        self.assertTrue(wait_for(lambda: '/emergency_stop' in self.services(), 10.0))

    # [FLT-2]
    def test_a_node_whose_name_another_process_has_at_a_new_master_ends_and_does_not_end_that_one(self):
        old = self.node('obstacle_avoider')
        service = '/set_obstacle_avoid_enabled'
        # A node that answers has registered everything: what it still had to register would go to the new master.
        self.assertTrue(wait_for(lambda: service in self.services() and self.call(service, 'false').success, 20.0))
        old.send_signal(signal.SIGSTOP)  # so that it is not registered first
        self.master.kill()
        self.master.wait()
        told_to_end = []
        with SimpleXMLRPCServer(('127.0.0.1', 0), logRequests=False) as namesake:
            namesake.register_function(lambda *told: told_to_end.append(told) or [1, '', 0], 'shutdown')
            namesake.register_function(lambda *_: [1, '', os.getpid()], 'getPid')
            threading.Thread(target=namesake.serve_forever, daemon=True).start()
            address = 'http://127.0.0.1:%d/' % namesake.server_address[1]
            self.new_master()
            rosgraph.Master('/obstacle_avoider', master_uri=self.uri).registerPublisher('/new', 'std_msgs/Empty', address)
            old.send_signal(signal.SIGCONT)
            self.assertTrue(wait_for(lambda: old.poll() is not None, 15.0))
            self.assertEqual(rosgraph.Master('/test', master_uri=self.uri).lookupNode('/obstacle_avoider'), address)
            namesake.shutdown()
        self.assertEqual(told_to_end, [])

    # [FLT-1]
    def test_a_service_that_a_second_node_took_and_left_is_offered_again(self):
        service = '/waypoint_follower/clear'
        self.node('waypoint_follower')
        self.assertTrue(wait_for(lambda: service in self.services(), 20.0))
        second = Stranger(self, 'second', OFFERS % service, self.environment)  # a second node of ours does not start
        self.assertTrue(wait_for(lambda: self.services()[service] == ['/second'], 20.0), self.services().get(service))
        second.end()
        self.assertTrue(wait_for(lambda: self.services().get(service) == ['/waypoint_follower'], 10.0), '[FLT-1]')

    # [FLT-1]
    def test_a_subscriber_that_a_forged_message_disconnects_from_its_publisher_is_connected_again(self):
        self.node('obstacle_avoider')
        self.node('cmd_vel_arbiter')
        topic = '/cmd_vel_avoid'

        def uri_of(node):
            return rosgraph.Master('/test', master_uri=self.uri).lookupNode(node)

        def connections():
            """The addresses of the publishers that the arbiter is connected to; None before it is there."""
            try:
                words = xmlrpc.client.ServerProxy(uri_of('/cmd_vel_arbiter')).getBusInfo('/test')[2]
            except (OSError, rosgraph.MasterException):
                return None
            return [uri for _, uri, direction, _, name, *_ in words if direction == 'i' and name == topic]
        self.assertTrue(wait_for(lambda: len(connections() or []) == 1, 20.0))
        for forged in [[], ['http://127.0.0.1:%d/' % free_port()]]:
            arbiter = xmlrpc.client.ServerProxy(uri_of('/cmd_vel_arbiter'))
            arbiter.publisherUpdate('/master', topic, forged)
            self.assertTrue(wait_for(lambda: connections() == []))
            self.assertTrue(wait_for(lambda: connections() == [uri_of('/obstacle_avoider')], 20.0), '[FLT-1]')


if __name__ == '__main__':
    use_a_home_of_its_own()
    rospy.init_node('registration_test')
    rostest.rosrun('frontier_pilot', 'registration', Registration)
