#!/usr/bin/env python3
"""How long a velocity command takes through the arbiter, compared to a bare topic_tools/relay in the same run.

It needs a roscore that nothing else uses, and starts the nodes that it measures.

The probe (arbiter_latency_probe) is C++, with TCP_NODELAY on both sides; it sends a command and stamps its return.
"""
import os
import signal
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'scripts'))
from command_line import CommandLine  # noqa: E402


def start(*command):
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, preexec_fn=os.setsid)


def main():
    parser = CommandLine(__doc__, 'bench/arbiter_latency.py build/bin/arbiter_latency_probe')
    parser.add_argument('probe', help='the built arbiter_latency_probe')
    parser.add_argument('--seconds', type=float, default=10.0, help='of each rate')
    parser.add_argument('--stops', type=int, default=1000, help='emergency stops under load')
    arguments = parser.parse_args()
    nodes = [start('rosrun', 'topic_tools', 'relay', 'relay_in', 'relay_out', '__name:=bare_relay'),
             start('rosrun', 'frontier_pilot', 'cmd_vel_arbiter', '_clear_quiet_time:=0.02')]
    try:
        return subprocess.call([arguments.probe, '--seconds', str(arguments.seconds), '--stops', str(arguments.stops)])
    finally:
        for node in nodes:
            os.killpg(node.pid, signal.SIGINT)
            node.wait()


if __name__ == '__main__':
    sys.exit(main())
