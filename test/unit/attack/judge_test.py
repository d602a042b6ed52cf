#!/usr/bin/env python3
"""The verdict on stops, the stream of the probe and the timetable of the attack on the stop."""
import pathlib
import struct
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from run_attack.judge import Call, Message, held_time, stopped_spans, violations  # noqa: E402
from run_attack.timetable import CYCLE, DRIVING, LULL, Timetable  # noqa: E402


def stop(begin, answer):
    return Call(True, begin, answer)


def clear(begin, answer):
    return Call(False, begin, answer)


def moving(at, wait=0.001):
    return Message(at - wait, at, True)


class Judge(unittest.TestCase):
    """[ARB-7]"""
    calls = [stop(1.0, 1.1), clear(3.0, 3.1)]

    def test_a_command_that_moves_while_the_stop_holds_is_a_violation(self):
        self.assertEqual(violations([moving(2.0)], self.calls), [moving(2.0)])

    def test_before_the_answer_and_after_the_begin_of_the_clear_the_robot_may_move(self):
        self.assertEqual(violations([moving(0.5), moving(1.05), moving(3.05), moving(5.0)], self.calls), [])

    def test_zeros_are_no_violation(self):
        self.assertEqual(violations([Message(1.999, 2.0, False)], self.calls), [])

    def test_a_message_that_may_have_been_on_its_way_when_the_stop_was_answered_shows_nothing(self):
        self.assertEqual(violations([Message(1.05, 1.9, True)], self.calls), [], 'the probe slept')
        self.assertEqual(violations([Message(1.103, 1.11, True)], self.calls), [], 'within the transport')
        self.assertEqual(len(violations([Message(1.106, 1.11, True)], self.calls)), 1)

    def test_a_message_that_was_read_after_the_clear_began_shows_nothing(self):
        self.assertEqual(violations([Message(2.0, 3.01, True)], self.calls), [])

    def test_a_stop_that_a_clear_overlaps_may_have_been_served_first(self):
        overlapping = [stop(1.0, 1.1), clear(1.05, 1.2)]
        self.assertEqual(stopped_spans(overlapping), ([], 0))
        self.assertEqual(violations([moving(2.0)], overlapping), [])
        self.assertEqual(stopped_spans([stop(1.0, 1.1), clear(0.9, 1.05)])[1], 0)

    def test_a_long_clear_is_not_hidden_by_a_short_one_that_began_later(self):
        self.assertEqual(stopped_spans([stop(1.0, 1.1), clear(0.1, 1.05), clear(0.2, 0.3)])[1], 0)

    def test_a_clear_that_was_answered_before_the_stop_began_ends_nothing(self):
        self.assertEqual(stopped_spans([clear(0.1, 0.9), stop(1.0, 1.1)]), ([(1.1, float('inf'))], 1))

    def test_several_stops_make_one_span_until_the_next_clear(self):
        calls = [stop(1.0, 1.1), stop(1.05, 1.3), stop(2.0, 2.1), clear(3.0, 3.1), stop(4.0, 4.1)]
        self.assertEqual(stopped_spans(calls), ([(1.1, 3.0), (4.1, float('inf'))], 4))
        self.assertAlmostEqual(held_time(calls, 5.1), 1.9 + 1.0)
        self.assertEqual(len(violations([moving(2.5), moving(3.05), moving(4.5)], calls)), 2)


class ProbeStream(unittest.TestCase):
    def setUp(self):
        from run_attack.probe import Stream
        self.stream = Stream(1.0)

    @staticmethod
    def twist(linear):
        return struct.pack('<I6d', 48, linear, 0.0, 0.0, 0.0, 0.0, 0.0)

    def test_messages_are_cut_out_with_the_time_at_which_the_socket_was_empty(self):
        self.assertEqual(self.stream.add(self.twist(0.1) + self.twist(-0.0), 2.0), [(1.0, 2.0, True), (1.0, 2.0, False)])
        self.stream.found_empty(2.5)
        self.assertEqual(self.stream.add(self.twist(0.1), 3.0), [(2.5, 3.0, True)])

    def test_of_a_message_in_two_pieces_the_first_piece_counts(self):
        data = self.twist(0.1)
        self.assertEqual(self.stream.add(data[:10], 2.0), [])
        self.stream.found_empty(2.5)
        self.assertEqual(self.stream.add(data[10:], 3.0), [(1.0, 3.0, True)])


class SharedTimetable(unittest.TestCase):
    def test_it_is_the_same_for_all_who_know_the_seed(self):
        first, second = Timetable(3, 100.0), Timetable(3, 100.0)
        times = [100.0 + 0.037 * i for i in range(1000)]
        self.assertEqual([first.source_drives(2, now) for now in times], [second.source_drives(2, now) for now in times])

    def test_no_source_drives_and_nobody_stops_before_the_robot_moves_again(self):
        timetable = Timetable(1, 0.0)
        for cycle in range(20):
            quiet = cycle * CYCLE + DRIVING + 0.01
            self.assertFalse(any(timetable.source_drives(source, quiet) for source in range(5)))
            self.assertFalse(timetable.stops_are_called(cycle * CYCLE + LULL + 0.01))
            self.assertTrue(timetable.stops_are_called(cycle * CYCLE + 1.0))


if __name__ == '__main__':
    unittest.main()
