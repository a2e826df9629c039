"""The document as a PDF to sign: the same document gives the same bytes.

What stays together, where a page begins, what is made to fit; the contents; margins, running head, foot with "page x
of y", bookmarks.
"""

from __future__ import annotations

import datetime
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise
from math import ceil
from pathlib import Path
from typing import Any

from reportlab import rl_config
from reportlab.lib.colors import HexColor
from reportlab.lib.pagesizes import A4, LETTER
from reportlab.lib.units import mm
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import (
    BaseDocTemplate,
    CondPageBreak,
    Flowable,
    Frame,
    KeepTogether,
    PageTemplate,
    Paragraph,
    Spacer,
)
from reportlab.platypus import Table as Grid

from reports.document import (
    Banner,
    Block,
    BulletList,
    Document,
    Facts,
    Figure,
    FigureRow,
    Photograph,
    Prose,
    Section,
    Sheet,
    Signatures,
    Table,
    WritingBox,
)
from reports.figures.style import GRID, printable
from reports.language.locale import Locale, truncate
from reports.language.texts import Verbatim, count, say
from reports.render.pdf_blocks import (
    BARE,
    REGULAR,
    STYLES,
    BlockFlowables,
    PagedTable,
    PlacedFigure,
    cut_to_width,
    markup,
    paragraph,
    photograph,
    register_fonts,
    set_letters,
    width_of,
)
from reports.render.table_text import CONTENTS, program_and_stamp
from reports.render.vector import TracedFigures, document_processes, trace_figures

rl_config.useA85 = 0  # streams as bytes, not as letters: four fifths of the size, and sooner written
_LONGEST_TITLE, _LONGEST_FACT = 120, 160
_LOGO = (42 * mm, 18 * mm)
_OPENING_CHAPTERS = 2  # chapters before the contents
_SHORT_TABLE = 8  # rows of a table that stays on one page
_WHOLE_BLOCKS = (Figure, FigureRow, Photograph, Facts, WritingBox, Signatures, Banner)


def write_pdf(document: Document, path: Path, *, drawings: TracedFigures | None = None) -> Path:
    """Write the document to `path`; the path written. drawings: its figures by name, where they are drawn already."""
    register_fonts()
    locale = document.writer
    pages = Pages(path, document, locale)
    with document_processes(1, document) as here:
        figures = drawings or trace_figures(document, here)
    pages.build(list(Story(document, locale, figures, pages).flowables()), canvasmaker=DeferredCanvas)
    return path


class Story:
    """The flowables of a document."""

    def __init__(self, document: Document, locale: Locale, drawings: TracedFigures, pages: Pages) -> None:
        self.document, self.locale, self.pages = document, locale, pages
        self.blocks = BlockFlowables(locale, drawings, pages.width, pages.height)
        chapters = [place for place, section in enumerate(document.sections) if section.level == 0]
        self.opening = (
            chapters[_OPENING_CHAPTERS] if len(chapters) > _OPENING_CHAPTERS else 0
        )  # sections before the contents
        self.headings = [Heading(each, locale, f"section-{n}") for n, each in enumerate(document.sections)]

    def flowables(self) -> Iterator[Flowable]:
        """Yield the title block, two sections, the contents and the other sections."""
        yield from self._title()
        sections = self.document.sections
        starts = [place for place, section in enumerate(sections) if place > 0 and section.starts_page]
        for first, end in pairwise([0, *starts, len(sections)]):
            before = len(self.blocks.placed)
            parts = list(self._parts(first, end))
            if first:
                yield PageStart(
                    self.pages.height, parts, self.blocks.placed[before:], shares=sections[first].shares_page
                )
            share = 0.5 * self.pages.height if sections[first].shares_page else 0.0
            yield from self._placed(parts, parts if first else parts[: len(sections[0].blocks)], share)

    def _placed(self, parts: Sequence[PagePart], page: Sequence[PagePart], share: float) -> Iterator[Flowable]:
        """Yield what the parts put into the story, the first ones, of one heading, on a page where they can be.

        share : height that they are to have with their heading, as far as they can [pt]; 0 for all of the page
        """
        heads = [each for part in page for each in part.flowables if isinstance(each, Heading)]
        if len(heads) == 1 and page[0].flowables[0] is heads[0]:
            yield heads[0]
            most = share - heads[0].wrap(self.pages.width, self.pages.height)[1] - _AROUND_HEADING if share else 0.0
            yield OnePage([replace(page[0], flowables=page[0].flowables[1:]), *page[1:]], most)
            parts = parts[len(page) :]
        for part in parts:
            yield from part.place()

    def _parts(self, first: int, end: int) -> Iterator[PagePart]:
        """Yield the parts of sections; headings without blocks stay with the next one."""
        held: list[Flowable] = []
        for place in range(first, end):
            section = self.document.sections[place]
            held.append(self.headings[place])
            if _is_signed(section):  # with the next one, so that nobody signs a page with nothing else on it
                held += chain.from_iterable(map(self.blocks.flowables, section.blocks))
                if place + 1 == end or not _is_signed(self.document.sections[place + 1]):
                    yield PagePart(held, is_whole=True)
                    held = []
                continue
            for block, after in zip(section.blocks, (*section.blocks, None)[1:], strict=True):
                if isinstance(block, Prose) and isinstance(after, BulletList) and len(block.paragraphs) == 1:
                    held += self.blocks.flowables(block)  # the title of a list
                    continue
                yield PagePart(
                    [*held, *self.blocks.flowables(block)],
                    _is_whole(block),
                    bool(held) or isinstance(block, Table | Sheet),
                )
                held = []
            if place + 1 == self.opening:
                yield self._contents()
        if held:
            yield PagePart(held)

    def _contents(self) -> PagePart:
        listed = _contents_lines(self.headings, self.pages.numbers, self.pages.width)
        return PagePart([paragraph(self.locale.text(CONTENTS), "heading-1"), listed, Spacer(1, 6)], is_whole=True)

    def _title(self) -> Iterator[Flowable]:
        text, logo = self.locale.text, self.document.logo
        titles = [
            paragraph(truncate(text(self.document.title), _LONGEST_TITLE), "title"),
            paragraph(text(self.document.subject), "subject"),
        ]
        picture = photograph(logo, *_LOGO) if logo else None
        width = self.pages.width
        if picture:
            head = Grid([[titles, picture]], colWidths=[width - _LOGO[0] - 10, _LOGO[0] + 10])
            head.setStyle([*BARE, ("VALIGN", (0, 0), (-1, -1), "TOP"), ("ALIGN", (1, 0), (1, 0), "RIGHT")])
            yield head
        else:
            yield from titles
        facts = [(label, Verbatim(truncate(text(value), _LONGEST_FACT))) for label, value in self.document.facts]
        yield from self.blocks.flowables(Facts(tuple(facts)))


ROOM_TO_BEGIN = 24 * mm
"""What a heading and its first lines, or a table after its first row, need on a page, or go to the next."""
_LEAST_LEFT = 0.67  # share of a page below which a section that asks for a page begins a new one
_SMALLEST_FIGURE = 0.7  # reduction of figures
_PAGE_SIZES = (0.97, 0.94, 0.91, 0.88, 0.85, 0.82, 0.79)  # to which a page is set that is to hold all of its parts
_SHARED_FIGURE = 0.7  # reduction of figures of what shares a page
_AROUND_HEADING = 14.0  # above and below the heading of a part of a page [pt]
_SLACK = 8.0  # of a page that is filled to its end: spaces that the parts put between each other [pt]


@dataclass(frozen=True)
class PagePart:
    """Flowables that follow each other.

    is_whole : on one page
    needs_room : begins where there is `ROOM_TO_BEGIN`, and more before a table that starts with a high row
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
            starts = (flowable.start for flowable in self.flowables if isinstance(flowable, PagedTable))
            yield PageUnlessRoom(ROOM_TO_BEGIN + max(starts, default=0.0), self.flowables)
        yield from self.flowables


class PageUnlessRoom(CondPageBreak):
    """Begins a page unless this height [pt], or that of all that follows, is left on the present one."""

    def __init__(self, height: float, flowables: Sequence[Flowable]) -> None:
        super().__init__(height)
        self.flowables = flowables

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        self.height = min(self.height, _stacked_height(self.flowables, aW, self.height))
        width, height = super().wrap(aW, aH)
        return float(width), float(height)


class PageStart(CondPageBreak):
    """Begins a page, unless this one is nearly empty, or has room for all parts and may be shared.

    Where the parts after it need a little more than the page, their figures are reduced until it has room for all.
    """

    def __init__(
        self, page: float, parts: Sequence[PagePart], drawings: Sequence[PlacedFigure], *, shares: bool
    ) -> None:
        super().__init__(_LEAST_LEFT * page)
        self.page, self.drawings, self.shares = page, drawings, shares
        self.largest = _SHARED_FIGURE if shares else 1.0  # of figures
        self.flowables = list(chain.from_iterable(part.flowables for part in parts))

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        if self.shares:
            least = _PAGE_SIZES[-1] * self._height(aW, _SMALLEST_FIGURE, self.page)
            self.height = min(self.height, least + _SLACK)
        if self.drawings:
            self._reduce(aW, (self.page if aH < self.height else aH) - _SLACK)
        width, height = super().wrap(aW, aH)
        return float(width), float(height)

    def _reduce(self, width: float, room: float) -> None:
        whole = self._height(width, self.largest, 1.5 * room)
        if whole <= room or whole > 1.5 * room:
            return
        least = self._height(width, _SMALLEST_FIGURE, 1.5 * room)
        share = (room - least) / (whole - least) if least <= room and least < whole else 1.0
        self._set(_SMALLEST_FIGURE + (self.largest - _SMALLEST_FIGURE) * share)

    def _height(self, width: float, reduction: float, limit: float) -> float:
        """Return the height of all parts [pt] with figures so reduced; some value beyond `limit` where it is higher."""
        self._set(reduction)
        return _stacked_height(self.flowables, width, limit)

    def _set(self, reduction: float) -> None:
        for drawing in self.drawings:
            drawing.reduction = reduction


class OnePage(Flowable):
    """What belongs on the rest of a page, set smaller where it needs that; as it comes where that is not enough.

    share : height to which it is set where it can be, for another to follow on the page [pt]; 0 for none
    """

    def __init__(self, parts: Sequence[PagePart], share: float = 0.0) -> None:
        super().__init__()
        self.parts, self.share = parts, share
        self.flowables = list(chain.from_iterable(part.flowables for part in parts))

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        for most in (self.share, aH) if 0.0 < self.share < aH else (aH,):
            for self.scale in (1.0, *_PAGE_SIZES):
                width, room = aW / self.scale, most / self.scale
                self.size = width, _stacked_height(self.flowables, width, 1.5 * room) + _SLACK
                if self.size[1] <= room:
                    return aW, self.size[1] * self.scale
                if self.size[1] * self.scale > most / _PAGE_SIZES[-1] ** 2:  # wider lines are fewer, too
                    break
        return aW, self.size[1] * self.scale

    def split(self, aW: float, aH: float) -> list[Flowable]:
        return [Spacer(1, 0), *chain.from_iterable(part.place() for part in self.parts)]

    def draw(self) -> None:
        self.canv.scale(self.scale, self.scale)
        Frame(0, 0, *self.size, 0, 0, 0, 0).addFromList(self.flowables, self.canv)


LINES_IN_COLUMN = 10  # lines up to which they stand in one column
_CONTENTS_STYLE = "contents"
_ROOM_FOR_NUMBER, _COLUMN_GAP = 27.0, 14.0  # left for dots and number; between two columns [pt]
_DOT = " ."


class ContentsLine(Flowable):
    """The line of one heading. numbers: of the pages by the headings' keys, complete when the pages are."""

    def __init__(self, heading: Heading, numbers: Mapping[str, int]) -> None:
        super().__init__()
        self.heading, self.numbers = heading, numbers

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        self.width, self.height = aW, STYLES[_CONTENTS_STYLE].leading
        return self.width, self.height

    def draw(self) -> None:
        canvas = self.canv
        assert isinstance(canvas, DeferredCanvas)  # the only one that write_pdf makes
        set_letters(canvas, _CONTENTS_STYLE)
        text = cut_to_width(self.heading.short, self.width - _ROOM_FOR_NUMBER, _CONTENTS_STYLE)
        canvas.drawString(0, self.height - STYLES[_CONTENTS_STYLE].fontSize, text)
        canvas.linkRect("", self.heading.key, (0.0, 0.0, self.width, self.height), relative=1)
        self.free = self.width - width_of(text, _CONTENTS_STYLE)
        canvas.later(f"page-of-{self.heading.key}", self._number)

    def _number(self, canvas: Canvas) -> None:
        """Draw dots and number at the right end."""
        set_letters(canvas, _CONTENTS_STYLE)
        number = f" {self.numbers[self.heading.key]}"
        dots = _DOT * int((self.free - width_of(number, _CONTENTS_STYLE)) / width_of(_DOT, _CONTENTS_STYLE))
        canvas.drawRightString(self.width, self.height - STYLES[_CONTENTS_STYLE].fontSize, dots + number)


class DeferredCanvas(Canvas):
    """A canvas that leaves room for what is known only when all pages exist, so that one pass over them is enough."""

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
            creator=printable(text(program_and_stamp(document))),
            producer=document.program,
            invariant=1,
            lang=locale.language,
            initialFontName=REGULAR,
            pageCompression=1,
        )
        frame = Frame(_SIDE, _BOTTOM, self.width, self.height, 0, 0, 0, 0, id="text")
        self.addPageTemplates(PageTemplate("page", [frame], onPage=self._head_and_foot))

    def afterFlowable(self, flowable: object) -> None:  # noqa: N802 - reportlab's name
        """Enter a heading into contents and bookmarks."""
        if isinstance(flowable, Heading):
            self._depth = min(flowable.level, self._depth + 1)  # a bookmark is at most one below the one before
            self.canv.bookmarkPage(flowable.key)
            self.canv.addOutlineEntry(flowable.short, flowable.key, self._depth, closed=self._depth)
            self.numbers[flowable.key] = self.page

    def _head_and_foot(self, canvas: Canvas, _: object) -> None:
        assert isinstance(canvas, DeferredCanvas)  # the only one that write_pdf makes
        made = _pdf_date(self.document.date)
        if made:
            canvas.setDateFormatter(lambda *_: made)
        left, right, head = _SIDE, _SIDE + self.width, _BOTTOM + self.height + _HEAD
        text, document, page = self.locale.text, self.document, self.page
        canvas.saveState()
        set_letters(canvas, "running")
        canvas.setStrokeColor(HexColor(GRID))
        shown = [truncate(printable(each), _RUNNING) for each in map(text, document.running) if each]
        running = cut_to_width(" · ".join(shown), _RUNNING_SHARE * self.width, "running")
        room = self.width - width_of(running, "running") - _HEAD_GAP
        canvas.drawString(left, head, cut_to_width(printable(text(document.title)), room, "running"))
        canvas.drawRightString(right, head, running)
        canvas.line(left, head - 3.5, right, head - 3.5)
        canvas.drawString(left, _FOOT, truncate(printable(text(program_and_stamp(document))), _LONGEST))
        canvas.later(f"number-{page}", lambda canvas: self._number(canvas, page))
        canvas.restoreState()

    def _number(self, canvas: Canvas, page: int) -> None:
        """Draw the number of a page, when the last page has its number."""
        set_letters(canvas, "running")
        number = say("page {page} of {total}", page=count(page), total=count(self.page))
        canvas.drawRightString(_SIDE + self.width, _FOOT, self.locale.text(number))


def _is_signed(section: Section) -> bool:
    """Return whether somebody writes or signs in the section."""
    return any(isinstance(block, WritingBox | Signatures) for block in section.blocks)


def _is_whole(block: Block) -> bool:
    return isinstance(block, _WHOLE_BLOCKS) or (isinstance(block, Table) and len(block.rows) <= _SHORT_TABLE)


def _stacked_height(flowables: Sequence[Flowable], width: float, limit: float) -> float:
    """Return the height of flowables one below the other [pt]; some value beyond `limit` where it is higher."""
    height = space = 0.0
    for flowable in flowables:
        height += flowable.wrap(width, limit)[1] + max(space, flowable.getSpaceBefore())
        space = flowable.getSpaceAfter()
        if height > limit:
            break
    return height


def _contents_lines(headings: Sequence[Heading], numbers: Mapping[str, int], width: float) -> Flowable:
    """Return the lines of the chapters and of the mechanisms, in two columns where they are many."""
    entries = [ContentsLine(each, numbers) for each in headings if each.level == 0]
    high = len(entries) if len(entries) <= LINES_IN_COLUMN else ceil(len(entries) / 2)
    rows = [[entries[place], *entries[place + high : place + high + 1]] for place in range(high)]
    wide = (width - _COLUMN_GAP) / 2
    if high == len(entries):
        return Grid(rows, colWidths=[width], style=BARE)
    whole = [[*row, "", ""][:2] for row in rows]
    return Grid([[one, "", other] for one, other in whole], colWidths=[wide, _COLUMN_GAP, wide], style=BARE)


PAPER = {"A4": A4, "letter": LETTER}
_SIDE, _TOP, _BOTTOM = 18 * mm, 19 * mm, 17 * mm
_HEAD, _FOOT = 5 * mm, 10 * mm  # of the running head above the text, of the foot above the edge
_LONGEST, _RUNNING = 90, 40  # letters of a heading in the bookmarks, of each part of the running head
_RUNNING_SHARE, _HEAD_GAP = 0.6, 12.0  # of the line, beside the title; between them [pt]


def _pdf_date(date: str) -> str:
    """Return a date like 2026-05-12 as the properties of a PDF have it; empty for one that is not written so."""
    try:
        return f"D:{datetime.date.fromisoformat(date):%Y%m%d}000000Z"
    except ValueError:
        return ""
