"""The track of the robot on the map, and the map itself, from their messages."""
import bisect
import math

import numpy

STEP, TURN = 0.03, 0.1  # a pose this much farther or turned is kept [m, rad]
MOST_JUMP = 1.0  # [m] between two poses: the track is not drawn across it


def yaw_of(rotation):
    return math.atan2(2.0 * (rotation.w * rotation.z + rotation.x * rotation.y),
                      1.0 - 2.0 * (rotation.y * rotation.y + rotation.z * rotation.z))


def bare(frame):
    return frame.lstrip('/')


class Track:
    """Follows the transforms between frames, and keeps the poses of the robot in the frame of the map: of the first of `base_frames`
    that is connected to it."""

    def __init__(self, map_frame='map', base_frames=('base_footprint',)):
        self.map_frame, self.base_frames = map_frame, list(base_frames)
        self.parents = {}  # child: (parent, x, y, yaw)
        self.poses = []  # (time [s], x, y, yaw)
        self.length = 0.0  # [m], without jumps

    def add(self, time, transforms):
        for transform in transforms:
            moved = transform.transform
            self.parents[bare(transform.child_frame_id)] = (
                bare(transform.header.frame_id), moved.translation.x, moved.translation.y, yaw_of(moved.rotation))
        pose = self.locate()
        if pose is not None and all(math.isfinite(value) for value in pose):
            self._keep(time, *pose)

    def locate(self):
        """The pose of the robot in the map; None while the frames are not connected."""
        return next((pose for pose in map(self._pose_of, self.base_frames) if pose is not None), None)

    def _pose_of(self, frame):
        x, y, yaw = 0.0, 0.0, 0.0
        for _ in range(16):  # frames that form a ring must not hold us up
            if frame == self.map_frame:
                return x, y, yaw
            if frame not in self.parents:
                return None
            frame, px, py, pyaw = self.parents[frame]
            x, y = px + math.cos(pyaw) * x - math.sin(pyaw) * y, py + math.sin(pyaw) * x + math.cos(pyaw) * y
            yaw += pyaw
        return None

    def _keep(self, time, x, y, yaw):
        if self.poses:
            _, last_x, last_y, last_yaw = self.poses[-1]
            step = math.hypot(x - last_x, y - last_y)
            if step < STEP and abs(math.remainder(yaw - last_yaw, 2.0 * math.pi)) < TURN:
                return
            self.length += step if step < MOST_JUMP else 0.0
        self.poses.append((time, x, y, yaw))

    def at(self, time):
        """Where the robot was at that time (x, y), by the pose before it; None before the first."""
        index = bisect.bisect(self.poses, (time, math.inf)) - 1
        return None if index < 0 else self.poses[index][1:3]

    def pieces(self):
        """Arrays of x and y, a new one after each jump."""
        points = numpy.array([pose[1:3] for pose in self.poses]).reshape(-1, 2)
        steps = numpy.hypot(*numpy.diff(points, axis=0).T) if len(points) > 1 else numpy.array([])
        return numpy.split(points, numpy.flatnonzero(steps >= MOST_JUMP) + 1)


class MapImage:
    """The last map, from whole maps and changes."""

    def __init__(self):
        self.cells = None  # rows from the lower edge of occupancy in per cent, -1 unknown
        self.resolution, self.origin, self.frame = 0.0, (0.0, 0.0), 'map'
        self.taken = None  # the stamp of the last whole map [s]

    def take(self, grid):
        place = grid.info.resolution, grid.info.origin.position.x, grid.info.origin.position.y
        if grid.info.width * grid.info.height != len(grid.data) or not grid.data or not all(map(math.isfinite, place)):
            return
        stamp = grid.header.stamp.to_sec()
        if stamp and stamp == self.taken:
            return  # rosbag writes a latched message once more at the beginning of each part, and changes have come since
        self.taken = stamp
        self.cells = numpy.array(grid.data, numpy.int8).reshape(grid.info.height, grid.info.width)
        self.resolution, self.frame = grid.info.resolution, bare(grid.header.frame_id)
        self.origin = grid.info.origin.position.x, grid.info.origin.position.y

    def change(self, update):
        if self.cells is None or update.width * update.height != len(update.data) or update.x < 0 or update.y < 0:
            return
        rows, columns = slice(update.y, update.y + update.height), slice(update.x, update.x + update.width)
        if self.cells[rows, columns].shape == (update.height, update.width):
            self.cells[rows, columns] = numpy.array(update.data, numpy.int8).reshape(update.height, update.width)

    def free_area(self):
        """[m^2] known to be free."""
        return 0.0 if self.cells is None else float(((self.cells >= 0) & (self.cells < 50)).sum()) * self.resolution ** 2
