"""The page: margins, running head, foot with "page x of y", bookmarks."""

from __future__ import annotations

import datetime
from collections.abc import Callable
from pathlib import Path
from typing import Any

from reportlab.lib.colors import HexColor
from reportlab.lib.pagesizes import A4, LETTER
from reportlab.lib.units import mm
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import BaseDocTemplate, Flowable, Frame, PageTemplate, Paragraph

from reports.document import Document, Section
from reports.figures.font import printable
from reports.figures.style import GRID
from reports.language.lettering import truncate
from reports.language.locale import Locale
from reports.language.texts import count, say
from reports.render.frame_words import origin
from reports.render.typeset import REGULAR, STYLES, cut_to_width, markup, set_letters, width_of

PAPER = {"A4": A4, "letter": LETTER}
_SIDE, _TOP, _BOTTOM = 18 * mm, 19 * mm, 17 * mm
_HEAD, _FOOT = 5 * mm, 10 * mm  # of the running head above the text, of the foot above the edge
_LONGEST, _RUNNING = 90, 40  # letters of a heading in the bookmarks, of each part of the running head
_RUNNING_SHARE, _GAP = 0.6, 12.0  # of the line, beside the title; between them [pt]


def pdf_date(date: str) -> str:
    """Return a date like 2026-05-12 as the properties of a PDF have it; empty for one that is not written so."""
    try:
        return f"D:{datetime.date.fromisoformat(date):%Y%m%d}000000Z"
    except ValueError:
        return ""


class DeferredCanvas(Canvas):
    """A canvas on which room is left for what is known only when all pages are there: one pass over them is enough."""

    def __init__(self, *given: Any, **named: Any) -> None:
        super().__init__(*given, **named)
        self._late: dict[str, Callable[[Canvas], None]] = {}

    def later(self, name: str, draw: Callable[[Canvas], None]) -> None:
        """Show here what `draw` draws at the end, within a page from the present origin on; name: used once."""
        self._late[name] = draw
        self.doForm(name)

    def save(self) -> None:
        """Draw what was left for later, and write the file."""
        for name, draw in self._late.items():
            self.beginForm(name)
            draw(self)
            self.endForm()
        super().save()


class Heading(Paragraph):
    """A section heading, which `Pages` puts into the contents and the bookmarks.

    short : the text for contents and bookmarks
    key : of its place in the file
    """

    def __init__(self, section: Section, locale: Locale, key: str) -> None:
        text = " ".join(part for part in (section.mark, locale.text(section.title)) if part)
        super().__init__(markup(truncate(text, 2 * _LONGEST)), STYLES[f"heading-{min(section.level, 1)}"])
        self.short, self.level, self.key = truncate(printable(text), _LONGEST), section.level, key

    def split(self, aW: float, aH: float) -> list[Flowable]:
        """Return nothing: a heading goes to the next page whole."""
        return []


class Pages(BaseDocTemplate):
    """The document template. numbers: of the pages of the headings, by their keys, as they become known."""

    def __init__(self, path: Path, document: Document, locale: Locale) -> None:
        self.document, self.locale = document, locale
        self.numbers: dict[str, int] = {}
        self._depth = -1
        text = locale.text
        super().__init__(
            str(path),
            pagesize=PAPER[document.paper],
            leftMargin=_SIDE,
            rightMargin=_SIDE,
            topMargin=_TOP,
            bottomMargin=_BOTTOM,
            title=truncate(printable(text(document.title)), 200),
            author=truncate(printable(document.author), 200),
            subject=printable(text(document.subject)),
            creator=printable(text(origin(document))),
            producer=document.program,
            invariant=1,
            lang=locale.language,
            initialFontName=REGULAR,
            pageCompression=1,
        )
        frame = Frame(_SIDE, _BOTTOM, self.width, self.height, 0, 0, 0, 0, id="text")
        self.addPageTemplates(PageTemplate("page", [frame], onPage=self._furniture))

    def afterFlowable(self, flowable: object) -> None:  # noqa: N802 - reportlab's name
        """Enter a heading into contents and bookmarks."""
        if isinstance(flowable, Heading):
            self._depth = min(flowable.level, self._depth + 1)  # a bookmark is at most one below the one before
            self.canv.bookmarkPage(flowable.key)
            self.canv.addOutlineEntry(flowable.short, flowable.key, self._depth, closed=self._depth)
            self.numbers[flowable.key] = self.page

    def _furniture(self, canvas: Canvas, _: object) -> None:
        assert isinstance(canvas, DeferredCanvas)  # the only one that write_pdf makes
        made = pdf_date(self.document.date)
        if made:
            canvas.setDateFormatter(lambda *_: made)
        left, right, head = _SIDE, _SIDE + self.width, _BOTTOM + self.height + _HEAD
        text, document, page = self.locale.text, self.document, self.page
        canvas.saveState()
        set_letters(canvas, "running")
        canvas.setStrokeColor(HexColor(GRID))
        said = [truncate(printable(each), _RUNNING) for each in map(text, document.running) if each]
        running = cut_to_width(" · ".join(said), _RUNNING_SHARE * self.width, "running")
        room = self.width - width_of(running, "running") - _GAP
        canvas.drawString(left, head, cut_to_width(printable(text(document.title)), room, "running"))
        canvas.drawRightString(right, head, running)
        canvas.line(left, head - 3.5, right, head - 3.5)
        canvas.drawString(left, _FOOT, truncate(printable(text(origin(document))), _LONGEST))
        canvas.later(f"number-{page}", lambda canvas: self._number(canvas, page))
        canvas.restoreState()

    def _number(self, canvas: Canvas, page: int) -> None:
        """Draw the number of a page, when the last page has its number."""
        set_letters(canvas, "running")
        number = say("page {page} of {total}", page=count(page), total=count(self.page))
        canvas.drawRightString(_SIDE + self.width, _FOOT, self.locale.text(number))
