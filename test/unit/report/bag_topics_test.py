#!/usr/bin/env python3
"""Topics of a recorded drive, as play.launch reads them."""
import io
import os
import shutil
import tempfile
import unittest
from unittest import mock

import folder_case  # noqa: F401: finds the scripts
import rosbag
from bag_topics import MOST_BYTES, BagError, Topic, choose_scan, memory_for, read_bag
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage


class Damage(unittest.TestCase):
    def test_a_message_that_cannot_be_read_is_named_by_its_topic(self):
        buffer = io.BytesIO()
        Odometry().serialize(buffer)
        topic = Topic('/odom', Odometry)
        topic.raw = [(0.0, buffer.getvalue()), (0.1, buffer.getvalue()[:40])]
        self.assertEqual(topic.message(0), Odometry())
        for read in (lambda: topic.message(1), lambda: list(topic.messages())):
            with self.assertRaisesRegex(BagError, '/odom: a message cannot be read'):
                read()

    def test_a_field_of_view_that_is_not_finite_is_none(self):
        buffer = io.BytesIO()
        LaserScan(angle_increment=float('inf'), ranges=[1.0, 1.0]).serialize(buffer)
        scan = Topic('/scan', LaserScan)
        scan.raw = [(0.0, buffer.getvalue())]
        self.assertEqual(choose_scan({'/scan': scan}, '')[0], scan)

    def test_messages_that_no_node_would_take_are_left_out_before_they_take_memory(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'drive.bag')
            with rosbag.Bag(path, 'w') as bag:
                for beams in 36000, 1, MOST_BYTES:
                    bag.write('/scan', LaserScan(ranges=[1.0] * beams, intensities=[1.0] * beams))
                bag.write('/other', LaserScan(ranges=[1.0] * MOST_BYTES))
            topics, _ = read_bag(path)
            self.assertEqual([(len(topics[name].raw), topics[name].too_long) for name in ('/scan', '/other')], [(2, 1), (0, 1)])
            self.assertEqual(choose_scan(topics, '')[0].name, '/scan')
            with self.assertRaisesRegex(BagError, 'all messages of /other are longer'):
                choose_scan({'/other': topics['/other']}, '')

    def test_a_file_of_zeros_is_not_read_in_search_of_its_first_line(self):
        """[FLT-1]"""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'zeros.bag')
            with open(path, 'wb') as file:
                file.truncate(2 ** 30)
            with mock.patch('rosbag.Bag') as read, self.assertRaisesRegex(BagError, 'zeros.bag: it does not begin as a bag does'):
                read_bag(path)
            read.assert_not_called()

    def test_a_bag_whose_messages_together_take_more_than_4_gb_is_refused(self):
        """[FLT-1]"""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'drive.bag')
            with rosbag.Bag(path, 'w') as bag:
                for _ in range(4):
                    bag.write('/scan', LaserScan(ranges=[1.0] * 1000))
            with mock.patch('bag_topics.MOST_MEMORY', 20000):
                self.assertEqual(len(read_bag(path)[0]['/scan'].raw), 4)
            with mock.patch('bag_topics.MOST_MEMORY', 16000), self.assertRaisesRegex(BagError, 'take more than .*; rosbag filter'):
                read_bag(path)

    def test_the_memory_that_transforms_take_once_they_are_read_counts_as_well(self):
        """[FLT-1]"""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'drive.bag')
            with rosbag.Bag(path, 'w') as bag:
                bag.write('/tf', TFMessage([TransformStamped() for _ in range(100)]))
            size = len(read_bag(path)[0]['/tf'].raw[0][1])
            with mock.patch('bag_topics.MOST_MEMORY', 8 * size), self.assertRaisesRegex(BagError, 'take more than'):
                read_bag(path)
        self.assertLess(memory_for(TFMessage, b'\xff' * 100), 10000, 'a count of transforms that is damaged is believed')

    def test_a_bag_whose_recording_was_killed_is_refused_with_a_way_to_recover_it(self):
        with tempfile.TemporaryDirectory() as folder:
            path, killed = os.path.join(folder, 'drive.bag'), os.path.join(folder, 'killed.bag')
            with rosbag.Bag(path, 'w') as bag:
                bag.write('/odom', Odometry())
                bag.flush()
                shutil.copyfile(path, killed)
            with self.assertRaisesRegex(BagError, "has no index.*'rosbag reindex' may recover"):
                read_bag(killed)


if __name__ == '__main__':
    unittest.main()
