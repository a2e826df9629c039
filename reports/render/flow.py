"""How the parts of a document share out the pages: what stays together, where a page begins, what is made to fit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain

from reportlab.lib.units import mm
from reportlab.platypus import CondPageBreak, Flowable, KeepTogether

from reports.render.pdf_blocks import Drawing
from reports.render.pdf_tables import Rows

ROOM = 24 * mm
"""What a heading and its first lines, or a table after its first row, need on a page, or go to the next."""
_LEFT = 0.75  # share of a page below which a section that asks for a page begins a new one
_SMALLEST = 0.7  # reduction of figures
_SLACK = 8.0  # of a page that is filled to its end: spaces that the parts put between each other [pt]


@dataclass(frozen=True)
class Part:
    """Flowables that follow each other.

    is_whole : on one page
    needs_room : begins where there is `ROOM`, and more before a table that starts with a high row
    """

    flowables: list[Flowable]
    is_whole: bool = False
    needs_room: bool = False

    def place(self) -> Iterator[Flowable]:
        """Yield what the part puts into the story."""
        if self.is_whole:
            yield KeepTogether(self.flowables)
            return
        if self.needs_room:
            starts = (flowable.start for flowable in self.flowables if isinstance(flowable, Rows))
            yield Room(ROOM + max(starts, default=0.0), self.flowables)
        yield from self.flowables


class Room(CondPageBreak):
    """Begins a page where there is neither this room [pt] nor enough for all that follows."""

    def __init__(self, height: float, flowables: Sequence[Flowable]) -> None:
        super().__init__(height)
        self.flowables = flowables

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        self.height = min(self.height, height_of(self.flowables, aW, self.height))
        width, height = super().wrap(aW, aH)
        return float(width), float(height)


def height_of(flowables: Sequence[Flowable], width: float, limit: float) -> float:
    """Return the height of flowables one below the other [pt]; some value beyond `limit` where it is higher."""
    height = space = 0.0
    for flowable in flowables:
        height += flowable.wrap(width, limit)[1] + max(space, flowable.getSpaceBefore())
        space = flowable.getSpaceAfter()
        if height > limit:
            break
    return height


class PageStart(CondPageBreak):
    """Begins a page, unless this one is nearly empty.

    Where the parts after it need a little more than the page, their figures are reduced until it has room for all.
    """

    def __init__(self, page: float, parts: Sequence[Part], drawings: Sequence[Drawing]) -> None:
        super().__init__(_LEFT * page)
        self.page, self.drawings = page, drawings
        self.flowables = list(chain.from_iterable(part.flowables for part in parts))

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        if aH >= self.height and self._needs_a_page(aW, aH):
            self.height = self.page
        if self.drawings:
            self._reduce(aW, (self.page if aH < self.height else aH) - _SLACK)
        width, height = super().wrap(aW, aH)
        return float(width), float(height)

    def _needs_a_page(self, width: float, room: float) -> bool:
        """Return whether all parts fit on a page of their own and not on what is left of this one."""
        return room < self._height(width, _SMALLEST, 1.5 * self.page) <= self.page

    def _reduce(self, width: float, room: float) -> None:
        whole = self._height(width, 1.0, 1.5 * room)
        if whole <= room or whole > 1.5 * room:
            return
        least = self._height(width, _SMALLEST, 1.5 * room)
        share = (room - least) / (whole - least) if least <= room and least < whole else 1.0
        self._set(_SMALLEST + (1 - _SMALLEST) * share)

    def _height(self, width: float, reduction: float, limit: float) -> float:
        """Return the height of all parts [pt] with figures so reduced; some value beyond `limit` where it is higher."""
        self._set(reduction)
        return height_of(self.flowables, width, limit)

    def _set(self, reduction: float) -> None:
        for drawing in self.drawings:
            drawing.reduction = reduction
