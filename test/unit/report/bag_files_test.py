#!/usr/bin/env python3
"""Bags that are whole, that were not closed, and that are damaged."""
import errno
import os
import unittest
from unittest import mock

import rosbag

from folder_case import FolderCase
import synthetic_bag
from run_report.bag_files import BagFiles, ReportError, find_parts


def seconds_in(bags):
    return sum(1 for _ in bags.messages(['/navigator/status']))


class Finding(FolderCase):
    def test_latest_is_the_newest_run_that_holds_a_bag(self):
        self.touch('2030-01-01_00-00-00', 'run_0.bag')
        newest = self.touch('2030-01-02_00-00-00', 'run_0.bag')
        os.mkdir(self.path('2030-01-03_00-00-00'))
        self.assertEqual(find_parts('latest', self.folder), [newest])

    def test_what_is_missing_is_named(self):
        for word, words in (('latest', 'record:=true'), (self.folder, 'no bag in this folder'), ('nowhere.bag', 'no such bag')):
            with self.assertRaisesRegex(ReportError, words):
                find_parts(word, self.path('nowhere'))


class Reading(FolderCase):
    def setUp(self):
        super().setUp()
        self.bag = self.path('run_0.bag')
        synthetic_bag.write(self.bag)

    def cut(self, share, name):
        """The bag as a recorder that was killed leaves it."""
        with open(self.bag, 'rb') as file:
            content = bytearray(file.read())
        path = self.path(name)
        # The header of a bag that is open has neither index nor counts.
        for field in (b'index_pos=', b'conn_count=', b'chunk_count='):
            at = content.index(field) + len(field)
            width = 8 if field == b'index_pos=' else 4
            content[at:at + width] = bytes(width)
        with open(path, 'wb') as file:
            file.write(content[:int(share * len(content))])
        return path

    def test_a_whole_bag_is_read_without_a_note(self):
        with BagFiles([self.bag]) as bags:
            self.assertEqual((seconds_in(bags), bags.notes), (synthetic_bag.SECONDS, []))

    def test_a_bag_that_was_not_closed_is_read_as_far_as_it_goes_and_stays_as_it_is(self):
        """[REC-2]"""
        for name in ('run_1.bag.active', 'cut.bag'):
            path = self.cut(0.6, name)
            before = os.path.getsize(path)
            with BagFiles([path]) as bags:
                self.assertGreater(seconds_in(bags), 10)
                self.assertIn('was not closed', bags.notes[0])
            self.assertEqual(os.path.getsize(path), before)

    def test_a_copy_for_which_there_is_no_room_is_said_with_its_folder(self):
        full = OSError(errno.ENOSPC, 'No space left on device')
        with mock.patch('shutil.copyfile', side_effect=full), self.assertRaisesRegex(ReportError, 'cut.bag cannot be copied to .*TMPDIR'):
            with BagFiles([self.cut(0.6, 'cut.bag')]):
                pass

    def test_a_damaged_bag_is_read_up_to_the_damage(self):
        """[REC-2]"""
        with open(self.bag, 'r+b') as file:
            file.seek(os.path.getsize(self.bag) // 3)
            file.write(b'\xa5' * 500)
        with BagFiles([self.bag]) as bags:
            self.assertLess(seconds_in(bags), synthetic_bag.SECONDS)
            self.assertRegex(' '.join(bags.notes), 'damaged|cannot be read')

    def test_a_definition_that_names_an_unknown_type_is_damage(self):
        """[REC-2]"""
        with open(self.bag, 'rb') as file:
            content = file.read()
        with open(self.bag, 'wb') as file:
            file.write(content.replace(b'std_msgs/Header', b'std_msgs/Hexder'))
        with mock.patch.dict(rosbag.bag._message_types, clear=True), BagFiles([self.bag]) as bags:
            self.assertEqual(list(bags.messages(['/odom'])), [])
            self.assertRegex(' '.join(bags.notes), 'damaged.*Hexder|damaged.*Header')

    def test_what_is_no_bag_is_named(self):
        """[REC-2]"""
        with self.assertRaisesRegex(ReportError, 'junk.bag: it cannot be read'):
            with BagFiles([self.touch('junk.bag')]):
                pass

    def test_what_is_no_regular_file_is_named_and_never_opened(self):
        """[REC-2] [FLT-1]"""
        pipe = self.path('pipe.bag')
        os.mkfifo(pipe)
        device = self.path('device.bag')
        os.symlink('/dev/zero', device)
        for path in (pipe, device):
            with self.assertRaisesRegex(ReportError, 'not a regular file'):
                with BagFiles([path]):
                    pass

    def test_what_does_not_begin_as_a_bag_does_is_not_read_in_search_of_its_first_line(self):
        """[REC-2] [FLT-1]"""
        for name, beginning in (('zeros.bag', b''), ('endless.bag', b'#ROSBAG V2.0')):
            with open(self.path(name), 'wb') as file:
                file.write(beginning)
                file.truncate(2 ** 30)
            with mock.patch('rosbag.Bag') as read, self.assertRaisesRegex(ReportError, name + ': .* does not begin as a bag does'):
                with BagFiles([self.path(name)]):
                    pass
            read.assert_not_called()

    def test_a_part_that_cannot_be_read_does_not_hide_the_others(self):
        """[REC-2]"""
        with BagFiles([self.touch('run_1.bag'), self.bag]) as bags:
            self.assertEqual(seconds_in(bags), synthetic_bag.SECONDS)
            self.assertIn('run_1.bag', bags.notes[0])


if __name__ == '__main__':
    unittest.main()
