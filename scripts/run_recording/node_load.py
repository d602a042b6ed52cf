"""CPU time and memory of the nodes that run on this computer, from the master, the nodes and /proc."""
import os
import time
import urllib.parse
import xmlrpc.client

import rosgraph

from ros_program import FAILURES, PatientTransport, master

TICKS = os.sysconf('SC_CLK_TCK')
PAGE = os.sysconf('SC_PAGE_SIZE')


def pid_behind(uri):
    """The process that serves this XML-RPC address on this computer; None if it does not answer, or runs elsewhere."""
    host = urllib.parse.urlparse(uri).hostname
    try:
        if host is None or not rosgraph.network.is_local_address(host):
            return None
        code, _, pid = xmlrpc.client.ServerProxy(uri, transport=PatientTransport()).getPid('/run_recorder')
        return pid if code == 1 else None
    except (*FAILURES, ValueError, TypeError):
        return None


def used_by(pid):
    """CPU time since the start of the process [s], and resident memory [bytes]; None if it has ended."""
    try:
        with open('/proc/%d/stat' % pid, 'rb') as file:
            fields = file.read().rpartition(b')')[2].split()  # the second field, the name, may contain anything
        with open('/proc/%d/statm' % pid, 'rb') as file:
            pages = int(file.read().split()[1])
        return (int(fields[11]) + int(fields[12])) / TICKS, pages * PAGE
    except (OSError, ValueError, IndexError):
        return None


class Nodes:
    """The processes of the nodes, asked for again from time to time, because nodes come and go."""

    def __init__(self, name, period=10.0):
        self.master = master(name)
        self.period = period  # [s]
        self.asked = None
        self.uris, self.pids = {}, {}

    def processes(self):
        """The process of each node, by its name."""
        now = time.monotonic()
        if self.asked is None or now - self.asked > self.period:
            self.asked = now
            self.look()
        return self.pids

    def look(self):
        try:
            names = {name for kind in self.master.getSystemState() for _, nodes in kind for name in nodes}
            uris = {name: self.master.lookupNode(name) for name in names}
            uris['master'] = self.uris.get('master') or self.master.getUri()
        except FAILURES:
            return  # a master that is gone for a while changes nothing
        known = {name: pid for name, pid in self.pids.items() if self.uris.get(name) == uris.get(name) and used_by(pid)}
        self.pids = {name: known.get(name) or pid_behind(uri) for name, uri in uris.items()}
        self.pids = {name: pid for name, pid in self.pids.items() if pid}
        self.uris = uris


class LoadMeter:
    """Measures what processes use between two calls."""

    def __init__(self, clock=time.monotonic, used=used_by):
        self.clock, self.used = clock, used
        self.last = {}  # by process: when, and the CPU time until then

    def measure(self, processes):
        """For each name whose process was there at the call before: (name, process, CPU time per real time, memory)."""
        now, measured, seen = self.clock(), [], {}
        for name, pid in sorted(processes.items()):
            use = self.used(pid)
            if use is None:
                continue
            seen[pid] = (now, use[0])
            before = self.last.get(pid)
            if before and now > before[0] and use[0] >= before[1]:
                measured.append((name, pid, (use[0] - before[1]) / (now - before[0]), use[1]))
        self.last = seen
        return measured
