#!/usr/bin/env python3
"""The arbiter on the wire: order, expiry, switches, the emergency stop, foreign publishers."""
import os
import signal
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

from tap import Tap
from wire import (Node, Record, Source, assert_memory_below, clear, emergency_stop, enable, memory_of, moves, pid_of,
                  set_emergency_stop, twist, wait_for)

SOURCES = ['avoid', 'behavior', 'patrol', 'nav', 'manual']


class ArbiterOnTheWire(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.out = Record('cmd_vel', Twist)
        cls.status = Record('cmd_vel_arbiter/status', ArbiterStatus)
        cls.stop_state = Record('emergency_stop_state', Bool)
        cls.diagnostics = Record('/diagnostics', DiagnosticArray)
        cls.sources = {name: Source('cmd_vel_' + name) for name in SOURCES}

    def setUp(self):
        self.assertTrue(clear())
        for source in self.sources.values():
            source.connect()
        self.assertTrue(wait_for(lambda: self.out.last is not None and not moves(self.out.last)), 'must start at rest')

    def tearDown(self):
        for source in self.sources.values():
            source.stop()
        for name in SOURCES:
            enable(name, True)
        self.assertTrue(wait_for(lambda: not moves(self.out.last)), 'must end at rest')

    def drives(self, linear, timeout=3.0):
        return wait_for(lambda: self.out.last.linear.x == linear, timeout)

    def tap(self, topic, kind):
        tap = Tap('/cmd_vel_arbiter', topic, kind)
        self.addCleanup(tap.close)
        return tap

    def source_status(self, name):
        return next(source for source in self.status.last.sources if source.name == name)

    # [ARB-1] [ARB-2]
    def test_a_higher_source_takes_over_and_hands_back_when_it_expires(self):
        self.sources['manual'].start(0.05)
        self.assertTrue(self.drives(0.05))
        self.sources['nav'].start(0.10)
        self.assertTrue(self.drives(0.10))
        start = time.monotonic()
        self.sources['nav'].stop()
        self.assertTrue(self.drives(0.05))
        self.assertGreater(time.monotonic() - start, 0.8, 'not before the timeout of 1.0 s [ARB-1]')
        self.sources['manual'].stop()
        self.assertTrue(self.drives(0.0), 'expiry gives zero [ARB-2]')

    # [ARB-2]
    def test_a_zero_that_came_while_the_arbiter_was_held_up_ends_the_motion_before_it(self):
        patrol, arbiter = self.sources['patrol'].start(0.1), pid_of('/cmd_vel_arbiter')
        self.assertTrue(self.drives(0.1))
        os.kill(arbiter, signal.SIGSTOP)
        try:
            time.sleep(0.4)
            patrol.stop()
            patrol.send(0.0)
            time.sleep(0.05)
        finally:
            os.kill(arbiter, signal.SIGCONT)
        self.assertTrue(self.drives(0.0, 0.45), 'before that motion has expired')

    # [ARB-2]
    def test_zero_leaves_at_20_hz_while_nobody_drives(self):
        first = len(self.out.items)
        self.assertTrue(wait_for(lambda: len(self.out.items) >= first + 41))
        items = self.out.items[first:first + 41]
        rate = 40.0 / (items[-1][0] - items[0][0])
        self.assertAlmostEqual(rate, 20.0, delta=2.0, msg='[ARB-2]')
        self.assertFalse(any(moves(message) for _, message in items))

    # [ARB-11]
    def test_the_arbiter_alone_publishes_cmd_vel(self):
        publishers = rosgraph.Master('/test').getSystemState()[0]
        nodes = next(nodes for topic, nodes in publishers if topic == '/cmd_vel')
        self.assertEqual(nodes, ['/cmd_vel_arbiter'], 'nothing else publishes cmd_vel [ARB-11]')

    # The explorer pauses when it hears of a clear. Whoever is told of the clear and lets it go on must not be overtaken. [ARB-8]
    def test_a_clear_is_on_the_wire_before_it_is_answered(self):
        tap = self.tap('/emergency_stop_state', Bool)
        late = 0
        for _ in range(100):
            self.assertTrue(emergency_stop().success)
            self.assertTrue(wait_for(lambda: any(state.data for state in tap.arrived())))
            self.assertTrue(set_emergency_stop(False).success)
            late += all(state.data for state in tap.arrived())
        self.assertEqual(late, 0, 'of 100 clears')

    # [ARB-3]
    def test_a_zero_of_avoid_is_a_heartbeat_and_a_zero_of_patrol_holds(self):
        self.sources['manual'].start(0.05)
        self.sources['avoid'].start(0.0)
        self.assertTrue(wait_for(lambda: self.source_status('avoid').state == 4, 3.0), 'idle [ARB-3]')
        self.assertTrue(self.drives(0.05), '[ARB-3]')
        self.sources['patrol'].start(0.0)
        self.assertTrue(self.drives(0.0), 'the others hold the wheels with zero [ARB-3]')
        self.assertTrue(wait_for(lambda: self.status.last.active_source == 'patrol'))

    # [ARB-3] [AVO-5]
    def test_a_hold_of_avoid_is_zero_for_the_wheels_but_claims_them(self):
        self.sources['manual'].start(0.05)
        self.assertTrue(self.drives(0.05))
        hold = Twist()
        hold.linear.z = 1e-9
        self.sources['avoid'].publisher.publish(hold)
        self.assertTrue(wait_for(lambda: self.out.last == Twist()), 'all unused axes zeroed [ARB-5]')
        self.assertTrue(wait_for(lambda: self.status.last.active_source == 'avoid'))

    # [ARB-5]
    def test_a_message_with_any_field_not_finite_is_rejected_and_counted(self):
        before = self.source_status('nav').rejected
        for axis in ['linear.y', 'angular.x', 'linear.x', 'angular.z']:
            self.sources['nav'].send(0.1)
            self.assertTrue(self.drives(0.1))
            bad = twist(0.1)
            part, name = axis.split('.')
            setattr(getattr(bad, part), name, float('nan'))
            self.sources['nav'].publisher.publish(bad)
            self.assertTrue(self.drives(0.0, 0.5), axis + ': stale at once [ARB-5]')
        self.assertTrue(wait_for(lambda: self.source_status('nav').rejected == before + 4), '[ARB-5]')
        self.assertTrue(wait_for(lambda: any('nav sends' in text for text in self.status.last.problems)))

    # [ARB-5]
    def test_finite_values_are_clamped_and_unused_axes_zeroed(self):
        wild = twist(5.0, -50.0)
        wild.linear.y = 3.0
        wild.angular.x = 3.0
        self.sources['nav'].publisher.publish(wild)
        self.assertTrue(wait_for(lambda: self.out.last == twist(0.22, -2.84)), '[ARB-5]')

    # [ARB-6]
    def test_after_the_answer_to_disable_nothing_of_the_source_leaves(self):
        self.sources['nav'].start(0.1)
        self.assertTrue(self.drives(0.1))
        tap = self.tap('/cmd_vel', Twist)
        answer = enable('nav', False)
        tap.arrived()  # what had arrived by then
        self.assertEqual((answer.success, answer.message), (True, 'nav disabled'))
        self.assertFalse(any(map(moves, tap.next(12))), '[ARB-6]')
        self.assertIn('already', enable('nav', False).message)
        self.sources['nav'].stop()
        enable('nav', True)
        tap.arrived()
        self.assertFalse(any(map(moves, tap.next(5))), 'no revival [ARB-6]')

    # [ARB-7] [ARB-8]
    def test_a_stop_holds_against_every_source_and_is_cleared_only_when_they_are_quiet(self):
        self.sources['nav'].start(0.1)
        self.assertTrue(self.drives(0.1))
        tap = self.tap('/cmd_vel', Twist)
        self.assertTrue(emergency_stop().success)
        tap.arrived()  # what had arrived by then
        self.assertTrue(set_emergency_stop(True).success, 'idempotent [ARB-7]')
        self.assertFalse(any(map(moves, tap.next(20))), '[ARB-7]')
        self.assertTrue(wait_for(lambda: self.stop_state.last.data))
        self.assertIn('emergency_stop called by', self.status.last.emergency_stop_cause)
        refused = set_emergency_stop(False)
        self.assertFalse(refused.success, '[ARB-8]')
        self.assertIn('nav asked to move', refused.message)
        self.sources['nav'].stop()
        self.assertTrue(clear(), '[ARB-8]')
        tap.arrived()
        self.assertFalse(any(map(moves, tap.next(10))), 'clearing never moves [ARB-8]')
        self.assertTrue(wait_for(lambda: not self.stop_state.last.data))
        again = set_emergency_stop(False)
        self.assertTrue(again.success, '[ARB-8]')
        self.assertIn('not stopped: nothing changed', again.message)

    # [ARB-7]
    def test_the_latch_survives_sigkill_and_respawn(self):
        emergency_stop()
        first = pid_of('/cmd_vel_arbiter')
        os.kill(first, signal.SIGKILL)
        killed = time.monotonic()

        def respawned():
            try:
                return pid_of('/cmd_vel_arbiter') != first
            except (OSError, rosgraph.MasterException):
                return False
        self.assertTrue(wait_for(respawned, 20.0))
        self.sources['manual'].start(0.1)
        self.sources['manual'].connect()
        self.assertTrue(wait_for(lambda: len(self.out.since(killed)) >= 20, 20.0))
        self.assertFalse(any(moves(m) for m in self.out.since(killed)), 'comes up stopped [ARB-7]')
        self.assertTrue(self.status.last.emergency_stop)
        self.assertIn('from before a restart', self.status.last.emergency_stop_cause)
        self.sources['manual'].stop()
        self.assertTrue(clear())

    # [ARB-8]
    def test_a_clear_that_races_a_stop_is_served_first_or_refused(self):
        emergency_stop()
        self.assertTrue(clear())
        for _ in range(20):
            emergency_stop()
            answers = {}
            threads = [threading.Thread(target=lambda: answers.update(clear=set_emergency_stop(False))),
                       threading.Thread(target=lambda: answers.update(stop=emergency_stop()))]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertTrue(answers['stop'].success)
            if not answers['clear'].success:
                self.assertIn('a stop was given while', answers['clear'].message, '[ARB-8]')

    # [ARB-10]
    def test_under_three_sources_at_1_khz_only_the_active_one_leaves_and_memory_stays(self):
        load = {'patrol': 0.05, 'nav': 0.10, 'manual': 0.15}
        fast = [Source('cmd_vel_' + name, 1000.0).connect().start(speed) for name, speed in load.items()]
        self.assertTrue(self.drives(0.05))
        pid, start = pid_of('/cmd_vel_arbiter'), time.monotonic()
        before = memory_of(pid)[0]
        self.assertTrue(wait_for(lambda: len(self.out.since(start)) >= 2000, 30.0))
        self.assertEqual({message.linear.x for message in self.out.since(start)}, {0.05}, 'never the wrong one [ARB-10]')
        assert_memory_below(self, memory_of(pid)[0] - before, 1.0, '[MB] [ARB-10]')
        tap = self.tap('/cmd_vel', Twist)
        emergency_stop()
        tap.arrived()  # what had arrived by then
        self.assertFalse(any(map(moves, tap.next(20))), 'stopped under load [ARB-10]')
        for source in fast:
            source.stop()

    # [ARB-11]
    def test_a_foreign_publisher_is_found_and_named_within_2_s(self):
        intruder = Node('rostopic', 'pub', '-r', '10', '/cmd_vel', 'geometry_msgs/Twist', '{}', package='rostopic')
        try:
            master = rosgraph.Master('/test')

            def intruders():
                for topic, nodes in master.getSystemState()[0]:
                    if topic == '/cmd_vel':
                        return [node for node in nodes if node != '/cmd_vel_arbiter']
                return []
            self.assertTrue(wait_for(intruders, 20.0))
            appeared = time.monotonic()
            name = intruders()[0]

            def reported():
                return any(status.level == DiagnosticStatus.ERROR and name in status.message
                           for message in self.diagnostics.since(appeared - 2.0) for status in message.status)
            self.assertTrue(wait_for(reported, 10.0))
            self.assertLess(time.monotonic() - appeared, 2.0, 'within 2 s [ARB-11]')
            self.assertTrue(wait_for(lambda: any(name in text for text in self.status.last.problems)), 'in the status')
        finally:
            intruder.end()

    # [ARB-11]
    def test_two_publishers_on_one_source_are_a_warning_that_names_them(self):
        second = Node('rostopic', 'pub', '-r', '1', '/cmd_vel_manual', 'geometry_msgs/Twist', '{}', package='rostopic')
        try:
            self.assertTrue(wait_for(
                lambda: any('2 nodes publish /cmd_vel_manual' in text for text in self.status.last.problems), 20.0),
                '[ARB-11]')
            self.assertTrue(wait_for(lambda: any(
                status.level == DiagnosticStatus.WARN and '2 nodes publish /cmd_vel_manual' in status.message
                for _, message in self.diagnostics.items for status in message.status), 5.0), '[ARB-11]')
        finally:
            second.end()


if __name__ == '__main__':
    rospy.init_node('arbiter_wire_test')
    rostest.rosrun('frontier_pilot', 'arbiter_wire', ArbiterOnTheWire)
