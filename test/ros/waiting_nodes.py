#!/usr/bin/env python3
"""What nodes wait for beside a robot with other names, in the log and in the diagnostics; and when they are ready. [ROB-3]"""
import os
import sys
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from frontier_pilot.msg import ExplorerStatus

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from named_robot import NamedRobot  # noqa: E402
from wire import Node, Record, wait_for  # noqa: E402

SAID_WITHIN = 5.0  # [s] after the node is up
NO_SCAN = 'nobody publishes /scan; /foreign/base_scan is a sensor_msgs/LaserScan'
NO_ODOMETRY = 'nobody publishes /odom; /foreign/wheels/odom is a nav_msgs/Odometry of'
NO_MAP = '/map is published, but no map has arrived yet'  # the mapper, too, waits
NO_BASE = 'no frame base_footprint; base_link exists: set base_frame:=base_link'
WAITING = {
    'mapper': [NO_SCAN, NO_ODOMETRY],
    'navigator': [NO_SCAN, NO_ODOMETRY, NO_MAP, NO_BASE],
    'frontier_explorer': [NO_ODOMETRY, NO_MAP, NO_BASE],
    'behavior_server': [NO_SCAN, NO_BASE],
    'obstacle_avoider': [NO_SCAN],
    'patrol_server': [NO_ODOMETRY],
}
TF = ('/tf:=/foreign/tf', '/tf_static:=/foreign/tf_static')


class Diagnostics:
    """The row `connections` of each node, and when it first came."""

    def __init__(self):
        self.rows, self.since = {}, {}
        rospy.Subscriber('/diagnostics', DiagnosticArray, self.take)

    def take(self, message):
        for status in message.status:
            node, _, row = status.name.partition(': ')
            if row == 'connections':
                self.since.setdefault(node, time.monotonic())
                self.rows[node] = status

    def says(self, node, words):
        row = self.rows.get(node)
        return row is not None and row.level == DiagnosticStatus.WARN and all(word in row.message for word in words)


class WaitingNodes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.diagnostics = Diagnostics()
        cls.robot = NamedRobot('foreign')

    def start(self, name, *arguments):
        node = Node(name, *TF, *arguments)
        self.addCleanup(node.end)
        return node

    def test_each_says_for_what_it_waits_and_under_which_name_it_is_there(self):
        status = Record('frontier_explorer/status', ExplorerStatus)
        nodes = {name: self.start(name) for name in WAITING}
        for name, words in WAITING.items():
            said = wait_for(lambda: self.diagnostics.says(name, words), 30.0)
            self.assertTrue(said, (name, words, self.diagnostics.rows.get(name)))
        for name, words in WAITING.items():
            logged = wait_for(lambda: all(word in nodes[name].said() for word in ['waiting: ', *words]), 30.0)
            self.assertTrue(logged, (name, words, nodes[name].said()))
        self.assertIn('nobody publishes /odom', status.last.reason_text)  # which the window shows

    def test_it_is_said_within_five_seconds(self):
        node = self.start('behavior_server', '__name:=late_server')
        self.assertTrue(wait_for(lambda: self.diagnostics.says('late_server', [NO_BASE]), 30.0))
        self.assertLess(time.monotonic() - self.diagnostics.since['late_server'], SAID_WITHIN, node.said())

    def test_a_node_that_is_told_the_names_is_ready(self):
        node = self.start('mapper', '__name:=told_mapper', 'scan:=/foreign/base_scan', 'odom:=/foreign/wheels/odom',
                          '_robot/base_frame:=base_link')
        said = []

        def ready():
            said.append(node.said())
            return 'ready: all inputs are there' in said[-1]
        self.assertTrue(wait_for(ready, 30.0), said[-1])

        def well():
            row = self.diagnostics.rows.get('told_mapper')
            return row is not None and row.level == DiagnosticStatus.OK
        self.assertTrue(wait_for(well), self.diagnostics.rows.get('told_mapper'))
        self.assertIn('inputs', [value.key for value in self.diagnostics.rows['told_mapper'].values])


if __name__ == '__main__':
    rospy.init_node('waiting_nodes_test')
    rostest.rosrun('frontier_pilot', 'waiting_nodes', WaitingNodes)
