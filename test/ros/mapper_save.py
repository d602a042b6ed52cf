#!/usr/bin/env python3
"""A large map is saved while the mapper goes on saying where the robot is."""
import os
import shutil
import tempfile
import time
import unittest

import rospy
import rostest
from frontier_pilot.srv import LoadMap, SaveMap
from tf2_msgs.msg import TFMessage

from wire import Record, wait_for

KEY_OF_ZERO = 32768
DEPTH = 16
HEIGHT = 3   # the layer of the scanner, in cells
FAR = 1780   # [cells] from the middle: a map of 180 m x 180 m


def octree(cells):
    """OctoMap's binary file of a tree whose only leaves are free cells at the scanner's height."""
    keys = [(x + KEY_OF_ZERO, y + KEY_OF_ZERO, HEIGHT + KEY_OF_ZERO) for x, y in cells]
    data, nodes = bytearray(), 1

    def write(inside, depth):
        nonlocal nodes
        bit = DEPTH - 1 - depth
        children = {}
        for key in inside:
            child = sum(((key[axis] >> bit) & 1) << axis for axis in range(3))
            children.setdefault(child, []).append(key)
        nodes += len(children)
        kind = 1 if depth + 1 == DEPTH else 3  # a free leaf, or a node with children
        data.extend(sum(kind << (2 * child) for child in children).to_bytes(2, 'little'))
        if depth + 1 < DEPTH:
            for child in sorted(children):
                write(children[child], depth + 1)

    write(keys, 0)
    header = '# Octomap OcTree binary file\nid OcTree\nsize %d\nres 0.05\ndata\n' % nodes
    return header.encode() + bytes(data)


class SaveWhileMapping(unittest.TestCase):
    def setUp(self):
        rospy.init_node('mapper_save')
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.transforms = Record('/tf', TFMessage)

    def test_map_to_odom_goes_on_while_a_large_map_is_saved(self):  # [MAP-5]
        large = os.path.join(self.folder, 'large.bt')
        with open(large, 'wb') as file:
            file.write(octree([(-FAR, -FAR), (FAR, FAR)]))
        rospy.wait_for_service('mapper/load_map', 30.0)
        answer = rospy.ServiceProxy('mapper/load_map', LoadMap)(large)
        self.assertTrue(answer.success, answer.message)
        save = rospy.ServiceProxy('mapper/save_map', SaveMap)
        during, took = 0, 0.0
        for i in range(3):
            seen = len(self.transforms.items)
            self.assertTrue(wait_for(lambda: len(self.transforms.items) > seen))
            start, began = rospy.Time.now(), time.monotonic()
            answer = save(os.path.join(self.folder, 'copy%d' % i))
            end, took = rospy.Time.now(), took + time.monotonic() - began
            self.assertTrue(answer.success, answer.message)
            self.assertGreater(os.path.getsize(os.path.join(self.folder, 'copy%d.pgm' % i)), 12000000)
            self.assertTrue(wait_for(lambda: self.sent_at(-1) > end))
            during += sum(start < self.sent_at(i) < end for i in range(seen, len(self.transforms.items)))
        print('%d transforms in %.2f s of saving' % (during, took))
        # One every 50 ms; a map that is copied and a machine that is busy may hold up every other one.
        self.assertGreater(during, took / 0.05 / 2)

    def sent_at(self, i):
        """They are dated ahead by tf_lead."""
        return self.transforms.items[i][1].transforms[0].header.stamp - rospy.Duration(0.1)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'mapper_save', SaveWhileMapping)
