#!/usr/bin/env python3
"""The table of the coverage, from what llvm-cov exports."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from coverage_table import BEGIN, END, WORST, module_of, render, replaced, shares_of, total_of  # noqa: E402

ROOT = pathlib.Path('/house')


def file(path, lines, branches):
    return {'filename': path, 'summary': {kind: {'count': count, 'covered': covered}
                                          for kind, (count, covered) in (('lines', lines), ('branches', branches))}}


def shares(*files):
    return shares_of({'data': [{'files': list(files)}]}, ROOT)


class CoverageTable(unittest.TestCase):
    def test_a_public_header_belongs_to_the_module_of_its_folder(self):
        self.assertEqual(module_of(pathlib.Path('include/frontier_pilot/arbiter/arbiter.h')), 'arbiter')
        self.assertEqual(module_of(pathlib.Path('src/exploration/tour/tour.cpp')), 'exploration')

    def test_adapters_tests_benchmarks_and_libraries_are_no_modules(self):
        for path in ('src/ros/common/threads/worker.h', 'src/gui/theme.cpp', 'src/nodes/mapper_node.cpp', 'src/tools/x.cpp', 'src/rviz/x.cpp',
                     'test/unit/core/x_test.cpp', 'bench/x.cpp', 'build/coverage/x.cpp'):
            self.assertIsNone(module_of(pathlib.Path(path)), path)
        self.assertEqual(shares(file('/usr/include/eigen3/Eigen/Core', (10, 1), (2, 1))), ({}, {}))

    def test_the_files_of_a_module_are_added(self):
        modules, files = shares(file('/house/build/coverage/../../src/core/a.cpp', (10, 9), (4, 2)),
                                file('/house/src/core/b.cpp', (30, 21), (0, 0)))
        self.assertAlmostEqual(modules['core'].percent('lines'), 75.0)
        self.assertAlmostEqual(modules['core'].percent('branches'), 50.0)
        self.assertEqual(sorted(files), ['src/core/a.cpp', 'src/core/b.cpp'])

    def test_the_total_counts_lines_and_not_modules(self):
        modules, _ = shares(file('/house/src/core/a.cpp', (90, 90), (1, 1)), file('/house/src/sim/b.cpp', (10, 0), (1, 0)))
        self.assertAlmostEqual(total_of(modules).percent('lines'), 90.0)

    def test_a_file_without_branches_has_all_of_them_reached(self):
        modules, _ = shares(file('/house/src/core/a.cpp', (2, 2), (0, 0)))
        self.assertAlmostEqual(modules['core'].percent('branches'), 100.0)

    def test_the_files_with_the_most_that_is_left_are_named_first(self):
        found = shares(*(file('/house/src/core/%02d.cpp' % left, (100, 100 - left), (0, 0)) for left in range(20)))
        table = render(*found, '2026-01-02')
        self.assertIn('2026-01-02', table)
        self.assertIn('| `src/core/19.cpp` | 19 | 0 |\n| `src/core/18.cpp` | 18 | 0 |', table)
        self.assertEqual(table.count('.cpp'), WORST)

    def test_the_table_replaces_what_is_between_its_marks(self):
        self.assertEqual(replaced('a\n%s old %s\nb' % (BEGIN, END), 'new'), 'a\n%s\n\nnew\n\n%s\nb' % (BEGIN, END))
        with self.assertRaises(ValueError):
            replaced('a page', 'new')


if __name__ == '__main__':
    unittest.main()
