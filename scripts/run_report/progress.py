"""What is kept of the explorer's status: of each one a few figures, because a run has thousands, with up to 100 frontiers each."""
import collections
import math

DONE, NAVIGATING = 4, 2  # ExplorerStatus


class Progress(collections.namedtuple('Progress', 'state state_text reason_text goals_sent goals_reached goals_failed explored_area '
                                                  'distance_travelled estimated_area estimated_area_deviation share_explored')):
    """The fields of one status that a page shows, but for its frontiers."""


def progress_of(status):
    """Raises ValueError if a figure cannot be, and AttributeError if one is missing."""
    progress = Progress(*(getattr(status, name) for name in Progress._fields))
    if not math.isfinite(progress.explored_area) or not math.isfinite(progress.distance_travelled):
        raise ValueError('they have an area or a distance that is not finite')
    return progress
