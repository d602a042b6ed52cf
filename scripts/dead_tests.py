#!/usr/bin/env python3
"""Shows what is known of each test that left a file of results which cannot be read, because it died.

A ROS test of Python opens its file at its beginning and writes it at its end. If its program dies in between, rostest takes the empty
file for no cases at all. How the program ended is in rostest's own file, rostest-*.xml, and what it said last in ctest's log and in
the files that roslaunch wrote for it.
"""
import collections
import glob
import pathlib
import re
import signal
import xml.etree.ElementTree as xml

from command_line import CommandLine

LINES = 60  # of each output


def words_of(path):
    """All text of a file of results; none if it cannot be read."""
    try:
        return ''.join(xml.parse(path).getroot().itertext())
    except xml.ParseError:
        return ''


def unreadable(folder):
    """The files of results that cannot be read."""
    for path in sorted(pathlib.Path(folder).rglob('*.xml')):
        try:
            xml.parse(path)
        except xml.ParseError:
            yield path


class DeadTest:
    """The test that left an unreadable file of results.

    `name` is what ctest -R finds it by, `end` says how its program ended, as far as that is known, and `logs` are the files with its output.
    """

    def __init__(self, path):
        kind, _, program = path.stem.partition('-')
        self.name, self.end, self.logs = program, 'ended', []
        for told in sorted(path.parent.glob('rostest-*.xml')) if kind == 'rosunit' else []:
            words = words_of(told)
            if '/%s]' % path.name in words:
                self.name = told.stem.partition('-')[2]
                self._read_end(program, words)

    def _read_end(self, program, words):
        end = re.search(r'\[%s-\d+\] process has (?:died \[.*?exit code (-?\d+).*|finished cleanly)\n(?:log file: (\S+?\*\.log))?'
                        % re.escape(program), words)
        if not end:
            return
        code = int(end.group(1) or 0)
        self.end = 'ended by %s' % signal_name(-code) if code < 0 else 'ended with exit code %d' % code
        self.logs = sorted(glob.glob(end.group(2) or ''))

    def __str__(self):
        return '%s %s before it had written its results' % (self.name, self.end)


def signal_name(number):
    try:
        return signal.Signals(number).name
    except ValueError:
        return 'signal %d' % number


def output_of(name, lines):
    """What ctest's log has of a test: the trace of a crash of Python, if there is one, and the end."""
    inside, trace, end = False, [], collections.deque(maxlen=LINES)
    for line in lines:
        begins = re.match(r'\d+/\d+ Testing: (\S+)', line)
        if begins:
            inside = re.sub(r'\.test$', '', begins.group(1)).endswith('_' + name)
        if inside:
            end.append(line)
            if (trace or 'Fatal Python error' in line) and len(trace) < LINES // 2:
                trace.append(line)
    return [line for line in trace if line not in end] + list(end)


def show(heading, lines):
    lines = list(lines)
    if lines:
        print('--- %s' % heading)
        print('\n'.join(line.rstrip('\n') for line in lines))


def main():
    parser = CommandLine(__doc__, 'scripts/dead_tests.py build/test')
    parser.add_argument('build')
    build = pathlib.Path(parser.parse_args().build)
    log = build / 'Testing/Temporary/LastTest.log'
    for path in unreadable(build / 'test_results'):
        test = DeadTest(path)
        print('%s: %s' % (path.name, test))
        if log.exists():
            with open(log, errors='replace') as lines:
                show('the end of its output in %s' % log, output_of(test.name, lines))
        for file in test.logs:
            with open(file, errors='replace') as lines:
                show('the end of %s' % file, collections.deque(lines, maxlen=LINES))


if __name__ == '__main__':
    main()
