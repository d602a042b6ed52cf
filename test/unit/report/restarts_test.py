#!/usr/bin/env python3
"""What a report says of nodes that died during the run and were started again. [REC-1]"""
import unittest
from types import SimpleNamespace

import rosbag
import rospy
from frontier_pilot.msg import ProcessLoad, ProcessLoads
from std_msgs.msg import Bool

from folder_case import FolderCase
import synthetic_bag
from run_report import page, summary
from run_report.bag_files import BagFiles
from run_report.load import Load
from run_report.progress import Counts
from run_report.run import Run


def status(sent, distance, reached=0, failed=0):
    return SimpleNamespace(goals_sent=sent, goals_reached=reached, goals_failed=failed, distance_travelled=distance)


class AnExplorerThatWasStartedAgain(unittest.TestCase):
    def test_counts_of_before_are_added_to_those_of_now(self):
        counts = Counts()
        for one in (status(1, 0.5), status(4, 6.5, reached=1), status(0, 0.0), status(2, 1.5, failed=1), status(0, 0.0)):
            whole = counts.take(one)
        self.assertEqual(whole, {'goals_sent': 6, 'goals_reached': 1, 'goals_failed': 1, 'distance_travelled': 8.0})

    def test_counts_of_one_that_was_not_are_its_own(self):
        counts = Counts()
        counts.take(status(1, 0.5))
        self.assertEqual(counts.take(status(1, 2.5))['distance_travelled'], 2.5)


class AClockThatWasSetBack(FolderCase):
    def test_does_not_let_counts_of_before_and_after_it_be_added_again_and_again(self):
        path = self.path('run_0.bag')
        synthetic_bag.write(path)
        with rosbag.Bag(path, 'a') as bag:
            for at, number in ((20.0, 2), (21.0, 1)):
                load = ProcessLoads(wall_time=1.7e9)
                load.header.seq = number
                bag.write('/run_recorder/load', load, rospy.Time.from_sec(synthetic_bag.BEGIN + at))
            for second in range(20, 50):  # of the second time that these seconds were recorded
                bag.write('/frontier_explorer/status', synthetic_bag.explorer_status(second - 19),
                          rospy.Time.from_sec(synthetic_bag.BEGIN + second + 0.5))
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        self.assertTrue(run.load.was_set_back())
        self.assertEqual(run.status(), run.explorer[-1][1])
        self.assertGreater(run.counts.whole()['distance_travelled'], run.status().distance_travelled)


class ARecordThatLacksTopics(FolderCase):
    def test_does_not_say_that_nothing_happened_of_which_nothing_was_recorded(self):
        path = self.path('scan.bag')
        with rosbag.Bag(path, 'w') as bag:
            for second in range(5):
                bag.write('/simulator/stalled', Bool(False), rospy.Time(100 + second))
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        self.assertEqual(summary.incident_counts(run), (None, 0, None))
        self.assertEqual(summary.sentences(run)[-1], 'There was no contact.')
        self.assertEqual([words.split(':')[0] for _, words in summary.to_look_at(run)][-2:],
                         ['Nothing of the arbiter was recorded', 'No diagnostics were recorded'])
        made = page.page(run, [], True, [path])
        self.assertNotIn('Nothing went wrong', made)
        self.assertNotIn('was OK throughout', made)


class ANodeThatDied(FolderCase):
    def test_is_known_by_its_next_process(self):
        load = Load()
        for time, pid in ((1.0, 7), (2.0, 7), (3.0, 9), (4.0, 9)):
            load.take(time, ProcessLoads(wall_time=1.7e9 + time, processes=[ProcessLoad('/mapper', pid, 0.1, 5)]))
        self.assertEqual(load.restarts(), [(3.0, '/mapper')])

    def test_is_not_one_that_people_start_once_more(self):
        load = Load()
        for time, pid in ((1.0, 7), (600.0, 9)):
            processes = [ProcessLoad(name, pid, 0.1, 5) for name in ('/patrol_client', '/robot1/teleop_gui', '/robot1/mapper')]
            load.take(time, ProcessLoads(wall_time=1.7e9 + time, processes=processes))
        self.assertEqual(load.restarts(), [(600.0, '/robot1/mapper')])

    def test_is_not_told_from_one_whose_samples_lie_between_those_of_before_because_the_clock_was_set_back(self):
        load = Load()
        for number, pid in ((1, 7), (30, 9), (2, 7), (31, 9)):  # as a bag gives them, by time
            loads = ProcessLoads(wall_time=1.7e9, processes=[ProcessLoad('/mapper', pid, 0.1, 5)])
            loads.header.seq = number
            load.take(float(number), loads)
        self.assertEqual(load.restarts(), [])

    def test_is_worth_a_look(self):
        path = self.path('run_0.bag')
        synthetic_bag.write(path)
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        before = summary.to_look_at(run)
        run.load._restarts.append((run.begin + 3.0, '/mapper'))
        self.assertEqual([item for item in summary.to_look_at(run) if item not in before],
                         [('ERROR', '/mapper ended, and went on as another process at 0:03.')])


if __name__ == '__main__':
    unittest.main()
