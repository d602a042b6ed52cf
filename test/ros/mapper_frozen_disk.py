#!/usr/bin/env python3
"""A disk under ROS_HOME that hangs, as one of a server that is away, holds up no reset, no save to another disk, and no end of the mapper,
and leaves no map that was replaced meanwhile."""
import os
import pathlib
import re
import signal
import tempfile
import threading
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.srv import LoadMap, SaveMap
from std_srvs.srv import Trigger

from mapper_case import SMALL, MapperCase, kept_maps
from wire import SANITIZED, Node, Record, call, find_node, use_a_home_of_its_own, wait_for

LIBRARY = os.path.join(os.path.dirname(find_node('frontier_pilot', 'mapper')), '..', 'libhanging_disk.so')


@unittest.skipIf(SANITIZED, 'no library may be loaded before that of the sanitizer')
class MapperOnAFrozenDisk(MapperCase):
    def setUp(self):
        super().setUp()
        disk = os.path.join(os.environ['ROS_HOME'], 'frontier_pilot')
        self.hangs = pathlib.Path(disk + '.hangs')
        self.mapper = Node('mapper', environment=dict(os.environ, HANGING_DISK=disk, LD_PRELOAD=LIBRARY))
        self.addCleanup(self.mapper.process.kill)
        self.addCleanup(lambda: self.hangs.unlink() if self.hangs.exists() else None)
        self.assertTrue(self.keeps_a_map(), self.mapper.said())

    def keeps_a_map(self):
        """Whether it keeps one from now on."""
        start = time.time_ns()
        return wait_for(lambda: self.drive() or any(written > start for written in kept_maps()), 20.0)

    # [FLT-1] [FLT-2]
    def test_a_reset_does_not_wait_and_what_is_kept_after_it_stays(self):
        self.hangs.touch()
        answers = []
        asking = threading.Thread(target=lambda: answers.append(call('mapper/reset', Trigger)), daemon=True)
        asking.start()
        asking.join(10.0)
        self.assertTrue(answers and answers[0].success, 'the reset waits for the disk [FLT-1]')
        self.forget_the_map()
        self.assertTrue(wait_for(lambda: self.drive() or self.known() > 0, 10.0), 'the mapper goes on [FLT-1]')
        self.hangs.unlink()
        self.assertTrue(self.keeps_a_map(), self.mapper.said())
        wait_for(lambda: self.drive() and False, 1.0)
        self.assertTrue(kept_maps(), 'the map of after the reset is kept [FLT-2]')
        self.mapper.end()
        self.assertEqual(kept_maps(), set(), 'an end in order leaves none')

    # [FLT-2] [MAP-5]
    def test_a_map_that_was_replaced_meanwhile_does_not_come_back(self):
        self.hangs.touch()
        answer = call('mapper/load_map', LoadMap, SMALL)
        self.assertTrue(answer.success)
        self.assertIn('; would not survive this node: it is still being saved', answer.message, '[FLT-2]')
        self.mapper.signal(signal.SIGKILL)
        self.mapper.finish()
        self.hangs.unlink()
        self.forget_the_map()
        mapper = Node('mapper')
        self.addCleanup(mapper.end)
        rospy.wait_for_service('mapper/reset', 15.0)
        self.assertFalse(wait_for(lambda: self.say_where() and self.known() > 0, 3.0), 'the map of before [MAP-5]')
        self.assertRegex(mapper.said(), r'/lost[.0-9]*/kept_map\.mapper', 'nothing is lost [FLT-2]')

    # [FLT-1]
    def test_a_save_to_it_is_named_and_holds_up_no_save_to_another_one(self):
        hung = os.path.join(os.environ['ROS_HOME'], 'frontier_pilot', 'floor')
        diagnostics = Record('/diagnostics', DiagnosticArray)

        def is_named():
            words = 'saving to %s has not ended for' % hung
            return any(words in status.message for _, array in list(diagnostics.items) for status in array.status)
        self.hangs.touch()
        answers = []
        asking = threading.Thread(target=lambda: answers.append(call('mapper/save_map', SaveMap, hung)), daemon=True)
        asking.start()
        self.assertTrue(wait_for(is_named, 20.0), 'nothing says that a save hangs [FLT-1]')
        with tempfile.TemporaryDirectory() as folder:
            answer = call('mapper/save_map', SaveMap, os.path.join(folder, 'floor'))
            self.assertTrue(answer.success, answer.message)
        asking.join(60.0)
        self.assertTrue(answers, 'a save waits for the disk for ever [FLT-1]')
        self.assertFalse(answers[0].success)
        self.assertIn('saving to %s has not ended' % hung, answers[0].message)

    # [FLT-2] [MAP-5]
    def test_a_copy_that_is_still_being_written_at_the_end_is_named(self):
        self.assertFalse(call('mapper/save_map', SaveMap, '/proc/nowhere/floor').success)
        self.hangs.touch()
        wait_for(lambda: self.drive() and False, 1.0)
        self.mapper.signal(signal.SIGINT)
        self.assertTrue(wait_for(lambda: 'its copy is still being written' in self.mapper.said(), 30.0), self.mapper.said())
        said = self.mapper.said()
        self.hangs.unlink()
        self.mapper.finish(30.0)
        kept = re.search(r'the map was not saved, /proc/nowhere.*: map_file:=(\S+)\.yaml begins with it, or with an older one', said)
        self.assertTrue(kept and os.path.exists(kept.group(1) + '.bt'), said)

    # [FLT-1]
    def test_the_end_does_not_wait(self):
        self.hangs.touch()
        self.mapper.signal(signal.SIGINT)
        self.assertTrue(wait_for(self.mapper.has_ended, 30.0), 'the end waits for the disk')


if __name__ == '__main__':
    use_a_home_of_its_own()
    os.environ['XDG_RUNTIME_DIR'] = os.path.join(os.environ['ROS_HOME'], 'spare')  # does not hang
    os.mkdir(os.environ['XDG_RUNTIME_DIR'])
    rospy.init_node('mapper_frozen_disk')
    rostest.rosrun('frontier_pilot', 'mapper_frozen_disk', MapperOnAFrozenDisk)
