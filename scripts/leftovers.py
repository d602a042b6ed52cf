"""Lets no process outlive what started it: this one ends with its parent, and those that were started with a mark in their
environment are found and ended."""
import ctypes
import glob
import os
import shutil
import signal
import time

PATIENCE = 3.0  # for a process to end on SIGTERM [s]
STARTING = 0.1  # a process that is being started has no environment for a moment, and is not found [s]
_SET_PARENT_DEATH_SIGNAL = 1
_prctl = ctypes.CDLL(None).prctl  # not looked for between fork and exec


def end_with_the_parent():
    """The kernel sends SIGTERM to this process when its parent dies without a word."""
    _prctl(_SET_PARENT_DEATH_SIGNAL, signal.SIGTERM)


def end_after_this_process(name, value, folder=None):
    """Starts a process that waits until this one has ended, in whatever way, and then ends all that have name=value in their
    environment, and removes the folder if this one has not."""
    reading, writing = os.pipe()
    if os.fork() > 0:
        os.close(reading)  # the other end stays open for as long as this process lives
        return
    try:
        os.setsid()  # a Ctrl-C does not reach it
        os.close(writing)
        os.read(reading, 1)
        end(name, value)
        if folder:
            shutil.rmtree(folder, ignore_errors=True)
    finally:
        os._exit(0)  # whatever happens, it must not go on with the work of the process that it was forked from


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
    time.sleep(STARTING)
    for number in (signal.SIGTERM, signal.SIGKILL):
        for process in find(name, value):
            try:
                os.kill(process, number)
            except ProcessLookupError:
                pass
        deadline = time.monotonic() + PATIENCE
        while find(name, value) and time.monotonic() < deadline:
            time.sleep(0.05)
