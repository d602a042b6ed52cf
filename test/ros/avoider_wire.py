#!/usr/bin/env python3
"""The avoider on the wire, with a scanner that is mounted upside down, and the arbiter below it."""
import math
import threading
import time
import unittest

import rospy
import rostest
from frontier_pilot.msg import ArbiterStatus, AvoiderStatus
from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan
from std_srvs.srv import SetBool

from wire import Record, Source, call, clear, emergency_stop, moves, wait_for

BEAMS = 360


class World:
    """Publishes scans at 20 Hz; `ranges` maps a direction seen from the base [deg] to a range [m]."""

    def __init__(self):
        self.publisher = rospy.Publisher('scan', LaserScan, queue_size=1)
        self.ranges = {}
        self.default = float('inf')
        self.alive = True
        threading.Thread(target=self._run, daemon=True).start()

    def scan(self):
        scan = LaserScan()
        scan.header.stamp = rospy.Time.now()
        scan.header.frame_id = 'base_scan'
        scan.angle_min, scan.angle_increment = -math.pi, 2.0 * math.pi / BEAMS
        scan.angle_max = scan.angle_min + (BEAMS - 1) * scan.angle_increment
        scan.range_min, scan.range_max = 0.1, 8.0
        scan.ranges = [self.default] * BEAMS
        for degrees, distance in self.ranges.items():
            # Upside down and looking backward: a beam at `a` of the scanner points to 180 degrees - a of the base.
            scan.ranges[(180 - degrees + 180) % BEAMS] = distance
        return scan

    def _run(self):
        pace = threading.Event()
        while not pace.wait(0.05):
            if self.alive:
                self.publisher.publish(self.scan())


class AvoiderOnTheWire(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.world = World()
        cls.out = Record('cmd_vel_avoid', Twist)
        cls.wheels = Record('cmd_vel', Twist)
        cls.status = Record('obstacle_avoider/status', AvoiderStatus)
        cls.arbiter = Record('cmd_vel_arbiter/status', ArbiterStatus)

    def setUp(self):
        self.world.ranges, self.world.default, self.world.alive = {}, float('inf'), True
        call('set_obstacle_avoid_enabled', SetBool, True)
        self.assertTrue(self.becomes(AvoiderStatus.CLEAR), 'must start clear')

    def becomes(self, state, timeout=5.0):
        return wait_for(lambda: self.status.last is not None and self.status.last.state == state, timeout)

    # [AVO-3]
    def test_when_clear_zeros_leave_at_10_hz(self):
        first = len(self.out.items)
        self.assertTrue(wait_for(lambda: len(self.out.items) >= first + 21))
        items = self.out.items[first:first + 21]
        self.assertAlmostEqual(20.0 / (items[-1][0] - items[0][0]), 10.0, delta=1.5, msg='[AVO-3]')
        self.assertTrue(all(message == Twist() for _, message in items), '[AVO-3]')

    # [AVO-1] [AVO-3]
    def test_backs_up_and_turns_away_from_the_side_that_the_mount_says(self):
        for degrees, turn in [(30, -0.7), (-30, 0.7)]:
            self.world.ranges = {degrees: 0.4}
            self.assertTrue(wait_for(lambda: self.out.last.linear.x == -0.08), '[AVO-3]')
            self.assertTrue(wait_for(lambda: self.out.last.angular.z == turn, 2.0), '%d degrees [AVO-1]' % degrees)
            self.assertTrue(wait_for(lambda: self.wheels.last.angular.z == turn, 2.0), 'through the arbiter')
            self.world.ranges = {}
            self.assertTrue(self.becomes(AvoiderStatus.CLEAR), '[AVO-3]')

    # [AVO-4]
    def test_does_not_reverse_into_what_is_behind(self):
        start = time.monotonic()
        self.world.ranges = {20: 0.4, 180: 0.2}
        self.assertTrue(wait_for(lambda: self.out.last.angular.z == -0.7))
        self.assertFalse(any(message.linear.x < 0.0 for message in self.out.since(start)), '[AVO-4]')

    # [ARB-8]
    def test_lets_a_stop_be_cleared_beside_an_obstacle_and_moves_nothing_until_another_source_drives(self):
        self.world.ranges = {20: 0.4}
        self.assertTrue(wait_for(lambda: moves(self.wheels.last)))
        emergency_stop()
        self.assertTrue(wait_for(lambda: 'it was stopped' in self.status.last.reason))
        self.assertTrue(clear(), 'it asks for no motion')
        cleared = time.monotonic()
        wait_for(lambda: False, 1.5)
        self.assertFalse(any(moves(message) for message in self.wheels.since(cleared)), '[ARB-8]')
        nav = Source('cmd_vel_nav').connect().start(0.1)
        self.assertTrue(wait_for(lambda: self.wheels.last.linear.x == -0.08), '[AVO-3]')
        nav.close()

    # [AVO-5]
    def test_without_a_trustworthy_scan_it_holds_the_wheels_against_the_others(self):
        nav = Source('cmd_vel_nav').connect().start(0.1)
        self.assertTrue(wait_for(lambda: self.wheels.last.linear.x == 0.1))
        self.world.alive = False
        self.assertTrue(self.becomes(AvoiderStatus.FAULT), 'old scan [AVO-5]')
        self.assertTrue(wait_for(lambda: not moves(self.wheels.last)), '[AVO-5]')
        self.assertTrue(wait_for(lambda: self.arbiter.last.active_source == 'avoid'))
        self.assertEqual((self.out.last.linear.x, self.out.last.angular.z), (0.0, 0.0))
        self.world.alive = True
        self.assertTrue(wait_for(lambda: self.wheels.last.linear.x == 0.1))
        self.world.default = float('nan')
        self.assertTrue(wait_for(lambda: self.status.last.reason == '360 of 360 beams are invalid'), '[AVO-5]')
        self.assertTrue(wait_for(lambda: not moves(self.wheels.last)), '[AVO-5]')
        nav.close()

    # [AVO-6]
    def test_disabling_gives_one_zero_and_silence_and_enabling_needs_a_new_scan(self):
        self.world.ranges = {20: 0.4}
        self.assertTrue(wait_for(lambda: moves(self.out.last)))
        self.assertTrue(call('set_obstacle_avoid_enabled', SetBool, False).success)
        self.assertTrue(wait_for(lambda: self.out.last == Twist()), 'one zero [AVO-6]')
        self.assertTrue(self.becomes(AvoiderStatus.IDLE), '[AVO-6]')
        quiet = len(self.out.items)
        wait_for(lambda: False, 0.5)
        self.assertEqual(len(self.out.items), quiet, 'silent [AVO-6]')
        self.world.alive = False
        self.assertTrue(call('set_obstacle_avoid_enabled', SetBool, True).success)
        self.assertTrue(self.becomes(AvoiderStatus.WAITING), '[AVO-6]')
        self.world.ranges, self.world.alive = {}, True
        self.assertTrue(self.becomes(AvoiderStatus.CLEAR))


if __name__ == '__main__':
    rospy.init_node('avoider_wire_test')
    rostest.rosrun('frontier_pilot', 'avoider_wire', AvoiderOnTheWire)
