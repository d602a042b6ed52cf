#!/usr/bin/env python3
"""The matrix of faults, its table, and what the fuzzer keeps to itself."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from run_attack import fuzz_plan, table  # noqa: E402
from run_attack.outcome import Outcome  # noqa: E402
from run_attack.parts import seconds_of  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]


class Table(unittest.TestCase):
    results = {('mapper', 'killed', 'exploring'): '0.61 s', ('mapper', 'suspended 10 s', 'idle'): 'held',
               ('mapper', 'suspended 3 s', 'idle'): 'FAILED: a | b\nc', ('arbiter', 'killed', 'idle'): 'held'}

    def test_each_fault_of_a_node_has_a_row_and_each_phase_a_column(self):
        lines = table.render(self.results, ('idle', 'exploring'), 'Run today.').split('\n')
        self.assertEqual(lines[0], 'Run today.')
        self.assertEqual(lines[2], '| node | fault | idle | exploring |')
        self.assertEqual(lines[4:], ['| `arbiter` | killed | held | – |', '| `mapper` | killed | – | 0.61 s |',
                                     '| `mapper` | suspended 3 s | FAILED: a / b c | – |',
                                     '| `mapper` | suspended 10 s | held | – |'])

    def test_only_what_is_between_the_marks_is_replaced(self):
        page = 'before\n%s\nold\n%s\nafter\n' % (table.BEGIN, table.END)
        self.assertEqual(table.replaced(table.replaced(page, 'x'), 'new'),
                         'before\n%s\n\nnew\n\n%s\nafter\n' % (table.BEGIN, table.END))
        with self.assertRaises(ValueError):
            table.replaced('a page without marks', 'new')

    def test_the_page_has_a_place_for_the_table(self):
        page = (ROOT / 'docs/reliability.md').read_text()
        self.assertIn('\n\nnew\n\n', table.replaced(page, 'new'))


class Faults(unittest.TestCase):
    def setUp(self):
        try:
            from run_attack import faults
        except ImportError as error:
            self.skipTest('needs the messages of a build: %s' % error)
        self.faults = faults

    def test_all_cells_are_visited_in_an_order_that_the_seed_gives(self):
        cells = self.faults.drawn_cells(1)
        self.assertEqual(len(cells), 8 * 6 * 5)
        self.assertEqual(len(set(cells)), len(cells))
        self.assertEqual(cells, self.faults.drawn_cells(1))
        self.assertNotEqual(cells, self.faults.drawn_cells(2))

    # [FLT-2]
    def test_the_base_has_to_stand_where_the_node_that_drives_is_gone_for_longer_than_its_commands_count(self):
        limit = self.faults.standing_limit
        self.assertAlmostEqual(limit('navigator', 'killed', 'exploring'), 1.2)
        self.assertAlmostEqual(limit('cmd_vel_arbiter', 'suspended 1 s', 'spinning'), 0.8)
        self.assertIsNone(limit('navigator', 'suspended 1 s', 'exploring'))
        self.assertIsNone(limit('frontier_explorer', 'killed', 'exploring'))
        self.assertIsNone(limit('navigator', 'killed', 'idle'))
        self.assertAlmostEqual(limit('patrol_server', 'aborted', 'patrolling'), 1.2)
        self.assertIsNone(limit('navigator', 'slowed 5 s', 'exploring'), 'it may be in time')

    def test_a_node_that_is_slowed_down_runs_for_its_share_of_the_time(self):
        busy = subprocess.Popen([sys.executable, '-c', 'while True: pass'])
        self.addCleanup(busy.wait)
        self.addCleanup(busy.kill)

        def used():
            fields = pathlib.Path('/proc/%d/stat' % busy.pid).read_text().rsplit(')', 1)[1].split()
            return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')
        before = used()
        self.faults.starve(busy.pid, 2.0, 0.05)
        self.assertLess(used() - before, 0.6)
        self.assertGreater(used() - before, 0.0)
        busy.kill()
        busy.wait()
        with self.assertRaises(ProcessLookupError):
            self.faults.starve(busy.pid, 1.0, 0.05)

    def cell(self, motion, fault='killed', node='navigator'):
        """A cell that was judged on a motion of the base, (time, speed), with the fault at 10.0, in a slow simulation."""
        class Watch:
            stood_after = self.robot_watch.RobotWatch.stood_after
            braking_time = self.robot_watch.RobotWatch.braking_time
            _stamp_at = self.robot_watch.RobotWatch._stamp_at
            moved_since = self.robot_watch.RobotWatch.moved_since
        watch = Watch()
        watch.motion = [(at, 5.0 + 0.5 * at, speed, speed / 2.0) for at, speed in motion]
        return self.faults.Cell(watch, None, node, fault, 'exploring')

    # [FLT-2]
    def test_a_base_that_moves_on_for_too_long_fails(self):
        from run_attack import robot_watch
        self.robot_watch = robot_watch
        moving = [(10.0 + 0.1 * i, 0.2) for i in range(60)]
        in_time = self.cell(moving[:19] + [(11.9, 0.0)] + moving[20:])
        self.assertEqual((in_time.judge_standing(10.05), in_time.failures), ('0.95 s', []))
        late = self.cell(moving[:40] + [(14.0, 0.0)])
        late.judge_standing(10.05)
        self.assertEqual(late.failures, ['stood after 2.00 s instead of 1.30 s'])
        never = self.cell(moving)
        never.judge_standing(10.05)
        self.assertEqual(never.failures, ['stood after still moving instead of 1.30 s'])
        back = self.cell(moving, 'suspended 1 s', 'cmd_vel_arbiter')  # after 0.6 s the base brakes, for a long time
        back.watch.motion = [(at, stamp, speed, 0.7) for at, stamp, speed, _ in back.watch.motion]
        self.assertEqual((back.judge_standing(10.05), back.failures), ('held', []))
        stopped = self.cell([(9.0, 0.2), (10.5, 0.0)])
        self.assertFalse(stopped.watch.moved_since(10.0))
        self.assertTrue(self.cell([(11.0, 0.1)]).watch.moved_since(10.0))


class Lives(unittest.TestCase):
    # [FLT-1]
    def test_a_node_that_dies_is_noticed_and_its_last_messages_are_kept(self):
        try:
            from run_attack import lives
        except ImportError as error:
            self.skipTest('needs the messages of a build: %s' % error)
        nodes = {name: subprocess.Popen(['sleep', '60']) for name in ('mapper', 'navigator')}
        for process in nodes.values():
            self.addCleanup(process.wait)
            self.addCleanup(process.kill)
        told = threading.Event()
        with unittest.mock.patch.object(lives, 'pids', lambda _: {name: process.pid for name, process in nodes.items()}):
            watched = lives.Lives(lambda node: told.set())
            self.addCleanup(watched.end)
            self.assertEqual(watched.dead, {})
            nodes['mapper'].send_signal(signal.SIGSEGV)
            nodes['mapper'].wait()
            self.assertTrue(told.wait(10.0))
        self.assertEqual(set(watched.dead), {'mapper'})
        self.assertLess(abs(watched.growth()['navigator']), 10.0)


class Plan(unittest.TestCase):
    names = ['/clock', '/scan', '/tf_static', '/cmd_vel', '/cmd_vel_nav', '/simulator/set_pose', '/emergency_stop',
             '/set_emergency_stop', '/move_base/goal', '/cmd_vel_arbiter/set_logger_level', '/scan_of_another']

    def test_an_honest_round_leaves_out_the_world_the_wheels_and_the_stop(self):
        self.assertEqual(fuzz_plan.chosen(self.names, True),
                         ['/move_base/goal', '/cmd_vel_arbiter/set_logger_level', '/scan_of_another'])

    def test_the_other_round_leaves_out_only_the_stop(self):
        self.assertEqual(set(self.names) - set(fuzz_plan.chosen(self.names, False)), {'/emergency_stop', '/set_emergency_stop'})


class KeptMessages(unittest.TestCase):
    def test_what_was_kept_is_read_again(self):
        try:
            from run_attack import fuzz_sender
        except ImportError as error:
            self.skipTest('needs rospy: %s' % error)
        kept = [(1.5, '/scan', 'sensor_msgs/LaserScan', b'\0\xff'), (2.0, '/odom', 'nav_msgs/Odometry', b'')]
        with tempfile.TemporaryDirectory() as folder:
            fuzz_sender.write_kept(kept, folder + '/kept')
            self.assertEqual(fuzz_sender.read_kept(folder + '/kept'), kept)


class Parts(unittest.TestCase):
    def test_the_parts_share_the_time(self):
        parts = ('stops', 'fuzz', 'faults')
        self.assertAlmostEqual(sum(seconds_of(part, parts, 2.0) for part in parts), 120.0)
        self.assertAlmostEqual(seconds_of('stops', ('stops',), 2.0), 120.0)

    def test_what_does_not_hold_is_a_failure(self):
        outcome = Outcome('part', lambda words: None)
        self.assertTrue(outcome.expect(True, 'nothing'))
        self.assertFalse(outcome.expect(False, 'something'))
        self.assertEqual(outcome.failures, ['something'])


if __name__ == '__main__':
    unittest.main()
