"""What is kept of the explorer's status: of each one a few figures, because a run has thousands, with up to 100 frontiers each."""
import collections
import math

DONE, NAVIGATING = 4, 2  # ExplorerStatus


class Progress(collections.namedtuple('Progress', 'state state_text reason_text goals_sent goals_reached goals_failed explored_area '
                                                  'distance_travelled estimated_area estimated_area_deviation share_explored')):
    """The fields of one status that a page shows, but for its frontiers."""


class Counts:
    """What the explorer counts from its start, over a run in which it may have been started again or reset."""
    NAMES = ('goals_sent', 'goals_reached', 'goals_failed', 'distance_travelled')

    def __init__(self):
        self.before = dict.fromkeys(self.NAMES, 0)  # of the earlier starts
        self.last = dict.fromkeys(self.NAMES, 0)

    def whole(self):
        """The figures of the whole run by name."""
        return {name: self.before[name] + self.last[name] for name in self.NAMES}

    def take(self, status):
        """The figures of the whole run with those of this status, which is the latest one."""
        now = {name: getattr(status, name) for name in self.NAMES}
        if now['goals_sent'] < self.last['goals_sent'] or now['distance_travelled'] < self.last['distance_travelled']:
            self.before = self.whole()
        self.last = now
        return self.whole()


def progress_of(status):
    """Raises ValueError if a figure cannot be, and AttributeError if one is missing."""
    progress = Progress(*(getattr(status, name) for name in Progress._fields))
    if not math.isfinite(progress.explored_area) or not math.isfinite(progress.distance_travelled):
        raise ValueError('they have an area or a distance that is not finite')
    return progress
