"""The matrix of faults: each node is killed, suspended and slowed down in each phase of the work. [FLT-2]"""
import collections
import contextlib
import datetime
import os
import random
import signal
import time

from run_attack import environment, recordings, services, table
from run_attack.phases import PHASES, Phases
from run_attack.robot_watch import watch_from_the_start
from run_attack.system import NODES, System, pid_of, provider, wait_until

WORLD = str(environment.ROOT / 'config/worlds/small.yaml')
PAGE = environment.ROOT / 'docs/reliability.md'
VICTIMS = [node for node in NODES if node != 'simulator']  # which is the world and the base
# A fault ends a node by a signal, or gives it only a share of its time [0 ... 1] for a while [s].
Fault = collections.namedtuple('Fault', 'signal length share', defaults=(None, None, 0.0))
FAULTS = {'killed': Fault(signal.SIGKILL),
          'aborted': Fault(signal.SIGABRT),  # which is how an exception that nothing catches ends a process
          'suspended 1 s': Fault(length=1.0), 'suspended 3 s': Fault(length=3.0), 'suspended 10 s': Fault(length=10.0),
          'slowed 5 s': Fault(length=5.0, share=0.05)}
SLICE = 0.1  # [s]: a node that is slowed down runs for its share of each
MARGIN = 0.2  # [s]
COMMAND_TIMEOUT = 1.0  # [s] of a source at the arbiter
WATCHDOG = 0.6  # [s] of the simulated base
# The nodes without which the robot may not go on in a phase, and how long it may at most [s].
MUST_STAND = {('navigator', 'exploring'): COMMAND_TIMEOUT, ('mapper', 'exploring'): COMMAND_TIMEOUT,
              ('patrol_server', 'patrolling'): COMMAND_TIMEOUT, ('behavior_server', 'spinning'): COMMAND_TIMEOUT}
MUST_STAND.update({('cmd_vel_arbiter', phase): WATCHDOG for phase in ('exploring', 'patrolling', 'spinning')})
BACK = 20.0  # [s] for a node that was ended to serve again
KEPT = {'mapper': 0.9}  # share of the known cells; of a mapper that is ended, the copy of two seconds before
USUALLY_KEPT = 0.98


def standing_limit(node, fault, phase):
    """How long after the fault the base may go on before it brakes [s]; None where the node is back before, or need not be.

    A node that is slowed down may be in time all the same.
    """
    limit = MUST_STAND.get((node, phase))
    _, length, share = FAULTS[fault]
    if limit is None or share > 0.0 or (length is not None and length <= limit + MARGIN):
        return None
    return limit + MARGIN


def starve(pid, length, share):
    """Suspends the process for `length` seconds, or lets it run for `share` of them, a slice at a time."""
    end, pause = time.monotonic() + length, length if share == 0.0 else (1.0 - share) * SLICE
    try:
        while time.monotonic() < end:
            os.kill(pid, signal.SIGSTOP)
            time.sleep(pause)
            os.kill(pid, signal.SIGCONT)
            time.sleep(share * SLICE)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGCONT)


def drawn_cells(seed):
    """All cells of the matrix in the order in which they are visited: every node, fault and phase comes early."""
    cells = [(node, fault, phase) for node in VICTIMS for fault in FAULTS for phase in PHASES]
    random.Random(seed).shuffle(cells)
    return cells


class Cell:
    """One fault of one node in one phase. `run` gives what the table says of it, `failures` has what did not hold."""

    def __init__(self, watch, phases, node, fault, phase):
        self.watch, self.phases = watch, phases
        self.node, self.fault, self.phase = node, fault, phase
        self.failures = []

    def expect(self, held, words):
        if not held:
            self.failures.append(words)
        return held

    def run(self):
        """None where the robot could not be brought into the phase."""
        if not (self.phases.rest() and self.phases.enter(self.phase)):
            return None
        contacts, known, maps = self.watch.contacts, self.watch.known, self.watch.maps
        pid, begin = pid_of(self.node), time.monotonic()
        self.strike(pid)
        stood = self.judge_standing(begin)
        if self.phase == 'stopped':
            self.judge_stop(begin)
        self.expect(self.is_back(pid), 'the node is not back')
        self.judge_map(known, maps)
        try:
            self.expect(wait_until(lambda: self.phases.go_on(self.phase), 1.0), 'the work does not go on')
        except services.NoAnswer as error:
            self.expect(False, str(error))
        self.expect(self.watch.contacts == contacts, 'the robot touched something: ' + self.watch.last_contact)
        return 'FAILED: ' + '; '.join(self.failures) if self.failures else stood

    def strike(self, pid):
        """Ends the node, or suspends it or slows it down for its time."""
        fault = FAULTS[self.fault]
        if fault.signal is not None:
            os.kill(pid, fault.signal)
            return time.sleep(1.5)
        try:
            starve(pid, fault.length, fault.share)
        except ProcessLookupError:
            self.expect(False, 'the node has died meanwhile')

    def judge_standing(self, begin):
        """Gives the text of a cell that held."""
        limit = standing_limit(self.node, self.fault, self.phase)
        if limit is None:
            return 'held'
        limit += self.watch.braking_time(begin, limit)
        stood = self.watch.stood_after(begin)
        length = FAULTS[self.fault].length
        if length is not None and length <= limit and (stood is None or stood > limit):
            return 'held'  # the node was back, and drove on, before the base had braked
        words = 'still moving' if stood is None else '%.2f s' % stood
        self.expect(stood is not None and stood <= limit, 'stood after %s instead of %.2f s' % (words, limit))
        return words

    def judge_stop(self, begin):
        time.sleep(1.0)
        self.expect(not self.watch.moved_since(begin), 'the robot moved while it was stopped')

    def is_back(self, pid):
        """A node that was ended is another process that serves, any other one the same."""
        ended = FAULTS[self.fault].signal is not None
        back = wait_until(lambda: (pid_of(self.node) not in (None, pid)) if ended else pid_of(self.node) == pid, BACK)
        return back and (self.node != 'cmd_vel_arbiter' or
                         wait_until(lambda: provider('/emergency_stop') == '/cmd_vel_arbiter', 5.0))

    def judge_map(self, known, maps):
        """Once the mapper has published again, which it does where something has changed."""
        if self.node == 'mapper' and FAULTS[self.fault].signal is not None:
            wait_until(lambda: self.watch.maps > maps, 10.0)
        share = KEPT.get(self.node, USUALLY_KEPT)
        self.expect(self.watch.known >= share * known, 'of %d known cells %d are left' % (known, self.watch.known))


def draw_cells(watch, phases, seconds, seed, outcome):
    """Visits cells until the time is over: {(node, fault, phase): text}.

    A cell whose phase was not reached is visited again at the end.
    """
    results, end, cells, missed = {}, time.monotonic() + seconds, drawn_cells(seed), []
    while cells and time.monotonic() < end:
        cell = cells.pop(0)
        text = visit(watch, phases, cell, outcome)
        if text is not None:
            results[cell] = text
        elif cell not in missed:
            missed.append(cell)
            cells.append(cell)
    outcome.expect(len(missed) <= 2 + 0.2 * len(results), 'in %d cells the robot did not reach the phase' % len(missed))
    return results


def visit(watch, phases, cell, outcome):
    """The text of a cell, None where its phase was not reached."""
    visited = Cell(watch, phases, *cell)
    try:
        text = visited.run()
    except services.NoAnswer as error:
        visited.expect(False, str(error))
        text = 'FAILED: %s' % error
    for words in visited.failures:
        outcome.expect(False, '%s %s while %s: %s' % (*cell, words))
    return text


def heading(results, seed, seconds):
    """The sentence above the table: when, on what, how much of it."""
    whole = len(VICTIMS) * len(FAULTS) * len(PHASES)
    failed = sum(text.startswith('FAILED') for text in results.values())
    return ('Run on %s on %d cores with seed %d: %d of %d cells in %.0f minutes, %d failed.' % (
        datetime.date.today().isoformat(), os.cpu_count(), seed, len(results), whole, seconds / 60.0, failed))


def write_docs(results, seed, seconds):
    page = PAGE.read_text(encoding='utf-8')
    PAGE.write_text(table.replaced(page, table.render(results, PHASES, heading(results, seed, seconds))), encoding='utf-8')


def attack(folder, seconds, arguments, outcome):
    system = System(folder, WORLD, arguments.seed, recordings.ARGUMENTS)
    try:
        watch = watch_from_the_start(system, 'attack_faults', outcome)
        if watch is None:
            return
        phases = Phases(watch)
        outcome.expect(phases.wait_for_servers(), 'the actions are not served')
        begin = time.monotonic()
        results = draw_cells(watch, phases, seconds, arguments.seed, outcome)
        stood = [float(text[:-2]) for text in results.values() if text.endswith(' s') and text[0].isdigit()]
        outcome.figure('%d cells of the matrix; where the base had to stand, it did after %s' % (
            len(results), 'at most %.2f s (%d cells)' % (max(stood), len(stood)) if stood else 'nothing that was drawn'))
        if arguments.write_docs:
            write_docs(results, arguments.seed, time.monotonic() - begin)
        system.end_launch()
        recordings.judge(folder, outcome)
    finally:
        system.end()
