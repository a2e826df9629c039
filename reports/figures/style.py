"""What all figures share: sheets, letters, ticks, units of axes, names of points, and pens.

Colours after Okabe and Ito (2008), which the colour-blind can tell apart. A procedure has the same colour and line in
every figure; informative readings are dashed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from itertools import product
from pathlib import Path
from textwrap import wrap
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backend_bases import RendererBase
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.ft2font import FT2Font
from matplotlib.textpath import text_to_path
from matplotlib.ticker import Formatter, LogFormatter, LogLocator, NullLocator, ScalarFormatter
from numpy.typing import ArrayLike

from assess.results import Results
from reports.language.locale import UNITS, Locale, Unit, character_code, truncate, truncate_middle, visible
from reports.language.texts import Text
from reports.mechanisms import group_variants
from spectra.arrays import FloatArray

WIDTH = 6.7  # of the text on the page [in]
HALF = 3.3  # of a figure beside another [in]
NOTEBOOK_DPI = 130
INK, MUTED, GRID, PAPER = "#1b2733", "#6b7680", "#d7dce1", "#f3f5f7"
PASS, FAIL = "#00694c", "#b3380e"
BANNER = {"pass": PASS, "fail": FAIL, "incomplete": "#8a6100"}
VERDICT = {"pass": "#9fd3bf", "fail": "#d8694a", "incomplete": "#ecd08a"}  # of masonry, apart in grey too
STONE_EDGE, LOAD = "#6f6350", "#6b4c9a"
POSITIVE, NEGATIVE = "#c1121f", "#0072b2"  # the branches
MECHANISMS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#6b4c9a", "#8c6d31", "#000000")
BLOCKS = ("#d9cdb8", "#a8977a", "#efe8db")  # from the base upwards, distinct in grey too
FIXED = "#dfe2e5"  # masonry that does not move
FAMILY = "DejaVu Sans"

_RC: dict[Any, Any] = {
    "font.family": [FAMILY],
    "font.size": 7,
    "axes.titlesize": 7,
    "axes.labelsize": 7,
    "axes.linewidth": 0.6,
    "axes.edgecolor": MUTED,
    "axes.labelcolor": INK,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.use_mathtext": False,
    "axes.formatter.limits": (-4, 5),
    "grid.color": GRID,
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.2,
    "legend.fontsize": 6.5,
    "legend.borderpad": 0.2,
    "legend.handlelength": 1.8,
    "legend.columnspacing": 1.2,
    "legend.labelspacing": 0.3,
    "legend.frameon": False,
    "figure.constrained_layout.w_pad": 0.02,
    "figure.constrained_layout.h_pad": 0.03,
    "text.color": INK,
    "text.parse_math": False,
    "text.hinting": "none",  # letters measured as they are drawn
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.labelsize": 6.5,
    "ytick.labelsize": 6.5,
    "svg.hashsalt": "assess",
    "svg.fonttype": "path",
    "figure.dpi": 72,
}


@dataclass(frozen=True)
class Pen:
    """How a procedure or a mechanism is drawn. width: of its line [pt]."""

    colour: str
    dash: str
    marker: str
    width: float = 1.2


PROCEDURES: dict[str, Pen] = {
    "asce43-05-spectrum": Pen("#0072b2", "-", "o"),
    "asce43-05-spectrum-thesis": Pen("#56b4e9", "--", "o"),
    "asce43-05-history": Pen("#000000", "-", "D"),
    "dmi2008-linear": Pen("#e69f00", "-", "s"),
    "dmi2008-nonlinear": Pen("#d55e00", "-", "^"),
    "dmi2008-nonlinear-thesis": Pen("#d55e00", "--", "^"),
    "dmi2008-history": Pen("#8c564b", "-.", "D"),
    "ntc2018-linear": Pen("#cc79a7", "-", "s"),
    "ntc2018-nonlinear": Pen("#009e73", "-", "v"),
    "ntc2018-history": Pen("#6b4c9a", "-.", "D"),
    "nzsee2017-face-loaded": Pen("#117733", "-", "P"),
    "asce41-13-ht": Pen("#882255", "-", "X"),
    "ec8-element": Pen("#44aa99", "-", "p"),
    "asce43-05-sliding": Pen("#5c6b00", "-", "P"),
    "sliding": Pen("#5c6b00", "-.", "X"),
}
_OTHER = Pen(MUTED, ":", "x")


def pen(procedure: str) -> Pen:
    """Return the pen of a procedure; grey and dotted for one that is not in the table."""
    return PROCEDURES.get(procedure, _OTHER)


@contextmanager
def report_style() -> Iterator[None]:
    """Make and draw figures in the report's style within this context."""
    with matplotlib.rc_context(_RC):
        yield


def sheet(height: float, locale: Locale, *, width: float = WIDTH) -> Figure:
    """Return an empty figure of `width` x `height` [in] that lays itself out; made within `report_style`."""
    return _Sheet(locale, figsize=(width, height), layout="constrained")


def bare_sheet(height: float, locale: Locale, *, width: float = WIDTH) -> Figure:
    """Return an empty figure of `width` x `height` [in] whose axes are placed by hand; made within `report_style`."""
    return _Sheet(locale, figsize=(width, height))


class _Sheet(Figure):
    """A figure in the report's style and with the numbers of a locale wherever it is drawn."""

    def __init__(self, locale: Locale, **given: Any) -> None:
        super().__init__(**given)
        self.locale = locale

    def draw(self, renderer: RendererBase) -> None:
        """Lay the figure out and draw it."""
        for axes in self.axes:
            _localise_ticks(axes.xaxis, self.locale)
            _localise_ticks(axes.yaxis, self.locale)
        with report_style():
            super().draw(renderer)

    def _repr_png_(self) -> bytes:
        """Show the figure in a notebook."""
        file = BytesIO()
        self.savefig(file, format="png", dpi=NOTEBOOK_DPI)
        return file.getvalue()


def shade(block: int) -> str:
    """Return the colour of a block, from 0 at the base; grey where it does not move."""
    return FIXED if block < 0 else BLOCKS[block % len(BLOCKS)]


def legend_below(figure: Figure, *, columns: int, axes: Axes | None = None) -> None:
    """Put one legend below all axes, where it covers no curve. axes: whose names it has, the first without it."""
    handles, names = (axes or figure.axes[0]).get_legend_handles_labels()
    if handles:
        figure.legend(handles, names, loc="outside lower center", ncols=columns)


def legend_above(axes: Axes, *, columns: int) -> None:
    """Put a legend above the panel, where it covers no curve."""
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), borderaxespad=0.1, ncols=columns)


def label(text: str, limit: int = 40) -> str:
    """Return user text for a figure: printable, and no longer than `limit` characters."""
    return truncate(printable(text), limit)


def record_label(text: str, limit: int) -> str:
    """Return the name of a record for a figure, shortened in the middle."""
    return truncate_middle(printable(text), limit)


def fold(text: str, *, width: int, lines: int = 2) -> str:
    """Fold user text into a label of several lines of at most `width` characters."""
    return "\n".join(wrap(printable(text), width, max_lines=lines, placeholder="…"))


MECHANISM_DASHES = ("-", "--", ":", "-.")
MECHANISM_WIDTHS = (1.2, 2.2, 0.6)  # of lines [pt], of mechanisms that share a colour by chance


def mechanism_pens(results: Results) -> dict[str, Pen]:
    """Return how each mechanism is drawn: those that differ by their joints alone in one colour, each with a dash."""
    made = {}
    for place, group in enumerate(group_variants(results)):
        colour, width = (
            MECHANISMS[place % len(MECHANISMS)],
            MECHANISM_WIDTHS[place // len(MECHANISMS) % len(MECHANISM_WIDTHS)],
        )
        for number, mechanism in enumerate(group):
            made[mechanism.name] = Pen(colour, MECHANISM_DASHES[number % len(MECHANISM_DASHES)], "", width)
    return made


TICK_FIGURES = 3


class LinearTicks(ScalarFormatter):
    """As many decimals as the ticks need, all alike."""

    def __init__(self, locale: Locale) -> None:
        super().__init__(useOffset=False, useMathText=False, useLocale=False)
        self.point = locale.point

    def __call__(self, x: float, pos: Any = None) -> str:
        """Return the number of a tick."""
        return super().__call__(x, pos).replace(".", self.point)

    def get_offset(self) -> str:
        """Return the power of ten by which the ticks are multiplied, empty for none."""
        return super().get_offset().replace(".", self.point)


class LogTicks(Formatter):
    """Numbers as they are read, 0.02 and not a power of ten."""

    def __init__(self, locale: Locale) -> None:
        self.locale = locale

    def __call__(self, x: float, pos: Any = None) -> str:
        """Return the number of a tick."""
        return self.locale.number(x, figures=TICK_FIGURES)


def number_by_decades(axis: Axis, locale: Locale) -> None:
    """Give a logarithmic axis numbers at 1, 2 and 5 of each decade."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(LogTicks(locale))


@dataclass(frozen=True)
class Scale:
    """The unit in which an axis shows values in SI."""

    unit: Unit
    locale: Locale

    def in_unit(self, values: ArrayLike) -> FloatArray:
        """Return values in SI as numbers of the unit."""
        return np.asarray(values, dtype=np.float64) / self.unit.size

    def heading(self, label: Text) -> str:
        """Return the label of the axis with its unit: "rotation φ [rad]"."""
        return f"{self.locale.text(label)} [{self.locale.unit_name(self.unit) or '-'}]"


def table_scale(dimension: str, locale: Locale) -> Scale:
    """Return the scale in the unit that tables have."""
    return Scale(locale.table_unit(dimension), locale)


def fitting_scale(dimension: str, values: Sequence[float], locale: Locale) -> Scale:
    """Return the scale in the unit in which the largest of the values is written."""
    largest = max((abs(value) for value in values if np.isfinite(value)), default=0.0)
    return Scale(UNITS[locale.system][dimension].unit_for(largest), locale)


Box = tuple[float, float, float, float]  # left, bottom, right, top [pt]
LABEL_SIZE = 6.5  # of the letters [pt]
LABEL_MARK = 4.0  # half the width of what is drawn at a point [pt]
LABEL_DISTANCES = (7.0, 13.0, 22.0, 34.0, 48.0)  # from a point to its name [pt]
LABEL_SIDES = ((1, 1), (-1, 1), (1, -1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1))
LABEL_PADDING = 2.0  # between the letters of a name and its box [pt]
LABEL_LEADER = 20.0  # a name farther off than this has a line to its point [pt]


@dataclass(frozen=True)
class Label:
    """A name for a point of the axes; an empty one keeps its point free of other names."""

    text: str
    at: tuple[float, float]
    colour: str = INK


def write_labels(axes: Axes, labels: Sequence[Label]) -> None:
    """Write the labels, each where it covers least. The figure has 72 dots to the inch."""
    left, low, right, high = axes.get_window_extent().extents
    places = axes.transData.transform([label.at for label in labels]).tolist()
    taken = [(x - LABEL_MARK, y - LABEL_MARK, x + LABEL_MARK, y + LABEL_MARK) for x, y in places]
    leader = {"arrowstyle": "-", "color": MUTED, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 3}
    for label, place in zip(labels, places, strict=True):
        if label.text:
            box = _freest_box(_boxes_around(place, text_extent(label.text)), taken, (left, low, right, high), 0.5)
            taken.append(box)
            offset = box[0] - place[0], box[1] - place[1]
            axes.annotate(
                label.text,
                label.at,
                xytext=offset,
                textcoords="offset points",
                color=label.colour,
                fontsize=LABEL_SIZE,
                annotation_clip=False,
                arrowprops=leader if max(map(abs, offset)) > LABEL_LEADER else None,
            )


def write_tags(axes: Axes, labels: Sequence[Label]) -> None:
    """Write each label in a white box over its point, or beside it with a line where another box is there already.

    The axes are in points.
    """
    inside, taken = (0.0, 0.0, axes.get_xlim()[1], axes.get_ylim()[1]), list[Box]()
    for label in labels:
        (x, y), (wide, high) = label.at, (side + 2 * LABEL_PADDING for side in text_extent(label.text))
        over = (x - 0.5 * wide, y - 0.5 * high, x + 0.5 * wide, y + 0.5 * high)
        box = _freest_box([over, *_boxes_around((x, y), (wide, high))], taken, inside, 0.1)
        taken.append(box)
        middle = 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])
        if box is not over:
            axes.plot([x, middle[0]], [y, middle[1]], color=INK, linewidth=0.5, zorder=6)
            axes.plot([x], [y], "o", color=INK, markersize=1.8, zorder=6)
        frame = {"boxstyle": "round,pad=0.18", "facecolor": "white", "edgecolor": label.colour, "linewidth": 0.5}
        axes.text(
            *middle, label.text, ha="center", va="center", fontsize=LABEL_SIZE, color=label.colour, bbox=frame, zorder=7
        )


def box_overlap(one: Box, other: Box) -> float:
    """Return the area that two boxes share [pt2]."""
    wide = min(one[2], other[2]) - max(one[0], other[0])
    high = min(one[3], other[3]) - max(one[1], other[1])
    return max(wide, 0.0) * max(high, 0.0)


def text_extent(text: str) -> tuple[float, float]:
    """Return width and height of a line of letters [pt]."""
    font = FontProperties(family=FAMILY, size=LABEL_SIZE)
    wide, high, _ = text_to_path.get_text_width_height_descent(text, font, ismath=False)
    return wide, max(high, 0.75 * LABEL_SIZE)


_FONT_FILES = {"regular": "DejaVuSans.ttf", "bold": "DejaVuSans-Bold.ttf", "italic": "DejaVuSans-Oblique.ttf"}


def font_file(face: str) -> Path:
    """Return the path of the font `face` ("regular", "bold", "italic"), as matplotlib ships it."""
    return Path(matplotlib.get_data_path()) / "fonts" / "ttf" / _FONT_FILES[face]


def printable(text: str) -> str:
    """Return `visible` text with characters that the font lacks, or a PDF font cannot map, shown as their code too."""
    if text.isascii() and text.isprintable():
        return text
    known = _glyphs()
    return "".join(
        mark if ord(mark) in known and ord(mark) <= 0xFFFF else character_code(mark) for mark in visible(text)
    )


def _localise_ticks(axis: Axis, locale: Locale) -> None:
    """Give an axis that matplotlib would number by itself the numbers of a locale; labels that were set stay."""
    given = axis.get_major_formatter()
    if type(given) is ScalarFormatter:
        axis.set_major_formatter(LinearTicks(locale))
    elif isinstance(given, LogFormatter):
        axis.set_major_formatter(LogTicks(locale))


def _boxes_around(point: tuple[float, float], size: tuple[float, float]) -> list[Box]:
    """Return places for a name of a size beside a point [pt], nearest first."""
    (x, y), (wide, high) = point, size
    made = []
    for far, (right, up) in product(LABEL_DISTANCES, LABEL_SIDES):
        step = far if right == 0 or up == 0 else 0.6 * far
        left, low = x + right * step - wide * (1 - right) / 2, y + up * step - high * (1 - up) / 2
        made.append((left, low, left + wide, low + high))
    return made


def _freest_box(boxes: Sequence[Box], taken: Sequence[Box], inside: Box, step: float) -> Box:
    """Return the box that covers the least area of others and outside the panel; each later one counts `step` more."""

    def cost(place: int) -> float:
        outside = box_overlap(boxes[place], boxes[place]) - box_overlap(boxes[place], inside)
        return sum(box_overlap(boxes[place], other) for other in taken) + 3.0 * outside + step * place

    return boxes[min(range(len(boxes)), key=cost)]


@cache
def _glyphs() -> frozenset[int]:
    faces = [FT2Font(str(font_file(face))) for face in _FONT_FILES]
    return frozenset.intersection(*(frozenset(face.get_charmap()) for face in faces))
