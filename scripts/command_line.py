"""What the command lines of the Python programs have in common."""
import argparse
import errno
import os
import signal
import sys


class CommandLine(argparse.ArgumentParser):
    """A parser that prints the docstring of a program for --help, and one line with exit code 2 for a wrong argument."""

    def __init__(self, doc, example):
        super().__init__(description=doc, epilog='example:\n  ' + example,
                         formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)

    def parse_args(self, words=None):
        words = sys.argv[1:] if words is None else words
        for word in words:  # before argparse misses what else is not given
            if word.startswith('--') and word.split('=')[0] not in self._option_string_actions:
                self.error('unknown option ' + word)
        return super().parse_args(words)

    def error(self, message):
        self.exit(2, "%s: %s; '%s --help' lists what it takes\n" % (self.prog, message, self.prog))


def say(text, stream=None):
    """Prints a line, and returns whether there is a reader. Once that, or the terminal, is gone, nothing more is written."""
    stream = stream or sys.stdout
    try:
        print(text, file=stream, flush=True)
        return True
    except OSError as error:
        if error.errno not in (errno.EPIPE, errno.EIO):
            return True  # the disk may be full for a while
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
        return False


def end_quietly_until_main():
    """From now on a Ctrl-C ends the process without a traceback: for a program whose imports take a second. Ended by exit_with."""
    if signal.getsignal(signal.SIGINT) == signal.default_int_handler:  # it is ignored in the background of a script
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def exit_with(main):
    """Ends the program with what `main` returns, or with the exit code for a Ctrl-C."""
    if signal.getsignal(signal.SIGINT) == signal.SIG_DFL:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
