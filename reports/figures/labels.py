"""Names of points in a figure, placed where there is room."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import text_to_path

from reports.figures.font import FAMILY
from reports.figures.style import INK, MUTED

Box = tuple[float, float, float, float]  # left, bottom, right, top [pt]

SIZE = 6.5  # of the letters [pt]
MARK = 4.0  # half the width of what is drawn at a point [pt]
DISTANCES = (7.0, 13.0, 22.0, 34.0, 48.0)  # from a point to its name [pt]
WAYS = ((1, 1), (-1, 1), (1, -1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1))
PAD = 2.0  # between the letters of a name and its box [pt]
LED = 20.0  # a name farther off than this has a line to its point [pt]


@dataclass(frozen=True)
class Label:
    """A name for a point; `at` [pt] from the lower left corner of the panel."""

    text: str
    at: tuple[float, float]
    colour: str = INK


def write(
    axes: Axes, labels: Sequence[Label], *, window: tuple[float, float], drawn: Sequence[tuple[float, float]] = ()
) -> None:
    """Write the labels into a panel of a size `window` [pt], each where it covers least.

    drawn : points [pt] of lines that the names should leave free
    """
    for label, (x, y) in zip(labels, offsets(labels, window=window, drawn=drawn), strict=True):
        leader = {"arrowstyle": "-", "color": MUTED, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 3}
        axes.annotate(
            label.text,
            label.at,
            xytext=(x, y),
            xycoords="axes points",
            textcoords="offset points",
            color=label.colour,
            fontsize=SIZE,
            annotation_clip=False,
            arrowprops=leader if max(abs(x), abs(y)) > LED else None,
        )


def write_tags(axes: Axes, labels: Sequence[Label]) -> None:
    """Write each label in a white box over its point, or beside it with a line where another box is there already.

    The axes are in points.
    """
    window = axes.get_xlim()[1], axes.get_ylim()[1]
    taken: list[Box] = []
    for label in labels:
        (x, y), (wide, high) = label.at, extent(label.text)
        wide, high = wide + 2 * PAD, high + 2 * PAD
        over = ((-0.5 * wide, -0.5 * high), (x - 0.5 * wide, y - 0.5 * high, x + 0.5 * wide, y + 0.5 * high))
        choices = [over, *candidates(label, (wide, high))]
        costs = [cost(box, taken, window) + 0.1 * place for place, (_, box) in enumerate(choices)]
        (left, low), box = choices[costs.index(min(costs))]
        taken.append(box)
        middle = (x + left + 0.5 * wide, y + low + 0.5 * high)
        if box is not over[1]:
            axes.plot([x, middle[0]], [y, middle[1]], color=INK, linewidth=0.5, zorder=6)
            axes.plot([x], [y], "o", color=INK, markersize=1.8, zorder=6)
        frame = {"boxstyle": "round,pad=0.18", "facecolor": "white", "edgecolor": label.colour, "linewidth": 0.5}
        axes.text(
            *middle, label.text, ha="center", va="center", fontsize=SIZE, color=label.colour, bbox=frame, zorder=7
        )


def offsets(
    labels: Sequence[Label], *, window: tuple[float, float], drawn: Sequence[tuple[float, float]] = ()
) -> list[tuple[float, float]]:
    """Return the offset from each point to the lower left corner of its name [pt], least covered place first."""
    taken = [(x - MARK, y - MARK, x + MARK, y + MARK) for x, y in (*(label.at for label in labels), *drawn)]
    found = []
    for label in labels:
        choices = candidates(label, extent(label.text))
        costs = [cost(box, taken, window) + 0.5 * place for place, (_, box) in enumerate(choices)]
        offset, box = choices[costs.index(min(costs))]
        found.append(offset)
        taken.append(box)
    return found


def candidates(label: Label, size: tuple[float, float]) -> list[tuple[tuple[float, float], Box]]:
    """Return places for a name of a size [pt], nearest first: the offset of its lower left corner, and its box."""
    (x, y), (wide, high) = label.at, size
    made = []
    for far in DISTANCES:
        for right, up in WAYS:
            step = far if right == 0 or up == 0 else 0.6 * far
            left = right * step - wide * (1 - right) / 2
            low = up * step - high * (1 - up) / 2
            made.append(((left, low), (x + left, y + low, x + left + wide, y + low + high)))
    return made


def cost(box: Box, taken: Sequence[Box], window: tuple[float, float]) -> float:
    """Return the area [pt2] that a box covers of others, plus that outside the window, which counts more."""
    inside = overlap(box, (0.0, 0.0, *window))
    area = (box[2] - box[0]) * (box[3] - box[1])
    return sum(overlap(box, other) for other in taken) + 3.0 * (area - inside)


def overlap(one: Box, other: Box) -> float:
    """Return the area that two boxes share [pt2]."""
    wide = min(one[2], other[2]) - max(one[0], other[0])
    high = min(one[3], other[3]) - max(one[1], other[1])
    return max(wide, 0.0) * max(high, 0.0)


def extent(text: str) -> tuple[float, float]:
    """Return width and height of a line of letters [pt]."""
    font = FontProperties(family=FAMILY, size=SIZE)
    wide, high, _ = text_to_path.get_text_width_height_descent(text, font, ismath=False)
    return wide, max(high, 0.75 * SIZE)
