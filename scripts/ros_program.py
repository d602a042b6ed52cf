"""How the Python programs that are ROS nodes begin: with one line, and an exit code, where rospy prints a traceback or waits for a
master for ever."""
import http.client
import logging
import math
import os
import re
import signal
import socket
import sys
import threading
import time
import xml.parsers.expat
import xmlrpc.client

import rosgraph
import rosgraph.roslogging
import rospy
import yaml

from command_line import printable, say

WORD = re.compile(r'(?P<name>[^:]*):=(?P<value>.*)', re.DOTALL)
POLL = 0.3  # [s]
PATIENCE = 1.0  # for the answer of a node or of the master [s]
GOODBYE = 2.0  # to them [s]
LAST_WORDS = 3.0  # for a node of the same name that is about to end [s]
# Of calls to the master and to nodes. An answer that breaks off is no XML.
FAILURES = (OSError, http.client.HTTPException, rosgraph.MasterException, xmlrpc.client.Error, xml.parsers.expat.ExpatError)


class PatientTransport(xmlrpc.client.Transport):
    """Waits no longer than PATIENCE, for a node may hang."""

    def make_connection(self, host):
        connection = super().make_connection(host)
        connection.timeout = PATIENCE
        return connection


def master(node):
    """The rosgraph.Master of a node of this name. rosgraph's own waits for ever for a master that hangs; with this one a call ends after
    PATIENCE, with one of FAILURES."""
    patient = rosgraph.Master(node)
    patient.handle = xmlrpc.client.ServerProxy(patient.master_uri, transport=PatientTransport())
    return patient


def is_master_online(node):
    """Whether a master answers within PATIENCE. rosgraph's own waits for ever for one that hangs, and swallows a Ctrl-C."""
    try:
        return bool(master(node).getPid())
    except FAILURES:
        return False


def problem_of(word):
    """What is wrong with a word of the command line that is for ROS; empty if nothing is."""
    found = WORD.fullmatch(word)
    if not found:
        return ''
    name, value = found.group('name', 'value')
    if not name.startswith('_'):
        is_name = value.strip('/') and rosgraph.names.is_legal_name(value)
        return '' if is_name else '%s is not a remapping: it says no name of a topic or a service' % word
    if name == '__master':
        return '' if is_address(value) else '%s is not an address like http://host:11311' % word
    if name == '__name':
        return '' if rosgraph.names.is_legal_base_name(value) else '%s is not a name' % word
    if name == '__ns':
        return '' if rosgraph.names.is_legal_name(value) else '%s is not a namespace' % word
    if name.startswith('_') and not name.startswith('__') and value.strip():
        return problem_of_value(word, value)
    return ''


def problem_of_value(word, text):
    """What is wrong with the value of a private parameter, as YAML and on its way to the master."""
    if ':=' in text:
        return '%s holds := twice' % word
    try:
        value = yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError):
        return '%s is not YAML' % word
    try:
        xmlrpc.client.loads(xmlrpc.client.dumps((value,)).encode())
    except Exception:  # what the library throws depends on the value
        return "%s cannot be a parameter; a text in quotes can: _name:='\"text\"'" % word
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
    exit code 2 for words that ROS cannot use, and with 1 if it cannot be a node of that name. That it waits for a master is said
    after `silent_for` seconds."""
    problems = [problem for problem in map(problem_of, sys.argv[1:]) if problem]
    uri = '' if problems else rosgraph.get_master_uri()
    if not problems and not is_address(uri):
        problems = ['ROS_MASTER_URI is not an address like http://host:11311: ' + uri]
    if problems:
        say('%s: %s' % (name, printable(problems[0])), sys.stderr)
        sys.exit(2)
    interrupts = note_interrupts()
    say_at = time.monotonic() + silent_for
    while wanted() and not is_master_online(name):
        if time.monotonic() >= say_at:
            say('%s: no ROS master answers at %s: waiting for one, which roscore or roslaunch starts' % (name, uri), sys.stderr)
            say_at = math.inf
        time.sleep(POLL)
    if wanted():
        logging.getLogger('rosout').addFilter(is_news)
        if not options.get('anonymous'):
            refuse_a_namesake(name)
        init_node(name, options, interrupts)
    return wanted()


def note_interrupts():
    """A list to which every Ctrl-C from now on is added, beside being a KeyboardInterrupt as before: rospy swallows some of these
    while it makes a node."""
    noted = []

    def note(number, _frame):
        noted.append(number)
        raise KeyboardInterrupt

    if signal.getsignal(signal.SIGINT) == signal.default_int_handler:  # it is ignored in the background of a script
        signal.signal(signal.SIGINT, note)
    return noted


def refuse_a_namesake(name):
    """Ends the program with a line and exit code 1 while a node of its name lives at the master: ROS would shut that down."""
    own = rosgraph.names.ns_join(rosgraph.names.get_ros_namespace(), rosgraph.names.load_mappings(sys.argv).get('__name', name))
    end = time.monotonic() + LAST_WORDS
    alive = lives(own)
    while alive is not False:
        if time.monotonic() >= end:
            if alive is None:
                return
            say('%s: a node %s is already running, and ROS would shut it down for this one: end it first (rosnode kill %s), or give '
                'this one another name (__name:=...)' % (name, own, own), sys.stderr)
            sys.exit(1)
        time.sleep(POLL)
        alive = lives(own)


def lives(node):
    """Whether a node is registered at the master, and answers or at least holds its port; None if the master does not say in time."""
    try:
        uri = master(node).lookupNode(node)
    except socket.timeout:
        return None
    except FAILURES:
        return False
    try:
        return xmlrpc.client.ServerProxy(uri, transport=PatientTransport()).getPid(node)[0] == 1
    except socket.timeout:
        return True
    except FAILURES:
        return False


def init_node(name, options, interrupts):
    """rospy.init_node; if the master ends in this moment, or refuses the node, a line and exit code 1; 130 after a Ctrl-C."""
    problem = ''
    try:
        rospy.init_node(name, **options)
    except Exception as error:  # of sockets, of XML-RPC or of rospy
        problem = str(error) or type(error).__name__
    log_to_terminal()
    if interrupts:
        sys.exit(130)
    if problem:
        say('%s: cannot be a node of the ROS master: %s' % (name, printable(problem)), sys.stderr)
        sys.exit(1)


def log_to_terminal():
    """Shows the lines of the log on the terminal also where rospy cannot make a folder for log files: it sets up no logging then."""
    logger = logging.getLogger('rosout')
    if all(isinstance(handler, rospy.impl.rosout.RosOutHandler) for handler in logger.handlers + logging.getLogger().handlers):
        logger.addHandler(rosgraph.roslogging.RosStreamHandler())
        logger.setLevel(logging.INFO)


def publish(publisher, message):
    """Publishes the message, unless the node is shut down meanwhile: its topics are closed before rospy.is_shutdown says so."""
    try:
        publisher.publish(message)
    except rospy.ROSException:
        if not rospy.core.is_shutdown_requested():
            raise


def leave(code):
    """Shuts rospy down, and returns the exit code of the program. rospy waits for a master that hangs for ever, and Python for the
    threads of rospy: then the process ends here."""
    goodbye = threading.Thread(target=rospy.signal_shutdown, args=('ended',), daemon=True)
    goodbye.start()
    goodbye.join(GOODBYE)
    if goodbye.is_alive():
        os._exit(code)
    return code
