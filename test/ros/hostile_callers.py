#!/usr/bin/env python3
"""Whoever calls the emergency stop may name itself as it likes: the robot stops, and stays stopped. [ARB-7] [FLT-1]"""
import io
import os
import signal
import socket
import unittest
from urllib.parse import urlparse

import rosgraph
import rosgraph.network
import rospy
import rostest
from frontier_pilot.msg import ArbiterStatus
from std_srvs.srv import Trigger

from wire import Record, clear, pid_of, wait_for

MOST = 600  # characters of a cause that a person may still read


def stop_as(caller):
    """Calls the emergency stop under this name."""
    service = rospy.resolve_name('emergency_stop')
    rospy.wait_for_service(service, 15.0)
    address = urlparse(rosgraph.Master('/tester').lookupService(service))
    with socket.create_connection((address.hostname, address.port), 15.0) as connection:
        fields = {'service': service, 'md5sum': Trigger._md5sum, 'callerid': caller}
        connection.sendall(rosgraph.network.encode_ros_handshake_header(fields))
        rosgraph.network.read_ros_handshake_header(connection, io.BytesIO(), 65536)
        connection.sendall(bytes(4))
        return connection.recv(1) == b'\x01'


class HostileCallers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.status = Record('cmd_vel_arbiter/status', ArbiterStatus)

    def setUp(self):
        self.assertTrue(clear())
        self.assertTrue(wait_for(lambda: self.status.last is not None and not self.status.last.emergency_stop))

    def cause(self, beginning):
        """That of a stop, once a status has it."""
        def said():
            last = self.status.last
            return last.emergency_stop and last.emergency_stop_cause.startswith(beginning)
        self.assertTrue(wait_for(said, 20.0), self.status.last.emergency_stop_cause[:MOST])
        return self.status.last.emergency_stop_cause

    def test_a_name_of_nearly_a_megabyte_stops_the_robot_and_is_cut(self):
        self.assertTrue(stop_as('/' + 'x' * 900_000))  # roscpp takes no longer ones
        self.assertLess(len(self.cause('emergency_stop called by /xxx')), MOST)

    def test_a_name_of_several_lines_does_not_lose_the_stop_when_the_arbiter_dies(self):
        self.assertTrue(stop_as('/me\n1 2 3 4 a b'))
        self.assertNotIn('\n', self.cause('emergency_stop called by /me'))
        os.kill(pid_of('/cmd_vel_arbiter'), signal.SIGKILL)
        self.assertIn('/me', self.cause('from before a restart: '))


if __name__ == '__main__':
    rospy.init_node('hostile_callers')
    rostest.rosrun('frontier_pilot', 'hostile_callers', HostileCallers)
