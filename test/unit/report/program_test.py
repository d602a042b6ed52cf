"""scripts/report as a program, where its surroundings are not as they should be."""
import errno
import glob
import os
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
import time
import unittest

import synthetic_bag
from folder_case import FolderCase

PROGRAM = pathlib.Path(__file__).resolve().parents[3] / 'scripts/report'
FULL = os.strerror(errno.ENOSPC)


def receive_all_signals():
    """As a program in the foreground does, also where this test is in the background."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


class Program(FolderCase):
    def setUp(self):
        super().setUp()
        self.bag = self.path('run_0.bag')
        synthetic_bag.write(self.bag)

    def report(self, *words, stdout=subprocess.PIPE, preexec_fn=None, **environment):
        return subprocess.run([PROGRAM, *words], stdin=subprocess.DEVNULL, stdout=stdout, stderr=subprocess.PIPE, timeout=120,
                              preexec_fn=preexec_fn, universal_newlines=True, env=dict(os.environ, **environment))

    # [FLT-1]
    def test_an_output_that_cannot_be_written_is_named_in_one_line_also_without_a_buffer(self):
        for unbuffered in ('', '1'):
            with self.subTest(unbuffered=unbuffered), open('/dev/full', 'w') as full:
                done = self.report(self.bag, stdout=full, PYTHONUNBUFFERED=unbuffered)
                self.assertEqual((done.returncode, done.stderr), (1, 'report: cannot write its output: %s\n' % FULL))

    # [FLT-1]
    def test_a_reader_that_has_gone_is_no_news(self):
        for unbuffered in ('', '1'):
            reader, writer = os.pipe()
            os.close(reader)
            with self.subTest(unbuffered=unbuffered), open(writer, 'w') as nobody:
                done = self.report(self.bag, stdout=nobody, PYTHONUNBUFFERED=unbuffered)
                self.assertEqual((done.returncode, done.stderr), (1, ''))

    def test_the_messages_of_this_package_need_not_be_installed(self):
        done = self.report(self.bag, PYTHONPATH='', ROS_PACKAGE_PATH='/usr/share')
        self.assertEqual((done.returncode, done.stderr), (0, ''))
        page = pathlib.Path(done.stdout.strip()).read_text()
        self.assertIn('explored 29.5', page)
        self.assertNotIn('not understood', page)

    def test_what_matplotlib_is_told_does_not_matter(self):
        done = self.report(self.bag, MPLBACKEND='nonsense', SOURCE_DATE_EPOCH='nonsense')
        self.assertEqual((done.returncode, done.stderr), (0, ''))

    # [FLT-1]
    def test_a_place_where_no_page_can_be_written_is_named_as_the_user_has_called_it(self):
        for out, why in ((self.path('nowhere/page.html'), errno.ENOENT), (self.path(300 * 'x'), errno.ENAMETOOLONG)):
            with self.subTest(out=out):
                done = self.report(self.bag, '--out', out)
                self.assertEqual((done.returncode, done.stderr),
                                 (1, 'report: %s cannot be written: %s\n' % (out, os.strerror(why))))

    # [REC-2] [FLT-1]
    def test_a_file_of_another_program_is_replaced_only_if_the_user_has_named_it(self):
        beside = pathlib.Path(self.path('run_0.html'))
        for word, place in ((self.bag, beside), (self.folder, pathlib.Path(self.path('report.html')))):
            with self.subTest(place=place.name):
                place.write_text('<!DOCTYPE html><title>Report of a run</title> of a horse')
                done = self.report(word)
                self.assertEqual((done.returncode, done.stdout), (1, ''))
                self.assertRegex(done.stderr, '^report: %s is there already, and is no page of this program: .*--out\n$' % place)
                self.assertIn('of a horse', place.read_text())
                self.assertEqual(self.report(word, '--out', place).returncode, 0)
                self.assertEqual(self.report(word).returncode, 0, 'it replaces its own page')
        of_an_earlier_version = re.sub('<meta name="generator".*\n', '', beside.read_text())
        beside.write_text(of_an_earlier_version)
        self.assertEqual(self.report(self.bag).returncode, 0)
        self.assertNotEqual(beside.read_text(), of_an_earlier_version)
        self.assertEqual(len(os.listdir(self.folder)), 3)

    # [FLT-1]
    def test_a_limit_of_files_is_no_damage_of_the_bag(self):
        done = self.report(self.bag, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10240, 10240)))
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, '^report: .*' + os.strerror(errno.EFBIG))
        self.assertEqual(os.listdir(self.folder), ['run_0.bag'])

    # [REC-2]
    def test_a_signal_ends_it_without_leaving_the_copy_of_a_bag_that_was_not_closed(self):
        os.rename(self.bag, self.bag + '.active')
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            with self.subTest(signal=number.name), tempfile.TemporaryDirectory() as temporary:
                report = subprocess.Popen([PROGRAM, self.bag + '.active'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                          env=dict(os.environ, TMPDIR=temporary), preexec_fn=receive_all_signals, universal_newlines=True)
                while report.poll() is None and not glob.glob(temporary + '/*/copy.bag'):
                    time.sleep(0.001)
                for _ in range(3):  # as of a terminal and of the shell in it
                    report.send_signal(number)
                said, _ = report.communicate(timeout=60)
                self.assertEqual((report.returncode, said), (128 + number, ''))
                self.assertEqual((os.listdir(temporary), os.listdir(self.folder)), ([], ['run_0.bag.active']))

    # [REC-2]
    def test_a_signal_when_the_page_is_there_is_too_late(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            with self.subTest(signal=number.name):
                page = self.path(number.name + '.html')
                report = subprocess.Popen([PROGRAM, self.bag, '--out', page], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                          preexec_fn=receive_all_signals, universal_newlines=True)
                while report.poll() is None and not os.path.exists(page):
                    time.sleep(0.001)
                report.send_signal(number)
                said, _ = report.communicate(timeout=60)
                self.assertEqual((report.returncode, said), (0, page + '\n'))

    def test_each_mark_of_the_legend_has_a_shape(self):
        self.assertEqual(self.report(self.bag, '--out', self.path('page.html')).returncode, 0)
        page = pathlib.Path(self.path('page.html')).read_text()
        marks = set(re.findall(r'class="mark (\w+)"', page))
        self.assertIn('reached', marks)
        self.assertEqual([mark for mark in marks if not re.search(r'\.mark\.%s\b' % mark, page)], [])

    def test_a_folder_of_runs_below_a_file_holds_no_run(self):
        done = self.report('latest', ROS_HOME='/dev/null')
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, '^report: no run is recorded in /dev/null/frontier_pilot/runs; record:=true')


if __name__ == '__main__':
    unittest.main()
