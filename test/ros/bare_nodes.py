#!/usr/bin/env python3
"""Every node starts by itself, without one parameter, and ends on SIGINT without complaint."""
import os
import signal
import unittest

import rosgraph
import rostest

from wire import Node, wait_for

NODES = ('cmd_vel_arbiter', 'obstacle_avoider', 'patrol_server', 'behavior_server', 'mapper', 'navigator',
         'frontier_explorer', 'teleop_gui')


def is_up(name):
    """Whether it has come as far as its diagnostics, which nodes advertise with all the rest; the window has none."""
    topics = dict(rosgraph.Master('/bare_nodes').getSystemState()[0])
    return '/' + name in topics.get('/cmd_vel_manual' if name == 'teleop_gui' else '/diagnostics', [])


class BareNodes(unittest.TestCase):
    def test_start_and_end_without_complaint(self):
        os.environ['QT_QPA_PLATFORM'] = 'offscreen'
        nodes = {name: Node(name) for name in NODES}
        for node in nodes.values():
            self.addCleanup(node.end)
        came_up = {name: wait_for(lambda: node.has_ended() or is_up(name), 30.0) for name, node in nodes.items()}
        # roscpp's own service crashes its node when it is asked a second time. [FLT-1]
        services = [name for name, _ in rosgraph.Master('/bare_nodes').getSystemState()[2]]
        offered = {name for name in NODES if '/%s/get_loggers' % name in services}
        for node in nodes.values():
            if not node.has_ended():
                node.signal(signal.SIGINT)
        self.assertEqual(offered, set(), '[FLT-1]')
        for name, node in nodes.items():
            code, said = node.finish(15.0)
            self.assertTrue(came_up[name], (name, said))
            self.assertEqual(code, 0, (name, said))
            self.assertNotIn('[ERROR]', said, name)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'bare_nodes', BareNodes)
