#!/usr/bin/env python3
"""The arbiter under a ROS clock that the test drives: it stops, and it jumps back."""
import threading
import time
import unittest

import rospy
import rostest
from frontier_pilot.msg import ArbiterStatus
from geometry_msgs.msg import Twist
from rosgraph_msgs.msg import Clock

from wire import Record, Source, moves, wait_for


class DrivenClock:
    """/clock at real speed, until it is held."""

    def __init__(self):
        self.publisher = rospy.Publisher('/clock', Clock, queue_size=1, tcp_nodelay=True)
        self.now = 1000.0
        self.running = True
        threading.Thread(target=self._run, daemon=True).start()

    def _run(self):
        pace = threading.Event()
        while not pace.wait(0.01):
            if self.running:
                self.now += 0.01
                self.publisher.publish(Clock(rospy.Time.from_sec(self.now)))


class ArbiterAndItsClock(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock = DrivenClock()
        cls.out = Record('cmd_vel', Twist)
        cls.status = Record('cmd_vel_arbiter/status', ArbiterStatus)
        cls.nav = Source('cmd_vel_nav').connect()

    def setUp(self):
        self.clock.running = True
        self.nav.start(0.1)
        self.assertTrue(wait_for(lambda: self.out.last is not None and moves(self.out.last)))

    def tearDown(self):
        self.nav.stop()

    def stays_at_rest(self, seconds):
        start = time.monotonic()
        wait_for(lambda: False, seconds)
        return not any(moves(message) for message in self.out.since(start))

    # [ARB-9]
    def test_when_ros_time_stands_still_the_robot_stops_although_messages_arrive(self):
        self.clock.running = False
        start = time.monotonic()
        self.assertTrue(wait_for(lambda: not moves(self.out.last), 2.0), '[ARB-9]')
        self.assertGreater(time.monotonic() - start, 0.3)
        self.assertTrue(wait_for(lambda: self.status.last.state == ArbiterStatus.CLOCK_STOPPED, 2.0))
        still = time.monotonic()
        self.assertTrue(wait_for(lambda: len(self.out.since(still)) >= 20), 'zeros go on by the steady clock [ARB-9]')
        self.assertFalse(any(moves(message) for message in self.out.since(still)), '[ARB-9]')
        self.nav.stop()
        self.clock.running = True
        self.assertTrue(wait_for(lambda: self.status.last.state == ArbiterStatus.IDLE, 2.0))
        self.assertTrue(self.stays_at_rest(0.5), 'nothing revives without a new message [ARB-9]')
        self.nav.send(0.1)
        self.assertTrue(wait_for(lambda: moves(self.out.last), 2.0))

    # [ARB-9]
    def test_when_ros_time_jumps_back_every_source_is_stale(self):
        self.nav.stop()
        self.nav.send(0.1)
        self.assertTrue(wait_for(lambda: moves(self.out.last)))
        self.clock.now -= 100.0
        self.assertTrue(wait_for(lambda: not moves(self.out.last), 0.5), '[ARB-9]')
        self.clock.now += 100.0
        self.assertTrue(self.stays_at_rest(0.5), 'jumping forth again revives nothing [ARB-9]')


if __name__ == '__main__':
    rospy.init_node('arbiter_clock_test')
    rostest.rosrun('frontier_pilot', 'arbiter_clock', ArbiterAndItsClock)
