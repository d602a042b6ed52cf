#!/usr/bin/env python3
"""check_robot names the mistakes of a simulated robot that has other names than ours, and moves nothing. [ROB-3]"""
import math
import os
import subprocess
import sys
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from rosgraph_msgs.msg import Clock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from named_robot import NamedRobot, SecondNode  # noqa: E402
from wire import find_node, wait_for  # noqa: E402

AT_ONCE = 4
PATIENCE = 30.0  # [s] for all programs of a batch on a busy machine
NAN = float('nan')


def no_beams(scan):
    scan.ranges = [NAN] * len(scan.ranges)


def no_rotation(transform):
    transform.transform.rotation.x = transform.transform.rotation.y = 0.0
    transform.transform.rotation.z = transform.transform.rotation.w = 0.0


def in_millimetres(transform):
    transform.transform.translation.x = 172.0


def only_the_rear(scan):  # the scanner of the robot is turned by 172 degrees
    scan.angle_min, scan.angle_max = -math.pi / 2, math.pi / 2
    scan.ranges = [2.0] * (1 + round(math.pi / scan.angle_increment))


def no_place(message):
    message.transforms[0].transform.translation.x = NAN


def no_increment(scan):
    scan.angle_increment = 0.0


def nowhere(odometry):
    odometry.pose.pose.position.x = NAN


# What is wrong with the robot, and the words by which it has to be named.
MISTAKES = {
    'no_scan': (dict(scan=None), ['nobody publishes /no_scan/base_scan']),
    'scan_elsewhere': (dict(scan='front/scan'), ['nobody publishes /scan_elsewhere/base_scan',
                                                 '/scan_elsewhere/front/scan is a sensor_msgs/LaserScan of /check_robot']),
    'silent_scanner': (dict(scan_rate=0.0), ['/silent_scanner/base_scan is published by', 'but nothing arrived']),
    'two_scanners': (dict(second='scan'), ['several scanners publish /two_scanners/base_scan: frames laser, rear_laser',
                                           'laserscan_multi_merger']),
    'no_frame': (dict(scan_frame=''), ['header.frame_id is empty']),
    'unknown_frame': (dict(scan_frame='lidar'), ['the frame lidar of', 'is not connected to base_link in TF',
                                                 'static_transform_publisher']),
    'tilted': (dict(roll=math.pi / 2), ['tilted by 90 deg']),
    'unset_mount': (dict(spoil_mount=no_rotation), ['PROBLEM the transform base_link -> laser of /check_robot', 'cannot be used',
                                                    'its quaternion not of unit length']),
    'distant_mount': (dict(spoil_mount=in_millimetres), ['PROBLEM by TF the scanner is 172.', 'in metres?']),
    'looks_back': (dict(spoil_scan=only_the_rear), ['PROBLEM /looks_back/base_scan does not show what is ahead']),
    'transform_nowhere': (dict(spoil_transforms=no_place), ['PROBLEM the transform odom -> base_link of /check_robot',
                                                            'cannot be used: not finite']),
    'slow_scanner': (dict(scan_rate=1.2), ['/slow_scanner/base_scan comes at 1.', 'at least 2.00 Hz']),
    'late_scans': (dict(scan_lag=0.6), ['the stamps of /late_scans/base_scan are 0.', 's behind this computer', 'chrony']),
    'early_scans': (dict(scan_lag=-0.4), ['the stamps of /early_scans/base_scan are 0.', 's ahead of this computer', 'chrony']),
    'no_increment': (dict(spoil_scan=no_increment), ['cannot be used: angle increment zero']),
    'blind': (dict(spoil_scan=no_beams), ['only 0.00 % of the beams of /blind/base_scan']),
    'odom_elsewhere': (dict(odom='odometry/filtered'), ['nobody publishes /odom_elsewhere/wheels/odom',
                                                        '/odom_elsewhere/odometry/filtered is a nav_msgs/Odometry']),
    'odom_nowhere': (dict(spoil_odometry=nowhere), ['/odom_nowhere/wheels/odom cannot be used']),
    'odom_frame': (dict(odom_frame_id='wheels'), ["is in the frame 'wheels', not in odom", 'set odom_frame:=wheels']),
    'odom_late': (dict(odom_lag=0.5), ['the stamps of /odom_late/wheels/odom are 0.5', 'behind this computer']),
    'odom_frozen': (dict(odom_lag=None), ['all messages of /odom_frozen/wheels/odom have the same stamp']),
    'base_frame': (dict(told_base='base_footprint'), ['no frame base_footprint; base_link exists: set base_frame:=base_link']),
    'no_transform': (dict(base_in=None), ['no frame odom']),
    'two_broadcasters': (dict(second='tf'), ['several nodes publish the transform odom -> base_link', '/second_node']),
    'two_parents': (dict(also_in='odom_combined'), ['frame base_link has several parents']),
    'other_mapper': (dict(map_in='map'), ['/check_robot publishes the transform map -> odom', 'end that mapper']),
    'other_driver': (dict(drives=True), ['/check_robot publishes /other_driver/drive past the arbiter']),
    'nobody_listens': (dict(listens=None), ['no base listens to /nobody_listens/drive']),
    'listens_elsewhere': (dict(listens='commands/velocity'), ['no base listens to /listens_elsewhere/drive; /check_robot listens '
                                                              'to /listens_elsewhere/commands/velocity']),
}


def start(robot, *arguments, duration=2.5):
    return subprocess.Popen([find_node('frontier_pilot', 'check_robot'), *robot.names(), '_duration:=%s' % duration, *arguments],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)


class CheckRobot(unittest.TestCase):
    def check(self, name, wrong, *arguments):
        """Exit code and text for one robot alone."""
        robot = NamedRobot(name, **wrong)
        try:
            program = start(robot, *arguments)
            said = program.communicate(timeout=PATIENCE)[0]
            return program.returncode, said
        finally:
            robot.end()

    def test_a_robot_without_mistakes_could_drive_and_is_not_moved(self):
        commands = []
        listener = rospy.Subscriber('healthy/drive', Twist, commands.append)
        self.addCleanup(listener.unregister)
        begin = time.monotonic()
        code, said = self.check('healthy', {})
        self.assertLess(time.monotonic() - begin, 10.0)
        self.assertEqual(code, 0, said)
        self.assertIn('The robot could drive.', said)
        self.assertRegex(said, r'/healthy/base_scan: [0-9.]+ Hz, 90 beams')
        self.assertIn('turned by 172 deg, upside down', said)
        self.assertEqual(commands, [])

    def test_b_each_mistake_is_named(self):
        second = SecondNode([name for name, (wrong, _) in MISTAKES.items() if 'second' in wrong])
        self.addCleanup(second.end)
        names, missed = list(MISTAKES), []
        for first in range(0, len(names), AT_ONCE):
            batch = names[first:first + AT_ONCE]
            robots = [NamedRobot(name, **MISTAKES[name][0]) for name in batch]
            programs = [start(robot) for robot in robots]
            for name, program in zip(batch, programs):
                said = program.communicate(timeout=PATIENCE)[0]
                unsaid = [words for words in MISTAKES[name][1] if words not in said]
                if program.returncode != 1 or unsaid:
                    missed.append('%s, exit code %d: %s is not in\n%s' % (name, program.returncode, unsaid, said))
            for robot in robots:
                robot.end()
        self.assertFalse(missed, '\n'.join(missed))

    def test_b_two_arbiters_are_named(self):  # alone, because the node of an arbiter is nobody's base
        second = SecondNode(['two_arbiters'])
        self.addCleanup(second.end)
        self.assertTrue(wait_for(lambda: rospy.get_published_topics('/two_arbiters'), PATIENCE))
        code, said = self.check('two_arbiters', dict(arbiter=True))
        self.assertEqual(code, 1, said)
        self.assertRegex(said, 'there are several arbiters: .*/second_node')

    def test_c_odometry_as_a_transform_alone_is_named_and_taken(self):
        code, said = self.check('alone', dict(odom=None))
        self.assertEqual(code, 1, said)
        self.assertIn('set odom:=tf', said)
        code, said = self.check('alone', dict(odom=None), '_robot/odometry:=tf')
        self.assertEqual(code, 0, said)

    def test_d_simulated_time_without_a_clock_and_a_clock_without_simulated_time(self):
        clock = rospy.Publisher('/clock', Clock, queue_size=1)
        code, said = self.check('clocked', {})
        clock.unregister()
        self.assertEqual(code, 1, said)
        self.assertIn('publishes /clock, but use_sim_time is not true', said)
        rospy.set_param('/use_sim_time', True)
        try:
            code, said = self.check('timeless', {})
        finally:
            rospy.set_param('/use_sim_time', False)
        self.assertEqual(code, 1, said)
        self.assertIn('use_sim_time is true, but nobody publishes /clock', said)

    def test_d_an_answer_that_cannot_be_written_is_an_error(self):
        with open('/dev/full', 'w') as full:
            result = subprocess.run([find_node('frontier_pilot', 'check_robot'), '_duration:=1', '__name:=unheard'], stdout=full,
                                    stderr=subprocess.PIPE, universal_newlines=True, timeout=PATIENCE)
        self.assertEqual((result.returncode, 'cannot be written' in result.stderr), (1, True), result.stderr)

    def run_alone(self, *words, **environment):
        begin = time.monotonic()
        result = subprocess.run([find_node('frontier_pilot', 'check_robot'), *words], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, universal_newlines=True, timeout=PATIENCE,
                                env=dict(os.environ, **environment))
        self.assertLess(time.monotonic() - begin, 10.0)
        return result.returncode, result.stdout

    def test_e_help_and_a_missing_master_need_no_robot(self):
        nowhere = {'ROS_MASTER_URI': 'http://127.0.0.1:9'}
        code, said = self.run_alone('--help', **nowhere)
        self.assertEqual((code, 'usage' in said), (0, True), said)
        for words in ([], ['_duration:=1']):  # roscpp waits for a master that is to be told a parameter
            code, said = self.run_alone(*words, **nowhere)
            self.assertEqual((code, 'no ROS master answers at http://127.0.0.1:9' in said), (3, True), said)
        code, said = self.run_alone('--hlep')
        self.assertEqual((code, '--hlep' in said), (2, True), said)
        code, said = self.run_alone('_no_such_parameter:=1', '__name:=misled')
        rospy.delete_param('/misled')
        self.assertEqual((code, 'no_such_parameter' in said), (2, True), said)


if __name__ == '__main__':
    rospy.init_node('check_robot_test')
    wait_for(lambda: rospy.get_time() > 0.0)
    rostest.rosrun('frontier_pilot', 'check_robot', CheckRobot)
