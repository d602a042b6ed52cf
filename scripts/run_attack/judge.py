"""The verdict on a stop: no command that moves is published between its answer and the begin of the next clear. [ARB-7]

A command has no stamp. The probe knows for each message two times of the steady clock: `earliest`, when its socket was
found empty before the message came, and `latest`, when it was read. It was published after `earliest`, but for the
transport within the machine, and before `latest`.
"""
import bisect
import collections

TRANSPORT = 0.005  # [s] a written message may wait in the loopback interface before the socket of its reader has it

Message = collections.namedtuple('Message', 'earliest latest moves')
Call = collections.namedtuple('Call', 'stop begin answer')  # `stop`: whether it was a stop, else a clear that succeeded


def stopped_spans(calls):
    """The spans in which the stop certainly holds, in order and not overlapping, and how many stops they rest on.

    A clear that overlaps a stop may have been served before or after it: such a stop shows nothing, and is left out.
    """
    clears = sorted(call for call in calls if not call.stop)
    latest_answers, latest = [], float('-inf')
    for clear in clears:  # the latest answer of this and all earlier begun clears
        latest = max(latest, clear.answer)
        latest_answers.append(latest)
    begins = [clear.begin for clear in clears]
    spans, count = [], 0
    for stop in sorted((call for call in calls if call.stop), key=lambda call: call.answer):
        after = bisect.bisect_right(begins, stop.answer)
        if after and latest_answers[after - 1] >= stop.begin:
            continue
        count += 1
        end = begins[after] if after < len(begins) else float('inf')
        if spans and spans[-1][1] >= stop.answer:
            spans[-1] = (spans[-1][0], max(spans[-1][1], end))
        else:
            spans.append((stop.answer, end))
    return spans, count


def violations(messages, calls, transport=TRANSPORT):
    """The messages that move and were certainly published while the stop held."""
    spans, _ = stopped_spans(calls)
    begins = [begin for begin, _ in spans]
    found = []
    for message in messages:
        if not message.moves:
            continue
        index = bisect.bisect_left(begins, message.earliest - transport) - 1
        if index >= 0 and message.latest < spans[index][1]:
            found.append(message)
    return found


def held_time(calls, end):
    """How long the stop certainly held until `end` [s]."""
    return sum(max(0.0, min(last, end) - begin) for begin, last in stopped_spans(calls)[0])
