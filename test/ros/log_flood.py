#!/usr/bin/env python3
"""Nobody fills the disk by asking again and again: a line of the log that can be brought about at will has a budget."""
import collections
import threading
import time
import unittest

import rospy
import rostest
from frontier_pilot.msg import PatrolActionGoal, SpinActionGoal
from frontier_pilot.srv import LoadMap, SaveMap
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from nav_msgs.srv import GetPlan
from rosgraph_msgs.msg import Log
from std_srvs.srv import SetBool

from wire import Record, wait_for

SECONDS = 4.0  # of flood
BURST, RATE = 20, 1.0  # what one line of the source code may say: at once, and then a second


def in_a_loop(action, end):
    """Calls `action` with 0, 1, 2, ... until the steady time `end`; gives how often."""
    count = 0
    while time.monotonic() < end and not rospy.is_shutdown():
        try:
            action(count)
        except rospy.ServiceException:
            pass  # a call that is refused without an answer
        count += 1
    return count


def patrol_goal(i):
    goal = PatrolActionGoal()
    goal.goal_id.id, goal.goal_id.stamp = 'patrol %d' % i, rospy.Time.now()
    goal.goal.goal.x, goal.goal.goal.y, goal.goal.goal.z = 1.0, 1.0, 1.0  # a square of 1 m
    return goal


def spin_goal(i):
    goal = SpinActionGoal()
    goal.goal_id.id, goal.goal_id.stamp = 'spin %d' % i, rospy.Time.now()
    goal.goal.target_yaw = 1.0
    return goal


class LogFlood(unittest.TestCase):
    def test_a_flood_of_requests_is_no_flood_of_lines(self):
        """[FLT-1]"""
        said = Record('/rosout', Log)
        services = {
            'mapper/save_map': (SaveMap, lambda i: '/nowhere/%d' % i),
            'mapper/load_map': (LoadMap, lambda i: '/nowhere/%d' % i),
            'set_obstacle_avoid_enabled': (SetBool, lambda i: i % 2 == 0),
            'set_exploration_enabled': (SetBool, lambda i: i % 2 == 0),
        }
        calls = []
        for name, (kind, argument) in services.items():
            rospy.wait_for_service(name, 20.0)
            proxy = rospy.ServiceProxy(name, kind, persistent=True)
            calls.append(lambda i, proxy=proxy, argument=argument: proxy(argument(i)))
        rospy.wait_for_service('make_plan', 20.0)
        make_plan = rospy.ServiceProxy('make_plan', GetPlan)
        calls.append(lambda i: make_plan(PoseStamped(), PoseStamped(), 0.1))
        topics = {
            'initialpose': (PoseWithCovarianceStamped, lambda i: PoseWithCovarianceStamped()),
            'move_base_simple/goal': (PoseStamped, lambda i: PoseStamped()),
            'turtlebot3/goal': (PatrolActionGoal, patrol_goal),
            'spin/goal': (SpinActionGoal, spin_goal),
        }
        for name, (kind, message) in topics.items():
            publisher = rospy.Publisher(name, kind, queue_size=10)
            self.assertTrue(wait_for(lambda p=publisher: p.get_num_connections() > 0, 20.0), name)

            def publish(i, publisher=publisher, message=message):
                publisher.publish(message(i))
                rospy.rostime.wallsleep(0.002)  # 500 a second
            calls.append(publish)
        self.assertTrue(wait_for(lambda: said.subscriber.get_num_connections() >= 6))

        begin = time.monotonic()
        counts = [0] * len(calls)

        def flood(k):
            counts[k] = in_a_loop(calls[k], begin + SECONDS)
        threads = [threading.Thread(target=flood, args=(k,)) for k in range(len(calls))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertGreater(sum(counts), 50 * BURST, 'a flood it should be: %s' % counts)
        # Each answers still, and by then what it said has been passed on as far as the queues go.
        self.assertFalse(rospy.ServiceProxy('mapper/save_map', SaveMap)('/nowhere/last').success)

        lines = collections.Counter((log.name, log.file, log.line) for log in said.since(begin))
        seconds = time.monotonic() - begin
        for place, count in lines.items():
            self.assertLessEqual(count, BURST + RATE * seconds + 1, place)
        size = sum(len(log.msg) for log in said.since(begin))
        self.assertGreater(len(lines), 4, 'the nodes still say something')
        self.assertLess(size, 100000, 'bytes of log for %s requests' % counts)
        self.assertTrue(any('suppressed' in log.msg for log in said.since(begin)), lines)


if __name__ == '__main__':
    rospy.init_node('log_flood')
    rostest.rosrun('frontier_pilot', 'log_flood', LogFlood)
