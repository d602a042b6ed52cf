"""CPU time and memory of the nodes over the run."""


class Load:
    """The samples of each node: (time [s], CPU time per real time, memory [bytes])."""

    def __init__(self):
        self.nodes = {}
        self.wall = []  # real time of the messages [s since the epoch]

    def take(self, time, message):
        self.wall.append(message.wall_time)
        for process in message.processes:
            self.nodes.setdefault(process.node, []).append((time, process.cpu, process.memory))

    def rows(self):
        """(node, mean CPU, greatest CPU, greatest memory [bytes]), the busiest node first."""
        rows = []
        for node, samples in self.nodes.items():
            cpu = [sample[1] for sample in samples]
            rows.append((node, sum(cpu) / len(cpu), max(cpu), max(sample[2] for sample in samples)))
        return sorted(rows, key=lambda row: -row[1])
