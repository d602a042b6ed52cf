"""The system that is attacked: a launch file of the project on a master of its own."""
import logging
import os
import resource
import signal
import subprocess
import sys
import time
import xmlrpc.client

import rosgraph
import rospy

import leftovers
import ros_program
from run_attack import environment, processes

CALLER = '/attack'
LOG_SIZE = '20000000'  # [bytes] of the output of all nodes
STARTED = 60.0  # [s] within which all nodes have to serve
NODES = ('simulator', 'mapper', 'navigator', 'waypoint_follower', 'cmd_vel_arbiter', 'behavior_server', 'frontier_explorer',
         'obstacle_avoider', 'patrol_server')


class System:
    """A master and the launch, which work in `folder`. `begin` waits until every node serves; `end` ends both.

    `nodes` are those of the launch file that have to serve. The environment of this process is changed so that it belongs to
    the same ROS graph.
    """

    def __init__(self, folder, world, seed, launch_arguments=(), file='system.launch', nodes=NODES):
        self.folder, self.nodes = folder, nodes
        self.words = [file, 'world:=' + world, 'seed:=%d' % (seed % 1000000), 'gui:=false', 'rviz:=false', *launch_arguments]
        self.master = self.launch = None
        self._port = processes.free_port()
        os.environ.update(HOME=folder, ROS_HOME=os.path.join(folder, 'ros'),
                          ROS_MASTER_URI='http://127.0.0.1:%d' % self._port)
        os.environ[processes.MARK] = folder
        os.environ.pop('ROS_LOG_DIR', None)
        os.makedirs(os.environ['ROS_HOME'], exist_ok=True)

    def begin(self):
        """Starts everything; gives whether all nodes serve within `STARTED`."""
        self.start_master()
        self.start_launch()
        return wait_until(self.is_up, STARTED)

    def start_master(self):
        self.master = processes.start(['rosmaster', '--core', '-p', str(self._port)], self.path('master.log'))
        if not wait_until(lambda: ros_program.is_master_online(CALLER), 20.0):
            raise OSError('no master at port %d' % self._port)

    def start_launch(self):
        reading, writing = os.pipe()
        bounded = str(environment.ROOT / 'scripts' / 'bounded_log.py')
        subprocess.Popen([sys.executable, bounded, self.path('log'), LOG_SIZE], stdin=reading, start_new_session=True)
        os.close(reading)
        self.launch = subprocess.Popen(['roslaunch', 'frontier_pilot', *self.words], stdin=subprocess.DEVNULL,
                                       stdout=writing, stderr=subprocess.STDOUT, start_new_session=True,
                                       preexec_fn=prepare_launch)
        os.close(writing)

    def kill_master(self):
        self.master.kill()
        self.master.wait()

    def end_launch(self):
        if self.launch is not None:
            processes.end(self.launch)
            self.launch = None

    def end(self):
        """Ends the launch, the master, and whatever of them is left."""
        self.end_launch()
        if self.master is not None:
            processes.end(self.master, signal.SIGTERM, 5.0)
        leftovers.end(processes.MARK, self.folder)

    def is_up(self):
        return self.launch.poll() is None and all(pid_of(node) is not None for node in self.nodes)

    def path(self, name):
        return os.path.join(self.folder, name)


def prepare_launch():
    """In the process of the launch: it ends with this one, and no node that is aborted writes its memory to the disk."""
    leftovers.end_with_the_parent()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def join(name):
    """Makes this process a node, which says nothing: it is no news that connections end under an attack."""
    logging.raiseExceptions = False
    rospy.init_node(name, disable_signals=True, log_level=rospy.FATAL)
    for logger in ('rosout', 'rospy', 'rospy.internal'):
        logging.getLogger(logger).setLevel(logging.CRITICAL)


def pid_of(node):
    """The process of a running node as it says itself; None if it does not answer."""
    try:
        address = rosgraph.Master(CALLER).lookupNode('/' + node)
        with xmlrpc.client.ServerProxy(address) as proxy:
            return proxy.getPid(CALLER)[2]
    except (OSError, rosgraph.MasterException, xmlrpc.client.Error):
        return None


def pids(nodes=NODES):
    """The process of each node."""
    return {node: pid_of(node) for node in nodes}


def provider(service):
    """The node that offers a service, as the master knows it; None if there is none or the master does not answer."""
    try:
        offered = dict(rosgraph.Master(CALLER).getSystemState()[2])
    except (OSError, rosgraph.MasterException):
        return None
    return offered.get(service, [None])[0]


def resident_memory(pid):
    """What a process holds [MB]; None if it has ended, or if there is none."""
    if pid is None:
        return None
    try:
        with open('/proc/%d/status' % pid) as status:
            return next(int(line.split()[1]) / 1024.0 for line in status if line.startswith('VmRSS'))
    except (OSError, StopIteration):
        return None


def wait_until(condition, seconds):
    """Whether `condition()` came true within `seconds` of wall time."""
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.02)
    return True
