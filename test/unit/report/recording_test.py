#!/usr/bin/env python3
"""The folder of recorded runs, and the load of processes."""
import datetime
import errno
import os
import pathlib
import re
import subprocess
import unittest
import unittest.mock
import xml.parsers.expat
import xmlrpc.client

from folder_case import FolderCase
from run_recording import bag_writer, runs
from run_recording.node_load import LoadMeter, Nodes, used_by
from run_recording.topics import TOPICS


ROOT = pathlib.Path(__file__).resolve().parents[3]


class Topics(unittest.TestCase):
    def test_the_goals_of_all_actions_are_recorded(self):
        """[REC-1]"""
        names = dict(re.findall(r'constexpr const char\* k(\w+) = "(.*)";', (ROOT / 'src/ros/common/names.h').read_text()))
        actions = [names[file.stem] for file in (ROOT / 'action').glob('*.action')] + [names['MoveBase']]
        self.assertGreater(len(actions), 5)
        self.assertEqual([action for action in actions if action + '/goal' not in TOPICS], [])


class Runs(FolderCase):
    def test_a_run_is_named_by_its_date_and_two_of_the_same_second_are_kept_apart(self):
        now = datetime.datetime(2030, 2, 3, 4, 5, 6)
        names = [os.path.basename(runs.begin(self.folder, now)) for _ in range(2)]
        self.assertEqual(names, ['2030-02-03_04-05-06', '2030-02-03_04-05-06_1'])

    def test_only_the_newest_runs_are_kept_and_nothing_else_is_removed(self):
        """[REC-1]"""
        for day in range(1, 6):
            self.touch('2030-01-0%d_00-00-00' % day, 'run_0.bag')
        precious = self.touch('precious', 'run_0.bag')
        os.symlink(self.path('precious'), self.path('2029-01-01_00-00-00'))
        removed = runs.keep_newest(self.folder, 2)
        self.assertEqual([os.path.basename(path)[:10] for path in removed], ['2030-01-01', '2030-01-02', '2030-01-03'])
        self.assertTrue(os.path.exists(precious))
        self.assertEqual(len(runs.all_runs(self.folder)), 2)

    def test_runs_come_in_the_order_in_which_they_began_whatever_the_clock_said(self):
        """[REC-1] The clock is put back in autumn, and a computer without a battery begins anywhere."""
        older = self.touch('2031-01-01_00-00-00', 'run_0.bag')  # of a recorder that did not number its runs
        times = ((2030, 10, 27, 2, 50), (2030, 10, 27, 2, 10), (1970, 1, 1, 0, 0), (2030, 10, 27, 2, 50))
        begun = [runs.begin(self.folder, datetime.datetime(*time)) for time in times]
        self.assertEqual(runs.all_runs(self.folder), [os.path.dirname(older)] + begun)
        runs.keep_newest(self.folder, 2)
        self.assertEqual(runs.all_runs(self.folder), begun[2:])

    def test_of_the_same_second_more_than_ten_runs_keep_their_order(self):
        now = datetime.datetime(2030, 2, 3, 4, 5, 6)
        begun = [runs.begin(self.folder, now) for _ in range(12)]
        self.assertEqual(runs.all_runs(self.folder), begun)

    def test_a_run_that_is_still_being_recorded_is_not_removed(self):
        """[REC-1]"""
        open_part = self.touch('2030-01-01_00-00-00', 'run_0.bag.active')
        self.touch('2030-01-02_00-00-00', 'run_0.bag')
        with open(open_part):
            self.assertEqual(runs.keep_newest(self.folder, 1), [])
        self.assertEqual(len(runs.keep_newest(self.folder, 1)), 1)

    def test_a_run_that_waits_for_room_is_not_removed(self):
        """[REC-1]"""
        run = runs.begin(self.folder)
        with runs.held(run):
            self.assertEqual(runs.keep_newest(self.folder, 0), [])
        self.assertEqual(runs.keep_newest(self.folder, 0), [run])

    def test_a_folder_that_somebody_else_has_made_is_not_removed_whatever_its_name(self):
        """[REC-1]"""
        os.mkdir(self.path('2026-01-01_00-00-00'))
        self.touch('2026-01-02_00-00-00', 'thesis.txt')
        self.touch('2026-01-03_00-00-00', 'run_0.bag')
        self.touch('2026-01-03_00-00-00', 'thesis.txt')
        self.touch('2026-01-04_00-00-00', 'report.html')
        self.touch('2026-01-05_00-00-00/made_by_run_recorder.1', 'thesis.txt')
        with open(self.touch('2026-01-06_00-00-00', 'made_by_run_recorder.2'), 'w') as thesis:
            thesis.write('It was a dark and stormy night.')
        theirs = set(os.listdir(self.folder))
        ours = runs.begin(self.folder)
        self.assertEqual(runs.keep_newest(self.folder, 0), [ours])
        self.assertEqual(set(os.listdir(self.folder)), theirs)

    def test_what_somebody_has_put_into_a_run_outlives_it(self):
        """[REC-1] A map was saved beside the record of its run."""
        run = runs.begin(self.folder)
        for name in ('run_0.bag', 'run_1.bag', 'report.html', 'floor.bt', 'maps/floor.pgm'):
            self.touch(os.path.join(run, os.path.dirname(name)), os.path.basename(name))
        self.assertEqual(runs.keep_newest(self.folder, 0), [run])
        self.assertEqual(sorted(os.listdir(run)), ['floor.bt', 'maps'])
        self.assertTrue(os.path.exists(os.path.join(run, 'maps', 'floor.pgm')))
        self.assertEqual(runs.keep_newest(self.folder, 0), [])

    def test_a_run_without_the_file_that_marks_it_is_known_by_what_is_in_it(self):
        """[REC-1]"""
        for name in ('run_0.bag', 'run_2_0.bag.active', 'report.html'):
            self.touch('2026-01-01_00-00-00', name)
        self.assertEqual(runs.keep_newest(self.folder, 0), [self.path('2026-01-01_00-00-00')])

    def test_a_folder_in_which_nothing_can_be_written_is_not_left_behind(self):
        def refuse(*_):
            raise OSError(errno.ENOSPC, 'No space left on device')
        with unittest.mock.patch('run_recording.runs.open', refuse, create=True), self.assertRaises(OSError):
            runs.begin(self.folder)
        self.assertEqual(os.listdir(self.folder), [])

    def test_parts_come_in_the_order_in_which_they_were_written(self):
        for name in ('run_10.bag.active', 'run_9.bag', 'run_2.bag', 'report.html'):
            self.touch('run', name)
        self.assertEqual([os.path.basename(part) for part in runs.parts_of(self.path('run'))],
                         ['run_2.bag', 'run_9.bag', 'run_10.bag.active'])

    def test_all_parts_together_are_no_larger_than_a_run_may_be(self):
        """[REC-1]"""
        for limit in (10, 400, 5000):
            self.assertLessEqual(bag_writer.part_size(limit) * (bag_writer.PARTS + 1), limit)


class Processes(unittest.TestCase):
    def test_a_master_whose_answer_cannot_be_read_changes_nothing(self):
        """[FLT-1]"""
        failures = (ConnectionRefusedError(), xmlrpc.client.Fault(1, 'no'), xml.parsers.expat.ExpatError('no element found'))
        for failure in failures:
            for call in ('getSystemState', 'lookupNode', 'getUri'):
                with self.subTest(failure=failure, call=call):
                    nodes = Nodes('/run_recorder')
                    nodes.pids = {'/mapper': 7}
                    nodes.master = unittest.mock.Mock()
                    nodes.master.getSystemState.return_value = [[['/map', ['/mapper']]], [], []]
                    nodes.master.lookupNode.return_value = nodes.master.getUri.return_value = 'http://192.0.2.1:1'
                    getattr(nodes.master, call).side_effect = failure
                    self.assertEqual(nodes.processes(), {'/mapper': 7})


class Load(unittest.TestCase):
    def test_cpu_time_is_measured_between_two_looks(self):
        times, uses = iter((10.0, 12.0)), iter(((5.0, 100), (6.0, 200)))
        meter = LoadMeter(clock=lambda: next(times), used=lambda pid: next(uses))
        self.assertEqual(meter.measure({'/mapper': 7}), [])
        self.assertEqual(meter.measure({'/mapper': 7}), [('/mapper', 7, 0.5, 200)])

    def test_a_process_that_has_ended_or_whose_number_is_used_again_has_no_load(self):
        times = iter((10.0, 12.0, 14.0))
        uses = iter(((5.0, 100), (0.1, 100), None))
        meter = LoadMeter(clock=lambda: next(times), used=lambda pid: next(uses))
        self.assertEqual([meter.measure({'/mapper': 7}) for _ in range(3)], [[], [], []])

    def test_what_a_process_uses_is_read_from_the_system(self):
        seconds, memory = used_by(os.getpid())
        self.assertGreater(seconds, 0.0)
        self.assertGreater(memory, 1000000)
        with subprocess.Popen(['true']) as process:
            process.wait()
        self.assertIsNone(used_by(process.pid))


if __name__ == '__main__':
    unittest.main()
