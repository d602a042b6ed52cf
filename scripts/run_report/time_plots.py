"""The plots over time: explored area, who drove, what happened, CPU and memory."""
import math

from . import goals as outcomes
from .drawing import COLOURS, few_ticks, name_of, new_axes, new_axes_one_above_the_other, styled, time_axis, to_svg
from .intervals import total
from .load import without_numbers

SOURCE_COLOURS = {'avoid': 'c8', 'behavior': 'c5', 'patrol': 'c2', 'nav': 'c1', 'manual': 'c3'}
MOST_SOURCES = 20  # with a row in the plot
BUSIEST = 8  # nodes with a line of their own
THINNEST = 0.004  # of the width of the plot, so that what was short can still be seen


def area_plot(run):
    """Explored area, with the estimate of the whole; None without an explorer."""
    if len(run.explorer) < 2:
        return None
    times = [time - run.begin for time, _ in run.explorer]
    with styled():
        figure, axes = new_axes(2.7)
        explored = [status.explored_area for _, status in run.explorer]
        draw_estimate(axes, run, max(explored))
        axes.fill_between(times, explored, color=COLOURS['c1'], alpha=0.12, linewidth=0)
        axes.plot(times, explored, color=COLOURS['c1'], label='explored')
        axes.annotate('%.1f m²' % explored[-1], (times[-1], explored[-1]), (-4, -14), textcoords='offset points', ha='right',
                      color=COLOURS['c1'], fontweight='bold')
        axes.set_ylabel('area [m²]')
        axes.set_ylim(bottom=0.0)
        few_ticks(axes.yaxis)
        time_axis(axes, run.end - run.begin)
        axes.legend(loc='lower right', frameon=False, bbox_to_anchor=(1.0, 0.12))
        return to_svg(figure, 'area', 'Explored area over time')


def draw_estimate(axes, run, most):
    """The estimate of the whole area with its deviation, as far as it was known."""
    known = [(time - run.begin, status.estimated_area, status.estimated_area_deviation) for time, status in run.explorer
             if not math.isnan(status.estimated_area)]
    if not known:
        return
    times, area, deviation = zip(*known)
    limit = 1.6 * max(most, area[-1])
    lower = [max(0.0, one - off) for one, off in zip(area, deviation)]
    upper = [min(limit, one + off) for one, off in zip(area, deviation)]
    axes.fill_between(times, lower, upper, color=COLOURS['muted'], alpha=0.15, linewidth=0)
    axes.plot(times, [min(one, limit) for one in area], color=COLOURS['muted'], linewidth=1.2, linestyle='--',
              label='estimate of the whole ± 1 σ')


def draw_rows(axes, rows, end):
    """Rows of bars: (label, spans (begin, end), colour), the first one on top."""
    for index, (_, spans, colour) in enumerate(rows):
        bars = [(begin, max(until - begin, THINNEST * end)) for begin, until in spans]
        axes.broken_barh(bars, (len(rows) - 1 - index - 0.32, 0.64), facecolors=COLOURS[colour], linewidth=0)
    axes.set_yticks(range(len(rows)), [name_of(label) for label, _, _ in reversed(rows)])
    axes.tick_params(axis='y', labelcolor=COLOURS['ink'])
    axes.set_ylim(-0.6, len(rows) - 0.4)
    axes.grid(False, axis='y')
    time_axis(axes, end)


def rows_plot(run, rows, name, title):
    with styled():
        figure, axes = new_axes(0.55 + 0.3 * len(rows))
        draw_rows(axes, rows, run.end - run.begin)
        return to_svg(figure, name, title)


def shifted(run, spans):
    return [(span[0] - run.begin, span[1] - run.begin) for span in spans]


def driver_rows(run):
    """(source, spans) of each source that has driven: ours by their priority, then the others, which drove longest first."""
    spans = {}
    for span in run.source.those(run.end):
        spans.setdefault(span[2], []).append(span)
    ours = [name for name in SOURCE_COLOURS if name in spans]
    others = sorted(spans.keys() - set(ours), key=lambda name: (-total(spans[name]), name))
    return [(name, spans[name]) for name in ours + others]


def drivers_plot(run):
    """Who drove when, of the first of the sources; None where nobody did."""
    rows = [(name, shifted(run, spans), SOURCE_COLOURS.get(name, 'c7')) for name, spans in driver_rows(run)[:MOST_SOURCES]]
    return rows_plot(run, rows, 'drivers', 'Which source of commands drove when') if rows else None


def event_rows(run):
    """(label, spans) of everything that may have gone wrong, also of what did not happen."""
    failed = [(goal.ended, goal.ended) for goal in run.goals.of(outcomes.FAILED)]
    levels = [[span for finding in run.warnings.diagnostics.values() if finding.level in names and not always(run, finding)
               for span in finding.spans] for names in (('ERROR', 'STALE'), ('WARN',))]
    return [('emergency stop', run.stop.those(run.end), 'bad'), ('contact', run.contact.those(run.end), 'bad'),
            ('recovery', run.recoveries(), 'c8'), ('avoider', run.avoiding.those(run.end), 'c8'),
            ('goal failed', failed, 'c8'), ('loop closed', [(time, time) for time, _ in run.warnings.loops], 'c5'),
            ('diagnostics ERROR', levels[0], 'bad'), ('diagnostics WARN', levels[1], 'warn')]


def always(run, finding):
    """Whether a line was there all the time, as that of a node that is switched off: over time it would hide all others."""
    return total(finding.spans) > 0.95 * (run.end - run.begin)


def events_plot(run):
    """What happened when; None where nothing did."""
    rows = [(label, shifted(run, spans), colour) for label, spans, colour in event_rows(run)]
    happened = [row for row in rows if row[1]]
    return rows_plot(run, happened, 'events', 'Stops, contacts, recoveries and warnings over time') if happened else None


def load_plot(run):
    """CPU time above memory, on one axis of time; None where neither was measured."""
    if not run.load.nodes:
        return None
    with styled():
        figure, (upper, lower) = new_axes_one_above_the_other(2.9, 2)
        draw_load(upper, run, 1, 100.0, 'CPU [% of a core]')
        draw_load(lower, run, 2, 1e-6, 'memory [MB]')
        return to_svg(figure, 'load', 'CPU time and memory of the nodes')


def draw_load(axes, run, column, scale, unit):
    """A line for each of the nodes that used most in all, in this order."""
    nodes = sorted(run.load.nodes.items(), key=lambda item: -sum(sample[column] for sample in item[1]))[:BUSIEST]
    for index, (node, samples) in enumerate(nodes):
        axes.plot([sample[0] - run.begin for sample in samples], [scale * sample[column] for sample in samples],
                  color=COLOURS['c%d' % (index + 1)], linewidth=1.4, label=name_of(without_numbers(node.lstrip('/'))))
    axes.set_ylabel(unit)
    axes.set_ylim(0.0, 1.08 * max(scale * sample[column] for _, samples in nodes for sample in samples) or 1.0)
    few_ticks(axes.yaxis)
    time_axis(axes, run.end - run.begin)
    axes.legend(loc='upper left', frameon=False, bbox_to_anchor=(1.0, 1.03), handlelength=1.2)
