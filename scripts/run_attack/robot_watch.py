"""What an attack sees of the simulated robot and of the exploration."""
import collections
import math
import threading
import time

import rospy
from frontier_pilot.msg import ExplorerStatus
from nav_msgs.msg import OccupancyGrid, Odometry
from std_msgs.msg import Bool

LINKS = 3  # processes one after the other, each of which may be held up: arbiter, simulator, and this one
RESTING = 1e-3  # [m/s] and [rad/s] together


class Lag:
    """By how much processes are held up on a busy machine, as a thread finds that sleeps for 10 ms again and again."""

    def __init__(self):
        self.delays = collections.deque(maxlen=5000)  # (steady time, delay [s])
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self):
        while True:
            begin = time.monotonic()
            time.sleep(0.01)
            now = time.monotonic()
            self.delays.append((now, now - begin - 0.01))

    def worst(self, begin, end):
        """How late something may come at most between two times that depends on several processes [s]."""
        return LINKS * max([delay for at, delay in list(self.delays) if begin <= at <= end], default=0.0)


class RobotWatch:
    """The true motion, the contacts, the map and the status of the explorer."""

    def __init__(self):
        self.contacts = 0
        self.distance = 0.0  # [m] driven
        self.known = 0  # cells of the map
        self.maps = 0
        self.explorer = None
        self.motion = collections.deque(maxlen=5000)  # (steady time, |v| + |w|)
        self._position = None
        rospy.Subscriber('simulator/stalled', Bool, self._take_contact)
        rospy.Subscriber('base_pose_ground_truth', Odometry, self._take_pose, tcp_nodelay=True)
        rospy.Subscriber('map', OccupancyGrid, self._take_map, buff_size=1 << 22)
        rospy.Subscriber('frontier_explorer/status', ExplorerStatus, lambda message: setattr(self, 'explorer', message))

    def _take_contact(self, message):
        self.contacts += message.data

    def _take_map(self, message):
        if message._connection_header['callerid'] == '/mapper':
            self.known = sum(cell >= 0 for cell in message.data)
            self.maps += 1

    def _take_pose(self, message):
        twist, position = message.twist.twist, message.pose.pose.position
        if self._position is not None:
            step = math.hypot(position.x - self._position.x, position.y - self._position.y)
            self.distance += step if step < 0.2 else 0.0  # not when it was put elsewhere
        self._position = position
        self.motion.append((time.monotonic(), abs(twist.linear.x) + abs(twist.angular.z)))

    @property
    def speed(self):
        """|v| + |w| of the base; None before the first pose."""
        return self.motion[-1][1] if self.motion else None

    def done(self):
        return self.explorer is not None and self.explorer.state == ExplorerStatus.DONE

    def stood_after(self, since):
        """How long after the time `since` the base came to rest first [s]; None where it has not."""
        return next((at - since for at, speed in list(self.motion) if at >= since and speed < RESTING), None)

    def moved_since(self, since):
        """Whether the base has moved at any time from `since` on."""
        return any(at >= since and speed >= RESTING for at, speed in list(self.motion))
