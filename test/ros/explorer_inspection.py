#!/usr/bin/env python3
"""Poses that somebody wants inspected on the way, and what the status says of each frontier."""
import math

import rospy
import rostest
from frontier_pilot.msg import ExplorerStatus as Status
from geometry_msgs.msg import PoseStamped
from std_msgs.msg import String
from std_srvs.srv import Trigger

from explorer_case import ExplorerCase
from wire import call, wait_for


class ExplorerInspection(ExplorerCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('explorer_inspection')
        super().setUpClass()
        cls.inspect = rospy.Publisher('frontier_explorer/inspect', PoseStamped, queue_size=20)

    def explore(self, **parameters):
        super().explore(**parameters)
        self.assertTrue(wait_for(lambda: self.robot.goals and self.inspect.get_num_connections() > 0))

    def ask(self, x, y, frame='map', w=1.0):
        pose = PoseStamped()
        pose.header.frame_id, pose.header.stamp = frame, rospy.Time.now()
        pose.pose.position.x, pose.pose.position.y, pose.pose.orientation.w = x, y, w
        self.inspect.publish(pose)

    def was_at(self, x, y):
        return any(math.hypot(x - gx, y - gy) < 0.1 for gx, gy in self.robot.goals)

    # [EXP-10]
    def test_a_pose_is_inspected_shown_and_counted(self):
        self.explore(inspect={'detour': 20.0, 'stay': 0.3})
        self.ask(1.0, 0.3)
        self.assertTrue(self.comes(lambda status: len(status.to_inspect) == 1))
        self.assertTrue(wait_for(lambda: any(m.ns == 'to inspect' for m in self.markers.last.markers)))
        self.expect_reason(Status.INSPECTING)
        self.assertTrue(self.comes(lambda status: status.inspected == 1 and not status.to_inspect))
        self.assertTrue(self.was_at(1.0, 0.3), self.robot.goals)
        self.expect_done(Status.NO_REACHABLE_FRONTIER)

    # [EXP-10]
    def test_what_is_no_pose_in_the_map_is_refused_and_what_waits_can_be_taken_back(self):
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore(inspect={'detour': 0.0})
        self.ask(math.nan, 0.0)
        self.ask(1.0, 0.0, frame='nowhere')
        self.ask(1.0, 0.0, w=0.0)
        self.ask(1.0, 0.3)
        self.assertTrue(self.comes(lambda status: len(status.to_inspect) == 1))
        answer = call('frontier_explorer/clear_inspections', Trigger)
        self.assertEqual((True, 'poses that need not be inspected any more: 1'), (answer.success, answer.message))
        self.assertTrue(wait_for(lambda: not self.status.last.to_inspect))
        answer = call('frontier_explorer/clear_inspections', Trigger)
        self.assertIn('nothing changed', answer.message)

    # [EXP-10] [MAP-5]
    def test_a_pose_does_not_outlive_the_map_on_which_it_was_asked_for(self):
        replaced = rospy.Publisher('mapper/replaced', String, queue_size=1)
        self.addCleanup(replaced.unregister)
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        self.explore(inspect={'detour': 20.0})
        self.assertTrue(wait_for(lambda: replaced.get_num_connections() > 0))
        self.ask(1.0, 0.3)
        self.assertTrue(self.comes(lambda status: len(status.to_inspect) == 1))
        replaced.publish('floor.yaml loaded')
        self.assertTrue(wait_for(lambda: not self.status.last.to_inspect), '[MAP-5]')
        self.robot.goals.clear()
        self.expect_reason(Status.NAVIGATION_UNABLE)  # for five seconds, in which the new map comes
        self.robot.held.clear()
        self.expect_done(Status.NO_REACHABLE_FRONTIER, 30.0)
        self.assertFalse(self.was_at(1.0, 0.3), self.robot.goals)
        self.assertEqual((0, 0), (self.status.last.inspected, self.status.last.inspections_failed))
        self.assertIn('1 poses are not inspected any more: floor.yaml loaded', self.node.said())

    # [EXP-9]
    def test_the_status_says_of_each_frontier_its_gain_cost_place_and_owner_or_why_it_is_out(self):
        self.explore()
        self.assertTrue(self.comes(lambda status: len(status.frontiers) > 1))
        frontiers = self.status.last.frontiers
        planned = [f for f in frontiers if f.place > 0]
        self.assertTrue(planned)
        for frontier in planned:
            self.assertGreater(frontier.gain, 0.0)
            self.assertGreater(frontier.cost, 0.0)
            self.assertEqual('/', frontier.owner)
            self.assertEqual('', frontier.reason)
        for frontier in frontiers:
            self.assertTrue(frontier.place > 0 or not frontier.owner)
            self.assertNotEqual('too small', frontier.reason)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'explorer_inspection', ExplorerInspection)
