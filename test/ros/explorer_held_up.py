#!/usr/bin/env python3
"""An explorer that is held up while it decides sends no goal after a stop and a clear, or over somebody else's goal, that came meanwhile."""
import os
import signal
import time

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from frontier_pilot.msg import ExplorerStatus as Status
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid
from std_srvs.srv import SetBool

from explorer_case import ExplorerCase
from foreign_robot import CELL
from wire import SANITIZED, Node, call, clear, emergency_stop, use_a_home_of_its_own, wait_for

PATIENCE = 120.0 if SANITIZED else 30.0  # for a goal [s]
SIDE = 3600  # [cells]: a decision takes a large part of a second


def large_floor():
    """A free square whose surroundings are unknown."""
    grid = OccupancyGrid()
    grid.header.frame_id = 'map'
    grid.header.stamp = rospy.Time.now()
    grid.info.resolution, grid.info.width, grid.info.height = CELL, SIDE, SIDE
    grid.info.origin.position.x = grid.info.origin.position.y = -0.5 * SIDE * CELL
    grid.info.origin.orientation.w = 1.0
    edge = [-1] * 20
    grid.data = edge * SIDE + (edge + [0] * (SIDE - 40) + edge) * (SIDE - 40) + edge * SIDE
    return grid


class ExplorerHeldUp(ExplorerCase):
    def work(self):
        """What the explorer's own thread has used of the processor [s]."""
        pid = self.node.process.pid
        with open('/proc/%d/task/%d/stat' % (pid, pid)) as stat:
            return int(stat.read().rsplit(')', 1)[1].split()[11]) / os.sysconf('SC_CLK_TCK')

    def start_without_a_map(self):
        use_a_home_of_its_own()
        self.status.items.clear()
        self.robot.goals.clear()
        self.robot.show(OccupancyGrid())
        self.start()
        self.assertTrue(self.comes(lambda status: status.reason_text.startswith('missing: map')), self.status.last)

    def work_of_a_decision(self):
        """That of an explorer that nobody holds up, from the map to its goal [s]: it depends on the computer."""
        self.start_without_a_map()
        before = self.work()
        self.robot.show(large_floor())
        self.assertTrue(wait_for(lambda: self.robot.goals, 60.0))
        work = self.work() - before
        self.node.end()
        return work

    def hold_up_in_a_decision(self, work):
        """Stops the process of an explorer that has done a part of this work [s]. It may have done all of it by then."""
        for share in (0.5, 0.4, 0.3, 0.2):  # less than half of it goes into reading the map
            self.start_without_a_map()
            before = self.work()
            self.robot.show(large_floor())
            self.assertTrue(wait_for(lambda: self.work() > before + share * work, 60.0))
            self.node.signal(signal.SIGSTOP)
            time.sleep(0.3)  # for a goal that was on its way
            if not self.robot.goals:
                return
            self.node.signal(signal.SIGCONT)
            self.node.end()
        self.fail('it has decided each time')

    # [ARB-8] [FLT-2]
    def test_a_goal_that_was_decided_before_a_stop_is_not_sent_after_its_clear(self):
        arbiter = Node('cmd_vel_arbiter')
        self.addCleanup(arbiter.end)
        rospy.set_param('frontier_explorer', {'autostart': True})
        self.addCleanup(rospy.delete_param, 'frontier_explorer')
        self.hold_up_in_a_decision(self.work_of_a_decision())
        emergency_stop()
        self.assertTrue(clear())
        self.node.signal(signal.SIGCONT)
        self.assertTrue(self.comes(lambda status: status.reason == Status.PAUSED, 30.0), self.status.last)
        self.assertEqual([], self.robot.goals, '[ARB-8]')
        self.assertTrue(call('set_exploration_enabled', SetBool, True).success)
        self.assertTrue(wait_for(lambda: self.robot.goals, PATIENCE), ('then it goes on', self.status.last))

    # [EXP-11]
    def test_a_goal_that_was_decided_before_somebody_else_gave_one_is_not_sent_over_it(self):
        operator = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        self.assertTrue(operator.wait_for_server(rospy.Duration(10.0)))
        rospy.set_param('frontier_explorer', {'autostart': True})
        self.addCleanup(rospy.delete_param, 'frontier_explorer')
        self.hold_up_in_a_decision(self.work_of_a_decision())
        self.robot.held.set()
        self.addCleanup(self.robot.held.clear)
        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.orientation.w = 1.0, 1.0
        operator.send_goal(goal)
        self.assertTrue(wait_for(self.robot.drives))
        self.node.signal(signal.SIGCONT)
        self.assertTrue(self.comes(lambda status: status.reason == Status.OTHERS_GOAL, 30.0), self.status.last)
        self.assertEqual([(1.0, 0.0)], self.robot.goals, '[EXP-11]')
        self.robot.held.clear()
        self.assertTrue(wait_for(lambda: len(self.robot.goals) > 1, PATIENCE), ('then it goes on', self.status.last))
        self.assertEqual(GoalStatus.SUCCEEDED, operator.get_state())


if __name__ == '__main__':
    rospy.init_node('explorer_held_up_test')
    rostest.rosrun('frontier_pilot', 'explorer_held_up', ExplorerHeldUp)
