#!/usr/bin/env python3
"""What a report says of times, topics and parts of a bag that are missing, and of what stands there twice."""
import json
import os
import unittest

import rosbag
import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from frontier_pilot.msg import ArbiterStatus, SpinActionResult
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid
from std_msgs.msg import String

from folder_case import FolderCase
import synthetic_bag
from run_report.bag_files import BagFiles
from run_report.intervals import States
from run_report.run import Run
from run_report.track import MapImage
from run_report.warnings import Warnings


def read(*paths):
    run = Run()
    with BagFiles(list(paths)) as bags:
        run.read(bags)
    return run


class Lifetimes(unittest.TestCase):
    def test_what_is_said_again_and_again_ends_when_nobody_says_it_any_more(self):
        states = States(5.0)
        for time in (1.0, 2.0, 40.0, 41.0):
            states.add(time, 'nav')
        self.assertEqual(states.those(100.0), [(1.0, 2.0, 'nav'), (40.0, 46.0, 'nav')])

    def test_a_state_may_be_interrupted(self):
        states = States()
        states.interrupt(1.0)
        states.add(2.0, 'recovering')
        states.interrupt(10.0)
        states.add(1000.0, 'recovering')
        self.assertEqual(states.those(1001.0), [(2.0, 10.0, 'recovering'), (1000.0, 1001.0, 'recovering')])


class RepeatedMap(unittest.TestCase):
    def test_a_map_that_is_written_once_more_does_not_undo_the_changes_since(self):
        image, whole, change = MapImage(), OccupancyGrid(), OccupancyGridUpdate(x=1, width=1, height=1, data=[0])
        whole.header.stamp.secs, whole.info.resolution, whole.info.width, whole.info.height, whole.data = 7, 0.1, 2, 1, [-1, -1]
        image.take(whole)
        image.change(change)
        image.take(whole)
        self.assertEqual(list(image.cells[0]), [-1, 0])
        whole.header.stamp.secs = 8
        image.take(whole)
        self.assertEqual(list(image.cells[0]), [-1, -1], 'a later one')


class Loops(unittest.TestCase):
    def closed(self, *counts, namespace=None):
        """What is counted of these (name of the status, count), one each second."""
        warnings = Warnings()
        warnings.namespace = namespace
        for second, (name, count) in enumerate(counts):
            status = DiagnosticStatus(name=name, values=[KeyValue('loops closed', str(count))])
            warnings.take_diagnostics(float(second), DiagnosticArray(status=[status]))
        return warnings.loops

    def test_a_mapper_that_is_started_again_counts_anew(self):
        mapper = 'mapper: map'
        self.assertEqual(self.closed((mapper, 0), (mapper, 3), (mapper, 0), (mapper, 2)), [(1.0, 3), (3.0, 5)])

    def test_those_of_another_robot_do_not_count(self):
        both = [('robot2/mapper: map', 5), ('robot1/mapper: map', 1), ('robot2/mapper: map', 6)]
        self.assertEqual(self.closed(*both, namespace='/robot1'), [(1.0, 1)])
        self.assertEqual(self.closed(*both), [(0.0, 5), (2.0, 6)], 'without a word of the recorder those of the first')


class Bags(FolderCase):
    def test_a_topic_of_another_robot_is_not_taken_for_one_of_which_there_is_no_message(self):
        path = os.path.join(self.folder, 'both.bag')
        info = json.dumps({'moment': 'start', 'wall_time': 1.7e9, 'namespace': '/robot1', 'parameters': {},
                           'topics': {'spin/result': '/robot1/spin/result'}})
        with rosbag.Bag(path, 'w') as bag:
            bag.write('/robot1/run_recorder/info', String(info), rospy.Time(1))
            bag.write('/robot2/spin/result', SpinActionResult(), rospy.Time(5))
        self.assertEqual(read(path).actions, [])

    def test_an_arbiter_that_has_died_is_not_said_to_drive(self):
        path = os.path.join(self.folder, 'dead.bag')
        with rosbag.Bag(path, 'w') as bag:
            for second in range(1, 61):
                if second <= 10:
                    bag.write('/cmd_vel_arbiter/status', ArbiterStatus(active_source='nav'), rospy.Time(second))
                bag.write('/map', OccupancyGrid(), rospy.Time(second))
        run = read(path)
        self.assertEqual(run.source.those(run.end), [(1.0, 15.0, 'nav')])

    def test_a_part_that_is_damaged_is_not_said_to_be_a_clock_that_was_set(self):
        parts = [os.path.join(self.folder, 'run_%d.bag' % part) for part in range(3)]
        for part, path in enumerate(parts):
            synthetic_bag.write(path, begin=60 * part, seconds=60 * part + 60, with_end=False)
        for left in 4096, os.path.getsize(parts[1]) // 2:
            with open(parts[1], 'r+b') as file:
                file.truncate(left)
            run = read(*parts)
            self.assertFalse([note for note in run.notes if 'the clock was set' in note], run.notes)
            synthetic_bag.write(parts[1], begin=60, seconds=120, with_end=False)


if __name__ == '__main__':
    unittest.main()
