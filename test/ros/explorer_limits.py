#!/usr/bin/env python3
"""What bounds and ends an exploration, and goals of others, against a move_base and a map that are not ours."""
import math
import signal
import threading
import time

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.msg import ExplorerStatus as Status
from frontier_pilot.srv import SaveMap, SaveMapResponse, SetBounds
from geometry_msgs.msg import Point32, Polygon
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Bool
from std_srvs.srv import SetBool, Trigger

from explorer_case import START, ExplorerCase
from foreign_robot import hall
from wire import Record, Stranger, call, wait_for

RIGHT = [-0.9, -2.0, 5.0, -2.0, 5.0, 2.0, -0.9, 2.0]  # without the left end


def rectangle(left, right):
    return Polygon([Point32(left, -2.0, 0.0), Point32(right, -2.0, 0.0), Point32(right, 2.0, 0.0),
                    Point32(left, 2.0, 0.0)])


class ExplorerLimits(ExplorerCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('explorer_limits')
        super().setUpClass()
        cls.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        cls.battery = rospy.Publisher('battery_state', BatteryState, queue_size=1)

    def charge(self, percentage):
        """Tells the charge until it is in the status, in which nothing is NaN."""
        def told():
            self.battery.publish(BatteryState(percentage=percentage))
            last = self.status.last
            return last is not None and (math.isnan(last.battery) if math.isnan(percentage)
                                         else abs(last.battery - percentage) < 1e-6)
        self.assertTrue(wait_for(told), self.status.last)

    # [EXP-10]
    def test_stays_within_the_bounds_of_its_parameters_and_shows_them(self):
        self.explore(bounds={'stay_within': RIGHT})
        self.assertTrue(wait_for(lambda: self.robot.goals and self.status.last))
        self.assertGreater(self.robot.goals[0][0], 0.0)
        self.assertEqual(4, len(self.status.last.stay_within.points))
        self.assertTrue(wait_for(lambda: self.markers.last and any(m.ns == 'bounds' for m in self.markers.last.markers)))
        self.expect_done(Status.NO_REACHABLE_FRONTIER)
        self.assertTrue(all(x > -0.9 for x, _ in self.robot.goals), self.robot.goals)

    def explore_within_bounds_of_a_service(self):
        self.explore()
        self.assertTrue(wait_for(lambda: self.robot.goals))
        self.assertTrue(call('frontier_explorer/set_bounds', SetBounds, rectangle(-1.0, 5.0), [rectangle(1.0, 2.0)]).success)

    def expect_the_bounds_of_the_service(self):
        self.assertTrue(self.comes(lambda status: len(status.stay_within.points) == 4 and len(status.keep_out) == 1), '[FLT-2]')

    # [EXP-10] [FLT-2]
    def test_keeps_the_bounds_of_a_service_when_it_dies(self):
        self.explore_within_bounds_of_a_service()
        self.start_again()
        self.expect_the_bounds_of_the_service()

    # [EXP-10] [FLT-2]
    def test_leaves_its_bounds_to_the_next_one_when_a_node_of_another_program_takes_its_name(self):
        self.explore_within_bounds_of_a_service()
        namesake = Stranger(self, 'frontier_explorer')
        self.node.finish(20.0)  # the master has told it to end
        namesake.end()
        self.status.items.clear()
        self.start()
        self.expect_the_bounds_of_the_service()

    # [EXP-10] [FLT-2]
    def test_does_not_drive_off_again_when_it_dies_after_a_stopping_rule_has_ended_the_exploration(self):
        self.explore(until={'time': 1.0})
        self.expect_done(Status.UNTIL_TIME)
        self.robot.goals.clear()
        self.start_again()
        self.expect_reason(Status.PAUSED)
        self.assertFalse(wait_for(lambda: self.robot.goals, 2.0), '[FLT-2]')
        call('set_exploration_enabled', SetBool, True)
        self.assertTrue(wait_for(lambda: self.robot.goals))

    # [EXP-10]
    def test_leads_a_navigation_that_drives_straight_around_a_keep_out_area(self):
        block = (0.5, 1.5, 0.2)  # from x, to x, up to y
        corners = [block[0], -2.0, block[1], -2.0, block[1], block[2], block[0], block[2]]
        self.explore(bounds={'stay_within': RIGHT, 'keep_out': [corners]})
        self.assertTrue(wait_for(lambda: self.robot.track and self.robot.track[-1][0] > block[1]), self.robot.goals)
        inside = [(x, y) for x, y in self.robot.track if block[0] < x < block[1] and y < block[2]]
        self.assertEqual([], inside)

    # [EXP-10]
    def test_takes_bounds_by_a_service_and_refuses_broken_ones(self):
        self.explore()
        self.assertTrue(wait_for(lambda: self.robot.goals and self.robot.goals[0][0] < 0.0), self.robot.goals)
        answer = call('frontier_explorer/set_bounds', SetBounds, Polygon(), [rectangle(-5.0, -0.9)])
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(self.comes(lambda status: len(status.keep_out) == 1))
        twisted = rectangle(0.0, 1.0)
        twisted.points[1], twisted.points[2] = twisted.points[2], twisted.points[1]
        answer = call('frontier_explorer/set_bounds', SetBounds, twisted, [])
        self.assertFalse(answer.success)
        self.assertIn('stay_within: crosses or touches itself', answer.message)
        self.assertEqual(1, len(self.status.last.keep_out))

    # [EXP-10]
    def test_a_robot_outside_is_told_so_and_not_driven(self):
        self.explore(bounds={'stay_within': RIGHT, 'keep_out': [[-0.9, -2.0, 0.5, -2.0, 0.5, 2.0, -0.9, 2.0]]})
        self.expect_reason(Status.ROBOT_OUT_OF_BOUNDS)
        self.assertEqual([], self.robot.goals)
        answer = call('frontier_explorer/set_bounds', SetBounds, Polygon(), [])
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(wait_for(lambda: self.robot.goals))

    # [EXP-10]
    def test_ends_after_a_time_and_goes_on_when_started_again(self):
        self.explore(until={'time': 1.0})
        self.expect_done(Status.UNTIL_TIME)
        self.status.items.clear()
        self.assertTrue(call('set_exploration_enabled', SetBool, True).success)
        self.expect_reason(Status.STARTED_AGAIN)
        self.expect_reason(Status.UNTIL_TIME)

    # [EXP-10] [EXP-12]
    def test_ends_at_a_share_of_the_estimate_and_tells_the_estimate(self):
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore(until={'share': 0.05})
        self.assertTrue(self.comes(lambda status: math.isnan(status.estimated_area)))
        self.assertTrue(self.comes(lambda status: status.exploring_time > 10.5, 30.0), 'too early to tell until then')
        self.robot.show(hall(-2.4, 2.4))  # so that the explorer decides again
        self.expect_done(Status.UNTIL_SHARE)
        last = self.status.last
        self.assertGreaterEqual(last.share_explored, 0.05)
        self.assertGreaterEqual(last.estimated_area, last.explored_area)
        self.assertGreater(last.estimated_area_deviation, 0.0)
        self.assertGreater(last.time_left, 0.0)

    # [EXP-10]
    def test_ends_after_a_distance_and_goes_on_after_a_reset(self):
        self.explore(until={'distance': 0.8})
        self.expect_done(Status.UNTIL_DISTANCE)
        self.assertGreaterEqual(self.status.last.exploring_distance, 0.8)
        self.status.items.clear()
        self.assertTrue(call('frontier_explorer/reset', Trigger).success)
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING))

    # [EXP-10]
    def test_ends_at_a_charge_and_returns_and_says_so_while_no_battery_state_is_received(self):
        diagnostics = Record('/diagnostics', DiagnosticArray)
        self.addCleanup(diagnostics.subscriber.unregister)
        self.explore(until={'battery': 0.3}, return_to_start=True)
        self.assertTrue(wait_for(lambda: not self.is_at_start()))
        self.assertTrue(math.isnan(self.status.last.battery))
        self.assertEqual('the battery is at 30 % (no battery state is received)', self.status.last.until)
        self.assertTrue(wait_for(lambda: any('no battery state is received' in status.message for _, array in diagnostics.items
                                             for status in array.status)))
        self.charge(0.5)
        self.charge(float('nan'))
        self.charge(0.4)
        self.assertEqual('the battery is at 30 %', self.status.last.until)
        self.assertNotEqual(Status.DONE, self.status.last.state)
        self.battery.publish(BatteryState(percentage=29.0))  # of a driver that sends percent
        self.expect_reason(Status.RETURNING_TO_START)
        self.expect_done(Status.UNTIL_BATTERY)
        self.assertAlmostEqual(0.29, self.status.last.battery, 6)
        self.assertTrue(self.is_at_start(), self.robot.position)

    # [EXP-10]
    def test_returns_to_the_start_when_asked_to_in_the_middle_of_it(self):
        self.explore(until={'distance': 0.8})
        self.assertTrue(wait_for(lambda: not self.is_at_start()))
        self.assertFalse(self.status.last.return_to_start)
        answer = call('frontier_explorer/set_return_to_start', SetBool, True)
        self.assertEqual((True, 'returns to the start at the end'), (answer.success, answer.message))
        self.assertTrue(self.comes(lambda status: status.return_to_start))
        self.expect_done(Status.UNTIL_DISTANCE)
        self.assertTrue(self.is_at_start(), self.robot.position)

    # [EXP-10]
    def test_says_that_an_exploration_which_a_rule_has_ended_goes_on_when_it_is_enabled(self):
        self.explore(until={'distance': 0.8})
        self.expect_done(Status.UNTIL_DISTANCE)
        self.assertIn('set_exploration_enabled true goes on, and at the end of that the robot returns to its start',
                      call('frontier_explorer/set_return_to_start', SetBool, True).message)

    # [EXP-10]
    def test_says_what_sends_the_robot_back_once_the_exploration_has_ended(self):
        self.explore()
        self.assertTrue(self.comes(lambda status: status.state == Status.DONE, 30.0))
        self.expect_done(Status.NO_REACHABLE_FRONTIER)
        self.assertIn('exploration enabled already: nothing changed; it has ended (no reachable frontier left): frontier_explorer/reset '
                      'begins it anew, and at the end of that the robot stays where it is',
                      call('set_exploration_enabled', SetBool, True).message)
        self.assertIn('frontier_explorer/reset begins it anew, and at the end of that the robot returns to its start',
                      call('frontier_explorer/set_return_to_start', SetBool, True).message)
        self.status.items.clear()
        self.assertTrue(call('frontier_explorer/reset', Trigger).success)
        self.expect_reason(Status.RETURNING_TO_START)
        self.status.items.clear()
        self.expect_done(Status.NO_REACHABLE_FRONTIER)
        self.assertTrue(self.is_at_start(), self.robot.position)

    # [EXP-10] [FLT-2]
    def test_returns_to_where_it_began_also_when_it_dies_far_from_there(self):
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore(until={'area': 9.8}, return_to_start=True)
        self.assertTrue(wait_for(lambda: abs(self.robot.position[0] - START[0]) > 1.0), self.robot.goals)
        self.start_again()
        self.robot.held.clear()
        self.assertTrue(self.comes(lambda status: status.state == Status.NAVIGATING))
        self.robot.show(hall(known_to=2.8))
        self.expect_done(Status.UNTIL_AREA)
        self.assertTrue(self.is_at_start(), self.robot.position)

    # [EXP-8]
    def test_stands_while_it_is_paused_and_goes_on_where_it_was(self):
        self.explore()
        self.assertTrue(wait_for(lambda: not self.is_at_start()))
        self.assertTrue(call('set_exploration_enabled', SetBool, False).success)
        self.expect_reason(Status.PAUSED)
        self.assertTrue(wait_for(lambda: not self.robot.drives()), 'its goal is taken back')
        goals, position = len(self.robot.goals), self.robot.position
        heard, time = len(self.status.items), self.status.last.exploring_time
        self.assertTrue(wait_for(lambda: len(self.status.items) > heard + 2))
        self.assertEqual((goals, position), (len(self.robot.goals), self.robot.position))
        self.assertEqual(time, self.status.last.exploring_time)
        self.assertTrue(call('set_exploration_enabled', SetBool, True).success)
        self.assertTrue(wait_for(lambda: self.robot.position != position))

    # [ARB-8] [FLT-2]
    def test_a_call_that_waited_while_it_was_frozen_through_a_stop_and_its_clearing_sends_no_goal(self):
        stop = rospy.Publisher('emergency_stop_state', Bool, queue_size=10)
        self.addCleanup(stop.unregister)
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore()
        self.assertTrue(wait_for(lambda: self.robot.goals and stop.get_num_connections() > 0))
        # Over a connection that is there already the call arrives before the stop.
        reset = rospy.ServiceProxy('frontier_explorer/reset', Trigger, persistent=True)
        self.addCleanup(reset.close)
        self.assertTrue(reset().success)
        self.assertTrue(wait_for(lambda: len(self.robot.goals) == 2), 'a reset sends a goal')
        self.node.signal(signal.SIGSTOP)
        caller = threading.Thread(target=reset)
        caller.start()
        time.sleep(0.2)
        stop.publish(True)
        stop.publish(False)
        time.sleep(0.6)
        self.node.signal(signal.SIGCONT)
        caller.join()
        self.expect_reason(Status.PAUSED)
        goals = list(self.robot.goals)
        self.assertTrue(call('set_exploration_enabled', SetBool, True).success)  # the next explorer is not paused
        self.assertEqual(2, len(goals), goals)

    # [EXP-10]
    def test_returns_to_the_start_and_has_the_map_saved_without_waiting_for_it(self):
        asked, may_answer = [], threading.Event()

        def save(request):
            asked.append(request.path)
            may_answer.wait(10.0)
            return SaveMapResponse(True, 'written')
        service = rospy.Service('mapper/save_map', SaveMap, save)
        self.addCleanup(service.shutdown, 'the test is over')
        self.addCleanup(may_answer.set)
        self.explore(until={'area': 9.8}, return_to_start=True, save_map_at_end='end_of_it')
        self.assertTrue(wait_for(lambda: not self.is_at_start()))
        self.robot.show(hall(known_to=2.8))
        self.expect_reason(Status.RETURNING_TO_START)
        self.expect_done(Status.UNTIL_AREA)
        self.assertTrue(self.is_at_start(), self.robot.position)
        self.assertTrue(wait_for(lambda: asked == ['end_of_it']), asked)
        seen = len(self.status.items)
        self.assertTrue(wait_for(lambda: len(self.status.items) > seen + 1), 'it goes on while the mapper saves')
        self.assertEqual('saving end_of_it', self.status.last.map_saved)
        may_answer.set()
        self.assertTrue(self.comes(lambda status: status.map_saved == 'saved: written'))
        self.assertEqual(1, len(asked))

    # [EXP-10]
    def test_a_map_that_was_not_saved_is_tried_again_under_the_name_of_the_robot(self):
        asked = []
        self.explore(until={'time': 0.5}, save_map_at_end='end_of_it.yaml', fleet={'name': 'robot7'})
        self.assertTrue(self.comes(lambda status: status.map_saved.startswith('not saved: ')), self.status.last)
        self.assertEqual('end_of_it_robot7', self.status.last.save_map_at_end)

        def save(request):
            asked.append(request.path)
            return SaveMapResponse(True, 'written')
        service = rospy.Service('mapper/save_map', SaveMap, save)
        self.addCleanup(service.shutdown, 'the test is over')
        self.assertTrue(self.comes(lambda status: status.map_saved == 'saved: written', 15.0), self.status.last)
        self.assertEqual(['end_of_it_robot7'], asked)
        self.assertEqual(1, self.node.said().count('the map at the end was not saved'))

    # [EXP-10]
    def test_says_that_the_map_was_not_saved(self):
        self.explore(until={'time': 0.5}, save_map_at_end='end_of_it')
        self.assertTrue(self.comes(lambda status: status.map_saved.startswith('not saved: ')), self.status.last)
        self.assertIn('/mapper/save_map: no such service', self.status.last.map_saved)

    # [EXP-11]
    def test_does_not_take_back_a_goal_of_somebody_else(self):
        self.explore()
        self.assertTrue(wait_for(lambda: len(self.robot.goals) == 1))
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.orientation.w = 1.0, 1.0
        self.client.send_goal(goal)
        self.expect_reason(Status.OTHERS_GOAL)
        waiting = len(self.status.items)
        self.assertTrue(wait_for(lambda: len(self.status.items) > waiting + 7, 20.0))
        self.assertEqual('waiting for your goal to end', self.status.last.reason_text)
        self.assertEqual((1.0, 0.0), self.robot.goals[-1])
        self.robot.held.clear()
        self.assertTrue(self.client.wait_for_result(rospy.Duration(10.0)))
        self.assertEqual(GoalStatus.SUCCEEDED, self.client.get_state())
        self.assertTrue(wait_for(lambda: len(self.robot.goals) == 3), 'then the explorer goes on')


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'explorer_limits', ExplorerLimits)
