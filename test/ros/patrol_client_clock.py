#!/usr/bin/env python3
"""The patrol's client where ROS has no time: it waits a little, heeds signals meanwhile, and gives up."""
import os
import signal
import socket
import unittest

import rostest

from wire import Node, wait_for


def handles(node, number):
    """Whether the process has installed a handler for this signal."""
    with open('/proc/%d/status' % node.process.pid) as file:
        caught = next(line for line in file if line.startswith('SigCgt:'))
    return int(caught.split()[1], 16) >> (number - 1) & 1 == 1


class PatrolClientClock(unittest.TestCase):
    def start(self):
        client = Node('patrol_client', 'square', '--side', '1')
        self.addCleanup(client.end)
        return client

    def test_it_gives_up_and_says_that_there_is_no_time(self):
        code, said = self.start().finish(15.0)
        self.assertEqual(code, 3, said)
        self.assertIn('patrol_client: there is no ROS time: /use_sim_time is set, and nobody publishes /clock', said)

    def test_it_ends_by_the_signal_and_does_not_wait_until_it_gives_up(self):
        for number, expected in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            client = self.start()
            self.assertTrue(wait_for(lambda: handles(client, number)))
            client.signal(number)
            code, said = client.finish(15.0)
            self.assertEqual(code, expected, said)

    def test_a_signal_while_a_master_is_asked_that_never_answers_is_the_reason_why_it_ends(self):
        with socket.create_server(('127.0.0.1', 0)) as silent:
            address = 'http://127.0.0.1:%d' % silent.getsockname()[1]
            client = Node('patrol_client', 'square', environment=dict(os.environ, ROS_MASTER_URI=address))
            self.addCleanup(client.end)
            silent.settimeout(10.0)
            question, _ = silent.accept()
            with question:
                client.signal(signal.SIGTERM)
                code, said = client.finish(15.0)
        self.assertEqual(code, 143, said)
        self.assertEqual(said, '')

    def test_a_wrong_number_is_an_error_of_the_command_line(self):
        client = Node('patrol_client', 'square', '--side', '-1')
        self.addCleanup(client.end)
        code, said = client.finish(15.0)
        self.assertEqual(code, 2)
        self.assertEqual(said, "patrol_client: --side must be above 0 m, not -1; 'patrol_client --help' lists what it takes\n")


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'patrol_client_clock', PatrolClientClock)
