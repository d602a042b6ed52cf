#!/usr/bin/env python3
"""Counts the test cases in a folder of JUnit XML files.

Prints "PASSED FAILED" and then the name of each failed case. A file that cannot be read counts as a failure, because
its test died before it had written it; scripts/dead_tests.py shows what is known of that. A ROS test leaves two files:
rosunit-*.xml with its cases, and rostest-*.xml with one case for the whole, which fails if the test could not be started
and passes even if cases failed or its program died.
"""
import pathlib
import xml.etree.ElementTree as xml

from command_line import CommandLine
from dead_tests import DeadTest


def cases(path):
    """(name, failed, skipped) of each test case."""
    for case in xml.parse(path).getroot().iter('testcase'):
        failed = any(case.find(kind) is not None for kind in ('failure', 'error'))
        skipped = case.find('skipped') is not None or case.get('status') == 'notrun'
        yield '%s.%s' % (case.get('classname', path.stem), case.get('name')), failed, skipped


def main():
    parser = CommandLine(__doc__, 'scripts/count_tests.py build/test/test_results')
    parser.add_argument('folder')
    folder = parser.parse_args().folder
    passed, failed = 0, []
    for path in sorted(pathlib.Path(folder).rglob('*.xml')):
        try:
            found = list(cases(path))
        except xml.ParseError:
            failed.append('%s: not readable: %s' % (path.name, DeadTest(path)))
            continue
        failed += [name for name, bad, _ in found if bad]
        if path.name.startswith('rostest-'):
            continue  # its cases have been counted
        passed += sum(not bad and not skipped for _, bad, skipped in found)
    print(passed, len(failed))
    print('\n'.join(failed))


if __name__ == '__main__':
    main()
