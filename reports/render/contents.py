"""The contents: a line for each heading, with a link to it, dots and the number of its page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from reportlab.lib.colors import HexColor
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable

from reports.figures.style import INK, MUTED
from reports.render.cells import draw_cells, plain_cell
from reports.render.page import DeferredCanvas, Heading
from reports.render.typeset import STYLES, width_of

LONGEST = 48  # sections; of a longer report only the chapters are listed, the bookmarks have all
_STYLES, _COLOURS, _INDENTS = ("contents-0", "contents-1"), (INK, MUTED), (0.0, 14.0)
_ABOVE, _FOR_NUMBER = 2.6, 24.0  # [pt]
_DOT = " . "


class Entry(Flowable):
    """The line of one heading. numbers: of the pages by the headings' keys, complete when the pages are."""

    def __init__(self, heading: Heading, numbers: Mapping[str, int]) -> None:
        super().__init__()
        self.heading, self.numbers = heading, numbers
        self.style, self.indent = _STYLES[heading.level], _INDENTS[heading.level]

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        self.cell = plain_cell(self.heading.short, self.style, width=aW - self.indent - _FOR_NUMBER)
        self.width, self.height = aW, self.cell.height + _ABOVE
        return self.width, self.height

    def draw(self) -> None:
        canvas = self.canv
        assert isinstance(canvas, DeferredCanvas)  # the only one that write_pdf makes
        draw_cells(canvas, [(self.cell, self.indent, self.cell.height)])
        canvas.linkRect("", self.heading.key, (0.0, 0.0, self.width, self.cell.height), relative=1)
        canvas.later(f"page-of-{self.heading.key}", self._number)

    def _number(self, canvas: Canvas) -> None:
        """Draw dots and number at the right end of the last line."""
        number = str(self.numbers[self.heading.key])
        free = self.width - self.indent - self.cell.lines[-1].width - width_of(number, self.style)
        of = STYLES[self.style]
        canvas.setFont(of.fontName, of.fontSize)
        canvas.setFillColor(HexColor(_COLOURS[self.heading.level]))
        dots = _DOT * int(free / width_of(_DOT, self.style))
        canvas.drawRightString(self.width, of.leading - of.fontSize, dots + number)


def contents(headings: Sequence[Heading], numbers: Mapping[str, int]) -> list[Flowable]:
    """Return the lines of all headings, or of the chapters alone."""
    every = len(headings) <= LONGEST
    return [Entry(each, numbers) for each in headings if every or each.level == 0]
