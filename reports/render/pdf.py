"""The document as a PDF to sign: the same document gives the same bytes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from reportlab import rl_config
from reportlab.lib.colors import HexColor
from reportlab.lib.units import mm
from reportlab.platypus import CondPageBreak, Flowable, KeepTogether, Spacer
from reportlab.platypus import Table as Grid

from reports.document import (
    Banner,
    Block,
    Document,
    Facts,
    Figure,
    Photograph,
    Row,
    Section,
    Sheet,
    Signatures,
    Table,
    Writing,
)
from reports.figures.style import GRID
from reports.language.lettering import truncate
from reports.language.locale import Locale
from reports.render.contents import contents
from reports.render.frame_words import CONTENTS
from reports.render.page import DeferredCanvas, Heading, Pages
from reports.render.pdf_blocks import Blocks, photograph
from reports.render.typeset import paragraph, register_fonts
from reports.render.vector import FigureMarks, trace_figure

rl_config.useA85 = 0  # streams as bytes, not as letters: four fifths of the size, and sooner written

_LONGEST_TITLE, _LONGEST_FACT = 120, 160
_LOGO = (42 * mm, 18 * mm)
_ROOM = 32 * mm  # that a heading, a table or a sheet begins in, or the page breaks
_USED = 0.75  # share of a page that must be left for a section not to begin a new one
_SHORT = 8  # rows of a table that stays on one page
_WHOLE = (Figure, Row, Photograph, Facts, Writing, Signatures, Banner)


class Story:
    """The flowables of a document."""

    def __init__(self, document: Document, locale: Locale, drawings: Mapping[str, FigureMarks], pages: Pages) -> None:
        self.document, self.locale, self.pages = document, locale, pages
        self.blocks = Blocks(locale, drawings, pages.width, pages.height)
        self.headings = [Heading(each, locale, f"section-{n}") for n, each in enumerate(document.sections)]

    def flowables(self) -> Iterator[Flowable]:
        """Yield the title block, two sections, the contents and the other sections."""
        yield from self._title()
        held: list[Flowable] = []  # headings without blocks, which stay with the next one
        for place, (section, heading) in enumerate(zip(self.document.sections, self.headings, strict=True)):
            if place == 2:
                yield from self._contents()
            if section.starts_page and place > 0:
                yield CondPageBreak(_USED * self.pages.height)
            held.append(heading)
            if section.blocks:
                yield from self._section(section, held)
                held = []
        yield from held

    def _section(self, section: Section, headings: list[Flowable]) -> Iterator[Flowable]:
        """Yield headings and blocks; what is whole, such as a figure, stays on one page with the headings above it."""
        first, *others = section.blocks
        made = self.blocks.of(first)
        if _is_whole(first):
            yield KeepTogether([*headings, *made])
        else:
            yield CondPageBreak(_ROOM)
            yield from (*headings, *made)
        for block in others:
            made = self.blocks.of(block)
            if _is_whole(block):
                yield KeepTogether(made)
            else:
                if isinstance(block, Table | Sheet):
                    yield CondPageBreak(_ROOM)
                yield from made

    def _contents(self) -> Iterator[Flowable]:
        listed = contents(self.headings, self.pages.numbers, self.pages.width)
        yield KeepTogether([paragraph(self.locale.text(CONTENTS), "heading-1"), listed, Spacer(1, 6)])

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
            head.setStyle([*_TIGHT, ("ALIGN", (1, 0), (1, 0), "RIGHT")])
            yield head
        else:
            yield from titles
        pairs = [(text(label), truncate(text(said), _LONGEST_FACT)) for label, said in self.document.facts]
        if pairs:
            facts = [[paragraph(label, "muted"), paragraph(said, "cell")] for label, said in pairs]
            grid = Grid(facts, colWidths=[0.17 * width, 0.83 * width], hAlign="LEFT", spaceAfter=5)
            grid.setStyle([("LINEABOVE", (0, 0), (-1, 0), 0.6, HexColor(GRID)), *_TIGHT])
            yield grid


def _is_whole(block: Block) -> bool:
    return isinstance(block, _WHOLE) or (isinstance(block, Table) and len(block.rows) <= _SHORT)


_TIGHT = [
    ("LEFTPADDING", (0, 0), (0, -1), 0),
    ("RIGHTPADDING", (0, 0), (-1, -1), 0),
    ("TOPPADDING", (0, 0), (-1, -1), 1.5),
    ("BOTTOMPADDING", (0, 0), (-1, -1), 1.5),
    ("VALIGN", (0, 0), (-1, -1), "TOP"),
]


def write_pdf(document: Document, path: Path, *, drawings: Mapping[str, FigureMarks] | None = None) -> Path:
    """Write the document to `path`; the path written. drawings: its figures by name, where they are drawn already."""
    register_fonts()
    locale = document.writer
    pages = Pages(path, document, locale)
    figures = drawings or {figure.name: trace_figure(figure.draw(locale)) for figure in document.figures}
    pages.build(list(Story(document, locale, figures, pages).flowables()), canvasmaker=DeferredCanvas)
    return path
