"""Names of points in a figure, placed where there is room."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

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
    """A name for a point of the axes; an empty one keeps its point free of other names."""

    text: str
    at: tuple[float, float]
    colour: str = INK


def write(axes: Axes, labels: Sequence[Label]) -> None:
    """Write the labels, each where it covers least. The figure has 72 dots to the inch."""
    left, low, right, high = axes.get_window_extent().extents
    places = axes.transData.transform([label.at for label in labels]).tolist()
    taken = [(x - MARK, y - MARK, x + MARK, y + MARK) for x, y in places]
    leader = {"arrowstyle": "-", "color": MUTED, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 3}
    for label, place in zip(labels, places, strict=True):
        if label.text:
            box = freest_box(boxes_around(place, extent(label.text)), taken, (left, low, right, high), 0.5)
            taken.append(box)
            offset = box[0] - place[0], box[1] - place[1]
            axes.annotate(
                label.text,
                label.at,
                xytext=offset,
                textcoords="offset points",
                color=label.colour,
                fontsize=SIZE,
                annotation_clip=False,
                arrowprops=leader if max(map(abs, offset)) > LED else None,
            )


def write_tags(axes: Axes, labels: Sequence[Label]) -> None:
    """Write each label in a white box over its point, or beside it with a line where another box is there already.

    The axes are in points.
    """
    inside, taken = (0.0, 0.0, axes.get_xlim()[1], axes.get_ylim()[1]), list[Box]()
    for label in labels:
        (x, y), (wide, high) = label.at, (side + 2 * PAD for side in extent(label.text))
        over = (x - 0.5 * wide, y - 0.5 * high, x + 0.5 * wide, y + 0.5 * high)
        box = freest_box([over, *boxes_around((x, y), (wide, high))], taken, inside, 0.1)
        taken.append(box)
        middle = 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])
        if box is not over:
            axes.plot([x, middle[0]], [y, middle[1]], color=INK, linewidth=0.5, zorder=6)
            axes.plot([x], [y], "o", color=INK, markersize=1.8, zorder=6)
        frame = {"boxstyle": "round,pad=0.18", "facecolor": "white", "edgecolor": label.colour, "linewidth": 0.5}
        axes.text(
            *middle, label.text, ha="center", va="center", fontsize=SIZE, color=label.colour, bbox=frame, zorder=7
        )


def boxes_around(point: tuple[float, float], size: tuple[float, float]) -> list[Box]:
    """Return places for a name of a size beside a point [pt], nearest first."""
    (x, y), (wide, high) = point, size
    made = []
    for far, (right, up) in product(DISTANCES, WAYS):
        step = far if right == 0 or up == 0 else 0.6 * far
        left, low = x + right * step - wide * (1 - right) / 2, y + up * step - high * (1 - up) / 2
        made.append((left, low, left + wide, low + high))
    return made


def freest_box(boxes: Sequence[Box], taken: Sequence[Box], inside: Box, step: float) -> Box:
    """Return the box that covers the least area of others and outside the panel; each later one counts `step` more."""

    def cost(place: int) -> float:
        outside = overlap(boxes[place], boxes[place]) - overlap(boxes[place], inside)
        return sum(overlap(boxes[place], other) for other in taken) + 3.0 * outside + step * place

    return boxes[min(range(len(boxes)), key=cost)]


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
