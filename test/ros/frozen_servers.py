#!/usr/bin/env python3
"""Servers that are frozen while the robot is stopped and cleared: what they were doing does not go on."""
import os
import signal
import threading
import time
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, Twist
from move_base_msgs.msg import MoveBaseAction
from std_srvs.srv import Empty, SetBool, Trigger

from frontier_pilot.msg import (FollowWaypointsAction, FollowWaypointsGoal, FollowWaypointsResult, PatrolAction, PatrolGoal,
                                SpinAction, SpinGoal)
from wire import Record, hears, moves, pid_of, replace_the_arbiter, wait_for

ROUNDS = 5  # whether the server reads of the stop before its next cycle is a matter of chance


class FrozenServers(unittest.TestCase):
    def setUp(self):
        for name in ('emergency_stop', 'set_emergency_stop', 'reset_positions'):
            rospy.wait_for_service(name, 60)
        self.stop = rospy.ServiceProxy('emergency_stop', Trigger)
        self.clear = rospy.ServiceProxy('set_emergency_stop', SetBool)
        for server in '/patrol_server', '/behavior_server', '/waypoint_follower':
            self.assertTrue(wait_for(lambda: hears(server, '/emergency_stop_state'), 20))
        time.sleep(2.0)  # each has asked the master by then which arbiter that is

    def cleared(self):
        return self.clear(False).success

    def freeze_through_a_stop(self, server):
        """Freezes `server`, stops and clears, and lets it go on; when that was."""
        pid = pid_of(server)
        os.kill(pid, signal.SIGSTOP)
        try:
            self.assertTrue(self.stop().success)
            self.assertTrue(wait_for(self.cleared, 20), 'the stop is not cleared')
            time.sleep(0.5)
        finally:
            resumed = time.monotonic()
            os.kill(pid, signal.SIGCONT)
        return resumed

    def frozen_through_a_stop(self, server, topic, client, goal):
        """Freezes `server` while it drives."""
        rospy.ServiceProxy('reset_positions', Empty)()
        self.assertTrue(client.wait_for_server(rospy.Duration(60)))
        commands = Record(topic, Twist)
        self.assertTrue(wait_for(lambda: commands.subscriber.get_num_connections() > 0))
        client.send_goal(goal)
        self.assertTrue(wait_for(lambda: commands.last is not None and moves(commands.last), 30), 'it never drove')
        resumed = self.freeze_through_a_stop(server)
        self.assertTrue(client.wait_for_result(rospy.Duration(60)), 'it has not ended')
        self.assertEqual(client.get_state(), GoalStatus.ABORTED)
        time.sleep(0.5)  # what is asked of the server before it has read all of that time is aborted, too
        self.assertFalse([command for command in commands.since(resumed) if moves(command)])
        commands.subscriber.unregister()

    def sent_while_the_server_was_frozen(self, server, client, goal, arbiter_dies=False):
        """A goal that is sent while `server` is frozen and the robot is stopped, which is then cleared; its result."""
        self.assertTrue(client.wait_for_server(rospy.Duration(60)))
        commands = Record('cmd_vel', Twist)
        pid = pid_of(server)
        os.kill(pid, signal.SIGSTOP)
        try:
            self.assertTrue(self.stop().success)
            if arbiter_dies:
                # What it has sent to a frozen process is lost with it, and the next one starts stopped.
                self.assertIn('stopped already', replace_the_arbiter().message)
            client.send_goal(goal)
            time.sleep(0.5)
            self.assertTrue(wait_for(self.cleared, 20), 'the stop is not cleared')
        finally:
            resumed = time.monotonic()
            os.kill(pid, signal.SIGCONT)
        self.assertTrue(client.wait_for_result(rospy.Duration(60)), 'it has not ended')
        self.assertFalse([command for command in commands.since(resumed) if moves(command)])
        commands.subscriber.unregister()
        return client.get_result()

    def test_what_is_asked_of_a_frozen_server_while_the_robot_is_stopped_is_aborted_also_after_the_clear(self):
        """[PAT-5] [SPN-4] [FLT-2]"""
        square = PatrolGoal()
        square.goal.x, square.goal.y, square.goal.z = 1, 0.6, 1
        patrols, spins = actionlib.SimpleActionClient('turtlebot3', PatrolAction), actionlib.SimpleActionClient('spin', SpinAction)
        for _ in range(ROUNDS):
            spin = self.sent_while_the_server_was_frozen('/behavior_server', spins, SpinGoal(6.0, rospy.Duration(0), False))
            self.assertEqual(spin.error_msg, 'emergency stop')
            patrol = self.sent_while_the_server_was_frozen('/patrol_server', patrols, square)
            self.assertEqual(patrol.result, 'aborted: emergency stop')

    def test_a_goal_is_aborted_also_if_the_arbiter_that_was_stopped_dies_while_the_server_is_frozen(self):
        """[SPN-4] [FLT-2]"""
        spins = actionlib.SimpleActionClient('spin', SpinAction)
        for _ in range(ROUNDS):
            result = self.sent_while_the_server_was_frozen('/behavior_server', spins, SpinGoal(6.0, rospy.Duration(0), False), True)
            self.assertEqual(result.error_msg, 'emergency stop')

    def test_a_patrol_that_was_frozen_through_a_stop_and_its_clearing_does_not_go_on(self):
        """[PAT-5] [FLT-2]"""
        square = PatrolGoal()
        square.goal.x, square.goal.y, square.goal.z = 1, 0.6, 1
        client = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        reasons = []
        for _ in range(ROUNDS):
            self.frozen_through_a_stop('/patrol_server', 'cmd_vel_patrol', client, square)
            reasons.append(client.get_result().result)
        self.assertIn('aborted: emergency stop', reasons, 'on a busy machine some may be of old odometry')

    def test_a_spin_that_was_frozen_through_a_stop_and_its_clearing_does_not_go_on(self):
        """[SPN-4] [FLT-2]"""
        client = actionlib.SimpleActionClient('spin', SpinAction)
        reasons = []
        for _ in range(ROUNDS):
            self.frozen_through_a_stop('/behavior_server', 'cmd_vel_behavior', client, SpinGoal(6.0, rospy.Duration(0), False))
            reasons.append(client.get_result().error_msg)
        self.assertIn('emergency stop', reasons, 'on a busy machine some may be of an old pose')

    def test_waypoints_whose_server_was_frozen_through_a_stop_and_its_clearing_do_not_go_on(self):
        """[FLT-2]"""
        under_way = threading.Event()

        def drive(_):
            under_way.set()
            while not (navigation.is_preempt_requested() or rospy.is_shutdown()):
                time.sleep(0.02)
            navigation.set_preempted()
        navigation = actionlib.SimpleActionServer('move_base', MoveBaseAction, drive, auto_start=False)
        navigation.start()
        client = actionlib.SimpleActionClient('follow_waypoints', FollowWaypointsAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60)))
        pose = PoseStamped()
        pose.header.frame_id, pose.pose.orientation.w = 'map', 1.0
        client.send_goal(FollowWaypointsGoal([pose, pose]))
        self.assertTrue(under_way.wait(30), 'it never sent a goal')
        self.freeze_through_a_stop('/waypoint_follower')
        self.assertTrue(client.wait_for_result(rospy.Duration(60)), 'they have not ended')
        self.assertEqual(client.get_result().error_code, FollowWaypointsResult.EMERGENCY_STOP)


if __name__ == '__main__':
    rospy.init_node('frozen_servers')
    rostest.rosrun('frontier_pilot', 'frozen_servers', FrozenServers)
