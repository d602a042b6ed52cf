#!/usr/bin/env python3
"""What a run of days says fits on the disk."""
import os
import pathlib
import signal
import stat
import subprocess
import tempfile
import unittest

import rostest

WRITER = pathlib.Path(__file__).resolve().parents[2] / 'scripts/bounded_log.py'
SIZE = 100000


class BoundedLog(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.log = os.path.join(self.folder.name, 'log')

    def tearDown(self):
        self.folder.cleanup()

    def write(self, text, size=SIZE):
        return subprocess.run([WRITER, self.log, str(size)], input=text, timeout=30, check=False).returncode

    def kept(self):
        older = pathlib.Path(self.log + '.1')
        return (older.read_bytes() if older.exists() else b'') + pathlib.Path(self.log).read_bytes()

    def test_keeps_all_of_what_is_short(self):
        self.assertEqual(0, self.write(b'hello\n'))
        self.assertEqual(b'hello\n', self.kept())
        self.assertEqual(['log'], os.listdir(self.folder.name))

    def test_keeps_the_end_of_what_is_long(self):
        """[FLT-1]"""
        lines = b''.join(b'line %d\n' % i for i in range(200000))
        self.assertEqual(0, self.write(lines))
        self.assertLessEqual(len(self.kept()), SIZE)
        self.assertGreaterEqual(len(self.kept()), SIZE // 2)
        self.assertTrue(lines.endswith(self.kept()))
        self.assertEqual({'log', 'log.1'}, set(os.listdir(self.folder.name)))

    def test_follows_no_link(self):
        """[FLT-1]"""
        victim = pathlib.Path(self.folder.name, 'victim')
        victim.write_text('precious')
        for name in ('', '.1'):
            os.symlink(victim, self.log + name)
        self.assertEqual(0, self.write(b'x' * 3 * SIZE))
        self.assertEqual('precious', victim.read_text())

    def test_a_device_is_not_replaced(self):
        """[FLT-1]"""
        os.symlink('/dev/full', self.log)
        self.assertEqual(0, self.write(b'x'))
        if os.getuid() == 0:  # only root may make one
            self.log += '.device'
            os.mknod(self.log, 0o600 | stat.S_IFCHR, os.makedev(1, 7))
            self.assertEqual(1, self.write(b'x'))
            self.assertTrue(stat.S_ISCHR(os.lstat(self.log).st_mode))

    def test_a_log_that_cannot_be_written_holds_nobody_up(self):
        """[FLT-1]"""
        os.mkdir(self.log)
        self.assertEqual(1, self.write(b'x' * 10 * SIZE))

    def test_a_size_that_no_log_can_have_is_refused(self):
        """[FLT-1]"""
        for size, words in ((0, 'must be from 1000'), (-5, 'must be from 1000'), (999, 'must be from 1000'), ('many', 'invalid'),
                            ('9' * 5000, 'invalid'), (10 ** 16, 'must be from 1000')):
            done = subprocess.run([WRITER, self.log, str(size)], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=30, text=True)
            self.assertEqual(2, done.returncode)
            self.assertRegex(done.stderr, '^bounded_log.py: argument size: .*%s.*\n$' % words)
        self.assertEqual(0, self.write(b'x' * 5000, 1000))
        self.assertLessEqual(len(self.kept()), 1000)

    def test_hears_the_last_words(self):
        with subprocess.Popen([WRITER, self.log], stdin=subprocess.PIPE) as writer:
            writer.stdin.write(b'first\n')
            writer.stdin.flush()
            while not os.path.exists(self.log) or not self.kept():  # its handlers are in place by then
                self.assertIsNone(writer.poll())
            for number in (signal.SIGINT, signal.SIGTERM):
                writer.send_signal(number)
            writer.stdin.write(b'last\n')
            writer.stdin.close()
            self.assertEqual(0, writer.wait(10))
        self.assertEqual(b'first\nlast\n', self.kept())


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'bounded_log', BoundedLog)
