#!/usr/bin/env python3
"""Waypoints on the wire: their order, and what a missed one, a cancel, a stop and a goal of somebody else do to them."""
import math
import unittest

import actionlib
import rosnode
import rospy
import rostest
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from frontier_pilot.msg import ArbiterSource, ArbiterStatus
from frontier_pilot.msg import ExplorerStatus, FollowWaypointsAction, FollowWaypointsGoal, FollowWaypointsResult
from geometry_msgs.msg import PoseArray, PoseStamped
from move_base_msgs.msg import MoveBaseAction
from nav_msgs.msg import Odometry
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

from wire import Record, call, clear, emergency_stop, hears, wait_for

# In the room where the robot starts, which is the origin.
NEAR, MIDDLE, FAR = (0.4, 0.0), (0.9, 0.0), (1.4, 0.0)
OUTSIDE = (30.0, 0.0)


def pose(place, frame='map'):
    msg = PoseStamped()
    msg.header.frame_id = frame
    msg.pose.position.x, msg.pose.position.y = place
    msg.pose.orientation.w = 1.0
    return msg


class WaypointsOnTheWire(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('waypoints_wire')
        cls.odom = Record('odom', Odometry)
        cls.goals = Record('move_base/status', GoalStatusArray)
        cls.exploration = Record('frontier_explorer/status', ExplorerStatus)
        cls.collected = Record('waypoint_follower/waypoints', PoseArray)
        cls.client = actionlib.SimpleActionClient('follow_waypoints', FollowWaypointsAction)
        assert cls.client.wait_for_server(rospy.Duration(60.0))
        assert wait_for(lambda: cls.goals.last and cls.odom.last and cls.exploration.last, 60.0)
        cls.legs, cls.trouble = [], ''
        cls.navigation = actionlib.SimpleActionServer('elsewhere/move_base', MoveBaseAction, cls.give_up, auto_start=False)
        cls.navigation.start()

    @classmethod
    def give_up(cls, goal):
        """The navigation of the follower elsewhere."""
        cls.legs.append(goal)
        cls.navigation.set_aborted(text=cls.trouble)

    def setUp(self):
        self.assertTrue(clear())
        self.visited = []

    def tearDown(self):
        # By its id: a cancel of all might be read only after the goal of the next test, which comes by another connection.
        if self.client.simple_state != actionlib.SimpleGoalState.DONE:
            self.client.cancel_goal()
        self.assertTrue(wait_for(lambda: not self.active(), 10.0))

    def follow(self, *places):
        self.client.send_goal(FollowWaypointsGoal(poses=[pose(place) for place in places]),
                              feedback_cb=lambda feedback: self.visited.append(feedback.current_waypoint))

    def active(self):
        return [goal for goal in self.goals.last.status_list if goal.status in (GoalStatus.PENDING, GoalStatus.ACTIVE)]

    def at(self):
        position = self.odom.last.pose.pose.position
        return position.x, position.y

    def is_at(self, place):
        return math.dist(self.at(), place) < 0.3

    def drives(self):
        return self.odom.last.twist.twist.linear.x > 0.1

    def moves(self):
        return self.drives() or abs(self.odom.last.twist.twist.angular.z) > 0.1

    def stands(self):
        twist = self.odom.last.twist.twist
        return abs(twist.linear.x) < 1e-6 and abs(twist.angular.z) < 1e-6

    def expect_end(self, state, code, timeout=60.0):
        done = actionlib.SimpleGoalState.DONE
        self.assertTrue(wait_for(lambda: self.client.simple_state == done, timeout), self.at())
        self.assertEqual(state, self.client.get_state(), self.client.get_goal_status_text())
        self.assertEqual(code, self.client.get_result().error_code, self.client.get_result())
        return self.client.get_result()

    def expect_standstill(self):
        self.assertTrue(wait_for(lambda: self.stands() and not self.active(), 5.0))
        self.assertFalse(wait_for(lambda: not self.stands(), 1.0), 'nothing goes on')

    def start_driving(self):
        self.follow(FAR if self.is_at(NEAR) or self.at()[0] < 0.7 else NEAR, MIDDLE)
        self.assertTrue(wait_for(self.moves, 20.0))

    def test_are_gone_to_in_their_order_without_those_that_cannot_be_reached(self):  # [NAV-5]
        self.follow(MIDDLE, OUTSIDE, FAR, NEAR)
        result = self.expect_end(GoalStatus.SUCCEEDED, FollowWaypointsResult.NONE, 90.0)
        self.assertEqual([1, 2, 3], self.visited[-3:])  # the first may be told before this client is connected
        self.assertEqual([1], list(result.missed_waypoints))
        self.assertEqual('3 of 4 waypoints reached, missed: 2', self.client.get_goal_status_text())
        self.assertTrue(self.is_at(NEAR), self.at())

    def test_a_cancel_stops_the_robot(self):  # [NAV-5]
        self.start_driving()
        self.client.cancel_goal()
        self.expect_end(GoalStatus.PREEMPTED, FollowWaypointsResult.CANCELED, 5.0)
        self.expect_standstill()

    def test_an_emergency_stop_ends_them_and_nothing_goes_on_when_it_is_cleared(self):  # [NAV-5]
        self.start_driving()
        self.assertTrue(emergency_stop().success)
        self.expect_end(GoalStatus.ABORTED, FollowWaypointsResult.EMERGENCY_STOP, 5.0)
        self.assertTrue(clear())
        self.expect_standstill()

    def test_a_goal_of_somebody_else_wins(self):  # [NAV-5]
        goals = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=1)
        self.assertTrue(wait_for(lambda: goals.get_num_connections() > 0))
        self.start_driving()
        goals.publish(pose(MIDDLE))
        result = self.expect_end(GoalStatus.ABORTED, FollowWaypointsResult.REPLACED, 5.0)
        self.assertIn('preempted', result.error_msg)
        self.assertTrue(wait_for(lambda: self.is_at(MIDDLE) and not self.active(), 40.0), 'the other goal is gone to')

    def test_a_cancel_of_the_navigation_ends_them(self):  # [NAV-5]
        cancels = rospy.Publisher('move_base/cancel', GoalID, queue_size=1)
        self.assertTrue(wait_for(lambda: cancels.get_num_connections() > 0))
        self.start_driving()
        cancels.publish(GoalID())
        self.expect_end(GoalStatus.ABORTED, FollowWaypointsResult.REPLACED, 5.0)
        self.expect_standstill()

    def test_a_navigator_that_is_restarted_gets_the_goal_again(self):  # [NAV-5] [FLT-2]
        self.start_driving()
        rosnode.kill_nodes(['/navigator'])
        result = self.expect_end(GoalStatus.SUCCEEDED, FollowWaypointsResult.NONE, 60.0)
        self.assertEqual([], list(result.missed_waypoints))
        self.assertTrue(self.is_at(MIDDLE))

    def test_come_before_an_explorer_that_waited_for_them_when_the_navigator_is_restarted(self):  # [EXP-11] [FLT-2]
        self.start_driving()
        self.assertTrue(call('set_exploration_enabled', SetBool, True).success)
        try:
            self.assertTrue(wait_for(lambda: self.exploration.last.reason == ExplorerStatus.OTHERS_GOAL))
            rosnode.kill_nodes(['/navigator'])
            result = self.expect_end(GoalStatus.SUCCEEDED, FollowWaypointsResult.NONE, 60.0)
        finally:
            call('set_exploration_enabled', SetBool, False)
        self.assertEqual([], list(result.missed_waypoints))

    def expect_no_fault_of_the_places(self, trouble):
        self.legs.clear()
        type(self).trouble = trouble
        client = self.client
        self.addCleanup(setattr, self, 'client', client)
        self.client = actionlib.SimpleActionClient('elsewhere/follow_waypoints', FollowWaypointsAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(60.0)))
        self.follow(NEAR, MIDDLE, FAR)
        result = self.expect_end(GoalStatus.ABORTED, FollowWaypointsResult.NAVIGATION_UNABLE, 20.0)
        self.assertIn(trouble, result.error_msg)
        self.assertEqual([], list(result.missed_waypoints))
        self.assertEqual(1, len(self.legs))
        return result

    def test_end_when_the_navigation_can_drive_nowhere_which_is_no_fault_of_the_places(self):  # [NAV-5]
        self.expect_no_fault_of_the_places('not localised')

    def test_end_when_the_navigation_fails_while_the_arbiter_ignores_it(self):  # [NAV-5]
        arbiter = rospy.Publisher('elsewhere/cmd_vel_arbiter/status', ArbiterStatus, queue_size=1)
        nav = ArbiterSource(name='nav', topic='/elsewhere/cmd_vel_nav', enabled=False)
        timer = rospy.Timer(rospy.Duration(0.1), lambda _: arbiter.publish(ArbiterStatus(sources=[nav])))
        self.addCleanup(timer.shutdown)
        self.assertTrue(wait_for(lambda: arbiter.get_num_connections() > 0))
        seen = Record('elsewhere/cmd_vel_arbiter/status', ArbiterStatus)
        self.addCleanup(seen.subscriber.unregister)
        self.assertTrue(wait_for(lambda: len(seen.items) > 5), 'the follower has heard of it, too')
        self.assertIn('source nav', self.expect_no_fault_of_the_places('blocked').error_msg)

    def test_malformed_ones_are_refused_with_the_reason(self):  # [FLT-1]
        self.client.send_goal(FollowWaypointsGoal(poses=[pose(NEAR), pose((float('nan'), 0.0))]))
        result = self.expect_end(GoalStatus.ABORTED, FollowWaypointsResult.INVALID_GOAL, 5.0)
        self.assertIn('waypoint 2: ', result.error_msg)
        self.client.send_goal(FollowWaypointsGoal())
        result = self.expect_end(GoalStatus.ABORTED, FollowWaypointsResult.INVALID_GOAL, 5.0)
        self.assertEqual('there are no waypoints', result.error_msg)

    def test_may_be_collected_one_by_one_as_rviz_publishes_them(self):  # [NAV-5]
        self.assertFalse(call('waypoint_follower/start', Trigger).success)
        add = rospy.Publisher('waypoint_follower/add', PoseStamped, queue_size=10)
        self.assertTrue(wait_for(lambda: add.get_num_connections() > 0))
        places = (FAR, NEAR)
        for msg in (pose(FAR), pose(NEAR, 'odom'), pose((float('inf'), 0.0)), pose(NEAR)):
            add.publish(msg)
        self.assertTrue(wait_for(lambda: self.collected.last and len(self.collected.last.poses) == 2))
        self.assertEqual(places, tuple((at.position.x, at.position.y) for at in self.collected.last.poses))
        self.assertTrue(emergency_stop().success)
        stopped = 'the robot is stopped'
        self.assertTrue(wait_for(lambda: call('waypoint_follower/start', Trigger).message.startswith(stopped), 5.0))
        self.assertFalse(call('waypoint_follower/start', Trigger).success)
        self.assertTrue(clear())
        self.assertTrue(wait_for(lambda: call('waypoint_follower/start', Trigger).success, 5.0))
        for place in places:
            self.assertTrue(wait_for(lambda at=place: self.is_at(at), 40.0), self.at())
        self.assertTrue(wait_for(lambda: not self.active(), 20.0))
        self.assertTrue(call('waypoint_follower/clear', Trigger).success)
        self.assertTrue(wait_for(lambda: not self.collected.last.poses))

    def test_that_were_collected_are_no_longer_driven_to_once_they_are_taken_back(self):  # [NAV-5]
        add = rospy.Publisher('waypoint_follower/add', PoseStamped, queue_size=10)
        self.assertTrue(wait_for(lambda: add.get_num_connections() > 0))
        add.publish(pose(FAR if self.at()[0] < 0.7 else NEAR))
        add.publish(pose(MIDDLE))
        self.assertTrue(wait_for(lambda: self.collected.last and len(self.collected.last.poses) == 2))
        self.assertTrue(wait_for(lambda: call('waypoint_follower/start', Trigger).success, 5.0))
        self.assertTrue(wait_for(self.moves, 20.0))
        answer = call('waypoint_follower/clear', Trigger)
        self.assertEqual((True, '2 waypoints taken back, and the drive to them is ended'), (answer.success, answer.message))
        self.expect_standstill()
        self.start_driving()
        self.assertEqual('0 waypoints taken back', call('waypoint_follower/clear', Trigger).message)
        self.expect_end(GoalStatus.SUCCEEDED, FollowWaypointsResult.NONE)  # those of an action are of somebody else

    def test_do_not_outlive_the_map_on_which_they_were_given(self):  # [NAV-5] [MAP-5]
        add = rospy.Publisher('waypoint_follower/add', PoseStamped, queue_size=10)
        replaced = rospy.Publisher('mapper/replaced', String, queue_size=1)
        self.addCleanup(replaced.unregister)
        self.assertTrue(wait_for(lambda: add.get_num_connections() > 0 and hears('/waypoint_follower', '/mapper/replaced')))
        add.publish(pose(FAR if self.at()[0] < 0.7 else NEAR))
        add.publish(pose(MIDDLE))
        self.assertTrue(wait_for(lambda: self.collected.last and len(self.collected.last.poses) == 2))
        self.assertTrue(wait_for(lambda: call('waypoint_follower/start', Trigger).success, 5.0))
        self.assertTrue(wait_for(self.moves, 20.0))
        replaced.publish('floor.yaml loaded')
        self.assertTrue(wait_for(lambda: not self.collected.last.poses), '[MAP-5]')
        self.assertEqual('no waypoints were added', call('waypoint_follower/start', Trigger).message)
        self.expect_standstill()

    def test_that_were_collected_do_not_outlive_a_map_that_the_navigation_took_for_another(self):  # [NAV-5] [NAV-1]
        collected = Record('elsewhere/waypoint_follower/waypoints', PoseArray)
        self.addCleanup(collected.subscriber.unregister)
        add = rospy.Publisher('elsewhere/waypoint_follower/add', PoseStamped, queue_size=1)
        self.addCleanup(add.unregister)
        self.assertTrue(wait_for(lambda: add.get_num_connections() > 0))
        add.publish(pose(NEAR))
        self.assertTrue(wait_for(lambda: collected.last and len(collected.last.poses) == 1))
        type(self).trouble = 'the map was replaced'
        self.assertTrue(wait_for(lambda: call('elsewhere/waypoint_follower/start', Trigger).success, 5.0))
        self.assertTrue(wait_for(lambda: not collected.last.poses), '[NAV-1]')


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'waypoints', WaypointsOnTheWire)
