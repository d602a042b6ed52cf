"""What lasted from when to when, from samples of a state."""
import math


class States:
    """The values of something over time, of which only the changes are kept. A value of which nothing more is said lasts for `lifetime`
    [s], and None follows it."""

    def __init__(self, lifetime=math.inf):
        self.lifetime = lifetime
        self.changes = []  # (time [s], value)
        self.heard = 0.0  # when a value was said last, by the same time

    def add(self, time, value):
        if time - self.heard > self.lifetime:
            self.interrupt()
        self.heard = time
        if not self.changes or self.changes[-1][1] != value:
            self.changes.append((time, value))

    def interrupt(self, at=0.0):
        """What was said last need not last any longer than until `at`, or until it was said."""
        if self.changes and self.changes[-1][1] is not None:
            self.changes.append((max(at, self.heard, self.changes[-1][0]), None))

    def intervals(self, end):
        """(begin, end, value) of each value [s]; the last one lasts until `end`, unless its lifetime is over by then."""
        end = min(end, self.heard + self.lifetime)
        ends = [time for time, _ in self.changes[1:]] + [end]
        return [(begin, max(begin, until), value) for (begin, value), until in zip(self.changes, ends)]

    def those(self, end, accept=bool):
        """The intervals of the values that `accept` takes."""
        return [interval for interval in self.intervals(end) if accept(interval[2])]


def merged(spans, gap=0.0):
    """Spans (begin, end, ...) as (begin, end), those that overlap or are less than `gap` apart as one."""
    out = []
    for begin, end in sorted(span[:2] for span in spans):
        if out and begin - out[-1][1] <= gap:
            out[-1] = (out[-1][0], max(end, out[-1][1]))
        else:
            out.append((begin, end))
    return out


def total(spans):
    """How long they last together [s]."""
    return sum(end - begin for begin, end in merged(spans))
