"""The run in plain words, and its main figures."""
import math
import os

from .drawing import clock
from .intervals import merged, total
from .progress import DONE, NAVIGATING
from .warnings import Warnings


def duration(seconds):
    """In words: 48 s, 5 min 12 s, 1 h 3 min."""
    whole = int(round(seconds))
    if whole < 60:
        return '%d s' % whole
    if whole < 3600:
        return '%d min %d s' % (whole // 60, whole % 60)
    return '%d h %d min' % (whole // 3600, whole % 3600 // 60)


def counted(count, one, many=None):
    """1 contact, 2 contacts, no contact."""
    return '%s %s' % (count or 'no', one if count in (0, 1) else many or one + 's')


def first_parameter(run, *names):
    """A parameter at the start of the run by its path; empty if it is not known."""
    value = (run.start_info or {}).get('parameters', {})
    for name in names:
        value = value.get(name, {}) if isinstance(value, dict) else {}
    return value if isinstance(value, str) else ''


def is_simulated(run):
    return bool(first_parameter(run, 'simulator', 'world'))


def subject(run):
    """The robot and where it was."""
    name = run.namespace().strip('/')
    kind = os.path.basename(str((run.start_info or {}).get('robot') or '')).replace('.yaml', '')
    words = 'The robot' + (' ' + name if name else '') + (' (%s)' % kind if kind else '')
    if is_simulated(run):
        return words + ', simulated in the world “%s”,' % os.path.splitext(os.path.basename(
            first_parameter(run, 'simulator', 'world')))[0]
    return words


def goal_counts(run):
    """Goals sent, reached, failed, and dropped on the way, by the explorer's last status; None without an explorer."""
    status = run.status()
    if status is None:
        return None
    under_way = 1 if status.state == NAVIGATING else 0
    dropped = max(0, status.goals_sent - status.goals_reached - status.goals_failed - under_way)
    return status.goals_sent, status.goals_reached, status.goals_failed, dropped


def time_words(run):
    """How long the record is, and how long that took."""
    words = 'was recorded for %s' % duration(run.end - run.begin)
    wall = run.real_seconds
    if wall and is_simulated(run) and abs(wall - (run.end - run.begin)) > 0.1 * wall:
        words += ' of its own time (%s of real time)' % duration(wall)
    return words


def exploration_words(run):
    status, counts = run.status(), goal_counts(run)
    if status is None:
        return 'No explorer was running. The robot moved %.1f m.' % run.track.length
    words = 'It explored %.1f m² and drove %.1f m.' % (status.explored_area, status.distance_travelled)
    if counts[0]:
        words += ' Of %s it reached %d, dropped %d on the way, and failed at %d.' % (
            counted(counts[0], 'goal'), counts[1], counts[3], counts[2])
    return words


def end_words(run):
    """How it ended."""
    status = run.status()
    unfinished = any('was not closed' in note for note in run.notes)
    if status is not None and status.state == DONE:
        return 'The exploration ended by itself: %s.' % status.reason_text.rstrip('.')
    if status is not None and status.goals_sent:
        return 'The exploration was not finished when the record ended; the explorer was %s: %s.' % (
            status.state_text, status.reason_text.rstrip('.'))
    return 'The record ended without a goodbye.' if unfinished else 'Then the record was ended.'


def incident_counts(run):
    """(emergency stops, contacts, recoveries); contacts are None where the robot cannot tell."""
    stops, contacts = len(merged(run.stop.those(run.end))), len(run.contact.those(run.end))
    return stops, contacts if run.stalls_known else None, len(run.recoveries())


def incident_words(run):
    stops, contacts, recoveries = incident_counts(run)
    words = [counted(stops, 'emergency stop')]
    words += [counted(contacts, 'contact')] if contacts is not None else []
    words.append(counted(recoveries, 'recovery', 'recoveries'))
    text = 'There was %s and %s.' if max(stops, contacts or 0, recoveries) <= 1 else 'There were %s and %s.'
    return text % (', '.join(words[:-1]), words[-1])


def sentences(run):
    return [subject(run) + ' ' + time_words(run) + '.', exploration_words(run), end_words(run), incident_words(run)]


def to_look_at(run):
    """What deserves a look: (level, words)."""
    items = [('WARN', note) for note in run.notes]
    for begin, end, cause in run.stop.those(run.end):
        items.append(('ERROR', 'Emergency stop at %s, for %s: %s' % (clock(begin - run.begin), duration(end - begin), cause)))
    contacts = run.contact.those(run.end)
    if contacts:
        items.append(('ERROR', 'The robot touched something %s, for %s in all, first at %s.' % (
            'once' if len(contacts) == 1 else '%d times' % len(contacts), duration(total(contacts)),
            clock(contacts[0][0] - run.begin))))
    for finding in Warnings.sorted(run.warnings.diagnostics):
        if finding.level == 'ERROR':
            items.append(('ERROR', 'From %s on, %s: %s' % (clock(finding.spans[0][0] - run.begin), finding.who, finding.text)))
    items += [('ERROR', '%s ended, and went on as another process at %s.' % (node, clock(time - run.begin)))
              for time, node in run.load.restarts()]
    busy = [row for row in run.load.rows() if row[1] > 0.8]
    items += [('WARN', '%s used %.0f %% of a core on average.' % (row[0], 100.0 * row[1])) for row in busy]
    return items


def tiles(run):
    """The main figures: (name for tests, label, value as a number, as text)."""
    out = [('duration', 'recorded', run.end - run.begin, clock(run.end - run.begin))]
    status, counts = run.status(), goal_counts(run)
    if status is not None:
        out += [('explored_area', 'explored', status.explored_area, '%.1f m²' % status.explored_area),
                ('distance', 'driven', status.distance_travelled, '%.1f m' % status.distance_travelled),
                ('goals', 'goals sent', counts[0], '%d' % counts[0]),
                ('goals_reached', 'reached', counts[1], '%d' % counts[1]),
                ('goals_dropped', 'dropped', counts[3], '%d' % counts[3]),
                ('goals_failed', 'failed', counts[2], '%d' % counts[2])]
        if not math.isnan(status.share_explored) and status.state != DONE:
            out.append(('share', 'of the whole, estimated', status.share_explored, '%.0f %%' % (100.0 * status.share_explored)))
    else:
        out.append(('distance', 'moved', run.track.length, '%.1f m' % run.track.length))
    stops, contacts, recoveries = incident_counts(run)
    out.append(('stops', 'emergency stops', stops, '%d' % stops))
    if contacts is not None:
        out.append(('contacts', 'contacts', contacts, '%d' % contacts))
    out += [('recoveries', 'recoveries', recoveries, '%d' % recoveries),
            ('loops', 'loops closed', run.warnings.loops[-1][1] if run.warnings.loops else 0,
             '%d' % (run.warnings.loops[-1][1] if run.warnings.loops else 0))]
    return out
