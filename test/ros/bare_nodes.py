#!/usr/bin/env python3
"""Every node starts by itself, without one parameter, offers what its --help names, and ends on SIGINT without complaint."""
import os
import signal
import subprocess
import unittest

import rosgraph
import rostest

from wire import SANITIZED, Node, find_node, wait_for

NODES = ('cmd_vel_arbiter', 'obstacle_avoider', 'patrol_server', 'behavior_server', 'mapper', 'navigator', 'frontier_explorer',
         'waypoint_follower', 'fleet_stop', 'teleop_gui')


def is_up(name):
    """Whether it has come as far as its diagnostics, which nodes advertise with all the rest; the window has none."""
    topics = dict(rosgraph.Master('/bare_nodes').getSystemState()[0])
    return '/' + name in topics.get('/cmd_vel_manual' if name == 'teleop_gui' else '/diagnostics', [])


def own_names(name):
    """The topics and services of a node at the master, without those that every node has and those of its actions."""
    publishers, subscribers, services = rosgraph.Master('/bare_nodes').getSystemState()
    of_all = ('/rosout', '/diagnostics', '/clock')
    found = {topic for topic, nodes in publishers + subscribers + services if '/' + name in nodes} - set(of_all)
    loggers = {'/%s/%s' % (name, service) for service in ('get_loggers', 'set_logger_level')}
    actions = {topic[:-len('/cancel')] for topic in found if topic.endswith('/cancel')}
    parts = {action + part for action in actions for part in ('/goal', '/cancel', '/status', '/feedback', '/result')}
    return (found - loggers - parts) | actions


def names_in_help(name):
    """The same by its --help, with a leading slash."""
    words = subprocess.run([find_node('frontier_pilot', name), '--help'], stdout=subprocess.PIPE, universal_newlines=True).stdout.split()
    return {'/' + word.lstrip('/') for word in words}


class BareNodes(unittest.TestCase):
    def test_start_and_end_without_complaint(self):
        self.check(NODES)

    def test_the_one_that_publishes_the_map_as_the_mapper_does_starts_without_it(self):
        self.check(('map_merger',))

    @unittest.skipIf(SANITIZED, 'the sanitizer itself opens files')
    def test_which_may_hardly_open_a_file_say_so_and_end(self):
        """[FLT-1]"""
        for name in NODES:
            for limit in ('4', '12'):
                ended = subprocess.run(['prlimit', '--nofile=' + limit, find_node('frontier_pilot', name)], stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, universal_newlines=True, timeout=30)
                self.assertEqual(ended.returncode, 1, (name, limit, ended.stdout))
                self.assertIn('may open %s files and connections, and a node needs 32' % limit, ended.stdout, name)

    def check(self, names):
        os.environ['QT_QPA_PLATFORM'] = 'offscreen'
        nodes = {name: Node(name) for name in names}
        for node in nodes.values():
            self.addCleanup(node.end)
        came_up = {name: wait_for(lambda: node.has_ended() or is_up(name), 30.0) for name, node in nodes.items()}
        # roscpp's own service crashes its node when it is asked a second time. [FLT-1]
        services = [name for name, _ in rosgraph.Master('/bare_nodes').getSystemState()[2]]
        offered = {name for name in names if '/%s/get_loggers' % name in services}
        unsaid = {name: own_names(name) - names_in_help(name) for name in names}
        self.assertEqual(offered, set(), '[FLT-1]')
        self.assertEqual(unsaid, {name: set() for name in names}, '--help does not name them')
        # The last ones call the first ones: roscpp says an ERROR about a call of a service that an ending node has just taken back.
        for name, node in reversed(list(nodes.items())):
            if not node.has_ended():
                node.signal(signal.SIGINT)
            code, said = node.finish(15.0)
            self.assertTrue(came_up[name], (name, said))
            self.assertEqual(code, 0, (name, said))
            self.assertNotIn('[ERROR]', said, name)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'bare_nodes', BareNodes)
