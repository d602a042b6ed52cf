"""What the command lines of the Python programs have in common."""
import argparse
import codecs
import errno
import os
import signal
import sys


def _open_closed_streams():
    """A standard stream that was closed (>&-) is None, and its number would be given to the next file."""
    for number, name, mode in ((0, 'stdin', 'r'), (1, 'stdout', 'w'), (2, 'stderr', 'w')):
        if getattr(sys, name) is None:
            os.dup2(os.open(os.devnull, os.O_RDWR), number)
            setattr(sys, name, open(number, mode))


_open_closed_streams()
# A path that is not valid text is printed byte for byte as it was given; a letter that the output cannot take (PYTHONIOENCODING=ascii)
# by its number.
if sys.stdout.errors == 'strict':
    sys.stdout.reconfigure(errors='surrogateescape' if codecs.lookup(sys.stdout.encoding).name == 'utf-8' else 'backslashreplace')


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

    def print_help(self, file=None):
        if not _written(self.format_help()):
            sys.exit(1)

    def error(self, message):
        say("%s: %s; '%s --help' lists what it takes" % (self.prog, message, self.prog), sys.stderr)
        sys.exit(2)


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


def printable(text, most=500):
    """A text from outside for a line of the log: without control characters, and no longer than `most`."""
    shown = ''.join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in text[:most])
    return shown if len(text) <= most else shown + '...'


def end_quietly_until_main():
    """From now on a Ctrl-C ends the process without a traceback: for a program whose imports take a second. Ended by exit_with."""
    if signal.getsignal(signal.SIGINT) == signal.default_int_handler:  # it is ignored in the background of a script
        signal.signal(signal.SIGINT, signal.SIG_DFL)


_TOLD_TO_END = signal.SIGINT, signal.SIGTERM, signal.SIGHUP


def clean_up_when_told_to_end():
    """From now on Ctrl-C, SIGTERM and SIGHUP end the process by way of SystemExit, so that its temporary files are removed. Further
    signals do not interrupt that. What is ignored stays ignored: SIGHUP by nohup, Ctrl-C in the background of a script."""
    for number in _TOLD_TO_END:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, _end)


def _end(number, _):
    end_undisturbed()
    sys.exit(128 + number)


def end_undisturbed():
    """From now on what clean_up_when_told_to_end has begun to heed does nothing: the work is done, or is being left. It would interrupt
    what libraries do last, where Python prints a traceback and goes on with the exit code of before."""
    for number in _TOLD_TO_END:
        if signal.getsignal(number) == _end:
            signal.signal(number, signal.SIG_IGN)


def _drop_what_stderr_does_not_take():
    """Python would try once more at its end, and give an exit code of its own, 120."""
    try:
        if sys.stderr:
            sys.stderr.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())


def exit_with(main):
    """Ends the program with what `main` returns, or with the exit code for a Ctrl-C; with 1 and one line if what it printed cannot be
    written, if the ROS master has ended, or for any other exception."""
    if signal.getsignal(signal.SIGINT) == signal.SIG_DFL:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        code = main()
    except KeyboardInterrupt:
        code = 130
    except ConnectionRefusedError:
        say('%s: the ROS master has ended' % os.path.basename(sys.argv[0]), sys.stderr)
        code = 1
    except SystemExit as end:  # --help, for example
        code = end.code
    except Exception as error:  # of a library in surroundings that nobody thought of, or a defect
        if os.environ.get('FRONTIER_PILOT_TRACEBACK'):
            raise
        say("%s: failed with %s: %s; with FRONTIER_PILOT_TRACEBACK=1 it says where" % (
            os.path.basename(sys.argv[0]), type(error).__name__, printable(str(error))), sys.stderr)
        code = 1
    end_undisturbed()
    code = code if _written() else code or 1
    _drop_what_stderr_does_not_take()
    sys.exit(code)


def answered(text):
    """Prints the line that a program was called for, and returns whether it could be written; says so if not."""
    return _written(text + '\n')


def _written(text=''):
    """Whether `text` and all that was printed before could be written; says so if not."""
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # else Python tries again, and prints a traceback
        if error.errno != errno.EPIPE:
            say('%s: cannot write its output: %s' % (os.path.basename(sys.argv[0]), error.strerror), sys.stderr)
        return False
    return True
