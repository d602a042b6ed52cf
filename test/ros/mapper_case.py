"""What the wire tests of the map that a mapper leaves behind share: a room, a robot that drives in it, and the kept files."""
import glob
import math
import os
import signal
import time
import unittest

import rospkg
import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid, Odometry
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Trigger

from wire import Node, Record, call, wait_for

SIDE = 3.0  # half of that of the room [m]
BEAMS = 180
SMALL = os.path.join(rospkg.RosPack().get_path('frontier_pilot'), 'config', 'worlds', 'small.yaml')


def written_maps():
    """The copies of maps, their .bt, that a mapper has written within five seconds."""
    home = os.environ.get('ROS_HOME', os.path.expanduser('~/.ros'))
    files = glob.glob(home + '/frontier_pilot/*/kept_map.mapper.bt')
    return [file for file in files if time.time() - os.path.getmtime(file) < 5.0]


def kept_maps():
    """When each of these was written [ns], if its pose is there: with a copy that has none no mapper goes on."""
    return {os.stat(file).st_mtime_ns for file in written_maps() if os.path.exists(file[:-len('.bt')])}


def newest_map():
    """The kept map that was written last, without the ending of its files."""
    home = os.environ.get('ROS_HOME', os.path.expanduser('~/.ros'))
    return max(glob.glob(home + '/frontier_pilot/*/kept_map.mapper.bt'), key=os.path.getmtime)[:-len('.bt')]


def poses_of_the_session(kept):
    """The files with the pose of a kept map, which a mapper renews each second: one for each name of the session."""
    poses = glob.glob(os.path.join(os.path.dirname(kept), '..', '*', 'kept_map.mapper'))
    return [pose for pose in poses if time.time() - os.path.getmtime(pose) < 30.0]


class MapperCase(unittest.TestCase):
    def setUp(self):
        self.map = Record('map', OccupancyGrid)
        self.addCleanup(lambda: self.map.subscriber.unregister())
        self.addCleanup(self.forget_the_parameters)
        self.odometry = rospy.Publisher('odom', Odometry, queue_size=10)
        self.scans = rospy.Publisher('scan', LaserScan, queue_size=10)
        self.frames = tf2_ros.StaticTransformBroadcaster()
        mount = TransformStamped()
        mount.header.frame_id, mount.child_frame_id, mount.transform.rotation.w = 'base_footprint', 'base_scan', 1.0
        self.frames.sendTransform(mount)
        self.driven, self.jump = 0.0, 0.0  # along x: from where the robot began, and of its odometry [m]

    def say_where(self):
        """Gives the stamp of the odometry that it sends."""
        odometry = Odometry()
        odometry.header.stamp, odometry.header.frame_id = rospy.Time.now(), 'odom'
        odometry.pose.pose.position.x, odometry.pose.pose.orientation.w = self.driven + self.jump, 1.0
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

    def forget_the_parameters(self):
        """What one mapper was told in its command line stays on the parameter server, and would count for the next one."""
        for name in 'mapper/map_file', 'mapper/autosave_period', 'mapper/mapper/trust_odometry':
            if rospy.has_param(name):
                rospy.delete_param(name)

    def known(self):
        return sum(cell >= 0 for cell in self.map.last.data) if self.map.last else 0

    def leave_a_map(self, *arguments):
        """Ends a mapper that has kept its map of the room, by SIGKILL, and gives the number of the map's known cells."""
        mapper = Node('mapper', *arguments)
        self.addCleanup(mapper.end)
        self.assertTrue(call('mapper/reset', Trigger).success)  # what it began with
        self.assertTrue(wait_for(lambda: self.drive() or (self.known() > 5000 and kept_maps()), 20.0))
        known = self.known()
        mapper.signal(signal.SIGKILL)
        mapper.finish()
        self.forget_the_map()
        return known
