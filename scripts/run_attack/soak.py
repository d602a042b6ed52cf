"""A long ordinary life: explorations, patrols, turns, saved, loaded and new maps, over and over. [FLT-1]"""
import collections
import contextlib
import itertools
import os
import random
import statistics
import time

import rospy
from frontier_pilot.srv import LoadMap, SaveMap
from std_srvs.srv import Empty, Trigger

from run_attack import environment, services
from run_attack.phases import Phases
from run_attack.robot_watch import watch_from_the_start
from run_attack.system import System, pids, resident_memory, wait_until

WORLD = str(environment.ROOT / 'config/worlds/small.yaml')
SPEED = 8  # of the simulation: more than the nodes keep up with all the time, as on a computer that is too slow
SETTLED = 1800.0  # [s] of the simulation, after which memory has to stay as it is
MOST_GROWTH = 3.0  # [MB] of a node for each hour of the simulation after that ...
MOST_NOISE = 6.0  # ... [MB], unless it has grown by less than this in all
MOST_DRIFT = 1.6  # times the CPU time that a node needs for a second of the simulation
LEAST_LOAD = 0.02  # [s/s]: of a node that needs less, the drift is noise
LEAST_TIME = 7200.0  # [s] of the simulation: in less, a quarter of the time is a few jobs, and these differ
LEAST_SUCCESS = 0.6  # share of the jobs of each kind that have to succeed
MOST_DISK = 150.0  # [MB] of logs, maps and copies of maps


def slope(points):
    """The median of the slopes between all pairs of points (x, y): Theil and Sen's estimate. 0 for fewer than two points."""
    points = points[::max(1, len(points) // 200)]
    slopes = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in itertools.combinations(points, 2) if b[0] > a[0]]
    return statistics.median(slopes) if slopes else 0.0


def cpu_time(pid):
    """What a process has used [s]; None if it has ended."""
    try:
        with open('/proc/%d/stat' % pid) as stat:
            fields = stat.read().rsplit(')', 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')
    except OSError:
        return None


def disk_use(folder):
    """What lies in a folder [MB]."""
    size = 0
    for path, _, names in os.walk(folder):
        for name in names:
            with contextlib.suppress(OSError):  # a log that is rotated meanwhile
                size += os.stat(os.path.join(path, name), follow_symlinks=False).st_size
    return size / 1e6


class Record:
    """Memory and CPU time of one node over the time of the simulation."""

    def __init__(self):
        self.memory = []  # (time of the simulation [s], [MB])
        self.cpu = []  # (time of the simulation [s], [s])

    def growth(self):
        """After it has settled: [MB] for each hour, and in all."""
        begin = self.memory[0][0] + min(SETTLED, 0.25 * (self.memory[-1][0] - self.memory[0][0]))
        settled = [point for point in self.memory if point[0] >= begin]
        by_hour = 3600.0 * slope(settled)
        return by_hour, by_hour * (settled[-1][0] - settled[0][0]) / 3600.0

    def load(self):
        """CPU time for a second of the simulation in the second quarter of the time, and in the last; None for a short one."""
        if self.cpu[-1][0] - self.cpu[0][0] < LEAST_TIME:
            return None

        def between(begin, end):
            part = self.cpu[int(begin * (len(self.cpu) - 1)):int(end * (len(self.cpu) - 1)) + 1]
            took = part[-1][0] - part[0][0]
            return (part[-1][1] - part[0][1]) / took if took > 0.0 else 0.0
        return between(0.25, 0.5), between(0.75, 1.0)


def judge(records, outcome):
    """Says what has grown, and how fast."""
    rates = []
    for node, record in sorted(records.items()):
        by_hour, in_all = record.growth()
        earlier, later = record.load() or (0.0, 0.0)
        rates.append('%s %+.1f' % (node, by_hour))
        outcome.expect(by_hour <= MOST_GROWTH or in_all <= MOST_NOISE,
                       '%s grows by %.1f MB an hour of the simulation' % (node, by_hour))
        outcome.expect(later <= MOST_DRIFT * max(earlier, LEAST_LOAD),
                       '%s needs %.3f s of CPU time a second instead of %.3f' % (node, later, earlier))
    outcome.figure('memory of the nodes [MB] for each hour of the simulation: ' + ', '.join(rates))


class Life:
    """One job after the other, each for some seconds."""

    def __init__(self, folder, watch, phases, draw):
        self.tried, self.done = collections.Counter(), collections.Counter()
        self._watch, self._phases, self._draw = watch, phases, draw
        self._map = os.path.join(folder, 'floor')
        self._kinds = [self.explore, self.explore, self.patrol, self.turn, self.save, self.load, self.begin_anew, self.put_back]

    def go_on(self):
        job = self._draw.choice(self._kinds)
        if job == self.load and not self.done['save']:
            job = self.save
        self.tried[job.__name__] += 1
        self.done[job.__name__] += bool(job())

    def judge(self, outcome):
        """Says how many jobs there were: an attack on a robot that does nothing would find nothing."""
        outcome.figure('jobs: ' + ', '.join('%s %d of %d' % (kind, self.done[kind], tried)
                                            for kind, tried in sorted(self.tried.items())))
        for kind, tried in self.tried.items():
            outcome.expect(tried < 5 or self.done[kind] >= LEAST_SUCCESS * tried,
                           'only %d of %d times it could %s' % (self.done[kind], tried, kind.replace('_', ' ')))

    def explore(self):
        drives = self._phases.explore()
        wait_until(self._watch.done, 20.0)
        return drives

    def patrol(self):
        drives = self._phases.rest() and self._phases.patrol()
        time.sleep(3.0)
        return self._phases.rest() and drives

    def turn(self):
        turns = self._phases.rest() and self._phases.spin()
        return self._phases.rest() and turns

    def save(self):
        answer = services.call('mapper/save_map', SaveMap, SaveMap._request_class(self._map), 20.0)
        return answer is not None and answer.success

    def load(self):
        self._phases.rest()
        answer = services.call('mapper/load_map', LoadMap, LoadMap._request_class(self._map), 20.0)
        return answer is not None and answer.success and services.call('frontier_explorer/reset', Trigger) is not None

    def begin_anew(self):
        answers = [self._phases.rest(), services.call('mapper/reset', Trigger), services.call('frontier_explorer/reset', Trigger)]
        return all(answers)

    def put_back(self):
        self._phases.rest()
        return services.call('reset_positions', Empty) is not None and self.begin_anew()


def attack(folder, seconds, arguments, outcome):
    system = System(folder, WORLD, arguments.seed, ['speed:=%d' % SPEED])
    try:
        watch = watch_from_the_start(system, 'attack_soak', outcome)
        if watch is None:
            return
        phases = Phases(watch)
        outcome.expect(phases.wait_for_servers(), 'the actions are not served')
        live(folder, seconds, Life(folder, watch, phases, random.Random(arguments.seed)), outcome)
        outcome.expect(watch.contacts == 0, 'the robot touched something: ' + watch.last_contact)
    finally:
        system.end()


def live(folder, seconds, life, outcome):
    nodes = pids()
    if not outcome.expect(all(nodes.values()), 'a node is missing from the start: %s' % nodes):
        return
    records = {node: Record() for node in nodes}
    began, end = rospy.get_time(), time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            life.go_on()
        except services.NoAnswer as error:
            outcome.expect(False, str(error))
        now = rospy.get_time()
        for node, pid in nodes.items():
            memory, cpu = resident_memory(pid), cpu_time(pid)
            if memory is not None and cpu is not None:
                records[node].memory.append((now, memory))
                records[node].cpu.append((now, cpu))
    outcome.figure('%.2f hours of the simulation, at %.1f times real time' % ((now - began) / 3600.0, (now - began) / seconds))
    outcome.expect(wait_until(lambda: pids() == nodes, 10.0), 'a node has died: %s before, %s now' % (nodes, pids()))
    life.judge(outcome)
    judge({node: record for node, record in records.items() if record.memory}, outcome)
    used = disk_use(folder)
    outcome.figure('%.1f MB of logs and maps' % used)
    outcome.expect(used <= MOST_DISK, 'logs and maps take %.0f MB' % used)
