#!/usr/bin/env python3
"""Goals, cancels and transforms with stamps, durations and names that nobody means well with: no node ends. [FLT-1]"""
import io
import struct
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from geometry_msgs.msg import TransformStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseActionGoal, MoveBaseGoal
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from std_srvs.srv import SetBool
from tf2_msgs.msg import TFMessage

from frontier_pilot.msg import (PatrolAction, PatrolActionGoal, PatrolGoal, SpinAction, SpinActionGoal, SpinGoal,
                                WaitAction, WaitActionGoal, WaitGoal)
from wire import Node, Record, assert_memory_below, memory_of, wait_for

END_OF_TIME = rospy.Time(4294967295, 999999999)
LONGEST = rospy.Duration(2147483647, 999999999)
SHORTEST = rospy.Duration(-2147483648, 0)
NODES = ('navigator', 'behavior_server', 'patrol_server', 'mapper', 'frontier_explorer', 'obstacle_avoider')
ARGUMENTS = {'frontier_explorer': ('_autostart:=true',)}


class EndlessStatus(GoalStatusArray):
    """A status that says it has so many goals, and has none."""

    def __init__(self, goals):
        super().__init__()
        self.goals = goals

    def serialize(self, buff):
        honest = io.BytesIO()
        super().serialize(honest)
        buff.write(honest.getvalue()[:-4] + struct.pack('<I', self.goals))


def move_base_goal(frame='nowhere'):
    goal = MoveBaseGoal()
    goal.target_pose.header.frame_id = frame
    goal.target_pose.pose.orientation.w = 1.0
    return goal


# What ends at once, with what the node itself says of it: the state, and a word of the text.
ACTIONS = {
    'move_base': (MoveBaseAction, MoveBaseActionGoal, move_base_goal(), GoalStatus.REJECTED, 'invalid goal'),
    'spin': (SpinAction, SpinActionGoal, SpinGoal(0.0, rospy.Duration(0), False), GoalStatus.SUCCEEDED, 'nothing'),
    'wait': (WaitAction, WaitActionGoal, WaitGoal(rospy.Duration(0.1), rospy.Duration(0)), GoalStatus.SUCCEEDED, ''),
    'turtlebot3': (PatrolAction, PatrolActionGoal, PatrolGoal(), GoalStatus.ABORTED, ''),
}


class HostileActions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.odometry = Record('odom', Odometry)
        assert wait_for(lambda: cls.odometry.last is not None, 30.0), 'the simulator'
        cls.nodes = {name: Node(name, *ARGUMENTS.get(name, ())) for name in NODES}
        cls.clients = {name: actionlib.SimpleActionClient(name, action[0]) for name, action in ACTIONS.items()}
        for name, client in cls.clients.items():
            assert client.wait_for_server(rospy.Duration(60.0)), name
        cls.goals = {name: cls.publisher(name + '/goal', action[1]) for name, action in ACTIONS.items()}
        cls.cancels = {name: cls.publisher(name + '/cancel', GoalID) for name in ACTIONS}
        cls.statuses = {name: Record(name + '/status', GoalStatusArray) for name in ACTIONS}
        cls.tf = cls.publisher('/tf', TFMessage)
        cls.tf_static = cls.publisher('/tf_static', TFMessage)
        cls.scans = cls.publisher('scan', LaserScan)

    @classmethod
    def tearDownClass(cls):
        for node in cls.nodes.values():
            node.end()

    @staticmethod
    def publisher(topic, kind):
        publisher = rospy.Publisher(topic, kind, queue_size=5000, tcp_nodelay=True)
        assert wait_for(lambda: publisher.get_num_connections() > 0, 30.0), topic
        return publisher

    def assert_all_live(self):
        for name, node in self.nodes.items():
            self.assertFalse(node.has_ended(), '%s has ended:\n%s' % (name, node.process.stdout.read()[-2000:]
                                                                        if node.has_ended() else ''))

    def assert_all_work(self):
        """Each action's next goal is judged by its node: it is neither lost nor recalled."""
        for name, (_, _, goal, state, word) in ACTIONS.items():
            self.assertTrue(wait_for(lambda: self.answered(name, goal, state), 15.0),
                            (name, self.clients[name].get_state(), self.clients[name].get_goal_status_text()))
            self.assertIn(word, self.clients[name].get_goal_status_text(), name)
        self.assert_all_live()

    def answered(self, name, goal, state):
        self.clients[name].send_goal(goal)
        self.clients[name].wait_for_result(rospy.Duration(5.0))
        return self.clients[name].get_state() == state

    def with_id(self, name, goal_id):
        message = ACTIONS[name][1]()
        message.goal, message.goal_id = ACTIONS[name][2], goal_id
        return message

    def test_cancels_of_the_end_of_time(self):
        for name in ACTIONS:
            self.cancels[name].publish(GoalID(END_OF_TIME, ''))
            self.cancels[name].publish(GoalID(END_OF_TIME, 'unknown'))
            self.cancels[name].publish(GoalID(rospy.Time(4294967290, 0), 'unknown too'))
        self.assert_all_work()

    def test_a_cancel_of_everything_until_tomorrow_does_not_recall_the_goals_of_today(self):
        for name in ACTIONS:
            self.cancels[name].publish(GoalID(rospy.Time.now() + rospy.Duration(86400.0), ''))
        self.assert_all_work()

    def test_goals_of_the_end_of_time_and_of_tomorrow_do_not_outrank_those_of_today(self):
        for name in ACTIONS:
            for number, stamp in enumerate((END_OF_TIME, rospy.Time.now() + rospy.Duration(86400.0))):
                self.goals[name].publish(self.with_id(name, GoalID(stamp, 'late %d' % number)))
                self.goals[name].publish(self.with_id(name, GoalID(stamp, 'late %d' % number)))
        self.assert_all_work()

    def test_cancels_of_unknown_goals_are_not_kept_for_ever(self):
        for name in ACTIONS:
            for number in range(1000):
                self.cancels[name].publish(GoalID(END_OF_TIME if number % 2 else rospy.Time(), 'u%d' % number))
        self.assert_all_work()
        for name in ACTIONS:
            self.assertTrue(wait_for(lambda: len(self.statuses[name].last.status_list) < 100, 5.0),
                            (name, len(self.statuses[name].last.status_list)))

    def test_a_cancel_that_comes_before_its_goal_recalls_it(self):
        for name in ACTIONS:
            self.cancels[name].publish(GoalID(rospy.Time(), 'early'))
            self.assertTrue(wait_for(lambda: self.state_of(name, 'early') == GoalStatus.RECALLING, 5.0), name)
            self.goals[name].publish(self.with_id(name, GoalID(rospy.Time(), 'early')))
            self.assertTrue(wait_for(lambda: self.state_of(name, 'early') == GoalStatus.RECALLED, 5.0), name)
        self.assert_all_work()

    def state_of(self, name, goal_id):
        return next((s.status for s in self.statuses[name].last.status_list if s.goal_id.id == goal_id), None)

    def test_names_that_are_empty_or_endless(self):
        for name in ACTIONS:
            for goal_id in ('', 'x' * 100000):
                self.goals[name].publish(self.with_id(name, GoalID(rospy.Time(), goal_id)))
                self.cancels[name].publish(GoalID(rospy.Time(), goal_id))
        self.assert_all_work()

    def test_a_status_that_says_it_is_longer_than_it_is_costs_a_client_no_memory(self):
        patrol = Node('patrol_client', 'square', '--laps', '10')
        self.addCleanup(patrol.end)
        goals = lambda: self.statuses['turtlebot3'].last.status_list
        self.assertTrue(wait_for(lambda: any(goal.status == GoalStatus.ACTIVE for goal in goals()), 15.0))
        publishers = [self.publisher(name + '/status', GoalStatusArray) for name in ('move_base', 'turtlebot3')]
        for publisher in publishers:
            self.assertTrue(wait_for(lambda: publisher.get_num_connections() > 1, 15.0), publisher.name)
            for count in (10**7, 2**31, 2**32 - 1):
                publisher.publish(EndlessStatus(count))
        heard = len(self.statuses['turtlebot3'].items)
        self.assertTrue(wait_for(lambda: len(self.statuses['turtlebot3'].items) > heard + 10, 15.0))
        for name, node in dict(self.nodes, patrol_client=patrol).items():
            self.assertFalse(node.has_ended(), name)
            assert_memory_below(self, memory_of(node.process.pid)[1], 500.0, name + ' [MB] [FLT-1]')
        patrol.signal(2)
        code, said = patrol.finish()
        self.assertIn('patrol canceled', said)
        for publisher in publishers:
            publisher.unregister()
        self.assert_all_work()

    def test_waits_and_allowances_without_end(self):
        for duration in (LONGEST, SHORTEST, rospy.Duration(-1)):
            for goal in (WaitGoal(duration, rospy.Duration(0)), WaitGoal(rospy.Duration(1000), duration)):
                self.goals['wait'].publish(WaitActionGoal(goal=goal))
            self.goals['spin'].publish(SpinActionGoal(goal=SpinGoal(0.1, duration, False)))
        self.goals['wait'].publish(WaitActionGoal(goal=WaitGoal(LONGEST, LONGEST)))
        self.assert_all_work()

    def test_a_wait_without_end_does_not_keep_its_node_from_ending(self):
        node = Node('behavior_server', '__ns:=leaving')
        self.addCleanup(node.end)
        client = actionlib.SimpleActionClient('/leaving/wait', WaitAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(30.0)))
        client.send_goal(WaitGoal(LONGEST, rospy.Duration(0)))
        self.assertTrue(wait_for(lambda: node.has_ended() or client.get_state() == GoalStatus.ACTIVE, 10.0))
        self.assertFalse(node.has_ended(), 'the wait has ended its node')
        node.signal(2)
        code, said = node.finish()
        self.assertEqual(code, 0, said)

    def test_transforms_that_cannot_be(self):
        def transform(stamp, parent, child, w=1.0):
            message = TransformStamped()
            message.header.stamp, message.header.frame_id, message.child_frame_id = stamp, parent, child
            message.transform.rotation.w = w
            return message
        for stamp in (END_OF_TIME, rospy.Time(4294967290, 0), rospy.Time.now() + rospy.Duration(1e6)):
            for parent, child in (('odom', 'base_footprint'), ('map', 'odom'), ('', 'odom'), ('odom', 'odom')):
                for w in (1.0, 0.0, float('nan')):
                    self.tf.publish(TFMessage([transform(stamp, parent, child, w)]))
                    self.tf_static.publish(TFMessage([transform(stamp, parent, child + '_static', w)]))
        self.assert_all_work()

    def test_parameters_that_are_none(self):
        """The window asks for the avoider's as soon as that is there."""
        rospy.set_param('/window/obstacle_avoider', 7)
        service = rospy.Service('/window/set_obstacle_avoid_enabled', SetBool, lambda _: (True, ''))
        self.addCleanup(service.shutdown)
        window = Node('teleop_gui', '__ns:=/window')
        self.addCleanup(window.end)
        self.assertTrue(wait_for(lambda: window.has_ended() or 'single value' in window.said(), 20.0))
        self.assertFalse(window.has_ended(), 'the window has ended')

    def test_scans_and_goals_in_frames_and_at_times_that_are_not(self):
        for frame in ('', 'nowhere', '/', 'x' * 10000, 'base_scan'):
            scan = LaserScan(angle_min=-1.0, angle_max=1.0, angle_increment=0.5, range_max=3.5, ranges=[1.0] * 5)
            scan.header.stamp, scan.header.frame_id = END_OF_TIME, frame
            self.scans.publish(scan)
            goal = MoveBaseActionGoal(goal=move_base_goal(frame))
            goal.goal.target_pose.header.stamp = END_OF_TIME
            self.goals['move_base'].publish(goal)
        self.assert_all_work()


if __name__ == '__main__':
    rospy.init_node('hostile_actions')
    rostest.rosrun('frontier_pilot', 'hostile_actions', HostileActions)
