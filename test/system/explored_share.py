"""How much of the reachable floor of a world a published map shows: own measure, independent of the nodes."""
import collections
import math
import os

import numpy as np
import yaml
from PIL import Image


class World:
    """A map_server world: `solid[row, column]`, the lowest row first; what is not free counts as solid."""

    def __init__(self, path):
        with open(path) as file:
            meta = yaml.safe_load(file)
        image = Image.open(os.path.join(os.path.dirname(path), meta['image'])).convert('L')
        shade = np.flipud(np.asarray(image, dtype=float)) / 255.0
        darkness = shade if meta['negate'] else 1.0 - shade
        self.solid = darkness >= meta['free_thresh']
        self.resolution = meta['resolution']
        self.origin = meta['origin'][:2]
        self.start = meta.get('start')

    def reachable_floor(self, start, radius):
        """Centres [m] of the free cells that a disc covers on its ways from `start`, in the world's frame."""
        ring = disc(int(math.ceil(radius / self.resolution)))
        fits = ~spread(self.solid, ring)
        row, column = (int((start[i] - self.origin[i]) / self.resolution) for i in (1, 0))
        covered = spread(connected(fits, (row, column)), ring) & ~self.solid
        rows, columns = np.nonzero(covered)
        return np.stack([self.origin[0] + (columns + 0.5) * self.resolution,
                         self.origin[1] + (rows + 0.5) * self.resolution])


def disc(cells):
    span = range(-cells, cells + 1)
    return [(i, j) for i in span for j in span if i * i + j * j <= cells * cells]


def spread(mask, offsets):
    """Where a set cell lies at one of the offsets."""
    margin = max(max(abs(i), abs(j)) for i, j in offsets)
    padded = np.pad(mask, margin)
    height, width = mask.shape
    result = np.zeros_like(mask)
    for i, j in offsets:
        result |= padded[margin + i:margin + i + height, margin + j:margin + j + width]
    return result


def connected(mask, start):
    """The set cells that can be reached from `start` over edges."""
    reached = np.zeros_like(mask)
    if not mask[start]:
        raise ValueError('the start is not free')
    reached[start] = True
    queue = collections.deque([start])
    while queue:
        row, column = queue.popleft()
        for cell in ((row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)):
            if 0 <= cell[0] < mask.shape[0] and 0 <= cell[1] < mask.shape[1] and mask[cell] and not reached[cell]:
                reached[cell] = True
                queue.append(cell)
    return reached


def explored_share(floor, start, grid):
    """The share of `floor` (2 x n, world's frame) that `grid` shows as free; `start` is the pose of map in world."""
    cos, sin = math.cos(start[2]), math.sin(start[2])
    dx, dy = floor[0] - start[0], floor[1] - start[1]
    columns = np.floor((cos * dx + sin * dy - grid.info.origin.position.x) / grid.info.resolution).astype(int)
    rows = np.floor((cos * dy - sin * dx - grid.info.origin.position.y) / grid.info.resolution).astype(int)
    cells = np.asarray(grid.data, np.int8).reshape(grid.info.height, grid.info.width)
    inside = (rows >= 0) & (columns >= 0) & (rows < grid.info.height) & (columns < grid.info.width)
    values = np.full(rows.shape, -1, np.int8)
    values[inside] = cells[rows[inside], columns[inside]]
    return float(np.mean((values >= 0) & (values < 50)))
