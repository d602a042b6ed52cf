"""A process that is all five sources of velocity commands at once, at a high rate, by a timetable.

Usage: python3 -m run_attack.velocity_sources SEED START SECONDS RATE OUT
"""
import json
import struct
import sys
import time

import rospy
from geometry_msgs.msg import Twist

from leftovers import end_with_the_parent
from run_attack.system import join
from run_attack.timetable import Timetable

SOURCES = ('avoid', 'behavior', 'patrol', 'nav', 'manual')


class Written(Twist):
    """A command that was serialised beforehand."""

    def __init__(self, linear, angular):
        super().__init__()
        self.linear.x, self.angular.z = linear, angular
        self.bytes = struct.pack('<6d', linear, 0.0, 0.0, 0.0, 0.0, angular)

    def serialize(self, buff):
        buff.write(self.bytes)


def send_all(timetable, publishers, commands, begin, end, period):
    """Lets the sources that drive send once in each period. Gives how many commands were sent, and the time in which a
    source drove, the sum of all of them [s]."""
    sent, driven, due, looked_at = 0, 0.0, begin, begin - 1.0
    while due < end and not rospy.is_shutdown():
        if due - looked_at > 0.02:
            driving, looked_at = [number for number in range(len(publishers)) if timetable.source_drives(number, due)], due
        for number in driving:
            publishers[number].publish(commands[number])
        sent += len(driving)
        now = time.monotonic()
        # A delay is caught up with, so that the rate is that which was asked for, but not a long one.
        following = max(due + period, now - 0.05)
        driven += len(driving) * (following - due)
        due = following
        time.sleep(max(0.0, due - now))
    return sent, driven


def main(seed, start, seconds, rate, out):
    end_with_the_parent()
    join('attack_sources')
    publishers = [rospy.Publisher('cmd_vel_' + name, Twist, queue_size=None, tcp_nodelay=True) for name in SOURCES]
    # They turn more than they go, so that the robot stays about where it is.
    commands = [Written(0.02 * (number + 1), 2.0) for number in range(len(SOURCES))]
    begin = float(start)
    time.sleep(max(0.0, begin - time.monotonic()))
    sent, driven = send_all(Timetable(int(seed), begin), publishers, commands, begin, begin + float(seconds), 1.0 / float(rate))
    with open(out, 'w') as file:
        json.dump({'sent': sent, 'driven': driven}, file)


if __name__ == '__main__':
    import warnings
    warnings.filterwarnings('ignore')
    main(*sys.argv[1:])
