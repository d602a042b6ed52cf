#!/usr/bin/env python3
"""A recorded drive waits for a mapper that died."""
import os
import re
import shutil
import signal
import tempfile
import unittest

import rosgraph
import rospy
import rostest
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan

from play_bag import write_bag
from tap import Tap
from wire import Node, Record, pid_of, wait_for

NOTICED = 1.0  # within so much of the drive the player knows that the mapper is gone [s]


class PlayBagRespawn(unittest.TestCase):
    def setUp(self):
        rospy.init_node('play_bag_respawn')
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.scans = Record('scan', LaserScan)

    def is_another_than(self, pid):
        try:
            return pid_of('/mapper') != pid
        except (OSError, rosgraph.MasterException):
            return False

    def test_the_drive_waits_for_a_mapper_that_died_and_the_player_says_what_the_map_lacks(self):  # [FLT-2]
        bag = os.path.join(self.folder, 'drive.bag')
        write_bag(bag)
        player = Node('bag_player.py', '_bag:=' + bag, '_speed:=2.0', '_save_map:=' + os.path.join(self.folder, 'mapped'))
        self.addCleanup(player.end)
        self.assertTrue(wait_for(lambda: len(self.scans.items) > 40, 60.0), player.said())
        tap, pid = Tap('/bag_player', '/clock', Clock), pid_of('/mapper')
        self.addCleanup(tap.close)
        os.kill(pid, signal.SIGKILL)
        self.assertTrue(wait_for(lambda: not os.path.exists('/proc/%d' % pid)))
        clocks = tap.next(1)
        ended = clocks[-1].clock
        self.assertTrue(wait_for(lambda: self.is_another_than(pid), 60.0), player.said())
        clocks = [each.clock for each in clocks + tap.arrived()]
        stood = max(clocks, key=clocks.count)
        self.assertGreater(clocks.count(stood), 10, 'the clock stands still')
        self.assertLess((stood - ended).to_sec(), NOTICED, 'the rest waits')
        self.assertTrue(wait_for(lambda: player.said() and player.has_ended(), 120.0), player.said())
        said = player.said()
        self.assertEqual(0, player.process.returncode, said)
        self.assertIn('Map saved', said)
        counts = re.search('the mapper ended once while the bag was played.* of ([0-9]+) scans played since it was back it has taken ([0-9]+)', said)
        self.assertTrue(counts, said)
        played, taken = map(int, counts.groups())
        self.assertGreater(played, 80)
        self.assertGreater(taken, 0.9 * played, said)  # a mapper that is held up leaves out what has become old
        self.assertLessEqual(taken, played)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'play_bag_respawn', PlayBagRespawn)
