#!/usr/bin/env python3
"""What watch_exploration.py takes, when it starts the exploration, and when it saves the map again."""
import io
import pathlib
import signal
import subprocess
import sys
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'scripts'))
import watch_exploration  # noqa: E402
from frontier_pilot.msg import ExplorerStatus  # noqa: E402
from std_msgs.msg import Bool  # noqa: E402


class Words(unittest.TestCase):
    def test_a_folder_is_no_map(self):
        """[FLT-1]"""
        for path in ('/tmp', '.', 'maps/', '~/'):
            with self.subTest(path=path):
                done = subprocess.run([str(ROOT / 'scripts/watch_exploration.py'), '--map=' + path, '__master:=nowhere'], timeout=60,
                                      stdin=subprocess.DEVNULL, capture_output=True, text=True)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, '^watch_exploration.py: argument --map: .* is a folder; .*/floor;')

    def test_a_period_in_which_no_line_can_be_printed_is_refused(self):
        """[FLT-1]"""
        for period in ('nan', 'inf', '-1', '0.1', '3601', 'often'):
            with self.subTest(period=period):
                done = subprocess.run([str(ROOT / 'scripts/watch_exploration.py'), '--period=' + period, '__master:=nowhere'], timeout=60,
                                      stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                self.assertEqual((done.returncode, done.stdout), (2, ''))
                self.assertRegex(done.stderr, '^watch_exploration.py: argument --period: .*%s.*\n$' % period.lstrip('-'))


class Later(unittest.TestCase):
    def saved(self, *statuses, before=True):
        """To which paths a watcher saves that hears these one by one, and is told to end after the last one."""
        watcher, interrupt = mock.Mock(status=None), mock.Mock(number=0)
        left = list(statuses)

        def go_on(_):
            if left:
                watcher.status = left.pop(0)
            else:
                interrupt.number = 15
        with mock.patch('watch_exploration.time.sleep', go_on), mock.patch('sys.stdout', io.StringIO()), \
                mock.patch('rospy.is_shutdown', return_value=False), mock.patch('watch_exploration.save_map') as save:
            self.assertEqual(watch_exploration.save_at_the_end(watcher, interrupt, '', before), 143)
        return [call[0][0] for call in save.call_args_list]

    def test_what_was_mapped_after_the_exploration_is_saved_when_all_ends(self):
        done = ExplorerStatus(explored_area=50.0, distance_travelled=30.0)
        self.assertEqual(self.saved(done, done), [])
        self.assertEqual(self.saved(), [])
        self.assertEqual(self.saved(done, ExplorerStatus(explored_area=52.0, distance_travelled=30.0)), [''])
        self.assertEqual(self.saved(done, done, ExplorerStatus(explored_area=50.0, distance_travelled=33.0)), [''])

    def test_what_could_not_be_saved_is_saved_when_all_ends_although_nothing_has_changed(self):
        """[FLT-2]"""
        done = ExplorerStatus(explored_area=50.0, distance_travelled=30.0)
        self.assertEqual(self.saved(done, done, before=False), [''])


class Abandoned(unittest.TestCase):
    """It was started by a program that was killed, and the nodes have ended too: it does not go on for ever."""

    def setUp(self):
        self.parent, self.clock, self.out = 7, 100.0, io.StringIO()
        self.saves, self.steps, self.master_lives, self.subscriptions = [], [], True, 0
        for patch in (mock.patch('ros_program.is_master_online', lambda _: self.master_lives),
                      mock.patch('sys.stdout', self.out), mock.patch('sys.argv', ['watch_exploration.py']),
                      mock.patch('rospy.Subscriber', self.subscribe), mock.patch('rospy.is_shutdown', lambda: False),
                      mock.patch('watch_exploration.Interrupt', lambda: mock.Mock(number=0)),
                      mock.patch('watch_exploration.os.getppid', lambda: self.parent),
                      mock.patch('watch_exploration.save_map', self.saves.append),
                      mock.patch('watch_exploration.time.monotonic', lambda: self.clock),
                      mock.patch('watch_exploration.time.sleep', self.sleep)):
            patch.start()
            self.addCleanup(patch.stop)

    def subscribe(self, _topic, _kind, take, **_):
        self.take = take
        self.subscriptions += 1
        return mock.Mock()

    def sleep(self, seconds):
        self.clock += seconds
        if self.steps and self.clock >= self.steps[0][0]:
            self.steps.pop(0)[1]()
        if self.clock > 1000.0:
            raise TimeoutError(self.out.getvalue())

    def orphan(self):
        self.parent = 1

    def begin(self, _name, wanted, **_):
        while self.master_at > self.clock and wanted():
            self.sleep(0.3)
        return wanted()

    def run_it(self, master_at=0.0):
        self.master_at = master_at
        with mock.patch('ros_program.begin', self.begin):
            return watch_exploration.main()

    def test_it_saves_the_map_and_ends_half_a_minute_after_the_explorer_was_heard(self):
        """[FLT-1]"""
        first, second, latched = (ExplorerStatus(explored_area=50.0) for _ in range(3))
        second.header.stamp.secs = latched.header.stamp.secs = 15
        self.steps = [(110.0, lambda: self.take(first)), (120.0, self.orphan), (125.0, lambda: self.take(second)),
                      (140.0, lambda: self.take(latched))]  # as whenever it listens again
        self.assertEqual(self.run_it(), 1)
        self.assertEqual(self.saves, [''])
        self.assertAlmostEqual(self.clock, 155.0, delta=1.0)
        self.assertIn('the explorer has not been heard for 10 s', self.out.getvalue())
        self.assertIn('The explorer is gone, and so is the program that has started this one: saving the map', self.out.getvalue())

    def test_it_ends_if_the_explorer_or_the_master_never_came(self):
        """[FLT-1]"""
        for master_at in (0.0, 10000.0):
            with self.subTest(master_at=master_at):
                self.parent, self.clock = 7, 100.0
                self.steps = [(110.0, self.orphan)]
                self.assertEqual(self.run_it(master_at), 1)
                self.assertEqual(self.saves, [])
                self.assertAlmostEqual(self.clock, 130.0, delta=1.0)

    def test_it_says_that_the_master_is_gone(self):
        """[FLT-1]"""
        self.steps = [(110.0, lambda: setattr(self, 'master_lives', False)), (115.0, self.orphan)]
        self.run_it()
        self.assertRegex(self.out.getvalue(), 'the explorer has not been heard for 1[05] s: no ROS master answers at http://')

    def test_it_waits_for_an_explorer_that_has_died_while_somebody_waits_for_it(self):
        done = ExplorerStatus(explored_area=50.0, state=ExplorerStatus.DONE, reason=ExplorerStatus.NO_REACHABLE_FRONTIER)
        self.steps = [(110.0, lambda: self.take(ExplorerStatus(explored_area=40.0))), (700.0, lambda: self.take(done))]
        self.run_it()
        self.assertEqual(self.saves, [''])
        self.assertIn('the explorer has not been heard for 585 s', self.out.getvalue())
        self.assertGreater(self.subscriptions, 50, 'the master may be another one by now')

    def test_it_hears_the_explorer_of_another_master_also_when_only_the_last_map_is_to_be_saved(self):
        self.steps = [(110.0, lambda: self.take(ExplorerStatus(explored_area=40.0))), (140.0, self.orphan)]
        with mock.patch('sys.argv', ['watch_exploration.py', '--saved-already']):
            self.run_it()
        self.assertGreater(self.subscriptions, 3, 'the master may be another one by now')

    def test_it_says_at_the_start_that_the_folder_of_the_map_is_not_there(self):
        """[FLT-2]"""
        for path, said in (('/nowhere/floor', '^watch_exploration: there is no folder /nowhere here; .*\n$'), ('/tmp/floor', '^$')):
            err = io.StringIO()
            self.parent, self.steps = 7, [(self.clock + 10.0, self.orphan)]
            with self.subTest(path=path), mock.patch('sys.argv', ['watch_exploration.py', '--map', path]), mock.patch('sys.stderr', err):
                self.run_it()
                self.assertRegex(err.getvalue(), said)


class TwoSignals(unittest.TestCase):
    def second_after(self, seconds):
        """Whether a second Ctrl-C so long after the first one ends the program at once."""
        clock = [100.0]
        with mock.patch('signal.signal'), mock.patch('watch_exploration.time.monotonic', lambda: clock[0]), \
                mock.patch('watch_exploration.os._exit') as end:
            interrupt = watch_exploration.Interrupt()
            interrupt.take(signal.SIGINT, None)
            clock[0] += seconds
            interrupt.take(signal.SIGINT, None)
            self.assertEqual(interrupt.number, signal.SIGINT)
        return end.called

    def test_of_which_both_come_together_are_one(self):
        self.assertFalse(self.second_after(0.001))
        self.assertTrue(self.second_after(1.0))


class Line(unittest.TestCase):
    def test_a_line_about_a_paused_exploration_says_how_it_goes_on(self):
        way_out = 'IDLE: paused; "rosservice call /set_exploration_enabled true" resumes it'
        paused = {'reason': ExplorerStatus.PAUSED, 'state_text': 'IDLE', 'reason_text': 'paused'}
        with mock.patch('rospy.Subscriber'), mock.patch('rospy.resolve_name', lambda name: '/' + name):
            watcher = watch_exploration.Watcher(5.0)
            watcher.on_status(ExplorerStatus(**paused))
            self.assertNotIn(way_out, watcher.line(), 'it has not begun')
            watcher.on_status(ExplorerStatus(goals_sent=1, **paused))
            self.assertIn(way_out, watcher.line())
            watcher.on_status(ExplorerStatus(goals_sent=1, reason=ExplorerStatus.GOAL_SENT))
            self.assertNotIn('rosservice', watcher.line())

    def test_a_line_says_that_the_exploration_waits_for_the_recorder(self):
        paused = ExplorerStatus(reason=ExplorerStatus.PAUSED, state_text='IDLE', reason_text='paused')
        with mock.patch('rospy.Subscriber'):
            watcher = watch_exploration.Watcher(5.0)
            watcher.on_status(paused)
            self.assertTrue(watcher.line().endswith('IDLE: paused'), 'nothing is to be recorded')
            watcher.starter = watch_exploration.Starter()
            self.assertTrue(watcher.line().endswith('IDLE: waiting for the recorder'), watcher.line())
            watcher.on_status(ExplorerStatus(reason=ExplorerStatus.EMERGENCY_STOP, state_text='IDLE', reason_text='emergency stop'))
            self.assertTrue(watcher.line().endswith('IDLE: emergency stop'), watcher.line())
            watcher.starter.settled = True  # the exploration was started, or the robot was stopped
            watcher.on_status(paused)
            self.assertTrue(watcher.line().endswith('IDLE: paused'), watcher.line())


class Start(unittest.TestCase):
    def setUp(self):
        self.calls, self.clock = [], 100.0
        self.out = io.StringIO()
        for patch in (mock.patch('sys.stdout', self.out), mock.patch('rospy.resolve_name', lambda name: '/' + name),
                      mock.patch('rospy.Subscriber', self.subscribe), mock.patch('rospy.ServiceProxy', lambda name, _: self.serve(name)),
                      mock.patch('watch_exploration.time.monotonic', lambda: self.clock)):
            patch.start()
            self.addCleanup(patch.stop)
        self.listeners = {}
        self.starter = watch_exploration.Starter()

    def subscribe(self, topic, _, take, **__):
        self.listeners[topic] = take

    def serve(self, name):
        def call(on):
            self.calls.append((name, on))
            return mock.Mock(success=True)
        return call

    def go_on(self, recorded, state=ExplorerStatus.IDLE):
        self.clock += 2.0
        self.starter.recorder_is_ready = lambda: recorded
        self.starter.go_on(ExplorerStatus(state=state))

    def test_the_exploration_starts_when_it_is_recorded(self):
        self.go_on(False)
        self.assertEqual(self.calls, [])
        self.go_on(True)
        self.go_on(True)
        self.assertEqual(self.calls, [('set_exploration_enabled', True)])

    def test_a_stop_is_not_overridden_by_the_start_also_if_it_was_cleared(self):
        """[ARB-8]"""
        self.go_on(False)
        for stopped in (False, True, False):
            self.listeners['emergency_stop_state'](Bool(stopped))
        for _ in range(30):
            self.go_on(True)
        self.assertEqual(self.calls, [])
        self.assertEqual(self.out.getvalue(), 'The robot was stopped: the exploration is not started any more; when the stop is cleared, '
                         '"rosservice call /set_exploration_enabled true" starts it\n')

    def test_an_arbiter_that_is_not_stopped_does_not_keep_it_from_starting(self):
        self.listeners['emergency_stop_state'](Bool(False))
        self.go_on(True)
        self.assertEqual(len(self.calls), 1)

    def test_what_an_operator_has_started_is_left_to_him(self):
        self.go_on(False, ExplorerStatus.SELECT_GOAL)
        self.go_on(True)
        self.assertEqual((self.calls, self.out.getvalue()), ([], ''))


if __name__ == '__main__':
    unittest.main()
