#!/usr/bin/env python3
"""What a soak finds: a node that grows, one that becomes slower, and neither where there is none."""
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from run_attack.outcome import Outcome  # noqa: E402


class Soak(unittest.TestCase):
    def setUp(self):
        try:
            from run_attack import soak
        except ImportError as error:
            self.skipTest('needs the messages of a build: %s' % error)
        self.soak = soak

    def failures(self, memory, cpu=lambda t: 0.1 * t, hours=8.0):
        """Of a node with this memory [MB] and this CPU time [s] after a time [s]."""
        record, draw = self.soak.Record(), random.Random(1)
        for step in range(800):
            t = 3600.0 * hours * step / 800.0
            record.memory.append((t, memory(t) + draw.uniform(-1.0, 1.0)))
            record.cpu.append((t, cpu(t)))
        outcome = Outcome('soak', lambda words: None)
        self.soak.judge({'mapper': record}, outcome)
        return outcome.failures

    # [FLT-1]
    def test_a_node_that_goes_on_growing_is_named(self):
        self.assertEqual(len(self.failures(lambda t: 50.0 + 5.0 * t / 3600.0)), 1)
        self.assertIn('mapper grows by 5', self.failures(lambda t: 50.0 + 5.0 * t / 3600.0)[0])

    # [FLT-1]
    def test_growth_within_the_first_half_hour_and_noise_are_not(self):
        self.assertEqual(self.failures(lambda t: 50.0 + 100.0 * min(t, 1700.0) / 1700.0), [])
        self.assertEqual(self.failures(lambda t: 50.0 + 20.0 * (t > 7200.0)), [], 'a single step is no growth')
        self.assertEqual(self.failures(lambda t: 50.0 + 4.0 * t / 3600.0, hours=1.0), [], 'too little to tell')

    # [FLT-1]
    def test_a_node_that_needs_more_and_more_time_is_named(self):
        words = self.failures(lambda t: 50.0, lambda t: 1e-5 * t * t)
        self.assertEqual(len(words), 1)
        self.assertIn('CPU time', words[0])

    def test_a_few_uneven_jobs_are_no_drift(self):
        self.assertEqual(self.failures(lambda t: 50.0, lambda t: 1e-3 * t * t, hours=0.1), [])

    def test_a_robot_that_does_nothing_is_no_success(self):
        life, outcome = self.soak.Life('/nowhere', None, None, random.Random(1)), Outcome('soak', lambda words: None)
        life.tried.update(patrol=10, save=10, turn=2)
        life.done.update(patrol=3, save=9)
        life.judge(outcome)
        self.assertEqual(outcome.failures, ['only 3 of 10 times it could patrol'])

    def test_the_slope_is_that_of_most_points(self):
        points = [(float(x), 2.0 * x + (1000.0 if x == 50 else 0.0)) for x in range(100)]
        self.assertAlmostEqual(self.soak.slope(points), 2.0)
        self.assertEqual(self.soak.slope([(1.0, 2.0)]), 0.0)


if __name__ == '__main__':
    unittest.main()
