"""Plots as SVG that follows the colours of the page, light or dark."""
import io
import re

import matplotlib
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from command_line import printable

# Colours that stand for those of the page: each becomes var(--name), which the style sheet defines for light and dark.
NAMES = ('ink', 'muted', 'grid', 'unknown', 'warn', 'bad') + tuple('c%d' % number for number in range(1, 9))
COLOURS = {name: '#%02x1f%02x' % (index, index) for index, name in enumerate(NAMES)}
STYLE = {
    'svg.fonttype': 'none', 'text.parse_math': False, 'font.family': 'sans-serif', 'font.size': 10.0, 'text.color': COLOURS['ink'],
    'axes.edgecolor': COLOURS['grid'], 'axes.labelcolor': COLOURS['muted'], 'axes.facecolor': 'none', 'axes.grid': True,
    'axes.axisbelow': True, 'axes.spines.top': False, 'axes.spines.right': False, 'axes.spines.left': False,
    'grid.color': COLOURS['grid'], 'grid.linewidth': 0.7, 'xtick.color': COLOURS['grid'], 'ytick.color': COLOURS['grid'],
    'xtick.labelcolor': COLOURS['muted'], 'ytick.labelcolor': COLOURS['muted'], 'ytick.major.size': 0.0,
    'lines.linewidth': 1.8, 'lines.solid_joinstyle': 'round', 'figure.facecolor': 'none', 'savefig.facecolor': 'none'}
WIDTH = 9.2  # [inch] of 72 units
LONGEST_NAME = 40  # [letters] beside a plot


def clock(seconds, _=None):
    """3:05, or 1:03:05 from an hour on."""
    whole = int(round(abs(seconds)))
    sign = '-' if seconds < -0.5 else ''
    if whole < 3600:
        return '%s%d:%02d' % (sign, whole // 60, whole % 60)
    return '%s%d:%02d:%02d' % (sign, whole // 3600, whole // 60 % 60, whole % 60)


def name_of(text):
    """A name as it stands beside a plot: anybody can choose one that is longer than the page is wide."""
    return printable(text, LONGEST_NAME)


def new_axes(height, width=WIDTH):
    """A figure with one pair of axes. Call within a `styled()` context."""
    figure = Figure(figsize=(width, height), layout='constrained')
    FigureCanvasSVG(figure)
    return figure, figure.add_subplot()


def new_axes_one_above_the_other(height, count, width=WIDTH):
    """A figure with so many axes of one width, each of this height. Call within a `styled()` context."""
    figure = Figure(figsize=(width, count * height), layout='constrained')
    FigureCanvasSVG(figure)
    return figure, figure.subplots(count)


def styled():
    """The context in which plots are drawn."""
    return matplotlib.rc_context(STYLE)


def time_axis(axes, end):
    """Gives the axes the time since the start of the record, [s] written as a clock."""
    steps = (1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 43200, 86400)
    step = next((step for step in steps if end / step <= 9), steps[-1])
    step = max(step, end / 10)  # a clock that was set during the run makes it last for decades
    axes.set_xlim(0.0, max(end, 1.0))
    axes.set_xticks([index * step for index in range(int(end / step) + 1)])
    axes.xaxis.set_major_formatter(FuncFormatter(clock))


def few_ticks(axis, count=5):
    axis.set_major_locator(MaxNLocator(count, min_n_ticks=2))


def to_svg(figure, name, title):
    """The figure as an <svg> element without size, with ids of its own, and the page's colours and font."""
    out = io.StringIO()
    with matplotlib.rc_context({'svg.hashsalt': name, **STYLE}):
        figure.savefig(out, format='svg', metadata={'Date': None, 'Creator': None, 'Format': None, 'Type': None})
    svg = out.getvalue()
    svg = svg[svg.index('<svg'):]
    svg = re.sub(r'<metadata>.*?</metadata>', '', svg, flags=re.DOTALL)
    svg = re.sub(r'<style.*?</style>', '', svg, flags=re.DOTALL)  # it would be that of the whole page
    svg = re.sub(r'<!--.*?-->\n?', '', svg, flags=re.DOTALL)
    svg = re.sub(r' (width|height)="[\d.]+pt"', '', svg, count=2)
    svg = re.sub(r'\bid="', 'id="%s-' % name, svg)
    svg = re.sub(r'(url\(#|href="#)', r'\g<1>%s-' % name, svg)
    svg = re.sub(r"font: ([\d.]+px) [^;\"]*", r'font-size: \1', svg)
    for colour, value in COLOURS.items():
        svg = svg.replace(value, 'var(--%s)' % colour)
    return svg.replace('<svg ', '<svg role="img" aria-label="%s" class="%s" ' % (title, name), 1)
