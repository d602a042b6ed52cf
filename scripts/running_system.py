#!/usr/bin/python3
"""Says whether a robot, a simulation or a recording already runs at the ROS master of ROS_MASTER_URI.

scripts/run asks it before it launches: a second simulator would set simulated time for that robot, and the exploration would
start there. Whoever publishes a topic clock, map, odom or scan, in any namespace, is a reason; a roscore, rviz or rqt is none.

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

TELLING = {'clock', 'map', 'odom', 'scan'}  # the last word of a topic
PATIENCE = 4.0  # for the answer of the master [s]
ADVICE = 'end it first%s, or choose another port for this run: export ROS_MASTER_URI=http://127.0.0.1:PORT'


def publishers_at(uri):
    """Topics, and a node that publishes each, as the master at this address lists them; none if there is no master."""
    try:
        listed = xmlrpc.client.ServerProxy(uri).getSystemState('/running_system')[2][0]
        return [(str(topic), str(nodes[0])) for topic, nodes in listed if nodes]
    except Exception:  # what the library throws depends on what answers there
        return []  # roslaunch starts a master, or says what is wrong with the address


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
    publishers = within(PATIENCE, lambda: publishers_at(uri))
    if publishers is None:
        return 'what listens at %s does not answer as a ROS master within %.0f s: ' % (uri, PATIENCE) + ADVICE % ''
    for topic, node in publishers:
        if topic.split('/')[-1] in TELLING:
            return '%s publishes %s at the ROS master %s, where a robot or a simulation already runs: ' % (
                printable(node, 100), printable(topic, 100), uri) + ADVICE % ' (rosnode cleanup, if it has died)'
    return ''


def main():
    CommandLine(__doc__, 'scripts/running_system.py && roslaunch frontier_pilot system.launch').parse_args()
    problem = problem_at(os.environ.get('ROS_MASTER_URI') or 'http://localhost:11311')
    if problem:
        say(problem)
    return 1 if problem else 0


if __name__ == '__main__':
    exit_with(main)
