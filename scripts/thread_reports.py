"""Tells the reports of ThreadSanitizer that concern this project from those that come of libraries without its instrument.

Usage: thread_reports.py BUILD. Reads the files in BUILD/reports and prints a line for each different report of this project, and on
stderr how many there were of others.

A library that is not instrumented synchronises by means that ThreadSanitizer does not see, such as the reference counts that are
inlined into it, so that what it frees in another thread looks like a race. Whose an access, or a lock, is, is told by the innermost frame
that lies neither in a header of the system nor in the sanitizer: what is inlined belongs to its caller, but for roscpp's buffers. A race is the project's if both
accesses are; any other report, a cycle of mutexes above all, if one of its locks is. A cycle in a single thread is left out as well: it
cannot block, and nodes call actionlib, which has locks of its own, from one thread only.
"""
import collections
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
SEPARATOR = '=================='
FRAME = re.compile(r'^ *#\d+ (?P<name>.*) (?P<file>\S+) \((?P<module>[^()]*)\+0x[0-9a-f]+\)')
TITLE = re.compile(r'WARNING: ThreadSanitizer: (?P<kind>.*?) \(pid=')
TAKEN_IN = re.compile(r'acquired here while holding .* in (?P<thread>main thread|thread T\d+)')
BUFFER_OF_ROSCPP = '/usr/include/ros/serialized_message.h'  # which is shared with its threads by a reference count
ABOUT_OTHERS = re.compile(r'^\s*(Mutex .* created at|Thread .* created|Location is)')


class Stack:
    """The heading of a stack, and its frames from the innermost on, as (function, file, module)."""

    def __init__(self, heading):
        self.heading = heading
        self.frames = []


class Report:
    """The kind of a report and its stacks of what was done: those of where a thread, a mutex or a block was made are left out."""

    def __init__(self, kind, stacks):
        self.kind = kind
        doing = [stack for stack in stacks if not ABOUT_OTHERS.match(stack.heading)]
        self.stacks = doing or stacks


def stacks_of(lines):
    """The stacks of one report; each begins with the line before its first frame."""
    stacks, before = [], ''
    for line in lines:
        frame = FRAME.match(line)
        if frame is None:
            before = line
            continue
        if line.lstrip().startswith('#0 '):
            stacks.append(Stack(before))
        if stacks:
            stacks[-1].frames.append((frame['name'], frame['file'].split(':')[0], frame['module']))
    return stacks


def reports_in(text):
    """The reports of one file of them."""
    for block in text.split(SEPARATOR):
        title = TITLE.search(block)
        if title:
            yield Report(title['kind'], stacks_of(block.splitlines()))


def place_in_project(path, build, root):
    """The path of a source file of this project, relative to its root; None for any other. The compiler's paths start at BUILD."""
    if path == '<null>':
        return None
    absolute = pathlib.Path(os.path.normpath(build / path))
    if not absolute.is_relative_to(root) or absolute.is_relative_to(root / 'build'):
        return None
    return str(absolute.relative_to(root))


def is_inlined(path, module):
    """Whether a frame says nothing of whose the access is: it is the sanitizer's, or of a header that others include."""
    return module.startswith(('libtsan', 'libc.so')) or path.startswith('/usr/') or path.startswith('devel/include/')


def owner_of(stack, build, root):
    """The place in this project that a stack belongs to, or None if it belongs to a library."""
    for name, path, module in stack.frames:
        if path == BUFFER_OF_ROSCPP:
            return None
        if not is_inlined(path, module):
            place = place_in_project(path, build, root)
            return f'{place}: {name}' if place else None
    return None


def is_within_one_thread(report):
    """Whether the report is a cycle of mutexes that one thread took in both orders."""
    taken = [TAKEN_IN.search(stack.heading) for stack in report.stacks]
    return len({match['thread'] for match in taken if match}) == 1


def places_of(report, build, root):
    """Where this project takes part in a report that is its own; empty if it is not."""
    if is_within_one_thread(report):
        return []
    owners = [owner_of(stack, build, root) for stack in report.stacks]
    ours = sorted({owner for owner in owners if owner})
    return ours if ours and (report.kind != 'data race' or all(owners)) else []


def sort(files, build, root=ROOT):
    """The reports of this project, as what is said -> the names of the files that say it, and how many there are of others.

    FILES are pairs of a name and its text; BUILD is the folder in which the compiler ran.
    """
    ours, others = collections.defaultdict(list), 0
    for name, text in files:
        for report in reports_in(text):
            places = places_of(report, build, root)
            if places:
                ours[f'{report.kind}: ' + ' | '.join(places)].append(name)
            else:
                others += 1
    return ours, others


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    build = pathlib.Path(sys.argv[1]).resolve()
    paths = sorted((build / 'reports').glob('thread.*'))
    ours, others = sort(((path, path.read_text(errors='replace')) for path in paths), build)
    for said, names in ours.items():
        print(f'{said}: {len(names)} times, first in {names[0]}')
    print(f'{others} reports of libraries that are not instrumented, or of one thread, are left out', file=sys.stderr)
    return 0


if __name__ == '__main__':
    sys.exit(main())
