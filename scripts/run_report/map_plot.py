"""The map with what happened where."""
import numpy
from matplotlib.colors import ListedColormap

from . import goals as outcomes
from .drawing import COLOURS, few_ticks, new_axes, styled, to_svg

MARGIN = 0.4  # [m] around what is shown
# Unknown, free, occupied: one picture for each of the two colour schemes, of which the style sheet shows one.
PALETTES = {'light': ((0, 0, 0, 0), (1.0, 1.0, 1.0, 1), (0.23, 0.25, 0.28, 1)),
            'dark': ((0, 0, 0, 0), (0.22, 0.24, 0.27, 1), (0.78, 0.80, 0.83, 1))}


def classes_of(cells):
    """0 unknown, 1 free, 2 occupied."""
    return numpy.where(cells < 0, 0, numpy.where(cells < 50, 1, 2)).astype(numpy.uint8)


def known_part(cells):
    """Rows and columns (first, last + 1) of the cells that are known."""
    rows, columns = numpy.nonzero(cells >= 0)
    if not len(rows):
        return 0, cells.shape[0], 0, cells.shape[1]
    return rows.min(), rows.max() + 1, columns.min(), columns.max() + 1


def draw_map(axes, grid):
    """Draws the known part; gives the extent (left, right, bottom, top) [m]."""
    top, bottom, left, right = known_part(grid.cells)
    cells = classes_of(grid.cells[top:bottom, left:right])
    x, y = grid.origin
    extent = (x + left * grid.resolution, x + right * grid.resolution, y + top * grid.resolution, y + bottom * grid.resolution)
    for scheme, palette in PALETTES.items():
        image = axes.imshow(cells, origin='lower', extent=extent, cmap=ListedColormap(palette), vmin=0, vmax=2,
                            interpolation='none', zorder=1)
        image.set_gid('cells-' + scheme)
    return extent


def draw_places(axes, places, **style):
    if places:
        axes.plot([place[0] for place in places], [place[1] for place in places], linestyle='none', **style)


def mark(colour, marker, size, filled=True, width=1.4, zorder=5):
    return dict(marker=marker, markersize=size, markeredgecolor=COLOURS[colour], markeredgewidth=width, zorder=zorder,
                markerfacecolor=COLOURS[colour] if filled else 'none')


def places_of(run, times):
    return [place for place in (run.track.at(time) for time in times) if place]


def extent_of_track(run):
    points = numpy.array([pose[1:3] for pose in run.track.poses])
    return points[:, 0].min(), points[:, 0].max(), points[:, 1].min(), points[:, 1].max()


def map_plot(run):
    """The plot and its legend [(css class, words)]; None where there is neither a map nor a track."""
    if run.map.cells is None and not run.track.poses:
        return None
    with styled():
        figure, axes = new_axes(1.0)
        extents = [draw_map(axes, run.map)] if run.map.cells is not None else []
        extents += [extent_of_track(run)] if run.track.poses else []
        left, right, bottom, top = (pick(values) for pick, values in zip((min, max, min, max), zip(*extents)))
        wide, high = right - left + 2 * MARGIN, top - bottom + 2 * MARGIN
        figure.set_size_inches(7.6, min(10.0, max(2.6, 7.0 * high / wide + 0.5)))
        legend = draw_run(axes, run)
        axes.set_aspect('equal')
        axes.set_xlim(left - MARGIN, right + MARGIN)
        axes.set_ylim(bottom - MARGIN, top + MARGIN)
        axes.set_xlabel('x [m]')
        axes.set_ylabel('y [m]')
        few_ticks(axes.xaxis, 8)
        few_ticks(axes.yaxis, 8)
        axes.spines[:].set_visible(False)
        axes.set_facecolor(COLOURS['unknown'])
        return to_svg(figure, 'map', 'The map with the track of the robot'), legend


def draw_run(axes, run):
    """Draws track and events; gives the legend of what is there."""
    legend = []
    for piece in run.track.pieces():
        axes.plot(piece[:, 0], piece[:, 1], color=COLOURS['c1'], linewidth=1.5, alpha=0.9, zorder=3)
    reached, failed, dropped = ([goal.place for goal in run.goals.of(outcome) if goal.place]
                                for outcome in (outcomes.REACHED, outcomes.FAILED, outcomes.DROPPED))
    kinds = (
        ('track', 'track of the robot, from the ring to the dot', [], {}),
        ('dropped', 'goal dropped on the way', dropped, mark('c2', 'o', 6, filled=False)),
        ('reached', 'goal reached', reached, mark('c2', 'o', 6)),
        ('failed', 'goal failed', failed, mark('bad', 'X', 8, width=0.5)),
        ('loop', 'place at which loops were closed', places_of(run, [time for time, _ in run.warnings.loops]), mark('c5', 'D', 7)),
        ('frontier', 'frontier that is left', run.frontiers, mark('c4', 's', 4)),
        ('recovery', 'recovery', places_of(run, [begin for begin, _ in run.recoveries()]), mark('c8', '^', 8)),
        ('stopped', 'emergency stop', places_of(run, [begin for begin, _, _ in run.stop.those(run.end)]), mark('bad', 's', 8)),
        ('contact', 'contact', places_of(run, [begin for begin, _, _ in run.contact.those(run.end)]), mark('bad', '*', 13)))
    for name, words, places, style in kinds:
        draw_places(axes, places, **style)
        if places or name == 'track' and run.track.poses:
            legend.append((name, words if name == 'track' else '%s (%d)' % (words, len(places))))
    if run.track.poses:
        (_, *first), (_, *last) = run.track.poses[0], run.track.poses[-1]
        draw_places(axes, [first[:2]], **mark('c1', 'o', 10, filled=False, width=2.2, zorder=6))
        draw_places(axes, [last[:2]], **mark('c1', 'o', 8, zorder=6))
    return legend
