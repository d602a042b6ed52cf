#!/usr/bin/env python3
"""When rosbag is started, and started again, and what is kept of a run that it has written in several stretches. [REC-1]"""
import os
import re
import unittest

import synthetic_bag
from folder_case import FolderCase
from run_recording import bag_writer, runs
from run_report.bag_files import BagFiles
from run_report.run import Run

LIMIT, MIN_SPACE = 90, 100  # [MB]; a part is 10 MB


class FakeRosbag:
    """A process that ends when the test says so, with this exit code."""

    def __init__(self, command):
        self.words = command
        self.bag = command[command.index('-O') + 1]
        self.returncode = None

    def poll(self):
        return self.returncode

    def send_signal(self, _):
        self.returncode = 0

    def wait(self, _):
        pass


class Writing(FolderCase):
    def setUp(self):
        super().setUp()
        self.free, self.now, self.started = 1000, 0.0, []
        self.writer = self.begin()

    def begin(self):
        return bag_writer.BagWriter(['/scan'], self.folder, LIMIT, MIN_SPACE, '/robot1/run_recorder_rosbag', free=self.free_bytes,
                                    start=self.start, clock=lambda: self.now)

    def free_bytes(self, _):
        return self.free * bag_writer.MEGA

    def start(self, command):
        self.started.append(FakeRosbag(command))
        return self.started[-1]

    def end_rosbag(self, code):
        self.now += 1000.0
        self.started[-1].returncode = code

    def fill(self, name, megabytes):
        with open(self.touch(name), 'w') as file:
            file.truncate(megabytes * bag_writer.MEGA)

    def test_rosbag_is_a_node_in_the_namespace_of_its_recorder_and_not_in_that_of_the_environment(self):
        self.assertEqual(self.started[0].words[-2:], ['__ns:=/robot1/', '__name:=run_recorder_rosbag'])

    def test_a_record_that_ended_because_the_disk_was_full_goes_on_once_a_whole_part_fits(self):
        self.free = 90
        self.end_rosbag(1)
        self.assertIn('is full', self.writer.problem())
        self.free = 105
        self.assertIn('is full', self.writer.problem(), 'it would soon end again')
        self.assertEqual(len(self.started), 1)
        self.free = 111
        self.assertEqual(self.writer.problem(), '')
        self.assertEqual([os.path.basename(rosbag.bag) for rosbag in self.started], ['run', 'run_2'])

    def test_what_is_said_of_a_full_disk_stays_the_same_while_the_space_changes(self):
        self.end_rosbag(1)
        said = set()
        for self.free in (90, 91, 105):
            said.add(self.writer.problem())
        self.assertEqual(len(said), 1, said)

    def test_a_record_that_begins_on_a_full_disk_is_started_when_there_is_room(self):
        self.free, self.started = 90, []
        writer = self.begin()
        self.assertIn('is full', writer.problem())
        self.free = 101
        self.assertEqual(writer.problem(), '')
        self.assertEqual(len(self.started), 1)

    def test_a_rosbag_that_was_killed_is_started_again_after_its_end_was_said_but_not_in_quick_succession(self):
        self.end_rosbag(-9)
        self.assertIn('exit code -9', self.writer.problem())
        self.assertEqual(self.writer.problem(), '')
        self.started[-1].returncode = 1
        self.assertIn('exit code 1', self.writer.problem())
        self.assertIn('exit code 1', self.writer.problem())
        self.assertEqual(len(self.started), 2)
        self.now += bag_writer.PAUSE
        self.assertEqual(self.writer.problem(), '')

    def test_a_rosbag_that_somebody_has_ended_is_not_started_again(self):
        self.end_rosbag(0)
        for _ in range(3):
            self.assertIn('somebody has ended rosbag', self.writer.problem())
        self.assertEqual(len(self.started), 1)

    def test_the_oldest_parts_of_earlier_stretches_make_room_within_the_size_of_the_run(self):
        for number in range(4):
            self.fill('run_%d.bag' % number, 15)
        self.end_rosbag(1)
        self.writer.problem()
        self.assertEqual(self.writer.problem(), '')
        self.fill('run_2_0.bag', 10)
        self.fill('run_2_1.bag.active', 35)
        self.assertEqual(self.writer.problem(), '')
        self.assertEqual([os.path.basename(part) for part in runs.parts_of(self.folder)],
                         ['run_1.bag', 'run_2.bag', 'run_3.bag', 'run_2_0.bag', 'run_2_1.bag.active'])
        self.assertLessEqual(self.writer.size(), LIMIT * bag_writer.MEGA)

    def test_a_bag_that_somebody_removes_while_it_is_written_is_replaced_by_another_one(self):
        self.now += 2.0 * bag_writer.GONE
        self.assertEqual(self.writer.problem(), '', 'rosbag has not opened it yet: it waits for a clock')
        self.fill('run_0.bag.active', 1)
        self.assertEqual(self.writer.problem(), '')
        os.rename(self.path('run_0.bag.active'), self.path('run_0.bag'))
        self.assertEqual(self.writer.problem(), '', 'the next part is about to be opened')
        self.fill('run_1.bag.active', 1)
        self.assertEqual(self.writer.problem(), '')
        os.remove(self.path('run_1.bag.active'))
        self.assertEqual(self.writer.problem(), '', 'the next part may be about to be opened')
        self.now += bag_writer.GONE
        self.assertIn('is gone', self.writer.problem())
        self.assertEqual(self.started[0].poll(), 0, 'it was not ended')
        self.now += 1000.0
        self.assertEqual(self.writer.problem(), '')
        self.assertIn('run_2', self.started[1].bag)

    def test_a_folder_that_is_gone_is_named_while_rosbag_runs(self):
        self.writer.run = self.path('nowhere')
        self.assertIn('the folder of the record is gone', self.writer.problem())


class Starting(FolderCase):
    def test_a_program_that_cannot_be_started_is_a_problem_and_tried_again(self):
        def refuse(_):
            raise OSError('no setpriv')
        writer = bag_writer.BagWriter(['/scan'], self.folder, LIMIT, MIN_SPACE, '/x', start=refuse, free=lambda _: 1e12)
        self.assertIn('no setpriv', writer.problem())
        writer.start, writer.clock = FakeRosbag, lambda: 1e9
        self.assertEqual(writer.problem(), '')


class Stretches(FolderCase):
    def test_parts_of_a_later_stretch_come_after_all_of_an_earlier_one(self):
        for name in ('run_2_0.bag', 'run_10_0.bag.active', 'run_2_11.bag', 'run_0.bag', 'run_12.bag', 'run_2_2.bag'):
            self.touch(name)
        self.assertEqual([os.path.basename(part) for part in runs.parts_of(self.folder)],
                         ['run_0.bag', 'run_12.bag', 'run_2_0.bag', 'run_2_2.bag', 'run_2_11.bag', 'run_10_0.bag.active'])

    def test_rosbag_writes_what_counts_as_a_part_of_its_stretch(self):
        for stretch in (1, 2, 10):
            self.assertEqual(runs.stretch_of(runs.bag_of(self.folder, stretch) + '_7.bag.active'), stretch)

    def test_the_report_reads_all_stretches_and_says_where_nothing_was_recorded(self):
        """[REC-2]"""
        synthetic_bag.write(self.path('run_0.bag'), seconds=5, with_end=False)
        synthetic_bag.write(self.path('run_1.bag'), begin=5, seconds=10, with_end=False)
        synthetic_bag.write(self.path('run_2_0.bag'), begin=45)
        run = Run()
        with BagFiles(runs.parts_of(self.folder)) as bags:
            run.read(bags)
        self.assertEqual(round(run.end - run.begin), synthetic_bag.SECONDS)
        self.assertEqual(run.start_info['moment'], 'start')
        gaps = [note for note in run.notes if note.startswith('Nothing was recorded')]
        self.assertEqual(len(gaps), 1, run.notes)
        self.assertEqual(re.findall(r'\d:\d\d', gaps[0]), ['0:09', '0:45'])


if __name__ == '__main__':
    unittest.main()
