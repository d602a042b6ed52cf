#!/usr/bin/env python3
"""The view of rviz on the simulated world."""
import math
import pathlib
import sys
import unittest

from nav_msgs.msg import OccupancyGrid, Odometry

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
import fitted_rviz  # noqa: E402
from robots_rviz import PICTURE, view_of  # noqa: E402


def odometry(x, y, yaw):
    message = Odometry()
    message.pose.pose.position.x, message.pose.pose.position.y = x, y
    message.pose.pose.orientation.z, message.pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return message


class FittedRviz(unittest.TestCase):
    def test_the_map_begins_where_the_robot_began_although_it_has_driven_since(self):
        start, driven = (3.0, 2.0, math.pi / 2), (1.0, 0.5, 0.3)  # one metre ahead is one metre along y of the world
        truth = fitted_rviz.pose_of(odometry(start[0] - driven[1], start[1] + driven[0], start[2] + driven[2]))
        beginning = fitted_rviz.beginning_of(truth, fitted_rviz.pose_of(odometry(*driven)))
        for key, value in zip(('x', 'y', 'yaw'), start):
            self.assertAlmostEqual(beginning[key], value)

    def test_the_middle_of_the_world_is_in_the_middle_of_a_view_that_holds_all_of_it(self):
        grid = OccupancyGrid()
        grid.info.width, grid.info.height, grid.info.resolution = 600, 200, 0.05
        grid.info.origin.position.x, grid.info.origin.position.y = -2.0, 1.0
        view = view_of(fitted_rviz.world_of(grid), {'x': 1.0, 'y': 1.0, 'yaw': 0.0})
        self.assertAlmostEqual(view['X'], -2.0 + 15.0 - 1.0)
        self.assertAlmostEqual(view['Y'], 1.0 + 5.0 - 1.0)
        self.assertLess(30.0 * view['Scale'], PICTURE[0])
        self.assertLess(10.0 * view['Scale'], PICTURE[1])


if __name__ == '__main__':
    unittest.main()
