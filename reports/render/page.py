"""The page: margins, header, footer with "page x of y", bookmarks."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from reportlab.lib.colors import HexColor
from reportlab.lib.pagesizes import A4, LETTER
from reportlab.lib.units import mm
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import BaseDocTemplate, Flowable, Frame, PageTemplate

from reports.document import Document
from reports.figures.font import printable
from reports.figures.style import GRID, MUTED
from reports.language.lettering import truncate
from reports.render.typeset import REGULAR, STYLES, paragraph

PAPER = {"A4": A4, "letter": LETTER}
_SIDE, _TOP, _BOTTOM = 18 * mm, 22 * mm, 20 * mm
PAGE = "page {page} of {total}"
_LONGEST_ENTRY = 90


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


class Heading(Flowable):
    """A section heading that puts itself into the contents and the bookmarks."""

    def __init__(self, text: str, *, level: int, key: str) -> None:
        super().__init__()
        self.text, self.level, self.key = truncate(text, 2 * _LONGEST_ENTRY), level, key
        self._shape = paragraph(self.text, f"heading-{level}")

    @property
    def short(self) -> str:
        """The text for contents and bookmarks."""
        return truncate(printable(self.text), _LONGEST_ENTRY)

    def getSpaceBefore(self) -> float:  # noqa: N802 - reportlab's name
        return float(STYLES[f"heading-{self.level}"].spaceBefore)

    def getSpaceAfter(self) -> float:  # noqa: N802 - reportlab's name
        return float(STYLES[f"heading-{self.level}"].spaceAfter)

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        width, height = self._shape.wrap(aW, aH)
        return float(width), float(height)

    def draw(self) -> None:
        self._shape.drawOn(self.canv, 0, 0)


class Pages(BaseDocTemplate):
    """The document template. numbers: of the pages of the headings, by their keys, as they become known."""

    def __init__(self, path: Path, document: Document) -> None:
        self.document = document
        self.numbers: dict[str, int] = {}
        super().__init__(
            str(path),
            pagesize=PAPER[document.paper],
            leftMargin=_SIDE,
            rightMargin=_SIDE,
            topMargin=_TOP,
            bottomMargin=_BOTTOM,
            title=truncate(printable(document.title), 200),
            author=truncate(printable(document.author), 200),
            subject=document.subject,
            creator=document.origin,
            producer=document.program,
            invariant=1,
            lang=document.language,
            initialFontName=REGULAR,
            pageCompression=1,
        )
        frame = Frame(_SIDE, _BOTTOM, self.width, self.height, 0, 0, 0, 0, id="text")
        self.addPageTemplates(PageTemplate("page", [frame], onPage=self._furniture))

    def afterFlowable(self, flowable: Flowable) -> None:  # noqa: N802 - reportlab's name
        """Enter a heading into contents and bookmarks."""
        if isinstance(flowable, Heading):
            self.canv.bookmarkPage(flowable.key)
            self.canv.addOutlineEntry(flowable.short, flowable.key, flowable.level, closed=flowable.level)
            self.numbers[flowable.key] = self.page

    def _furniture(self, canvas: Canvas, _: object) -> None:
        assert isinstance(canvas, DeferredCanvas)  # the only one that write_pdf makes
        left, right, head = _SIDE, _SIDE + self.width, _BOTTOM + self.height + 8 * mm
        canvas.saveState()
        _small(canvas)
        canvas.setStrokeColor(HexColor(GRID))
        canvas.drawString(left, head, truncate(printable(self.document.title), 70))
        canvas.drawRightString(right, head, truncate(printable(_reference(self.document)), 40))
        canvas.line(left, head - 4, right, head - 4)
        canvas.drawString(left, 12 * mm, self.document.origin)
        page = self.page
        canvas.later(f"number-{page}", lambda canvas: self._number(canvas, page))
        canvas.restoreState()

    def _number(self, canvas: Canvas, page: int) -> None:
        """Draw the number of a page, when the last page has its number."""
        _small(canvas)
        number = self.document.translate(PAGE).format(page=page, total=self.page)
        canvas.drawRightString(_SIDE + self.width, 12 * mm, number)


def _small(canvas: Canvas) -> None:
    canvas.setFont(REGULAR, 7)
    canvas.setFillColor(HexColor(MUTED))


def _reference(document: Document) -> str:
    return next((text for label, text in document.facts if label == document.translate("Reference")), "")
