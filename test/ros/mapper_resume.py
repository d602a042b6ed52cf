#!/usr/bin/env python3
"""Which map, and which place in it, a mapper goes on with that is started after another one died."""
import os
import signal
import time

import rosgraph
import rospy
import rostest
from frontier_pilot.srv import LoadMap, SaveMap
from std_msgs.msg import Bool
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

from mapper_case import SMALL, MapperCase, kept_maps, newest_map
from wire import Node, Record, Stranger, call, free_port, use_a_home_of_its_own, wait_for

JUMP = 3.0  # of odometry [m]


class MapperResume(MapperCase):
    def setUp(self):
        super().setUp()
        self.transforms = Record('/tf', TFMessage)
        self.addCleanup(lambda: self.transforms.subscriber.unregister())

    def start(self, *arguments):
        mapper = Node('mapper', *arguments)
        self.addCleanup(mapper.end)
        return mapper

    def kill(self, mapper):
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        self.forget_the_map()
        self.transforms.subscriber.unregister()
        self.transforms = Record('/tf', TFMessage)

    def corrections(self):
        """The x of all map -> odom that were heard [m]."""
        return [each.transform.translation.x for _, message in list(self.transforms.items)
                for each in message.transforms if each.child_frame_id == 'odom']

    def has_jumped(self):
        return self.corrections() and abs(self.corrections()[-1] + JUMP) < 0.3

    def test_the_robot_is_nowhere_until_odometry_comes_and_then_where_odometry_was_reset_last(self):  # [FLT-2]
        mapper = self.start('_autosave_period:=6')
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps() and
                                                          os.path.exists(newest_map())), 20.0))
        saved = os.stat(newest_map()).st_mtime_ns
        self.assertTrue(wait_for(lambda: self.drive() or os.stat(newest_map()).st_mtime_ns > saved), 'renewed once the save has ended')
        self.jump = JUMP
        self.assertTrue(wait_for(lambda: self.say_where() and self.has_jumped(), 10.0), self.corrections()[-1:])
        self.kill(mapper)
        self.start()
        rospy.wait_for_service('mapper/reset', 15.0)
        time.sleep(2.0)  # forty periods of map -> odom
        self.assertEqual(self.corrections(), [], 'not the identity [FLT-2]')
        self.assertTrue(wait_for(lambda: self.say_where() and self.corrections(), 10.0))
        self.assertLess(abs(self.corrections()[0] + JUMP), 0.3, 'the reset was not forgotten [FLT-2]')

    def test_a_map_that_another_one_was_loaded_in_place_of_does_not_come_back(self):  # [FLT-2]
        mapper = self.start()
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        room = self.map.last.info.width
        self.assertTrue(call('mapper/load_map', LoadMap, SMALL).success)
        self.kill(mapper)
        self.start()
        self.assertFalse(wait_for(lambda: self.say_where() and self.map.last and self.map.last.info.width == room, 4.0),
                         '[FLT-2]')

    def test_a_robot_that_was_not_found_is_looked_for_also_if_odometry_is_trusted(self):  # [FLT-2] [MAP-5]
        options = '_autosave_period:=1', '_mapper/trust_odometry:=true'
        mapper = self.start(*options)
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        localized = Record('mapper/localized', Bool)
        self.addCleanup(localized.subscriber.unregister)
        self.assertTrue(call('mapper/load_map', LoadMap, SMALL).success)
        self.assertTrue(wait_for(lambda: self.drive() or (localized.last is not None and not localized.last.data)))
        self.assertFalse(wait_for(lambda: self.drive() or localized.last.data, 3.0), 'it is in another room than that of the map')
        self.kill(mapper)
        localized = Record('mapper/localized', Bool)
        self.addCleanup(localized.subscriber.unregister)
        self.start(*options)
        self.assertTrue(wait_for(lambda: self.drive() or (self.map.last and localized.items), 15.0))
        self.assertFalse(wait_for(lambda: self.drive() or localized.last.data, 3.0), '[MAP-5]')

    def test_a_map_of_a_launch_with_another_map_file_is_put_aside(self):  # [FLT-2]
        room = self.leave_a_map()
        kept = newest_map()
        mapper = self.start('_map_file:=' + SMALL)
        lost = os.path.join(os.path.dirname(kept), 'lost', 'kept_map.mapper')
        self.assertTrue(wait_for(lambda: os.path.exists(lost + '.bt') and self.say_where() and self.known() > 0), '[FLT-2]')
        small = self.known()
        wait_for(lambda: self.say_where() and False, 3.0)
        self.assertEqual(self.known(), small, 'the map of the file [FLT-2]')
        said = mapper.said()
        self.assertIn('loaded ' + SMALL, said)
        self.assertIn('without a map_file', said)
        self.assertIn(SMALL, said)
        self.assertIn(lost, said)
        # What is loaded meanwhile belongs to this launch: one that is started again with the same file gets it.
        self.assertTrue(call('mapper/load_map', LoadMap, lost).success)
        self.assertTrue(wait_for(lambda: self.known() > 0.95 * room))
        self.assertTrue(wait_for(lambda: os.path.exists(kept + '.bt') and os.path.exists(kept), 10.0))
        self.kill(mapper)
        self.start('_map_file:=' + SMALL)
        self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0.95 * room, 20.0), '[FLT-2]')

    def test_a_map_that_waits_for_odometry_is_saved_and_stays_when_the_mapper_ends(self):  # [FLT-2]
        room, saved = self.leave_a_map(), os.path.join(os.environ['ROS_HOME'], 'room')
        mapper = self.start()
        self.assertTrue(call('mapper/save_map', SaveMap, saved).success, '[FLT-2]')
        mapper.end()
        self.assertTrue(kept_maps(), 'nobody has continued with it')
        self.start()
        self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0.95 * room, 20.0), '[FLT-2]')
        self.assertTrue(call('mapper/reset', Trigger).success)
        self.assertTrue(wait_for(lambda: self.known() == 0))
        self.assertTrue(call('mapper/load_map', LoadMap, saved).success)
        self.assertTrue(wait_for(lambda: self.known() > 0.95 * room), '[FLT-2]')

    def lose_the_name(self, take_it):
        """Maps until the master ends the mapper, because `take_it()` registers its name. Gives the number of known cells, and what
        `take_it` gave."""
        mapper = self.start()
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        known, kept = self.known(), newest_map()
        taken = take_it()
        mapper.finish(20.0)
        self.assertTrue(os.path.exists(kept) and os.path.exists(kept + '.bt'), '[FLT-2]')
        return known, taken

    def assert_the_next_mapper_has(self, known):
        self.forget_the_map()
        self.start()
        self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0.95 * known, 20.0), '[FLT-2]')

    def test_a_mapper_that_a_node_of_its_name_replaces_leaves_its_map_for_the_next_one(self):  # [FLT-2]
        known, namesake = self.lose_the_name(lambda: Stranger(self, 'mapper'))
        namesake.end()
        self.assert_the_next_mapper_has(known)

    def test_a_mapper_leaves_its_map_also_if_the_node_of_its_name_ended_before_it(self):  # [FLT-2]
        ended = 'http://127.0.0.1:%d/' % free_port()
        known, _ = self.lose_the_name(lambda: rosgraph.Master('/mapper').registerPublisher('/its_topic', 'std_msgs/Bool', ended))
        self.assert_the_next_mapper_has(known)

    def test_a_map_without_a_known_cell_is_not_missed(self):  # [FLT-2]
        mapper = self.start()
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        self.assertTrue(call('mapper/reset', Trigger).success)
        time.sleep(5.0)  # two periods of the autosave, without a scan
        self.assertNotIn('would not survive', mapper.said())


if __name__ == '__main__':
    use_a_home_of_its_own()
    rospy.init_node('mapper_resume')
    rostest.rosrun('frontier_pilot', 'mapper_resume', MapperResume)
