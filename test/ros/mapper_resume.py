#!/usr/bin/env python3
"""Which map, and which place in it, a mapper goes on with that is started after another one died."""
import os
import signal
import time

import rospy
import rostest
from tf2_msgs.msg import TFMessage

from mapper_case import MapperCase, kept_maps, newest_map
from wire import Node, Record, use_a_home_of_its_own, wait_for

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

    def test_the_robot_is_nowhere_until_odometry_comes_and_then_where_it_was(self):  # [FLT-2]
        mapper = self.start()
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps() and
                                                          os.path.exists(newest_map())), 20.0))
        self.jump = JUMP
        self.assertTrue(wait_for(lambda: self.say_where() and self.has_jumped(), 3.0), self.corrections()[-1:])
        before = os.path.getmtime(newest_map())
        self.assertTrue(wait_for(lambda: self.drive() or os.path.getmtime(newest_map()) > before + 2.5, 10.0))
        self.kill(mapper)
        self.start()
        rospy.wait_for_service('mapper/reset', 15.0)
        time.sleep(2.0)  # forty periods of map -> odom
        self.assertEqual(self.corrections(), [], 'not the identity [FLT-2]')
        self.assertTrue(wait_for(lambda: self.say_where() and self.corrections(), 10.0))
        self.assertLess(abs(self.corrections()[0] + JUMP), 0.3, '[FLT-2]')


if __name__ == '__main__':
    use_a_home_of_its_own()
    rospy.init_node('mapper_resume')
    rostest.rosrun('frontier_pilot', 'mapper_resume', MapperResume)
