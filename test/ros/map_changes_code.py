"""The code of frontier_pilot/MapChanges, as its message file describes it."""
from frontier_pilot.msg import MapBlock, MapChanges

USUAL = (-1, 0, 100)


def encode(cells):
    """The runs of a list of cells; only values that maps usually have."""
    runs, begin = bytearray(), 0
    for i in range(1, len(cells) + 1):
        if i == len(cells) or cells[i] != cells[begin] or i - begin == 60:
            runs.append(USUAL.index(cells[begin]) << 6 | (i - begin - 1))
            begin = i
    return bytes(runs)


def decode(runs):
    cells, rest = [], iter(runs)
    for first in rest:
        code, low = first >> 6, first & 63
        value = USUAL[code] if code < 3 else next(rest)
        length = low + 1 if low < 60 else 61 + sum(next(rest) << 8 * i for i in range(low - 59))
        cells += [value - 256 if value > 127 else value] * length
    return cells


def changes_of(grid, sequence, blocks=None):
    """The whole map, or `blocks` (x, y, width, height) of it."""
    message = MapChanges(header=grid.header, info=grid.info, sequence=sequence, whole=blocks is None)
    cells = list(grid.data)
    if blocks is not None:
        message.blocks = [MapBlock(*block) for block in blocks]
        cells = [grid.data[row * grid.info.width + column] for x, y, width, height in blocks
                 for row in range(y, y + height) for column in range(x, x + width)]
    message.runs = encode(cells)
    return message


class Copy:
    """The map as a subscriber knows it who hears `map_changes` alone."""

    def __init__(self):
        self.info, self.cells, self.sequence = None, [], None

    def take(self, message):
        cells = decode(message.runs)
        if message.whole:
            self.info, self.cells = message.info, cells
        elif self.info is None:
            return  # sent before the whole map that this subscriber was given
        else:
            assert message.sequence == (self.sequence + 1) % (1 << 32), (message.sequence, self.sequence)
            values = iter(cells)
            for block in message.blocks:
                for row in range(block.y, block.y + block.height):
                    for column in range(block.x, block.x + block.width):
                        self.cells[row * self.info.width + column] = next(values)
        self.sequence = message.sequence
