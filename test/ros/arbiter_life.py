#!/usr/bin/env python3
"""How an arbiter starts and ends: configurations, the required source, and its last words."""
import signal
import time
import unittest

import rospkg
import rospy
import rostest
import yaml
from frontier_pilot.msg import ArbiterStatus
from geometry_msgs.msg import Twist
from std_srvs.srv import Trigger

from wire import Node, Record, Source, call, moves, wait_for


class ArbiterLife(unittest.TestCase):
    def arbiter(self, namespace, *arguments):
        node = Node('cmd_vel_arbiter', '__ns:=' + namespace, *arguments)
        self.addCleanup(node.end)
        return node

    # [ARB-11]
    def test_the_last_words_are_zeros_on_sigint_and_sigterm(self):
        for number in [signal.SIGINT, signal.SIGTERM]:
            namespace = '/last_words_%d' % number
            out = Record(namespace + '/cmd_vel', Twist)
            node = self.arbiter(namespace)
            nav = Source(namespace + '/cmd_vel_nav', 200.0).connect().start(0.1)
            self.assertTrue(wait_for(lambda: out.last is not None and moves(out.last)))
            node.signal(number)
            code, said = node.finish()
            self.assertEqual(code, 0, said)
            nav.close()
            self.assertTrue(wait_for(lambda: not moves(out.last), 2.0), '[ARB-11]')

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

    # [ARB-7]
    def test_two_arbiters_of_two_robots_have_latches_of_their_own(self):
        for robot in ['/one', '/two']:
            self.arbiter(robot)
        states = {robot: Record(robot + '/cmd_vel_arbiter/status', ArbiterStatus) for robot in ['/one', '/two']}
        self.assertTrue(wait_for(lambda: all(state.last for state in states.values())))
        call('/one/emergency_stop', Trigger)
        self.assertTrue(wait_for(lambda: states['/one'].last.emergency_stop))
        self.assertFalse(states['/two'].last.emergency_stop)


if __name__ == '__main__':
    rospy.init_node('arbiter_life_test')
    rostest.rosrun('frontier_pilot', 'arbiter_life', ArbiterLife)
