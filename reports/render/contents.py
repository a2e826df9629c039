"""The contents: a line for each chapter and mechanism, with a link to it, dots and the number of its page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil

from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable
from reportlab.platypus import Table as Grid

from reports.render.page import DeferredCanvas, Heading
from reports.render.typeset import BARE, STYLES, cut_to_width, set_letters, width_of

COLUMN = 10  # lines up to which they stand in one column
_STYLE = "contents"
_FOR_NUMBER, _GAP = 27.0, 14.0  # left for dots and number; between two columns [pt]
_DOT = " ."


class Entry(Flowable):
    """The line of one heading. numbers: of the pages by the headings' keys, complete when the pages are."""

    def __init__(self, heading: Heading, numbers: Mapping[str, int]) -> None:
        super().__init__()
        self.heading, self.numbers = heading, numbers

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        self.width, self.height = aW, STYLES[_STYLE].leading
        return self.width, self.height

    def draw(self) -> None:
        canvas = self.canv
        assert isinstance(canvas, DeferredCanvas)  # the only one that write_pdf makes
        set_letters(canvas, _STYLE)
        text = cut_to_width(self.heading.short, self.width - _FOR_NUMBER, _STYLE)
        canvas.drawString(0, self.height - STYLES[_STYLE].fontSize, text)
        canvas.linkRect("", self.heading.key, (0.0, 0.0, self.width, self.height), relative=1)
        self.free = self.width - width_of(text, _STYLE)
        canvas.later(f"page-of-{self.heading.key}", self._number)

    def _number(self, canvas: Canvas) -> None:
        """Draw dots and number at the right end."""
        set_letters(canvas, _STYLE)
        number = f" {self.numbers[self.heading.key]}"
        dots = _DOT * int((self.free - width_of(number, _STYLE)) / width_of(_DOT, _STYLE))
        canvas.drawRightString(self.width, self.height - STYLES[_STYLE].fontSize, dots + number)


def contents(headings: Sequence[Heading], numbers: Mapping[str, int], width: float) -> Flowable:
    """Return the lines of the chapters and of the mechanisms, in two columns where they are many."""
    entries = [Entry(each, numbers) for each in headings if each.level == 0]
    high = len(entries) if len(entries) <= COLUMN else ceil(len(entries) / 2)
    rows = [[entries[place], *entries[place + high : place + high + 1]] for place in range(high)]
    wide = (width - _GAP) / 2
    if high == len(entries):
        return Grid(rows, colWidths=[width], style=BARE)
    whole = [[*row, "", ""][:2] for row in rows]
    return Grid([[one, "", other] for one, other in whole], colWidths=[wide, _GAP, wide], style=BARE)
