"""Mechanisms side by side at rest, to one scale."""

from __future__ import annotations

from math import ceil

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from assess.results import Drawing, MechanismResult, Point
from reports.figures.style import BLOCKS, FIXED, POSITIVE, STONE_EDGE, WIDTH, bare_sheet, fold, report_style
from reports.mechanism_title import mechanism_title

MOST = 24  # mechanisms in one figure
COLUMNS = 6
TALLEST, LOWEST = 2.6, 0.75  # a panel without its name [in]
HIGHEST = 8.2  # the figure: it shares a page of either paper with its caption [in]
NAME, GAP, LEFT = 0.34, 0.12, 0.42  # room for names, between panels, for the axis of elevation [in]


def draw(mechanisms: tuple[MechanismResult, ...]) -> Figure:
    """Draw a panel for each mechanism, centred on its masonry; elevations [m] from the lowest of all."""
    columns = min(COLUMNS, len(mechanisms))
    rows = ceil(len(mechanisms) / columns)
    spans = [_span(mechanism.drawing) for mechanism in mechanisms]
    wide = max(high - low for (low, high), _ in spans) * 1.12
    wide_panel = (WIDTH - LEFT - GAP * columns) / columns
    tall = max(high - low for _, (low, high) in spans) * 1.06
    scale = min(wide_panel / wide, min(TALLEST, HIGHEST / rows - NAME) / tall)
    high_panel = max(LOWEST, tall * scale)
    with report_style():
        figure = bare_sheet(rows * (high_panel + NAME) + 0.1)
        for place, (mechanism, span) in enumerate(zip(mechanisms, spans, strict=True)):
            row, column = divmod(place, columns)
            left = (LEFT + column * (wide_panel + GAP)) / WIDTH
            height = rows * (high_panel + NAME) + 0.1
            bottom = (height - (row + 1) * (high_panel + NAME)) / height
            axes = figure.add_axes((left, bottom, wide_panel / WIDTH, high_panel / height))
            _panel(axes, mechanism, span, size=(wide_panel / scale, high_panel / scale), first=column == 0)
        return figure


def _span(drawing: Drawing) -> tuple[Point, Point]:
    """Return extent of the moving masonry and its hinges: least and largest x, least and largest z [m]."""
    points = [point for ring in drawing.blocks for point in ring] + [hinge.at for hinge in drawing.hinges]
    along, up = [x for x, _ in points], [z for _, z in points]
    return (min(along), max(along)), (min(up), max(up))


def _panel(
    axes: Axes, mechanism: MechanismResult, span: tuple[Point, Point], *, size: tuple[float, float], first: bool
) -> None:
    (left, right), (low, _) = span
    middle = (left + right) / 2.0
    axes.set_xlim(middle - size[0] / 2.0, middle + size[0] / 2.0)
    axes.set_ylim(low - 0.04 * size[1], low + 0.96 * size[1])
    drawing = mechanism.drawing
    for ring in drawing.fixed:
        axes.add_artist(Polygon(ring, facecolor=FIXED, edgecolor=STONE_EDGE, linewidth=0.3))
    for ring, block in zip(drawing.blocks, drawing.block_of, strict=True):
        colour = FIXED if block < 0 else BLOCKS[block % len(BLOCKS)]
        axes.add_artist(Polygon(ring, facecolor=colour, edgecolor=STONE_EDGE, linewidth=0.5))
    for hinge in drawing.hinges:
        if not hinge.name.endswith("'"):
            axes.plot(*hinge.at, marker="o", markersize=2.6, color=POSITIVE, markerfacecolor="white", clip_on=False)
    axes.set_title(fold(mechanism_title(mechanism), width=22), fontsize=6.4, loc="center", pad=3)
    axes.set_xticks([])
    axes.grid(visible=False)
    axes.tick_params(labelsize=5.8)
    axes.locator_params(axis="y", nbins=5)
    if first:
        axes.set_ylabel("elevation z [m]", fontsize=6.4)
