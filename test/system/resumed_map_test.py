#!/usr/bin/python3
"""Going on from a loaded map of half a building: localised first, then only the other half is explored."""
import math
import os
import sys
import tempfile
import unittest

import numpy as np
import rospy
import rostest
import tf2_ros
import yaml
from PIL import Image
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from std_srvs.srv import SetBool
from visualization_msgs.msg import MarkerArray

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from explored_share import World, explored_share  # noqa: E402
from system_watch import SystemWatch, wait_until  # noqa: E402
from frontier_pilot.msg import ExplorerStatus  # noqa: E402
from frontier_pilot.srv import LoadMap  # noqa: E402

START = (1.2, 0.9, 1.0)  # of the robot in the world, as in the launch file [m, rad]
GUESS = (1.35, 0.8, 0.85)  # what the operator says
WALL = (2.9, 3.1)  # between the rooms: the left one is known [m]
WAY = 8.0  # to the other room and through it is about half of this [m]
UNKNOWN = 205  # in a picture of a map
IN_WORLD = (0.0, 0.0, 0.0)  # the frame of the loaded map is that of the world


class ResumedMap(unittest.TestCase):
    def setUp(self):
        self.watch = SystemWatch()
        self.goals = []
        self.frontiers = []
        self.known_at_start = None
        rospy.Subscriber('frontier_explorer/goal', PoseStamped, self.on_goal)
        rospy.Subscriber('frontier_explorer/status', ExplorerStatus, self.on_status)
        rospy.Subscriber('frontier_explorer/frontiers', MarkerArray, self.on_frontiers)
        self.tf = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.tf)
        self.initial_pose = rospy.Publisher('initialpose', PoseWithCovarianceStamped, queue_size=1)

    def on_goal(self, msg):
        self.goals.append((msg.pose.position.x, msg.pose.position.y))

    def on_status(self, msg):
        if self.known_at_start is None and msg.state == ExplorerStatus.NAVIGATING:
            self.known_at_start = msg.explored_area

    def on_frontiers(self, msg):
        found = [(m.pose.position.x, m.pose.position.y) for m in msg.markers if m.ns == 'centroids']
        if found:
            self.frontiers.append(found)

    def half_a_map(self, folder):
        """The world as a map in which nothing is known behind the wall."""
        path = rospy.get_param('simulator/world')
        with open(path) as file:
            meta = yaml.safe_load(file)
        cells = np.array(Image.open(os.path.join(os.path.dirname(path), meta['image'])).convert('L'))
        cells[:, int(round((WALL[1] - meta['origin'][0]) / meta['resolution'])):] = UNKNOWN
        Image.fromarray(cells).save(os.path.join(folder, 'half.pgm'))
        meta['image'] = 'half.pgm'
        with open(os.path.join(folder, 'half.yaml'), 'w') as file:
            yaml.safe_dump(meta, file)
        return os.path.join(folder, 'half.yaml'), 0.05 ** 2 * np.count_nonzero(cells > UNKNOWN)

    def say_where(self):
        msg = PoseWithCovarianceStamped()
        msg.header.frame_id = 'map'
        msg.pose.pose.position.x, msg.pose.pose.position.y = GUESS[:2]
        msg.pose.pose.orientation.z, msg.pose.pose.orientation.w = math.sin(GUESS[2] / 2.0), math.cos(GUESS[2] / 2.0)
        msg.pose.covariance[0] = msg.pose.covariance[7] = 0.1
        msg.pose.covariance[35] = 0.05
        self.initial_pose.publish(msg)

    def pose(self):
        try:
            found = self.tf.lookup_transform('map', 'base_footprint', rospy.Time(0)).transform
        except tf2_ros.TransformException:
            return (math.inf, math.inf, math.inf)
        return found.translation.x, found.translation.y, 2.0 * math.atan2(found.rotation.z, found.rotation.w)

    def is_found(self):
        return all(abs(a - b) < 0.06 for a, b in zip(self.pose(), START))

    def free_floor(self):
        """Of the map that was published last [m^2]."""
        cells = np.array(self.watch.map.data)
        return self.watch.map.info.resolution ** 2 * np.count_nonzero((cells >= 0) & (cells < 50))

    def test_only_what_the_loaded_map_does_not_show_is_explored(self):
        """[EXP-10] [MAP-5]"""
        rospy.wait_for_service('mapper/load_map', 60.0)
        self.assertTrue(wait_until(lambda: self.watch.map is not None and self.pose()[0] < math.inf, 60.0))
        with tempfile.TemporaryDirectory() as folder:
            path, known = self.half_a_map(folder)
            answer = rospy.ServiceProxy('mapper/load_map', LoadMap)(path)
            self.assertTrue(answer.success, answer.message)
        self.assertTrue(wait_until(lambda: self.initial_pose.get_num_connections() > 0, 10.0))
        self.say_where()
        self.assertTrue(wait_until(self.is_found, 60.0), self.pose())
        # The robot may be found before its loaded map is published, and an exploration that begins then knows the map of before.
        self.assertTrue(wait_until(lambda: self.free_floor() > 0.95 * known, 20.0), self.free_floor())
        self.assertTrue(rospy.ServiceProxy('set_exploration_enabled', SetBool)(True).success)
        self.assertTrue(wait_until(self.watch.done, 200.0), 'not done in time\n' + self.watch.describe())
        self.assertEqual(ExplorerStatus.NO_REACHABLE_FRONTIER, self.watch.status.reason, self.watch.describe())

        self.assertGreater(self.known_at_start, 0.95 * known, 'the floor of the loaded map counts as explored')
        elsewhere = [f for found in self.frontiers for f in found if f[0] < WALL[0] - 0.1]
        self.assertEqual([], elsewhere, 'frontiers where the loaded map has none')
        self.assertLess(self.watch.distance, WAY, 'it goes to the other room and not through its own first')
        world = World(rospy.get_param('simulator/world'))
        floor = world.reachable_floor(START, radius=0.15)
        # The whole map follows its updates by some seconds.
        wait_until(lambda: explored_share(floor, IN_WORLD, self.watch.map) >= 0.99, 15.0)
        share = explored_share(floor, IN_WORLD, self.watch.map)
        print('explored %.2f %% after driving %.1f m to %d goals' % (100 * share, self.watch.distance, len(self.goals)))
        self.assertGreaterEqual(share, 0.99)
        self.assertEqual(0, self.watch.contacts)


if __name__ == '__main__':
    rospy.init_node('resumed_map_test')
    rostest.rosrun('frontier_pilot', 'resumed_map', ResumedMap)
