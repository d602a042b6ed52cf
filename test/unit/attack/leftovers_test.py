#!/usr/bin/env python3
"""Processes that were started with a mark end with the one that has started them, however that one ends."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SCRIPTS = str(pathlib.Path(__file__).resolve().parents[3] / 'scripts')
sys.path.insert(0, SCRIPTS)
import leftovers  # noqa: E402

PARENT = """
import os, subprocess, sys, time
sys.path.insert(0, %r)
import leftovers
leftovers.end_after_this_process('LEFTOVERS_TEST', *sys.argv[1:])
os.environ['LEFTOVERS_TEST'] = sys.argv[1]
subprocess.Popen(['sleep', '60'], start_new_session=True)
print('started', flush=True)
time.sleep(60)
""" % SCRIPTS


def becomes(condition, seconds=10.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


class Leftovers(unittest.TestCase):
    def test_what_was_started_ends_with_its_parent_also_if_that_was_killed(self):
        """[FLT-2]"""
        for number in (signal.SIGKILL, signal.SIGTERM):
            value = '%d-%d' % (os.getpid(), number)
            parent = subprocess.Popen([sys.executable, '-c', PARENT, value], stdout=subprocess.PIPE)
            self.addCleanup(parent.stdout.close)
            self.addCleanup(leftovers.end, 'LEFTOVERS_TEST', value)
            self.assertEqual(parent.stdout.readline(), b'started\n')
            self.assertTrue(becomes(lambda: len(leftovers.find('LEFTOVERS_TEST', value)) == 1), 'it was not started')
            parent.send_signal(number)
            parent.wait(10.0)
            self.assertTrue(becomes(lambda: not leftovers.find('LEFTOVERS_TEST', value)), number)

    def test_its_folder_goes_with_a_parent_that_could_not_remove_it(self):
        """[FLT-2]"""
        for number in (signal.SIGKILL, signal.SIGTERM):
            with tempfile.TemporaryDirectory() as above:
                folder = os.path.join(above, 'folder')
                os.mkdir(folder)
                pathlib.Path(folder, 'starts.yaml').write_text('robots: []')
                parent = subprocess.Popen([sys.executable, '-c', PARENT, folder, folder], stdout=subprocess.PIPE)
                self.addCleanup(parent.stdout.close)
                self.addCleanup(leftovers.end, 'LEFTOVERS_TEST', folder)
                self.assertEqual(parent.stdout.readline(), b'started\n')
                self.assertTrue(os.path.exists(folder))
                parent.send_signal(number)
                parent.wait(10.0)
                self.assertTrue(becomes(lambda: not os.path.exists(folder)), number)


if __name__ == '__main__':
    unittest.main()
