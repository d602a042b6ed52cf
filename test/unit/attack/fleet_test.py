#!/usr/bin/env python3
"""What the attack on several robots and on recordings would find: robots, services and reports are stand-ins."""
import os
import pathlib
import random
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from run_attack.outcome import Outcome  # noqa: E402
try:
    from std_srvs.srv import TriggerResponse
    from run_attack import fleet, recordings
except ImportError as missing:
    raise unittest.SkipTest('needs the messages of a build: %s' % missing)


class StandInWatch:
    """A robot that stands, unless it is told to creep on."""

    def __init__(self):
        self.speed, self.creeps, self.finished = 0.0, False, False

    def moved_since(self, _):
        return self.creeps

    def has_nothing_to_do(self):
        return self.finished


class StandInRobot:
    def __init__(self, name):
        self.name, self.watch, self.caller = name, StandInWatch(), unittest.mock.Mock()

    def moves(self):
        return self.watch.speed > 0.05

    def stands(self):
        return self.watch.speed == 0.0


class StandInFleet:
    drives = staticmethod(fleet.Fleet.drives)

    def __init__(self, answer):
        self.robots = [StandInRobot('robot1'), StandInRobot('robot2')]
        self.answer = answer

    def stop(self):
        return self.answer


def events(answer=TriggerResponse(True, 'stopped')):
    return fleet.Events(StandInFleet(answer), random.Random(1))


@unittest.mock.patch('time.sleep', lambda _: None)
class Fleet(unittest.TestCase):
    def test_a_stop_of_all_has_to_be_confirmed_and_to_hold(self):
        self.assertEqual(events().stop_of_all(), [])
        self.assertIn('nothing', events(None).stop_of_all()[0])
        self.assertIn('not confirmed by robot1', events(TriggerResponse(False, 'not confirmed by robot1')).stop_of_all()[0])

    def test_a_robot_that_goes_on_or_creeps_after_a_stop_is_named(self):
        judged = events()
        judged.fleet.robots[0].watch.speed, judged.fleet.robots[1].watch.creeps = 0.1, True
        self.assertEqual(judged.stop_of_all(), ['robot1 does not stand after the stop', 'robot2 moved although it was stopped'])

    def test_a_stop_of_one_may_not_stop_another(self):
        judged = events()
        with unittest.mock.patch.object(fleet, 'TO_WORK', 0.0):
            self.assertIn('stopped another one', judged.stop_of_one()[0])
            for robot in judged.fleet.robots:
                robot.watch.finished = True  # and has therefore no reason to drive
            self.assertEqual(judged.stop_of_one(), [])

    def test_a_frozen_arbiter_may_not_count_as_stopped(self):
        with unittest.mock.patch.multiple(fleet, pid_of=lambda _: 1), unittest.mock.patch('os.kill'):
            self.assertIn('frozen', events().stop_past_a_frozen_arbiter()[0])
            judged = events(TriggerResponse(False, 'not confirmed by robot1, robot2'))
            self.assertEqual(judged.stop_past_a_frozen_arbiter(), [])

    def test_the_robots_are_of_three_kinds_and_start_apart(self):
        with tempfile.TemporaryDirectory() as folder:
            robots = fleet.yaml.safe_load(pathlib.Path(fleet.written_starts(folder, 3)).read_text())['robots']
        self.assertEqual([robot['robot'] for robot in robots], list(fleet.KINDS))
        self.assertEqual(len({(robot['x'], robot['y']) for robot in robots}), 3)


class Recordings(unittest.TestCase):
    def judged(self, script, bags=('1.bag',)):
        """What does not hold when `script` stands for the report."""
        with tempfile.TemporaryDirectory() as folder:
            run = pathlib.Path(folder, 'frontier_pilot/runs/a')
            run.mkdir(parents=True)
            for bag in bags:
                (run / bag).touch()
            report = pathlib.Path(folder, 'report')
            report.write_text('#!/bin/bash\n' + script)
            report.chmod(0o755)
            outcome = Outcome('x', lambda words: None)
            with unittest.mock.patch.dict(os.environ, ROS_HOME=folder), \
                    unittest.mock.patch.object(recordings, 'REPORT', str(report)):
                recordings.judge(folder, outcome)
            return outcome.failures

    def test_a_report_that_is_refused_or_empty_is_a_failure(self):
        self.assertEqual(self.judged('head -c 30000 /dev/zero >"$3"'), [])
        self.assertIn('exit code 1, no map', self.judged('echo no map; exit 1')[0])
        self.assertIn('exit code 0', self.judged('echo x >"$3"')[0])

    def test_a_run_without_records_is_a_failure(self):
        self.assertEqual(self.judged('exit 0', bags=()), ['nothing was recorded'])


if __name__ == '__main__':
    unittest.main()
