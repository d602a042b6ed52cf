#!/usr/bin/env python3
"""How an arbiter starts and ends: configurations, the required source, and its last words."""
import contextlib
import os
import resource
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rosnode
import rospkg
import rospy
import rostest
import yaml
from frontier_pilot.msg import ArbiterStatus
from geometry_msgs.msg import Twist
from std_srvs.srv import SetBool, Trigger

from wire import SANITIZED, Node, Record, Source, call, find_node, free_port, moves, twist, wait_for


def let_no_file_grow():
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))


class ArbiterLife(unittest.TestCase):
    def arbiter(self, namespace, *arguments):
        node = Node('cmd_vel_arbiter', '__ns:=' + namespace, *arguments)
        self.addCleanup(node.end)
        return node

    # [ARB-11]
    def test_the_last_words_are_zeros_on_sigint_sigterm_and_rosnode_kill(self):
        def kill(node, name):
            self.assertEqual(rosnode.kill_nodes([name]), ([name], []))

        ways = [lambda node, name: node.signal(signal.SIGINT), lambda node, name: node.signal(signal.SIGTERM), kill]
        for number, end in enumerate(ways):
            namespace = '/last_words_%d' % number
            out = Record(namespace + '/cmd_vel', Twist)
            node = self.arbiter(namespace)
            nav = Source(namespace + '/cmd_vel_nav', 200.0).connect().start(0.1)
            self.assertTrue(wait_for(lambda: out.last is not None and moves(out.last)))
            end(node, namespace + '/cmd_vel_arbiter')
            code, said = node.finish()
            self.assertEqual(code, 0, said)
            nav.close()
            self.assertTrue(wait_for(lambda: not moves(out.last), 2.0), '[ARB-11]')

    # [ARB-7] [FLT-1]
    def test_stops_are_answered_although_nobody_reads_what_the_arbiter_says(self):
        node = self.arbiter('/unread')  # through a pipe, as with "roslaunch ... | less" or a terminal that is stopped
        stop, clear = '/unread/emergency_stop', '/unread/set_emergency_stop'
        rospy.wait_for_service(stop, 20.0)
        pipe = os.open('/proc/%d/fd/1' % node.process.pid, os.O_WRONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, pipe)
        with self.assertRaises(BlockingIOError):
            while True:
                os.write(pipe, b'x' * 512)
        answers = []

        def stop_and_clear():
            for _ in range(30):  # which says more than the 4 kB that stdout keeps before it writes to a pipe
                answers.append(call(stop, Trigger).success)
                answers.append(call(clear, SetBool, False).success)
        threading.Thread(target=stop_and_clear, daemon=True).start()
        self.assertTrue(wait_for(lambda: len(answers) == 60, 30.0), '[ARB-7]')
        self.assertTrue(all(answers))

    # [ARB-12] [FLT-1]
    @unittest.skipIf(SANITIZED, 'the sanitizer itself opens pipes, to look at memory')
    def test_it_stands_while_it_has_no_descriptor_left_for_a_caller_of_a_stop(self):
        out, status = Record('/full/cmd_vel', Twist), Record('/full/cmd_vel_arbiter/status', ArbiterStatus)
        node = self.arbiter('/full')
        nav = Source('/full/cmd_vel_nav', 50.0).connect().start(0.1)
        self.addCleanup(nav.close)
        self.assertTrue(wait_for(lambda: out.last is not None and moves(out.last)))
        few = len(os.listdir('/proc/%d/fd' % node.process.pid)) + 20
        _, most = resource.prlimit(node.process.pid, resource.RLIMIT_NOFILE)
        resource.prlimit(node.process.pid, resource.RLIMIT_NOFILE, (few, most))
        port = int(rosgraph.Master('/test').lookupService('/full/emergency_stop').rsplit(':', 1)[1])
        with contextlib.ExitStack() as idle:
            for _ in range(20):
                idle.enter_context(socket.create_connection(('127.0.0.1', port), 5.0))
            self.assertTrue(wait_for(lambda: status.last.state == ArbiterStatus.UNREACHABLE, 5.0), status.last)
            self.assertTrue(wait_for(lambda: not moves(out.last), 1.0))
            self.assertFalse(wait_for(lambda: moves(out.last), 1.0), 'nav commands motion all the time')
            self.assertIn('no emergency stop can be called', '; '.join(status.last.problems))
        self.assertTrue(wait_for(lambda: moves(out.last), 10.0), 'the connections are closed')
        self.assertTrue(call('/full/emergency_stop', Trigger).success)
        self.assertTrue(wait_for(lambda: not moves(out.last), 1.0))

    # [FLT-1]
    @unittest.skipIf(SANITIZED, 'the reports of the sanitizer are files that grow')
    def test_a_log_file_that_may_not_grow_does_not_end_the_arbiter(self):
        with tempfile.TemporaryFile() as log:
            path = find_node('frontier_pilot', 'cmd_vel_arbiter')
            arbiter = subprocess.Popen([path, '__ns:=/unwritable'], stdout=log, stderr=log, preexec_fn=let_no_file_grow)
            self.addCleanup(arbiter.wait)
            self.addCleanup(arbiter.terminate)
            for _ in range(3):  # a second time the latch cannot be kept, which the arbiter warns of
                self.assertTrue(call('/unwritable/emergency_stop', Trigger).success, '[ARB-7]')
                call('/unwritable/set_emergency_stop', SetBool, False)
            self.assertIsNone(arbiter.poll(), '[FLT-1]')

    # [ARB-4]
    def test_without_the_required_avoider_the_lower_sources_turn_and_reverse_only(self):
        path = rospkg.RosPack().get_path('frontier_pilot') + '/config/arbiter_avoid_required.yaml'
        with open(path) as file:
            configuration = file.read()
        rospy.set_param('/required/cmd_vel_arbiter', yaml.safe_load(configuration))
        out = Record('/required/cmd_vel', Twist)
        status = Record('/required/cmd_vel_arbiter/status', ArbiterStatus)
        self.arbiter('/required')
        nav = Source('/required/cmd_vel_nav').connect().start(0.1, 0.5)
        self.assertTrue(wait_for(lambda: out.last is not None and out.last.angular.z == 0.5))
        self.assertEqual(out.last.linear.x, 0.0, 'no forward motion [ARB-4]')
        self.assertTrue(wait_for(lambda: status.last.missing_sources == ['avoid']), '[ARB-4]')
        self.assertTrue(any('avoid is required but silent' in text for text in status.last.problems))
        nav.start(-0.1)
        self.assertTrue(wait_for(lambda: out.last.linear.x == -0.1), 'reversing is free [ARB-4]')
        nav.start(0.1)
        avoid = Source('/required/cmd_vel_avoid').connect().start(0.0)
        self.assertTrue(wait_for(lambda: out.last.linear.x == 0.1), 'the heartbeat frees forward motion [ARB-4]')
        silent = time.monotonic()
        avoid.stop()
        self.assertTrue(wait_for(lambda: out.last.linear.x == 0.0, 3.0), '[ARB-4]')
        self.assertGreater(time.monotonic() - silent, 0.7)
        nav.close()
        avoid.close()

    # [ARB-1]
    def test_a_bad_configuration_is_refused_with_every_problem_named(self):
        rospy.set_param('/refused/cmd_vel_arbiter', {'surces': 1, 'sources': [
            {'name': 'nav', 'timeout': -1.0}, {'name': 'joy', 'topic': 'joy', 'priority': 60}]})
        code, said = self.arbiter('/refused').finish()
        self.assertNotEqual(code, 0, said)
        for text in ['sources[0]/timeout', 'sources[1]/priority', 'surces']:
            self.assertIn(text, said, '[ARB-1]')

    # [ARB-1] [ARB-2]
    def test_a_source_whose_topic_is_the_arbiters_own_output_by_another_name_is_refused(self):
        for i, (topic, arguments) in enumerate([
                ('//output/%d/cmd_vel', []), ('cmd_vel/', []), ('/base/%d', ['cmd_vel:=/base/%d']), ('joy', ['joy:=cmd_vel']),
                ('emergency_stop_state', []), ('cmd_vel_arbiter/status', [])]):
            topic, arguments = topic.replace('%d', str(i)), [word.replace('%d', str(i)) for word in arguments]
            rospy.set_param('/output/%d/cmd_vel_arbiter' % i, {'sources': [{'name': 'joy', 'topic': topic, 'priority': 30}]})
            code, said = self.arbiter('/output/%d' % i, *arguments).finish()
            self.assertEqual(code, 2, said)
            self.assertIn("sources[0]/topic: '%s' is what the arbiter itself publishes" % topic, said, '[ARB-1]')

    # [ARB-1]
    def test_topics_that_are_no_names_and_topics_of_two_sources_are_refused_by_parameter(self):
        rospy.set_param('/topics/cmd_vel_arbiter', {'sources': [
            {'name': 'manual', 'topic': 'a b'}, {'name': 'nav', 'topic': '~x'}, {'name': 'joy', 'topic': 'joy', 'priority': 1},
            {'name': 'pad', 'topic': '/topics//joy', 'priority': 2}], 'fleet_stop_status': 'c d'})
        code, said = self.arbiter('/topics').finish()
        self.assertEqual(code, 2, said)
        for text in ["sources[0]/topic: 'a b' is not a name of ROS", "sources[1]/topic: '~x' is not a name of ROS",
                     "sources[3]/topic: '/topics//joy' belongs to 'joy' already", "fleet_stop_status: 'c d' is not a name of ROS"]:
            self.assertIn(text, said, '[ARB-1]')

    # [ARB-6] [ARB-8]
    def test_a_latched_command_that_is_delivered_again_does_not_drive(self):
        out = Record('/latched/cmd_vel', Twist)
        node = self.arbiter('/latched')
        self.assertTrue(wait_for(lambda: out.last is not None))
        time.sleep(2.5)  # a new arbiter takes latched commands for old ones
        latched = rospy.Publisher('/latched/cmd_vel_manual', Twist, queue_size=1, latch=True)
        self.addCleanup(latched.unregister)
        latched.publish(twist(angular=0.5))
        self.assertTrue(wait_for(lambda: moves(out.last)), 'as by rostopic pub')
        self.assertTrue(call('/latched/emergency_stop', Trigger).success)
        self.assertTrue(wait_for(lambda: call('/latched/set_emergency_stop', SetBool, False).success))
        start = time.monotonic()
        slave = xmlrpc.client.ServerProxy(rosgraph.Master('/test').lookupNode('/latched/cmd_vel_arbiter'))
        slave.publisherUpdate('/master', '/latched/cmd_vel_manual', [])  # as if the connection had been reset
        self.assertTrue(wait_for(lambda: latched.get_num_connections() == 0))
        self.assertTrue(wait_for(lambda: latched.get_num_connections() > 0, 20.0), '[FLT-1]')
        self.assertFalse(wait_for(lambda: any(map(moves, out.since(start))), 2.0), '[ARB-8]')
        latched.publish(twist(angular=0.4))
        self.assertTrue(wait_for(lambda: out.last.angular.z == 0.4), 'a new one does')
        node.signal(signal.SIGKILL)
        node.finish()
        self.assertTrue(wait_for(lambda: not moves(out.last) or time.monotonic() > out.items[-1][0] + 1.0))
        start = time.monotonic()
        second = self.arbiter('/latched')
        self.assertTrue(wait_for(lambda: 'was published before' in second.said(), 20.0), 'an arbiter that is started again')
        self.assertTrue(wait_for(lambda: len(out.since(start)) > 40))
        self.assertFalse(any(map(moves, out.since(start))), '[ARB-6]')

    # [FLT-1]
    def test_no_call_of_the_slave_api_that_roscpp_cannot_take_ends_the_arbiter(self):
        node = self.arbiter('/called')
        rospy.wait_for_service('/called/emergency_stop', 20.0)
        slave = xmlrpc.client.ServerProxy(rosgraph.Master('/test').lookupNode('/called/cmd_vel_arbiter'))
        self.assertEqual(slave.system.multicall([{'methodName': 'system.multicall', 'params': [[]]}])[0], 0)
        datagrams = [['UDPROS', b'', '127.0.0.1', 9, 8]]
        self.assertEqual(slave.requestTopic('/test', '/called/cmd_vel', datagrams)[0], 0)
        over_tcp = slave.requestTopic('/test', '/called/cmd_vel', datagrams + [['TCPROS']])
        self.assertEqual([over_tcp[0], over_tcp[2][0]], [1, 'TCPROS'])
        self.assertEqual(slave.requestTopic('/test', '/nobodys', [['TCPROS']])[0], 0)
        self.assertEqual(slave.shutdown('/test')[0], 0, 'without a reason')
        killed = '[/mapper] Reason: new node registered with same name'
        self.assertEqual(slave.shutdown('/master', killed)[0], 0, 'for a process that had the same port')
        self.assertFalse(wait_for(node.has_ended, 1.0), '[FLT-1]')
        self.assertTrue(call('/called/emergency_stop', Trigger).success)

    # [ARB-7]
    def test_two_arbiters_of_two_robots_have_latches_of_their_own(self):
        for robot in ['/one', '/two']:
            self.arbiter(robot)
        states = {robot: Record(robot + '/cmd_vel_arbiter/status', ArbiterStatus) for robot in ['/one', '/two']}
        self.assertTrue(wait_for(lambda: all(state.last for state in states.values())))
        call('/one/emergency_stop', Trigger)
        self.assertTrue(wait_for(lambda: states['/one'].last.emergency_stop))
        self.assertFalse(states['/two'].last.emergency_stop)

    # [ARB-12]
    def test_of_arbiters_that_start_at_the_same_moment_one_stays_and_none_of_their_stops_is_lost(self):
        for names in [['b', 'a', 'c'], ['a', 'b', 'c'], ['c', 'b', 'a'], ['two', 'one']]:
            namespace = '/at_once_' + '_'.join(names)
            status = Record(namespace + '/cmd_vel_arbiter/status', ArbiterStatus)
            nodes = [self.arbiter(namespace, '__name:=' + name) for name in names]
            said = call(namespace + '/emergency_stop', Trigger).message
            self.assertTrue(wait_for(lambda: sum(node.has_ended() for node in nodes) == len(nodes) - 1, 5.0),
                            'all but one [ARB-12]')
            for node in nodes:
                if node.has_ended():
                    code, why = node.finish()
                    self.assertEqual(code, 1, why)
                    self.assertIn('is already the arbiter of this namespace', why)
            status.items.clear()
            self.assertTrue(wait_for(lambda: status.last is not None))
            self.assertTrue(status.last.emergency_stop, said + ' [ARB-12]')
            self.assertTrue(wait_for(lambda: call(namespace + '/set_emergency_stop', SetBool, False).success))
            self.assertTrue(wait_for(lambda: status.last.state == ArbiterStatus.IDLE, 3.0), 'uncontested [ARB-12]')
            self.assertFalse(wait_for(lambda: all(node.has_ended() for node in nodes), 1.0), 'and it stays')

    # [ARB-12] somebody who plays a recorded run, for instance
    def test_a_stranger_that_publishes_an_arbiters_status_keeps_none_from_starting(self):
        stranger = rospy.Publisher('/played/cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        self.addCleanup(stranger.unregister)
        node = self.arbiter('/played')
        self.assertIn('/played', call('/played/emergency_stop', Trigger).message)
        self.assertFalse(wait_for(node.has_ended, 1.0), '[ARB-12]')
        second = self.arbiter('/played', '__name:=second')
        self.assertTrue(wait_for(second.has_ended, 10.0), 'beside an arbiter none starts [ARB-12]')
        self.assertIn('is already the arbiter of this namespace', second.finish()[1])

    # [ARB-12]
    def test_an_arbiter_that_is_only_registered_any_more_ends_nobody(self):
        ghost = rosgraph.Master('/haunted/a_ghost')
        uri = 'http://127.0.0.1:%d/' % free_port()
        ghost.registerPublisher('/haunted/cmd_vel_arbiter/status', ArbiterStatus._type, uri)
        ghost.registerService('/haunted/emergency_stop', uri.replace('http', 'rosrpc'), uri)
        status = Record('/haunted/cmd_vel_arbiter/status', ArbiterStatus)
        node = self.arbiter('/haunted')
        self.assertTrue(wait_for(lambda: status.last is not None and status.last.state == ArbiterStatus.IDLE))
        self.assertFalse(wait_for(node.has_ended, 2.0), '[ARB-12]')


if __name__ == '__main__':
    rospy.init_node('arbiter_life_test')
    rostest.rosrun('frontier_pilot', 'arbiter_life', ArbiterLife)
