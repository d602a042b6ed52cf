"""What became of the explorer's goals, from its status: reached, failed, or dropped on the way."""
import bisect

from .progress import NAVIGATING

REACHED, FAILED, DROPPED, OPEN = 'reached', 'failed', 'dropped', 'under way'


class Goal:
    def __init__(self, number, sent):
        self.number, self.sent = number, sent  # [s]
        self.place = None  # (x, y) in the map [m]
        self.ended, self.outcome, self.why = None, OPEN, ''


class Goals:
    """Pairs the goals with the counts of the status that follow. A goal that is neither reached nor failed when the next one
    is sent, or when the explorer does not drive any more, was dropped: nothing was left to see from it, another one had become
    better, or the exploration was paused or stopped."""

    def __init__(self):
        self.all = []
        self.places = []  # (time [s], x, y) of the poses that were sent
        self.counts = 0, 0, 0  # sent, reached, failed

    def take_pose(self, time, pose):
        self.places.append((time, pose.pose.position.x, pose.pose.position.y))

    def take_status(self, time, status):
        sent, reached, failed = self.counts
        self.counts = status.goals_sent, status.goals_reached, status.goals_failed
        if status.goals_sent < sent:  # the explorer was reset or restarted
            sent = reached = failed = 0
        under_way = self.all[-1] if self.all and self.all[-1].outcome == OPEN else None
        if under_way and status.goals_reached > reached:
            self._end(under_way, time, REACHED, status.reason_text)
        elif under_way and status.goals_failed > failed:
            self._end(under_way, time, FAILED, status.reason_text)
        elif under_way and (status.goals_sent > sent or status.state != NAVIGATING):
            self._end(under_way, time, DROPPED, status.reason_text)
        if status.goals_sent > sent:
            self.all.append(Goal(status.goals_sent, time))

    def place_all(self):
        """Gives each goal the pose that was sent nearest in time to it; to be called at the end."""
        self.places.sort()
        for goal in self.all:
            index = bisect.bisect(self.places, (goal.sent,))
            near = min(self.places[max(0, index - 1):index + 1], key=lambda place: abs(place[0] - goal.sent), default=None)
            goal.place = near[1:] if near else None

    @staticmethod
    def _end(goal, time, outcome, why):
        goal.ended, goal.outcome, goal.why = time, outcome, why

    def of(self, outcome):
        return [goal for goal in self.all if goal.outcome == outcome]
