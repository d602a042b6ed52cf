#!/usr/bin/env python3
"""A second node of a kind, or a second publisher of the map, beside a running one, and what a node that was
killed has left."""
import os
import signal
import subprocess
import sys
import time
import unittest

import rosgraph
import rospkg
import rospy
import rosservice
import rostest
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from frontier_pilot.msg import ExplorerStatus
from geometry_msgs.msg import Twist
from move_base_msgs.msg import MoveBaseActionGoal
from nav_msgs.msg import MapMetaData, OccupancyGrid
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool, Trigger
from tf2_msgs.msg import TFMessage

from wire import Node, Record, Source, call, clear, moves, wait_for

SIDE = 20  # of the maps [cells]
LARGE = os.path.join(rospkg.RosPack().get_path('frontier_pilot'), 'config', 'worlds', 'office.yaml')

STRANGER = """
import rospy
from nav_msgs.msg import OccupancyGrid
rospy.init_node('stranger')
map = OccupancyGrid()
map.header.frame_id = 'map'
map.info.resolution, map.info.width, map.info.height = 0.05, %d, %d
map.info.origin.orientation.w = 1.0
map.data = [0] * %d
topic = rospy.Publisher('map', OccupancyGrid, queue_size=1)
while topic.get_num_connections() == 0:
    rospy.rostime.wallsleep(0.01)
map.header.stamp = rospy.Time.now()
topic.publish(map)
print('published', flush=True)
rospy.spin()
""" % (SIDE, SIDE, SIDE * SIDE)


def is_served(name, node):
    """Whether the node serves this action or service."""
    publishers, _, services = rosgraph.Master('/second_copies').getSystemState()
    return any(node in nodes for what, nodes in publishers + services if what in (name, name + '/result'))


def map_with_free_cells(count):
    message = OccupancyGrid()
    message.header.frame_id = 'map'
    message.header.stamp = rospy.Time.now()
    message.info.resolution, message.info.width, message.info.height = 0.05, SIDE, SIDE
    message.info.origin.orientation.w = 1.0
    message.data = [0] * count + [100] * (SIDE * SIDE - count)
    return message


class SecondCopies(unittest.TestCase):
    def start(self, executable, *arguments):
        node = Node(executable, *arguments)
        self.addCleanup(node.end)
        return node

    # [FLT-2]
    def test_a_second_explorer_or_avoider_under_another_name_does_not_start(self):
        for executable, service in [('frontier_explorer', 'set_exploration_enabled'),
                                    ('obstacle_avoider', 'set_obstacle_avoid_enabled')]:
            self.start(executable)
            rospy.wait_for_service(service, 10.0)
            code, said = self.start(executable, '__name:=another').finish()
            self.assertEqual(code, 1, said)
            self.assertIn('offers /%s already' % service, said, '[FLT-2]')
            self.assertTrue(call(service, SetBool, False).success)

    # [MAP-3] [FLT-2]
    def test_a_second_mapper_under_another_name_does_not_start_and_takes_no_service(self):
        self.start('mapper')
        rospy.wait_for_service('mapper/save_map', 10.0)
        code, said = self.start('mapper', '__name:=another').finish()
        self.assertEqual(code, 1, said)
        self.assertIn('offers /mapper/save_map already', said, '[MAP-3]')
        for service in 'mapper/save_map', 'mapper/load_map', 'mapper/localize', 'mapper/reset', 'dynamic_map':
            self.assertEqual(rosservice.get_service_node('/' + service), '/mapper', '[MAP-3]')

    # [FLT-2]
    def test_a_second_server_of_an_action_or_of_a_fleet_under_another_name_does_not_start(self):
        for executable, does, name in [('navigator', 'serves the action', '/move_base'),
                                       ('behavior_server', 'serves the action', '/spin'),
                                       ('patrol_server', 'serves the action', '/turtlebot3'),
                                       ('waypoint_follower', 'serves the action', '/follow_waypoints'),
                                       ('fleet_stop', 'offers', '/fleet/emergency_stop'),
                                       ('map_merger', 'offers', '/map_merger/save_map')]:
            first = self.start(executable)
            self.assertTrue(wait_for(lambda: is_served(name, '/' + executable)))
            code, said = self.start(executable, '__name:=another').finish()
            self.assertEqual(code, 1, said)
            self.assertIn('%s %s already' % (does, name), said, '[FLT-2]')
            first.signal(signal.SIGKILL)
            first.finish()
            second = self.start(executable, '__name:=another')
            self.assertTrue(wait_for(lambda: is_served(name, '/another')), 'the first one has died [FLT-2]')
            second.end()

    # [FLT-2]
    def test_a_navigator_of_another_robot_starts(self):
        for robot in '/one', '/two':
            self.start('navigator', '__ns:=' + robot)
            rospy.wait_for_service(robot + '/make_plan', 10.0)

    # [MAP-3]
    def test_a_mapper_that_is_started_with_a_map_beside_another_map_says_nothing_until_that_one_has_ended(self):
        transforms, maps = Record('/tf', TFMessage), Record('map', OccupancyGrid)
        self.addCleanup(transforms.subscriber.unregister)
        self.addCleanup(maps.subscriber.unregister)
        other = rospy.Publisher('map', OccupancyGrid, queue_size=1)
        self.addCleanup(other.unregister)
        mapper = self.start('mapper', '_map_file:=' + LARGE)
        self.addCleanup(rospy.delete_param, 'mapper/map_file')
        self.assertTrue(wait_for(lambda: 'publishes /map as well' in mapper.said(), 20.0), mapper.said())
        self.assertEqual(len(maps.items), 0, '[MAP-3]')
        self.assertFalse([message for _, message in transforms.items
                          if any(each.child_frame_id == 'odom' for each in message.transforms)], '[MAP-3]')
        other.unregister()
        self.assertTrue(wait_for(lambda: maps.items), '[MAP-3]')

    # [MAP-3]
    def test_a_mapper_beside_another_map_does_not_say_where_the_robot_is_until_that_one_has_ended(self):
        transforms, localized = Record('/tf', TFMessage), Record('mapper/localized', Bool)
        self.addCleanup(transforms.subscriber.unregister)
        self.addCleanup(localized.subscriber.unregister)
        self.start('mapper')

        def says_where():
            return any(at > time.monotonic() - 1.0 for at, message in transforms.items[-100:]
                       if any(each.child_frame_id == 'odom' for each in message.transforms))
        self.assertTrue(wait_for(lambda: says_where() and localized.last is not None and localized.last.data, 15.0))
        other = rospy.Publisher('map', OccupancyGrid, queue_size=1)
        self.addCleanup(other.unregister)
        self.assertTrue(wait_for(lambda: not says_where()), '[MAP-3]')
        self.assertTrue(wait_for(lambda: localized.subscriber.get_num_connections() == 0), '[MAP-3]')
        localized.items.clear()
        other.unregister()
        self.assertTrue(wait_for(lambda: says_where() and localized.last is not None and localized.last.data), '[MAP-3]')

    # [MAP-3] [NAV-1]
    def test_a_mapper_that_has_only_kept_silent_beside_another_map_ends_no_goal_on_that_one(self):
        replaced = Record('mapper/replaced', String)
        self.addCleanup(replaced.subscriber.unregister)
        other = rospy.Publisher('map', OccupancyGrid, queue_size=1)
        mapper = self.start('mapper')
        self.assertTrue(wait_for(lambda: 'this mapper keeps silent' in mapper.said()))
        self.assertTrue(wait_for(lambda: replaced.subscriber.get_num_connections() > 0))
        self.assertTrue(call('mapper/reset', Trigger).success)
        owned = Record('map_metadata', MapMetaData)
        self.addCleanup(owned.subscriber.unregister)
        other.unregister()
        self.assertTrue(wait_for(lambda: owned.subscriber.get_num_connections() > 0))
        self.assertTrue(call('mapper/reset', Trigger).success)
        self.assertTrue(wait_for(lambda: replaced.items))
        self.assertEqual(len(replaced.items), 1, 'only that of its own map [MAP-3]')

    # [ARB-8] [FLT-2]
    def test_a_stop_is_not_cleared_by_an_arbiter_that_has_not_heard_yet_who_asks_for_motion(self):
        out = Record('cmd_vel', Twist)
        arbiter = self.start('cmd_vel_arbiter')
        manual = Source('cmd_vel_manual').connect().start(0.05)
        self.addCleanup(manual.close)
        call('emergency_stop', Trigger)
        arbiter.signal(signal.SIGKILL)
        arbiter.finish()
        stopped = time.monotonic()
        self.start('cmd_vel_arbiter')
        answers = []
        while time.monotonic() < stopped + 5.0:
            try:
                answers.append(rospy.ServiceProxy('set_emergency_stop', SetBool)(False))
            except rospy.ServiceException:  # until it is registered again
                rospy.rostime.wallsleep(0.01)
        self.assertTrue(answers, 'a clear is answered again')
        self.assertEqual([answer.message for answer in answers if answer.success], [], '[ARB-8]')
        self.assertFalse(any(moves(message) for message in out.since(stopped)), '[ARB-8]')
        manual.stop()
        self.assertTrue(wait_for(clear), 'once nobody asks for motion any more')

    # [FLT-2] [EXP-8]
    def test_an_explorer_cancels_the_goal_that_the_one_before_it_has_left(self):
        cancels = Record('move_base/cancel', GoalID)
        statuses = rospy.Publisher('move_base/status', GoalStatusArray, queue_size=1)
        goals = Record('move_base/goal', MoveBaseActionGoal)  # a status counts if it comes from who takes the goals
        self.addCleanup(goals.subscriber.unregister)
        pursued = GoalStatusArray()
        for name in ['/frontier_explorer-3-12.5', '/somebody-1-12.5']:
            status = GoalStatus(status=GoalStatus.ACTIVE)
            status.goal_id.id, status.goal_id.stamp = name, rospy.Time(12.5)
            pursued.status_list.append(status)
        self.start('frontier_explorer')

        def canceled():
            statuses.publish(pursued)
            return bool(cancels.items)
        self.assertTrue(wait_for(canceled), '[FLT-2]')
        self.assertEqual({message.id for _, message in cancels.items}, {'/frontier_explorer-3-12.5'})
        self.assertTrue(all(message.stamp == rospy.Time() for _, message in cancels.items), 'none that is older')

    # [FLT-1]
    def test_the_map_of_a_stranger_does_not_replace_that_of_the_mapper(self):
        status = Record('frontier_explorer/status', ExplorerStatus)
        topic = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        self.start('frontier_explorer')
        self.assertTrue(wait_for(lambda: topic.get_num_connections() > 0))
        topic.publish(map_with_free_cells(100))
        self.assertTrue(wait_for(lambda: status.last is not None and abs(status.last.explored_area - 0.25) < 1e-6))
        stranger = subprocess.Popen([sys.executable, '-c', STRANGER])
        self.addCleanup(stranger.wait)
        self.addCleanup(stranger.kill)
        heard = len(status.items)
        self.assertTrue(wait_for(lambda: len(status.items) >= heard + 5, 15.0))
        topic.publish(map_with_free_cells(200))
        self.assertTrue(wait_for(lambda: abs(status.last.explored_area - 0.5) < 1e-6))
        areas = {round(message.explored_area, 6) for _, message in status.items[heard:]}
        self.assertEqual(areas, {0.25, 0.5}, '[FLT-1]')

    # [FLT-1] [MAP-3]
    def test_the_map_of_a_stranger_does_not_replace_that_of_a_node_that_lives_and_has_withdrawn_it(self):
        status = Record('frontier_explorer/status', ExplorerStatus)
        topic = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        self.start('frontier_explorer')
        topic.publish(map_with_free_cells(100))
        self.assertTrue(wait_for(lambda: status.last is not None and abs(status.last.explored_area - 0.25) < 1e-6))
        topic.unregister()  # as a mapper does beside a stranger
        stranger = subprocess.Popen([sys.executable, '-c', STRANGER], stdout=subprocess.PIPE)
        self.addCleanup(stranger.communicate)
        self.addCleanup(stranger.kill)
        stranger.stdout.readline()  # it has published its map
        heard = len(status.items)
        self.assertTrue(wait_for(lambda: len(status.items) >= heard + 5, 15.0))
        self.assertAlmostEqual(status.last.explored_area, 0.25, 6, '[FLT-1]')

    # [FLT-1]
    def test_a_map_that_was_refused_is_used_once_the_stranger_before_it_has_died(self):
        status = Record('frontier_explorer/status', ExplorerStatus)
        stranger = subprocess.Popen([sys.executable, '-c', STRANGER])
        self.addCleanup(stranger.wait)
        self.addCleanup(stranger.kill)
        self.start('frontier_explorer')
        self.assertTrue(wait_for(lambda: status.last is not None and status.last.explored_area > 0.0, 15.0))
        of_stranger = status.last.explored_area
        topic = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        self.addCleanup(topic.unregister)
        topic.publish(map_with_free_cells(200))
        self.assertTrue(wait_for(lambda: topic.get_num_connections() > 0))
        rospy.rostime.wallsleep(1.0)
        self.assertEqual(status.last.explored_area, of_stranger, 'refused')
        stranger.kill()
        self.assertTrue(wait_for(lambda: abs(status.last.explored_area - 0.5) < 1e-6, 15.0), '[FLT-1]')


if __name__ == '__main__':
    rospy.init_node('second_copies_test')
    rostest.rosrun('frontier_pilot', 'second_copies', SecondCopies)
