"""Runs the parts of the attack one after the other, each in a process of its own, and says what did not hold."""
import importlib
import multiprocessing
import os
import shutil
import signal
import sys
import tempfile
import traceback

import leftovers
from run_attack import processes
from run_attack.outcome import Outcome

SHARES = {'stops': 0.25, 'fuzz': 0.4, 'faults': 0.35, 'fleet': 0.3, 'soak': 1.0}  # of the time, in relation to each other


def seconds_of(part, parts, minutes):
    """How long a part attacks [s]: its share of the time of the parts that run."""
    return 60.0 * minutes * SHARES[part] / sum(SHARES[each] for each in parts)


def run_part(part, folder, seconds, arguments, answers):
    """In the process of the part: runs it, and sends what came of it."""
    leftovers.end_with_the_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that started this one decides
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(143))
    outcome = Outcome(part, lambda words: print(words, flush=True))
    try:
        importlib.import_module('run_attack.' + part).attack(folder, seconds, arguments, outcome)
    except Exception as error:  # a part that breaks off has not shown anything
        outcome.expect(False, 'broken off: %s: %s' % (type(error).__name__, error))
        with open(os.path.join(folder, 'traceback'), 'w') as file:
            traceback.print_exc(file=file)
    answers.send((outcome.figures, outcome.failures))


def outcome_of(part, folder, seconds, arguments):
    """What did not hold in a part, one sentence each."""
    receiving, sending = multiprocessing.Pipe(False)
    process = multiprocessing.get_context('fork').Process(target=run_part, args=(part, folder, seconds, arguments, sending))
    process.start()
    sending.close()
    try:
        return receiving.recv()[1]
    except EOFError:
        return ['the attack itself has ended without a word']
    finally:
        process.terminate()
        process.join(40.0)
        leftovers.end(processes.MARK, folder)


def interrupt(number, _):
    raise KeyboardInterrupt(number)


def run(arguments):
    """Gives the exit code."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):  # SIGINT is ignored at first in a shell's background
        signal.signal(number, interrupt)
    folder = tempfile.mkdtemp(prefix='frontier_pilot_attack.')
    failures = []
    try:
        parts = ['fuzz'] if arguments.replay else list(arguments.only)
        for part in parts:
            inner = os.path.join(folder, part)
            os.mkdir(inner)
            said = outcome_of(part, inner, seconds_of(part, parts, arguments.minutes), arguments)
            failures += ['%s: %s' % (part, words) for words in said]
    except KeyboardInterrupt as interruption:
        return 128 + interruption.args[0]
    finally:
        keep = arguments.keep or failures
        if keep:
            print('The logs are in %s' % folder)
        else:
            shutil.rmtree(folder, ignore_errors=True)
    print('attack: seed %d, %.1f minutes: %s' % (arguments.seed, arguments.minutes,
                                                 'everything held' if not failures else '%d did not hold' % len(failures)))
    for words in failures:
        print(words)
    return 1 if failures else 0
