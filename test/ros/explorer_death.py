#!/usr/bin/env python3
"""An explorer that dies goes on when it is back, but not after an emergency stop that it did not live to see cleared."""
import glob
import os
import re
import signal

import rospy
import rostest
from frontier_pilot.msg import ExplorerStatus as Status
from std_srvs.srv import SetBool

from explorer_case import ExplorerCase
from wire import Node, call, clear, emergency_stop, use_a_home_of_its_own, wait_for

PAUSED = 'exploration paused because an emergency stop was called while no explorer was there to be paused by its clear'


def kept_count():
    """Of the stops, as of the memory of the explorer; nothing as long as that has none."""
    for file in glob.glob(os.environ['ROS_HOME'] + '/frontier_pilot/*/exploration_orders*'):
        with open(file) as memory:
            found = re.search(r' #(\d+)', memory.read())
        if found:
            return int(found.group(1))
    return None


def read(file):
    with open(file) as memory:
        return memory.read()


def kept_by_the_arbiter():
    """The files with its count of stops, in both places."""
    places = (os.environ['ROS_HOME'], os.environ.get('XDG_RUNTIME_DIR', '/dev/shm/frontier_pilot-%d' % os.getuid()))
    return [file for place in places for file in glob.glob(place + '/frontier_pilot/*/count_of_stops*')]


class ExplorerDeath(ExplorerCase):
    def setUp(self):
        use_a_home_of_its_own()
        self.start_arbiter()
        self.robot.held.set()  # so that the explorer has a goal all the time
        self.addCleanup(self.robot.held.clear)
        self.explore()
        self.assertTrue(wait_for(lambda: self.robot.goals), 'it explores')
        self.assertTrue(wait_for(lambda: kept_count() is not None), 'it knows how often the robot was stopped')

    def start_arbiter(self):
        self.arbiter = Node('cmd_vel_arbiter')
        self.addCleanup(self.arbiter.end)

    def wait_for_more(self, count):
        seen = len(self.status.items)
        self.assertTrue(wait_for(lambda: len(self.status.items) >= seen + count, 20.0))

    def kill(self, node):
        node.signal(signal.SIGKILL)
        node.finish()

    def end_in_order(self):
        """As Ctrl-C and `rosnode kill` do."""
        self.node.signal(signal.SIGTERM)
        self.node.finish()
        self.stand()

    def stand(self):
        """Ends the goal of the explorer that was killed, as the navigator does when the robot is stopped."""
        self.robot.held.clear()
        self.assertTrue(wait_for(lambda: not self.robot.drives()))
        self.robot.held.set()
        self.robot.goals.clear()
        self.status.items.clear()

    def be_dead_over_a_stop(self):
        self.kill(self.node)
        emergency_stop()
        self.stand()
        self.assertTrue(clear())

    def expect_it_starts_paused(self):
        said = []

        def says_so():
            said.append(self.node.said())
            return PAUSED in said[-1]
        self.assertTrue(wait_for(says_so), said[-1:])
        self.expect_reason(Status.PAUSED)
        self.wait_for_more(3)
        self.assertEqual((Status.IDLE, Status.PAUSED), (self.status.last.state, self.status.last.reason))
        self.assertEqual([], self.robot.goals, '[ARB-8]')
        self.assertTrue(call('set_exploration_enabled', SetBool, True).success)
        self.assertTrue(wait_for(lambda: self.robot.goals), 'then it goes on')

    def expect_it_goes_on(self):
        self.assertTrue(wait_for(lambda: self.robot.goals), self.node.said())
        self.assertNotIn(PAUSED, self.node.said())

    def pass_a_stop(self):
        """A stop and its clear that the explorer lives to see, after which it is let go on."""
        before = kept_count()
        emergency_stop()
        self.assertTrue(clear())
        self.expect_reason(Status.PAUSED)
        self.robot.goals.clear()
        self.assertTrue(call('set_exploration_enabled', SetBool, True).success)
        self.assertTrue(wait_for(lambda: self.robot.goals and kept_count() == before + 1), kept_count())

    # [ARB-8] [FLT-2]
    def test_is_paused_by_a_stop_that_was_called_and_cleared_while_it_was_dead(self):
        self.be_dead_over_a_stop()
        self.start()
        self.expect_it_starts_paused()

    # [ARB-8] [FLT-2]
    def test_is_paused_by_a_stop_that_was_cleared_after_it_had_ended_in_order(self):
        emergency_stop()
        self.end_in_order()
        self.assertTrue(clear())
        self.start()
        self.expect_it_starts_paused()

    # [ARB-8] [FLT-2]
    def test_an_order_that_comes_before_it_hears_of_stops_does_not_outlive_one(self):
        self.be_dead_over_a_stop()
        self.kill(self.arbiter)
        self.start()
        answer = call('set_exploration_enabled', SetBool, True)
        self.assertIn('waits until the arbiter says', answer.message)
        self.start_arbiter()
        self.expect_it_starts_paused()

    # [ARB-8]
    def test_is_paused_by_a_stop_that_was_cleared_while_its_launch_began(self):
        self.kill(self.node)
        self.stand()
        use_a_home_of_its_own()
        emergency_stop()
        self.assertTrue(clear())
        self.start()
        self.assertTrue(wait_for(lambda: PAUSED in self.node.said()), self.node.said())
        self.expect_reason(Status.PAUSED)

    # [FLT-2]
    def test_goes_on_without_a_stop_after_it_has_ended_in_order(self):
        self.pass_a_stop()
        self.end_in_order()
        self.start()
        self.expect_it_goes_on()

    # [ARB-8] [FLT-2]
    def test_is_paused_by_the_clear_of_a_stop_during_which_it_died(self):
        self.pass_a_stop()
        self.status.items.clear()
        emergency_stop()
        self.expect_reason(Status.EMERGENCY_STOP)
        self.kill(self.node)
        self.stand()
        self.assertTrue(clear())
        self.start()
        self.expect_it_starts_paused()

    # [ARB-8] [FLT-2]
    def test_is_paused_also_if_the_arbiter_died_after_the_clear(self):
        self.be_dead_over_a_stop()
        self.kill(self.arbiter)
        self.start_arbiter()
        self.start()
        self.expect_it_starts_paused()

    # [ARB-8] [FLT-2]
    def test_is_paused_also_if_the_arbiter_died_before_it_had_counted_the_stop(self):
        self.pass_a_stop()
        self.kill(self.node)
        counted = {file: read(file) for file in kept_by_the_arbiter()}
        self.assertTrue(counted)
        emergency_stop()
        self.stand()
        self.kill(self.arbiter)
        for file, text in counted.items():
            with open(file, 'w') as count:
                count.write(text)
        self.start_arbiter()
        self.assertTrue(clear())
        self.start()
        self.expect_it_starts_paused()

    # [FLT-2]
    def test_goes_on_without_a_stop_also_if_the_arbiter_died_with_it(self):
        self.pass_a_stop()
        self.kill(self.node)
        self.kill(self.arbiter)
        self.stand()
        self.start_arbiter()
        self.start()
        self.expect_it_goes_on()

    # [ARB-8] [FLT-2]
    def test_sends_no_goal_before_it_has_heard_from_the_arbiter(self):
        self.kill(self.node)
        self.kill(self.arbiter)
        self.stand()
        self.start()
        self.assertTrue(self.comes(lambda status: 'no arbiter' in status.reason_text), self.status.last)
        self.wait_for_more(3)
        self.assertEqual([], self.robot.goals, '[ARB-8]')
        self.start_arbiter()
        self.expect_it_goes_on()


if __name__ == '__main__':
    rospy.init_node('explorer_death_test')
    rostest.rosrun('frontier_pilot', 'explorer_death', ExplorerDeath)
