#!/usr/bin/env python3
"""A robot with other names than ours, and with one mistake. Run as a program it is a second node, for mistakes of two nodes."""
import math
import subprocess
import sys
import threading

import rospy
from frontier_pilot.msg import ArbiterStatus
from geometry_msgs.msg import TransformStamped, Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

BEAMS = 90
ODOMETRY_RATE = 20.0  # [Hz]


def turned(roll, yaw):
    """The quaternion x, y, z, w of a rotation about x and then about the fixed z."""
    cr, sr, cy, sy = math.cos(roll / 2), math.sin(roll / 2), math.cos(yaw / 2), math.sin(yaw / 2)
    return cy * sr, sy * sr, sy * cr, cy * cr


def transform(parent, child, x=0.0, roll=0.0, yaw=0.0):
    message = TransformStamped()
    message.header.stamp, message.header.frame_id, message.child_frame_id = rospy.Time.now(), parent, child
    message.transform.translation.x = x
    q = message.transform.rotation
    q.x, q.y, q.z, q.w = turned(roll, yaw)
    return message


def scan_of(frame, rate=10.0, lag=0.0):
    scan = LaserScan()
    scan.header.frame_id, scan.header.stamp = frame, rospy.Time.now() - rospy.Duration(lag)
    scan.angle_min, scan.angle_increment = -math.pi, 2.0 * math.pi / BEAMS
    scan.angle_max = scan.angle_min + (BEAMS - 1) * scan.angle_increment
    scan.range_min, scan.range_max, scan.scan_time = 0.1, 8.0, 1.0 / rate
    scan.ranges = [2.0] * BEAMS
    return scan


class NamedRobot:
    """All its topics begin with /NAME; each argument but `told_base` and `second` is a mistake."""

    def __init__(self, name, scan='base_scan', scan_rate=10.0, scan_frame='laser', scan_lag=0.0, roll=math.pi,
                 spoil_mount=None, spoil_scan=None, spoil_transforms=None, odom='wheels/odom', odom_lag=0.0, odom_frame_id='odom',
                 spoil_odometry=None, base_in='odom', also_in=None, map_in=None, told_base='base_link', listens='drive', drives=False,
                 arbiter=False, second=None):
        self.name, self.told_base = name, told_base
        self._ending = threading.Event()
        self._connections = [rospy.Publisher('/%s/tf' % name, TFMessage, queue_size=10),
                             rospy.Publisher('/%s/tf_static' % name, TFMessage, queue_size=1, latch=True)]
        tf, fixed = self._connections
        mount = transform('base_link', 'laser', 0.05, roll, 3.0)
        if spoil_mount:
            spoil_mount(mount)
        fixed.publish(TFMessage([mount]))
        self._begin = rospy.Time.now()
        if listens:
            self._connections.append(rospy.Subscriber('/%s/%s' % (name, listens), Twist, lambda _: None))
        if drives:
            self._connections.append(rospy.Publisher('/%s/drive' % name, Twist, queue_size=1))
        if arbiter:
            self._connections.append(rospy.Publisher('/%s/arbiter/status' % name, ArbiterStatus, queue_size=1))
        if scan:
            scans = rospy.Publisher('/%s/%s' % (name, scan), LaserScan, queue_size=10, tcp_nodelay=True)
            self._connections.append(scans)

            def publish_scan():
                message = scan_of(scan_frame, scan_rate, scan_lag)
                if spoil_scan:
                    spoil_scan(message)
                scans.publish(message)
            if scan_rate:
                self._every(1.0 / scan_rate, publish_scan)
        if odom:
            odometry = rospy.Publisher('/%s/%s' % (name, odom), Odometry, queue_size=10, tcp_nodelay=True)
            self._connections.append(odometry)

            def publish_odometry():
                message = Odometry()
                message.header.frame_id, message.child_frame_id = odom_frame_id, 'base_link'
                message.header.stamp = self._begin if odom_lag is None else rospy.Time.now() - rospy.Duration(odom_lag)
                message.pose.pose.orientation.w = 1.0
                if spoil_odometry:
                    spoil_odometry(message)
                odometry.publish(message)
            self._every(1.0 / ODOMETRY_RATE, publish_odometry)
        parents = [(base_in, 'base_link'), (also_in, 'base_link'), (map_in, 'odom')]

        def publish_transforms():
            message = TFMessage([transform(parent, child) for parent, child in parents if parent])
            if spoil_transforms:
                spoil_transforms(message)
            tf.publish(message)
        self._every(1.0 / ODOMETRY_RATE, publish_transforms)

    def names(self):
        """The arguments by which a program learns them."""
        pairs = {'scan': 'base_scan', 'odom': 'wheels/odom', 'cmd_vel': 'drive', 'map': 'map', '/tf': 'tf',
                 '/tf_static': 'tf_static', 'cmd_vel_arbiter/status': 'arbiter/status'}
        return (['%s:=/%s/%s' % (ours, self.name, theirs) for ours, theirs in pairs.items()] +
                ['__name:=check_%s' % self.name, '_robot/base_frame:=' + self.told_base])

    def _every(self, period, publish):
        def run():
            while not self._ending.wait(period) and not rospy.is_shutdown():
                publish()
        threading.Thread(target=run, daemon=True).start()

    def end(self):
        self._ending.set()
        for connection in self._connections:
            connection.unregister()


class SecondNode:
    """A process that publishes what only a second node can, for the robots of these names."""

    def __init__(self, names):
        self.process = subprocess.Popen([sys.executable, __file__, *names])

    def end(self):
        self.process.terminate()
        self.process.wait()


def main(names):
    rospy.init_node('second_node')
    scans = [rospy.Publisher('/%s/base_scan' % name, LaserScan, queue_size=10) for name in names if name == 'two_scanners']
    frames = [rospy.Publisher('/%s/tf' % name, TFMessage, queue_size=10) for name in names if name == 'two_broadcasters']
    arbiters = [rospy.Publisher('/%s/arbiter/status' % name, ArbiterStatus, queue_size=1) for name in names
                if name == 'two_arbiters']
    while not rospy.is_shutdown():
        for publisher in scans:
            publisher.publish(scan_of('rear_laser'))
        for publisher in frames:
            publisher.publish(TFMessage([transform('odom', 'base_link')]))
        rospy.sleep(0.1)
    return arbiters


if __name__ == '__main__':
    main(sys.argv[1:])
