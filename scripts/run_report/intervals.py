"""What lasted from when to when, from samples of a state."""


class States:
    """The values of something over time, of which only the changes are kept."""

    def __init__(self):
        self.changes = []  # (time [s], value)

    def add(self, time, value):
        if not self.changes or self.changes[-1][1] != value:
            self.changes.append((time, value))

    def intervals(self, end):
        """(begin, end, value) of each value [s]; the last one lasts until `end`."""
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
