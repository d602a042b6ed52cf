"""The file that the report is written to."""
import os
import unittest

from folder_case import FolderCase  # finds the modules below
from run_report import output_file
from run_report.bag_files import ReportError


class OutputFile(FolderCase):
    def read(self, name):
        with open(self.path(name)) as file:
            return file.read()

    # [REC-2] [FLT-1]
    def test_is_not_one_of_the_bags_by_whatever_name(self):
        bag = self.touch('run.bag')
        os.link(bag, self.path('hard'))
        os.symlink(bag, self.path('soft'))
        for name in ('run.bag', 'hard', 'soft'):
            with self.assertRaisesRegex(ReportError, 'is one of the bags'):
                output_file.check(self.path(name), [bag])
        output_file.check(self.path('page.html'), [bag])

    # [FLT-1]
    def test_is_no_pipe_folder_or_device(self):
        os.mkfifo(self.path('pipe'))
        for path in (self.path('pipe'), self.folder, '/dev/null'):
            with self.assertRaisesRegex(ReportError, 'is no file'):
                output_file.check(path, [])

    # [FLT-1]
    def test_is_nothing_but_a_page_of_this_program_where_the_user_has_not_named_it(self):
        os.mkfifo(self.path('pipe'))
        os.symlink(self.path('nowhere'), self.path('link'))
        for path in (self.path('pipe'), self.path('link'), self.touch('page'), self.folder):
            with self.assertRaisesRegex(ReportError, 'is no page of this program'):
                output_file.check_unasked(path)
        output_file.check_unasked(self.path('free.html'))
        output_file.write(self.path('page'), output_file.MARK)
        output_file.check_unasked(self.path('page'))

    # [FLT-1]
    def test_replaces_a_link_and_not_what_it_points_to(self):
        precious = self.touch('precious')
        os.symlink(precious, self.path('report.html'))
        output_file.write(self.path('report.html'), 'page')
        self.assertEqual(self.read('precious'), 'x')
        self.assertEqual(self.read('report.html'), 'page')
        self.assertEqual(sorted(os.listdir(self.folder)), ['precious', 'report.html'])


if __name__ == '__main__':
    unittest.main()
