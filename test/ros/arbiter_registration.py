#!/usr/bin/env python3
"""A stop that was answered is a stop of the robot: rivals, strangers, and a master that dies and comes back empty."""
import signal
import subprocess
import threading
import time
import unittest

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from frontier_pilot.msg import ArbiterStatus
from geometry_msgs.msg import Twist
from std_msgs.msg import Bool
from std_srvs.srv import SetBool, Trigger

from tap import Tap
from wire import Node, Record, Source, call, moves, time_until, wait_for

STRANGER = """
import sys, rospy
from std_srvs.srv import Trigger, TriggerResponse
rospy.init_node('stranger', anonymous=True)
rospy.Service(sys.argv[1], Trigger, lambda request: TriggerResponse(True, 'done'))
rospy.spin()
"""


def provider(service):
    for name, nodes in rosgraph.Master('/test').getSystemState()[2]:
        if name == service:
            return nodes[0]
    return None


class Stranger:
    """A node that is none of ours and offers a service."""

    def __init__(self, service):
        self.service = service
        self.before = provider(service)
        self.process = subprocess.Popen(['/usr/bin/python3', '-c', STRANGER, service], stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        assert wait_for(lambda: provider(service) not in (None, self.before), 15.0)
        self.name = provider(service)

    def end(self, number=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(number)
            self.process.wait(10.0)


class ArbiterRegistration(unittest.TestCase):
    def arbiter(self, namespace, *arguments):
        node = Node('cmd_vel_arbiter', '__ns:=' + namespace, *arguments)
        self.addCleanup(node.end)
        self.assertTrue(wait_for(lambda: provider(namespace + '/emergency_stop'), 15.0))
        return node

    def driven_arbiter(self, namespace):
        """An arbiter that nav drives, what it says, and that source."""
        out = Record(namespace + '/cmd_vel', Twist)
        status = Record(namespace + '/cmd_vel_arbiter/status', ArbiterStatus)
        node = self.arbiter(namespace)
        nav = Source(namespace + '/cmd_vel_nav', 50.0).connect().start(0.1)
        self.addCleanup(nav.close)
        self.assertTrue(wait_for(lambda: out.last is not None and moves(out.last) and status.last is not None))
        return node, out, status, nav

    def stands(self, out):
        """Whether only zeros leave for half a second, soon."""
        def quiet():
            recent = out.since(time.monotonic() - 0.5)
            return len(recent) >= 5 and not any(moves(message) for message in recent)
        return wait_for(quiet, 5.0)

    # [ARB-12]
    def test_a_second_arbiter_does_not_start_whatever_its_name_and_names_the_first(self):
        _, out, _, _ = self.driven_arbiter('/second')
        for name in ['another', 'cmd_vel_arbiter']:
            code, said = Node('cmd_vel_arbiter', '__ns:=/second', '__name:=' + name).finish(20.0)
            self.assertNotEqual(code, 0, said)
            self.assertIn('/second/cmd_vel_arbiter', said)
            self.assertEqual(provider('/second/emergency_stop'), '/second/cmd_vel_arbiter', '[ARB-12]')
            self.assertTrue(moves(out.last), 'the first goes on [ARB-12]')

    # [ARB-12]
    def test_while_a_stranger_offers_the_stop_only_zeros_leave_and_afterwards_the_arbiter_offers_it_again(self):
        _, out, status, nav = self.driven_arbiter('/stranger')
        stranger = Stranger('/stranger/emergency_stop')
        self.addCleanup(stranger.end)
        self.assertTrue(wait_for(lambda: status.last.state == ArbiterStatus.CONTESTED), '[ARB-12]')
        self.assertTrue(self.stands(out), '[ARB-12]')
        self.assertTrue(any(stranger.name in text for text in status.last.problems), 'named in the status')
        diagnostics = Record('/diagnostics', DiagnosticArray)
        self.assertTrue(wait_for(lambda: any(
            stranger.name in part.message and part.level == DiagnosticStatus.ERROR
            for _, message in diagnostics.items for part in message.status)), 'an ERROR by name [ARB-12]')
        stranger.end()
        self.assertTrue(wait_for(lambda: provider('/stranger/emergency_stop') == '/stranger/cmd_vel_arbiter'), '[ARB-12]')
        self.assertTrue(wait_for(lambda: any('registered again' in text for text in status.last.problems)))
        self.assertTrue(wait_for(lambda: moves(out.last)), 'drives again')
        self.assertIn('/stranger/cmd_vel_arbiter', call('/stranger/emergency_stop', Trigger).message)
        self.assertTrue(self.stands(out), '[ARB-7]')

    # [ARB-12]
    def test_a_stranger_is_noticed_within_2_s_and_so_is_its_end(self):
        _, _, status, _ = self.driven_arbiter('/watched')
        noticed, registered = [], []
        for _ in range(3):  # the best counts: the machine may be busy
            stranger = Stranger('/watched/emergency_stop')
            self.addCleanup(stranger.end)
            noticed.append(time_until(lambda: status.last.state == ArbiterStatus.CONTESTED))
            stranger.end()
            registered.append(time_until(lambda: provider('/watched/emergency_stop') == '/watched/cmd_vel_arbiter'))
            self.assertTrue(wait_for(lambda: status.last.state != ArbiterStatus.CONTESTED), 'uncontested')
        self.assertLess(min(noticed), 2.0, '[ARB-12]')
        self.assertLess(min(registered), 2.0, 'registered again [ARB-12]')

    # [ARB-12]
    def test_a_service_that_a_killed_stranger_has_left_registered_is_taken_back(self):
        self.driven_arbiter('/killed')
        stranger = Stranger('/killed/set_emergency_stop')
        stranger.end(signal.SIGKILL)
        self.assertEqual(provider('/killed/set_emergency_stop'), stranger.name, 'nobody said goodbye for it')
        self.assertTrue(wait_for(lambda: provider('/killed/set_emergency_stop') == '/killed/cmd_vel_arbiter', 3.0))
        self.assertTrue(call('/killed/set_emergency_stop', SetBool, True).success, '[ARB-12]')

    # [ARB-12]
    def test_a_service_of_a_dead_provider_is_taken_back_even_if_its_node_cannot_be_asked(self):
        _, out, _, _ = self.driven_arbiter('/ghost')
        living = rosgraph.Master('/test').lookupNode('/ghost/cmd_vel_arbiter')
        for address in ('http://no-such-host.invalid:5/', living):
            ghost = rosgraph.Master('/departed')
            ghost.registerService('/ghost/emergency_stop', 'rosrpc://127.0.0.1:1', address)
            self.assertTrue(wait_for(lambda: provider('/ghost/emergency_stop') == '/ghost/cmd_vel_arbiter', 10.0), address)
            self.assertTrue(call('/ghost/emergency_stop', Trigger).success, '[ARB-12]')
            self.assertTrue(self.stands(out), '[ARB-7]')

    # [ARB-12]
    def test_while_somebody_takes_the_stop_away_again_and_again_only_zeros_leave(self):
        _, out, status, _ = self.driven_arbiter('/taken')
        arbiter = rosgraph.Master('/taken/cmd_vel_arbiter')
        ending = threading.Event()

        def take():
            while not ending.wait(0.02):
                try:
                    arbiter.unregisterService('/taken/emergency_stop', arbiter.lookupService('/taken/emergency_stop'))
                except rosgraph.MasterException:
                    pass  # nobody has registered it since
        taker = threading.Thread(target=take, daemon=True)
        taker.start()
        self.addCleanup(ending.set)
        self.assertTrue(wait_for(lambda: status.last.state == ArbiterStatus.CONTESTED, 8.0), '[ARB-12]')
        self.assertTrue(self.stands(out), '[ARB-12]')
        ending.set()
        taker.join()
        self.assertTrue(wait_for(lambda: moves(out.last), 20.0), 'drives again when it is over')
        self.assertIn('/taken/cmd_vel_arbiter', call('/taken/emergency_stop', Trigger).message)

    # [ARB-1] [FLT-2]
    def test_what_was_sent_while_the_arbiter_was_suspended_does_not_move_the_robot_afterwards(self):
        node, out, _, nav = self.driven_arbiter('/suspended')
        for _ in range(5):
            nav.start(0.1)
            self.assertTrue(wait_for(lambda: moves(out.last)))
            node.signal(signal.SIGSTOP)
            nav.stop()
            time.sleep(1.2)  # longer than a command counts
            went_on = time.monotonic()
            node.signal(signal.SIGCONT)
            self.assertTrue(wait_for(lambda: len(out.since(went_on)) >= 5))
            self.assertFalse(any(moves(message) for message in out.since(went_on)), '[ARB-1]')

    # [ARB-8] [FLT-2]
    def test_a_clear_that_finds_the_arbiter_suspended_is_refused_while_a_source_commands_motion(self):
        node, out, _, nav = self.driven_arbiter('/resumed')
        clear = rospy.ServiceProxy('/resumed/set_emergency_stop', SetBool)
        tap = Tap('/resumed/cmd_vel_arbiter', '/resumed/cmd_vel', Twist)
        self.addCleanup(tap.close)
        for _ in range(3):
            nav.start(0.1)
            self.assertTrue(wait_for(lambda: moves(out.last)))
            self.assertTrue(call('/resumed/emergency_stop', Trigger).success)
            tap.arrived()  # what had arrived by then
            node.signal(signal.SIGSTOP)
            answers = []
            caller = threading.Thread(target=lambda: answers.append(clear(False)))
            caller.start()
            time.sleep(1.2)  # longer than the sources have to be quiet
            node.signal(signal.SIGCONT)
            caller.join()
            self.assertFalse(answers[0].success, answers[0].message)
            self.assertIn('asked to move', answers[0].message)
            nav.stop()
            self.assertTrue(wait_for(lambda: call('/resumed/set_emergency_stop', SetBool, False).success, 3.0))
            self.assertFalse(any(map(moves, tap.arrived())), '[ARB-8]')

    # [ARB-12]
    def test_a_stranger_may_be_put_up_with_if_a_parameter_says_so(self):
        rospy.set_param('/tolerant/cmd_vel_arbiter/stand_when_contested', False)
        _, out, status, _ = self.driven_arbiter('/tolerant')
        stranger = Stranger('/tolerant/emergency_stop')
        self.addCleanup(stranger.end)
        self.assertTrue(wait_for(lambda: any(stranger.name in text for text in status.last.problems), 3.0))
        self.assertTrue(moves(out.last), 'an ERROR, but it drives on [ARB-12]')

    # [ARB-12]
    def test_a_stop_of_another_arbiter_is_a_stop_of_this_one(self):
        _, out, status, _ = self.driven_arbiter('/told')
        other = rospy.Publisher('/told/emergency_stop_state', Bool, latch=True, queue_size=1)
        other.publish(False)
        self.assertTrue(moves(out.last))
        self.assertTrue(wait_for(lambda: any(rospy.get_name() + ' publishes /told/emergency_stop_state' in text
                                             for text in status.last.problems)), 'named, whatever it says')
        other.publish(True)
        self.assertTrue(wait_for(lambda: status.last.emergency_stop), '[ARB-12]')
        self.assertIn(rospy.get_name(), status.last.emergency_stop_cause)
        self.assertTrue(self.stands(out))
        other.publish(False)
        self.assertFalse(wait_for(lambda: not status.last.emergency_stop, 0.5), 'only a clear undoes a stop')
        other.unregister()

    # [ARB-7] [ARB-12]
    def test_after_a_stop_was_answered_nothing_that_moves_reaches_the_base(self):
        self.arbiter('/answered')
        tap = Tap('/answered/cmd_vel_arbiter', '/answered/cmd_vel', Twist)
        sources = [Source('/answered/cmd_vel_' + name, 1000.0).connect() for name in ['patrol', 'nav', 'manual']]
        stop = rospy.ServiceProxy('/answered/emergency_stop', Trigger, persistent=True)
        load = [threading.Thread(target=self.stop_and_clear, args=('/answered', 30), daemon=True) for _ in range(7)]
        for _ in range(30):
            for source in sources:
                source.start(0.1)
            self.assertTrue(wait_for(lambda: any(moves(message) for message in tap.arrived())))
            self.assertIn('/answered/cmd_vel_arbiter', stop().message, 'says who answered')
            tap.arrived()  # what had arrived by then
            self.assertFalse(any(moves(message) for message in tap.during(0.05)), '[ARB-7]')
            for source in sources:
                source.stop()
            self.assertTrue(wait_for(lambda: call('/answered/set_emergency_stop', SetBool, False).success))
        for thread in load:
            thread.start()
        for thread in load:
            thread.join()
        tap.close()

    def stop_and_clear(self, namespace, times):
        for _ in range(times):
            call(namespace + '/emergency_stop', Trigger)
            call(namespace + '/set_emergency_stop', SetBool, False)


if __name__ == '__main__':
    rospy.init_node('arbiter_registration_test')
    rostest.rosrun('frontier_pilot', 'arbiter_registration', ArbiterRegistration)
