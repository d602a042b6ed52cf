#!/usr/bin/env python3
"""What a report finds in a run."""
import json
import re
import time
import tracemalloc
import unittest
from unittest import mock

import rosbag
import rospy
from frontier_pilot.msg import AvoiderStatus, ExplorerStatus, FrontierStatus, ProcessLoad, ProcessLoads
from geometry_msgs.msg import PoseStamped
from std_msgs.msg import Bool, String

from folder_case import FolderCase
import synthetic_bag
from run_report import drawing, goals, parameters, summary, time_plots
from run_report.bag_files import BagFiles
from run_report.intervals import States, merged, total
from run_report.load import Load
from run_report.page import page, parameters_section
from run_report.run import Run, read_info
from run_report.warnings import Warnings


def since(run, spans):
    """The spans in whole seconds since the start."""
    return [(round(span[0] - run.begin), round(span[1] - run.begin)) for span in spans]


class Intervals(unittest.TestCase):
    def test_a_state_lasts_until_the_next_one_and_the_last_one_until_the_end(self):
        states = States()
        for time, value in ((1.0, 'a'), (2.0, 'a'), (3.0, ''), (5.0, 'b')):
            states.add(time, value)
        self.assertEqual(states.those(9.0), [(1.0, 3.0, 'a'), (5.0, 9.0, 'b')])

    def test_spans_that_touch_are_one(self):
        self.assertEqual(merged([(4.0, 5.0, 'x'), (1.0, 2.0), (2.0, 3.0)]), [(1.0, 3.0), (4.0, 5.0)])
        self.assertEqual(total([(0.0, 2.0), (1.0, 3.0)]), 3.0)


class WhatSomebodyElsePublished(unittest.TestCase):
    def test_notes_of_a_run_with_times_or_topics_that_cannot_be_are_not_the_recorders(self):
        good = {'moment': 'start', 'wall_time': 1.7e9, 'namespace': '/', 'topics': {'map': '/map'}, 'parameters': {}}
        self.assertEqual(read_info(json.dumps(good)), good)
        deep = {}
        for _ in range(500):
            deep = {'mapper': deep}
        for change in ({'wall_time': float('nan')}, {'wall_time': float('inf')}, {'wall_time': 10**400}, {'wall_time': -1.0},
                       {'topics': {'map': [1]}}, {'topics': []}, {'parameters': deep}):
            self.assertIsNone(read_info(json.dumps(dict(good, **change))), change)

    def test_loads_that_cannot_be_are_left_out(self):
        load = Load()
        for cpu in (float('nan'), float('inf'), 1e308, -1e308):
            with self.assertRaises(ValueError):
                load.take(1.0, ProcessLoads(wall_time=1.7e9, processes=[ProcessLoad('/mapper', 7, cpu, 5)]))
        with self.assertRaises(ValueError):
            load.take(1.0, ProcessLoads(wall_time=float('nan')))
        self.assertEqual((load.rows(), load.wall), ([], []))


class SyntheticRun(FolderCase):
    def read(self, **options):
        path = self.path('run_0.bag')
        synthetic_bag.write(path, **options)
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        return run


class WhatTheSummarySays(SyntheticRun):
    def test_a_robot_is_not_simulated_because_a_simulation_has_left_its_parameters_at_the_master(self):
        self.assertIn('simulated', summary.subject(self.read()))
        self.assertNotIn('simulated', summary.subject(self.read(use_sim_time=False)))

    def test_odometry_that_does_not_name_the_robots_frame_leaves_its_track(self):
        length = self.read().track.length
        self.assertGreater(length, 1.0)
        for base_frame in '', 'nowhere':
            self.assertEqual(self.read(base_frame=base_frame).track.length, length, base_frame)

    def test_many_stops_do_not_hide_what_else_there_is(self):
        run = self.read()
        for time in range(70):
            run.stop.add(200.0 + time, 'cause %d' % time)
        looked_at = [text for _, text in summary.to_look_at(run)]
        self.assertIn('There were %d more emergency stops.' % (len(run.stop.those(run.end)) - summary.MOST_STOPS), looked_at)
        self.assertTrue([text for text in looked_at if 'touched something' in text])


class Reading(SyntheticRun):
    def setUp(self):
        super().setUp()
        self.run_read = self.read()

    def test_a_bag_that_the_recorder_did_not_write_is_read_as_far_as_it_has_our_topics_and_types(self):
        path = self.path('foreign.bag')
        nowhere = synthetic_bag.transform('map', 'base_footprint', float('nan'), 0.0)
        with rosbag.Bag(path, 'w') as bag:
            for second in range(3):
                at = rospy.Time(100 + second)
                bag.write('/odom', PoseStamped(), at)  # of another type than ours
                bag.write('/tf', synthetic_bag.transform('map', 'base_footprint', float(second), 0.0), at)
                bag.write('/tf', nowhere, at)
                bag.write('/somebody/map', String('a street'), at)
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        self.assertAlmostEqual(run.track.length, 0.0)  # steps of a metre are jumps
        self.assertEqual([pose[1] for pose in run.track.poses], [0.0, 1.0, 2.0])
        self.assertIsNone(run.map.cells)

    def test_a_record_that_begins_late_says_whether_its_beginning_was_removed_or_never_recorded(self):
        for name, cause in (('run_0.bag', 'the recorder was started later'), ('run_4.bag', 'was removed'),
                            ('run_2_0.bag', 'was removed')):
            path = self.path(name)
            with rosbag.Bag(path, 'w') as bag:
                for second in (30, 31):
                    bag.write('/frontier_explorer/status', synthetic_bag.explorer_status(second), rospy.Time(100 + second))
            run = Run()
            with BagFiles([path]) as bags:
                run.read(bags)
            self.assertEqual(len(run.notes), 1)
            self.assertRegex(run.notes[0], 'does not go back to the start of the run: .*' + cause)

    def test_notes_that_are_not_of_the_recorder_are_left_out(self):
        path = self.path('notes.bag')
        with rosbag.Bag(path, 'w') as bag:
            for text in ('0', '[]', '{"moment": 1}', '{', json.dumps({'moment': 'start', 'topics': [], 'parameters': 7})):
                bag.write('/run_recorder/info', String(text), rospy.Time(100))
            bag.write('/a/run_recorder/info', PoseStamped(), rospy.Time(100))
            bag.write('/tf', synthetic_bag.transform('map', 'base_footprint', 0.0, 0.0), rospy.Time(101))
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        self.assertIsNone(run.start_info)

    def test_a_clock_that_is_set_during_the_run_does_not_fill_the_axis_with_ticks(self):
        with drawing.styled():
            _, axes = drawing.new_axes(0.2)
            drawing.time_axis(axes, 1.7e9)
            self.assertLess(len(axes.get_xticks()), 12)

    def notes_with_loads(self, loads):
        """Those of the run with loads of these (time since its begin, real time, number) more, and how long it took in real time."""
        path = self.path('run_0.bag')
        with rosbag.Bag(path, 'a') as bag:
            for at, wall, number in loads:
                load = ProcessLoads(wall_time=1.7e9 + wall)
                load.header.seq = number
                bag.write('/run_recorder/load', load, rospy.Time.from_sec(synthetic_bag.BEGIN + at))
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        return run.notes, run.real_seconds

    def test_a_clock_that_was_set_back_is_told_from_a_time_without_any_message(self):
        notes, _ = self.notes_with_loads([(61.0, 21.0, 1), (8000.0, 22.0, 2), (63.0, 23.0, 3)])
        self.assertEqual([note for note in notes if 'clock' in note], [note for note in notes if 'was set back' in note])
        self.assertEqual(len([note for note in notes if 'was set back' in note]), 1, notes)

    def test_the_real_time_is_without_a_jump_of_the_computers_clock(self):
        notes, seconds = self.notes_with_loads([(61.0, 21.0, 1), (62.0, 1e9, 2), (63.0, 1e9 + 1.0, 3)])
        self.assertEqual(round(seconds), 22)
        self.assertTrue(any("The computer's clock was set" in note for note in notes), notes)

    def test_a_jump_of_the_computers_clock_is_told_from_a_recorder_that_looks_seldom(self):
        for walls, seconds, jumped in (((0.0, 60.0, 121.0, 180.0), 180, False), ((0.0, 2.0, 4.0, -90.0, -88.0), 6, True)):
            run = Run()
            run.load.wall = [(2.0 * number, wall, number) for number, wall in enumerate(walls)]
            bags = mock.Mock(has_a_break=lambda begin, end: False)
            self.assertEqual((run._measure_real_time(bags), round(run.real_seconds)), (jumped, seconds), walls)

    def test_a_record_that_begins_later_than_its_recorder_tells_nothing_of_the_computers_clock(self):
        run = Run()
        run.begin, run.start_info = 1000.0, {'wall_time': 0.0}  # its oldest part was removed
        run.load.wall = [(1000.0 + 2.0 * number, 1000.0 + 2.0 * number, number) for number in range(5)]
        bags = mock.Mock(has_a_break=lambda begin, end: False)
        self.assertEqual((run._measure_real_time(bags), round(run.real_seconds)), (False, 8))

    def test_a_time_without_any_message_is_said_to_be_of_the_clock(self):
        path = self.path('run_0.bag')
        with rosbag.Bag(path, 'a') as bag:
            bag.write('/simulator/stalled', Bool(False), rospy.Time(synthetic_bag.BEGIN + synthetic_bag.SECONDS + 86400.0))
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        self.assertEqual([note for note in run.notes if note.startswith('Nothing was recorded for 864')], run.notes)
        self.assertEqual(len(run.notes), 1)

    def test_numbers_that_no_run_can_have_are_left_out_and_noted(self):
        path = self.path('run_0.bag')
        with rosbag.Bag(path, 'a') as bag:
            at = rospy.Time(synthetic_bag.BEGIN + 30.0)
            for far in 1.5e308, -1.5e308, 2e6, float('nan'), float('inf'):
                bag.write('/tf', synthetic_bag.transform('odom', 'base_footprint', far, 0.0), at)
                pose = PoseStamped()
                pose.pose.position.y = far
                bag.write('/frontier_explorer/goal', pose, at)
            nothing_behind = AvoiderStatus(state=AvoiderStatus.ROTATE, summary='rotating', rear=float('inf'))
            bag.write('/obstacle_avoider/status', nothing_behind, at)
            for area in 1.5e308, -1.5e308, float('inf'):
                bag.write('/frontier_explorer/status', ExplorerStatus(explored_area=area), at)
        run = Run()
        with BagFiles([path]) as bags:
            run.read(bags)
        self.assertEqual((run.track.poses, len(run.explorer), run.goals.places),
                         (self.run_read.track.poses, len(self.run_read.explorer), self.run_read.goals.places))
        self.assertEqual({note.split(' has ')[0] for note in run.notes if 'not understood: they have' in note},
                         {'/tf', '/frontier_explorer/goal', '/frontier_explorer/status'}, run.notes)
        self.assertEqual([text for _, _, text in run.avoiding.those(run.end)], ['rotating'], 'no obstacle at all is infinitely far away')

    def test_the_track_is_in_the_frame_of_the_map(self):
        run = self.run_read
        self.assertAlmostEqual(run.track.length, 5.9, delta=0.1)
        self.assertEqual([round(number, 1) for number in run.track.at(run.begin + 30.5)], [3.0, 1.0])

    def test_places_are_found_at_once_among_very_many(self):
        run = Run()
        run.track.poses = [(float(time), 0.5 * time, 0.0, 0.0) for time in range(100000)]
        run.goals.places = [pose[:3] for pose in run.track.poses]
        run.goals.all = [goals.Goal(number, 100.0 * number + 0.4) for number in range(1000)]
        begin = time.process_time()
        found = [run.track.at(goal.sent) for goal in run.goals.all]
        run.goals.place_all()
        self.assertLess(time.process_time() - begin, 5.0)
        self.assertEqual([goal.place for goal in run.goals.all], found)
        self.assertEqual((found[7], run.track.at(-1.0), run.track.at(1e9)), ((350.0, 0.0), None, (49999.5, 0.0)))

    def test_changes_are_part_of_the_map(self):
        cells = self.run_read.map.cells
        self.assertEqual((cells[3, 2], cells[3, 3], cells[3, 4]), (0, 100, -1))
        self.assertEqual(self.run_read.map.free_area(), 0.25)

    def test_each_goal_has_its_outcome_and_its_place(self):
        outcomes = [goal.outcome for goal in self.run_read.goals.all]
        self.assertEqual(outcomes, [goals.REACHED, goals.DROPPED, goals.FAILED, goals.DROPPED])
        self.assertEqual([goal.place[0] for goal in self.run_read.goals.all], [5.0, 15.0, 25.0, 36.0])
        self.assertEqual(summary.goal_counts(self.run_read), (4, 1, 1, 2))

    def test_stops_contacts_recoveries_and_warnings_have_their_times(self):
        run = self.run_read
        self.assertEqual(since(run, run.stop.those(run.end)), [(20, 24)])
        self.assertEqual(since(run, run.contact.those(run.end)), [(40, 41)])
        self.assertEqual(since(run, run.recoveries()), [(30, 33)])
        finding, = run.warnings.diagnostics.values()
        self.assertEqual((finding.level, since(run, finding.spans)), ('WARN', [(10, 19)]))
        self.assertEqual([round(time - run.begin) for time, _ in run.warnings.loops], [45])
        self.assertEqual(since(run, dict(time_plots.driver_rows(run))['nav']), [(0, 20), (24, 60)])

    def test_the_summary_says_all_of_it_in_words(self):
        words = ' '.join(summary.sentences(self.run_read))
        for part in ('burger', '“small”', '1 min 0 s', '(20 s of real time)', '29.5 m²', '4 goals it reached 1,', 'ended by itself',
                     'everything within reach', '1 emergency stop, 1 contact and 1 recovery'):
            self.assertIn(part, words)

    def test_topics_of_a_robot_in_a_namespace_are_found(self):
        run = self.read(namespace='/robot1')
        self.assertEqual((len(run.goals.all), run.track.length > 5.0), (4, True))

    def test_one_of_several_robots_is_called_by_its_name(self):
        run = self.read()
        self.assertTrue(summary.subject(run).startswith('The robot'))
        run.start_info['namespace'] = '/robot1'
        self.assertTrue(summary.subject(run).startswith('The robot robot1'))

    def test_of_thousands_of_sources_those_that_drove_longest_have_a_row_and_the_others_are_counted(self):
        run = self.run_read
        run.source = States()
        for number in range(5000):
            run.source.add(run.begin + 0.01 * number, 'source %d' % number)
        run.source.add(run.begin + 50.0, 'nav')
        run.source.add(run.begin + 51.0, 'long')
        run.source.add(run.begin + 59.0, '')
        made = page(run, [], True, [])
        drawn = re.search('<svg[^>]*class="drivers".*?</svg>', made, re.DOTALL).group()
        self.assertEqual([name in drawn for name in ('>nav<', '>long<', '>source 4000<')], [True, True, False])
        self.assertLess(float(re.search(r'viewBox="0 0 [\d.]+ ([\d.]+)"', drawn).group(1)), 500.0)
        self.assertIn('and 4982 more, which were in command for less time', made)

    def test_cpu_and_memory_are_on_one_axis_of_time_and_anonymous_nodes_are_called_by_their_names(self):
        run = self.run_read
        times = [run.begin + second for second in (0.0, 20.0, 40.0)]
        for node, cpu, memory in (('/watch_exploration_5175_1796085781523', 0.1, 3e9), ('/rostopic_1796085781523141592', 0.2, 5.0),
                                  ('/floor_2', 0.3, 6.0)):
            run.load.nodes[node] = [(time, cpu, memory) for time in times]
        made = page(run, [], True, [])
        self.assertNotIn('1796085781523', made)
        drawn = re.search('<svg[^>]*class="load".*?</svg>', made, re.DOTALL).group()
        for name in ('watch_exploration', 'rostopic', 'floor_2'):
            self.assertEqual(drawn.count('>%s<' % name), 2, name)
            self.assertIn('<td>%s</td>' % name, made)
        sides = [re.search(r'id="load-axes_%d">.*?d="M ([\d.]+) [\d.]+ *\n?L ([\d.]+) ' % number, drawn, re.DOTALL).groups()
                 for number in (1, 2)]
        self.assertEqual(sides[0], sides[1])

    def test_a_run_of_many_statuses_takes_no_memory_for_the_frontiers_of_earlier_ones(self):
        path = self.path('frontiers.bag')
        with rosbag.Bag(path, 'w') as bag:
            for second in range(100):
                status = ExplorerStatus(frontiers=[FrontierStatus() for _ in range(100)])
                status.frontiers[0].centroid.x = second
                bag.write('/frontier_explorer/status', status, rospy.Time(100 + second))
        run = Run()
        with BagFiles([path]) as bags:
            tracemalloc.start()
            self.addCleanup(tracemalloc.stop)
            run.read(bags)
            self.assertLess(tracemalloc.get_traced_memory()[0], 3e6)
        self.assertEqual((len(run.explorer), len(run.frontiers), run.frontiers[0]), (100, 100, (99.0, 0.0)))

    def test_a_run_that_was_cut_off_says_so(self):
        run = self.read(seconds=30, with_end=False)
        self.assertIn('was not finished', summary.end_words(run))


class Lines(unittest.TestCase):
    def test_lines_that_differ_in_numbers_are_one_finding(self):
        warnings = Warnings()
        for time, text in ((0.0, '3 scans late'), (1.0, '4 scans late'), (60.0, '5 scans late')):
            warnings._note(warnings.diagnostics, 'mapper', 'WARN', text, time, 5.0)
        finding, = warnings.diagnostics.values()
        self.assertEqual((finding.text, finding.spans), ('3 scans late', [(0.0, 1.0), (60.0, 60.0)]))


class Parameters(FolderCase):
    TABLES = {'navigator': {'goal_tolerance': parameters.Described('double', '0.2', 'm', 'how near'),
                            'use_goal_yaw': parameters.Described('bool', 'false', '', '')},
              'mapper': {'map_file': parameters.Described('string', '', '', '')},
              'The robot': {'robot/limits/max_linear': parameters.Described('double', '0.22', 'm/s', 'speed')}}

    def differing(self, start, end=None):
        return [(setting.nodes, setting.name, setting.value, setting.default, setting.changed_to)
                for setting in parameters.differing(start, end or start, self.TABLES)]

    def test_only_what_differs_from_its_default_is_left(self):
        start = {'navigator': {'goal_tolerance': 0.2, 'use_goal_yaw': True}, 'mapper': {'map_file': ''}, 'rviz': {'x': 1}}
        self.assertEqual(self.differing(start), [(['navigator'], 'use_goal_yaw', True, 'false', None)])

    def test_the_default_has_its_unit_as_the_value_has_and_a_long_path_may_be_broken(self):
        settings = parameters.differing({'navigator': {'goal_tolerance': 0.3}, 'mapper': {'map_file': '/tmp/floor.yaml'}}, {}, self.TABLES)
        made = parameters_section(settings, True)
        self.assertIn('<td class="value">0.3 m</td><td class="value">0.2 m</td>', made)
        self.assertIn('/<wbr>tmp/<wbr>floor.yaml', made)

    def test_what_many_nodes_share_stands_once(self):
        limits = {'robot': {'limits': {'max_linear': 0.5}}}
        self.assertEqual(self.differing({'mapper': limits, 'navigator': limits}),
                         [(['mapper', 'navigator'], 'robot/limits/max_linear', 0.5, '0.22', None)])

    def test_limits_that_override_the_robots_have_the_defaults_of_those(self):
        self.assertEqual(self.differing({'mapper': {'limits': {'max_linear': 0.22}}}), [])

    def test_a_value_that_changed_during_the_run_is_there_even_if_it_began_as_the_default(self):
        self.assertEqual(self.differing({'navigator': {'goal_tolerance': 0.2}}, {'navigator': {'goal_tolerance': 0.4}}),
                         [(['navigator'], 'goal_tolerance', 0.2, '0.2', 0.4)])

    def test_a_parameter_that_was_first_set_during_the_run_is_there(self):
        self.assertEqual(self.differing({'navigator': {'use_goal_yaw': True}}, {'navigator': {'use_goal_yaw': True, 'goal_tolerance': 0.4}}),
                         [(['navigator'], 'goal_tolerance', '0.2', '0.2', 0.4), (['navigator'], 'use_goal_yaw', True, 'false', None)])
        self.assertEqual(self.differing({'rviz': {}}, {'navigator': {'goal_tolerance': 0.4, 'unknown': 1}}),
                         [(['navigator'], 'goal_tolerance', '0.2', '0.2', 0.4)])
        self.assertEqual(self.differing({}, {'navigator': {'goal_tolerance': 0.2}}), [])

    def test_a_limit_that_was_first_set_during_the_run_was_the_robots_before(self):
        robot = {'robot': {'limits': {'max_linear': 0.26}}}
        self.assertIn((['mapper'], 'limits/max_linear', 0.26, '0.22', 0.1),
                      self.differing({'mapper': robot}, {'mapper': dict(robot, limits={'max_linear': 0.1})}))

    def test_each_item_of_a_list_has_its_own_default(self):
        table = {'sources[i]/name': parameters.Described('string', 'avoid, nav', '', ''),
                 'sources[i]/timeout': parameters.Described('double', '1', 's', '')}
        start = {'cmd_vel_arbiter': {'sources': [{'name': 'avoid'}, {'name': 'nav', 'timeout': 2.0}]}}
        found = parameters.differing(start, start, {'cmd_vel_arbiter': table})
        self.assertEqual([(setting.name, setting.value, setting.default) for setting in found], [('sources[1]/timeout', 2.0, '1')])

    def test_the_tables_of_the_documentation_are_understood(self):
        import pathlib
        path = pathlib.Path(__file__).resolve().parents[3] / 'docs/parameters.md'
        tables = parameters.read_tables(str(path))
        self.assertEqual(tables['The robot']['robot/limits/max_linear'].unit, 'm/s')
        self.assertTrue(parameters.same([0.037, 0.089, -0.101, 0.089, -0.101, -0.089, 0.037, -0.089],
                                        tables['The robot']['robot/outline'].default))
        for section in ('simulator', 'mapper', 'navigator', 'frontier_explorer', 'cmd_vel_arbiter'):
            self.assertGreater(len(tables[section]), 5, section)


if __name__ == '__main__':
    unittest.main()
