#!/usr/bin/python3
"""The whole system, from its launch file: it explores a world, touches nothing, ends by itself, and its map can be loaded."""
import os
import sys
import tempfile
import unittest

import numpy as np
import rospy
import rostest
import yaml
from PIL import Image

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from explored_share import World, explored_share  # noqa: E402
from system_watch import SystemWatch, wait_until  # noqa: E402
from frontier_pilot.msg import ExplorerStatus  # noqa: E402
from frontier_pilot.srv import SaveMap  # noqa: E402

LIMIT = 400.0  # seconds of wall time


class Exploration(unittest.TestCase):
    def test_it_explores_everything_and_ends_by_itself(self):  # [EXP-7] [NAV-4]
        watch = SystemWatch()
        world = World(rospy.get_param('simulator/world'))
        self.assertTrue(wait_until(watch.done, LIMIT), 'not done in time\n' + watch.describe())
        self.assertEqual(ExplorerStatus.NO_REACHABLE_FRONTIER, watch.status.reason, watch.describe())
        share = explored_share(world.reachable_floor(world.start, radius=0.15), world.start, watch.map)
        print('explored %.2f %% after driving %.1f m to %d goals' % (
            100 * share, watch.distance, watch.status.goals_sent))
        self.assertGreaterEqual(share, 0.99)
        self.assertEqual(0, watch.contacts)
        self.check_saved_map(watch.map)

    def check_saved_map(self, grid):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'map')
            answer = rospy.ServiceProxy('mapper/save_map', SaveMap)(path)
            self.assertTrue(answer.success, answer.message)
            with open(path + '.yaml') as file:
                meta = yaml.safe_load(file)
            image = np.flipud(np.asarray(Image.open(os.path.join(folder, meta['image']))))
            cells = np.asarray(grid.data, np.int8).reshape(grid.info.height, grid.info.width)
            self.assertEqual(cells.shape, image.shape)
            self.assertAlmostEqual(grid.info.resolution, meta['resolution'], places=6)
            free = np.mean((image > 250) == ((cells >= 0) & (cells < 50)))
            self.assertGreater(free, 0.99, 'the picture shows another map')
            with open(path + '.bt', 'rb') as file:
                self.assertTrue(file.read(40).startswith(b'# Octomap OcTree binary'))


if __name__ == '__main__':
    rospy.init_node('exploration_test')
    rostest.rosrun('frontier_pilot', 'exploration', Exploration)
