#!/usr/bin/env python3
"""The map that is saved at the end of a run: what is said of it, and where it is saved if it cannot be where it was to be."""
import io
import os
import pathlib
import sys
import tempfile
import threading
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
import rospy  # noqa: E402
import saved_maps  # noqa: E402
from frontier_pilot.srv import SaveMapResponse  # noqa: E402
from saved_maps import Saved  # noqa: E402


class SavedMaps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)
        self.home = os.path.join(self.folder, 'home')
        self.out, self.asked, self.answers = io.StringIO(), [], []
        self.await_service = mock.Mock()
        for patch in (mock.patch('sys.stdout', self.out), mock.patch('sys.stderr', self.out), mock.patch.dict(os.environ, ROS_HOME=self.home),
                      mock.patch('rospy.wait_for_service', self.await_service), mock.patch('rospy.ServiceProxy', return_value=self.answer)):
            patch.start()
            self.addCleanup(patch.stop)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)

    def answer(self, path):
        self.asked.append(path)
        answer = self.answers.pop(0) if self.answers else SaveMapResponse(success=True, message='saved %s.pgm, .yaml and .bt' % path)
        if isinstance(answer, Exception):
            raise answer
        return answer

    def spare(self, name):
        return os.path.join(self.home, 'frontier_pilot', 'maps', name)

    def test_the_files_are_named_as_the_mapper_has_written_them(self):
        self.answers = [SaveMapResponse(success=True, message='saved /tmp/floor.pgm, .yaml and .bt')]
        self.assertEqual(saved_maps.save_map('/tmp/floor.yaml'), Saved.WHERE_ASKED)
        self.assertEqual(self.out.getvalue(), 'Map saved: /tmp/floor.pgm, .yaml and .bt\n')

    def test_a_mapper_that_was_just_started_again_is_asked_once_more(self):
        """[FLT-2]"""
        self.answers = [rospy.ServiceException('the service has gone')]
        self.assertEqual(saved_maps.save_map('/tmp/floor'), Saved.WHERE_ASKED)
        self.assertEqual(self.asked, ['/tmp/floor', '/tmp/floor'])
        self.assertIn('The map could not be saved: the service has gone; it is tried once more\n', self.out.getvalue())

    def test_a_mapper_that_takes_a_while_to_be_started_again_is_waited_for(self):
        """[FLT-2]"""
        def come_after(seconds, timeout):
            if timeout < seconds:
                raise rospy.ROSException('timeout exceeded while waiting for service')
        self.await_service.side_effect = lambda _, timeout: come_after(15.0, timeout)
        self.assertEqual(saved_maps.save_map('/tmp/floor'), Saved.WHERE_ASKED, self.out.getvalue())
        self.assertEqual(self.asked, ['/tmp/floor'])

    def test_a_map_that_cannot_be_written_where_it_was_to_be_is_saved_below_ros_home(self):
        """[FLT-2]"""
        for prefix in os.path.join(self.folder, 'floor'), '':
            with self.subTest(prefix=prefix):
                self.answers, self.asked = 2 * [SaveMapResponse(success=False, message='the disk is full')], []
                self.assertEqual(saved_maps.save_map(prefix), Saved.ELSEWHERE)
                self.assertEqual(len(self.asked), 3)
                self.assertTrue(self.asked[2].startswith(self.spare('')), self.asked)
                self.assertIn('Map saved: %s.pgm' % self.asked[2], self.out.getvalue())
                self.assertIn('the disk is full; another folder is tried, ' + self.spare('')[:-1], self.out.getvalue())
                self.assertEqual(os.listdir('maps') if os.path.exists('maps') else [], [], 'an empty picture is left')

    def hanging(self, function, is_hung):
        """This function, but it does not return before the end of the test where `is_hung` is true of its argument.

        What hung has ended before the folder of the test is removed: it may still make folders of its own.
        """
        answers, hung = threading.Event(), []

        def release():
            answers.set()
            for thread in hung:
                thread.join()
        self.addCleanup(release)

        def call(path, *arguments, **named):
            if is_hung(path):
                hung.append(threading.current_thread())
                answers.wait()
            return function(path, *arguments, **named)
        return call

    def saved_after_waiting(self):
        """Where a map is saved, and what is said first."""
        with mock.patch('saved_maps.DISK', 2.0), mock.patch('saved_maps.MAPPER', 2.0):
            saved = saved_maps.save_map(os.path.join(self.folder, 'floor'))
        return saved, self.out.getvalue().splitlines()[0]

    def test_a_map_whose_disk_does_not_answer_is_saved_below_ros_home(self):
        """[FLT-1] [FLT-2]"""
        with mock.patch('saved_maps.os.path.isdir', self.hanging(os.path.isdir, lambda folder: folder == self.folder)):
            saved, said = self.saved_after_waiting()
        self.assertEqual(saved, Saved.ELSEWHERE)
        self.assertEqual([os.path.dirname(path) + '/' for path in self.asked], [self.spare('')])
        self.assertRegex(said, 'the disk on which it was to be has not answered for 2 s; another folder is tried, ' + self.spare('')[:-1])
        self.assertEqual(self.out.getvalue().splitlines()[-1], 'The argument map_file:=%s.yaml begins with it' % self.asked[0])

    def test_a_map_whose_disk_hangs_where_only_the_mapper_sees_it_is_saved_below_ros_home(self):
        """[FLT-1] [FLT-2]"""
        self.answer = self.hanging(self.answer, lambda path: path.startswith(self.folder + '/floor'))
        with mock.patch('rospy.ServiceProxy', return_value=self.answer):
            saved, said = self.saved_after_waiting()
        self.assertEqual(saved, Saved.ELSEWHERE)
        self.assertIn('the mapper has not answered for 2 s; another folder is tried', said)

    def test_it_ends_although_no_disk_answers_and_the_mapper_hears_that_the_map_was_to_be_saved(self):
        """[FLT-1] [FLT-2]"""
        self.answers = [SaveMapResponse(success=False, message='the disk does not answer')]
        with mock.patch('saved_maps.os.path.isdir', self.hanging(os.path.isdir, lambda _: True)), \
                mock.patch('saved_maps.os.makedirs', self.hanging(os.makedirs, lambda _: True)):
            saved, _ = self.saved_after_waiting()
        self.assertEqual(saved, Saved.NOWHERE)
        self.assertEqual([os.path.dirname(path) + '/' for path in self.asked], [self.spare('')])
        self.assertEqual(self.out.getvalue().splitlines()[-1], 'The map could not be saved: the disk does not answer')

    def test_a_second_map_does_not_take_the_name_of_the_first_one(self):
        """[FLT-2]"""
        pathlib.Path('floor.pgm').write_text('the first one')
        for prefix in 'floor', 'floor.yaml', 'floor.pgm':
            with self.subTest(prefix=prefix):
                self.assertRegex(saved_maps.free_prefix(prefix), r'/floor_[0-9]+$')
        self.assertEqual(saved_maps.free_prefix('floor.pgm/room'), '', 'a file is no folder')

    def test_a_file_in_the_place_of_the_folder_does_not_lose_the_map(self):
        pathlib.Path('maps').write_text('')
        self.assertEqual(saved_maps.save_map(''), Saved.ELSEWHERE)
        self.assertEqual([os.path.dirname(path) + '/' for path in self.asked], [self.spare('')])

    def test_no_folder_is_made_for_the_path_of_somebody(self):
        saved_maps.save_map(os.path.join(self.folder, 'nowhere', 'floor'))
        self.assertEqual(self.asked, [os.path.join(self.folder, 'nowhere', 'floor')])
        self.assertFalse(os.path.exists('nowhere'))

    def test_why_no_map_was_saved_is_said(self):
        self.answers = 3 * [SaveMapResponse(success=False, message='there is no map')]
        self.assertEqual(saved_maps.save_map('/tmp/floor'), Saved.NOWHERE)
        self.assertEqual(self.out.getvalue().splitlines()[-1], 'The map could not be saved: there is no map')
        self.assertEqual(os.listdir(self.spare('')), [])

    def test_a_mapper_that_is_not_there_is_not_waited_for_three_times(self):
        self.await_service.side_effect = rospy.ROSException('timeout exceeded while waiting for service')
        self.assertEqual(saved_maps.save_map('/tmp/floor'), Saved.NOWHERE)
        self.assertEqual(self.await_service.call_count, 1)

    def test_a_mapper_on_another_computer_leaves_no_empty_picture_here(self):
        self.assertEqual(saved_maps.save_map(''), Saved.WHERE_ASKED)
        self.assertEqual(os.listdir('maps'), [])
        self.assertRegex(self.out.getvalue(), '^Map saved: .*, on the computer of the mapper\n$')

    def test_a_map_of_before_is_not_overwritten(self):
        prefix = os.path.join(self.folder, 'floor')
        self.assertEqual(saved_maps.free_prefix(prefix), prefix)
        self.assertEqual(saved_maps.free_prefix(prefix), prefix + '_1')


if __name__ == '__main__':
    unittest.main()
