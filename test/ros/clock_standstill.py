#!/usr/bin/env python3
"""A clock that never comes, or stands still: every node is there all the same, and says so. [FLT-1]"""
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rosgraph_msgs.msg import Clock

from wire import Node, Record, wait_for

NODES = ('cmd_vel_arbiter', 'obstacle_avoider', 'patrol_server', 'behavior_server', 'mapper', 'map_merger', 'navigator',
         'frontier_explorer', 'fleet_stop')


class ClockStandstill(unittest.TestCase):
    def test_is_said_by_every_node(self):
        clock = rospy.Publisher('/clock', Clock, queue_size=1, latch=True)
        diagnostics = Record('/diagnostics', DiagnosticArray)
        for name in NODES:
            # There may be one that publishes the map.
            self.addCleanup(Node(name, *(['map:=map_of_all'] if name == 'map_merger' else [])).end)

        def silent(text):
            said = {status.name.split(':')[0] for _, message in list(diagnostics.items) for status in message.status
                    if status.level == DiagnosticStatus.WARN and text in status.message}
            return set(NODES) - said
        wait_for(lambda: not silent('no /clock received yet'), 20.0)
        self.assertEqual(silent('no /clock received yet'), set(), '[FLT-1]')
        clock.publish(Clock(rospy.Time(100)))
        wait_for(lambda: not silent('ROS time has stood still for'), 20.0)
        self.assertEqual(silent('ROS time has stood still for'), set(), '[FLT-1]')


if __name__ == '__main__':
    rospy.init_node('clock_standstill')
    rostest.rosrun('frontier_pilot', 'clock_standstill', ClockStandstill)
