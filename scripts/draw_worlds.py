#!/usr/bin/python3
"""Draws the project's own worlds into config/worlds: a PGM and a map_server YAML each.

Deterministic: running it again changes nothing. The YAML's extra key `start: [x, y, yaw]` (m, m, rad; frame of the map)
is where a robot starts unless another pose is given; map_server ignores it.

"""
import os
import random

import numpy as np

from command_line import CommandLine, exit_with

RESOLUTION = 0.05  # [m] side of a cell
WALL = 0.15        # [m] thickness of a wall between rooms


class Plan:
    """A floor plan in metres, x to the right and y up, solid where nothing has been carved."""

    def __init__(self, width, height, solid=False):
        self.solid = np.full((self.cells(height), self.cells(width)), solid)

    @staticmethod
    def cells(metres):
        return int(round(metres / RESOLUTION))

    def box(self, x0, y0, x1, y1, solid=True):
        c = self.cells
        self.solid[max(0, c(y0)):c(y1), max(0, c(x0)):c(x1)] = solid
        return self

    def room(self, x0, y0, x1, y1):
        """A free room whose walls lie outside of it."""
        return self.box(x0, y0, x1, y1, solid=False)

    def door(self, x, y, width=0.9, vertical_wall=False, depth=0.4):
        """A gap centred on (x, y) through a wall along x, or along y."""
        half, through = width / 2, depth / 2
        if vertical_wall:
            return self.box(x - through, y - half, x + through, y + half, solid=False)
        return self.box(x - half, y - through, x + half, y + through, solid=False)

    def disc(self, x, y, radius, solid=True):
        rows, cols = np.indices(self.solid.shape)
        inside = np.hypot((cols + 0.5) * RESOLUTION - x, (rows + 0.5) * RESOLUTION - y) <= radius
        self.solid[inside] = solid
        return self

    def desk(self, x, y, width=1.4, depth=0.7):
        """A desk seen at the scanner's height: legs in its corners, a pedestal at its left end, a chair's column."""
        leg = 0.05
        for lx in (x, x + width - leg):
            for ly in (y, y + depth - leg):
                self.box(lx, ly, lx + leg, ly + leg)
        self.box(x, y, x + 0.4, y + depth)
        return self.disc(x + 0.65 * width, y - 0.35, 0.12)


def flat():
    """An apartment of about 80 square metres around a hall."""
    p = Plan(10.4, 8.4, solid=True)
    w = 0.2
    p.room(w, w, 6.1, 4.4)                  # living room
    p.room(w, 5.95, 3.6, 8.2)               # kitchen
    p.room(w, 4.55, 10.2, 5.8)              # hall
    p.room(3.75, 5.95, 5.75, 8.2)           # bath
    p.room(5.9, 5.95, 10.2, 8.2)            # study
    p.room(6.25, w, 10.2, 4.4)              # bedroom
    p.door(3.0, 4.475, 1.2)
    p.door(1.6, 5.875).door(4.7, 5.875, 0.8).door(7.2, 5.875)
    p.door(7.3, 4.475)
    p.box(0.2, 0.2, 0.65, 2.3).box(1.6, 1.0, 2.7, 1.6)              # sofa, coffee table
    p.box(3.4, 0.2, 5.4, 0.6)                                       # sideboard
    for x, y in ((4.2, 2.3), (5.3, 2.3), (4.2, 3.2), (5.3, 3.2)):   # dining table on legs
        p.box(x, y, x + 0.1, y + 0.1)
    p.disc(0.5, 4.1, 0.2)                                           # plant
    p.box(0.2, 7.6, 3.6, 8.2).box(0.2, 6.4, 0.8, 7.6)               # kitchen units
    p.box(3.75, 7.5, 4.5, 8.2).box(5.15, 6.5, 5.75, 8.2)            # bath
    p.box(8.2, 0.2, 10.2, 2.0).box(6.25, 0.2, 6.85, 2.2)            # bed, wardrobe
    p.box(9.75, 2.1, 10.2, 2.5)                                     # night stand
    p.desk(8.4, 7.45, 1.6, 0.7).box(5.9, 7.8, 7.6, 8.2)             # desk, bookshelf
    p.box(9.9, 4.55, 10.2, 5.2)                                     # coats
    return p, (1.5, 5.2, 0.0)


def office():
    """An office floor of about 500 square metres: a corridor, rooms on both sides, an open-plan end and a kitchen."""
    p = Plan(30.4, 17.4, solid=True)
    w = 0.2
    p.room(w, 7.7, 30.2, 9.6)                                       # corridor
    doors_x = []
    x = w
    for width in (3.6, 3.6, 4.4, 3.6, 3.6):                         # offices below
        p.room(x, w, x + width, 7.55)
        doors_x.append(x + width - 0.9)
        x += width + WALL
    for door in doors_x:
        p.door(door, 7.625)
    p.room(x, w, 30.2, 7.55).door(x + 1.2, 7.625, 1.6)              # meeting room
    p.room(w, 9.75, 12.6, 17.2).door(2.0, 9.675, 1.8).door(10.8, 9.675, 1.8)   # open plan
    x = 12.75
    for width in (3.2, 3.2, 4.0):                                   # offices above
        p.room(x, 9.75, x + width, 17.2).door(x + 0.9, 9.675)
        x += width + WALL
    p.room(x, 9.75, 30.2, 13.4).door(x + 3.2, 9.675, 1.2)           # kitchen
    p.room(x, 13.55, 30.2, 17.2).door(x + 1.2, 13.475)              # store behind it
    furnish_office(p)
    return p, (1.2, 8.65, 0.0)


def furnish_office(p):
    for x in (0.5, 4.25, 8.2, 12.5, 16.2):
        p.desk(x, 1.2).desk(x, 4.4)
        p.box(x - 0.1, 6.8, x + 1.0, 7.2)
    p.box(22.6, 2.4, 27.6, 4.4)                                     # meeting table
    for i in range(5):
        p.disc(23.2 + i, 1.9, 0.22).disc(23.2 + i, 4.9, 0.22)
    for y in (11.4, 13.6, 15.8):
        for x in (1.2, 3.4, 5.6, 7.8, 10.0):
            p.desk(x, y)
    for x in (4.3, 8.6):                                            # columns
        p.box(x, 12.5, x + 0.4, 12.9)
    for x in (13.0, 16.35, 19.7):
        p.desk(x, 15.9).desk(x, 12.6)
    p.box(29.6, 9.75, 30.2, 13.4).box(25.4, 11.2, 27.2, 12.0)       # kitchen units, table
    for y in (14.4, 15.6, 16.8):                                    # shelves
        p.box(25.6, y, 30.2, y + 0.4)
    p.box(12.0, 7.7, 13.0, 8.05).disc(20.0, 9.3, 0.25)              # copier, plant


def maze(rows=13, cols=16, seed=4):
    """A maze with corridors of 0.6 m between walls of 0.1 m, by a randomised depth-first search, with a few loops."""
    pitch, wall = 0.7, 0.1
    p = Plan(cols * pitch + wall, rows * pitch + wall, solid=True)
    rng = random.Random(seed)

    def carve(a, b):
        (r0, c0), (r1, c1) = min(a, b), max(a, b)
        p.box(c0 * pitch + wall, r0 * pitch + wall, c1 * pitch + pitch, r1 * pitch + pitch, solid=False)

    def neighbours(cell):
        r, c = cell
        around = [(r + 1, c), (r - 1, c), (r, c + 1), (r, c - 1)]
        return [(a, b) for a, b in around if 0 <= a < rows and 0 <= b < cols]

    stack, seen = [(0, 0)], {(0, 0)}
    while stack:
        ahead = [n for n in neighbours(stack[-1]) if n not in seen]
        if not ahead:
            stack.pop()
            continue
        chosen = rng.choice(ahead)
        carve(stack[-1], chosen)
        seen.add(chosen)
        stack.append(chosen)
    for _ in range(10):
        cell = (rng.randrange(rows), rng.randrange(cols))
        carve(cell, rng.choice(neighbours(cell)))
    return p, (0.4, 0.4, 0.0)


def blurred(field, radius):
    """Mean over a square window of `radius` cells on each side; the border cells are repeated outside."""
    for axis in (0, 1):
        pad = [(radius, radius) if a == axis else (0, 0) for a in (0, 1)]
        total = np.cumsum(np.pad(field, pad, mode='edge'), axis=axis)
        zero = np.zeros_like(np.take(total, [0], axis=axis))
        total = np.concatenate([zero, total], axis=axis)
        n = field.shape[axis]
        high = np.take(total, range(2 * radius + 1, 2 * radius + 1 + n), axis=axis)
        field = (high - np.take(total, range(n), axis=axis)) / (2 * radius + 1)
    return field


def connected(free, start):
    """The free cells 4-connected to the start."""
    reached = np.zeros_like(free)
    reached[start] = True
    while True:
        grown = reached.copy()
        grown[1:] |= reached[:-1]
        grown[:-1] |= reached[1:]
        grown[:, 1:] |= reached[:, :-1]
        grown[:, :-1] |= reached[:, 1:]
        grown &= free
        if (grown == reached).all():
            return reached
        reached = grown


def cave(seed=11):
    """A cave: smoothed noise, so that no wall is straight, with the chambers joined by winding passages."""
    p = Plan(22.0, 16.0, solid=True)
    rng = np.random.RandomState(seed)
    noise = rng.random_sample(p.solid.shape)
    for _ in range(3):
        noise = blurred(noise, 9)
    rows, cols = np.indices(noise.shape)
    inset = np.minimum(np.minimum(rows, rows[::-1]), np.minimum(cols, cols[:, ::-1])) * RESOLUTION
    noise -= 0.03 * np.clip(1.5 - inset, 0.0, None) ** 2            # closes the cave before the edge, along the noise
    rank = np.argsort(np.argsort(noise, axis=None)).reshape(noise.shape) / noise.size
    p.solid = rank < 0.52
    for k in range(220):                                            # a winding passage from end to end
        x = 1.5 + 19.0 * k / 219
        p.disc(x, 8.0 + 4.6 * np.sin(0.62 * x) + 0.8 * np.sin(2.3 * x), 0.55, solid=False)
    start = (2.0, 8.0 + 4.6 * np.sin(1.24) + 0.8 * np.sin(4.6))
    p.disc(start[0], start[1], 0.6, solid=False)
    cell = (Plan.cells(start[1]), Plan.cells(start[0]))
    p.solid = ~connected(~p.solid, cell)
    return p, (start[0], round(start[1], 2), 0.0)


def loop():
    """A corridor that closes after 69 m, with niches, doors and a few rooms so that no two places look the same."""
    p = Plan(24.4, 17.4, solid=True)
    x0, y0, x1, y1, width = 1.5, 1.5, 22.9, 15.9, 1.6
    p.room(x0, y0, x1, y1).box(x0 + width, y0 + width, x1 - width, y1 - width)
    for x, depth in ((4.0, 0.5), (7.5, 0.9), (13.0, 0.4), (18.6, 0.7)):
        p.box(x, y0 - depth, x + 1.1, y0, solid=False).box(x + 1.7, y1, x + 2.3, y1 + depth, solid=False)
    for y, depth in ((4.2, 0.6), (8.4, 0.9), (11.9, 0.4)):
        p.box(x0 - depth, y, x0, y + 0.8, solid=False).box(x1, y + 1.2, x1 + depth, y + 2.1, solid=False)
    p.room(5.0, 4.3, 9.4, 9.0).door(7.0, 3.7, 0.9, depth=1.4)       # rooms in the core
    p.room(14.2, 8.6, 19.6, 13.1).door(16.2, 13.7, 0.9, depth=1.4)
    p.box(6.2, 6.4, 7.6, 7.2).disc(17.6, 10.6, 0.5)
    p.box(10.5, y0, 10.9, y0 + 0.4).disc(15.2, y1 - 0.3, 0.25).box(x0, 10.1, x0 + 0.35, 10.7)
    return p, (2.3, 2.3, 0.0)


def small():
    """Two rooms of 20 square metres together, for tests."""
    p = Plan(5.6, 4.4, solid=True)
    p.room(0.2, 0.2, 2.9, 4.2).room(3.05, 0.2, 5.4, 4.2).door(2.975, 3.2, 0.9, vertical_wall=True)
    p.box(1.2, 1.6, 1.8, 2.2).box(4.6, 0.2, 5.4, 0.8)
    return p, (0.7, 0.8, 0.0)


WORLDS = (flat, office, maze, cave, loop, small)


def write(contents):
    """Replaces all these files, or leaves them as they were if one of them cannot be written."""
    parts = {path: path + '.part' for path in contents}
    try:
        for path, part in parts.items():
            with open(part, 'wb') as file:
                file.write(contents[path])
        for path, part in parts.items():
            os.replace(part, path)
    finally:
        for part in parts.values():
            if os.path.exists(part):
                os.remove(part)


def save(directory, name, plan, start, about):
    image = np.where(np.flipud(plan.solid), 0, 254).astype(np.uint8)
    picture = b'P5\n%d %d\n255\n' % (image.shape[1], image.shape[0]) + image.tobytes()
    text = '# %s\n' % about.split('\n')[0]
    text += 'image: %s.pgm\nresolution: %g\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n' % (name, RESOLUTION)
    text += 'occupied_thresh: 0.65\nfree_thresh: 0.196\nstart: [%g, %g, %g]\n' % start
    stem = os.path.join(directory, name)
    write({stem + '.pgm': picture, stem + '.yaml': text.encode()})


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = CommandLine(__doc__, 'scripts/draw_worlds.py /tmp/worlds')
    parser.add_argument('directory', nargs='?', default=os.path.join(here, '..', 'config', 'worlds'))
    directory = parser.parse_args().directory
    os.makedirs(directory, exist_ok=True)
    for draw in WORLDS:
        plan, start = draw()
        save(directory, draw.__name__, plan, start, draw.__doc__)
        print('%-8s %5.1f m2 free, start %s' % (draw.__name__, (~plan.solid).sum() * RESOLUTION ** 2, start))


if __name__ == '__main__':
    exit_with(main)
