#!/usr/bin/python3
"""Says whether a robot, a simulation or a recording already runs at the ROS master of ROS_MASTER_URI.

scripts/run asks it before it launches: a second simulator would set simulated time for that robot, and the exploration would
start there. Whoever publishes a topic clock, map, odom or scan, or a laser scan, odometry or a clock under any other name, and
whoever drives by a topic cmd_vel, is a reason, in any namespace; a roscore, rviz, rqt, rostopic or teleop_gui is none.

Exit code: 0 if nothing of this kind runs there, 1 if it does, or if the master does not answer: why, and what to do, is printed;
2 for wrong arguments.
"""
import os
import queue
import threading
import xmlrpc.client

from command_line import CommandLine, end_quietly_until_main, exit_with, printable, say

if __name__ == '__main__':
    end_quietly_until_main()

TELLING = {'clock', 'map', 'odom', 'scan'}  # the last word of a topic that is published
TELLING_TYPES = {'rosgraph_msgs/Clock', 'nav_msgs/Odometry', 'sensor_msgs/LaserScan'}
COMMANDS = 'cmd_vel'  # the last word of a topic that a base listens to
ONLOOKERS = ('rostopic_', 'rqt', 'rviz', 'record_', 'teleop_gui')  # how the last words of nodes begin that only show what they hear
PATIENCE = 4.0  # for the answer of the master [s]
ADVICE = 'end it first%s, or choose another port for this run: export ROS_MASTER_URI=http://127.0.0.1:PORT'


def reason_at(uri):
    """What the master at this address lists that a robot or a simulation has, as (node, what it does, topic); none if there is no
    master."""
    try:
        master = xmlrpc.client.ServerProxy(uri)
        published, subscribed = master.getSystemState('/running_system')[2][:2]
        published = [(str(nodes[0]), 'publishes', str(topic)) for topic, nodes in published if nodes]
        heard = [(str(node), 'listens to', str(topic)) for topic, nodes in subscribed for node in nodes]
    except Exception:  # what the library throws depends on what answers there
        return None  # roslaunch starts a master, or says what is wrong with the address
    told_by_name = [one for one in published if last_word(one[2]) in TELLING] + [
        one for one in heard if last_word(one[2]) == COMMANDS and not last_word(one[0]).startswith(ONLOOKERS)]
    if told_by_name:
        return told_by_name[0]
    types = types_at(master) if published else {}
    return next((one for one in published if types.get(one[2]) in TELLING_TYPES), None)


def types_at(master):
    """The types of the topics; none if the master does not say them."""
    try:
        return {str(topic): str(kind) for topic, kind in master.getTopicTypes('/running_system')[2]}
    except Exception:
        return {}


def last_word(name):
    return name.split('/')[-1]


def within(seconds, work):
    """What `work` returns; None if it takes longer. It may hang wherever it wants, such as in a search for a host's name."""
    answer = queue.Queue()
    threading.Thread(target=lambda: answer.put(work()), daemon=True).start()
    try:
        return answer.get(timeout=seconds)
    except queue.Empty:
        return None


def problem_at(uri):
    """Why nothing must be launched at this master; empty: nothing speaks against it."""
    # In a list: None alone would mean that the master did not answer in time.
    answer = within(PATIENCE, lambda: [reason_at(uri)])
    if answer is None:
        return 'what listens at %s does not answer as a ROS master within %.0f s: ' % (uri, PATIENCE) + ADVICE % ''
    if answer[0] is None:
        return ''
    node, does, topic = answer[0]
    return '%s %s %s at the ROS master %s, where a robot or a simulation already runs: ' % (
        printable(node, 100), does, printable(topic, 100), uri) + ADVICE % ' (rosnode cleanup, if it has died)'


def main():
    CommandLine(__doc__, 'scripts/running_system.py && roslaunch frontier_pilot system.launch').parse_args()
    problem = problem_at(os.environ.get('ROS_MASTER_URI') or 'http://localhost:11311')
    if problem:
        say(problem)
    return 1 if problem else 0


if __name__ == '__main__':
    exit_with(main)
