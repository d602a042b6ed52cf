#!/usr/bin/env python3
"""The map that a mapper leaves behind when it dies: never long behind, taken up again, and gone after an end in order."""
import os
import re
import resource
import shutil
import signal
import threading
import time

import rospy
import rostest
from frontier_pilot.srv import LoadMap, SaveMap
from nav_msgs.srv import GetMap
from std_srvs.srv import Trigger

from mapper_case import SMALL, MapperCase, kept_maps, newest_map, poses_of_the_session, written_maps
from wire import Node, call, use_a_home_of_its_own, wait_for


class MapperAutosave(MapperCase):
    def test_the_map_is_kept_every_two_seconds_and_taken_up_after_a_death_only(self):  # [FLT-2]
        floor = shutil.copytree(os.path.dirname(SMALL), os.path.join(os.environ['ROS_HOME'], 'floors'))
        file = '_map_file:=' + os.path.join(floor, 'small.yaml')
        mapper = Node('mapper', file)
        self.assertTrue(call('mapper/reset', Trigger).success)
        self.addCleanup(lambda: mapper.end())
        written, end = set(), time.monotonic() + 60.0  # it rests for 20 times as long as a save takes
        while time.monotonic() < end and len(written) < 4:
            self.drive()
            written |= kept_maps()
        self.assertGreaterEqual(len(written), 4, 'again and again [FLT-2]')
        self.assertLess(time.monotonic(), end)
        before = self.known()
        self.assertGreater(before, 5000)
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        self.forget_the_map()
        shutil.rmtree(floor)
        mapper = Node('mapper', file)  # its copy is worth more than the file, which is gone
        # Without a scan: what the map shows is what was kept.
        self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0, 20.0))
        self.assertGreater(self.known(), 0.95 * before, '[FLT-2]')
        mapper.end()
        self.assertFalse(written_maps(), 'an end in order leaves none')

    def test_a_map_is_taken_up_also_if_the_name_of_the_session_changes_before_the_mapper_dies(self):  # [FLT-2]
        name = rospy.get_param('/run_id')
        self.addCleanup(rospy.set_param, '/run_id', name)
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        for other in ('another', None):
            before = self.known()
            rospy.set_param('/run_id', other) if other else rospy.delete_param('/run_id')
            mapper.signal(signal.SIGKILL)
            mapper.finish()
            self.forget_the_map()
            mapper = Node('mapper')
            self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0, 20.0), other)
            self.assertGreater(self.known(), 0.95 * before, '[FLT-2]')
            self.assertTrue(wait_for(lambda: self.drive() or kept_maps(), 20.0))

    def test_a_map_that_was_loaded_or_reset_before_the_first_odometry_stays(self):  # [FLT-2]
        for service, *request in (('mapper/reset', Trigger), ('mapper/load_map', LoadMap, SMALL)):
            self.leave_a_map()
            mapper = Node('mapper')
            self.addCleanup(mapper.end)
            self.assertTrue(call(service, *request).success)
            self.assertTrue(wait_for(lambda: self.odometry.get_num_connections() > 0))
            self.assertTrue(service == 'mapper/reset' or wait_for(lambda: self.known() > 0, 10.0))
            known = self.known()
            wait_for(lambda: self.say_where() and False, 3.0)
            self.assertEqual(self.known(), known, 'the map of before is not put back [FLT-2]')
            mapper.end()

    @staticmethod
    def save_unless_killed():
        """The thread of the mapper that answers this also saves the copy."""
        try:
            rospy.ServiceProxy('mapper/save_map', SaveMap)(os.environ['ROS_HOME'] + '/saved')
        except rospy.ServiceException:
            pass

    @staticmethod
    def load_unless_killed():
        try:
            rospy.ServiceProxy('mapper/load_map', LoadMap)(SMALL)
        except rospy.ServiceException:
            pass

    def test_a_map_that_was_loaded_is_kept_when_the_mapper_dies_just_after_its_answer(self):  # [FLT-2]
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        for _ in range(3):
            saving = threading.Thread(target=self.save_unless_killed)
            saving.start()
            self.assertTrue(call('mapper/load_map', LoadMap, SMALL).success)
            mapper.signal(signal.SIGKILL)
            saving.join()
            mapper.finish()
            self.assertTrue(kept_maps())
            self.forget_the_map()
            mapper = Node('mapper')
            self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0, 20.0), '[FLT-2]')

    def test_a_loaded_map_that_cannot_be_kept_is_said_and_that_of_before_does_not_come_back(self):  # [FLT-2]
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        self.assertTrue(call('mapper/reset', Trigger).success)
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        kept = newest_map()
        # As on a full disk: a file may only have so many bytes.
        resource.prlimit(mapper.process.pid, resource.RLIMIT_FSIZE, (512, resource.RLIM_INFINITY))
        answer = call('mapper/load_map', LoadMap, SMALL)
        self.assertTrue(answer.success)
        self.assertIn('; would not survive this node: ', answer.message, '[FLT-2]')
        self.assertIn('/lost/kept_map.mapper', answer.message, '[FLT-2]')
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        self.assertFalse(os.path.exists(kept + '.bt'), '[FLT-2]')
        self.assertTrue(os.path.exists(os.path.join(os.path.dirname(kept), 'lost', 'kept_map.mapper.bt')), 'nothing is lost')
        self.forget_the_map()
        mapper = Node('mapper')
        rospy.wait_for_service('mapper/reset', 15.0)
        self.assertFalse(wait_for(lambda: self.say_where() and self.known() > 0, 3.0), '[FLT-2]')

    def test_a_mapper_that_dies_before_it_has_answered_load_map_leaves_one_map_or_the_other(self):  # [FLT-2]
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        for delay in (0.05, 0.1, 0.15, 0.2, 0.25, 0.3):
            self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 0 and kept_maps()), 20.0))
            calls = [threading.Thread(target=call) for call in 3 * [self.save_unless_killed] + [self.load_unless_killed]]
            for one in calls:
                one.start()
            time.sleep(delay)
            mapper.signal(signal.SIGKILL)
            for one in calls:
                one.join()
            mapper.finish()
            self.forget_the_map()
            mapper = Node('mapper')
            self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0, 20.0), '%s s [FLT-2]' % delay)

    def test_a_map_file_does_not_stand_in_for_the_kept_map_before_the_first_odometry(self):  # [FLT-2]
        room = self.leave_a_map('_map_file:=' + SMALL)
        kept = newest_map() + '.bt'
        before = os.stat(kept).st_mtime_ns
        mapper = Node('mapper', '_map_file:=' + SMALL)
        self.addCleanup(mapper.end)
        answered = call('dynamic_map', GetMap).map
        time.sleep(4.0)  # two periods of the autosave, without odometry
        self.assertEqual(os.stat(kept).st_mtime_ns, before, '[FLT-2]')
        self.assertGreater(sum(cell >= 0 for cell in answered.data), 0.95 * room, 'what it continues with [FLT-2]')
        self.assertIsNone(self.map.last, 'the map of the file [FLT-2]')

    def test_a_map_whose_pose_was_damaged_is_put_aside_and_can_be_loaded(self):  # [FLT-2]
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps() and
                                                          os.path.exists(newest_map())), 20.0))
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        before = self.known()
        kept = newest_map()
        for damage in 'nowhere\n', '1e9 -1e9 0\n', None:  # and removed
            for pose in poses_of_the_session(kept):
                os.remove(pose)
                if damage:
                    with open(pose, 'w') as file:
                        file.write(damage)
            self.forget_the_map()
            mapper = Node('mapper')
            lost = os.path.join(os.path.dirname(kept), 'lost', 'kept_map.mapper')
            self.assertTrue(wait_for(lambda: os.path.exists(lost + '.bt') and not os.path.exists(kept + '.bt'), 10.0))
            self.assertTrue(call('mapper/load_map', LoadMap, lost).success, '[FLT-2]')
            self.assertTrue(wait_for(lambda: self.known() > 0.95 * before))
            self.assertTrue(wait_for(lambda: os.path.exists(kept + '.bt') and os.path.exists(kept), 10.0))
            mapper.signal(signal.SIGKILL)
            mapper.finish()

    def test_the_copy_of_a_map_that_could_not_be_saved_outlives_the_end(self):  # [FLT-2] [MAP-5]
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        before = self.known()
        self.assertFalse(call('mapper/save_map', SaveMap, '/proc/nowhere/floor').success)
        mapper.signal(signal.SIGINT)
        _, said = mapper.finish(30.0)
        self.assertFalse(written_maps(), 'no mapper goes on with it by itself')
        kept = re.search(r'the map was not saved, /proc/nowhere.*; its copy is kept: map_file:=(\S+)\.yaml begins with it', said)
        self.assertTrue(kept, said)
        self.forget_the_map()
        mapper = Node('mapper', '_map_file:=' + kept.group(1) + '.yaml')
        self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0, 20.0))
        self.assertGreater(self.known(), 0.95 * before, '[MAP-5]')

    def test_a_map_that_a_run_promised_to_save_and_did_not_outlives_the_end(self):  # [FLT-2] [MAP-5]
        for is_saved, goes_on, why in ((True, False, ''), (False, False, 'before that'), (True, True, 'before it was saved once more, .*')):
            mapper = Node('mapper', environment=dict(os.environ, FRONTIER_PILOT_RUN='/proc/nowhere'))
            self.addCleanup(mapper.end)
            self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
            if is_saved:
                self.assertTrue(call('mapper/save_map', SaveMap, os.path.join(os.environ['ROS_HOME'], 'floor')).success)
            if goes_on:
                wait_for(lambda: self.drive() and False, 4.0)
                time.sleep(8.0)  # a map that was saved just before the end is the last one
            mapper.signal(signal.SIGINT)
            _, said = mapper.finish(30.0)
            kept = re.search(r'the map was not saved, because the mapper ended %s; its copy is kept: map_file:=(\S+)\.yaml begins with it' % why, said)
            self.assertEqual(bool(kept), bool(why), said)
            self.assertTrue(not kept or os.path.exists(kept.group(1) + '.bt'), said)
            self.forget_the_map()


if __name__ == '__main__':
    use_a_home_of_its_own()
    rospy.init_node('mapper_autosave')
    rostest.rosrun('frontier_pilot', 'mapper_autosave', MapperAutosave)
