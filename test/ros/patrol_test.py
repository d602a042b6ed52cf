#!/usr/bin/env python3
"""Patrols on the wire: results, cancel, preemption, emergency stop, blocked wheels, and the client program."""
import math
import os
import signal
import subprocess
import time
import unittest

import actionlib
import roslib.packages
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_srvs.srv import SetBool, Trigger

from frontier_pilot.msg import PatrolAction, PatrolGoal


def is_zero(twist):
    return twist.linear.x == 0.0 and twist.angular.z == 0.0


def yaw_of(odometry):
    q = odometry.pose.pose.orientation
    return 2.0 * math.atan2(q.z, q.w)


def goal(mode, size=0.3, laps=1):
    msg = PatrolGoal()
    msg.goal.x, msg.goal.y, msg.goal.z = mode, size, laps
    return msg


def program(name):
    return roslib.packages.find_node('frontier_pilot', name)[0]


class PatrolTest(unittest.TestCase):
    def setUp(self):
        self.commands, self.feedback = [], []
        self.odometry = None
        self.subscribers = [
            rospy.Subscriber('cmd_vel_patrol', Twist, self.commands.append, queue_size=1000),
            rospy.Subscriber('odom', Odometry, self.on_odometry, queue_size=1)]
        self.client = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(60)))
        self.until(lambda: self.odometry is not None, 'odometry')

    def tearDown(self):
        self.client.cancel_all_goals()
        for subscriber in self.subscribers:
            subscriber.unregister()

    def on_odometry(self, msg):
        self.odometry = msg

    def until(self, condition, what, seconds=30.0):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, 'waited in vain for ' + what)
            time.sleep(0.005)

    def send(self, msg):
        self.client.send_goal(msg, feedback_cb=lambda f: self.feedback.append(f.state))

    def end(self, seconds=200.0):
        self.assertTrue(self.client.wait_for_result(rospy.Duration(seconds)))
        return self.client.get_state(), self.client.get_result().result

    def moving(self):
        self.until(lambda: self.commands and not is_zero(self.commands[-1]), 'motion')

    def assert_silent_after_zero(self):
        """[PAT-6] Zero was the last word."""
        rospy.sleep(0.5)
        self.assertTrue(is_zero(self.commands[-1]))
        said = len(self.commands)
        rospy.sleep(2.0)
        self.assertEqual(len(self.commands), said)

    def test_every_shape_completes_with_its_text_and_comes_back(self):
        """[PAT-2] [PAT-3]"""
        for mode, name, legs in ((1, 'square', 4), (2, 'triangle', 3), (3, 'circle', 2)):
            start, self.feedback = self.odometry, []
            self.send(goal(mode, 0.3, 2 if mode == 3 else 1))
            self.assertEqual(self.end(), (GoalStatus.SUCCEEDED, name + ' patrol complete!!'))
            rospy.sleep(0.5)
            # What the law promises is tested in lockstep; here a busy machine delays odometry and commands.
            here, there = self.odometry.pose.pose.position, start.pose.pose.position
            self.assertLess(math.hypot(here.x - there.x, here.y - there.y), 0.04)
            turned = yaw_of(self.odometry) - yaw_of(start)
            self.assertLess(abs(math.remainder(turned, 2.0 * math.pi)), math.radians(4.0))
            self.assertEqual(self.feedback, ['line %d' % (leg + 1) for leg in range(legs)])
        self.assert_silent_after_zero()

    def test_a_bad_goal_is_aborted_with_its_text_and_without_motion(self):
        """[PAT-1]"""
        for bad, text in ((goal(4), 'invalid patrol mode'), (goal(1, -1.0), 'goal.y (side)'),
                          (goal(3, float('nan')), 'goal.y (radius)'), (goal(1, 1.0, 0.5), 'goal.z (laps)')):
            self.send(bad)
            state, result = self.end()
            self.assertEqual(state, GoalStatus.ABORTED)
            self.assertIn(text, result)
        self.assertTrue(all(is_zero(command) for command in self.commands))

    def test_cancel_sends_zero_and_then_the_result(self):
        """[PAT-4]"""
        self.send(goal(1, 2.0))
        self.moving()
        asked = time.monotonic()
        self.client.cancel_goal()
        self.until(lambda: is_zero(self.commands[-1]), 'zero')
        print('cancel to zero: %.1f ms' % ((time.monotonic() - asked) * 1e3))
        self.assertEqual(self.end(), (GoalStatus.PREEMPTED, 'patrol canceled'))
        self.assert_silent_after_zero()

    def test_a_new_goal_preempts_the_old_one_with_zero_between(self):
        """[PAT-4]"""
        self.send(goal(1, 2.0))
        self.moving()
        said = len(self.commands)
        other = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        self.assertTrue(other.wait_for_server(rospy.Duration(60)))
        other.send_goal(goal(2, 0.3))
        self.assertEqual(self.end(), (GoalStatus.PREEMPTED, 'patrol canceled'))
        self.until(lambda: any(is_zero(command) for command in self.commands[said:]), 'zero between the two')
        self.until(lambda: not is_zero(self.commands[-1]), 'the second patrol')
        self.assertTrue(other.wait_for_result(rospy.Duration(200)))
        self.assertEqual(other.get_result().result, 'triangle patrol complete!!')

    def test_an_emergency_stop_aborts_and_nothing_resumes(self):
        """[PAT-5]"""
        stop, clear = rospy.ServiceProxy('emergency_stop', Trigger), rospy.ServiceProxy('set_emergency_stop', SetBool)
        self.send(goal(1, 2.0))
        self.moving()
        self.assertTrue(stop().success)
        self.assertEqual(self.end(), (GoalStatus.ABORTED, 'aborted: emergency stop'))
        self.assert_silent_after_zero()
        self.send(goal(1, 2.0))
        self.assertEqual(self.end()[0], GoalStatus.ABORTED)
        self.until(lambda: clear(False).success, 'the stop to be cleared')
        self.assert_silent_after_zero()

    def test_without_the_wheels_it_gives_up(self):
        """[PAT-5]"""
        enable = rospy.ServiceProxy('set_patrol_enabled', SetBool)
        self.send(goal(1, 2.0))
        self.moving()
        enable(False)
        state, result = self.end()
        enable(True)
        self.assertEqual(state, GoalStatus.ABORTED)
        self.assertIn('blocked for 10 s', result)

    def run_client(self, *words):
        return subprocess.Popen([program('patrol_client')] + list(words), stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, universal_newlines=True)

    def test_the_client_prints_each_leg_and_tells_the_outcome(self):
        done = self.run_client('triangle', '--side', '0.3')
        self.assertEqual(done.communicate(timeout=60)[0].split('\n'),
                         ['line 1 of 3', 'line 2 of 3', 'line 3 of 3', 'triangle patrol complete!!', ''])
        self.assertEqual(done.returncode, 0)
        refused = self.run_client('square', '--side', '99')
        self.assertIn('goal.y (side)', refused.communicate(timeout=60)[0])
        self.assertEqual(refused.returncode, 1)
        wrong = self.run_client('pentagon')
        self.assertIn('unknown argument: pentagon', wrong.communicate(timeout=60)[0])
        self.assertEqual(wrong.returncode, 2)

    def test_ctrl_c_stops_the_robot_and_waits_for_it(self):
        client = self.run_client('square', '--side', '2')
        self.moving()
        client.send_signal(signal.SIGINT)
        self.assertIn('patrol canceled', client.communicate(timeout=60)[0])
        self.assertEqual(client.returncode, 130)
        self.assert_silent_after_zero()

    def test_the_client_notices_a_server_that_is_not_there_or_dies(self):
        asked = time.monotonic()
        alone = self.run_client('square', '__ns:=nowhere')
        self.assertIn('no patrol server', alone.communicate(timeout=60)[0])
        self.assertEqual(alone.returncode, 3)
        print('no server noticed after %.2f s' % (time.monotonic() - asked))
        server = subprocess.Popen([program('patrol_server'), '__ns:=second', 'odom:=/odom'])
        client = None
        try:
            commands = []
            subscriber = rospy.Subscriber('/second/cmd_vel_patrol', Twist, commands.append)
            watch = actionlib.SimpleActionClient('/second/turtlebot3', PatrolAction)
            self.assertTrue(watch.wait_for_server(rospy.Duration(60)))
            client = self.run_client('square', '--side', '2', '__ns:=second')
            self.until(lambda: commands, 'the second patrol')
            os.kill(server.pid, signal.SIGKILL)
            asked = time.monotonic()
            self.assertIn('server is gone', client.communicate(timeout=60)[0])
            print('death noticed after %.2f s' % (time.monotonic() - asked))
            self.assertEqual(client.returncode, 3)
            subscriber.unregister()
        finally:
            for process in (server, client):
                if process is not None and process.poll() is None:
                    process.kill()
                    process.wait()


if __name__ == '__main__':
    rospy.init_node('patrol_test')
    rostest.rosrun('frontier_pilot', 'patrol', PatrolTest)
