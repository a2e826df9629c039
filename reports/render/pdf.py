"""The document as a PDF to sign: the same document gives the same bytes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, pairwise
from pathlib import Path

from reportlab import rl_config
from reportlab.lib.units import mm
from reportlab.platypus import Flowable, Spacer
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
from reports.language.lettering import truncate
from reports.language.locale import Locale
from reports.language.texts import Verbatim
from reports.render.contents import contents
from reports.render.flow import PageStart, Part
from reports.render.frame_words import CONTENTS
from reports.render.page import DeferredCanvas, Heading, Pages
from reports.render.pdf_blocks import Blocks, photograph
from reports.render.processes import processes
from reports.render.typeset import BARE, paragraph, register_fonts
from reports.render.vector import Drawings, trace_figures

rl_config.useA85 = 0  # streams as bytes, not as letters: four fifths of the size, and sooner written

_LONGEST_TITLE, _LONGEST_FACT = 120, 160
_LOGO = (42 * mm, 18 * mm)
_OPENING = 2  # chapters before the contents
_SHORT = 8  # rows of a table that stays on one page
_WHOLE = (Figure, Row, Photograph, Facts, Writing, Signatures, Banner)


class Story:
    """The flowables of a document."""

    def __init__(self, document: Document, locale: Locale, drawings: Drawings, pages: Pages) -> None:
        self.document, self.locale, self.pages = document, locale, pages
        self.blocks = Blocks(locale, drawings, pages.width, pages.height)
        chapters = [place for place, section in enumerate(document.sections) if section.level == 0]
        self.opening = chapters[_OPENING] if len(chapters) > _OPENING else 0  # sections before the contents
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
                yield PageStart(self.pages.height, parts, self.blocks.placed[before:])
            for part in parts:
                yield from part.place()

    def _parts(self, first: int, end: int) -> Iterator[Part]:
        """Yield the parts of sections; headings without blocks stay with the next one."""
        held: list[Flowable] = []
        for place in range(first, end):
            section = self.document.sections[place]
            held.append(self.headings[place])
            if _is_signed(section):  # with the next one, so that nobody signs a page with nothing else on it
                held += chain.from_iterable(map(self.blocks.of, section.blocks))
                if place + 1 == end or not _is_signed(self.document.sections[place + 1]):
                    yield Part(held, is_whole=True)
                    held = []
                continue
            for block in section.blocks:
                yield Part(
                    [*held, *self.blocks.of(block)], _is_whole(block), bool(held) or isinstance(block, Table | Sheet)
                )
                held = []
            if place + 1 == self.opening:
                yield self._contents()
        if held:
            yield Part(held)

    def _contents(self) -> Part:
        listed = contents(self.headings, self.pages.numbers, self.pages.width)
        return Part([paragraph(self.locale.text(CONTENTS), "heading-1"), listed, Spacer(1, 6)], is_whole=True)

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
        facts = [(label, Verbatim(truncate(text(said), _LONGEST_FACT))) for label, said in self.document.facts]
        yield from self.blocks.of(Facts(tuple(facts)))


def _is_signed(section: Section) -> bool:
    """Return whether somebody writes or signs in the section."""
    return any(isinstance(block, Writing | Signatures) for block in section.blocks)


def _is_whole(block: Block) -> bool:
    return isinstance(block, _WHOLE) or (isinstance(block, Table) and len(block.rows) <= _SHORT)


def write_pdf(document: Document, path: Path, *, drawings: Drawings | None = None) -> Path:
    """Write the document to `path`; the path written. drawings: its figures by name, where they are drawn already."""
    register_fonts()
    locale = document.writer
    pages = Pages(path, document, locale)
    with processes(1, document) as here:
        figures = drawings or trace_figures(document, here)
    pages.build(list(Story(document, locale, figures, pages).flowables()), canvasmaker=DeferredCanvas)
    return path
