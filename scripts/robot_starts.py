"""Free places for several robots near each other in a world."""
import collections
import math
import os
import random
import re
import struct

import numpy
import yaml
from PIL import Image

CLEARANCE = 0.35  # around a start [m]
APART = 0.8  # between two starts [m]
MOST_ROBOTS = 20
SHARED = ('fleet', 'fleet_stop', 'map_merger', 'robots_launcher', 'rviz', 'simulator', 'teleop_gui')  # namespaces that no robot can have
LARGEST_YAML = 1000000  # [bytes]
MOST_PIXELS = 64000000  # of a world's picture, as the simulator
PIXEL_SIZES = 0.001, 1.0  # that a world may have, as for the simulator [m]
MOST_ORIGIN, MOST_COORDINATE = 1e5, 1e6  # of a world, and of a start in it, as for the simulator [m]
LEAST_CELL = 0.02  # side of the cells in which places are looked for [m]: finer pixels are put together


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
    """The shades (0 ... 255) of a picture, row by row from the top."""
    require_file(path)
    with Image.open(path) as picture:
        if picture.width * picture.height > MOST_PIXELS:
            raise StartsError('%s has more than %d pixels' % (path, MOST_PIXELS))
        return numpy.asarray(picture.convert('L'))


def pixel_size(value):
    """The side of a pixel [m]; ValueError if it is none that the simulator takes."""
    size = float(value)
    if not PIXEL_SIZES[0] <= size <= PIXEL_SIZES[1]:
        raise ValueError('the resolution must be from %g to %g m, not %g' % (*PIXEL_SIZES, size))
    return size


def point_of(values, most):
    """x and y of a list of numbers, neither of them beyond `most` [m]; ValueError if it is none."""
    point = [float(value) for value in values[:2]]
    if len(point) < 2 or not all(abs(number) <= most for number in point):
        raise ValueError('%r is no place within %g m' % (point, most))
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


def free_pixels(meta, shades):
    """Which pixels a map_server YAML calls free, row by row from the bottom."""
    darkest = 1.0 - float(meta['free_thresh'])
    negate = bool(meta.get('negate'))
    free = [(1.0 - shade / 255 if negate else shade / 255) > darkest for shade in range(256)]
    return numpy.array(free)[shades[::-1]]


def put_together(free, factor):
    """The grid of the cells of factor x factor pixels. A cell is free if all of its pixels are there, and free."""
    rows, columns = (-(-side // factor) for side in free.shape)
    whole = numpy.zeros((rows * factor, columns * factor), bool)
    whole[:free.shape[0], :free.shape[1]] = free
    return whole.reshape(rows, factor, columns, factor).all(axis=(1, 3))


def places_with_room(free, reach):
    """Which cells of a grid lie in the middle of a disc of free cells, of this radius in cells. Outside of it nothing is free."""
    rows, columns = free.shape
    room = free.copy()
    beside = numpy.pad(free, reach)  # whether a cell, and as many as `half` on either side of it, are free
    for half in range(reach + 1):
        if half > 0:
            beside[:, 1:-1] = beside[:, 1:-1] & beside[:, :-2] & beside[:, 2:]
        for row in range(-reach, reach + 1):
            if math.isqrt(reach * reach - row * row) == half:  # half the width of the disc in this row
                room &= beside[reach + row:reach + row + rows, reach:reach + columns]
    return room


class World:
    """A map_server YAML and its picture, and the cells in which a robot has room to start."""

    def __init__(self, path):
        meta = read_yaml(path)
        self.resolution = pixel_size(meta['resolution'])
        self.origin = point_of(meta['origin'], MOST_ORIGIN)
        self.start = point_of(meta['start'], MOST_COORDINATE) if meta.get('start') else None
        shades = read_picture(os.path.join(os.path.dirname(path), meta['image']))
        self.height, self.width = shades.shape
        factor = math.ceil(LEAST_CELL / self.resolution)
        self.cell_size = factor * self.resolution
        self.room = places_with_room(put_together(free_pixels(meta, shades), factor), math.ceil(CLEARANCE / self.cell_size))

    def has_room(self, cell):
        return all(0 <= cell[i] < self.room.shape[1 - i] for i in (0, 1)) and bool(self.room[cell[1], cell[0]])

    def cell(self, point):
        return tuple(int((point[i] - self.origin[i]) / self.cell_size) for i in (0, 1))

    def centre(self, cell):
        return tuple(round(self.origin[i] + (cell[i] + 0.5) * self.cell_size, 3) for i in (0, 1))


def first_cell(world, generator):
    """Where the world says that a robot starts, or a free place that is drawn."""
    if world.start and world.has_room(world.cell(world.start)):
        return world.cell(world.start)
    for _ in range(10000):
        cell = generator.randrange(world.room.shape[1]), generator.randrange(world.room.shape[0])
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
    the next. The first one looks along the world's x axis, so that the map stands as the world does; the others look anywhere. The
    same seed gives the same."""
    if not 1 <= count <= MOST_ROBOTS:
        raise StartsError('robots:=%d: from 1 to %d can be drawn' % (count, MOST_ROBOTS))
    generator = random.Random(seed)
    starts = []
    for cell in near_cells(world, first_cell(world, generator)):
        point = world.centre(cell)
        if all(math.dist(point, (start['x'], start['y'])) >= APART for start in starts):
            # Drawn for the first one, too, so that the others look where they always did for this seed.
            drawn = round(generator.uniform(-math.pi, math.pi), 3)
            yaw = drawn if starts else 0.0
            starts.append({'name': 'robot%d' % (len(starts) + 1), 'x': point[0], 'y': point[1], 'yaw': yaw})
        if len(starts) == count:
            return starts
    raise StartsError('robots:=%d: the world has room for %d that can reach each other' % (count, len(starts)))
