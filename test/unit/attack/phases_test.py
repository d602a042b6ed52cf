#!/usr/bin/env python3
"""What the attack takes for an exploration that goes on."""
import pathlib
import sys
import types
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from run_attack import phases  # noqa: E402


class PhasesOfTheWork(unittest.TestCase):
    def setUp(self):
        self.watch = types.SimpleNamespace(done=lambda: True, speed=1.0, known=100, maps=7)
        self.phases = phases.Phases.__new__(phases.Phases)  # without what it has at a ROS master
        self.phases._watch = self.watch
        for name, value in (('time.monotonic', self.tell), ('time.sleep', self.sleep)):
            patch = mock.patch(name, value)
            patch.start()
            self.addCleanup(patch.stop)
        self.now = 0.0

    def tell(self):
        return self.now

    def sleep(self, seconds):
        self.now += seconds
        if self.now > 15.0:
            self.watch.known, self.watch.maps = self.left, 8

    def explores(self):
        with mock.patch.object(phases.services, 'explore'), mock.patch.object(phases.services, 'call'):
            return self.phases.explore()

    def test_an_exploration_that_began_anew_goes_on_once_a_map_with_less_in_it_is_seen_however_late(self):
        self.left = 20
        self.assertTrue(self.explores())

    def test_it_does_not_while_there_is_only_the_map_of_before(self):
        self.left = 100
        self.assertFalse(self.explores())


if __name__ == '__main__':
    unittest.main()
