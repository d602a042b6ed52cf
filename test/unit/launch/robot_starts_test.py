#!/usr/bin/env python3
"""Where several robots start."""
import itertools
import math
import os
import pathlib
import random
import sys
import tempfile
import unittest
from unittest import mock

import numpy
import yaml
from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'scripts'))
import robot_starts  # noqa: E402
from robot_starts import StartsError, draw_starts, read_world  # noqa: E402

META = {'image': 'room.png', 'resolution': 0.05, 'origin': [0, 0, 0], 'negate': 0, 'occupied_thresh': 0.65, 'free_thresh': 0.196}


class StartsCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def world(self, picture, **meta):
        picture.save(os.path.join(self.folder, 'room.png'))
        path = os.path.join(self.folder, 'room.yaml')
        with open(path, 'w') as file:
            yaml.safe_dump(dict(META, **meta), file)
        return read_world(path)


class ShippedWorlds(unittest.TestCase):
    def last(self, name, count, seed):
        """The start of the last robot, which depends on those of all before it."""
        start = draw_starts(read_world(str(ROOT / 'config/worlds' / (name + '.yaml'))), count, seed)[-1]
        return start['x'], start['y'], start['yaw']

    def test_the_starts_for_a_seed_do_not_change(self):
        for name, of_twenty, of_twelve in (('cave', (6.575, 13.275), (5.025, 13.275)), ('flat', (4.325, 4.025), (2.775, 3.725)),
                                           ('loop', (7.825, 1.525), (2.275, 6.275)), ('office', (0.825, 11.725), (2.325, 10.175)),
                                           ('small', (3.425, 0.825), (3.075, 3.125))):
            with self.subTest(world=name):
                self.assertEqual(self.last(name, 20, 1), (*of_twenty, -2.949))
                self.assertEqual(self.last(name, 12, 7), (*of_twelve, -2.572))
        self.assertEqual(self.last('maze', 1, 123), (1.175, 5.225, 0.0))


class Room(StartsCase):
    def test_a_place_with_room_has_a_disc_of_free_cells_around_it(self):
        draw = random.Random(1)
        for reach in range(4):
            free = numpy.array([[draw.random() < 0.9 for _ in range(30)] for _ in range(20)])
            room = robot_starts.places_with_room(free, reach)
            disc = [step for step in itertools.product(range(-reach, reach + 1), repeat=2) if math.hypot(*step) <= reach]
            for y, x in itertools.product(range(20), range(30)):
                expected = all(0 <= y + dy < 20 and 0 <= x + dx < 30 and free[y + dy, x + dx] for dx, dy in disc)
                self.assertEqual(room[y, x], expected, (reach, x, y))

    def test_a_cell_of_several_pixels_is_free_only_if_all_of_them_are(self):
        free = numpy.ones((5, 6), bool)
        free[0, 3] = False
        self.assertEqual(robot_starts.put_together(free, 2).tolist(), [[True, False, True], [True, True, True], [False] * 3])

    def test_starts_between_fine_pixels_are_as_far_from_the_walls_as_any(self):
        picture = Image.new('L', (3000, 2000), 0)
        picture.paste(255, (500, 400, 3000, 2000))
        starts = draw_starts(self.world(picture, resolution=0.001), 3, 1)
        for start in starts:
            self.assertTrue(0.85 <= start['x'] <= 2.65 and 0.35 <= start['y'] <= 1.25, start)

    def test_the_largest_picture_at_the_finest_resolution_takes_seconds(self):
        """[FLT-1]"""
        room = self.world(Image.new('L', (8000, 8000), 255), resolution=0.001, start=[1, 1, 0]).room
        self.assertEqual(room.shape, (400, 400))


class Refusals(StartsCase):
    def test_what_the_simulator_refuses_is_refused_before_the_picture_is_read(self):
        """[FLT-1]"""
        for change in ({'resolution': 1e-6}, {'resolution': 0.0009}, {'resolution': 1.1}, {'resolution': math.nan}, {'resolution': 10 ** 400},
                       {'origin': [1e300, 0, 0]}, {'origin': [0, -1.1e5, 0]}, {'start': [1e308, 0, 0]}, {'start': [0, math.inf, 0]}):
            with self.subTest(**change), mock.patch('robot_starts.read_picture') as read:
                with self.assertRaises(StartsError):
                    self.world(Image.new('L', (40, 40), 255), **change)
                read.assert_not_called()


if __name__ == '__main__':
    unittest.main()
