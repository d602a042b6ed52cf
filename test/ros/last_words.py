#!/usr/bin/env python3
"""What navigator and explorer say last when they are ended while the robot drives: read from their sockets."""
import signal
import unittest

import rosnode
import rospy
import rostest
import tf2_ros
from actionlib_msgs.msg import GoalID
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from move_base_msgs.msg import MoveBaseActionGoal
from nav_msgs.msg import OccupancyGrid

from tap import Tap
from wire import Node, Record, moves, wait_for

START = (0.7, 0.8)  # in the world; the origin of map and odom
FAR = (3.3, 2.4)    # in the other room
ROUNDS = 6          # what is lost by chance is not lost every time


def end(node, name, number):
    """By Ctrl-C, by the end of the terminal, or by `rosnode kill`."""
    way = number % 3
    if way == 2:
        rosnode.kill_nodes([name])
    else:
        node.signal([signal.SIGINT, signal.SIGHUP][way])


class LastWords(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('last_words')
        cls.world = Record('simulator/world', OccupancyGrid)
        cls.map = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        cls.frames = tf2_ros.StaticTransformBroadcaster()
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'map', 'odom'
        transform.transform.rotation.w = 1.0
        cls.frames.sendTransform(transform)

    def publish_map(self, unknown_from=None):
        """The world as the map; from column `unknown_from` on nobody has been there yet."""
        self.assertTrue(wait_for(lambda: self.world.last is not None, 20.0))
        grid = OccupancyGrid(info=self.world.last.info, data=list(self.world.last.data))
        grid.header.frame_id = 'map'
        grid.info.origin.position.x, grid.info.origin.position.y = -START[0], -START[1]
        if unknown_from is not None:
            for i in range(len(grid.data)):
                if i % grid.info.width >= unknown_from:
                    grid.data[i] = -1
        self.map.publish(grid)

    def start(self, executable, *arguments):
        node = Node(executable, *arguments)
        self.addCleanup(node.end)
        return node

    def tap(self, publisher, topic, kind):
        tap = Tap(publisher, topic, kind)
        self.addCleanup(tap.close)
        return tap

    def test_the_navigator_ends_with_a_zero(self):  # [NAV-1]
        self.publish_map()
        for i in range(ROUNDS):
            name = 'navigator%d' % i
            navigator = self.start('navigator', '__name:=' + name)
            goals = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=1)
            self.assertTrue(wait_for(lambda: goals.get_num_connections() > 0, 20.0))
            commands = self.tap('/' + name, '/cmd_vel_nav', Twist)
            goal = PoseStamped()
            goal.header.frame_id = 'map'
            goal.pose.position.x, goal.pose.position.y = FAR
            goal.pose.orientation.w = 1.0
            goals.publish(goal)
            heard = []
            self.assertTrue(wait_for(lambda: heard.extend(commands.arrived()) or (heard and moves(heard[-1])), 20.0))
            end(navigator, '/' + name, i)
            heard += commands.until_closed(10.0)
            self.assertFalse(moves(heard[-1]), 'round %d: %s' % (i, heard[-1]))
            self.assertEqual(navigator.finish()[0], 0)
            goals.unregister()

    def test_the_explorer_ends_with_a_cancel_of_its_goal(self):  # [EXP-7]
        self.publish_map(unknown_from=60)
        self.start('navigator', '__name:=navigator')
        for i in range(ROUNDS):
            name = 'explorer%d' % i
            explorer = self.start('frontier_explorer', '__name:=' + name, '_autostart:=true')
            goals = Record('move_base/goal', MoveBaseActionGoal)
            self.assertTrue(wait_for(lambda: goals.last is not None, 30.0))
            cancels = self.tap('/' + name, '/move_base/cancel', GoalID)
            latest = goals.last.goal_id.id
            end(explorer, '/' + name, i)
            cancelled = [cancel.id for cancel in cancels.until_closed(10.0)]
            goals.subscriber.unregister()
            self.assertTrue(cancelled, 'round %d' % i)
            self.assertIn(cancelled[-1], [latest, goals.last.goal_id.id])
            self.assertEqual(explorer.finish()[0], 0)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'last_words', LastWords)
