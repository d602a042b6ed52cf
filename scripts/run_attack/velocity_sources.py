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


def send_all(timetable, publishers, commands, end, period):
    """Lets the sources that drive send once in each period. Gives how many were sent and the time in which they drove [s]."""
    sent, driving, last = 0, 0.0, time.monotonic()
    drives = [False] * len(publishers)
    looked_at = 0.0
    while last < end and not rospy.is_shutdown():
        if last - looked_at > 0.02:
            drives, looked_at = [timetable.source_drives(number, last) for number in range(len(publishers))], last
        for number, publisher in enumerate(publishers):
            if drives[number]:
                publisher.publish(commands[number])
                sent += 1
        time.sleep(max(0.0, last + period - time.monotonic()))
        now = time.monotonic()
        if timetable.sources_drive(last):
            driving += now - last
        last = now
    return sent, driving


def main(seed, start, seconds, rate, out):
    end_with_the_parent()
    join('attack_sources')
    publishers = [rospy.Publisher('cmd_vel_' + name, Twist, queue_size=None, tcp_nodelay=True) for name in SOURCES]
    # They turn more than they go, so that the robot stays about where it is.
    commands = [Written(0.02 * (number + 1), 2.0) for number in range(len(SOURCES))]
    begin = float(start)
    time.sleep(max(0.0, begin - time.monotonic()))
    sent, driving = send_all(Timetable(int(seed), begin), publishers, commands, begin + float(seconds), 1.0 / float(rate))
    with open(out, 'w') as file:
        json.dump({'sent': sent, 'driving': driving}, file)


if __name__ == '__main__':
    import warnings
    warnings.filterwarnings('ignore')
    main(*sys.argv[1:])
