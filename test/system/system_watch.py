"""What the tests of the whole system see of it."""
import math
import threading
import time
import xmlrpc.client

import numpy as np
import rosgraph
import rospy
from frontier_pilot.msg import ExplorerStatus
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid, Odometry
from std_msgs.msg import Bool


class SystemWatch:
    def __init__(self):
        self.contacts = 0
        self.map = None  # with all updates so far: whole maps are published much more rarely
        self.updates = []  # that are newer than the last whole map
        self.map_lock = threading.Lock()
        self.speed = None  # [m/s] and [rad/s] together: zero when it stands
        self.distance = 0.0
        self.position = None
        self.status = None
        self.reasons = []  # every reason of the explorer, in order
        self.time = 0.0  # the stamp of the latest ground truth [s]
        rospy.Subscriber('simulator/stalled', Bool, self.on_stalled)
        rospy.Subscriber('map', OccupancyGrid, self.on_map, buff_size=1 << 22)
        rospy.Subscriber('map_updates', OccupancyGridUpdate, self.on_update, buff_size=1 << 22)
        rospy.Subscriber('base_pose_ground_truth', Odometry, self.on_pose, buff_size=1 << 20)
        rospy.Subscriber('frontier_explorer/status', ExplorerStatus, self.on_status)

    def on_stalled(self, msg):
        self.contacts += msg.data

    def on_map(self, msg):
        msg.data = np.array(msg.data, np.int8)
        with self.map_lock:
            went_back = self.map is not None and msg.header.stamp < self.map.header.stamp  # the clock was set back
            self.updates = [update for update in self.updates if update.header.stamp >= msg.header.stamp and not went_back]
            for update in self.updates:
                apply(update, msg)
            self.map = msg

    def on_update(self, msg):
        with self.map_lock:
            self.updates.append(msg)
            if self.map is not None and msg.header.stamp >= self.map.header.stamp:
                apply(msg, self.map)

    def on_pose(self, msg):
        twist, position = msg.twist.twist, msg.pose.pose.position
        self.speed = abs(twist.linear.x) + abs(twist.angular.z)
        if self.position is not None:
            self.distance += math.hypot(position.x - self.position.x, position.y - self.position.y)
        self.position = position
        self.time = msg.header.stamp.to_sec()

    def on_status(self, msg):
        self.status = msg
        if not self.reasons or self.reasons[-1] != msg.reason:
            self.reasons.append(msg.reason)

    def done(self):
        return self.status is not None and self.status.state == ExplorerStatus.DONE

    def describe(self):
        return 'status:\n%s\nreasons so far: %s\ndriven %.1f m, contacts %d' % (
            self.status, self.reasons, self.distance, self.contacts)


def apply(update, grid):
    """Copies the cells of an update into a map, unless it reaches beyond it and so belongs to a larger one."""
    cells = grid.data.reshape(grid.info.height, grid.info.width)
    block = cells[update.y:update.y + update.height, update.x:update.x + update.width]
    if update.x >= 0 and update.y >= 0 and block.shape == (update.height, update.width):
        block[:] = np.asarray(update.data, np.int8).reshape(block.shape)


def wait_until(condition, seconds):
    """Whether `condition()` came true within `seconds` of wall time."""
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline or rospy.is_shutdown():
            return False
        time.sleep(0.02)
    return True


def pid_of(node):
    """The process of a running node, None if there is none."""
    try:
        uri = rosgraph.Master('/test').lookupNode(node)
        return xmlrpc.client.ServerProxy(uri).getPid('/test')[2]
    except (rosgraph.MasterException, OSError):
        return None


def subscribers(topic):
    """The nodes that are connected to this process's publisher of `topic` by now: the master tells them one by one."""
    connections = xmlrpc.client.ServerProxy(rospy.get_node_uri()).getBusInfo('/test')[2]
    return {connection[1] for connection in connections if connection[2] == 'o' and connection[4] == topic}
