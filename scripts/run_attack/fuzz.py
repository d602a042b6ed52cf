"""The structured fuzzer: whatever the nodes read and serve gets messages and calls that are made from the definitions.

An honest round leaves out what lies about the world and what drives the wheels, so that the robot may touch nothing. A round
with everything then asks only that the nodes live, that the stop holds, and that memory stays bounded.
"""
import json
import random
import threading
import time

import rospy
from std_srvs.srv import Trigger

from run_attack import fuzz_plan, fuzz_sender, interfaces, judge, recordings, services
from run_attack.environment import ROOT
from run_attack.lives import Lives
from run_attack.messages import Generator
from run_attack.robot_watch import watch_from_the_start
from run_attack.stop_callers import Caller
from run_attack.stops import start_module
from run_attack.system import System, pids, wait_until

WORLD = str(ROOT / 'config/worlds/small.yaml')
RATE = 4000.0  # messages per second, if the machine and the nodes keep up
LEAST = 1e5  # messages in a minute that an attack needs on a quiet machine
TURN = 6.0  # [s] for which some topics and services are used; with all at once there would always be a cancel
STOPPED = 0.6  # after this share of a turn the robot is stopped
TO_WORK = 5.0  # [s] that the robot has before a turn to drive again
MOST_GROWTH = 250.0  # [MB] of a node's memory over a round: the largest map and message that it takes, see docs/limits.md
GOES_ON = 30.0  # [s] after the fuzz within which the robot explores again


def some_of(names, draw):
    """A few of the names, or half of them."""
    return draw.sample(sorted(names), draw.choice((3, 6, (len(names) + 1) // 2)))


class Calls:
    """A thread that calls one service after the other with made requests."""

    def __init__(self, kinds, generator, draw):
        self.made = 0
        self.silent = set()
        self.last = {}
        self.names = sorted(kinds)
        self._kinds, self._generator, self._draw = kinds, generator, draw
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self):
        while not self._ending.is_set():
            names = self.names
            if not names:
                time.sleep(0.1)
                continue
            name = self._draw.choice(names)
            request = self._generator.message(self._kinds[name]._request_class)
            self.last = {'service': name, 'request': str(request)[:5000]}
            try:
                services.call(name, self._kinds[name], request)
            except services.NoAnswer:
                self.silent.add(name)
            self.made += 1

    def end(self):
        self._ending.set()
        self._thread.join(2.0 * services.PATIENCE)


class Round:
    """One round of the fuzz against a system that runs."""

    def __init__(self, system, watch, honest, seed, outcome):
        self.system, self.watch, self.honest, self.outcome = system, watch, honest, outcome
        self.name = 'honest' if honest else 'everything'
        self.draw = random.Random('%d %s' % (seed, self.name))
        topics, self.services = interfaces.topics(), interfaces.services()
        self.topics = {name: topics[name] for name in fuzz_plan.chosen(topics, honest)}
        self.called = {name: self.services[name] for name in fuzz_plan.chosen(self.services, honest)}
        self.samples = interfaces.samples(topics, 2.0)
        self.sender = fuzz_sender.Sender(self.topics)
        self.calls = None
        self.caller, self.goals = Caller(persistent=False), services.Goals()
        self.turns = self.driving_turns = self.unanswered = 0

    def generator(self, paths):
        return Generator(self.draw.getrandbits(32), rospy.get_time(), ('map', 'odom', 'base_footprint', 'base_scan', 'base_link'),
                         self.samples, paths)

    def keep(self, node):
        """The last messages before a death, so that they can be sent again."""
        path = self.system.path('%s_died.jsonl' % node)
        fuzz_sender.write_kept(self.sender.kept, path)
        with open(path + '.call', 'w') as file:
            json.dump(self.calls.last if self.calls else {}, file)
        print('fuzz: %s has died; scripts/attack --replay %s sends the last messages again' % (node, path), flush=True)

    def run(self, seconds):
        """Sends for so long, and says what did not hold."""
        lives, contacts, driven = Lives(self.keep), self.watch.contacts, self.watch.distance
        probe_log = self.system.path('probe_%s.json' % self.name)
        probe = start_module('probe', seconds + TURN + TO_WORK + 8.0, probe_log)
        self.calls = Calls(self.called, self.generator(paths=False), random.Random(self.draw.random()))
        begin = time.monotonic()
        while time.monotonic() < begin + seconds:
            self.take_turn(min(TURN, begin + seconds - time.monotonic()))
        last = time.monotonic()
        self.calls.end()
        self.sender.close()
        self.outcome.figure('%s round: %d messages on %d topics in %.0f s (%.0f a minute), %d calls of %d services' % (
            self.name, self.sender.sent, len(self.topics), last - begin, 60.0 * self.sender.sent / (last - begin),
            self.calls.made, len(self.called)))
        self.outcome.expect(self.sender.sent / (last - begin) * 60.0 >= 0.3 * LEAST, 'too few messages to show anything')
        self.judge_lives(lives)
        self.judge_services()
        if self.honest:
            self.outcome.figure('%s round: the robot explored at the begin of %d of %d turns, and drove %.1f m' % (
                self.name, self.driving_turns, self.turns, self.watch.distance - driven))
            self.outcome.expect(self.watch.contacts == contacts,
                                'the robot touched something in the honest round: ' + self.watch.last_contact)
        probe.wait(30.0)
        with open(probe_log) as file:
            self.judge_stops(json.load(file))

    def take_turn(self, seconds):
        """Some topics and services for so long, while the robot drives at first and is then stopped."""
        self.calls.names = []
        self.turns += 1
        self.driving_turns += self.set_to_work()
        self.sender.fill_pools(self.generator(paths=True), self.honest, some_of(self.topics, self.draw))
        self.calls.names = some_of(self.called, self.draw)
        stopping = threading.Timer(STOPPED * seconds, self.stop)
        stopping.start()
        self.sender.send_for(seconds, RATE, self.draw)
        stopping.join()

    def stop(self):
        self.unanswered += not self.caller.stop()

    def set_to_work(self):
        """Takes back what the last turn has asked for; gives whether the robot explores. A goal would refuse the clear."""
        try:
            services.explore(False)
            self.goals.cancel()
            for name in ('frontier_explorer/clear_bounds', 'waypoint_follower/clear'):
                services.call(name, Trigger)
            services.switch('set_nav_enabled', True)
            wait_until(self.caller.clear, 1.5)
            services.explore(True)
        except services.NoAnswer:
            return False  # counted where the services are called one by one
        return wait_until(lambda: self.watch.speed is not None and self.watch.speed > 0.05, TO_WORK)

    def judge_lives(self, lives):
        now = pids()
        lives.end()
        for node, pid in lives.before.items():
            self.outcome.expect(node not in lives.dead and now[node] == pid, '%s died in the %s round' % (node, self.name))
        growth = lives.growth()
        largest = max(growth, key=growth.get)
        self.outcome.figure('%s round: memory grew by %.0f MB at most, that of %s' % (self.name, growth[largest], largest))
        for node, grown in growth.items():
            self.outcome.expect(grown <= MOST_GROWTH, 'the memory of %s grew by %.0f MB' % (node, grown))

    def judge_services(self):
        silent = set()
        for name, kind in sorted(self.services.items()):
            if fuzz_plan.RESERVED.search(name):
                continue
            try:
                services.call(name, kind)
            except services.NoAnswer:
                silent.add(name)
        for name in sorted(silent):
            self.outcome.expect(False, '%s did not answer within %.0f s after the %s round' % (
                name, services.PATIENCE, self.name))
        if self.calls.silent - silent:
            self.outcome.figure('%s round: while it lasted, %s took longer than %.0f s' % (
                self.name, ', '.join(sorted(self.calls.silent - silent)), services.PATIENCE))

    def judge_stops(self, probe):
        messages = [judge.Message(*message) for message in probe['messages']]
        calls = [judge.Call(*call) for call in self.caller.log]
        spans, judged = judge.stopped_spans(calls)
        found = judge.violations(messages, calls)
        self.outcome.figure('%s round: %d stops held against %d messages at the base, %d of which move' % (
            self.name, judged, len(messages), sum(message.moves for message in messages)))
        self.outcome.expect(not found, '%d commands that move left the arbiter while a stop held' % len(found))
        self.outcome.expect(self.unanswered == 0, '%d stops were not answered in the %s round' % (self.unanswered, self.name))
        self.outcome.expect(judged > 0, 'no stop could be judged in the %s round' % self.name)


def explores_again(system, watch, outcome, name):
    """The robot explores within 30 s, at the worst after the launch was started again."""
    def goes_on():
        driven = watch.distance
        deadline = time.monotonic() + GOES_ON
        while time.monotonic() < deadline:
            caller.clear()
            services.explore(True)
            if wait_until(lambda: watch.distance > driven + 0.2, 1.0):
                return True
        return False
    goals, caller = services.Goals(), Caller(persistent=False)
    time.sleep(0.5)
    try:
        services.set_upright(goals)
        caller.clear()
        again = goes_on()
    except services.NoAnswer as error:
        outcome.figure('%s round: %s' % (name, error))
        again = False
    if again:
        return outcome.figure('%s round: the robot explores again' % name)
    said = watch.explorer.reason_text if watch.explorer else 'nothing'
    outcome.figure('%s round: the launch has to be started again; the explorer says: %s' % (name, said))
    system.end_launch()
    system.start_launch()
    outcome.expect(wait_until(system.is_up, 60.0) and goes_on(), 'the robot does not explore again after the %s round' % name)


def replay(system, path, outcome):
    """Sends the messages of an earlier run again."""
    lives = Lives(lambda node: None)
    count = fuzz_sender.replay(path)
    time.sleep(2.0)
    lives.end()
    outcome.figure('%d messages were sent again' % count)
    for node in lives.dead:
        outcome.expect(False, '%s died again' % node)


def attack(folder, seconds, arguments, outcome):
    """Two rounds, or a replay. [FLT-1]"""
    system = System(folder, WORLD, arguments.seed, recordings.ARGUMENTS)
    try:
        watch = watch_from_the_start(system, 'attack_fuzz', outcome)
        if watch is None:
            return
        if arguments.replay:
            return replay(system, arguments.replay, outcome)
        services.explore(True)
        for honest in (True, False):
            Round(system, watch, honest, arguments.seed, outcome).run(seconds / 2.0)
            explores_again(system, watch, outcome, 'honest' if honest else 'everything')
        system.end_launch()
        recordings.judge(folder, outcome)
    finally:
        system.end()
