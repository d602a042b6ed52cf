"""CPU time and memory of the nodes over the run."""
import re

MOST_CORES = 1e4  # that a process can use
STARTED_BY_PEOPLE = ('/patrol_client', '/teleop_gui')  # who end them and start them again as they like


def without_numbers(node):
    """The name of a node without what ROS has put behind that of an anonymous one: the process and the time, or the time alone."""
    return re.sub('(_[0-9]+)?_[0-9]{13,19}$', '', node) or node


def is_time(value):
    """Whether this is a time of our epoch [s] that a calendar has."""
    return 0.0 <= value < 1e11


class Load:
    """The samples of each node: (time [s], CPU time per real time, memory [bytes])."""

    def __init__(self):
        self.nodes = {}
        self.pids = {}
        self._restarts = []  # as `restarts` gives them
        self.wall = []  # (time [s], real time [s since the epoch], number) of the messages

    def take(self, time, message):
        if not is_time(message.wall_time) or not all(0.0 <= process.cpu < MOST_CORES for process in message.processes):
            raise ValueError('they have times that cannot be')
        self.wall.append((time, message.wall_time, message.header.seq))
        for process in message.processes:
            is_another = self.pids.setdefault(process.node, process.pid) != process.pid
            if is_another and not process.node.endswith(STARTED_BY_PEOPLE):
                self._restarts.append((time, process.node))
            self.pids[process.node] = process.pid
            self.nodes.setdefault(process.node, []).append((time, process.cpu, process.memory))

    def was_set_back(self):
        """Whether a later message has an earlier time."""
        numbers = [number for _, _, number in self.wall]
        return numbers != sorted(numbers)

    def restarts(self):
        """(time [s], node) of those that went on as another process, but for programs that people start. None after the clock was set
        back, when the samples of before and after that lie between each other."""
        return [] if self.was_set_back() else self._restarts

    def rows(self):
        """(node, mean CPU, greatest CPU, greatest memory [bytes]), the busiest node first."""
        rows = []
        for node, samples in self.nodes.items():
            cpu = [sample[1] for sample in samples]
            rows.append((node, sum(cpu) / len(cpu), max(cpu), max(sample[2] for sample in samples)))
        return sorted(rows, key=lambda row: -row[1])
