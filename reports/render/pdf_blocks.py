"""The blocks of a document as what reportlab puts on pages."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from concurrent.futures import Future
from functools import singledispatchmethod
from io import BytesIO
from math import ceil

from PIL import Image as Pillow
from reportlab.lib.colors import HexColor
from reportlab.lib.units import mm
from reportlab.platypus import Flowable, Image, Paragraph, Spacer
from reportlab.platypus import Table as Grid

from reports.document import (
    Banner,
    Block,
    Code,
    Facts,
    Figure,
    Items,
    Photograph,
    Prose,
    Row,
    Sheet,
    Signatures,
    Table,
    Writing,
)
from reports.figures.style import BANNER, MUTED
from reports.language.lettering import truncate
from reports.language.locale import Locale
from reports.language.texts import Kind, Text
from reports.render.frame_words import SIGNATURE_HEADS, verdict_word
from reports.render.pdf_marks import replay
from reports.render.pdf_tables import TINT, sheet_grid, table_grid
from reports.render.typeset import BARE, BOLD, REGULAR, STYLES, markup, paragraph, titled_caption, width_of
from reports.render.vector import Drawings, FigureMarks

_CAPTION = 26 * mm  # left for a caption below a figure as high as the page
_PHOTOGRAPH = 95 * mm  # height of a photograph at most
_PIXEL = 72 / 150  # of a photograph [pt]
_GAP = 8.0  # between figures side by side [pt]
_LONGEST_CAPTION, _LONGEST_NAME = 500, 60  # letters
_LONG = 120  # letters: a longer text is not measured
_VERDICT_MARGINS = 18.0  # of the left cell of the banner [pt]


class Drawing(Flowable):
    """A traced figure on the page, fetched only when it is placed: until then it may be in the making."""

    def __init__(self, drawing: Future[FigureMarks], room: tuple[float, float]) -> None:
        super().__init__()
        self.drawing, self.room = drawing, room
        self.reduction = 1.0  # besides, for a page to have room for all that belongs on it
        self.hAlign = "CENTER"

    @property
    def figure(self) -> FigureMarks:
        """The figure, waited for if it is still being drawn."""
        return self.drawing.result()

    @property
    def factor(self) -> float:
        """The factor by which it is reduced to fit."""
        return self.reduction * min(1.0, self.room[0] / self.figure.width, self.room[1] / self.figure.height)

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        return self.figure.width * self.factor, self.figure.height * self.factor

    def draw(self) -> None:
        self.canv.scale(self.factor, self.factor)
        replay(self.figure, self.canv, font=REGULAR, bold=BOLD)


class Blocks:
    """Makes flowables of blocks.

    width, height : of the text on a page [pt]
    placed : the figures made so far
    """

    def __init__(self, locale: Locale, drawings: Drawings, width: float, height: float) -> None:
        self.locale, self.drawings, self.width, self.height = locale, drawings, width, height
        self.text = locale.text
        self.placed: list[Drawing] = []

    @singledispatchmethod
    def of(self, block: Block) -> list[Flowable]:
        """Return the flowables of a block."""
        raise TypeError(f"{type(block).__name__}: not a block of a document")

    @of.register
    def _(self, block: Prose) -> list[Flowable]:
        return [paragraph(self.text(each), "body") for each in block.paragraphs]

    @of.register
    def _(self, block: Items) -> list[Flowable]:
        return [paragraph(self.text(each), "item", bullet="•") for each in block.points] + [Spacer(1, 3)]

    @of.register
    def _(self, block: Code) -> list[Flowable]:
        return [*(paragraph(line, "code") for line in block.lines), Spacer(1, 6)]

    @of.register
    def _(self, block: Table) -> list[Flowable]:
        return [self._caption("Table", block.name, block.caption), table_grid(block, self.locale, self.width)]

    @of.register
    def _(self, block: Sheet) -> list[Flowable]:
        return [self._caption("Sheet", block.name, block.caption), sheet_grid(block, self.locale, self.width)]

    @of.register
    def _(self, block: Figure) -> list[Flowable]:
        return [*self._figure(block, (self.width, self.height - _CAPTION)), Spacer(1, 6)]

    @of.register
    def _(self, block: Row) -> list[Flowable]:
        wide = (self.width - _GAP * (len(block.figures) - 1)) / len(block.figures)
        cells = [self._figure(figure, (wide, self.height - _CAPTION)) for figure in block.figures]
        widths = [wide + _GAP] * (len(cells) - 1) + [wide]
        grid = Grid([list(row) for row in zip(*cells, strict=True)], colWidths=widths, spaceAfter=5)
        grid.setStyle([*BARE, ("RIGHTPADDING", (0, 0), (-2, -1), _GAP), ("BOTTOMPADDING", (0, 0), (-1, 0), 2)])
        grid.setStyle([("VALIGN", (0, 0), (-1, 0), "MIDDLE"), ("VALIGN", (0, 1), (-1, 1), "TOP")])
        return [grid]

    @of.register
    def _(self, block: Photograph) -> list[Flowable]:
        made = photograph(block, self.width, _PHOTOGRAPH)
        return [*([made] if made else []), self._caption("Figure", block.name, block.caption), Spacer(1, 6)]

    @of.register
    def _(self, block: Facts) -> list[Flowable]:
        return [self._facts(block.pairs)] if block.pairs else []

    @of.register
    def _(self, block: Writing) -> list[Flowable]:
        box = Grid([[""]], colWidths=[self.width], rowHeights=[block.height * mm], spaceAfter=8)
        box.setStyle([("BOX", (0, 0), (-1, -1), 0.6, HexColor(MUTED))])
        return [paragraph(self.text(block.title), "caption"), box]

    @of.register
    def _(self, block: Signatures) -> list[Flowable]:
        named = [(self.text(role), truncate(self.text(name), _LONGEST_NAME)) for role, name in block.places]
        rows = [[paragraph(role, "muted"), paragraph(name, "cell"), "", ""] for role, name in named]
        heads = [paragraph(self.text(each), "muted") for each in SIGNATURE_HEADS]
        widths = [share * self.width for share in (0.19, 0.27, 0.27, 0.27)]
        grid = Grid([heads, *rows], colWidths=widths, rowHeights=[16, *[40] * len(rows)], spaceAfter=8)
        grid.setStyle([("LINEBELOW", (1, 1), (-1, -1), 0.6, HexColor(MUTED)), ("VALIGN", (0, 0), (-1, -1), "BOTTOM")])
        return [grid]

    @of.register
    def _(self, block: Banner) -> list[Flowable]:
        ink, word = HexColor(BANNER[block.outcome]), self.text(verdict_word(block))
        widths = [0.3 * self.width, 0.7 * self.width]
        size = _fitting(word, widths[0] - _VERDICT_MARGINS)
        style = STYLES["verdict"].clone("banner", textColor=ink, fontSize=size, leading=1.25 * size)
        cells = [
            Paragraph(markup(word), style),
            paragraph(truncate(self.text(block.headline), _LONGEST_CAPTION), "body"),
        ]
        grid = Grid([cells], colWidths=widths, spaceBefore=3, spaceAfter=7)
        grid.setStyle(
            [
                ("BOX", (0, 0), (-1, -1), 1.2, ink),
                ("BACKGROUND", (0, 0), (0, 0), HexColor(TINT[block.outcome])),
                ("VALIGN", (0, 0), (-1, -1), "MIDDLE"),
                ("TOPPADDING", (0, 0), (-1, -1), 6),
                ("BOTTOMPADDING", (0, 0), (-1, -1), 7),
            ]
        )
        return [grid]

    def _caption(self, kind: Kind, name: str, caption: Text) -> Flowable:
        return titled_caption(self.locale.title(kind, name), truncate(self.text(caption), _LONGEST_CAPTION))

    def _figure(self, block: Figure, room: tuple[float, float]) -> list[Flowable]:
        drawing = Drawing(self.drawings[block.name], room)
        self.placed.append(drawing)
        return [drawing, self._caption("Figure", block.name, block.caption)]

    def _facts(self, pairs: Sequence[tuple[Text, Text]]) -> Flowable:
        """Return the facts in two columns, or in twice two where all are short."""
        written = [(self.text(label), self.text(said)) for label, said in pairs]
        label = min(0.3 * self.width, 8 + max(width_of(name[:_LONG], "muted") for name, _ in written))
        widest = 8 + max(width_of(said[:_LONG], "cell") for _, said in written)
        twice = len(written) > 3 and label + widest < self.width / 2
        high = ceil(len(written) / 2) if twice else len(written)
        cells = [[paragraph(name, "muted"), paragraph(said, "cell")] for name, said in written]
        blank: list[Paragraph] = [paragraph("", "cell")] * 2
        rows = [[*cells[k], *([*cells, blank][k + high] if twice else [])] for k in range(high)]
        widths = [label, self.width / 2 - label] * 2 if twice else [label, self.width - label]
        grid = Grid(rows, colWidths=widths, hAlign="LEFT", spaceAfter=6, splitInRow=1)
        grid.setStyle([*BARE, ("BOTTOMPADDING", (0, 0), (-1, -1), 2), ("VALIGN", (0, 0), (-1, -1), "TOP")])
        grid.setStyle([("RIGHTPADDING", (0, 0), (-1, -1), 6)])
        return grid


def photograph(block: Photograph, width: float, height: float) -> Image | None:
    """Return a picture reduced to the room [pt]; None where the data are no picture."""
    try:
        data = base64.b64decode(block.data, validate=True)
        with Pillow.open(BytesIO(data), formats=("PNG", "JPEG")) as picture:
            picture.load()
            across, up = picture.size
    except (ValueError, OSError, SyntaxError, Pillow.DecompressionBombError):
        return None
    factor = min(_PIXEL, width / across, height / up)
    return Image(BytesIO(data), width=across * factor, height=up * factor)


def _fitting(text: str, width: float) -> float:
    """Return the size of letters at which the longest word of a verdict is no wider than `width` [pt]."""
    widest = max(width_of(word, "verdict") for word in text.split())
    return float(STYLES["verdict"].fontSize) * min(1.0, width / widest)
