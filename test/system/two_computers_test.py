#!/usr/bin/env python3
"""Two robots in the office on one computer, and what they have in common on another, behind a network that delays, loses and fails. The network
is made for the test alone, which root is needed for."""
import os
import signal
import subprocess
import time
import unittest

import emulated_network
import rospy
import rostest
from emulated_network import HERE, THERE
from frontier_pilot.msg import ExplorerStatus, MapChanges
from nav_msgs.msg import OccupancyGrid, Odometry
from std_msgs.msg import Bool
from std_srvs.srv import Trigger

from system_watch import wait_until

ROBOTS = ('robot1', 'robot2')
DELAY, LOSS = 0.1, 0.01  # [s] each way, share of the packets
OUTAGE = 15.0  # [s]
PORT = 11311  # in a network of its own


class TwoComputers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not emulated_network.enter_a_namespace():
            raise unittest.SkipTest('only root may make a network')
        cls.desk = emulated_network.Computer()
        cls.addClassCleanup(cls.desk.end)
        cls.link = emulated_network.Link(cls.desk, DELAY, LOSS)
        cls.addClassCleanup(cls.link.end)
        cls.processes = []
        cls.addClassCleanup(cls.end)  # also if what follows fails, and before the network goes
        os.environ.pop('ROS_HOSTNAME', None)
        os.environ.update(ROS_MASTER_URI='http://%s:%d' % (HERE, PORT), ROS_IP=HERE)
        cls.start(['roslaunch', 'frontier_pilot', 'robots_world.launch', 'fleet:=false', 'robot:=fast'])
        # A node that begins before this parameter is set takes the computer's time for ROS time.
        if not wait_until(cls.simulated_time_is_set, 60):
            raise AssertionError('no master')
        rospy.init_node('two_computers_test', disable_signals=True)
        cls.start(cls.desk.enter + ['env', 'ROS_IP=' + THERE, 'roslaunch', 'frontier_pilot', 'fleet.launch'])
        for name in ROBOTS:
            cls.start(['roslaunch', 'frontier_pilot', 'robot.launch', 'name:=' + name, 'robot:=fast', 'trust_odometry:=true',
                       'explore:=true'])
        cls.places_of, cls.states, cls.maps, cls.contacts = {}, {}, [], []
        cls.changed = None  # when the common map last changed
        for name in ROBOTS:
            rospy.Subscriber('/%s/base_pose_ground_truth' % name, Odometry, cls.note_place, name)
            rospy.Subscriber('/%s/frontier_explorer/status' % name, ExplorerStatus, cls.note_state, name)
            rospy.Subscriber('/%s/simulator/stalled' % name, Bool, cls.note_contact, name)
        rospy.Subscriber('/map', OccupancyGrid, lambda message: cls.maps.append(message), buff_size=1 << 22)
        rospy.Subscriber('/map_changes', MapChanges, cls.note_change, buff_size=1 << 22)

    @classmethod
    def end(cls):
        for process in reversed(cls.processes):
            process.send_signal(signal.SIGINT)
        for process in reversed(cls.processes):
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()

    @classmethod
    def start(cls, command):
        command = ['setpriv', '--pdeathsig', 'INT', '--'] + command
        cls.processes.append(subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, start_new_session=True))

    @staticmethod
    def simulated_time_is_set():
        try:
            return rospy.get_param('/use_sim_time', False)
        except (OSError, rospy.ROSException):
            return False

    @classmethod
    def note_place(cls, message, name):
        cls.places_of[name] = (message.pose.pose.position.x, message.pose.pose.position.y)

    @classmethod
    def note_state(cls, message, name):
        cls.states[name] = message

    @classmethod
    def note_change(cls, message):
        cls.changed = message.header.stamp

    @classmethod
    def note_contact(cls, message, name):
        if message.data:
            cls.contacts.append(name)

    def drives(self, name, patience=60.0):
        """Whether the robot gets ahead, or has nothing left to explore."""
        if not wait_until(lambda: name in self.places_of, patience):
            return False
        before = self.places_of[name]

        def has_moved():
            here = self.places_of[name]
            done = name in self.states and self.states[name].state == ExplorerStatus.DONE
            return done or max(abs(a - b) for a, b in zip(here, before)) > 0.3
        return wait_until(has_moved, patience)

    def heard_since(self, back):
        """What came when, in seconds of ROS time, if something does not come back."""
        return 'the network is back since %.1f, it is %.1f, the last whole map is of %.1f, the last change of %.1f, and the explorers: %s' % (
            back.to_sec(), rospy.Time.now().to_sec(), self.maps[-1].header.stamp.to_sec(), self.changed.to_sec(),
            {name: (status.state_text, status.header.stamp.to_sec()) for name, status in self.states.items()})

    def stop_all(self):
        rospy.wait_for_service('/fleet/emergency_stop', 60)
        return rospy.ServiceProxy('/fleet/emergency_stop', Trigger)()

    def test_they_explore_on_one_map_also_after_the_network_was_gone_and_are_stopped_by_one_call(self):
        """[MUL-1] [MUL-2] [MUL-4] [FLT-2]"""
        self.assertTrue(wait_until(lambda: self.maps and self.changed, 90), 'no common map')
        for name in ROBOTS:
            self.assertTrue(self.drives(name, 90), name)
        self.link.set_cut(True)
        time.sleep(OUTAGE)
        self.link.set_cut(False)
        back = rospy.Time.now()
        self.assertTrue(wait_until(lambda: self.changed > back, 90), 'no change of the common map: ' + self.heard_since(back))
        # A whole map is due a minute after the last one at the latest, and takes its time on this link.
        self.assertTrue(wait_until(lambda: self.maps[-1].header.stamp > back, 90), 'no common map: ' + self.heard_since(back))
        for name in ROBOTS:
            self.assertTrue(self.drives(name, 90), name)
        answer = self.stop_all()
        self.assertTrue(answer.success, answer.message)
        self.assertIn('2 of 2 robots stopped', answer.message)
        time.sleep(1.5)  # for the robots to brake
        before = dict(self.places_of)
        time.sleep(1.0)
        self.assertEqual(before, self.places_of, '[MUL-4]')
        self.assertEqual([], self.contacts, '[MUL-3]')


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'two_computers', TwoComputers)
