"""The page: margins, header, footer with "page x of y", contents with links, bookmarks."""

from __future__ import annotations

from pathlib import Path

from reportlab.lib.colors import HexColor
from reportlab.lib.pagesizes import A4, LETTER
from reportlab.lib.units import mm
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import BaseDocTemplate, Flowable, Frame, PageTemplate, TableStyle
from reportlab.platypus.tableofcontents import TableOfContents

from reports.document import Document
from reports.lettering import printable, shortened
from reports.style import GRID, INK, MUTED
from reports.typeset import REGULAR, STYLES, markup, paragraph

PAPER = {"A4": A4, "letter": LETTER}
_SIDE, _TOP, _BOTTOM = 18 * mm, 22 * mm, 20 * mm
PAGE = "page {page} of {total}"
_LONGEST_ENTRY = 90
_LONGEST_CONTENTS = 48  # sections; of a longer report only the chapters are listed, the bookmarks have all
_SIDES = ("LEFT", "RIGHT", "TOP", "BOTTOM")


class Heading(Flowable):
    """A section heading that puts itself into the contents and the bookmarks."""

    def __init__(self, text: str, *, level: int, key: str) -> None:
        super().__init__()
        self.text, self.level, self.key = shortened(text, 2 * _LONGEST_ENTRY), level, key
        self._shape = paragraph(self.text, f"heading-{level}")

    @property
    def short(self) -> str:
        """The text as contents and bookmarks have it."""
        return shortened(printable(self.text), _LONGEST_ENTRY)

    def entry(self, page: int) -> tuple[int, str, int, str]:
        """Its entry in the contents, on `page`."""
        return self.level, markup(self.short), page, self.key

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
    """The document template; the page total of one pass is printed by the next.

    The first pass finds where the pages break; tables and figures are drawn from the second on, as a rule the last.
    """

    def __init__(self, path: Path, document: Document) -> None:
        self.document, self.total, self.passes = document, 0, 0
        super().__init__(
            str(path),
            pagesize=PAPER[document.paper],
            leftMargin=_SIDE,
            rightMargin=_SIDE,
            topMargin=_TOP,
            bottomMargin=_BOTTOM,
            title=shortened(printable(document.title), 200),
            author=shortened(printable(document.author), 200),
            subject=document.subject,
            creator=document.program,
            producer=document.program,
            invariant=1,
            lang=document.language,
            initialFontName=REGULAR,
            pageCompression=1,
        )
        frame = Frame(_SIDE, _BOTTOM, self.width, self.height, 0, 0, 0, 0, id="text")
        self.addPageTemplates(PageTemplate("page", [frame], onPage=self._furniture))

    def foretold(self, story: list[Flowable]) -> list[Flowable]:
        """The story whose contents know their headings, if not the pages: the first pass leaves the room they take."""
        entries = [each.entry(0) for each in story if isinstance(each, Heading) and self._listed(each)]
        for table in story:
            if isinstance(table, TableOfContents):
                table.addEntries(entries)
        return story

    def _listed(self, heading: Heading) -> bool:
        """Whether the contents name the heading."""
        return heading.level == 0 or len(self.document.sections) <= _LONGEST_CONTENTS

    def beforeDocument(self) -> None:  # noqa: N802 - reportlab's name
        """Count the passes."""
        self.passes += 1

    def afterFlowable(self, flowable: Flowable) -> None:  # noqa: N802 - reportlab's name
        """Enter a heading into contents and bookmarks."""
        if isinstance(flowable, Heading):
            self.canv.bookmarkPage(flowable.key)
            self.canv.addOutlineEntry(flowable.short, flowable.key, flowable.level, closed=flowable.level)
            if self._listed(flowable):
                self.notify("TOCEntry", flowable.entry(self.page))

    def afterPage(self) -> None:  # noqa: N802 - reportlab's name
        """Remember how many pages there are."""
        self.total = max(self.total, self.page)

    def _furniture(self, canvas: Canvas, _: object) -> None:
        left, right, head = _SIDE, _SIDE + self.width, _BOTTOM + self.height + 8 * mm
        canvas.saveState()
        canvas.setFont(REGULAR, 7)
        canvas.setFillColor(HexColor(MUTED))
        canvas.setStrokeColor(HexColor(GRID))
        canvas.drawString(left, head, shortened(printable(self.document.title), 70))
        canvas.drawRightString(right, head, shortened(printable(_reference(self.document)), 40))
        canvas.line(left, head - 4, right, head - 4)
        canvas.drawString(left, 12 * mm, self.document.program)
        number = self.document.said(PAGE).format(page=self.page, total=max(self.total, self.page))
        canvas.drawRightString(right, 12 * mm, number)
        canvas.restoreState()


def only_measured(canvas: Canvas) -> bool:
    """Whether this is the first pass over the document, of which nothing is kept but the page numbers."""
    pages = getattr(canvas, "_doctemplate", None)
    return isinstance(pages, Pages) and pages.passes == 1


def contents() -> TableOfContents:
    """The table of contents, with page numbers and links."""
    table = TableOfContents(dotsMinLevel=0)
    paddings = [(f"{side}PADDING", (0, 0), (-1, -1), 2.6 if side == "TOP" else 0) for side in _SIDES]
    table.tableStyle = TableStyle([("VALIGN", (0, 0), (-1, -1), "TOP"), *paddings])
    table.levelStyles = [
        STYLES["body"].clone("contents-0", spaceBefore=0, spaceAfter=0, textColor=HexColor(INK)),
        STYLES["body"].clone(
            "contents-1", leftIndent=14, spaceAfter=0, fontSize=7.6, leading=10, textColor=HexColor(MUTED)
        ),
    ]
    return table


def _reference(document: Document) -> str:
    return next((text for label, text in document.facts if label == document.said("Reference")), "")
