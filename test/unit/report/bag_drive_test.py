#!/usr/bin/env python3
"""A recorded drive, as play.launch plays it."""
import io
import unittest

import folder_case  # noqa: F401: finds the scripts
import rospy
from bag_drive import Drive
from bag_topics import BagError, Topic
from sensor_msgs.msg import LaserScan

OPTIONS = {'scan': '', 'odom': '', 'base_frame': 'base', 'odom_frame': 'odom', 'map_frame': 'map', 'mount': '0 0 0'}


def scans_at(stamps, frame='laser'):
    topic = Topic('/scan', LaserScan)
    for stamp in stamps:
        scan = LaserScan(angle_increment=0.1, ranges=[1.0, 2.0])
        scan.header.frame_id, scan.header.stamp = frame, rospy.Time(stamp)
        buffer = io.BytesIO()
        scan.serialize(buffer)
        topic.raw.append((float(stamp), buffer.getvalue()))
    return {topic.name: topic}


class Stamps(unittest.TestCase):
    def test_a_drive_is_played_from_its_first_to_its_last_stamp(self):
        self.assertEqual([entry[0] for entry in Drive(scans_at((5, 6)), {}, OPTIONS).entries], [5.0, 6.0])

    def test_a_drive_whose_stamps_leave_the_clock_no_room_is_refused(self):
        with self.assertRaisesRegex(BagError, 'its last stamp is 4294967000 s'):
            Drive(scans_at((4294966999, 4294967000)), {}, OPTIONS)

    def test_the_clock_jumps_over_hours_without_a_message(self):
        drive = Drive(scans_at((5, 6, 400000000, 400000001)), {}, OPTIONS)
        self.assertIn('no message at all for 399999994.0 s from 1.0 s on: the clock jumps over it', drive.words)
        self.assertEqual([entry[0] for entry in drive.due_until(6.5)], [5.0, 6.0])
        self.assertEqual(drive.time_after(6.5), 400000000 - 0.5)
        self.assertEqual(drive.time_after(400000000.2), 400000000.2)

    def test_it_jumps_over_all_that_it_says_it_does_and_over_nothing_else(self):
        drive = Drive(scans_at((5, 6, 36, 37, 3637, 3638)), {}, OPTIONS)
        self.assertEqual(len([words for words in drive.words if 'jumps' in words]), 1, drive.words)
        list(drive.due_until(6.5))
        self.assertEqual(drive.time_after(6.5), 6.5)
        list(drive.due_until(37.5))
        self.assertEqual(drive.time_after(37.5), 3637 - 0.5)


class Frames(unittest.TestCase):
    # [FLT-1]
    def test_a_frame_is_shown_in_one_line_and_not_in_full(self):
        for frame, shown in ((100000 * 'x', 100 * 'x' + '...'), ('a\nb', 'a\\nb'), ('a\0', 'a\\x00')):
            with self.assertRaises(BagError) as raised:
                Drive(scans_at((5, 6), frame), {}, dict(OPTIONS, mount=''))
            self.assertIn("the scanner's frame %s: give mount" % shown, str(raised.exception))


if __name__ == '__main__':
    unittest.main()
