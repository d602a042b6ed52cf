"""Free places for several robots near each other in a world."""
import collections
import math
import os
import random
import re
import struct

import yaml
from PIL import Image

CLEARANCE = 0.35  # around a start [m]
APART = 0.8  # between two starts [m]
MOST_ROBOTS = 20
SHARED = ('fleet', 'fleet_stop', 'map_merger', 'robots_launcher', 'rviz', 'simulator', 'teleop_gui')  # namespaces that no robot can have
LARGEST_YAML = 1000000  # [bytes]
MOST_PIXELS = 64000000  # of a world's picture, as the simulator


class StartsError(Exception):
    """There are no robots, or no places for them."""


def require_file(path, largest=math.inf):
    """StartsError if this is no file, a pipe for instance, which would be waited for, or a file of more bytes than that."""
    if not os.path.isfile(path):
        raise StartsError('%s cannot be read: it is %s' % (path, 'no regular file' if os.path.exists(path) else 'not there'))
    if os.path.getsize(path) > largest:
        raise StartsError('%s cannot be read: it has more than %d bytes' % (path, largest))


def read_yaml(path):
    """What a YAML file says; StartsError if it cannot be read, or is too large or nested too deeply."""
    require_file(path, LARGEST_YAML)
    try:
        with open(path) as file:
            return yaml.safe_load(file)
    except RecursionError:
        raise StartsError('%s cannot be read: it is nested too deeply' % path) from None
    except (OSError, ValueError, yaml.YAMLError) as error:
        raise StartsError('%s cannot be read: %s' % (path, ' '.join(str(error).split()))) from None


def read_picture(path):
    """Width, height and shades (0 ... 1) of a picture, from the upper left."""
    require_file(path)
    with Image.open(path) as picture:
        if picture.width * picture.height > MOST_PIXELS:
            raise StartsError('%s has more than %d pixels' % (path, MOST_PIXELS))
        grey = picture.convert('L')
    return grey.width, grey.height, [shade / 255 for shade in grey.getdata()]


def point_of(values):
    """x and y of a list of finite numbers [m]; ValueError if it is none."""
    point = [float(value) for value in values[:2]]
    if len(point) < 2 or not all(map(math.isfinite, point)):
        raise ValueError('%r is no place' % (point,))
    return point


def text_of(value):
    """A text of a YAML file; ValueError if it is anything else, such as a list, which as a text might be without end."""
    if not isinstance(value, str):
        raise ValueError('%s instead of a text' % type(value).__name__)
    return value


def robot_name(value):
    """The name of a robot, which becomes a namespace; ValueError if it cannot be one."""
    if not re.fullmatch('[A-Za-z][A-Za-z0-9_]{0,255}', text_of(value)):
        raise ValueError('a name is a word of letters, digits and _ that begins with a letter')
    if value in SHARED:
        raise ValueError("'%s' cannot be a robot's name: it is the namespace of what all robots share" % value)
    return value


class World:
    """A map_server YAML and its picture."""

    def __init__(self, path):
        meta = read_yaml(path)
        self.width, self.height, shades = read_picture(os.path.join(os.path.dirname(path), meta['image']))
        self.resolution = float(meta['resolution'])
        if not self.resolution > 0.0:
            raise ValueError('the resolution is not greater than zero')
        self.origin = point_of(meta['origin'])
        self.start = point_of(meta['start']) if meta.get('start') else None
        darkest = 1.0 - float(meta['free_thresh'])
        negate = bool(meta.get('negate'))
        self.is_free = [(1.0 - shade if negate else shade) > darkest for shade in shades]
        reach = math.ceil(CLEARANCE / self.resolution)
        self.disc = [(x, y) for x in range(-reach, reach + 1) for y in range(-reach, reach + 1)
                     if math.hypot(x, y) <= reach]

    def free(self, x, y):
        inside = 0 <= x < self.width and 0 <= y < self.height
        return inside and self.is_free[(self.height - 1 - y) * self.width + x]

    def has_room(self, cell):
        return all(self.free(cell[0] + x, cell[1] + y) for x, y in self.disc)

    def cell(self, point):
        return tuple(int((point[i] - self.origin[i]) / self.resolution) for i in (0, 1))

    def centre(self, cell):
        return tuple(round(self.origin[i] + (cell[i] + 0.5) * self.resolution, 3) for i in (0, 1))


def first_cell(world, generator):
    """Where the world says that a robot starts, or a free place that is drawn."""
    if world.start and world.has_room(world.cell(world.start)):
        return world.cell(world.start)
    for _ in range(10000):
        cell = generator.randrange(world.width), generator.randrange(world.height)
        if world.has_room(cell):
            return cell
    raise StartsError('no free place was found in the world')


def near_cells(world, start):
    """The cells with room around them that a robot gets to from `start`, the nearest first."""
    queue, seen = collections.deque([start]), {start}
    while queue:
        x, y = queue.popleft()
        yield x, y
        for cell in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            if cell not in seen and world.has_room(cell):
                seen.add(cell)
                queue.append(cell)


def read_world(path):
    """The World of a map_server YAML; StartsError if it or its picture cannot be read."""
    try:
        return World(path)
    except (OSError, EOFError, ValueError, LookupError, TypeError, ArithmeticError, SyntaxError, struct.error,
            Image.DecompressionBombError) as error:
        raise StartsError('world:=%s cannot be read: %s' % (path, error))


def draw_starts(world, count, seed):
    """`count` robots (robot1, robot2, ...) with starts in a World: near each other, apart from walls, and with a way from one to
    the next. The same seed gives the same."""
    if not 1 <= count <= MOST_ROBOTS:
        raise StartsError('robots:=%d: from 1 to %d can be drawn' % (count, MOST_ROBOTS))
    generator = random.Random(seed)
    starts = []
    for cell in near_cells(world, first_cell(world, generator)):
        point = world.centre(cell)
        if all(math.dist(point, (start['x'], start['y'])) >= APART for start in starts):
            starts.append({'name': 'robot%d' % (len(starts) + 1), 'x': point[0], 'y': point[1],
                           'yaw': round(generator.uniform(-math.pi, math.pi), 3)})
        if len(starts) == count:
            return starts
    raise StartsError('robots:=%d: the world has room for %d that can reach each other' % (count, len(starts)))
