#!/usr/bin/env python3
"""Writes what comes in to FILE, which never takes more than SIZE bytes on the disk: when the first half is full it moves
to FILE.1, in the place of what was there, and a new half begins. The oldest lines are lost, the latest are kept.

Usage: bounded_log.py FILE [SIZE]    SIZE: 20000000 if not given

It ends with its input, and not by Ctrl-C: those who write to it have last words.
"""
import os
import signal
import sys


def open_new(path):
    """A file of this name that was not there before; nobody's link is followed."""
    try:
        os.unlink(path)
    except FileNotFoundError:
        pass
    return os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC, 0o644)


def copy(source, path, size):
    half = max(1, size // 2)
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
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    try:
        copy(sys.stdin.fileno(), sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else 20000000)
    except OSError as error:
        print('bounded_log.py: %s' % error, file=sys.stderr)
        while os.read(sys.stdin.fileno(), 65536):  # those who write must not be held up by a full disk
            pass
        sys.exit(1)


if __name__ == '__main__':
    main()
