"""How the tests of scripts/run start it, and what they look for after it."""
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import termios
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'scripts'))
import leftovers  # noqa: E402
from run_attack.processes import free_port  # noqa: E402

RUN = str(ROOT / 'scripts/run')


def environment(port, home):
    kept = {name: value for name, value in os.environ.items() if not name.startswith(('ROS_', 'DISPLAY'))}
    return dict(kept, ROS_MASTER_URI='http://127.0.0.1:%d' % port, ROS_IP='127.0.0.1', ROS_HOME=home)


def command_of(process):
    try:
        return pathlib.Path('/proc/%d/cmdline' % process).read_bytes().replace(b'\0', b' ')
    except OSError:
        return process  # it has ended meanwhile


def heed_ctrl_c():
    """A shell starts what runs in its background with SIGINT ignored, and bash cannot trap what was ignored when it began."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class RunTestCase(unittest.TestCase):
    """Runs scripts/run in a folder and at a master of its own, with the build that FRONTIER_PILOT_BUILD names."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.port = free_port()

    def start(self, *words, **how):
        how = dict({'stdout': subprocess.PIPE, 'stderr': subprocess.PIPE, 'stdin': subprocess.DEVNULL, 'start_new_session': True,
                    'preexec_fn': heed_ctrl_c, 'env': environment(self.port, self.folder.name)}, **how)
        return subprocess.Popen([RUN, *words], cwd=self.folder.name, universal_newlines=True, **how)

    def start_in_terminal(self, *words):
        """Like `start`, in a terminal of its own, which closes with the returned process' stdout. As after `stty tostop`, it stops what
        writes to it from the background."""
        screen, terminal = os.openpty()
        attributes = termios.tcgetattr(terminal)
        attributes[3] |= termios.TOSTOP
        termios.tcsetattr(terminal, termios.TCSANOW, attributes)
        process = self.start(*words, stdin=terminal, stdout=terminal, stderr=terminal, start_new_session=False,
                             preexec_fn=lambda: (os.login_tty(os.dup(terminal)), heed_ctrl_c()))
        os.close(terminal)
        process.stdout = open(screen, errors='replace')
        return process

    def start_with(self, roslaunch):
        """The running script once it launches, with this function of bash in place of roslaunch."""
        process = self.start(env=dict(environment(self.port, self.folder.name), **{'BASH_FUNC_roslaunch%%': roslaunch}))
        self.addCleanup(process.communicate)
        line = process.stdout.readline()
        while line and not line.startswith('Launching'):
            line = process.stdout.readline()
        return process

    def run_to_the_end(self, *words):
        process = self.start(*words)
        out, err = process.communicate(timeout=300)
        return process.returncode, out, err

    def processes(self):
        """Those of the run: they have its master's address in their environment."""
        return leftovers.find('ROS_MASTER_URI', 'http://127.0.0.1:%d' % self.port)

    def assert_nothing_is_left(self):
        self.assertEqual([command_of(process) for process in self.processes()], [])
        with socket.socket() as probe:
            self.assertNotEqual(probe.connect_ex(('127.0.0.1', self.port)), 0, 'a master is left')
