#!/usr/bin/env python3
"""The time from the cancel of a patrol or a spin to the first zero of its source and of cmd_vel. For comparison, the
round trip of a message through a bare topic_tools/relay is measured in the same runs: what exceeds it is caused by this
package. Needs the simulator, the arbiter and both action servers."""
import os
import statistics
import subprocess
import sys
import time

import actionlib
import roslib.packages
import rospy
from geometry_msgs.msg import Twist
from std_srvs.srv import Empty

from frontier_pilot.msg import PatrolAction, PatrolGoal, SpinAction, SpinGoal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'scripts'))
from command_line import CommandLine  # noqa: E402


class Watch:
    """When a topic last turned from motion to zero."""

    def __init__(self, topic):
        self.moving, self.stopped, self.heard = False, None, False
        rospy.Subscriber(topic, Twist, self.take, queue_size=100, tcp_nodelay=True)

    def take(self, msg):
        zero = msg.linear.x == 0.0 and msg.angular.z == 0.0
        if zero and self.moving:
            self.stopped = time.monotonic()
        self.moving, self.heard = not zero, True


def until(condition):
    while not condition() and not rospy.is_shutdown():
        time.sleep(0.0005)


class Relay:
    """A node that does nothing but forward messages."""

    def __init__(self):
        program = roslib.packages.find_node('topic_tools', 'relay')[0]
        self.process = subprocess.Popen([program, 'relay_in', 'relay_out'])
        self.back = Watch('relay_out')
        self.publisher = rospy.Publisher('relay_in', Twist, queue_size=1, tcp_nodelay=True)
        # A relay advertises its output only after it has received its first message.
        until(lambda: self.publisher.publish(Twist()) or self.back.heard)

    def send(self, speed):
        """Sends a speed and returns the time until it comes back [ms]."""
        msg = Twist()
        msg.linear.x = speed
        asked = time.monotonic()
        self.publisher.publish(msg)
        until(lambda: self.back.moving == (speed != 0.0))
        return (time.monotonic() - asked) * 1e3


def tell(name, topic, seen):
    print('%-7s cancel to zero on %-16s median %.1f ms, 90 %% %.1f ms, worst %.1f ms of %d' %
          (name, topic, statistics.median(seen), sorted(seen)[int(0.9 * len(seen))], max(seen), len(seen)), flush=True)


def measure(name, client, goal, source, runs, relay):
    watches = [Watch(source), Watch('cmd_vel')]
    client.wait_for_server()
    rospy.wait_for_service('reset_positions')
    times = [[], [], []]
    for run in range(runs):
        rospy.ServiceProxy('reset_positions', Empty)()
        time.sleep(0.3)
        client.send_goal(goal)
        until(lambda: all(watch.moving for watch in watches))
        time.sleep(0.05 + 0.037 * (run % 20))
        asked = time.monotonic()
        client.cancel_goal()
        until(lambda: not any(watch.moving for watch in watches))
        for seen, watch in zip(times, watches):
            seen.append((watch.stopped - asked) * 1e3)
        client.wait_for_result()
        times[2].append(relay.send(float((run + 1) % 2)))
    for topic, seen in zip((source, 'cmd_vel', '(bare relay)'), times):
        tell(name, topic, seen)


if __name__ == '__main__':
    parser = CommandLine(__doc__, 'bench/cancel_latency.py 20')
    parser.add_argument('runs', nargs='?', type=int, default=50)
    count = parser.parse_args(rospy.myargv()[1:]).runs
    rospy.init_node('cancel_latency')
    patrol = PatrolGoal()
    patrol.goal.x, patrol.goal.y, patrol.goal.z = 1, 1.0, 1
    bare = Relay()
    try:
        measure('patrol', actionlib.SimpleActionClient('turtlebot3', PatrolAction), patrol, 'cmd_vel_patrol', count, bare)
        measure('spin', actionlib.SimpleActionClient('spin', SpinAction), SpinGoal(target_yaw=6.0), 'cmd_vel_behavior',
                count, bare)
    finally:
        bare.process.terminate()
