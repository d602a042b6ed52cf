"""Explorers that are started for each case of a test, against a move_base and a map that are not this package's."""
import signal
import unittest

import rospy
from frontier_pilot.msg import ExplorerStatus as Status
from visualization_msgs.msg import MarkerArray

from foreign_robot import ForeignRobot, hall
from wire import Node, Record, wait_for

START = (-0.5, 0.0)  # the left end is nearer


class ExplorerCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.robot = ForeignRobot(*START)
        cls.robot.show(hall())
        cls.status = Record('frontier_explorer/status', Status)
        cls.markers = Record('frontier_explorer/frontiers', MarkerArray)

    def explore(self, **parameters):
        """Starts an explorer at the robot's start."""
        self.robot.position = START
        self.robot.show(hall())
        self.robot.goals.clear()
        self.robot.track.clear()
        self.status.items.clear()
        self.markers.items.clear()
        parameters.update({'autostart': True, 'done_settle_time': 0.5, 'settle_time': 0.2,
                           'frontier': {'view': {'sensor_range': 1.0}}})
        rospy.set_param('frontier_explorer', parameters)
        self.addCleanup(rospy.delete_param, 'frontier_explorer')
        self.start()

    def start(self):
        self.node = Node('frontier_explorer', '__name:=frontier_explorer')
        self.addCleanup(self.node.end)

    def start_again(self):
        """Kills the explorer, and starts the next one in its place, as roslaunch does."""
        self.node.signal(signal.SIGKILL)
        self.node.finish()
        self.status.items.clear()
        self.start()

    def comes(self, condition, timeout=10.0):
        """Whether a status comes, or has come, for which the condition holds."""
        return wait_for(lambda: any(condition(status) for _, status in list(self.status.items)), timeout)

    def expect_reason(self, reason):
        self.assertTrue(self.comes(lambda status: status.reason == reason),
                        [(s.state_text, s.reason_text) for _, s in self.status.items])

    def expect_done(self, reason, timeout=10.0):
        self.assertTrue(self.comes(lambda status: status.state == Status.DONE, timeout),
                        [(s.state_text, s.reason_text) for _, s in self.status.items])
        self.assertEqual(reason, self.status.last.reason, self.status.last.reason_text)

    def is_at_start(self):
        return max(abs(a - b) for a, b in zip(self.robot.position, START)) < 0.05
