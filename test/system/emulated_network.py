"""A second computer on this one: a network namespace, and a link to it that delays and loses packets and can be cut. For root; nothing
of it is visible outside, and all of it ends with the process."""
import collections
import ctypes
import fcntl
import mmap
import os
import random
import select
import signal
import struct
import subprocess
import sys
import threading
import time

CLONE_NEWNET = 0x40000000
TUNSETIFF, IFF_TUN, IFF_NO_PI = 0x400454ca, 0x0001, 0x1000
HERE, THERE = '10.77.0.1', '10.77.0.2'
PR_SET_PDEATHSIG = 1
LARGEST = 65536  # [bytes] a packet


def enter_a_namespace():
    """Gives this process, which must not have other threads yet, a network of its own with nothing but a loopback interface.
    Returns whether that is allowed here."""
    if not os.access('/dev/net/tun', os.R_OK | os.W_OK) or ctypes.CDLL(None, use_errno=True).unshare(CLONE_NEWNET) != 0:
        return False
    configure('ip', 'link', 'set', 'lo', 'up')
    return True


def configure(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, timeout=20)


def open_tunnel(name):
    """A network interface whose packets are read from and written to what this returns."""
    tunnel = os.open('/dev/net/tun', os.O_RDWR | os.O_NONBLOCK | os.O_CLOEXEC)
    fcntl.ioctl(tunnel, TUNSETIFF, struct.pack('16sH22x', name.encode(), IFF_TUN | IFF_NO_PI))
    return tunnel


class Computer:
    """A second network namespace."""

    def __init__(self):
        self.process = subprocess.Popen(['setpriv', '--pdeathsig', 'KILL', 'unshare', '--net', 'sh', '-c', 'ip link set lo up && echo ready && exec sleep infinity'],
                                        stdout=subprocess.PIPE, start_new_session=True)
        self.process.stdout.readline()
        self.enter = ['nsenter', '--target', str(self.process.pid), '--net', '--']

    def open_tunnel(self, name):
        """A namespace is entered by a thread."""
        made = []

        def make():
            with open('/proc/%d/ns/net' % self.process.pid) as namespace:
                if ctypes.CDLL(None, use_errno=True).setns(namespace.fileno(), CLONE_NEWNET) == 0:
                    made.append(open_tunnel(name))
        thread = threading.Thread(target=make)
        thread.start()
        thread.join()
        return made[0]

    def end(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()


class Link:
    """Carries packets between this process's namespace, where it is HERE, and that of a Computer, where it is THERE. It is a process of
    its own, before others in the queue for the CPU: a network does not become slower when its computers are busy. To be made before
    this process has other threads."""

    def __init__(self, computer, delay=0.0, loss=0.0, seed=1):
        """`delay` [s] in each direction; `loss`: the share of packets that are lost."""
        ends = [open_tunnel('wire0'), computer.open_tunnel('wire0')]
        for prefix, own, other in (([], HERE, THERE), (computer.enter, THERE, HERE)):
            configure(*prefix, 'ip', 'addr', 'add', own, 'peer', other, 'dev', 'wire0')
            configure(*prefix, 'ip', 'link', 'set', 'wire0', 'up')
        self.shared = mmap.mmap(-1, 1)  # with that process: whether the link is cut
        self.process = os.fork()
        if self.process == 0:
            ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
            try:
                come_first()
                carry(ends, self.shared, delay, loss, random.Random(seed))
            finally:
                os._exit(1)
        for end in ends:
            os.close(end)

    def set_cut(self, cut):
        self.shared[0] = int(cut)

    def end(self):
        os.kill(self.process, signal.SIGKILL)
        os.waitpid(self.process, 0)


def come_first():
    """Linux divides CPU time between sessions first (sched(7), autogroup)."""
    os.setsid()
    try:
        with open('/proc/self/autogroup', 'w') as priority:
            priority.write('-10')
    except OSError:
        pass


def carry(ends, cut, delay, loss, dice):
    under_way = collections.deque()  # when due, where to, packet: in the order of time, because all take as long
    while True:
        wait = max(0.0, under_way[0][0] - time.monotonic()) if under_way else None
        for end in select.select(ends, [], [], wait)[0]:
            packet = os.read(end, LARGEST)
            if not cut[0] and dice.random() >= loss:
                under_way.append((time.monotonic() + delay, ends[1 - ends.index(end)], packet))
        while under_way and under_way[0][0] <= time.monotonic():
            _, to, packet = under_way.popleft()
            try:
                os.write(to, packet)
            except OSError as error:  # the queue of the interface is full, as it can be in any network
                print('a packet is lost: %s' % error, file=sys.stderr)
