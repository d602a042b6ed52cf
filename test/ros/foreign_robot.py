"""A robot, a map server and a move_base that are not this package's: as little of them as an explorer needs."""
import math
import threading

import actionlib
import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from move_base_msgs.msg import MoveBaseAction
from nav_msgs.msg import OccupancyGrid, Odometry

PERIOD = 0.05  # [s]
SPEED = 1.0  # [m/s]
CELL = 0.05  # [m]
WIDTH, HEIGHT = 120, 40  # [cells]
ORIGIN = (-3.0, -1.0)  # [m]


def hall(known_from=-2.5, known_to=2.5):
    """A hall of 6 m x 2 m with walls on its long sides, known between two abscissas [m]."""
    grid = OccupancyGrid()
    grid.header.frame_id = 'map'
    grid.header.stamp = rospy.Time.now()
    grid.info.resolution, grid.info.width, grid.info.height = CELL, WIDTH, HEIGHT
    grid.info.origin.position.x, grid.info.origin.position.y = ORIGIN
    grid.info.origin.orientation.w = 1.0

    def value(column, row):
        if row in (0, HEIGHT - 1):
            return 100
        return 0 if known_from < ORIGIN[0] + (column + 0.5) * CELL < known_to else -1
    grid.data = [value(column, row) for row in range(HEIGHT) for column in range(WIDTH)]
    return grid


class ForeignRobot:
    """Drives straight to each goal of `move_base`, and stands there while `held`. With a `trouble` it gives each up."""

    def __init__(self, x, y):
        self.position = (x, y)
        self.goals = []
        self.track = []
        self.held = threading.Event()
        self.trouble = ''
        self.odometry_lives, self.odometry_ahead = True, 0.0  # whether it is told, and how far ahead of the clock [s]
        self._odom = rospy.Publisher('odom', Odometry, queue_size=10)
        self._tf = tf2_ros.TransformBroadcaster()
        self._map = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        self._timer = rospy.Timer(rospy.Duration(PERIOD), self._tell)
        self._server = actionlib.SimpleActionServer('move_base', MoveBaseAction, self._drive, auto_start=False)
        self._server.start()

    def show(self, grid):
        self._map.publish(grid)

    def drives(self):
        """Whether it has a goal."""
        return self._server.is_active()

    def _tell(self, _):
        now = rospy.Time.now()
        odom = Odometry()
        odom.header.stamp = now + rospy.Duration(self.odometry_ahead)
        odom.header.frame_id, odom.child_frame_id = 'odom', 'base_footprint'
        odom.pose.pose.orientation.w = 1.0
        if self.odometry_lives:
            self._odom.publish(odom)
        transform = TransformStamped()
        transform.header.stamp, transform.header.frame_id, transform.child_frame_id = now, 'map', 'base_footprint'
        transform.transform.translation.x, transform.transform.translation.y = self.position
        transform.transform.rotation.w = 1.0
        self._tf.sendTransform(transform)

    def _drive(self, goal):
        at = goal.target_pose.pose.position
        self.goals.append((at.x, at.y))
        while not rospy.is_shutdown():
            if self._server.is_preempt_requested():
                return self._server.set_preempted()
            if self.trouble:
                return self._server.set_aborted(text=self.trouble)
            if self._step_to(at.x, at.y) and not self.held.is_set():
                return self._server.set_succeeded()
            rospy.rostime.wallsleep(PERIOD)

    def _step_to(self, x, y):
        """Whether it is there."""
        dx, dy = x - self.position[0], y - self.position[1]
        share = min(1.0, SPEED * PERIOD / max(math.hypot(dx, dy), 1e-6))
        self.position = (self.position[0] + share * dx, self.position[1] + share * dy)
        self.track.append(self.position)
        return share == 1.0
