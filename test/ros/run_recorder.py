#!/usr/bin/env python3
"""The recorder on the wire: what it records, how much, and what it says when it cannot. [REC-1]"""
import glob
import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import unittest
import unittest.mock
import xmlrpc.client

import rosbag
import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from frontier_pilot.msg import ProcessLoads
from nav_msgs.msg import OccupancyGrid
from std_msgs.msg import Bool, String

from rosgraph_msgs.msg import Log

from wire import find_node, wait_for

MEGA = 1 << 20


class RunRecorder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.join(folder.name, 'runs')
        self.said, self.loads, self.log = [], [], []
        for topic, kind, take in (('/diagnostics', DiagnosticArray, self.take_diagnostics),
                                  ('/rosout', Log, lambda line: self.log.append((line.name, line.msg))),
                                  ('run_recorder/load', ProcessLoads, self.loads.append)):
            subscriber = rospy.Subscriber(topic, kind, take)
            self.addCleanup(subscriber.unregister)

    def take_diagnostics(self, array):
        self.said += [(status.level, status.message) for status in array.status]

    def start(self, environment=None, **parameters):
        words = ['_%s:=%s' % item for item in {'folder': self.folder, 'period': 0.5, 'min_space': 1, **parameters}.items()]
        process = subprocess.Popen([find_node('frontier_pilot', 'run_recorder'), *words, 'scan:=/lidar'], stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, universal_newlines=True, env=dict(os.environ, **environment or {}))
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def parts(self):
        return glob.glob(self.folder + '/*/run_*')

    def is_recording(self, topic):
        return wait_for(lambda: topic.get_num_connections() > 0 and self.parts() and self.loads, 60.0)

    def end(self, process, number=signal.SIGINT):
        process.send_signal(number)
        process.wait(30)
        self.assertTrue(wait_for(lambda: self.parts() and not any(part.endswith('.active') for part in self.parts()), 30.0))

    def messages(self):
        found = {}
        for part in self.parts():
            with rosbag.Bag(part) as bag:
                for topic, message, _ in bag.read_messages():
                    found.setdefault(topic, []).append(message)
        return found

    def test_a_run_holds_the_topics_the_parameters_and_the_load_of_the_nodes(self):
        stalled = rospy.Publisher('simulator/stalled', Bool, queue_size=1, latch=True)
        rospy.set_param('mapper/map_file', 'floor')
        process = self.start()
        stalled.publish(True)
        self.assertTrue(self.is_recording(stalled))
        self.assertTrue(wait_for(lambda: any(one.node == rospy.get_name() for load in self.loads for one in load.processes), 30.0))
        count = len(self.loads)  # rosbag may not listen to all topics yet
        self.assertTrue(wait_for(lambda: len(self.loads) > count + 10, 60.0))
        rospy.set_param('mapper/map_file', 'other')
        self.end(process)
        self.assertEqual(process.returncode, 0)
        found = self.messages()
        self.assertTrue(found['/simulator/stalled'][0].data)
        infos = [json.loads(message.data) for message in found['/run_recorder/info']]
        start, end = infos[0], infos[-1]
        self.assertEqual((start['moment'], end['moment']), ('start', 'end'))
        self.assertEqual([info['parameters']['mapper']['map_file'] for info in (start, end)], ['floor', 'other'])
        self.assertEqual(start['topics']['scan'], '/lidar')
        load = {one.node: one for message in found['/run_recorder/load'] for one in message.processes}
        self.assertEqual(load[rospy.get_name()].pid, os.getpid())
        self.assertGreater(load['/run_recorder'].memory, MEGA)
        self.assertGreaterEqual(load['master'].cpu, 0.0)

    # [FLT-1] ROS shuts a node down when another one registers with its name.
    def test_a_second_one_of_the_same_name_refuses_to_start(self):
        process = self.start()
        self.assertTrue(wait_for(lambda: self.loads, 60.0))
        second = self.start()
        said, _ = second.communicate(timeout=60)
        self.assertEqual(second.returncode, 1, said)
        self.assertRegex(said, '^run_recorder: a node /run_recorder is already running, .*\n$')
        count = len(self.loads)
        self.assertTrue(wait_for(lambda: len(self.loads) > count + 2, 30.0))
        self.end(process)
        self.assertEqual(process.returncode, 0)

    def test_a_connection_that_ends_before_its_header_is_no_news(self):
        process = self.start()
        self.assertTrue(wait_for(lambda: self.loads, 60.0))
        recorder = xmlrpc.client.ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode('/run_recorder'))
        _, host, port = recorder.requestTopic(rospy.get_name(), '/run_recorder/load', [['TCPROS']])[2]
        for _ in range(5):
            socket.create_connection((host, port), 10.0).close()
        count = len(self.loads)
        self.assertTrue(wait_for(lambda: len(self.loads) > count + 2, 30.0))
        self.end(process)
        self.assertNotIn('Inbound', process.stdout.read())
        self.assertFalse(self.has_logged('Inbound'))

    def test_a_run_that_is_full_loses_its_oldest_part(self):
        grid = OccupancyGrid()
        grid.data = [byte - 128 for byte in os.urandom(MEGA // 8)]  # nothing that can be compressed
        publisher = rospy.Publisher('map', OccupancyGrid, queue_size=1)
        process = self.start(size=10)
        self.assertTrue(self.is_recording(publisher))
        for number in range(200):
            grid.info.width = number
            publisher.publish(grid)
            rospy.sleep(0.03)
        self.end(process)
        self.assertLess(sum(os.path.getsize(part) for part in self.parts()), 12 * MEGA)
        found = self.messages()
        self.assertEqual(max(message.info.width for message in found['/map']), 199)
        self.assertNotIn(0, [message.info.width for message in found['/map']])
        self.assertIn('/run_recorder/info', found, 'a part that is left does not say what the run is')

    def test_a_full_disk_is_named_in_the_diagnostics(self):
        process = self.start(min_space=int(1e9))
        self.assertTrue(wait_for(lambda: any(level == 2 and 'the disk of ' + self.folder in text and 'is full' in text
                                             for level, text in self.said), 60.0), self.said)
        self.assertIsNone(process.poll())

    def test_a_folder_may_be_given_from_the_home_of_the_user(self):
        with unittest.mock.patch.dict(os.environ, HOME=os.path.dirname(self.folder)):
            process = self.start(folder='~/runs')
        self.assertTrue(wait_for(self.parts, 60.0))
        self.end(process)

    def test_a_folder_that_cannot_be_made_is_named_in_the_diagnostics(self):
        with open(self.folder, 'w'):
            pass
        process = self.start()
        self.assertTrue(wait_for(lambda: any(level == 2 and self.folder in text for level, text in self.said), 60.0), self.said)
        self.assertIsNone(process.poll())

    def has_logged(self, words):
        return any(name == '/run_recorder' and words in text for name, text in self.log)

    def test_without_a_home_for_its_own_log_it_says_on_the_terminal_why_nothing_is_recorded(self):
        process = self.start({'ROS_HOME': '/proc/none', 'ROS_LOG_DIR': '/proc/none/log'}, folder='/proc/none/runs')
        self.assertTrue(wait_for(lambda: any('/proc/none' in text for _, text in self.said), 60.0), self.said)
        process.send_signal(signal.SIGINT)
        self.assertIn('nothing is recorded: /proc/none', process.communicate(timeout=30)[0])

    def test_a_rosbag_that_is_killed_is_started_again_and_the_run_goes_on(self):
        stalled = rospy.Publisher('simulator/stalled', Bool, queue_size=1, latch=True)
        process = self.start()
        self.assertTrue(self.is_recording(stalled))
        rosbag_node = xmlrpc.client.ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode('/run_recorder_rosbag'))
        os.kill(rosbag_node.getPid(rospy.get_name())[2], signal.SIGKILL)
        self.assertTrue(wait_for(lambda: any('rosbag has ended (exit code -9)' in text for _, text in self.said), 30.0), self.said)
        self.assertTrue(wait_for(lambda: glob.glob(self.folder + '/*/run_2_0.bag.active'), 60.0), self.parts())
        self.assertTrue(wait_for(lambda: self.has_logged('recording goes on'), 30.0), self.log)
        self.assertTrue(wait_for(lambda: stalled.get_num_connections() > 0, 30.0))
        stalled.publish(True)
        process.send_signal(signal.SIGINT)
        process.wait(30)
        second = glob.glob(self.folder + '/*/run_2_0.bag')
        self.assertEqual(len(second), 1, self.parts())
        with rosbag.Bag(second[0]) as bag:
            found = [topic for topic, _, _ in bag.read_messages()]
        self.assertIn('/run_recorder/info', found, 'the second stretch does not say what the run is')

    def test_a_run_whose_folder_is_removed_is_followed_by_another(self):
        process = self.start()
        self.assertTrue(wait_for(lambda: self.parts() and self.loads, 60.0))
        before = os.path.dirname(self.parts()[0])
        shutil.rmtree(self.folder)
        self.assertTrue(wait_for(lambda: self.parts() and os.path.dirname(self.parts()[0]) != before, 30.0), '[REC-1] [FLT-1]')
        self.assertTrue(any('is gone, a new one begins' in line for _, line in self.log))
        self.end(process)
        self.assertIn('recorded', process.stdout.read())

    def test_a_record_that_ended_on_a_full_disk_goes_on_when_there_is_room_again(self):
        os.makedirs(self.folder)
        if subprocess.call(['mount', '-t', 'tmpfs', '-o', 'size=60m', 'tmpfs', self.folder], stderr=subprocess.DEVNULL):
            self.skipTest('only root may make a small disk')
        self.addCleanup(subprocess.call, ['umount', '--lazy', self.folder])
        process = self.start(min_space=30, size=10)
        self.assertTrue(wait_for(lambda: glob.glob(self.folder + '/*/run_0.bag.active'), 60.0))
        other = self.folder + '/something_else'
        with open(other, 'wb') as file:
            file.write(bytes(35 * MEGA))
        self.assertTrue(wait_for(lambda: self.has_logged('is full'), 90.0), self.log)  # rosbag looks at the disk every 20 s
        os.remove(other)
        self.assertTrue(wait_for(lambda: glob.glob(self.folder + '/*/run_2_0.bag.active'), 60.0), self.parts())
        self.assertTrue(wait_for(lambda: self.has_logged('recording goes on'), 30.0), self.log)
        self.end(process)
        self.assertEqual(len(glob.glob(self.folder + '/*/run_*.bag')), 2, self.parts())

    def test_a_recorder_that_is_killed_leaves_a_bag_and_no_process(self):
        info = rospy.Subscriber('run_recorder/info', String, lambda message: None)
        self.addCleanup(info.unregister)
        stalled = rospy.Publisher('simulator/stalled', Bool, queue_size=1, latch=True)
        process = self.start()
        self.assertTrue(self.is_recording(stalled))
        self.end(process, signal.SIGKILL)
        self.assertTrue(self.messages())

    def test_wrong_parameters_are_named(self):
        process = self.start(size=-1, runs='many', nonsense=1)
        out, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 2)
        for words in ('size: must be between', 'runs: must be a number', 'nonsense: there is no such parameter'):
            self.assertIn(words, out)


if __name__ == '__main__':
    rospy.init_node('recording_test')
    rostest.rosrun('frontier_pilot', 'recording', RunRecorder)
