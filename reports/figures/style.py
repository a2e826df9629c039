"""One look for all figures: letters, line widths, and a colour for each procedure that the colour-blind can tell apart.

Colours after Okabe and Ito (2008). A procedure has the same colour and line in every figure; informative readings
are dashed.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from io import BytesIO
from textwrap import wrap
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.figure import Figure

from reports.figures.font import FAMILY, printable
from reports.figures.ticks import localise_ticks
from reports.language.lettering import truncate, truncate_middle
from reports.language.locale import Locale

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
            localise_ticks(axes.xaxis, self.locale)
            localise_ticks(axes.yaxis, self.locale)
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
