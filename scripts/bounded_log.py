#!/usr/bin/env python3
"""Writes its standard input to FILE and keeps no more than the last SIZE bytes on the disk: when FILE has half of that,
it is renamed to FILE.1, which replaces an older FILE.1, and a new FILE is begun.

It ends when its input ends, and ignores SIGINT and SIGTERM, so that the last output of the writing processes is kept.
"""
import argparse
import os
import signal
import stat
import sys

from command_line import CommandLine

LEAST_SIZE, MOST_SIZE = 1000, 10 ** 15  # a file of a few bytes would be renamed at each line


def open_new(path):
    """Creates a new file of this name; an existing file is removed, and a symbolic link is not followed. A device is an error."""
    try:
        kind = os.lstat(path).st_mode
        if stat.S_ISCHR(kind) or stat.S_ISBLK(kind):
            raise OSError('%s is a device' % path)
        os.unlink(path)
    except FileNotFoundError:
        pass
    return os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC, 0o644)


def size_in(text):
    size = int(text)
    if not LEAST_SIZE <= size <= MOST_SIZE:
        raise argparse.ArgumentTypeError('must be from %d to %d bytes, not %d' % (LEAST_SIZE, MOST_SIZE, size))
    return size


def copy(source, path, size):
    half = size // 2
    target, written = open_new(path), 0
    while True:
        chunk = os.read(source, 65536)
        if not chunk:
            return
        while chunk:
            if written >= half:
                os.close(target)
                os.replace(path, path + '.1')
                target, written = open_new(path), 0
            count = os.write(target, chunk[:half - written])
            chunk, written = chunk[count:], written + count


def main():
    parser = CommandLine(__doc__, 'roslaunch ... 2>&1 | scripts/bounded_log.py /tmp/log 1000000')
    parser.add_argument('file')
    parser.add_argument('size', nargs='?', type=size_in, default=20000000, help='in bytes (20000000)')
    arguments = parser.parse_args()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    try:
        copy(sys.stdin.fileno(), arguments.file, arguments.size)
    except OSError as error:
        print('bounded_log.py: %s' % error, file=sys.stderr)
        while os.read(sys.stdin.fileno(), 65536):  # a full disk must not block the writing processes
            pass
        sys.exit(1)


if __name__ == '__main__':
    main()
