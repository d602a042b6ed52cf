"""What an attack sees of the simulated robot and of the exploration."""
import collections
import math
import time

import rospy
from frontier_pilot.msg import ExplorerStatus
from nav_msgs.msg import OccupancyGrid, Odometry
from std_msgs.msg import Bool

from run_attack.system import join, wait_until

BRAKING = (2.5, 3.2)  # [m/s^2] and [rad/s^2] of the simulated base
RESTING = 1e-3  # [m/s] and [rad/s] together


class RobotWatch:
    """The true motion, the contacts, the map and the status of the explorer of one robot; `robot` is its namespace."""

    def __init__(self, robot=''):
        self._space = '/' + robot + '/' if robot else '/'
        self._name = robot or 'the robot'
        self.contacts = 0
        self.last_contact = ''  # who, where in the world and when, in words
        self.distance = 0.0  # [m] driven
        self.known = 0  # cells of the map
        self.maps = 0
        self.explorer = None
        self.motion = collections.deque(maxlen=5000)  # (steady time, ROS time, |v| + |w|, time to brake)
        self._position = None
        rospy.Subscriber(self._space + 'simulator/stalled', Bool, self._take_contact)
        rospy.Subscriber(self._space + 'base_pose_ground_truth', Odometry, self._take_pose, tcp_nodelay=True)
        rospy.Subscriber(self._space + 'map', OccupancyGrid, self._take_map, buff_size=1 << 22)
        rospy.Subscriber(self._space + 'frontier_explorer/status', ExplorerStatus, self._take_status)

    def _take_contact(self, message):
        if not message.data:
            return
        self.contacts += 1
        if self._position is not None:
            self.last_contact = '%s at (%.2f, %.2f), %.1f s' % (self._name, self._position.x, self._position.y, self.motion[-1][1])

    def _take_status(self, message):
        if message._connection_header['callerid'] == self._space + 'frontier_explorer':
            self.explorer = message

    def _take_map(self, message):
        if message._connection_header['callerid'] == self._space + 'mapper':
            self.known = sum(cell >= 0 for cell in message.data)
            self.maps += 1

    def _take_pose(self, message):
        twist, position = message.twist.twist, message.pose.pose.position
        if self._position is not None:
            step = math.hypot(position.x - self._position.x, position.y - self._position.y)
            self.distance += step if step < 0.2 else 0.0  # not when it was put elsewhere
        speeds = (abs(twist.linear.x), abs(twist.angular.z))
        self.motion.append((time.monotonic(), message.header.stamp.to_sec(), sum(speeds),
                            max(speed / braking for speed, braking in zip(speeds, BRAKING))))
        self._position = position

    @property
    def speed(self):
        """|v| + |w| of the base; None before the first pose."""
        return self.motion[-1][2] if self.motion else None

    def done(self):
        return self.explorer is not None and self.explorer.state == ExplorerStatus.DONE

    def has_nothing_to_do(self):
        """Everything is explored, or other robots claim what is left."""
        return self.done() or (self.explorer is not None and self.explorer.reason == ExplorerStatus.LEFT_TO_OTHERS)

    def stood_after(self, since):
        """How long after the steady time `since` the base came to rest first [s]; None where it has not.

        It is the time of the simulation, which is what commands and the watchdog of the base go by: on a busy machine the
        simulation falls behind real time.
        """
        motion = list(self.motion)
        begin = self._stamp_at(since)
        return next((stamp - begin for at, stamp, speed, _ in motion
                     if at >= since and speed < RESTING and begin is not None), None)

    def braking_time(self, since, seconds):
        """How long the base brakes from its greatest speed within `seconds` of the simulation from `since` on [s]."""
        begin = self._stamp_at(since)
        return max([braking for at, stamp, _, braking in list(self.motion)
                    if at >= since and begin is not None and stamp <= begin + seconds], default=0.0)

    def _stamp_at(self, at):
        """The time of the simulation at a steady time; None before the first pose."""
        return max([stamp for received, stamp, _, _ in list(self.motion) if received < at], default=None)

    def moved_since(self, since):
        """Whether the base has moved at any time from the steady time `since` on."""
        return any(at >= since and speed >= RESTING for at, _, speed, _ in list(self.motion))


def watch_from_the_start(system, node, outcome):
    """Starts the system, joins it as a node, and gives the watch of its robot, which has a map; None if the system does not start."""
    if not outcome.expect(system.begin(), 'the system does not start'):
        return None
    join(node)
    watch = RobotWatch()
    outcome.expect(wait_until(lambda: watch.speed is not None and watch.maps > 0, 30.0), 'there is no map')
    return watch
