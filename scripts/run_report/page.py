"""The page: one HTML file that needs nothing else, neither a network nor scripts."""
import datetime
import html
import os
import re

from command_line import printable

from . import map_plot, summary, time_plots
from .drawing import clock
from .intervals import total
from .load import without_numbers
from .output_file import MARK
from .warnings import Warnings

MOST_ROWS = 60  # of a table


def escape(text):
    """A text from the record in HTML, without control characters."""
    return html.escape(printable(text, len(text)))


def read_style():
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'style.css'), encoding='utf-8') as file:
        return file.read()


def table(heads, rows, css=''):
    """A table of text; the first column is the row's head. Cells that are tuples are (css class, text)."""
    if not rows:
        return ''

    def cell(tag, content):
        kind, text = content if isinstance(content, tuple) else ('', content)
        words = escape(str(text))
        if kind in ('code', 'value'):
            words = re.sub('([/_])', r'\1<wbr>', words)  # may be broken there, or a path is wider than the page
        return '<%s%s>%s</%s>' % (tag, ' class="%s"' % kind if kind else '', words, tag)
    lines = ['<tr>%s</tr>' % ''.join(cell('th', head) for head in heads)]
    lines += ['<tr>%s</tr>' % ''.join(cell('td', content) for content in row) for row in rows[:MOST_ROWS]]
    return '<div class="wide"><table class="%s">%s</table></div>%s' % (css, '\n'.join(lines), those_left_out(rows))


def those_left_out(rows):
    """How many come after the most that are shown; empty if none do."""
    return '<p class="quiet">and %d more</p>' % (len(rows) - MOST_ROWS) if len(rows) > MOST_ROWS else ''


def section(name, title, *contents, about=''):
    """A section; empty where it has no content."""
    body = '\n'.join(content for content in contents if content)
    if not body:
        return ''
    quiet = '<p class="quiet">%s</p>' % about if about else ''
    return '<section id="%s"><h2>%s</h2>%s%s</section>\n' % (name, title, quiet, body)


def plot(svg, css='wide'):
    return '<div class="%s plot">%s</div>' % (css, svg) if svg else ''


def badge(level):
    return '<span class="badge %s">%s</span>' % (level.lower(), level)


def head_of(run):
    wall = (run.start_info or {}).get('wall_time') or (run.load.wall[0][1] if run.load.wall else None)
    when = datetime.datetime.fromtimestamp(wall).strftime('%d %B %Y, %H:%M') if wall else ''
    return '<header><h1>Report of a run</h1><p class="quiet">%s</p></header>\n' % escape(when.lstrip('0'))


def summary_section(run):
    words = ' '.join(summary.sentences(run))
    tiles = ''.join('<div class="tile%s" data-figure="%s" data-value="%.6g"><b>%s</b><span>%s</span></div>' % (
        ' alarm' if name in ('stops', 'contacts', 'goals_failed') and value else '', name, value, escape(text), escape(label))
        for name, label, value, text in summary.tiles(run))
    found = summary.to_look_at(run)
    items = ''.join('<li>%s %s</li>' % (badge(level), escape(text)) for level, text in found[:MOST_ROWS])
    look = '<h3>Worth a look</h3><ul class="look">%s</ul>%s' % (items, those_left_out(found)) if items else \
        '<p class="fine">Nothing went wrong: no stop, no contact, no error in the diagnostics, and no node that had to be started again.</p>'
    return '<section id="summary"><p class="lead">%s</p><div class="tiles">%s</div>%s</section>\n' % (escape(words), tiles, look)


def map_section(run):
    drawn = map_plot.map_plot(run)
    if drawn is None:
        return ''
    svg, legend = drawn
    marks = ''.join('<li><i class="mark %s"></i>%s</li>' % (name, escape(words)) for name, words in legend)
    return section('where', 'Where it was', plot(svg, 'map-box'), '<ul class="legend">%s</ul>' % marks)


def drivers_section(run):
    rows = [(name, duration(total(spans)), '%d' % len(spans)) for name, spans in time_plots.driver_rows(run)]
    left_out = len(rows) - time_plots.MOST_SOURCES
    note = '<p class="quiet">and %d more, which were in command for less time</p>' % left_out if left_out > 0 else ''
    return section('who-drove', 'Who drove when', plot(time_plots.drivers_plot(run)), note,
                   table(('source', 'in command for', 'times'), rows, 'numbers'),
                   about='Whose velocity commands the arbiter forwarded. A source that sends zeros is in command, too, and keeps those of lower '
                         'priority from driving. In the gaps nobody was, and the robot stood.')


def duration(seconds):
    return summary.duration(seconds) if seconds >= 1.0 else '%.1f s' % seconds


def in_words(value):
    """A parameter as YAML would have it."""
    return str(value).lower() if isinstance(value, bool) else '(empty)' if value in ('', '""') else str(value)


def with_unit(value, unit):
    return ('%s %s' % (in_words(value), unit)).strip()


def events_section(run):
    rows = [(clock(time - run.begin), action, text) for time, action, text in run.actions]
    rows += [(clock(begin - run.begin), 'recovery', '%s, for %s' % (text, duration(end - begin)))
             for begin, end, text in run.recovery.those(run.end)]
    rows += [(clock(begin - run.begin), 'avoider', '%s, for %s' % (text, duration(end - begin)))
             for begin, end, text in run.avoiding.those(run.end)]
    details = '<details><summary>In detail (%d)</summary>%s</details>' % (len(rows), table(('at', 'what', 'how'), rows)) \
        if rows else ''
    return section('events', 'Stops, contacts, recoveries', plot(time_plots.events_plot(run)), details)


def findings_table(run, findings):
    rows = [(('level ' + finding.level.lower(), finding.level), finding.who.lstrip('/'), finding.text,
             clock(finding.spans[0][0] - run.begin), clock(finding.spans[-1][1] - run.begin),
             ('time', duration(total(finding.spans)) if total(finding.spans) else 'once' if finding.count == 1 else
              '%d times' % finding.count)) for finding in Warnings.sorted(findings)]
    return table(('level', 'who', 'what it said first', 'first', 'last', 'for'), rows)


def log_table(run):
    rows = [(('level ' + finding.level.lower(), finding.level), finding.who.lstrip('/'), finding.text,
             clock(finding.spans[0][0] - run.begin), '%d' % finding.count) for finding in Warnings.sorted(run.warnings.log)]
    return table(('level', 'node', 'what it said first', 'first', 'times'), rows)


def diagnostics_section(run):
    log = log_table(run)
    nothing = '<p class="fine">Every line of the diagnostics was OK throughout.</p>' if '/diagnostics' in run.heard else \
        '<p class="quiet">No diagnostics were recorded.</p>'
    return section('diagnostics', 'What was wrong when', findings_table(run, run.warnings.diagnostics) or nothing,
                   '<h3>Warnings and errors in the log</h3>' + log if log else '',
                   about='Lines of the diagnostics that were not OK; those that differ only in numbers are one row.')


def load_section(run):
    rows = [(without_numbers(node.lstrip('/')), '%.1f' % (100.0 * mean), '%.1f' % (100.0 * most), '%.0f' % (1e-6 * memory))
            for node, mean, most, memory in run.load.rows()]
    whole = sum(mean for _, mean, _, _ in run.load.rows())
    about = 'All nodes together used %.0f %% of a core on average. Only nodes on the computer of the recorder are measured.' % (
        100.0 * whole)
    return section('load', 'CPU time and memory', plot(time_plots.load_plot(run)),
                   table(('node', 'CPU mean [%]', 'CPU most [%]', 'memory most [MB]'), rows, 'numbers'), about=about if rows else '')


def goals_section(run):
    rows = [(str(goal.number), clock(goal.sent - run.begin), '%.2f, %.2f' % goal.place if goal.place else '',
             ('goal-' + goal.outcome.split()[0], goal.outcome), duration(goal.ended - goal.sent) if goal.ended else '', goal.why)
            for goal in run.goals.all]
    if not rows:
        return ''
    return section('goals', 'Goals', '<details><summary>All %d goals</summary>%s</details>' % (
        len(rows), table(('goal', 'sent', 'x, y [m]', 'outcome', 'after', 'reason'), rows)))


def parameters_section(settings, known):
    """`known`: whether the defaults were found."""
    rows = []
    for setting in settings:
        value = with_unit(setting.value, setting.unit)
        if setting.changed_to is not None:
            value += ', at the end %s' % with_unit(setting.changed_to, setting.unit)
        default = '?' if setting.default is None else with_unit(setting.default, setting.unit)
        who = ', '.join(setting.nodes) if len(setting.nodes) < 4 else '%d nodes' % len(setting.nodes)
        rows.append((('code', setting.name), ('value', value), ('value', default), who, setting.meaning))
    about = 'What was set on the parameter server and differs from the default of its node.' if known else \
        'The defaults are not known here: everything that was set is shown.'
    return section('parameters', 'Parameters that differ from the defaults',
                   table(('parameter', 'value', 'default', 'of', 'meaning'), rows) or
                   '<p class="quiet">None.</p>', about=about)


def page(run, settings, defaults_known, sources):
    """The HTML of the report. `sources`: the bags that it was made from."""
    sections = (summary_section(run), map_section(run), section('area', 'Explored area', plot(time_plots.area_plot(run))),
                drivers_section(run), events_section(run), diagnostics_section(run), load_section(run), goals_section(run),
                parameters_section(settings, defaults_known))
    footer = '<footer>Made by <code>rosrun frontier_pilot report</code> from %s. Times are ROS time since the start ' \
             'of the record.</footer>' % escape(', '.join(sources))
    return '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n%s\n' \
           '<meta name="viewport" content="width=device-width, initial-scale=1">\n' \
           '<meta name="color-scheme" content="light dark">\n<link rel="icon" href="data:,">\n' \
           '<title>Report of a run</title>\n<style>\n%s</style>\n</head>\n<body>\n<main>\n%s%s</main>\n%s\n</body>\n</html>\n' % (
               MARK, read_style(), head_of(run), ''.join(sections), footer)
