#!/usr/bin/env python3
"""The navigator on the wire: how goals end and that the wheels stand then, make_plan, and missing map or scans."""
import math
import time
import unittest

import actionlib
import rospy
import rostest
import tf2_ros
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from frontier_pilot.msg import NavigatorProgress
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from move_base_msgs.msg import MoveBaseAction, MoveBaseActionGoal, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from nav_msgs.srv import GetPlan
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, String
from std_srvs.srv import Empty

from wire import Record, call, moves, wait_for

START = (0.7, 0.8)       # in the world; the origin of map and odom
NEAR = (1.5, 0.0)        # in the same room
FAR = (3.3, 2.4)         # in the other room
IN_BOX = (0.8, 1.05)     # inside of a solid box
OUTSIDE = (20.0, 0.0)


def pose(place, frame='map', yaw=0.0):
    msg = PoseStamped()
    msg.header.frame_id = frame
    msg.pose.position.x, msg.pose.position.y = place
    msg.pose.orientation.z, msg.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return msg


class NavigatorOnTheWire(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('navigator_wire')
        cls.commands = Record('cmd_vel_nav', Twist)
        cls.odom = Record('odom', Odometry)
        cls.plan = Record('plan', Path)
        cls.costmap = Record('local_costmap', OccupancyGrid)
        cls.status = Record('navigator/status', String)
        cls.goals = Record('move_base/status', GoalStatusArray)
        # Subscribed to long before a goal is sent: a publisher learns of its subscriber later than that of the connection.
        cls.current_goal = Record('move_base/current_goal', PoseStamped)
        cls.progress = Record('navigator/progress', NavigatorProgress)
        cls.stalled = Record('simulator/stalled', Bool)
        cls.world = Record('simulator/world', OccupancyGrid)
        cls.pass_on = True
        cls.scans = rospy.Publisher('scan_passed_on', LaserScan, queue_size=1)
        cls.scan_in = rospy.Subscriber('scan', LaserScan, lambda scan: cls.pass_on and cls.scans.publish(scan))
        cls.frames = tf2_ros.StaticTransformBroadcaster()
        cls.publish_frame()
        cls.publish_map()
        cls.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        assert cls.client.wait_for_server(rospy.Duration(30.0))

    @classmethod
    def tearDownClass(cls):
        cls.scan_in.unregister()

    @classmethod
    def publish_frame(cls):
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'map', 'odom'
        transform.transform.rotation.w = 1.0
        cls.frames.sendTransform(transform)

    @classmethod
    def publish_map(cls):
        assert wait_for(lambda: cls.world.last is not None, 20.0)
        grid = cls.world.last
        grid.header.frame_id = 'map'
        grid.info.origin.position.x, grid.info.origin.position.y = -START[0], -START[1]
        cls.map = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        cls.map.publish(grid)

    def setUp(self):
        type(self).pass_on = True
        call('reset_positions', Empty)
        self.assertTrue(wait_for(lambda: self.odom.last and abs(self.odom.last.pose.pose.position.x) < 0.05))
        # A goal that comes before the transform of the reset would be reached at once where the last test has ended.
        self.assertTrue(wait_for(self.navigator_is_at_the_start))

    def tearDown(self):
        if not self.ended():
            self.client.cancel_goal()  # not all goals: that might overtake the next one
        self.assertTrue(wait_for(self.stands))
        self.assertFalse(any(msg.data for _, msg in self.stalled.items), 'no contact [NAV-4]')

    @staticmethod
    def navigator_is_at_the_start():
        poses = call('make_plan', GetPlan, PoseStamped(), pose(NEAR), 0.0).plan.poses
        return bool(poses) and math.hypot(poses[0].pose.position.x, poses[0].pose.position.y) < 0.1

    def send(self, place, **how):
        self.client.send_goal(MoveBaseGoal(target_pose=pose(place, **how)))

    def stop_state(self):
        stop = rospy.Publisher('emergency_stop_state', Bool, queue_size=10, latch=True)
        self.addCleanup(stop.unregister)
        self.assertTrue(wait_for(lambda: stop.get_num_connections() > 0))
        return stop

    def ended(self):
        return self.client.simple_state == actionlib.SimpleGoalState.DONE

    def stands(self):
        return self.odom.last is not None and abs(self.odom.last.twist.twist.linear.x) < 1e-6

    def drives(self):
        return self.odom.last is not None and self.odom.last.twist.twist.linear.x > 0.1

    def expect_end(self, state, text, timeout=40.0):
        self.assertTrue(wait_for(self.ended, timeout), self.status.last)
        self.assertEqual(self.client.get_state(), state, self.client.get_goal_status_text())
        self.assertIn(text, self.client.get_goal_status_text())
        # The result and the last command come by different connections.
        self.assertTrue(wait_for(lambda: not moves(self.commands.last), 1.0), 'zero at every end')
        count = len(self.commands.items)
        self.assertTrue(wait_for(self.stands, 5.0))
        self.assertLessEqual(len(self.commands.items), count + 1, 'silent without a goal')

    def expect_standstill(self):
        # Odometry and the commands come by different connections.
        self.assertTrue(wait_for(lambda: not self.drives() and not moves(self.commands.last), 2.0),
                        'nothing is driven to any more [NAV-1]')
        ended = time.monotonic()
        self.assertFalse(wait_for(lambda: any(moves(command) for command in self.commands.since(ended)), 0.5),
                         'nor taken up again')

    def status_of(self, goal_id):
        return next((goal.status for goal in self.goals.last.status_list if goal.goal_id.id == goal_id), None)

    def test_reaches_a_goal_in_the_other_room(self):  # [NAV-1] [NAV-4]
        self.send(FAR, yaw=1.0)
        self.assertTrue(wait_for(lambda: self.plan.last and len(self.plan.last.poses) > 20))
        self.expect_end(GoalStatus.SUCCEEDED, 'goal reached')
        at = self.odom.last.pose.pose
        self.assertLess(math.hypot(at.position.x - FAR[0], at.position.y - FAR[1]), 0.2)
        self.assertLess(abs(2 * math.atan2(at.orientation.z, at.orientation.w) - 1.0), 0.2)
        self.assertIsNotNone(self.costmap.last)

    def test_says_how_far_it_is_and_what_the_present_goal_is(self):  # [NAV-1]
        progress, start = self.progress, time.monotonic()
        self.send(FAR)
        self.assertTrue(wait_for(lambda: self.current_goal.since(start)))
        self.assertEqual(self.current_goal.last.header.frame_id, 'map')
        self.assertAlmostEqual(self.current_goal.last.pose.position.x, FAR[0])
        self.assertTrue(wait_for(lambda: progress.last and progress.last.has_goal and progress.last.distance_left > 3.0))
        first = progress.last
        self.assertAlmostEqual(first.goal.position.y, FAR[1])
        self.assertGreater(first.time_left, 5.0)
        self.assertTrue(wait_for(lambda: progress.last.distance_left < first.distance_left - 0.5))
        self.assertIn('driving', progress.last.status)
        self.client.cancel_goal()
        self.assertTrue(wait_for(lambda: not progress.last.has_goal))
        self.assertIn('canceled', progress.last.status)

    def test_a_newer_goal_preempts_without_a_stop(self):  # [NAV-1]
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        first = self.client.gh
        other = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        self.assertTrue(other.wait_for_server(rospy.Duration(10.0)))
        start = time.monotonic()
        other.send_goal(MoveBaseGoal(target_pose=pose(NEAR)))
        self.assertTrue(wait_for(lambda: first.get_goal_status() == GoalStatus.PREEMPTED))
        self.assertIn('preempted by a newer goal', first.get_goal_status_text())
        self.assertTrue(all(moves(msg) for msg in self.commands.since(start)[:3]), 'the wheels go on')
        self.assertTrue(wait_for(lambda: other.get_state() == GoalStatus.SUCCEEDED, 30.0))

    def test_cancel_stops_at_once(self):  # [NAV-1]
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        self.client.cancel_goal()
        self.expect_end(GoalStatus.PREEMPTED, 'canceled', 2.0)

    def test_a_goal_does_not_outlive_its_map(self):  # [NAV-1]
        replaced = rospy.Publisher('mapper/replaced', String, queue_size=1)
        self.addCleanup(replaced.unregister)
        self.assertTrue(wait_for(lambda: replaced.get_num_connections() > 0))
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        replaced.publish('floor.yaml loaded')
        self.expect_end(GoalStatus.ABORTED, 'the map was replaced', 2.0)

    def test_no_goal_outlives_a_stop_and_none_that_comes_meanwhile_commands_motion(self):  # [ARB-8]
        stop = self.stop_state()
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        stop.publish(True)
        self.expect_end(GoalStatus.PREEMPTED, 'canceled', 2.0)
        start = time.monotonic()
        self.send(FAR)
        self.expect_end(GoalStatus.PREEMPTED, 'canceled', 2.0)
        stop.publish(False)
        self.assertFalse(wait_for(self.drives, 1.0))
        self.assertFalse([msg for msg in self.commands.since(start) if moves(msg)])

    def test_a_stop_that_is_cleared_at_once_ends_the_goal_as_well(self):  # [ARB-8]
        stop = self.stop_state()
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        stop.publish(True)
        stop.publish(False)
        self.expect_end(GoalStatus.PREEMPTED, 'canceled', 2.0)

    def test_a_cancel_of_a_goal_that_has_just_replaced_another_ends_both(self):  # [NAV-1]
        for _ in range(5):
            self.send(FAR)
            self.assertTrue(wait_for(self.drives))
            self.send(NEAR)
            self.client.cancel_goal()  # before the navigator has begun with the newer one, as a rule
            self.assertTrue(wait_for(self.ended, 2.0))
            # The goal and its cancel come on connections of their own: either may be the first. If a status that was sent
            # before the goal arrived comes after the cancel, rospy's client calls the goal lost.
            self.assertIn(self.client.get_state(), (GoalStatus.PREEMPTED, GoalStatus.RECALLED, GoalStatus.LOST))
            self.expect_standstill()

    def test_a_cancel_that_comes_before_its_goal_ends_what_the_goal_was_to_replace(self):  # [NAV-1]
        goals = rospy.Publisher('move_base/goal', MoveBaseActionGoal, queue_size=1)
        cancels = rospy.Publisher('move_base/cancel', GoalID, queue_size=1)
        self.assertTrue(wait_for(lambda: goals.get_num_connections() > 0 and cancels.get_num_connections() > 0))
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        newer = MoveBaseActionGoal(goal_id=GoalID(id='recalled'), goal=MoveBaseGoal(target_pose=pose(NEAR)))
        cancels.publish(newer.goal_id)
        self.assertTrue(wait_for(lambda: self.status_of('recalled') == GoalStatus.RECALLING))
        self.assertTrue(self.drives(), 'a cancel alone ends nothing else')
        goals.publish(newer)
        self.assertTrue(wait_for(lambda: self.status_of('recalled') == GoalStatus.RECALLED))
        self.expect_end(GoalStatus.PREEMPTED, 'canceled', 2.0)
        self.expect_standstill()

    def test_aborts_say_why(self):  # [NAV-1]
        for place, text in ((IN_BOX, 'goal occupied'), (OUTSIDE, 'goal outside')):
            self.send(place)
            self.expect_end(GoalStatus.ABORTED, text, 5.0)

    def test_malformed_goals_are_rejected(self):
        self.send(NEAR, frame='no_such_frame')
        self.assertTrue(wait_for(self.ended))
        self.assertEqual(self.client.get_state(), GoalStatus.REJECTED)
        self.send((float('nan'), 0.0))
        self.assertTrue(wait_for(self.ended))
        self.assertEqual(self.client.get_state(), GoalStatus.REJECTED)
        self.assertIn('invalid goal', self.client.get_goal_status_text())

    def test_takes_goals_from_rviz(self):
        publisher = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=1)
        self.assertTrue(wait_for(lambda: publisher.get_num_connections() > 0))
        publisher.publish(pose(NEAR))
        self.assertTrue(wait_for(lambda: 'goal reached' in self.status.last.data and
                                 abs(self.odom.last.pose.pose.position.x - NEAR[0]) < 0.2, 30.0))

    def test_a_goal_from_rviz_is_in_the_status_and_is_cancelled_like_any_other(self):  # [NAV-1] [EXP-11]
        goals = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=1)
        cancels = rospy.Publisher('move_base/cancel', GoalID, queue_size=1)
        self.assertTrue(wait_for(lambda: goals.get_num_connections() > 0 and cancels.get_num_connections() > 0))
        goals.publish(pose(FAR))
        self.assertTrue(wait_for(self.drives))
        active = [goal.goal_id.id for goal in self.goals.last.status_list if goal.status == GoalStatus.ACTIVE]
        self.assertEqual(1, len(active), self.goals.last)
        cancels.publish(GoalID())
        self.assertTrue(wait_for(lambda: self.status_of(active[0]) == GoalStatus.PREEMPTED), self.goals.last)
        self.expect_standstill()

    def test_make_plan_plans_without_driving(self):
        result = call('make_plan', GetPlan, pose((0.0, 0.0)), pose(FAR), 0.0)
        self.assertGreater(len(result.plan.poses), 20)
        from_here = call('make_plan', GetPlan, PoseStamped(), pose(NEAR), 0.0)
        self.assertAlmostEqual(from_here.plan.poses[0].pose.position.x, 0.0, delta=0.1)
        self.assertEqual(call('make_plan', GetPlan, pose((0.0, 0.0)), pose(OUTSIDE), 0.0).plan.poses, [])
        self.assertTrue(self.stands())
        call('clear_costmaps', Empty)

    def test_stands_while_scans_are_missing_and_goes_on_after(self):
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        type(self).pass_on = False
        self.assertTrue(wait_for(lambda: 'no scan' in self.status.last.data, 5.0))
        self.assertTrue(wait_for(self.stands, 2.0))
        type(self).pass_on = True
        self.expect_end(GoalStatus.SUCCEEDED, 'goal reached')

    def test_stands_while_nobody_answers_for_the_map_and_goes_on_after(self):
        self.send(FAR)
        self.assertTrue(wait_for(self.drives))
        self.map.unregister()
        self.assertTrue(wait_for(lambda: 'no map' in self.status.last.data, 5.0), self.status.last)
        self.assertTrue(wait_for(self.stands, 2.0))
        self.publish_map()
        self.expect_end(GoalStatus.SUCCEEDED, 'goal reached')


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'navigator_wire', NavigatorOnTheWire)
