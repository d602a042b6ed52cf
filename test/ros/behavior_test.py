#!/usr/bin/env python3
"""The behaviours on the wire: spin and its ends, straight motions, waiting, replacement, emergency stop."""
import math
import time
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from geometry_msgs.msg import PolygonStamped, Pose2D, Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Empty, SetBool, Trigger

from frontier_pilot.msg import (BackUpAction, BackUpGoal, BackUpResult, DriveOnHeadingAction, DriveOnHeadingActionGoal,
                                DriveOnHeadingGoal, SpinAction, SpinGoal, SpinResult, WaitAction, WaitGoal, WaitResult)
from frontier_pilot.srv import RemoveObstacle, SpawnObstacle


def is_zero(twist):
    return twist.linear.x == 0.0 and twist.angular.z == 0.0


class BehaviorTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Until the server sees: what has just started turns nowhere."""
        client = actionlib.SimpleActionClient('spin', SpinAction)
        if not client.wait_for_server(rospy.Duration(60)):
            raise RuntimeError('no server')
        end = time.monotonic() + 60.0
        while client.send_goal_and_wait(SpinGoal(0.05, rospy.Duration(0), False)) != GoalStatus.SUCCEEDED:
            if time.monotonic() > end:
                raise RuntimeError('the server never turns: ' + client.get_result().error_msg)

    def setUp(self):
        self.commands, self.truth, self.scan_stamps = [], None, []
        self.subscribers = [
            rospy.Subscriber('cmd_vel_behavior', Twist, self.commands.append, queue_size=1000),
            rospy.Subscriber('base_pose_ground_truth', Odometry, self.on_truth, queue_size=1),
            rospy.Subscriber('scan', LaserScan, lambda scan: self.scan_stamps.append(scan.header.stamp), queue_size=100)]
        self.spawned = []
        self.clients = {}
        rospy.wait_for_service('reset_positions', 60)
        rospy.ServiceProxy('reset_positions', Empty)()
        self.until(lambda: all(s.get_num_connections() > 0 for s in self.subscribers), 'connections')
        self.until(lambda: self.truth is not None, 'the truth')
        self.until_scans(10)  # the first ones, and what a jump leaves behind
        del self.commands[:]

    def tearDown(self):
        for client in self.clients.values():
            client.cancel_all_goals()
            self.until(lambda: client.get_state() not in (GoalStatus.PENDING, GoalStatus.ACTIVE), 'the end of a goal')
        for name in self.spawned:
            rospy.ServiceProxy('simulator/remove_obstacle', RemoveObstacle)(name)
        for subscriber in self.subscribers:
            subscriber.unregister()

    def on_truth(self, msg):
        self.truth = msg

    def until(self, condition, what, seconds=30.0):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, 'waited in vain for ' + what)
            time.sleep(0.005)

    def until_scans(self, count):
        """Until so many scans have come that were measured from now on: what they show, the server knows too."""
        now = rospy.Time.now()
        self.until(lambda: sum(stamp > now for stamp in list(self.scan_stamps)) >= count, 'scans')

    def until_it_stands(self):
        now = rospy.Time.now()

        def stands():
            twist = self.truth.twist.twist
            return self.truth.header.stamp > now and abs(twist.linear.x) + abs(twist.angular.z) < 1e-6
        self.until(stands, 'the robot to stand')

    def pose(self):
        q, p = self.truth.pose.pose.orientation, self.truth.pose.pose.position
        return p.x, p.y, 2.0 * math.atan2(q.z, q.w)

    def spawn(self, distance, bearing, radius=0.02):
        x, y, yaw = self.pose()
        name = 'obstacle%d' % len(self.spawned)
        at = Pose2D(x + distance * math.cos(yaw + bearing), y + distance * math.sin(yaw + bearing), 0.0)
        answer = rospy.ServiceProxy('simulator/spawn_obstacle', SpawnObstacle)(name, at, radius)
        self.assertTrue(answer.success, answer.message)
        self.spawned.append(name)
        self.until_scans(5)

    def send(self, name, action, goal):
        if name not in self.clients:
            self.clients[name] = actionlib.SimpleActionClient(name, action)
            self.assertTrue(self.clients[name].wait_for_server(rospy.Duration(60)), name)
        self.feedback = []
        self.clients[name].send_goal(goal, feedback_cb=self.feedback.append)

    def spin(self, yaw, allowance=0.0, unchecked=False, name='spin'):
        self.send(name, SpinAction, SpinGoal(yaw, rospy.Duration(allowance), unchecked))

    def end(self, name='spin'):
        self.assertTrue(self.clients[name].wait_for_result(rospy.Duration(60)))
        return self.clients[name].get_state(), self.clients[name].get_result()

    def expect(self, state, code, name='spin'):
        got, result = self.end(name)
        self.assertEqual((got, result.error_code), (state, code), result.error_msg)
        return result

    def moving(self, name='spin'):
        """Until it moves; a goal that has ended by then says why it did."""
        def begun():
            result = self.clients[name].get_result()
            self.assertIsNone(result, result and result.error_msg)
            return self.commands and not is_zero(self.commands[-1])
        self.until(begun, 'motion')

    def assert_silent_after_zero(self):
        self.until(lambda: is_zero(self.commands[-1]), 'zero')
        self.until_it_stands()
        said = len(self.commands)
        self.until_scans(5)  # a second
        self.assertEqual(len(self.commands), said)

    def test_spin_ends_at_its_yaw_with_result_and_feedback(self):
        """[SPN-1] [SPN-4]"""
        for target in (1.57, -2.5, 4.0):
            before = self.pose()[2]
            self.spin(target)
            result = self.expect(GoalStatus.SUCCEEDED, SpinResult.NONE)
            self.until_it_stands()
            turned = math.remainder(self.pose()[2] - before - target, 2.0 * math.pi)
            self.assertLess(abs(turned), 0.05)
            self.assertAlmostEqual(result.angular_distance_traveled, target, delta=0.05)
            self.assertGreater(len(self.feedback), 5)
        self.assert_silent_after_zero()

    def test_an_obstacle_in_the_way_of_a_turn_is_seen_before_anything_moves(self):
        """[SPN-2]"""
        self.spawn(0.15, 2.75)  # 0.2 rad ahead of the corner on the left behind, which is 0.15 m away
        self.spin(1.5)
        self.expect(GoalStatus.ABORTED, SpinResult.COLLISION_AHEAD)
        self.assertTrue(all(is_zero(command) for command in self.commands), self.commands)
        self.spin(0.1, unchecked=True)
        self.expect(GoalStatus.SUCCEEDED, SpinResult.NONE)

    def test_an_obstacle_that_appears_stops_the_turn(self):
        """[SPN-3]"""
        self.spin(6.0)
        self.moving()
        self.spawn(0.15, 2.8)
        result = self.expect(GoalStatus.ABORTED, SpinResult.COLLISION_AHEAD)
        self.assertIn('obstacle', result.error_msg)
        self.assert_silent_after_zero()

    def test_timeout_invalid_goals_and_a_zero_target(self):
        """[SPN-1] [SPN-4]"""
        self.spin(6.0, allowance=1.0)
        self.expect(GoalStatus.ABORTED, SpinResult.TIMEOUT)
        self.spin(float('nan'))
        self.expect(GoalStatus.ABORTED, SpinResult.INVALID_GOAL)
        self.spin(1.0, allowance=-1.0)
        self.expect(GoalStatus.ABORTED, SpinResult.INVALID_GOAL)
        self.spin(0.0)
        self.expect(GoalStatus.SUCCEEDED, SpinResult.NONE)

    def test_cancel_sends_zero_and_tells_the_amount_done(self):
        """[SPN-5]"""
        self.spin(6.0)
        self.until(lambda: self.feedback and self.feedback[-1].angular_distance_traveled > 0.3, 'a part of the turn')
        asked = time.monotonic()
        self.clients['spin'].cancel_goal()
        self.until(lambda: is_zero(self.commands[-1]), 'zero')
        print('cancel to zero: %.1f ms' % ((time.monotonic() - asked) * 1e3))
        result = self.expect(GoalStatus.PREEMPTED, SpinResult.CANCELED)
        self.assertGreater(result.angular_distance_traveled, 0.3)
        self.assertLess(result.angular_distance_traveled, 5.0)
        self.assert_silent_after_zero()

    def test_without_transform_or_scan_nothing_moves(self):
        """[SPN-1] [SPN-3]"""
        self.spin(1.0, name='lost/spin')
        self.expect(GoalStatus.ABORTED, SpinResult.TF_ERROR, 'lost/spin')
        self.spin(1.0, name='blind/spin')
        result = self.expect(GoalStatus.ABORTED, SpinResult.COLLISION_AHEAD, 'blind/spin')
        self.assertIn('no fresh scan', result.error_msg)

    def test_an_emergency_stop_ends_it_and_nothing_resumes(self):
        """[SPN-4]"""
        stop, clear = rospy.ServiceProxy('emergency_stop', Trigger), rospy.ServiceProxy('set_emergency_stop', SetBool)
        self.spin(6.0)
        self.moving()
        self.assertTrue(stop().success)
        result = self.expect(GoalStatus.ABORTED, SpinResult.NO_PROGRESS)
        self.assertEqual(result.error_msg, 'emergency stop')
        self.until(lambda: clear(False).success, 'the stop to be cleared')
        self.assert_silent_after_zero()

    def test_without_the_wheels_there_is_no_progress(self):
        """[SPN-4]"""
        enable = rospy.ServiceProxy('set_behavior_enabled', SetBool)
        enable(False)
        self.spin(6.0)
        result = self.end()[1]
        enable(True)
        self.assertEqual(result.error_code, SpinResult.NO_PROGRESS)

    def test_straight_motions_go_their_distance_and_stop_before_obstacles(self):
        """[SPN-5]"""
        x, y, _ = self.pose()
        self.send('drive_on_heading', DriveOnHeadingAction, DriveOnHeadingGoal(target_distance=0.3, speed=0.15))
        self.expect(GoalStatus.SUCCEEDED, 0, 'drive_on_heading')
        self.send('back_up', BackUpAction, BackUpGoal(target_distance=0.3))
        result = self.expect(GoalStatus.SUCCEEDED, BackUpResult.NONE, 'back_up')
        self.assertAlmostEqual(result.distance_traveled, 0.3, delta=0.01)
        self.assertLess(math.hypot(self.pose()[0] - x, self.pose()[1] - y), 0.02)
        self.spawn(0.3, math.pi, 0.05)
        self.send('back_up', BackUpAction, BackUpGoal(target_distance=0.5))
        result = self.expect(GoalStatus.ABORTED, BackUpResult.COLLISION_AHEAD, 'back_up')
        self.assertLess(result.distance_traveled, 0.15)

    def test_wait_counts_ros_time_and_a_newer_behaviour_replaces_it(self):
        """[SPN-5]"""
        began = rospy.Time.now()
        self.send('wait', WaitAction, WaitGoal(time=rospy.Duration(2)))
        result = self.expect(GoalStatus.SUCCEEDED, WaitResult.NONE, 'wait')
        self.assertGreaterEqual((rospy.Time.now() - began).to_sec(), 2.0)
        self.assertLess(result.total_elapsed_time.to_sec(), 2.5)
        self.send('wait', WaitAction, WaitGoal(time=rospy.Duration(60)))
        self.until(lambda: self.feedback, 'the wait to begin')
        self.spin(0.5)
        replaced = self.expect(GoalStatus.PREEMPTED, WaitResult.CANCELED, 'wait')
        self.assertEqual(replaced.error_msg, 'replaced by a newer goal')
        self.expect(GoalStatus.SUCCEEDED, SpinResult.NONE)

    def test_a_goal_that_its_cancel_overtook_ends_the_behaviour_that_it_would_have_replaced(self):
        """[SPN-5]"""
        known = set()
        goals = rospy.Publisher('drive_on_heading/goal', DriveOnHeadingActionGoal, queue_size=1)
        cancels = rospy.Publisher('drive_on_heading/cancel', GoalID, queue_size=1)
        statuses = rospy.Subscriber('drive_on_heading/status', GoalStatusArray,
                                    lambda msg: known.update(status.goal_id.id for status in msg.status_list))
        for wire in (goals, cancels, statuses):
            self.addCleanup(wire.unregister)
        self.until(lambda: goals.get_num_connections() > 0 and cancels.get_num_connections() > 0, 'connections')
        self.spin(6.0)
        self.moving()
        cancels.publish(GoalID(id='early'))
        self.until(lambda: 'early' in known, 'the cancel to be known')
        goals.publish(DriveOnHeadingActionGoal(goal_id=GoalID(id='early'),
                                               goal=DriveOnHeadingGoal(target_distance=0.3, speed=0.15)))
        result = self.expect(GoalStatus.PREEMPTED, SpinResult.CANCELED)
        self.assertEqual(result.error_msg, 'replaced by a newer goal, which was canceled')
        self.assert_silent_after_zero()

    def test_the_footprint_is_the_outline_of_the_robot_in_its_base_frame(self):
        """[ROB-1]"""
        for topic, front, side in (('footprint', 0.037, 0.089), ('blind/footprint', 0.077, 0.153)):
            outline = rospy.wait_for_message(topic, PolygonStamped, 30)
            self.assertEqual(outline.header.frame_id, 'base_footprint')
            self.assertAlmostEqual(max(point.x for point in outline.polygon.points), front, 6)
            self.assertAlmostEqual(max(point.y for point in outline.polygon.points), side, 6)


if __name__ == '__main__':
    rospy.init_node('behavior_test')
    rostest.rosrun('frontier_pilot', 'behavior', BehaviorTest)
