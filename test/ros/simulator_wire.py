#!/usr/bin/env python3
"""The simulator on the wire: its topics and frames for two robots, its services, its clock, and how it refuses to start."""
import math
import os
import signal
import tempfile
import time
import unittest

import rospkg
import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.srv import RemoveObstacle, SetPose, SpawnObstacle
from geometry_msgs.msg import Pose2D
from nav_msgs.msg import OccupancyGrid, Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool
from std_srvs.srv import Empty, SetBool

from wire import SANITIZED, Node, Record, Source, call, memory_of, wait_for

RADIUS = 0.105


def world(name='small'):
    return os.path.join(rospkg.RosPack().get_path('frontier_pilot'), 'config', 'worlds', name + '.yaml')


class SimulatorOnTheWire(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('simulator_wire')
        cls.clock = Record('/clock', Clock)
        cls.scan = Record('left/scan', LaserScan)
        cls.odom = Record('left/odom', Odometry)
        cls.truth = Record('left/base_pose_ground_truth', Odometry)
        cls.other = Record('right/base_pose_ground_truth', Odometry)
        cls.stalled = Record('left/simulator/stalled', Bool)
        cls.tf = tf2_ros.Buffer()
        cls.listener = tf2_ros.TransformListener(cls.tf)
        cls.drive = Source('left/cmd_vel').connect()

    def setUp(self):
        call('simulator/pause', SetBool, False)
        call('reset_positions', Empty)
        start = time.monotonic()
        for record in (self.clock, self.scan, self.odom, self.truth, self.other, self.stalled):
            self.assertTrue(wait_for(lambda: record.since(start)), record.subscriber.name)

    def tearDown(self):
        self.drive.stop()

    def at(self):
        return self.truth.last.pose.pose.position

    def test_clock_never_goes_back_and_steps_by_10_ms(self):
        """[SIM-4]"""
        count = len(self.clock.items)
        self.assertTrue(wait_for(lambda: len(self.clock.items) > count + 100))
        stamps = [message.clock.to_nsec() for _, message in list(self.clock.items)]
        # rospy shares its own queue of one with us, so that a message can be missing, or come twice where it joined while
        # one was sent, but none can be out of order.
        steps = [b - a for a, b in zip(stamps, stamps[1:])]
        self.assertGreaterEqual(min(steps), 0)
        self.assertEqual({step % 10000000 for step in steps}, {0})

    def test_speed_scales_time(self):
        """[SIM-4]"""
        count = len(self.clock.items)
        self.assertTrue(wait_for(lambda: len(self.clock.items) > count + 400))
        (t0, c0), (t1, c1) = self.clock.items[count], self.clock.items[count + 400]
        self.assertGreater((c1.clock - c0.clock).to_sec() / (t1 - t0), 1.0, 'twice as fast as real time was wanted')

    def test_pause_holds_everything(self):
        """[SIM-4]"""
        self.assertTrue(call('simulator/pause', SetBool, True).success)
        self.assertIn('unchanged', call('simulator/pause', SetBool, True).message)
        # A service that answers after it shows that the node lives; the clock must have stood meanwhile.
        held = self.clock.last.clock
        for _ in range(20):
            call('simulator/pause', SetBool, True)
        self.assertLessEqual((self.clock.last.clock - held).to_sec(), 0.05)
        held = self.clock.last.clock
        call('simulator/pause', SetBool, False)
        self.assertTrue(wait_for(lambda: self.clock.last.clock > held))

    def test_robots_see_each_other(self):
        """[SIM-2]"""
        scan = self.scan.last
        self.assertEqual(scan.header.frame_id, 'left/base_scan')
        self.assertEqual(len(scan.ranges), 360)
        self.assertAlmostEqual(scan.ranges[0], 1.0 - RADIUS, places=4)

    def test_sees_an_obstacle_until_it_is_removed(self):
        """[SIM-2]"""
        answer = call('simulator/spawn_obstacle', SpawnObstacle, 'box', Pose2D(1.2, 0.8, 0.0), 0.1)
        self.assertTrue(answer.success, answer.message)
        self.assertFalse(call('simulator/spawn_obstacle', SpawnObstacle, 'box', Pose2D(1.2, 0.8, 0.0), 0.1).success)
        self.assertTrue(wait_for(lambda: abs(self.scan.last.ranges[0] - 0.4) < 1e-4), self.scan.last.ranges[0])
        self.assertTrue(call('simulator/remove_obstacle', RemoveObstacle, 'box').success)
        self.assertTrue(wait_for(lambda: abs(self.scan.last.ranges[0] - 1.0 + RADIUS) < 1e-4))
        self.assertFalse(call('simulator/remove_obstacle', RemoveObstacle, 'box').success)

    def test_drives_on_commands_and_is_stopped_by_contact(self):
        """[SIM-1] [SIM-3]"""
        self.drive.start(0.2, 0.0)
        self.assertTrue(wait_for(lambda: self.stalled.last.data, 15.0), self.at().x)
        self.assertTrue(wait_for(lambda: abs(self.at().x - (1.7 - 2 * RADIUS)) < 1e-4), self.at().x)
        self.assertAlmostEqual(self.other.last.pose.pose.position.x, 1.7, places=6)
        self.drive.start(-0.2, 0.0)
        self.assertTrue(wait_for(lambda: not self.stalled.last.data))

    def test_stops_when_commands_cease(self):
        """[SIM-1]"""
        self.drive.start(0.1, 0.0)
        self.assertTrue(wait_for(lambda: self.odom.last.twist.twist.linear.x > 0.09))
        self.drive.stop()
        self.assertTrue(wait_for(lambda: self.odom.last.twist.twist.linear.x == 0.0))

    def test_a_command_that_is_not_finite_is_refused_and_counted(self):
        diagnostics = Record('/diagnostics', DiagnosticArray)
        self.drive.send(math.nan, 0.0)

        def refused():
            return any('cmd_vel' in pair.key and 'left' in pair.key and pair.value not in ('', '0')
                       for _, array in list(diagnostics.items) for status in array.status for pair in status.values)
        self.assertTrue(wait_for(refused, 15.0), diagnostics.last)
        self.assertEqual(self.odom.last.twist.twist.linear.x, 0.0)

    def test_odometry_starts_at_zero_and_the_frames_connect(self):
        self.assertEqual(self.odom.last.header.frame_id, 'left/odom')
        self.assertEqual(self.odom.last.child_frame_id, 'left/base_footprint')
        self.assertAlmostEqual(self.odom.last.pose.pose.position.x, 0.0)
        self.assertEqual(self.truth.last.header.frame_id, 'world')
        self.assertAlmostEqual(self.at().x, 0.7)
        for target, source in (('left/odom', 'left/base_scan'), ('world', 'left/map'), ('world', 'right/map')):
            self.assertTrue(wait_for(lambda: self.tf.can_transform(target, source, rospy.Time(0))), (target, source))
        self.assertAlmostEqual(self.tf.lookup_transform('world', 'right/map', rospy.Time(0)).transform.translation.x, 1.7)

    def test_set_pose_and_its_refusals(self):
        answer = call('simulator/set_pose', SetPose, 'left', Pose2D(1.0, 1.0, 1.0))
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(wait_for(lambda: abs(self.at().x - 1.0) < 1e-6))
        for robot, pose, why in (('left', Pose2D(0.0, 0.0, 0.0), 'wall'), ('left', Pose2D(1.7, 0.8, 0.0), 'robot'),
                                 ('nobody', Pose2D(1.0, 1.0, 0.0), 'no robot'),
                                 ('left', Pose2D(math.nan, 1.0, 0.0), 'finite')):
            answer = call('simulator/set_pose', SetPose, robot, pose)
            self.assertFalse(answer.success)
            self.assertIn(why, answer.message)

    def test_the_true_map_is_latched(self):
        record = Record('simulator/world', OccupancyGrid)
        self.assertTrue(wait_for(lambda: record.last is not None))
        self.assertEqual(record.last.header.frame_id, 'world')
        self.assertEqual(len(record.last.data), record.last.info.width * record.last.info.height)


class RefusesToStart(unittest.TestCase):
    """[SIM-1] with a message that names what is wrong, and an exit code other than 0."""

    def refuses(self, why, *parameters):
        code, said = Node('simulator', '__name:=refused_' + self._testMethodName, '/clock:=/other_clock', *parameters).finish(30.0)
        self.assertNotIn(code, (0, None))
        self.assertIn(why, said)

    def test_without_a_world(self):
        self.refuses('world: missing')

    def test_with_a_world_that_does_not_exist(self):
        self.refuses('nowhere.yaml: cannot be read', '_world:=/nowhere.yaml')

    def test_in_a_wall(self):
        self.refuses('the nearest free place is', '_world:=' + world(), '_x:=0.0', '_y:=0.0')

    def test_with_an_unknown_parameter(self):
        self.refuses('colour', '_world:=' + world(), '_colour:=red')

    def test_with_a_parameter_out_of_range(self):
        self.refuses('speed', '_world:=' + world(), '_speed:=-1.0')


class EndsWhileItReadsItsWorld(unittest.TestCase):
    """[FLT-2] A world of a quarter of a kilometre takes seconds to read, and whoever ends the node need not wait."""
    SIDE = 5000  # [cells]

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.world = os.path.join(folder.name, 'large.yaml')
        with open(os.path.join(folder.name, 'large.pgm'), 'wb') as file:
            file.write(b'P5 %d %d 255\n' % (self.SIDE, self.SIDE) + b'\xfe' * self.SIDE**2)
        with open(self.world, 'w') as file:
            file.write('{image: large.pgm, resolution: 0.05, origin: [0, 0, 0], occupied_thresh: 0.65, '
                       'free_thresh: 0.196, start: [20, 20, 0]}')

    def reading(self):
        """A simulator that holds the picture already."""
        node = Node('simulator', '__name:=large', '/clock:=/other_clock', '_world:=' + self.world)
        self.addCleanup(node.end)
        self.assertTrue(wait_for(lambda: memory_of(node.process.pid)[0] > 100.0, 20.0))
        return node

    def test_within_a_second_of_one_signal(self):
        node, start = self.reading(), time.monotonic()
        node.signal(signal.SIGTERM)
        node.finish(20.0)
        self.assertLess(time.monotonic() - start, 4.0 if SANITIZED else 1.8)

    def test_at_once_on_the_second_signal(self):
        node = self.reading()
        node.signal(signal.SIGINT)
        node.signal(signal.SIGTERM)
        self.assertIn(node.finish(20.0)[0], (128 + signal.SIGINT, 128 + signal.SIGTERM))


class All(unittest.TestSuite):
    def __init__(self):
        load = unittest.TestLoader().loadTestsFromTestCase
        super().__init__([load(SimulatorOnTheWire), load(RefusesToStart), load(EndsWhileItReadsItsWorld)])


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'simulator_wire', 'simulator_wire.All')
