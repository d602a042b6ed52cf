"""The run in plain words, and its main figures."""
import math
import os

from .drawing import clock
from .intervals import merged, total
from .progress import DONE, NAVIGATING
from .warnings import Warnings

MOST_STOPS = 20  # that are listed one by one
# What a page cannot tell of a record that lacks a topic.
NOT_RECORDED = (('cmd_vel_arbiter/status', 'Nothing of the arbiter was recorded: whether the robot was stopped, and who drove it, is not known.'),
                ('/diagnostics', 'No diagnostics were recorded: whether a node found something wrong is not known.'))


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
    """Also told by the clock: the parameters of an earlier simulation stay at the master."""
    clock_is_simulated = (run.start_info or {}).get('parameters', {}).get('use_sim_time') is True
    return clock_is_simulated and bool(first_parameter(run, 'simulator', 'world'))


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
    """(emergency stops, contacts, recoveries), each None where nothing was recorded that tells of it."""
    counts = len(merged(run.stop.those(run.end))), len(run.contact.those(run.end)), len(run.recoveries())
    return tuple(count if role in run.heard else None
                 for count, role in zip(counts, ('cmd_vel_arbiter/status', 'simulator/stalled', 'navigator/status')))


def incident_words(run):
    names = ('emergency stop',), ('contact',), ('recovery', 'recoveries')
    known = [(count, name) for count, name in zip(incident_counts(run), names) if count is not None]
    if not known:
        return ''
    words = [counted(count, *name) for count, name in known]
    listed = ', '.join(words[:-1]) + ' and ' + words[-1] if len(words) > 1 else words[0]
    return '%s %s.' % ('There was' if max(count for count, _ in known) <= 1 else 'There were', listed)


def sentences(run):
    words = subject(run) + ' ' + time_words(run) + '.', exploration_words(run), end_words(run), incident_words(run)
    return [sentence for sentence in words if sentence]


def to_look_at(run):
    """What deserves a look: (level, words)."""
    items = [('WARN', note) for note in run.notes]
    items += [('WARN', words) for role, words in NOT_RECORDED if role not in run.heard]
    stops = [('ERROR', 'Emergency stop at %s, for %s: %s' % (clock(begin - run.begin), duration(end - begin), cause))
             for begin, end, cause in run.stop.those(run.end)]
    items += stops[:MOST_STOPS]
    if len(stops) > MOST_STOPS:
        items.append(('ERROR', 'There were %d more emergency stops.' % (len(stops) - MOST_STOPS)))
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
    names = ('stops', 'emergency stops'), ('contacts', 'contacts'), ('recoveries', 'recoveries')
    out += [(*name, count, '%d' % count) for name, count in zip(names, incident_counts(run)) if count is not None]
    out += [('loops', 'loops closed', run.warnings.loops[-1][1] if run.warnings.loops else 0,
             '%d' % (run.warnings.loops[-1][1] if run.warnings.loops else 0))]
    return out
