"""What was WARN or ERROR when: lines of the diagnostics and of the log, those that differ only in numbers as one."""
import re

LEVELS = {0: 'OK', 1: 'WARN', 2: 'ERROR', 3: 'STALE'}
LOG_LEVELS = {4: 'WARN', 8: 'ERROR', 16: 'FATAL'}
COUNT = re.compile('[0-9]{1,9}')  # isdigit() takes more than int() does
SILENCE = 5.0  # [s] without a message of a status after which it no longer counts


class Finding:
    """One kind of line, and the spans (begin, end) during which it was there [s]."""

    def __init__(self, who, level, text):
        self.who, self.level, self.text = who, level, text
        self.spans, self.count = [], 0

    def note(self, time, gap):
        self.count += 1
        if self.spans and 0.0 <= time - self.spans[-1][1] <= gap:
            self.spans[-1] = (self.spans[-1][0], time)
        else:
            self.spans.append((time, time))


def without_numbers(text):
    return re.sub(r'[-+]?\d+(\.\d+)?', '#', text)


class Warnings:
    """Collects findings from diagnostics and the log."""

    def __init__(self):
        self.diagnostics, self.log = {}, {}
        self.namespace = None  # of the robot whose loops are counted; None: that of the first mapper
        self.loops = []  # (time [s], loops closed until then)
        self.closed_before, self.closed = 0, 0  # by mappers that have ended, and by the last one

    def take_diagnostics(self, time, array):
        for status in array.status:
            if status.level in (1, 2, 3):
                self._note(self.diagnostics, status.name, LEVELS[status.level], status.message, time, SILENCE)
            self._count_loops(time, status)

    def take_log(self, time, line):
        if line.level in LOG_LEVELS:
            self._note(self.log, line.name, LOG_LEVELS[line.level], line.msg, time, 0.0)

    @staticmethod
    def _note(findings, who, level, text, time, gap):
        key = who, level, without_numbers(text)
        findings.setdefault(key, Finding(who, level, text)).note(time, gap)

    def _count_loops(self, time, status):
        namespace = status.name.split(':')[0].strip('/').rpartition('/')[0]
        for value in status.values:
            if value.key != 'loops closed' or not COUNT.fullmatch(value.value):
                continue
            if self.namespace is None:
                self.namespace = namespace
            if namespace == self.namespace.strip('/'):
                self._note_loops(time, int(value.value))

    def _note_loops(self, time, count):
        """A mapper that is started again counts anew."""
        if count < self.closed:
            self.closed_before += self.closed
        self.closed = count
        whole = self.closed_before + count
        if whole > (self.loops[-1][1] if self.loops else 0):
            self.loops.append((time, whole))

    @staticmethod
    def sorted(findings):
        """The worst ones first, then by time."""
        order = {'FATAL': 0, 'ERROR': 1, 'STALE': 2, 'WARN': 3}
        return sorted(findings.values(), key=lambda finding: (order[finding.level], finding.spans[0]))
