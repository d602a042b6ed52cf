#!/usr/bin/env python3
"""Parameters that change while the nodes run, by dynamic_reconfigure's own client and tool."""
import math
import random
import subprocess
import threading
import time
import unittest

import rosgraph
import rospy
import rostest
from dynamic_reconfigure import DynamicReconfigureParameterException
from dynamic_reconfigure.client import Client
from dynamic_reconfigure.msg import Config, DoubleParameter, IntParameter, StrParameter
from dynamic_reconfigure.srv import Reconfigure
from frontier_pilot.msg import AvoiderStatus
from geometry_msgs.msg import Twist
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import LaserScan

from tap import Tap
from wire import Node, Record, Source, call, clear, emergency_stop, moves, wait_for

NODES = ('cmd_vel_arbiter', 'obstacle_avoider', 'patrol_server', 'behavior_server', 'navigator', 'frontier_explorer')


def dynparam(*arguments):
    return subprocess.run(['rosrun', 'dynamic_reconfigure', 'dynparam', *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, timeout=30.0)


class Obstacle:
    """Publishes scans at 20 Hz of a wall all around, so far away."""

    def __init__(self, distance):
        self.distance = distance
        self.publisher = rospy.Publisher('scan', LaserScan, queue_size=1)
        threading.Thread(target=self._run, daemon=True).start()

    def _run(self):
        pace = threading.Event()
        while not pace.wait(0.05):
            scan = LaserScan()
            scan.header.stamp = rospy.Time.now()
            scan.header.frame_id = 'base_scan'
            scan.angle_min, scan.angle_increment = -math.pi, math.pi / 180.0
            scan.angle_max = scan.angle_min + 359 * scan.angle_increment
            scan.range_min, scan.range_max = 0.1, 8.0
            scan.ranges = [self.distance + random.uniform(0.0, 0.005) for _ in range(360)]
            self.publisher.publish(scan)


class ReconfigureOnTheWire(unittest.TestCase):
    def start(self, executable, *arguments):
        node = Node(executable, *arguments)
        self.addCleanup(node.end)
        return node

    def says(self, node, *texts):
        return wait_for(lambda: all(text in node.said() for text in texts), 5.0)

    def test_every_node_that_can_be_tuned_is_found_with_its_bounds_and_gives_its_values(self):
        for name in NODES:
            self.start(name)
        found = lambda: set(dynparam('list').stdout.split())
        self.assertTrue(wait_for(lambda: {'/' + name for name in NODES} <= found(), 30.0), found())
        for name in NODES:
            client = Client(name, timeout=15.0)
            descriptions = {each['name']: each for each in client.get_parameter_descriptions()}
            values = client.get_configuration(timeout=15.0)
            self.assertGreater(len(descriptions), 1, name)
            for parameter, description in descriptions.items():
                self.assertEqual(description['default'], values[parameter], name)
                self.assertLessEqual(description['min'], values[parameter], (name, parameter))
                self.assertGreaterEqual(description['max'], values[parameter], (name, parameter))
            client.close()

    # [ARB-5] [ARB-7]
    def test_the_arbiter_obeys_a_new_limit_at_once_and_a_stop_holds_whatever_the_limits(self):
        self.start('cmd_vel_arbiter', '_limits/max_linear:=0.3')
        log = Record('/rosout', Log)
        wheels = Record('cmd_vel', Twist)
        nav = Source('cmd_vel_nav').connect().start(0.3)
        self.addCleanup(nav.close)
        self.assertTrue(wait_for(lambda: wheels.last is not None and wheels.last.linear.x == 0.3))
        client = Client('cmd_vel_arbiter', timeout=15.0)
        self.assertEqual(client.update_configuration({'limits/max_linear': 0.1})['limits/max_linear'], 0.1)
        self.assertTrue(wait_for(lambda: wheels.last.linear.x == 0.1, 1.0), '[ARB-5]')
        obeyed = time.monotonic()
        time.sleep(0.3)
        self.assertTrue(all(m.linear.x <= 0.1 for m in wheels.since(obeyed)), '[ARB-5]')
        line = 'parameter limits/max_linear changed: 0.3 -> 0.1'
        self.assertTrue(wait_for(lambda: any(line in message.msg for _, message in list(log.items))))
        self.assertTrue(wait_for(lambda: rospy.get_param('/cmd_vel_arbiter/limits/max_linear') == 0.1))
        tap = Tap('/cmd_vel_arbiter', '/cmd_vel', Twist)
        self.addCleanup(tap.close)
        self.assertTrue(emergency_stop().success)
        tap.arrived()  # what had arrived by then
        for most in (0.3, 20.0, 0.05, 0.3):
            client.update_configuration({'limits/max_linear': most})
        self.assertFalse(any(map(moves, tap.next(11))), '[ARB-7]')
        nav.stop()
        self.assertTrue(clear())
        client.close()

    # [FLT-1]
    def test_what_is_bad_is_refused_in_the_log_and_the_values_in_force_are_the_answer(self):
        arbiter = self.start('cmd_vel_arbiter')
        client = Client('cmd_vel_arbiter', timeout=15.0)
        good = client.get_configuration(timeout=15.0)
        self.assertRaises(DynamicReconfigureParameterException, client.update_configuration, {'nonsense': 1.0})
        for bad in (-0.1, 0.0, 1e9, float('nan'), float('inf')):
            self.assertEqual(client.update_configuration({'limits/max_linear': bad, 'limits/max_angular': 1.0}), good)
        for config, words in ((Config(ints=[IntParameter('limits/max_linear', 1)]), 'must be of type double'),
                              (Config(strs=[StrParameter('limits/max_linear', '0.1')]), 'must be of type double'),
                              (Config(doubles=[DoubleParameter('nonsense', 1.0)]), 'nonsense: is no parameter'),
                              (Config(doubles=[DoubleParameter('robot/watchdog', 1.0)]), 'robot/watchdog: is no')):
            answer = call('cmd_vel_arbiter/set_parameters', Reconfigure, config).config
            self.assertEqual({each.name: each.value for each in answer.doubles}['limits/max_linear'], 0.22)
            self.assertTrue(self.says(arbiter, words), arbiter.said())
        self.assertFalse(rospy.has_param('/cmd_vel_arbiter/limits/max_angular'))
        client.close()

    # [AVO-3]
    def test_the_avoider_stops_at_the_new_distance(self):
        Obstacle(0.8)
        self.start('obstacle_avoider')
        status = Record('obstacle_avoider/status', AvoiderStatus)
        self.assertTrue(wait_for(lambda: status.last is not None and status.last.state == AvoiderStatus.CLEAR, 15.0))
        said = dynparam('set', 'obstacle_avoider', '{clear_distance: 1.2, stop_distance: 1.0}')
        self.assertEqual(said.returncode, 0, said.stdout)
        self.assertTrue(wait_for(lambda: status.last.state in (AvoiderStatus.REVERSE, AvoiderStatus.ROTATE)), '[AVO-3]')
        self.assertIn("'stop_distance': 1.0", dynparam('get', 'obstacle_avoider').stdout)
        dynparam('set', 'obstacle_avoider', 'stop_distance', '1.5')  # beyond clear_distance
        self.assertIn("'stop_distance': 1.0", dynparam('get', 'obstacle_avoider').stdout)

    # [FLT-2]
    def test_a_node_that_is_started_again_has_the_changed_values(self):
        first = self.start('cmd_vel_arbiter')
        client = Client('cmd_vel_arbiter', timeout=15.0)
        client.update_configuration({'limits/max_angular': 1.5})
        client.close()
        self.assertTrue(wait_for(lambda: rospy.get_param('/cmd_vel_arbiter/limits/max_angular', 0.0) == 1.5))
        first.end()
        self.start('cmd_vel_arbiter')
        client = Client('cmd_vel_arbiter', timeout=15.0)
        self.assertTrue(wait_for(lambda: client.get_configuration(timeout=15.0)['limits/max_angular'] == 1.5, 15.0))
        client.close()

    # [ARB-12]
    def test_a_service_that_the_master_has_forgotten_is_registered_again(self):
        self.start('cmd_vel_arbiter')
        master = rosgraph.Master('/cmd_vel_arbiter')  # which alone may take its service back
        name = '/cmd_vel_arbiter/set_parameters'
        offered = lambda: any(service == name for service, _ in master.getSystemState()[2])
        self.assertTrue(wait_for(offered, 15.0))
        master.unregisterService(name, master.lookupService(name))
        self.assertTrue(wait_for(lambda: not offered(), 2.0))
        self.assertTrue(wait_for(offered, 5.0), '[ARB-12]')

    def tearDown(self):
        for name in ('/cmd_vel_arbiter', '/obstacle_avoider'):
            if rospy.has_param(name):
                rospy.delete_param(name)


if __name__ == '__main__':
    rospy.init_node('reconfigure')
    rostest.rosrun('frontier_pilot', 'reconfigure', ReconfigureOnTheWire)
