"""The stop under attack."""
import json
import signal
import sys
import time

import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from frontier_pilot.msg import ArbiterStatus

from run_attack import judge, processes, stranger
from run_attack.environment import ROOT
from run_attack.stop_callers import Caller
from run_attack.system import System, join, pid_of, provider, wait_until

WORLD = str(ROOT / 'config/worlds/small.yaml')
RATE = 1000.0  # [Hz] that each source aims at
LEAD = 4.0  # [s] in which the processes of the attack start
REPORTED = 4.0  # [s] within which a stranger is an error: 2 s, and what a busy machine adds
SERVICES = ('/emergency_stop', '/set_emergency_stop')


class ArbiterWatch:
    """What the arbiter says of itself."""

    def __init__(self):
        self.status = None
        self.errors = set()
        rospy.Subscriber('cmd_vel_arbiter/status', ArbiterStatus, lambda message: setattr(self, 'status', message))
        rospy.Subscriber('/diagnostics', DiagnosticArray, self._take)

    def _take(self, message):
        self.errors |= {part.message for part in message.status if part.level == DiagnosticStatus.ERROR}

    def names(self, node):
        """Whether status and diagnostics have named a node in an error."""
        return self.status is not None and any(node in text for text in self.status.problems) and any(
            node in text for text in self.errors)


def start_module(name, *words, log=None):
    return processes.start([sys.executable, '-m', 'run_attack.' + name, *map(str, words)], log,
                           PYTHONPATH='%s:%s' % (ROOT / 'scripts', ':'.join(sys.path[1:])))


def attack_from_outside(system, watch, start, seconds, outcome):
    """The stranger, the second arbiter and the death of the master, each at its share of the time."""
    def wait_for_share(share):
        time.sleep(max(0.0, start + share * seconds - time.monotonic()))
    wait_for_share(0.15)
    intruder = start_module('stranger')
    outcome.expect(wait_until(lambda: pid_of(stranger.NAME) is not None, 20.0) and
                   wait_until(lambda: watch.names('/' + stranger.NAME), REPORTED),
                   'the arbiter does not report a stranger on cmd_vel as ERROR by its name within %.0f s' % REPORTED)
    processes.end(intruder)
    wait_for_share(0.4)
    before = pid_of('cmd_vel_arbiter')
    second = processes.start(['rosrun', 'frontier_pilot', 'cmd_vel_arbiter', '__name:=second_arbiter'], system.path('second.log'))
    if wait_until(lambda: second.poll() is not None, 5.0):
        outcome.expect(second.returncode != 0, 'a second arbiter started')
    processes.end(second, signal.SIGKILL)
    outcome.expect(pid_of('cmd_vel_arbiter') == before, 'a second arbiter ended the first one')
    wait_for_share(0.65)
    system.kill_master()
    time.sleep(1.0)
    system.start_master()
    back = time.monotonic()
    if outcome.expect(wait_until(lambda: all(provider(name) == '/cmd_vel_arbiter' for name in SERVICES), 10.0),
                      'the arbiter does not offer the stop at a new master'):
        took = time.monotonic() - back
        outcome.figure('the stop is offered at the new master after %.1f s' % took)
        outcome.expect(took < 4.0, 'the stop came back at the new master after %.1f s, not within 4 s' % took)
    wait_for_share(1.0)


def judge_logs(probe, callers, sources, seconds, outcome):
    """Writes the figures, and fails for each command that left while the stop held, and for an attack that was none."""
    messages = [judge.Message(*message) for message in probe['messages']]
    calls = [judge.Call(*call) for call in callers['calls']]
    moving = sum(message.moves for message in messages)
    found = judge.violations(messages, calls)
    spans, judged = judge.stopped_spans(calls)
    stops = sum(call.stop for call in calls)
    held = judge.held_time(calls, max([call.answer for call in calls], default=0.0))
    rate = sources['sent'] / max(0.1, sources['driven'])
    outcome.figure('%.0f commands/s of each source while it drives; %d messages at the base, %d of them move' %
                   (rate, len(messages), moving))
    outcome.figure('%d stops answered without reserve, %d of them judged, %d with the reserve that the zero may not have '
                   'been sent yet; %d clears succeeded, %d were refused; the stop certainly held for '
                   '%.1f s in %d spans' % (
                       stops, judged, callers['unsent'], len(calls) - stops, callers['refused'], held, len(spans)))
    for message in found[:3]:
        outcome.expect(False, 'a command that moves left the arbiter between a stop and the next clear: read at the base at '
                       '%.4f s of the steady clock' % message.latest)
    outcome.expect(len(found) <= 3, '... and %d more' % (len(found) - 3))
    outcome.expect(callers['hanging'] == 0, '%d calls of a stop or a clear were never answered' % callers['hanging'])
    outcome.expect(judged >= seconds and len(spans) >= seconds / 10.0 and moving >= 2.0 * seconds,
                   'the attack was too weak to show anything: see its figures')


def attack(folder, seconds, arguments, outcome):
    """The stop under attack for so many seconds. [ARB-7] [ARB-8] [ARB-11] [ARB-12]"""
    system = System(folder, WORLD, arguments.seed)
    try:
        if not outcome.expect(system.begin(), 'the system does not start'):
            return
        join('attack_stops')
        watch = ArbiterWatch()
        outcome.expect(wait_until(lambda: watch.status is not None, 20.0), 'the arbiter says nothing')
        start = time.monotonic() + LEAD
        logs = {name: system.path(name + '.json') for name in ('probe', 'callers', 'sources')}
        attackers = [start_module('probe', LEAD + seconds + 1.0, logs['probe']),
                     start_module('velocity_sources', arguments.seed, start, seconds, RATE, logs['sources'],
                                  log=system.path('sources.log')),
                     start_module('stop_callers', arguments.seed, start, seconds, logs['callers'],
                                  log=system.path('callers.log'))]
        attack_from_outside(system, watch, start, seconds, outcome)
        for attacker in attackers:
            attacker.wait(30.0)
        said = {}
        for name, path in logs.items():
            with open(path) as file:
                said[name] = json.load(file)
        judge_logs(said['probe'], said['callers'], said['sources'], seconds, outcome)
        outcome.expect(Caller(False).stop(), 'a stop is not answered after the attack')
    finally:
        system.end()
