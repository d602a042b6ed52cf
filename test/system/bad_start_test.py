#!/usr/bin/python3
"""What no node can go on with: each a message that names it, and an exit code that is not zero."""
import os
import socket
import subprocess
import sys
import tempfile
import unittest

import roslib.packages
import rospkg
import rospy
import rostest

sys.path.insert(0, os.path.join(rospkg.RosPack().get_path('frontier_pilot'), 'scripts'))
import leftovers  # noqa: E402

NODES = ('simulator', 'cmd_vel_arbiter', 'obstacle_avoider', 'mapper', 'map_merger', 'navigator', 'frontier_explorer', 'patrol_server',
         'behavior_server', 'fleet_stop')
WORLDS = os.path.join(rospkg.RosPack().get_path('frontier_pilot'), 'config/worlds')


def start(node, *arguments):
    """Exit code and output of a node that is expected to end by itself."""
    path = roslib.packages.find_node('frontier_pilot', node)[0]
    process = subprocess.run([path, '__name:=bad_%s' % node, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             timeout=30)
    for name in list(rospy.get_param_names()):
        if name.startswith('/bad_'):
            rospy.delete_param(name)
    return process.returncode, process.stdout.decode(errors='replace')


class BadStart(unittest.TestCase):
    def expect(self, words, node, *arguments):
        code, output = start(node, *arguments)
        self.assertNotEqual(0, code, output)
        self.assertGreater(code, 0, 'ended by a signal:\n' + output)
        for word in words:
            self.assertIn(word, output)

    def simulator(self, words, world, *arguments):
        self.expect(words, 'simulator', '_world:=' + world, *arguments)

    def test_a_simulator_without_a_world_says_so(self):  # [SIM-1]
        self.expect(['world'], 'simulator')

    def test_a_world_file_that_is_missing_is_named(self):  # [SIM-1]
        self.simulator(['/nowhere/world.yaml'], '/nowhere/world.yaml')

    def test_a_broken_world_file_is_named(self):  # [SIM-1]
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
            file.write('image: nothing.pgm\nresolution: [')
            file.flush()
            self.simulator([file.name], file.name)

    def test_a_world_whose_picture_is_missing_names_it(self):  # [SIM-1]
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
            file.write('image: nothing.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n'
                       'occupied_thresh: 0.65\nfree_thresh: 0.196\n')
            file.flush()
            self.simulator(['nothing.pgm'], file.name)

    def test_a_start_in_a_wall_is_refused(self):  # [SIM-1]
        self.simulator(['start'], os.path.join(WORLDS, 'small.yaml'), '_x:=0.02', '_y:=0.02')

    def roslaunch(self, *words):
        """What a launch on a master of its own, which runs on, says on its way to its end."""
        process = subprocess.run(['roslaunch', 'frontier_pilot', *words], env=self.environment, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, universal_newlines=True, timeout=90)
        return process.stdout

    def test_two_robots_at_one_place_are_refused_and_leave_neither_a_node_nor_a_parameter(self):  # [SIM-1] [MUL-1]
        with socket.socket() as probe:
            probe.bind(('127.0.0.1', 0))
            port = probe.getsockname()[1]
        self.environment = dict(os.environ, ROS_MASTER_URI='http://127.0.0.1:%d' % port, BAD_START='%d' % port)
        master = subprocess.Popen(['roscore', '-p', str(port)], env=dict(self.environment, BAD_START=''),
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(master.wait)
        self.addCleanup(master.terminate)
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
            file.write('robots: [{name: a, x: 1.2, y: 8.65, yaw: 0}, {name: b, x: 1.2, y: 8.66, yaw: 0}]')
            file.flush()
            said = self.roslaunch('--wait', 'robots.launch', 'robots:=' + file.name)
        self.assertIn("robot 'b' cannot start at (1.2, 8.66)", said)
        self.assertEqual(leftovers.find('BAD_START', port), [])
        said = self.roslaunch('--wait', 'simulator.launch', 'x:=999', 'y:=999')
        self.assertIn('(999, 999)', said)

    def test_a_node_that_cannot_start_ends_when_roslaunch_has_started_the_others(self):  # [SIM-1]
        """It would leave behind what it starts after the end of a required node."""
        path = roslib.packages.find_node('frontier_pilot', 'simulator')[0]
        launch = ('import subprocess, sys, time\n'
                  'node = subprocess.Popen([sys.argv[1], "__name:=bad_simulator", "__log:=" + sys.argv[2], "_world:=/nowhere/world.yaml"])\n'
                  'others = []\n'
                  'for i in range(6):\n'
                  '    time.sleep(1.0)\n'
                  '    assert node.poll() is None, "it ended before %d others were started" % (6 - i)\n'
                  '    others.append(subprocess.Popen(["sleep", "30"]))\n'
                  'code = node.wait(15)\n'
                  'for other in others: other.kill()\n'
                  'sys.exit(0 if code == 1 else 9)\n')
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.run([sys.executable, '-c', launch, path, folder + '/log'], stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, timeout=60)
        self.assertEqual(process.returncode, 0, process.stdout.decode())

    def test_every_unknown_and_bad_parameter_is_named_at_once(self):
        self.simulator(['sped', 'seed'], os.path.join(WORLDS, 'small.yaml'), '_sped:=2', '_seed:=-1')

    def test_every_node_refuses_an_unknown_parameter(self):
        for node in NODES:
            with self.subTest(node=node):
                self.expect(['no_such_parameter'], node, '_no_such_parameter:=1')


if __name__ == '__main__':
    rospy.init_node('bad_start_test')
    rostest.rosrun('frontier_pilot', 'bad_start', BadStart)
