"""A table on the page: its caption and its head on every page, a rule below each row, split between rows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate

from reportlab.lib.colors import HexColor
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable

from reports.figures.style import GRID, INK, MUTED
from reports.render.cells import Cell, draw_cells
from reports.render.typeset import Lines

PADDING = 5.0  # of a cell, left and right together; lengths in points
_ABOVE, _BELOW, _BELOW_CAPTION = 1.6, 2.2, 4.0
_LEAST_CAPTION = 12.0
_FILLING = "#edf0f3"
_FEWEST_FIRST, _FEWEST_LAST = 2, 3  # rows before and after a break of the page
_TALL = 100.0  # a row: in a table with such a row any may be alone on a page, which a few fill
_ROUND = 1

Row = Sequence[Cell]


@dataclass(frozen=True)
class _Body:
    """What a table shows below its caption.

    lefts : of the columns [pt]
    ends : whether the last row is that of the whole table
    """

    head: Row
    rows: tuple[Row, ...]
    lefts: tuple[float, ...]
    ends: bool = True

    @property
    def heights(self) -> list[float]:
        """The heights of the head and each row [pt]."""
        return [max(cell.height for cell in row) + _ABOVE + _BELOW for row in (self.head, *self.rows)]


class RuledTable(Flowable):
    """A table; reportlab's own takes four times as long, for what it can do besides."""

    def __init__(self, caption: Lines, body: _Body, *, width: float) -> None:
        super().__init__()
        self.caption, self.body, self.width = caption, body, width
        self.hAlign, self.spaceBefore, self.spaceAfter = "LEFT", 4, 11
        _, self.high = caption.wrap(width - PADDING / 2, 0.0)
        self.heights = [max(self.high, _LEAST_CAPTION) + _ABOVE + _BELOW_CAPTION, *body.heights]
        self.height = sum(self.heights)

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        return self.width, self.height

    def split(self, aW: float, aH: float) -> list[Flowable]:
        """Split the table in two, with as many rows in the first as fit; empty where none do."""
        rows = self.body.rows
        room = sum(end <= aH for end in accumulate(self.heights)) - 2
        if room >= len(rows):
            return [self]
        first, last = (1, 1) if max(self.heights[1:]) > _TALL else (_FEWEST_FIRST, _FEWEST_LAST)
        kept = min(room, len(rows) - last)
        if kept < first:
            return []
        parts = (replace(self.body, rows=rows[:kept], ends=False), replace(self.body, rows=rows[kept:]))
        return [RuledTable(self.caption, part, width=self.width) for part in parts]

    def draw(self) -> None:
        canvas: Canvas = self.canv
        caption, *heights = self.heights
        self.caption.drawOn(canvas, 0.0, self.height - _ABOVE - self.high)
        tops = list(accumulate(heights, lambda top, high: top - high, initial=self.height - caption))
        canvas.saveState()
        canvas.setFillColor(HexColor(_FILLING))
        canvas.rect(0.0, tops[1], self.width, tops[0] - tops[1], stroke=0, fill=1)
        draw_cells(canvas, self._placed(tops))
        self._rules(tops)
        canvas.restoreState()

    def _placed(self, tops: Sequence[float]) -> Iterator[tuple[Cell, float, float]]:
        """Yield each cell by its upper left corner."""
        for row, top in zip((self.body.head, *self.body.rows), tops, strict=False):
            for cell, left in zip(row, self.body.lefts, strict=True):
                yield cell, left + PADDING / 2, top - _ABOVE

    def _rules(self, tops: Sequence[float]) -> None:
        first, below_head, *below_rows = tops
        self.canv.setLineCap(_ROUND)
        self._rule([first], INK, thick=0.8)
        self._rule([below_head], MUTED, thick=0.5)
        self._rule(below_rows, GRID, thick=0.3)
        self._rule(below_rows[-1:] if self.body.ends else [], MUTED, thick=0.5)

    def _rule(self, heights: Iterable[float], colour: str, *, thick: float) -> None:
        self.canv.setStrokeColor(HexColor(colour))
        self.canv.setLineWidth(thick)
        for y in heights:
            self.canv.line(0.0, y, self.width, y)


def ruled_table(caption: Lines, head: Row, rows: Sequence[Row], *, widths: Sequence[float]) -> RuledTable:
    """Return a table whose columns are `widths` [pt] wide."""
    *lefts, width = accumulate(widths, initial=0.0)
    return RuledTable(caption, _Body(head, tuple(rows), tuple(lefts)), width=width)
