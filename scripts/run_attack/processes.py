"""Processes of the attack: they end with the process that has started them, and by a mark that they inherit."""
import os
import random
import signal
import socket
import subprocess

import leftovers

MARK = 'FRONTIER_PILOT_ATTACK'  # in the environment of everything that an attack starts


def start(words, log=None, **environment):
    """Starts a program in a session of its own, whose output goes to the file `log`, or nowhere."""
    output = open(log, 'ab') if log else subprocess.DEVNULL
    try:
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                start_new_session=True, preexec_fn=leftovers.end_with_the_parent,
                                env=dict(os.environ, **environment))
    finally:
        if log:
            output.close()


def end(process, number=signal.SIGINT, patience=20.0):
    """Ends a process by a signal, and by SIGKILL if that takes longer than `patience` [s]. Gives its exit code."""
    if process.poll() is None:
        process.send_signal(number)
        try:
            process.wait(patience)
        except subprocess.TimeoutExpired:
            process.kill()
    return process.wait()


def free_port():
    """A port of the loopback interface on which nothing listens, and that the system gives to nobody who does not ask for it."""
    while True:
        port = random.randrange(12000, 32000)
        with socket.socket() as listener:
            try:
                listener.bind(('127.0.0.1', port))
                return port
            except OSError:
                pass
