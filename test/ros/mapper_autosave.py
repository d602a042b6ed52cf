#!/usr/bin/env python3
"""The map that a mapper leaves behind when it dies: never long behind, taken up again, and gone after an end in order."""
import glob
import math
import os
import signal
import time
import unittest

import rospkg
import rospy
import rostest
import tf2_ros
from frontier_pilot.srv import LoadMap, SaveMap
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid, Odometry
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Trigger

from wire import Node, Record, call, use_a_home_of_its_own, wait_for

SIDE = 3.0  # half of that of the room [m]
BEAMS = 180


def kept_maps():
    """When each of the mapper's kept maps was written [ns]."""
    home = os.environ.get('ROS_HOME', os.path.expanduser('~/.ros'))
    files = glob.glob(home + '/frontier_pilot/*/kept_map.mapper.bt')
    return {os.stat(file).st_mtime_ns for file in files if time.time() - os.path.getmtime(file) < 5.0}


def newest_map():
    """The kept map that was written last, without the ending of its files."""
    home = os.environ.get('ROS_HOME', os.path.expanduser('~/.ros'))
    return max(glob.glob(home + '/frontier_pilot/*/kept_map.mapper.bt'), key=os.path.getmtime)[:-len('.bt')]


def poses_of_the_session(kept):
    """The files with the pose of a kept map, which a mapper renews each second: one for each name of the session."""
    poses = glob.glob(os.path.join(os.path.dirname(kept), '..', '*', 'kept_map.mapper'))
    return [pose for pose in poses if time.time() - os.path.getmtime(pose) < 30.0]


class MapperAutosave(unittest.TestCase):
    def setUp(self):
        self.map = Record('map', OccupancyGrid)
        self.addCleanup(lambda: self.map.subscriber.unregister())
        self.addCleanup(self.forget_the_file)
        self.odometry = rospy.Publisher('odom', Odometry, queue_size=10)
        self.scans = rospy.Publisher('scan', LaserScan, queue_size=10)
        self.frames = tf2_ros.StaticTransformBroadcaster()
        mount = TransformStamped()
        mount.header.frame_id, mount.child_frame_id, mount.transform.rotation.w = 'base_footprint', 'base_scan', 1.0
        self.frames.sendTransform(mount)
        self.driven = 0.0

    def say_where(self):
        """Gives the stamp of the odometry that it sends."""
        odometry = Odometry()
        odometry.header.stamp, odometry.header.frame_id = rospy.Time.now(), 'odom'
        odometry.pose.pose.position.x, odometry.pose.pose.orientation.w = self.driven, 1.0
        self.odometry.publish(odometry)
        return odometry.header.stamp

    def drive(self):
        """One step along x in the room, and what the robot sees there."""
        self.driven += 0.02
        stamp = self.say_where()
        scan = LaserScan(angle_min=-math.pi, angle_increment=2.0 * math.pi / BEAMS, range_min=0.1, range_max=10.0)
        scan.angle_max = scan.angle_min + (BEAMS - 1) * scan.angle_increment
        scan.header.stamp, scan.header.frame_id = stamp, 'base_scan'
        for beam in range(BEAMS):
            c, s = (f(scan.angle_min + beam * scan.angle_increment) for f in (math.cos, math.sin))
            to_x = ((SIDE if c > 0.0 else -SIDE) - self.driven) / c if abs(c) > 1e-9 else math.inf
            to_y = (SIDE if s > 0.0 else -SIDE) / s if abs(s) > 1e-9 else math.inf
            scan.ranges.append(min(to_x, to_y))
        self.scans.publish(scan)
        time.sleep(0.1)

    def forget_the_map(self):
        """Subscribes anew: what a mapper that was killed left in its connection no longer counts."""
        self.map.subscriber.unregister()
        self.map = Record('map', OccupancyGrid)

    def forget_the_file(self):
        """What one mapper was told in its command line stays on the parameter server, and would count for the next one."""
        if rospy.has_param('mapper/map_file'):
            rospy.delete_param('mapper/map_file')

    def known(self):
        return sum(cell >= 0 for cell in self.map.last.data) if self.map.last else 0

    def test_the_map_is_kept_every_two_seconds_and_taken_up_after_a_death_only(self):  # [FLT-2]
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        written, end = set(), time.monotonic() + 20.0
        while time.monotonic() < end and len(written) < 4:
            self.drive()
            written |= kept_maps()
        self.assertGreaterEqual(len(written), 4, 'again and again [FLT-2]')
        self.assertLess(time.monotonic(), end)
        before = self.known()
        self.assertGreater(before, 5000)
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        self.forget_the_map()
        mapper = Node('mapper', '_map_file:=/no/longer/there')  # its copy is worth more than the file
        # Without a scan: what the map shows is what was kept.
        self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0, 20.0))
        self.assertGreater(self.known(), 0.95 * before, '[FLT-2]')
        mapper.end()
        self.assertFalse(kept_maps(), 'an end in order leaves none')

    def test_a_map_is_taken_up_also_if_the_name_of_the_session_changes_before_the_mapper_dies(self):  # [FLT-2]
        name = rospy.get_param('/run_id')
        self.addCleanup(rospy.set_param, '/run_id', name)
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        for other in ('another', None):
            before = self.known()
            rospy.set_param('/run_id', other) if other else rospy.delete_param('/run_id')
            mapper.signal(signal.SIGKILL)
            mapper.finish()
            self.forget_the_map()
            mapper = Node('mapper')
            self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0, 20.0), other)
            self.assertGreater(self.known(), 0.95 * before, '[FLT-2]')
            self.assertTrue(wait_for(lambda: self.drive() or kept_maps(), 20.0))

    def leave_a_map(self):
        """Ends a mapper that has kept its map, by SIGKILL, and gives the number of the map's known cells."""
        mapper = Node('mapper')
        self.addCleanup(mapper.end)
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        known = self.known()
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        self.forget_the_map()
        return known

    def test_a_map_that_was_loaded_or_reset_before_the_first_odometry_stays(self):  # [FLT-2]
        floor = os.path.join(rospkg.RosPack().get_path('frontier_pilot'), 'config', 'worlds', 'small.yaml')
        for service, *request in (('mapper/reset', Trigger), ('mapper/load_map', LoadMap, floor)):
            self.leave_a_map()
            mapper = Node('mapper')
            self.addCleanup(mapper.end)
            self.assertTrue(call(service, *request).success)
            self.assertTrue(wait_for(lambda: self.odometry.get_num_connections() > 0))
            self.assertTrue(service == 'mapper/reset' or wait_for(lambda: self.known() > 0, 10.0))
            known = self.known()
            wait_for(lambda: self.say_where() and False, 3.0)
            self.assertEqual(self.known(), known, 'the map of before is not put back [FLT-2]')
            mapper.end()

    def test_a_map_file_does_not_replace_the_kept_map_before_the_first_odometry(self):  # [FLT-2]
        floor = os.path.join(os.environ['ROS_HOME'], 'small_floor')
        known = self.leave_a_map()
        first = Node('mapper')
        self.addCleanup(first.end)
        self.assertTrue(wait_for(lambda: self.say_where() and self.known() > 0.95 * known, 20.0))
        self.assertTrue(call('mapper/save_map', SaveMap, floor).success)
        first.signal(signal.SIGKILL)
        first.finish()
        kept = newest_map() + '.bt'
        before = os.stat(kept).st_mtime_ns
        second = Node('mapper', '_map_file:=' + floor)
        self.addCleanup(second.end)
        time.sleep(4.0)  # two periods of the autosave, without odometry
        self.assertEqual(os.stat(kept).st_mtime_ns, before, '[FLT-2]')

    def test_a_map_whose_pose_was_damaged_is_put_aside_and_can_be_loaded(self):  # [FLT-2]
        mapper = Node('mapper')
        self.addCleanup(lambda: mapper.end())
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps() and
                                                          os.path.exists(newest_map())), 20.0))
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        before = self.known()
        kept = newest_map()
        for damage in 'nowhere\n', '1e9 -1e9 0\n', None:  # and removed
            for pose in poses_of_the_session(kept):
                os.remove(pose)
                if damage:
                    with open(pose, 'w') as file:
                        file.write(damage)
            self.forget_the_map()
            mapper = Node('mapper')
            lost = os.path.join(os.path.dirname(kept), 'lost', 'kept_map.mapper')
            self.assertTrue(wait_for(lambda: os.path.exists(lost + '.bt') and not os.path.exists(kept + '.bt'), 10.0))
            self.assertTrue(call('mapper/load_map', LoadMap, lost).success, '[FLT-2]')
            self.assertTrue(wait_for(lambda: self.known() > 0.95 * before))
            self.assertTrue(wait_for(lambda: os.path.exists(kept + '.bt') and os.path.exists(kept), 10.0))
            mapper.signal(signal.SIGKILL)
            mapper.finish()


if __name__ == '__main__':
    use_a_home_of_its_own()
    rospy.init_node('mapper_autosave')
    rostest.rosrun('frontier_pilot', 'mapper_autosave', MapperAutosave)
