"""A process in which eight threads stop and clear at once, and one switches sources on and off.

Usage: python3 -m run_attack.stop_callers SEED START SECONDS OUT

Writes of each stop that was answered, and of each clear that succeeded or may have, when it was called and answered.
"""
import json
import random
import sys
import threading
import time

import rospy
from std_srvs.srv import SetBool, Trigger

from leftovers import end_with_the_parent
from run_attack.system import join
from run_attack.timetable import Timetable
from run_attack.velocity_sources import SOURCES

THREADS = 8
UNCHANGED = 'not stopped'  # the answer to a clear that has changed nothing
UNSENT = 'may not have been sent yet'  # the answer to a stop on an overloaded machine, whose zero is still to be written


class Caller:
    """Calls stops and clears, and logs them as [stop, begin, answer] with times of the steady clock [s].

    `space` is the robot's namespace, with the slash behind it.
    """

    def __init__(self, persistent, space=''):
        self.log = []
        self._space = space
        self.refused = self.unanswered = self.unsent = 0
        self._persistent = persistent
        self._connect()

    def _connect(self):
        self._stop = rospy.ServiceProxy(self._space + 'emergency_stop', Trigger, self._persistent)
        self._set = rospy.ServiceProxy(self._space + 'set_emergency_stop', SetBool, self._persistent)

    def stop(self, by_setting=False):
        begin = time.monotonic()
        try:
            answer = self._set(True) if by_setting else self._stop()
        except (rospy.ServiceException, OSError):
            self._lost()
            return False
        if answer.success and UNSENT in answer.message:
            self.unsent += 1
        elif answer.success:
            self.log.append((True, begin, time.monotonic()))
        return answer.success

    def clear(self):
        begin = time.monotonic()
        try:
            answer = self._set(False)
        except (rospy.ServiceException, OSError):
            self.log.append((False, begin, time.monotonic()))  # it may have been served
            self._lost()
            return False
        if not answer.success:
            self.refused += 1
        elif UNCHANGED not in answer.message:
            self.log.append((False, begin, time.monotonic()))
        return answer.success

    def _lost(self):
        self.unanswered += 1
        time.sleep(0.05)
        self._connect()


def stop_and_clear(caller, timetable, draw, end):
    while time.monotonic() < end:
        if timetable.stops_are_called(time.monotonic()) and draw.random() < 0.5:
            caller.stop(draw.random() < 0.5)
        else:
            caller.clear()
        time.sleep(draw.choice((0.0, 0.002, 0.02)))


def switch_sources(draw, end):
    while time.monotonic() < end:
        name = draw.choice(SOURCES)
        for on in (False, True):
            try:
                rospy.ServiceProxy('set_%s_enabled' % name, SetBool)(on)
            except (rospy.ServiceException, OSError):
                pass
            time.sleep(draw.uniform(0.0, 0.1))


def main(seed, start, seconds, out):
    end_with_the_parent()
    join('attack_callers')
    begin, end = float(start), float(start) + float(seconds)
    timetable = Timetable(int(seed), begin)
    callers = [Caller(persistent=number % 2 == 0) for number in range(THREADS)]
    threads = [threading.Thread(target=stop_and_clear, args=(caller, timetable, random.Random(int(seed) + number), end))
               for number, caller in enumerate(callers)]
    threads.append(threading.Thread(target=switch_sources, args=(random.Random(int(seed) - 1), end)))
    time.sleep(max(0.0, begin - time.monotonic()))
    for thread in threads:
        thread.daemon = True
        thread.start()
    for thread in threads:
        thread.join(max(0.0, end + 10.0 - time.monotonic()))
    with open(out, 'w') as file:
        json.dump({'calls': [call for caller in callers for call in caller.log],
                   'refused': sum(caller.refused for caller in callers),
                   'unsent': sum(caller.unsent for caller in callers),
                   'unanswered': sum(caller.unanswered for caller in callers),
                   'hanging': sum(thread.is_alive() for thread in threads)}, file)


if __name__ == '__main__':
    main(*sys.argv[1:])
