#!/usr/bin/env python3
"""A stop and the switches belong to the arbiters of a namespace: whoever arbitrates next there finds them."""
import signal
import unittest

import rosgraph
import rospy
import rostest
from frontier_pilot.msg import ArbiterStatus
from std_srvs.srv import SetBool, Trigger

from wire import Node, Record, call, wait_for


class ArbiterHandover(unittest.TestCase):
    def arbiter(self, namespace, name='cmd_vel_arbiter'):
        """One that arbitrates, and its status."""
        status = Record(namespace + '/cmd_vel_arbiter/status', ArbiterStatus)
        node = Node('cmd_vel_arbiter', '__ns:=' + namespace, '__name:=' + name)
        self.addCleanup(node.end)
        own = namespace + '/' + name
        self.assertTrue(wait_for(lambda: self.latest(status, own) is not None, 15.0), node.said())
        return node, lambda: self.latest(status, own)

    def latest(self, status, node):
        return next((message for _, message in reversed(status.items) if
                     message._connection_header['callerid'] == node), None)

    def kill(self, node, number=signal.SIGKILL):
        node.signal(number)
        node.finish()

    def clear(self, namespace):
        return wait_for(lambda: call(namespace + '/set_emergency_stop', SetBool, False).success, 5.0)

    def forget(self, namespace):
        """The master knows nothing of the arbiter of this namespace, until that is registered again."""
        name = namespace + '/cmd_vel_arbiter'
        master = rosgraph.Master(name)
        for service in ['emergency_stop', 'set_emergency_stop']:
            master.unregisterService(namespace + '/' + service, master.lookupService(namespace + '/' + service))
        master.unregisterPublisher(namespace + '/cmd_vel_arbiter/status', master.lookupNode(name))

    def two_at_once(self, namespace):
        """Two that live: while the second starts the master knows nothing of the first."""
        first, first_says = self.arbiter(namespace)
        for last in (False, False, True):
            self.forget(namespace)
            try:
                second, second_says = self.arbiter(namespace, 'other')
                break
            except AssertionError:  # on a busy computer the first was registered again before the second had looked
                if last:
                    raise
        self.assertTrue(wait_for(lambda: first_says().state == ArbiterStatus.CONTESTED))
        self.assertTrue(wait_for(lambda: second_says().state == ArbiterStatus.CONTESTED))
        return first, first_says, second, second_says

    # [ARB-7] [ARB-12]
    def test_a_stop_holds_for_whoever_arbitrates_next_however_the_one_that_answered_it_ended(self):
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGKILL]:
            namespace = '/handover_%d' % number
            first, _ = self.arbiter(namespace)
            self.kill(first)
            other, _ = self.arbiter(namespace, 'other')
            self.assertIn(namespace + '/other', call(namespace + '/emergency_stop', Trigger).message)
            self.kill(other, number)
            again, says = self.arbiter(namespace)
            self.assertTrue(says().emergency_stop, '[ARB-12]')
            self.assertIn('from before a restart', says().emergency_stop_cause)
            self.assertTrue(self.clear(namespace))
            self.kill(again)
            _, says = self.arbiter(namespace, 'third')
            self.assertFalse(says().emergency_stop, 'a clear by one clears it for the next [ARB-7]')

    # [ARB-6] [ARB-12] [FLT-2]
    def test_a_source_that_one_arbiter_switched_off_is_off_for_the_next(self):
        first, _ = self.arbiter('/switched')
        self.kill(first)
        other, _ = self.arbiter('/switched', 'other')
        self.assertTrue(call('/switched/set_nav_enabled', SetBool, False).success)
        self.kill(other)
        again, says = self.arbiter('/switched')
        self.assertEqual([source.name for source in says().sources if not source.enabled], ['nav'], '[ARB-12]')
        self.assertTrue(call('/switched/set_nav_enabled', SetBool, True).success)
        self.kill(again)
        _, says = self.arbiter('/switched', 'other')
        self.assertTrue(all(source.enabled for source in says().sources))

    # [ARB-7] [ARB-12]
    def test_a_clear_that_reaches_one_of_two_arbiters_does_not_lose_the_stop_of_the_other(self):
        first, first_says, second, second_says = self.two_at_once('/both')
        answer = call('/both/emergency_stop', Trigger).message
        self.assertRegex(answer, r'answered by /both/(other|cmd_vel_arbiter)\)')
        if '/both/other' not in answer:  # the first has registered again meanwhile
            first, first_says, second, second_says = second, second_says, first, first_says
        self.assertTrue(wait_for(lambda: first_says().emergency_stop and second_says().emergency_stop))
        self.assertTrue(self.clear('/both'))
        self.kill(first)  # at once, and it was stopped
        self.assertTrue(wait_for(lambda: second_says().emergency_stop, 2.0), 'the one that goes on [ARB-12]')
        self.kill(second)
        _, says = self.arbiter('/both')
        self.assertTrue(says().emergency_stop, 'and whoever comes after it [ARB-12]')
        self.assertTrue(self.clear('/both'))
        self.assertTrue(wait_for(lambda: not says().emergency_stop), 'the status follows the answer')
        self.assertFalse(wait_for(lambda: says().emergency_stop, 1.5), 'a stop of the dead that was cleared')


if __name__ == '__main__':
    rospy.init_node('arbiter_handover_test')
    rostest.rosrun('frontier_pilot', 'arbiter_handover', ArbiterHandover)
