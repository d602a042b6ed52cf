"""When the sources drive and when stops are called: a schedule that all processes of the attack on the stop share.

A clear is refused while a source asked to move in the last 0.5 s. So all sources are quiet for a while in each cycle, and
towards the end of that nobody stops, so that a clear succeeds and the robot moves again.
"""
import random

CYCLE = 2.5  # [s]
DRIVING = 1.3  # [s] from the begin of a cycle
LULL = 2.1  # [s] after the begin of a cycle no stop is called any more


class Timetable:
    """The schedule of a seed. `start` and all times are of the steady clock [s]."""

    def __init__(self, seed, start):
        self._seed = seed
        self._start = start

    def _place(self, now):
        """Which cycle, and how far into it [s]."""
        cycle, place = divmod(now - self._start, CYCLE)
        return int(cycle), place

    def source_drives(self, source, now):
        """Each source is silent in some tenths of the time in which they drive."""
        cycle, place = self._place(now)
        return place < DRIVING and random.Random('%d %d %d %d' % (self._seed, source, cycle, int(place * 10))).random() < 0.8

    def stops_are_called(self, now):
        """In the lull, and for a random time after the sources have begun to drive, there are none."""
        cycle, place = self._place(now)
        begin = random.Random('%d begin %d' % (self._seed, cycle)).uniform(0.02, 0.6)
        return begin <= place < LULL
