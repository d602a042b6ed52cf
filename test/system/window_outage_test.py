#!/usr/bin/env python3
"""A window on a desk drives a robot by hand when the network between them fails. Somebody stops the robot and clears the stop before it is
back. The network is made for the test alone, which root is needed for."""
import os
import subprocess
import time
import unittest

import emulated_network
import roslib.packages
import rosgraph
import rospy
import rostest
from emulated_network import HERE, THERE
from geometry_msgs.msg import Twist
from std_srvs.srv import SetBool, Trigger

from system_watch import wait_until

DELAY = 0.05  # [s] each way
PORT = 11311  # in a network of its own
SILENCE = 4.0  # [s] after which the window knows that it does not hear the arbiter
ENOUGH = 10  # messages that the window sends in a second


def moves(message):
    return message.linear.x != 0.0 or message.angular.z != 0.0


class WindowOutage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not emulated_network.enter_a_namespace():
            raise unittest.SkipTest('only root may make a network')
        cls.desk = emulated_network.Computer()
        cls.addClassCleanup(cls.desk.end)
        cls.link = emulated_network.Link(cls.desk, DELAY)
        cls.addClassCleanup(cls.link.end)
        os.environ.pop('ROS_HOSTNAME', None)
        os.environ.update(ROS_MASTER_URI='http://%s:%d' % (HERE, PORT), ROS_IP=HERE)
        cls.addClassCleanup(cls.start(['rosmaster', '--core', '-p', str(PORT)]))
        if not wait_until(rosgraph.is_master_online, 60):
            raise AssertionError('no master')
        rospy.init_node('window_outage_test', disable_signals=True)
        cls.addClassCleanup(cls.start([cls.find('cmd_vel_arbiter')]))
        rospy.wait_for_service('emergency_stop', 60)
        cls.commands, cls.manual = [], []
        rospy.Subscriber('cmd_vel', Twist, cls.commands.append)
        rospy.Subscriber('cmd_vel_manual', Twist, cls.manual.append)

    @staticmethod
    def find(program):
        return roslib.packages.find_node('frontier_pilot', program)[0]

    @staticmethod
    def start(command):
        """Gives what ends it."""
        process = subprocess.Popen(['setpriv', '--pdeathsig', 'KILL', '--'] + command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)

        def end():
            process.kill()
            process.wait()
        return end

    def drive_from_the_desk(self, name):
        self.commands.clear()
        window = [self.find('gui_test'), '--window', '__name:=' + name]
        self.addCleanup(self.start(self.desk.enter + ['env', 'ROS_IP=' + THERE] + window))
        self.assertTrue(wait_until(self.drives_steadily, 60), 'it never drove')

    def drives_steadily(self):
        """With all its clicks on Go behind it."""
        last = [command.linear.x for command in self.commands[-ENOUGH:]]
        return len(last) == ENOUGH and min(last) == max(last) > 0.09

    def stop_and_clear(self):
        self.assertTrue(wait_until(lambda: not moves(self.commands[-1]), 10), 'it drives on without its operator')
        self.assertTrue(rospy.ServiceProxy('emergency_stop', Trigger)().success)
        clear = rospy.ServiceProxy('set_emergency_stop', SetBool)
        self.assertTrue(wait_until(lambda: clear(False).success, 10), 'the stop is not cleared')

    def assert_stands(self):
        """What was under way is delivered first."""
        heard = len(self.manual)
        zeros = wait_until(lambda: len(self.manual) >= heard + ENOUGH and not any(moves(word) for word in self.manual[-ENOUGH:]), 40)
        self.assertTrue(zeros, 'the window drives on')
        heard = len(self.commands)
        self.assertTrue(wait_until(lambda: len(self.commands) > heard + ENOUGH, 10))
        self.assertFalse([command for command in self.commands[heard:] if moves(command)])

    def test_a_set_point_of_before_a_long_outage_does_not_drive_a_robot_that_was_stopped_and_cleared(self):
        """[ARB-8] [GUI-1]"""
        self.drive_from_the_desk('window_before_a_long_outage')
        self.link.set_cut(True)
        time.sleep(SILENCE)
        self.stop_and_clear()
        self.link.set_cut(False)
        self.assert_stands()

    def test_a_set_point_of_before_a_short_outage_does_not_either(self):
        """[ARB-8] [GUI-1] The window hears the arbiter again before it knows that it did not: the count of stops tells it."""
        self.drive_from_the_desk('window_before_a_short_outage')
        self.link.set_cut(True)
        self.stop_and_clear()
        self.link.set_cut(False)
        self.assert_stands()


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'window_outage', WindowOutage)
