"""Finds and ends processes that were started with a mark in their environment and have outlived what started them."""
import glob
import os
import signal
import time

PATIENCE = 3.0  # for a process to end on SIGTERM [s]


def find(name, value):
    """The numbers of all processes of this user whose environment, as they were started, has name=value, but for this one."""
    entry = os.fsencode('%s=%s' % (name, value))
    found = []
    for path in glob.glob('/proc/[0-9]*/environ'):
        try:
            with open(path, 'rb') as file:
                marked = entry in file.read().split(b'\0')
        except OSError:  # it has ended, or belongs to somebody else
            continue
        process = int(path.split('/')[2])
        if marked and process != os.getpid():
            found.append(process)
    return found


def end(name, value):
    """Ends them by SIGTERM, and by SIGKILL if that takes too long."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        for process in find(name, value):
            try:
                os.kill(process, number)
            except ProcessLookupError:
                pass
        deadline = time.monotonic() + PATIENCE
        while find(name, value) and time.monotonic() < deadline:
            time.sleep(0.05)
