#!/usr/bin/env python3
"""Which reports of ThreadSanitizer are this project's."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from thread_reports import SEPARATOR, sort  # noqa: E402

ROOT = pathlib.Path('/house')
BUILD = ROOT / 'build/thread'
INTERCEPTOR = 'operator delete(void*) ../../../../src/libsanitizer/tsan/tsan_new_delete.cpp:150 (libtsan.so.2+0x86c3d)'
INLINED = 'std::vector<int>::size() const /usr/include/c++/12/bits/stl_vector.h:987 (mapper+0x10)'
MESSAGE = 'frontier_pilot::Claim_<std::allocator<void> >::~Claim_() devel/include/frontier_pilot/Claim.h:20 (mapper+0x14)'
OURS = 'frontier_pilot::Worker::take() ../../src/ros/common/worker.cpp:30 (mapper+0x20)'
OURS_ABSOLUTE = 'frontier_pilot::Worker::work() /house/src/ros/common/worker.cpp:50 (mapper+0x30)'
ROSCPP = 'ros::Connection::writeTransport() <null> (libroscpp.so.4d+0xa8b71)'


def stack(heading, *frames):
    return f'  {heading}:\n' + ''.join(f'    #{number} {frame}\n' for number, frame in enumerate(frames))


def report(kind, *stacks):
    return '\n'.join([SEPARATOR, f'WARNING: ThreadSanitizer: {kind} (pid=7)', *stacks, SEPARATOR, ''])


def race(first, second, *about):
    return report('data race', stack('Write of size 8 at 0x7b08 by thread T1', *first),
                  stack('Previous read of size 8 at 0x7b08 by main thread', *second), *about)


def cycle(first_thread, second_thread, *frames):
    return report('lock-order-inversion (potential deadlock)',
                  stack(f'Mutex M2 acquired here while holding mutex M1 in {first_thread}', *frames),
                  stack('Mutex M1 previously acquired by the same thread here', ROSCPP),
                  stack(f'Mutex M1 acquired here while holding mutex M2 in {second_thread}', ROSCPP))


def sorted_reports(*texts):
    return sort([(f'thread.{number}', text) for number, text in enumerate(texts)], BUILD, ROOT)


def said(*texts):
    return dict(sorted_reports(*texts)[0])


class ThreadReports(unittest.TestCase):
    def test_a_race_is_ours_if_both_accesses_are(self):
        self.assertEqual(said(race([OURS], [OURS_ABSOLUTE])),
                         {'data race: src/ros/common/worker.cpp: frontier_pilot::Worker::take() | '
                          'src/ros/common/worker.cpp: frontier_pilot::Worker::work()': ['thread.0']})

    def test_what_is_inlined_or_generated_belongs_to_its_caller(self):
        self.assertEqual(len(said(race([INTERCEPTOR, INLINED, MESSAGE, OURS], [INLINED, OURS_ABSOLUTE]))), 1)
        self.assertEqual(said(race([INTERCEPTOR, INLINED, ROSCPP, OURS], [INLINED, OURS])), {})

    def test_a_buffer_of_roscpp_is_its_own_wherever_it_is_let_go(self):
        buffer = 'ros::SerializedMessage::~SerializedMessage() /usr/include/ros/serialized_message.h:39 (mapper+0x3f68c)'
        publish = 'void ros::Publisher::publish<Claim>(Claim const&) const /usr/include/ros/publisher.h:90 (mapper+0x3f700)'
        self.assertEqual(said(race([INTERCEPTOR, INLINED, buffer, publish, OURS], [OURS])), {})
        self.assertEqual(len(said(race([INTERCEPTOR, INLINED, publish, OURS], [OURS]))), 1, 'what is published may be shared')

    def test_a_race_with_an_access_of_a_library_is_counted_with_the_others(self):
        self.assertEqual(sorted_reports(race([OURS], [ROSCPP, OURS]) + race([ROSCPP], [ROSCPP])), ({}, 2))

    def test_where_a_thread_or_a_mutex_was_made_does_not_make_a_race_ours(self):
        about = stack('Mutex M1 (0x7b48) created at', OURS), stack("Thread T1 'x' (tid=3, running) created by main thread at", OURS)
        self.assertEqual(said(race([ROSCPP], [ROSCPP], *about)), {})

    def test_a_leaked_thread_is_ours_if_it_was_made_here(self):
        self.assertEqual(len(said(report('thread leak', stack("Thread T1 (tid=3, finished) created by main thread at", OURS)))), 1)

    def test_a_cycle_of_mutexes_is_ours_if_one_lock_is(self):
        self.assertEqual(len(said(cycle('main thread', 'thread T4', INTERCEPTOR, OURS))), 1)
        self.assertEqual(said(cycle('main thread', 'thread T4', INTERCEPTOR, ROSCPP)), {})

    def test_a_cycle_in_one_thread_is_none(self):
        self.assertEqual(said(cycle('main thread', 'main thread', OURS)), {})

    def test_equal_reports_of_several_processes_are_one_line(self):
        self.assertEqual(list(said(race([OURS], [OURS]), race([OURS], [OURS])).values()), [['thread.0', 'thread.1']])

    def test_what_a_build_folder_or_a_system_folder_holds_is_not_ours(self):
        for path in ('/house/build/thread/x.cpp', '/usr/src/gtest/gtest.cc', '../../../elsewhere/src/x.cpp', '<null>'):
            self.assertEqual(said(race([f'f() {path}:3 (x+0x1)'], [OURS])), {}, path)


if __name__ == '__main__':
    unittest.main()
