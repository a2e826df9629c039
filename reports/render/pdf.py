"""The document as a PDF to sign: the same document gives the same bytes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import singledispatchmethod
from itertools import chain
from pathlib import Path

from reportlab import rl_config
from reportlab.lib.colors import HexColor
from reportlab.lib.units import mm
from reportlab.platypus import CondPageBreak, Flowable, KeepTogether, PageBreak, Paragraph, Spacer
from reportlab.platypus import Table as Grid

from reports.document import (
    SIGNATURE_HEADS,
    Banner,
    Block,
    Code,
    Document,
    Figure,
    Items,
    Section,
    Sheet,
    Signatures,
    Table,
    Text,
)
from reports.figures.style import BANNER, GRID, MUTED
from reports.language.lettering import truncate
from reports.render.contents import contents
from reports.render.grid import sheet_grid, table_grid
from reports.render.page import DeferredCanvas, Heading, Pages
from reports.render.pdf_marks import replay
from reports.render.typeset import BOLD, REGULAR, STYLES, markup, paragraph, register_fonts, width_of
from reports.render.vector import FigureMarks, trace_figure

rl_config.useA85 = 0  # streams as bytes, not as letters: four fifths of the size, and sooner written

_LONGEST_TITLE = 120
_VERDICT_MARGINS = 18  # of the banner's left cell [pt]
_ROOM, _FIGURE_ROOM, _SIGNING_ROOM = 50 * mm, 118 * mm, 75 * mm  # a heading needs below it, or the page breaks
_CAPTION = 26 * mm  # left for a caption of five lines below a figure as high as the page


class Drawing(Flowable):
    """A traced figure on the page, fetched only when it is placed: until then it may be in the making."""

    def __init__(self, drawings: Mapping[str, FigureMarks], name: str, room: tuple[float, float]) -> None:
        super().__init__()
        self.drawings, self.name, self.room = drawings, name, room
        self.hAlign = "CENTER"

    @property
    def figure(self) -> FigureMarks:
        """The figure, waited for if it is still being drawn."""
        return self.drawings[self.name]

    @property
    def factor(self) -> float:
        """The factor by which it is reduced to fit."""
        return min(1.0, self.room[0] / self.figure.width, self.room[1] / self.figure.height)

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        return self.figure.width * self.factor, self.figure.height * self.factor

    def draw(self) -> None:
        self.canv.scale(self.factor, self.factor)
        replay(self.figure, self.canv, font=REGULAR, bold=BOLD)


class Story:
    """The flowables of a document."""

    def __init__(self, document: Document, drawings: Mapping[str, FigureMarks], pages: Pages) -> None:
        self.document, self.drawings, self.width = document, drawings, pages.width
        self.for_figures = (pages.width, pages.height - _CAPTION)
        self.titles, self.numbers = document.titles, pages.numbers

    def flowables(self) -> list[Flowable]:
        """Return title block and opening section, contents, then everything else."""
        made = [self._section(section, f"section-{place}") for place, section in enumerate(self.document.sections)]
        headings = [flowable for each in made for flowable in each if isinstance(flowable, Heading)]
        opening = [*self._title(), *chain.from_iterable(made[:1]), PageBreak()]
        listed = [paragraph(self.document.translate("Contents"), "heading-0"), *contents(headings, self.numbers)]
        return [*opening, *listed, PageBreak(), *self._rest(made)]

    def _rest(self, made: Sequence[list[Flowable]]) -> Iterator[Flowable]:
        """Yield all sections but the opening one, each on a page of its own where it asks for one."""
        for place, (section, flowables) in enumerate(zip(self.document.sections, made, strict=True)):
            if section.starts_page and place > 1:
                yield PageBreak()
            if place > 0:
                yield from flowables

    def _title(self) -> list[Flowable]:
        facts = [
            [paragraph(label, "muted"), paragraph(truncate(text, 160), "cell")] for label, text in self.document.facts
        ]
        block: list[Flowable] = [
            paragraph(truncate(self.document.title, _LONGEST_TITLE), "title"),
            paragraph(self.document.subject, "subject"),
        ]
        if facts:
            grid = Grid(facts, colWidths=[32 * mm, self.width - 32 * mm], hAlign="LEFT", spaceAfter=6)
            grid.setStyle([("LINEABOVE", (0, 0), (-1, 0), 0.6, HexColor(GRID)), *_TIGHT])
            block.append(grid)
        return block

    def _section(self, section: Section, key: str) -> list[Flowable]:
        blocks = [self._block(block) for block in section.blocks]
        room = _SIGNING_ROOM if any(isinstance(block, Signatures) for block in section.blocks) else _ROOM
        room = _FIGURE_ROOM if isinstance(section.blocks[0], Figure) else room
        heading = Heading(section.title, level=section.level, key=key)
        made: list[Flowable] = [CondPageBreak(room), heading]
        return made + [flowable for block in blocks for flowable in block]

    @singledispatchmethod
    def _block(self, block: Block) -> list[Flowable]:
        raise TypeError(f"{type(block).__name__}: not a block of a document")

    @_block.register
    def _(self, block: Text) -> list[Flowable]:
        return [paragraph(text, "body") for text in block.paragraphs]

    @_block.register
    def _(self, block: Items) -> list[Flowable]:
        return [Paragraph(markup(text), STYLES["item"], bulletText="•") for text in block.points]

    @_block.register
    def _(self, block: Code) -> list[Flowable]:
        return [*(paragraph(line, "code") for line in block.lines), Spacer(1, 6)]

    @_block.register
    def _(self, block: Table) -> list[Flowable]:
        title = self.titles["Table", block.name]
        return [
            CondPageBreak(28 * mm),
            table_grid(block, title=title, width=self.width, translate=self.document.translate),
        ]

    @_block.register
    def _(self, block: Sheet) -> list[Flowable]:
        title = self.titles["Sheet", block.name]
        return [
            CondPageBreak(40 * mm),
            sheet_grid(block, title=title, width=self.width, translate=self.document.translate),
        ]

    @_block.register
    def _(self, block: Banner) -> list[Flowable]:
        ink = HexColor(BANNER[block.verdict])
        word, widths = self.document.translate(block.word), [0.3 * self.width, 0.7 * self.width]
        style = STYLES["verdict"].clone("banner", textColor=ink, fontSize=_fitting(word, widths[0] - _VERDICT_MARGINS))
        grid = Grid([[Paragraph(markup(word), style), paragraph(block.headline, "body")]], colWidths=widths)
        grid.setStyle([("BOX", (0, 0), (-1, -1), 1.4, ink), ("VALIGN", (0, 0), (-1, -1), "MIDDLE"), *_ROOMY])
        return [Spacer(1, 4), grid, Spacer(1, 8)]

    @_block.register
    def _(self, block: Figure) -> list[Flowable]:
        caption = paragraph(f"{self.titles['Figure', block.name]}. {truncate(block.caption, 500)}", "caption")
        drawing = Drawing(self.drawings, block.name, self.for_figures)
        return [KeepTogether([drawing, Spacer(1, 3), caption, Spacer(1, 9)])]

    @_block.register
    def _(self, block: Signatures) -> list[Flowable]:
        rows = [
            [paragraph(role, "muted"), paragraph(truncate(name, 60), "cell"), "", ""] for role, name in block.places
        ]
        labels = [paragraph(text, "muted") for text in map(self.document.translate, SIGNATURE_HEADS)]
        grid = Grid(
            [labels, *rows],
            colWidths=[0.14 * self.width, *[0.2867 * self.width] * 3],
            rowHeights=[16, *[42] * len(rows)],
        )
        grid.setStyle([("LINEBELOW", (1, 1), (-1, -1), 0.6, HexColor(MUTED)), ("VALIGN", (0, 0), (-1, -1), "BOTTOM")])
        return [KeepTogether([grid])]


def _fitting(text: str, width: float) -> float:
    """Return the size of letters at which the longest word of a verdict is no wider than `width` [pt]."""
    widest = max(width_of(word, "verdict") for word in text.split())
    return float(STYLES["verdict"].fontSize) * min(1.0, width / widest)


_ROOMY = [("TOPPADDING", (0, 0), (-1, -1), 9), ("BOTTOMPADDING", (0, 0), (-1, -1), 11)]
_TIGHT = [
    ("LEFTPADDING", (0, 0), (0, -1), 0),
    ("TOPPADDING", (0, 0), (-1, -1), 1.5),
    ("BOTTOMPADDING", (0, 0), (-1, -1), 1.5),
    ("VALIGN", (0, 0), (-1, -1), "TOP"),
]


def write_pdf(document: Document, path: Path, *, drawings: Mapping[str, FigureMarks] | None = None) -> Path:
    """Write the document to `path`; the path written. drawings: its figures by name, where they are drawn already."""
    register_fonts()
    pages = Pages(path, document)
    figures = drawings or {figure.name: trace_figure(figure.draw()) for figure in document.figures}
    pages.build(Story(document, figures, pages).flowables(), canvasmaker=DeferredCanvas)
    return path
