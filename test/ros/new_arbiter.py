#!/usr/bin/env python3
"""The robot is stopped and cleared as soon as a new arbiter is there, to which the other nodes are still connecting."""
import os
import signal
import threading
import time
import unittest

import actionlib
import rospy
import rostest
from frontier_pilot.msg import ArbiterStatus, PatrolAction, PatrolGoal
from geometry_msgs.msg import Twist
from std_srvs.srv import Empty, SetBool

from wire import Record, call, hears, moves, pid_of, replace_the_arbiter, wait_for

ROUNDS = 5  # who has connected before the clear is a matter of chance


class NewArbiter(unittest.TestCase):
    def setUp(self):
        for name in ('emergency_stop', 'set_emergency_stop', 'reset_positions'):
            rospy.wait_for_service(name, 60)
        self.assertTrue(wait_for(lambda: hears('/patrol_server', '/emergency_stop_state'), 20))
        self.patrols = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        self.assertTrue(self.patrols.wait_for_server(rospy.Duration(60)))
        self.commands = Record('cmd_vel', Twist)

    def begin_a_patrol(self):
        call('reset_positions', Empty)
        square = PatrolGoal()
        square.goal.x, square.goal.y, square.goal.z = 1, 0.6, 5
        begin = time.monotonic()
        self.patrols.send_goal(square)
        self.assertTrue(wait_for(lambda: any(moves(command) for command in self.commands.since(begin)), 30), 'it never drove')

    def assert_the_patrol_was_stopped(self):
        self.assertTrue(self.patrols.wait_for_result(rospy.Duration(30)), 'it goes on')
        self.assertEqual(self.patrols.get_result().result, 'aborted: emergency stop')

    def test_a_stop_that_is_cleared_at_once_ends_a_patrol_all_the_same(self):
        """[ARB-8] [PAT-5] [FLT-2]"""
        for _ in range(ROUNDS):
            self.begin_a_patrol()
            self.assertTrue(replace_the_arbiter().success)
            self.assertTrue(wait_for(lambda: call('set_emergency_stop', SetBool, False).success, 20), 'the stop is not cleared')
            cleared = time.monotonic()
            self.assert_the_patrol_was_stopped()
            time.sleep(1.0)  # that nothing moves can only be seen by waiting
            self.assertFalse([command for command in self.commands.since(cleared) if moves(command)])

    def test_a_clear_waits_for_a_node_that_follows_the_stop(self):
        """[ARB-8] [FLT-2]"""
        answers = []
        server = pid_of('/patrol_server')
        os.kill(server, signal.SIGSTOP)
        try:
            self.assertTrue(replace_the_arbiter().success)
            clear = threading.Thread(target=lambda: answers.append(call('set_emergency_stop', SetBool, False).success))
            clear.start()
            time.sleep(3.0)  # for longer than an arbiter listens to the sources
            self.assertEqual(answers, [])
        finally:
            os.kill(server, signal.SIGCONT)
        clear.join(30.0)
        self.assertEqual(answers, [True])

    def test_a_stop_that_only_the_count_of_the_arbiter_tells_of_ends_a_patrol(self):
        """[PAT-5] [FLT-2]"""
        status = rospy.Publisher('cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        self.addCleanup(status.unregister)
        self.begin_a_patrol()
        self.assertTrue(wait_for(lambda: status.get_num_connections() > 0))
        self.assertTrue(wait_for(lambda: status.publish(ArbiterStatus(stops=1000)) or self.patrols.wait_for_result(rospy.Duration(0.2)), 20))
        self.assert_the_patrol_was_stopped()


if __name__ == '__main__':
    rospy.init_node('new_arbiter_test')
    rostest.rosrun('frontier_pilot', 'new_arbiter', NewArbiter)
