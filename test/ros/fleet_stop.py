#!/usr/bin/env python3
"""One call stops all robots, and names those that have not confirmed it: two arbiters, of which one hangs or dies. [MUL-4]"""
import signal
import socket
import time
import unittest

import rospy
import rosservice
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from frontier_pilot.msg import ArbiterStatus, FleetStopStatus
from std_srvs.srv import SetBool, Trigger, TriggerResponse

from wire import Node, Record, call, wait_for

ROBOTS = ('robot1', 'robot2')
SERVICES = {'/%s/emergency_stop' % robot for robot in ROBOTS}


class FleetStop(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.set_param('/fleet_stop/robots', [{'name': robot} for robot in ROBOTS])
        cls.status = {robot: Record('/%s/cmd_vel_arbiter/status' % robot, ArbiterStatus) for robot in ROBOTS}
        cls.fleet = Record('/fleet/stop_status', FleetStopStatus)
        cls.diagnostics = Record('/diagnostics', DiagnosticArray)

    def setUp(self):
        self.fleet.items.clear()
        self.diagnostics.items.clear()
        self.arbiters = {robot: self.arbiter(robot) for robot in ROBOTS}
        self.node = self.start()
        self.assertTrue(self.reaches(SERVICES), self.state())
        for robot in ROBOTS:
            self.clear(robot)

    def state(self):
        """Why a test may have failed."""
        return self.node.process.poll(), self.node.said(), self.fleet.last

    def arbiter(self, robot):
        for record in self.status.values():
            record.items.clear()
        node = Node('cmd_vel_arbiter', '__ns:=/' + robot, '_fleet_stop_status:=/fleet/stop_status')
        self.addCleanup(node.end)
        return node

    def start(self, *arguments):
        node = Node('fleet_stop', *arguments)
        self.addCleanup(node.end)
        return node

    def reaches(self, services):
        return wait_for(lambda: self.fleet.last is not None and set(self.fleet.last.reached) == services, 10.0)

    def clear(self, robot):
        self.assertTrue(wait_for(lambda: call('/%s/set_emergency_stop' % robot, SetBool, False).success, 5.0))

    def stopped(self, robot, patience=3.0):
        return wait_for(lambda: self.status[robot].last is not None and self.status[robot].last.emergency_stop, patience)

    def stop(self):
        began = time.monotonic()
        answer = call('/fleet/emergency_stop', Trigger)
        return answer, time.monotonic() - began

    def test_every_robot_confirms_and_each_is_cleared_by_itself(self):
        answer, _ = self.stop()
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.message, '2 of 2 robots stopped')
        for robot in ROBOTS:
            self.assertTrue(self.stopped(robot))
        self.assertIn('/fleet_stop', self.status['robot1'].last.emergency_stop_cause)
        self.clear('robot1')
        self.assertTrue(wait_for(lambda: not self.status['robot1'].last.emergency_stop))
        self.assertTrue(self.status['robot2'].last.emergency_stop)

    def test_the_stop_of_one_robot_is_that_robots_alone(self):
        self.assertTrue(call('/robot1/emergency_stop', Trigger).success)
        self.assertTrue(self.stopped('robot1'))
        rospy.sleep(0.5)
        self.assertFalse(self.status['robot2'].last.emergency_stop)

    def test_a_robot_that_hangs_is_named_within_the_bound_and_stops_when_it_wakes(self):
        self.arbiters['robot2'].signal(signal.SIGSTOP)
        self.addCleanup(self.arbiters['robot2'].signal, signal.SIGCONT)
        answer, took = self.stop()
        self.assertFalse(answer.success)
        self.assertEqual(answer.message, '1 of 2 robots stopped; not confirmed by robot2: silent')
        self.assertLess(took, 1.5)
        self.assertTrue(self.stopped('robot1'))
        self.arbiters['robot2'].signal(signal.SIGCONT)
        self.assertTrue(self.stopped('robot2'))

    def test_a_robot_that_was_killed_is_named_at_once(self):
        self.arbiters['robot2'].signal(signal.SIGKILL)
        answer, took = self.stop()
        self.assertFalse(answer.success)
        self.assertEqual(answer.message, '1 of 2 robots stopped; not confirmed by robot2: no service')
        self.assertLess(took, 1.5)
        self.assertTrue(self.stopped('robot1'))
        self.assertTrue(wait_for(lambda: self.fleet.last.not_reached == ['/robot2/emergency_stop'], 5.0))
        # Its service stays at the master: a connection to where it was must never count.
        self.fleet.items.clear()
        rospy.sleep(4.0)
        self.assertTrue(self.fleet.items)
        for _, status in list(self.fleet.items):
            self.assertEqual(status.not_reached, ['/robot2/emergency_stop'])
        self.arbiters['robot2'] = self.arbiter('robot2')
        self.assertTrue(self.reaches(SERVICES))
        self.assertTrue(self.stop()[0].success)

    def test_a_robot_that_was_restarted_during_the_stop_is_stopped_when_it_is_back(self):
        self.arbiters['robot2'].signal(signal.SIGKILL)
        self.assertFalse(self.stop()[0].success)
        self.arbiters['robot2'] = self.arbiter('robot2')
        self.assertTrue(self.stopped('robot2', 20.0), '[MUL-4]')  # it has to start first
        self.clear('robot2')
        rospy.sleep(1.5)
        self.assertFalse(self.status['robot2'].last.emergency_stop, 'it is asked only until it has confirmed')

    def test_a_stranger_that_has_given_a_robots_service_back_is_not_called_any_more(self):
        """[MUL-4]"""
        self.node.end()
        asked = []
        stranger = rospy.Service('/robot1/emergency_stop', Trigger, lambda _: TriggerResponse(not asked.append(1), 'a stranger'))
        self.assertTrue(wait_for(lambda: rosservice.get_service_node('/robot1/emergency_stop') == rospy.get_name()))
        self.fleet.items.clear()
        self.node = self.start()
        self.assertTrue(self.reaches(SERVICES), self.state())
        rospy.sleep(2.0)
        self.assertIn('the answer of robot1 is not signed by an arbiter', self.stop()[0].message)
        self.assertEqual(len(asked), 1)
        stranger.shutdown()  # it goes on serving those that are connected to it
        self.assertTrue(wait_for(lambda: rosservice.get_service_node('/robot1/emergency_stop') == '/robot1/cmd_vel_arbiter', 10.0))
        self.assertTrue(self.stopped('robot1'), 'what the stranger has confirmed is owed to the arbiter')
        self.clear('robot1')
        self.assertTrue(self.stop()[0].success)
        self.assertTrue(self.stopped('robot1'))
        self.assertEqual(len(asked), 1)

    def test_a_robot_that_is_not_listed_is_found_and_stopped(self):
        robot3 = Node('cmd_vel_arbiter', '__ns:=/robot3')
        self.addCleanup(robot3.end)
        self.assertTrue(self.reaches(SERVICES | {'/robot3/emergency_stop'}))
        answer, _ = self.stop()
        self.assertEqual(answer.message, '3 of 3 robots stopped')

    def test_a_robot_on_a_computer_that_cannot_be_found_does_not_flood_the_log(self):
        """[FLT-1]"""
        master, service, there = rospy.get_master(), '/robot3/emergency_stop', 'rosrpc://no-such-computer.invalid:1'
        stranger = rospy.Publisher('/robot3/cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        self.addCleanup(stranger.unregister)
        master.target.registerService('/stranger', service, there, 'http://127.0.0.1:1')
        self.addCleanup(master.target.unregisterService, '/stranger', service, there)
        self.assertTrue(wait_for(lambda: self.fleet.last is not None and service in self.fleet.last.not_reached, 10.0))
        self.assertFalse(self.stop()[0].success)
        rospy.sleep(15.0)
        lines = [line for line in self.node.said().splitlines() if 'no-such-computer' in line]
        self.assertTrue(lines)
        self.assertLess(len(lines), 40, 'in 15 s, in the first of which it tries more often')

    def test_a_late_answer_confirms_no_later_stop(self):
        """The robot may have been cleared in between. [MUL-4]"""
        self.node.end()
        self.fleet.items.clear()
        self.node = self.start('_patience:=2.0')
        self.addCleanup(rospy.delete_param, '/fleet_stop/patience')
        calls = []

        def stop(_):
            calls.append(time.monotonic())
            if len(calls) == 1:
                time.sleep(2.5)
            return TriggerResponse(True, 'stopped (answered by a test)')
        stranger = rospy.Publisher('/robot3/cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        self.addCleanup(stranger.unregister)
        service = rospy.Service('/robot3/emergency_stop', Trigger, stop)
        self.addCleanup(service.shutdown)
        self.assertTrue(self.reaches(SERVICES | {'/robot3/emergency_stop'}))
        self.assertEqual(self.stop()[0].message, '2 of 3 robots stopped; not confirmed by robot3: silent')
        self.assertEqual(self.stop()[0].message, '3 of 3 robots stopped')
        self.assertEqual(len(calls), 2)
        rospy.sleep(1.0)
        self.assertEqual(len(calls), 2)

    def test_it_ends_although_a_computer_takes_no_connection(self):
        """[FLT-1]"""
        master, service, waiting = rospy.get_master(), '/robot3/emergency_stop', []
        full = socket.socket()
        self.addCleanup(full.close)
        full.bind(('127.0.0.1', 0))
        full.listen(0)
        for _ in range(3):  # its queue is full now, and what else wants to connect is not answered
            waiting.append(socket.socket())
            self.addCleanup(waiting[-1].close)
            waiting[-1].setblocking(False)
            waiting[-1].connect_ex(full.getsockname())
        stranger = rospy.Publisher('/robot3/cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        self.addCleanup(stranger.unregister)
        there = 'rosrpc://127.0.0.1:%d' % full.getsockname()[1]
        master.target.registerService('/stranger', service, there, 'http://127.0.0.1:1')
        self.addCleanup(master.target.unregisterService, '/stranger', service, there)
        self.assertTrue(wait_for(lambda: self.fleet.last is not None and service in self.fleet.last.not_reached, 10.0))
        rospy.sleep(1.0)
        self.node.signal(signal.SIGINT)
        self.node.finish(10.0)

    def test_it_never_calls_itself(self):
        """A robot called fleet would have its stop where the stop of all is. [FLT-1]"""
        stranger = rospy.Publisher('/fleet/cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        self.addCleanup(stranger.unregister)
        self.test_a_robot_that_is_not_listed_is_found_and_stopped()
        self.node.end()  # a second one is refused for another reason
        for name in ('fleet', '/fleet'):
            rospy.set_param('/refused/robots', [{'name': name}])
            code, said = Node('fleet_stop', '__name:=refused').finish(20.0)
            self.assertEqual(code, 2)
            self.assertIn("robots: '%s' cannot be a robot's name: fleet/emergency_stop stops all robots" % name, said)

    def test_every_arbiter_says_when_the_stop_for_all_is_gone_or_hangs(self):
        for number in (signal.SIGKILL, signal.SIGSTOP):
            self.node.signal(number)
            for robot in ROBOTS:
                self.assertTrue(self.complains(robot, True, 8.0), (number, robot))
            if number == signal.SIGKILL:
                self.node = self.start()
            else:
                self.node.signal(signal.SIGCONT)
            for robot in ROBOTS:
                self.assertTrue(self.complains(robot, False, 8.0), (number, robot, self.state()))
        said = [status.message for _, array in list(self.diagnostics.items) for status in array.status
                if status.level == DiagnosticStatus.ERROR]
        self.assertTrue(any('fleet/emergency_stop does not stop this robot' in text for text in said))

    def complains(self, robot, expected, timeout):
        record = self.status[robot]
        return wait_for(lambda: any('fleet/emergency_stop' in text for text in record.last.problems) == expected, timeout)


if __name__ == '__main__':
    rospy.init_node('fleet_stop_test')
    rostest.rosrun('frontier_pilot', 'fleet_stop', FleetStop)
