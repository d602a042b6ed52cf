"""How the Python programs that are ROS nodes begin: with one line, and an exit code, where rospy prints a traceback or waits for a
master for ever."""
import logging
import math
import re
import sys
import time

import rosgraph
import rospy
import yaml

from command_line import say

WORD = re.compile(r'(?P<name>[^:]*):=(?P<value>.*)', re.DOTALL)
POLL = 0.3  # [s]


def problem_of(word):
    """What is wrong with a word of the command line that is for ROS; empty if nothing is."""
    found = WORD.fullmatch(word)
    if not found:
        return ''
    name, value = found.group('name', 'value')
    if name == '__master':
        return '' if is_address(value) else '%s is not an address like http://host:11311' % word
    if name == '__name':
        return '' if rosgraph.names.is_legal_base_name(value) else '%s is not a name' % word
    if name == '__ns':
        return '' if rosgraph.names.is_legal_name(value) else '%s is not a namespace' % word
    if name.startswith('_') and not name.startswith('__'):
        try:
            yaml.safe_load(value)
        except (yaml.YAMLError, ValueError):
            return '%s is not YAML' % word
    return ''


def is_address(uri):
    """Whether the address of a master could be one."""
    try:
        rosgraph.network.parse_http_host_and_port(uri)
    except ValueError:
        return False
    return True


def is_news(record):
    """Whether a line of the log is for the user. rospy warns of each connection whose other end dies before it has said what it
    wants, which happens whenever nodes end."""
    return not record.getMessage().startswith('Inbound TCP/IP connection failed')


def begin(name, wanted=lambda: True, silent_for=0.0, **options):
    """rospy.init_node, once there is a master; returns whether it was begun before `wanted()` became false. Ends the program with
    exit code 2 for words that ROS cannot use. That it waits for a master is said after `silent_for` seconds."""
    problems = [problem for problem in map(problem_of, sys.argv[1:]) if problem]
    uri = '' if problems else rosgraph.get_master_uri()
    if not problems and not is_address(uri):
        problems = ['ROS_MASTER_URI is not an address like http://host:11311: ' + uri]
    if problems:
        say('%s: %s' % (name, problems[0]), sys.stderr)
        sys.exit(2)
    say_at = time.monotonic() + silent_for
    while wanted() and not rosgraph.is_master_online():
        if time.monotonic() >= say_at:
            say('%s: no ROS master answers at %s: waiting for one, which roscore or roslaunch starts' % (name, uri), sys.stderr)
            say_at = math.inf
        time.sleep(POLL)
    if wanted():
        logging.getLogger('rosout').addFilter(is_news)
        rospy.init_node(name, **options)
    return wanted()
