"""Whether the nodes live while they are attacked, and how much memory they take."""
import threading
import time

from run_attack.system import NODES, pids, resident_memory


class Lives:
    """The processes of the nodes and their memory, looked at all the time; the first deaths are told to `on_death`."""

    def __init__(self, on_death, nodes=NODES):
        self.before = pids(nodes)
        self.dead = {}
        self.most = {node: 0.0 for node in self.before}
        self._first = {node: resident_memory(pid) or 0.0 for node, pid in self.before.items()}
        self._on_death = on_death
        self._ending = threading.Event()
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self):
        while not self._ending.wait(0.2):
            for node, pid in self.before.items():
                memory = resident_memory(pid)
                if memory is not None:
                    self.most[node] = max(self.most[node], memory)
                elif node not in self.dead:
                    self.dead[node] = time.monotonic()
                    self._on_death(node)

    def end(self):
        self._ending.set()

    def growth(self):
        """By how much the memory of each node has grown at most [MB]."""
        return {node: self.most[node] - self._first[node] for node in self.most}
