#!/usr/bin/env python3
"""A navigator that shares a door with another robot: it tells where it drives, waits for the other, and goes on. [MUL-3]"""
import signal
import unittest

import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.msg import FleetMotion

from navigator_wire import FAR, NavigatorOnTheWire
from wire import Node, Record, wait_for


class NavigatorTraffic(unittest.TestCase):
    publish_frame = NavigatorOnTheWire.publish_frame
    publish_map = NavigatorOnTheWire.publish_map
    setUp, tearDown = NavigatorOnTheWire.setUp, NavigatorOnTheWire.tearDown
    send, ended, stands, drives = (NavigatorOnTheWire.send, NavigatorOnTheWire.ended, NavigatorOnTheWire.stands,
                                   NavigatorOnTheWire.drives)
    expect_end = NavigatorOnTheWire.expect_end
    navigator_is_at_the_start = staticmethod(NavigatorOnTheWire.navigator_is_at_the_start)

    @classmethod
    def setUpClass(cls):
        NavigatorOnTheWire.setUpClass()
        for name in ('commands', 'odom', 'status', 'stalled', 'world', 'client', 'scan_in'):
            setattr(cls, name, getattr(NavigatorOnTheWire, name))
        cls.motions = Record('/fleet/motions', FleetMotion)
        cls.diagnostics = Record('/diagnostics', DiagnosticArray)
        cls.publisher = rospy.Publisher('/fleet/motions', FleetMotion, queue_size=20)

    @classmethod
    def tearDownClass(cls):
        NavigatorOnTheWire.tearDownClass()

    def own(self):
        return [motion for _, motion in list(self.motions.items) if motion.robot == 'robot1']

    def begin(self):
        """Sends the robot through the door, and gives the way that it tells the others."""
        self.motions.items.clear()
        self.send(FAR)
        self.assertTrue(wait_for(lambda: self.own() and len(self.own()[-1].path) >= 8, 20.0))
        return self.own()[-1].path

    @staticmethod
    def coming(way, **fields):
        """A message of a robot that comes the other way."""
        points = list(zip(way[0::2], way[1::2]))[::-1]
        message = FleetMotion(version=FleetMotion.VERSION, robot='robot2', radius=0.3, valid_for=2.0, passes=['robot1'],
                              x=points[0][0], y=points[0][1], path=[value for point in points for value in point])
        message.header.frame_id, message.header.stamp = 'map', rospy.Time.now()
        for name, value in fields.items():
            setattr(message, name, value)
        return message

    def tell(self, way, **fields):
        self.publisher.publish(self.coming(way, **fields))

    def test_tells_twice_a_second_where_it_is_going_to_drive_in_few_bytes(self):
        self.begin()
        count, began = len(self.own()), rospy.Time.now()
        rospy.sleep(4.0)
        share = (len(self.own()) - count) / (rospy.Time.now() - began).to_sec()
        self.assertGreater(share, 1.0)
        self.assertLess(share, 3.0)
        last = self.own()[-1]
        self.assertEqual((FleetMotion.VERSION, 'map', 2.0), (last.version, last.header.frame_id, last.valid_for))
        self.assertLessEqual(len(last.path), 64)

    def test_gives_way_says_for_whom_and_goes_on_when_the_other_falls_silent(self):
        path = self.begin()
        self.status.items.clear()
        for _ in range(6):
            self.tell(path)
            rospy.sleep(0.5)
        self.assertTrue(any('for robot2' in status.data for _, status in self.status.items), self.status.last)
        self.assertIn('robot2', self.own()[-1].yields_to)
        self.expect_end(GoalStatus.SUCCEEDED, 'goal reached', 60.0)

    def test_refuses_other_versions_and_nonsense_with_a_word(self):
        path = self.begin()
        self.tell(path, version=2)
        self.tell(path, radius=-1.0)
        for word in ('another version of the protocol', 'not finite'):
            self.assertTrue(wait_for(lambda: self.refused(word)), word)
        self.assertFalse(self.own()[-1].yields_to)

    def refused(self, word):
        return any(word in value.key for _, array in list(self.diagnostics.items)
                   for status in array.status for value in status.values)

    # [FLT-1]
    def test_what_a_second_node_says_for_a_robot_is_refused_and_both_nodes_are_named(self):
        path = self.begin()
        self.tell(path, path=[], passes=[])
        stranger = Node('rostopic', 'pub', '-r', '5', '/fleet/motions', 'frontier_pilot/FleetMotion',
                        str(self.coming(path)), package='rostopic')
        self.addCleanup(stranger.signal, signal.SIGKILL)
        word = ": %s speaks for 'robot2'" % rospy.get_name()
        self.assertTrue(wait_for(lambda: self.tell(path, path=[], passes=[]) or self.refused(word), 20.0))
        self.assertFalse(self.own()[-1].yields_to)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'navigator_traffic', NavigatorTraffic)
