"""What the wire tests of arbiter and avoider share: a condition to wait on instead of sleeping, and nodes to kill."""
import atexit
import functools
import math
import os
import pathlib
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import xmlrpc.client

import rosgraph
import roslib.packages
import rospy
from geometry_msgs.msg import Twist
from std_srvs.srv import SetBool, Trigger

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / 'scripts'))
from run_attack.processes import free_port  # noqa: E402, F401: for the tests

_changed = threading.Condition()


def wait_for(condition, timeout=10.0):
    """Until `condition()` is true, looked at whenever something arrives; gives whether it became true. What arrives meanwhile does not
    wait for a condition that takes long, such as the answer of a service: its time would be that of the answer."""
    end = time.monotonic() + timeout
    while not condition():
        left = end - time.monotonic()
        if left <= 0.0:
            return False
        with _changed:
            _changed.wait(min(left, 0.02))
    return True


def time_until(condition, timeout=10.0):
    """How long it takes until `condition()` is true [s]; infinite if longer than `timeout`."""
    start = time.monotonic()
    return time.monotonic() - start if wait_for(condition, timeout) else math.inf


class Record:
    """Every message of a topic with the steady time of its arrival."""

    def __init__(self, topic, kind):
        self.items = []
        self.subscriber = rospy.Subscriber(topic, kind, self._take, queue_size=1000, tcp_nodelay=True)

    def _take(self, message):
        with _changed:
            self.items.append((time.monotonic(), message))
            _changed.notify_all()

    @property
    def last(self):
        return self.items[-1][1] if self.items else None

    def since(self, start):
        return [message for at, message in list(self.items) if at >= start]


def twist(linear=0.0, angular=0.0):
    message = Twist()
    message.linear.x = linear
    message.angular.z = angular
    return message


def moves(message):
    return message.linear.x != 0.0 or message.angular.z != 0.0


class Source:
    """A velocity source that can send once, or steadily on a thread of its own."""

    def __init__(self, topic, rate=20.0):
        self.publisher = rospy.Publisher(topic, Twist, queue_size=10, tcp_nodelay=True)
        self._period = 1.0 / rate
        self._stop = threading.Event()
        self._thread = None

    def connect(self):
        assert wait_for(lambda: self.publisher.get_num_connections() > 0), self.publisher.name
        return self

    def send(self, linear=0.0, angular=0.0):
        self.publisher.publish(twist(linear, angular))

    def start(self, linear=0.0, angular=0.0):
        self.stop()
        self._stop.clear()
        self._thread = threading.Thread(target=self._run, args=(linear, angular), daemon=True)
        self._thread.start()
        return self

    def _run(self, linear, angular):
        while not self._stop.wait(self._period):
            self.send(linear, angular)

    def stop(self):
        self._stop.set()
        if self._thread is not None:
            self._thread.join()
            self._thread = None

    def close(self):
        self.stop()
        self.publisher.unregister()


@functools.lru_cache()
def find_node(package, executable):
    return roslib.packages.find_node(package, executable)[0]


def use_a_home_of_its_own():
    """What the nodes that this process starts remember is not mixed with that of another test, which may run beside this one."""
    home = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, home, ignore_errors=True)
    os.environ['ROS_HOME'] = os.environ['XDG_RUNTIME_DIR'] = home


class Node:
    """A node of the package in a process of its own."""

    def __init__(self, executable, *arguments, package='frontier_pilot', environment=None, starter=()):
        self.process = subprocess.Popen([*starter, find_node(package, executable), *arguments],
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                                        preexec_fn=os.setsid, env=environment)
        self._said = ''

    def said(self):
        """All that was said so far. Not together with `finish`."""
        pipe = self.process.stdout.fileno()
        while select.select([pipe], [], [], 0.0)[0]:
            part = os.read(pipe, 65536)
            if not part:
                break
            self._said += part.decode(errors='replace')
        return self._said

    def signal(self, number):
        os.killpg(self.process.pid, number)

    def has_ended(self):
        return self.process.poll() is not None

    def finish(self, timeout=10.0):
        """Gives the exit code and all that was said."""
        said, _ = self.process.communicate(timeout=timeout)
        return self.process.returncode, said

    def end(self):
        """By SIGINT, so that it says goodbye to the master; nothing where it has been finished."""
        if self.process.stdout.closed:
            return
        if not self.has_ended():
            self.signal(signal.SIGINT)
        self.process.communicate()


class Stranger:
    """A node of another program, in a process of its own, which ends with `test` at the latest. `does` are lines of Python."""

    def __init__(self, test, name, does='', environment=None):
        program = "import rospy\nrospy.init_node('%s')\n%s\nrospy.spin()" % (name, does)
        self.process = subprocess.Popen([sys.executable, '-c', program], env=environment)
        test.addCleanup(self.end)

    def end(self):
        self.process.terminate()
        self.process.wait()


def pid_of(node):
    master = rosgraph.Master('/test')
    return xmlrpc.client.ServerProxy(master.lookupNode(node)).getPid('/test')[2]


def hears(node, topic):
    """Whether a publisher of `topic` is connected to `node`."""
    connections = xmlrpc.client.ServerProxy(rosgraph.Master('/test').lookupNode(node)).getBusInfo('/test')[2]
    return any(way == 'i' and name == topic for _, _, way, _, name, *_ in connections)


SANITIZED = 'ASAN_OPTIONS' in os.environ  # by scripts/sanitize: a node then needs memory and files that are not its own


def memory_of(pid):
    """What it holds now, and what it has held at most [MB]."""
    with open('/proc/%d/status' % pid) as file:
        sizes = dict(line.split(':', 1) for line in file if line.startswith('Vm'))
    return tuple(int(sizes[key].split()[0]) / 1024.0 for key in ('VmRSS', 'VmHWM'))


def assert_memory_below(test, amount, most, words):
    """Not under a sanitizer."""
    if not SANITIZED:
        test.assertLess(amount, most, words)


def call(service, kind, *arguments):
    rospy.wait_for_service(service, 15.0)
    return rospy.ServiceProxy(service, kind)(*arguments)


def enable(source, on):
    return call('set_%s_enabled' % source, SetBool, on)


def emergency_stop():
    return call('emergency_stop', Trigger)


def set_emergency_stop(on):
    return call('set_emergency_stop', SetBool, on)


def replace_the_arbiter():
    """Kills the arbiter, and stops the robot as soon as there is another one; gives the answer, or None if there was none."""
    pid = pid_of('/cmd_vel_arbiter')
    os.kill(pid, signal.SIGKILL)
    answers = []

    def is_answered_by_another():
        try:
            if pid_of('/cmd_vel_arbiter') != pid:
                answers.append(rospy.ServiceProxy('emergency_stop', Trigger)())
        except (OSError, rosgraph.MasterException, rospy.ServiceException):
            pass
        return bool(answers)
    return answers[0] if wait_for(is_answered_by_another, 30.0) else None


def clear():
    """Clears the stop as soon as the sources are quiet."""
    return wait_for(lambda: set_emergency_stop(False).success, 5.0)
