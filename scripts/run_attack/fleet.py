"""Three robots of different kinds in one world: the stop for all, faults of what they have in common and of each, and what a
stranger says to all of them. [FLT-1] [FLT-2] [MUL-2] [MUL-3]"""
import collections
import os
import random
import re
import signal
import time

import rospy
import yaml
from nav_msgs.msg import OccupancyGrid
from std_srvs.srv import Trigger

from robot_starts import draw_starts, read_world
from run_attack import environment, interfaces, services
from run_attack.fuzz_sender import Sender
from run_attack.lives import Lives
from run_attack.messages import Generator
from run_attack.robot_watch import RobotWatch
from run_attack.stop_callers import Caller
from run_attack.system import System, join, pid_of, pids, wait_until

WORLD = str(environment.ROOT / 'config/worlds/office.yaml')
KINDS = ('burger', 'waffle', 'turtlebot2')
OF_ALL = ('map_merger', 'fleet_stop')
OF_EACH = ('mapper', 'navigator', 'waypoint_follower', 'cmd_vel_arbiter', 'behavior_server', 'frontier_explorer')
STOP_ALL = '/fleet/emergency_stop'
TALK = re.compile(r'^/fleet/(claims|motions)$')  # what the robots tell each other; their maps are lies about the world
TO_WORK = 20.0  # [s] within which a robot that may explore drives
STANDS = 3.0  # [s] within which a stopped robot stands
BACK = 20.0  # [s] for a node that was ended to serve again
HEARD = 10.0  # [s] more within which all robots confirm a stop again
SUSPENDED = 3.0  # [s]
KEPT = 0.9  # share of the known cells of the common map
TALK_SHARE = 0.2  # of the time, for what a stranger says
RATE = 500.0  # of its messages a second
MOST_GROWTH = 250.0  # [MB] of a node while it talks


class Robot:
    """One of the robots, as an operator leads it."""

    def __init__(self, name):
        self.name = name
        self.watch = RobotWatch(name)
        self.caller = Caller(persistent=False, space='/%s/' % name)

    def nodes(self):
        return ['%s/%s' % (self.name, node) for node in OF_EACH]

    def call(self, service):
        return services.call('/%s/%s' % (self.name, service), Trigger)

    def explore(self, on):
        return services.explore(on, '/%s/' % self.name)

    def moves(self):
        return self.watch.speed is not None and self.watch.speed > 0.05

    def stands(self):
        return wait_until(lambda: self.watch.speed == 0.0, STANDS)


class Fleet:
    """The robots and the map that they make together."""

    def __init__(self):
        self.robots = [Robot('robot%d' % (number + 1)) for number in range(len(KINDS))]
        self.known = 0
        rospy.Subscriber('/map', OccupancyGrid, self._take_map, buff_size=1 << 22)

    def _take_map(self, message):
        self.known = sum(cell >= 0 for cell in message.data)

    def nodes(self):
        return [*OF_ALL, *(node for robot in self.robots for node in robot.nodes())]

    def contacts(self):
        return sum(robot.watch.contacts for robot in self.robots)

    def last_contacts(self):
        """Who touched something last, where and when, in words."""
        return ', '.join(robot.watch.last_contact for robot in self.robots if robot.watch.last_contact)

    def stop(self):
        """The answer to a stop of all robots."""
        return services.call(STOP_ALL, Trigger)

    def stops_again(self):
        """Whether all confirm a stop, at once or once all connections are there again."""
        def confirmed():
            answer = self.stop()
            return answer is not None and answer.success
        return wait_until(confirmed, HEARD)

    def drive(self):
        """Every stop is cleared and all explore, in a new map if all have finished; gives whether each of them drives."""
        for robot in self.robots:
            robot.explore(False)
            wait_until(robot.caller.clear, 5.0)
        if all(robot.watch.done() for robot in self.robots):
            for robot in self.robots:
                robot.call('mapper/reset')
            for robot in self.robots:
                robot.call('frontier_explorer/reset')
        for robot in self.robots:
            robot.explore(True)
        return self.drives(self.robots)

    @staticmethod
    def drives(robots):
        """Whether each of the robots drives at some time, unless there is nothing left for it to explore."""
        waiting = list(robots)

        def all_seen():
            waiting[:] = [robot for robot in waiting if not (robot.moves() or robot.watch.has_nothing_to_do())]
            return not waiting
        return wait_until(all_seen, TO_WORK)


class Events:
    """What happens to the robots; each gives what did not hold, in words."""

    def __init__(self, fleet, draw):
        self.fleet, self.draw = fleet, draw
        self.kinds = [self.stop_of_all, self.stop_of_all, self.stop_of_one, self.common_node_ends, self.common_node_hangs,
                      self.node_ends, self.node_hangs, self.stop_past_a_frozen_arbiter, self.stop_that_outlives_an_arbiter]

    def stop_of_all(self):
        answer = self.fleet.stop()
        if answer is None or not answer.success:
            return ['the stop of all was answered with: %s' % (answer.message if answer else 'nothing')]
        return self.moving_after_a_stop(self.fleet.robots)

    def stop_of_one(self):
        robot = self.draw.choice(self.fleet.robots)
        others = [other for other in self.fleet.robots if other is not robot]
        failures = [] if robot.caller.stop() else ['%s was not stopped' % robot.name]
        failures += self.moving_after_a_stop([robot])
        return failures + ([] if self.fleet.drives(others) else ['a stop of %s stopped another one' % robot.name])

    def common_node_ends(self):
        return self.end(self.draw.choice(OF_ALL))

    def common_node_hangs(self):
        return self.suspend(self.draw.choice(OF_ALL))

    def node_ends(self):
        return self.end(self.draw.choice(self.draw.choice(self.fleet.robots).nodes()))

    def node_hangs(self):
        return self.suspend(self.draw.choice(self.draw.choice(self.fleet.robots).nodes()))

    def stop_past_a_frozen_arbiter(self):
        """It must not be said to be stopped; the others are."""
        frozen = self.draw.choice(self.fleet.robots)
        pid = pid_of(frozen.name + '/cmd_vel_arbiter')
        os.kill(pid, signal.SIGSTOP)
        try:
            answer = self.fleet.stop()
            others = [robot for robot in self.fleet.robots if robot is not frozen]
            failures = self.moving_after_a_stop(others)
        finally:
            os.kill(pid, signal.SIGCONT)
        if answer is None or answer.success or frozen.name not in answer.message:
            failures.append('with the arbiter of %s frozen, the stop of all was answered with: %s' % (
                frozen.name, answer.message if answer else 'nothing'))
        return failures

    def stop_that_outlives_an_arbiter(self):
        robot = self.draw.choice(self.fleet.robots)
        failures = self.stop_of_all()
        since = time.monotonic()
        failures += self.end(robot.name + '/cmd_vel_arbiter')
        time.sleep(1.0)
        return failures + ['%s moved although it was stopped' % each.name for each in self.fleet.robots
                           if each.watch.moved_since(since)]

    @staticmethod
    def moving_after_a_stop(robots):
        """The robots brake, and then stand for a second."""
        failures = ['%s does not stand after the stop' % robot.name for robot in robots if not robot.stands()]
        since = time.monotonic()
        time.sleep(1.0)
        return failures + ['%s moved although it was stopped' % robot.name for robot in robots if robot.watch.moved_since(since)]

    def end(self, node):
        """Kills a node or aborts it; another one takes its place."""
        pid = pid_of(node)
        os.kill(pid, self.draw.choice((signal.SIGKILL, signal.SIGABRT)))
        return [] if wait_until(lambda: pid_of(node) not in (None, pid), BACK) else ['%s is not back' % node]

    def suspend(self, node):
        pid = pid_of(node)
        os.kill(pid, signal.SIGSTOP)
        time.sleep(SUSPENDED)
        os.kill(pid, signal.SIGCONT)
        return [] if wait_until(lambda: pid_of(node) == pid, 5.0) else ['%s is not back' % node]


def live(fleet, seconds, draw, outcome):
    """One event after the other, and after each all robots drive again and stop at a call."""
    events, happened, end, drove = Events(fleet, draw), collections.Counter(), time.monotonic() + seconds, 0
    while time.monotonic() < end:
        event, contacts = draw.choice(events.kinds), fleet.contacts()
        drove += fleet.drive()
        known = fleet.known
        happened[event.__name__] += 1
        for words in event():
            outcome.expect(False, '%s: %s' % (event.__name__, words))
        outcome.expect(fleet.stops_again(), '%s: the robots do not confirm a stop any more' % event.__name__)
        outcome.expect(fleet.contacts() == contacts, '%s: a robot touched something: %s' % (event.__name__, fleet.last_contacts()))
        outcome.expect(wait_until(lambda: fleet.known >= KEPT * known, 10.0),
                       '%s: of %d known cells %d are left' % (event.__name__, known, fleet.known))
    outcome.figure('%d events among %d robots: %s' % (sum(happened.values()), len(fleet.robots), ', '.join(
        '%s %d' % (name.replace('_', ' '), count) for name, count in sorted(happened.items()))))
    outcome.expect(drove >= 0.7 * sum(happened.values()), 'only %d of %d times all robots drove before' % (
        drove, sum(happened.values())))


def listen_to_a_stranger(fleet, seconds, draw, outcome):
    """Claims and motions that nobody has: they may hold the robots up, but end no node, hold up no stop and cause no contact."""
    kinds = {topic: kind for topic, kind in interfaces.topics({'/' + node for node in fleet.nodes()}).items() if TALK.match(topic)}
    outcome.expect(len(kinds) == 2, 'the robots do not talk to each other: %s' % sorted(kinds))
    generator = Generator(draw.getrandbits(32), rospy.get_time(), ('map', 'robot1/map'), interfaces.samples(kinds, 2.0), True)
    contacts, sender = fleet.contacts(), Sender(kinds)
    fleet.drive()
    died = []
    lives = Lives(died.append, fleet.nodes())
    sender.fill_pools(generator, True, kinds)
    sender.send_for(seconds, RATE, draw)
    outcome.expect(fleet.stops_again(), 'the robots do not confirm a stop while a stranger talks')
    sender.close()
    lives.end()
    growth = lives.growth()
    largest = max(growth, key=growth.get)
    outcome.figure('%d messages of a stranger on %s; memory grew by %.0f MB at most, that of %s' % (
        sender.sent, ' and '.join(sorted(kinds)), growth[largest], largest))
    for node in died:
        outcome.expect(False, '%s died while a stranger talked' % node)
    outcome.expect(growth[largest] <= MOST_GROWTH, 'the memory of %s grew by %.0f MB' % (largest, growth[largest]))
    outcome.expect(fleet.contacts() == contacts, 'a robot touched something while a stranger talked: ' + fleet.last_contacts())
    outcome.expect(wait_until(fleet.drive, 2.0 * TO_WORK), 'the robots do not drive again after a stranger has talked')


def written_starts(folder, seed):
    """The path of a list of robots, one of each kind, near each other in the world."""
    starts = draw_starts(read_world(WORLD), len(KINDS), seed)
    path = os.path.join(folder, 'robots.yaml')
    with open(path, 'w') as file:
        yaml.safe_dump({'robots': [dict(start, robot=kind) for start, kind in zip(starts, KINDS)]}, file)
    return path


def attack(folder, seconds, arguments, outcome):
    nodes = ['simulator', *OF_ALL, *('robot%d/%s' % (number + 1, node) for number in range(len(KINDS)) for node in OF_EACH)]
    words = ['robots:=' + written_starts(folder, arguments.seed)]
    system = System(folder, WORLD, arguments.seed, words, 'robots.launch', nodes)
    draw = random.Random(arguments.seed)
    try:
        if not outcome.expect(system.begin(), 'the system does not start'):
            return
        join('attack_fleet')
        fleet = Fleet()
        outcome.expect(wait_until(lambda: fleet.known > 0, 30.0), 'there is no common map')
        live(fleet, (1.0 - TALK_SHARE) * seconds, draw, outcome)
        listen_to_a_stranger(fleet, TALK_SHARE * seconds, draw, outcome)
        outcome.expect(all(pids(nodes).values()), 'a node is missing at the end: %s' % pids(nodes))
    finally:
        system.end()
