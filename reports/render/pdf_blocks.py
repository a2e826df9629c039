"""The blocks of a document as what reportlab puts on pages: text, figures, and tables that go on over pages."""

from __future__ import annotations

import base64
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from functools import cache, lru_cache, singledispatchmethod
from io import BytesIO
from itertools import groupby
from math import ceil
from typing import Any
from xml.sax.saxutils import escape

from matplotlib.path import Path
from PIL import Image as Pillow
from reportlab.lib.colors import Color, HexColor
from reportlab.lib.enums import TA_RIGHT
from reportlab.lib.styles import ParagraphStyle
from reportlab.lib.units import mm
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable, Image, LongTable, Paragraph, Spacer
from reportlab.platypus import Table as Grid

from reports.document import (
    Banner,
    Block,
    BulletList,
    Cell,
    Column,
    Equations,
    Facts,
    Figure,
    FigureRow,
    FileLines,
    OutcomeCell,
    Photograph,
    Prose,
    Sheet,
    Signatures,
    Table,
    WritingBox,
)
from reports.figures.style import BANNER, GRID, INK, MUTED, PAPER, font_file, printable
from reports.language.locale import Locale, mark_up, truncate
from reports.language.texts import Kind, Text, Verbatim
from reports.render.table_text import (
    SHEET_HEADS,
    SIGNATURE_HEADS,
    SheetRow,
    column_texts,
    equations_line,
    is_numeric,
    sheet_rows,
    verdict_word,
)
from reports.render.vector import FigureMarks, Letters, Rectangle, Rgba, Stroke, TracedFigures

_CAPTION = 26 * mm  # left for a caption below a figure as high as the page
_PHOTOGRAPH = 95 * mm  # height of a photograph at most
_PIXEL = 72 / 150  # of a photograph [pt]
_FIGURE_GAP = 8.0  # between figures side by side [pt]
_LONGEST_CAPTION, _LONGEST_NAME = 500, 60  # letters
_LONGEST_MEASURED = 120  # letters: a longer text is not measured
_VERDICT_MARGINS = 18.0  # of the left cell of the banner [pt]


class PlacedFigure(Flowable):
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
        draw_marks(self.figure, self.canv, font=REGULAR, bold=BOLD)


class BlockFlowables:
    """Makes flowables of blocks.

    width, height : of the text on a page [pt]
    placed : the figures made so far
    """

    def __init__(self, locale: Locale, drawings: TracedFigures, width: float, height: float) -> None:
        self.locale, self.drawings, self.width, self.height = locale, drawings, width, height
        self.text = locale.text
        self.placed: list[PlacedFigure] = []

    @singledispatchmethod
    def flowables(self, block: Block) -> list[Flowable]:
        """Return the flowables of a block."""
        raise TypeError(f"{type(block).__name__}: not a block of a document")

    @flowables.register
    def _(self, block: Prose) -> list[Flowable]:
        return [paragraph(self.text(each), "body") for each in block.paragraphs]

    @flowables.register
    def _(self, block: BulletList) -> list[Flowable]:
        return [paragraph(self.text(each), "item", bullet="•") for each in block.points] + [Spacer(1, 3)]

    @flowables.register
    def _(self, block: FileLines) -> list[Flowable]:
        return [*(paragraph(line, "code") for line in block.lines), Spacer(1, 6)]

    @flowables.register
    def _(self, block: Table) -> list[Flowable]:
        return [self._caption("Table", block.name, block.caption), _table_grid(block, self.locale, self.width)]

    @flowables.register
    def _(self, block: Sheet) -> list[Flowable]:
        return [self._caption("Sheet", block.name, block.caption), _sheet_grid(block, self.locale, self.width)]

    @flowables.register
    def _(self, block: Equations) -> list[Flowable]:
        lead = f"<b>{markup(self.text(block.lead))}</b> "
        return [Paragraph(lead + equations_line(block.steps, self.locale, formula), STYLES["equations"])]

    @flowables.register
    def _(self, block: Figure) -> list[Flowable]:
        return [*self._figure(block, (self.width, self.height - _CAPTION)), Spacer(1, 6)]

    @flowables.register
    def _(self, block: FigureRow) -> list[Flowable]:
        wide = (self.width - _FIGURE_GAP * (len(block.figures) - 1)) / len(block.figures)
        cells = [self._figure(figure, (wide, self.height - _CAPTION)) for figure in block.figures]
        widths = [wide + _FIGURE_GAP] * (len(cells) - 1) + [wide]
        grid = Grid([list(row) for row in zip(*cells, strict=True)], colWidths=widths, spaceAfter=5)
        grid.setStyle([*BARE, ("RIGHTPADDING", (0, 0), (-2, -1), _FIGURE_GAP), ("BOTTOMPADDING", (0, 0), (-1, 0), 2)])
        grid.setStyle([("VALIGN", (0, 0), (-1, 0), "MIDDLE"), ("VALIGN", (0, 1), (-1, 1), "TOP")])
        return [grid]

    @flowables.register
    def _(self, block: Photograph) -> list[Flowable]:
        made = photograph(block, self.width, _PHOTOGRAPH)
        return [*([made] if made else []), self._caption("Figure", block.name, block.caption), Spacer(1, 6)]

    @flowables.register
    def _(self, block: Facts) -> list[Flowable]:
        return [self._facts(block.pairs)] if block.pairs else []

    @flowables.register
    def _(self, block: WritingBox) -> list[Flowable]:
        box = Grid([[""]], colWidths=[self.width], rowHeights=[block.height * mm], spaceAfter=8)
        box.setStyle([("BOX", (0, 0), (-1, -1), 0.6, HexColor(MUTED))])
        return [paragraph(self.text(block.title), "caption"), box]

    @flowables.register
    def _(self, block: Signatures) -> list[Flowable]:
        named = [(self.text(role), truncate(self.text(name), _LONGEST_NAME)) for role, name in block.places]
        rows = [[paragraph(role, "muted"), paragraph(name, "cell"), "", ""] for role, name in named]
        heads = [paragraph(self.text(each), "muted") for each in SIGNATURE_HEADS]
        widths = [share * self.width for share in (0.19, 0.27, 0.27, 0.27)]
        grid = Grid([heads, *rows], colWidths=widths, rowHeights=[16, *[40] * len(rows)], spaceAfter=8)
        grid.setStyle([("LINEBELOW", (1, 1), (-1, -1), 0.6, HexColor(MUTED)), ("VALIGN", (0, 0), (-1, -1), "BOTTOM")])
        return [grid]

    @flowables.register
    def _(self, block: Banner) -> list[Flowable]:
        ink, word = HexColor(BANNER[block.outcome]), self.text(verdict_word(block))
        widths = [0.3 * self.width, 0.7 * self.width]
        size = _verdict_size(word, widths[0] - _VERDICT_MARGINS)
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
        return _titled_caption(self.locale.title(kind, name), truncate(self.text(caption), _LONGEST_CAPTION))

    def _figure(self, block: Figure, room: tuple[float, float]) -> list[Flowable]:
        drawing = PlacedFigure(self.drawings[block.name], room)
        self.placed.append(drawing)
        return [drawing, self._caption("Figure", block.name, block.caption)]

    def _facts(self, pairs: Sequence[tuple[Text, Text]]) -> Flowable:
        """Return the facts in two columns, or in twice two where all are short."""
        written = [(self.text(label), self.text(value)) for label, value in pairs]
        label = min(0.3 * self.width, 8 + max(width_of(name[:_LONGEST_MEASURED], "muted") for name, _ in written))
        widest = 8 + max(width_of(value[:_LONGEST_MEASURED], "cell") for _, value in written)
        twice = len(written) > 3 and label + widest < self.width / 2
        high = ceil(len(written) / 2) if twice else len(written)
        cells = [[paragraph(name, "muted"), paragraph(value, "cell")] for name, value in written]
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


TINT: Mapping[str, str] = {"pass": "#dcefe6", "fail": "#f8dfd6", "incomplete": "#faeccb", "comparison": "#e9ecef"}
INK_OF: Mapping[str, str] = {**BANNER, "comparison": MUTED}
_PADDING = 3.0  # left and right of a cell [pt]
_WIDEST, _LEAST = 0.5, 62.0  # share of the table that a text may ask for; width up to which words are not broken [pt]
_LOOSEST = 1.7  # a table is stretched so many times at most to fill its line
_DIVIDED = 260.0  # a row that has so much room and needs more is divided [pt]
_NARROWEST = 0.04  # share of the table that is left for a column without one
_LONGEST_HEAD = 120  # letters
_SHEET_SHARES = (0.11, 0.33, 0.39, 0.17)

_TABLE_STYLE: tuple[Any, ...] = (
    ("VALIGN", (0, 0), (-1, 0), "BOTTOM"),
    ("VALIGN", (0, 1), (-1, -1), "TOP"),
    ("LINEBELOW", (0, 0), (-1, 0), 0.7, HexColor(MUTED)),
    ("LINEBELOW", (0, 1), (-1, -1), 0.3, HexColor(GRID)),
    ("LEFTPADDING", (0, 0), (-1, -1), _PADDING),
    ("RIGHTPADDING", (0, 0), (-1, -1), _PADDING),
    ("TOPPADDING", (0, 0), (-1, -1), 1.4),
    ("BOTTOMPADDING", (0, 0), (-1, -1), 1.9),
)


class PagedTable(LongTable):
    """A table that goes on over pages; a row is divided only where it is higher than a good part of a page.

    start : height of the head and the first row, of which a higher one may be divided [pt]
    """

    start = 0.0

    def split(self, aW: float, aH: float) -> list[Any]:
        self.splitInRow = int(aH > _DIVIDED)
        return list(super().split(aW, aH))


def column_widths(rows: Sequence[Sequence[str]], shares: Sequence[float], width: float, style: str) -> list[float]:
    """Return the widths of columns [pt]: those with a share of `width` have it, the others what their cells need.

    rows : texts, the heads first, which may be folded
    shares : of the width, 0 for a column that shares what is left
    """
    free = [place for place, share in enumerate(shares) if not share]
    whole = max(1.0, sum(shares) + _NARROWEST * len(free))
    given = [share * width / whole for share in shares]
    columns = [[row[place] for row in rows] for place in free]
    least = [_padded(max(_word_width(text, style) for text in column)) for column in columns]
    lines = [[min(_WIDEST * width, _padded(_line_width(text, style))) for text in column] for column in columns]
    wanted = [max(low, *each[1:], 0.0) for low, each in zip(least, lines, strict=True)]
    easy = [max(want, each[0]) for want, each in zip(wanted, lines, strict=True)]
    found = _shared(least, wanted, easy, width - sum(given), fills=len(free) < len(shares))
    for place, own in zip(free, found, strict=True):
        given[place] = own
    return given


_CAP = {"butt": 0, "projecting": 2, "round": 1}
_JOIN = {"miter": 0, "round": 1, "bevel": 2}
_PLACE = "%.2f %.2f"  # a hundredth of a point is less than paper holds
_OPERATORS = {int(Path.MOVETO): f"{_PLACE} m", int(Path.LINETO): f"{_PLACE} l", int(Path.CLOSEPOLY): "h"}
_PAINT = {(True, True): "B", (True, False): "S", (False, True): "f", (False, False): "n"}  # a line, a filling

_SETTING: Mapping[str, Callable[[Canvas, Any], None]] = {
    "line": lambda canvas, ink: canvas.addLiteral("{:.4f} {:.4f} {:.4f} RG".format(*ink)),
    "opacity of lines": lambda canvas, alpha: canvas.setStrokeAlpha(alpha),
    "width": lambda canvas, width: canvas.addLiteral(f"{width:.3f} w"),
    "cap": lambda canvas, cap: canvas.setLineCap(_CAP[cap]),
    "join": lambda canvas, join: canvas.setLineJoin(_JOIN[join]),
    "dashes": lambda canvas, dashes: canvas.setDash(list(dashes[0]), dashes[1]),
    "filling": lambda canvas, ink: canvas.addLiteral("{:.4f} {:.4f} {:.4f} rg".format(*ink)),
    "opacity of fillings": lambda canvas, alpha: canvas.setFillAlpha(alpha),
}


def draw_marks(traced: FigureMarks, canvas: Canvas, *, font: str, bold: str) -> None:
    """Draw the marks with the lower left corner at the canvas' origin, in the registered fonts `font` and `bold`."""
    for clip, marks in groupby(traced.marks, key=lambda mark: mark.clip if isinstance(mark, Stroke) else None):
        canvas.saveState()
        _clip(clip, canvas)
        held: dict[str, object] = {}
        for mark in marks:
            if isinstance(mark, Stroke):
                _stroke(mark, held, canvas)
            else:
                _write(mark, canvas, bold if mark.bold else font)
        canvas.restoreState()


def operators(codes: bytes, numbers: tuple[float, ...]) -> str:
    """Return an outline in the operators of PDF."""
    return _shape(codes) % numbers


REGULAR, BOLD, ITALIC = "ReportSans", "ReportSans-Bold", "ReportSans-Italic"
_FACES = {REGULAR: "regular", BOLD: "bold", ITALIC: "italic"}
_INDEX, _POWER = '<sub rise="1.3" size="5.4">', '<super rise="2.4" size="5.4">'
_ROOT = ParagraphStyle(
    "root", fontName=REGULAR, fontSize=8.5, leading=11.3, textColor=HexColor(INK), splitLongWords=1, allowWidows=0
)
_CELL = ParagraphStyle("cell", _ROOT, fontSize=7.3, leading=9.1)
_SMALL = ParagraphStyle("small", _CELL, fontSize=6.3, leading=7.9)


def _bold(name: str, size: float, *, before: float = 0.0, after: float = 0.0) -> ParagraphStyle:
    leading = 1.25 * size
    return ParagraphStyle(
        name, _ROOT, fontName=BOLD, fontSize=size, leading=leading, spaceBefore=before, spaceAfter=after
    )


STYLES: Mapping[str, ParagraphStyle] = {
    "body": ParagraphStyle("body", _ROOT, spaceAfter=4),
    "item": ParagraphStyle("item", _ROOT, spaceAfter=2.5, leftIndent=11, bulletIndent=1),
    "code": ParagraphStyle("code", _ROOT, fontSize=7.6, leading=10.2, leftIndent=11, backColor=HexColor(PAPER)),
    "title": _bold("title", 17, after=2),
    "subject": ParagraphStyle("subject", _ROOT, fontSize=9.5, leading=13, textColor=HexColor(MUTED), spaceAfter=5),
    "verdict": _bold("verdict", 17),
    "heading-0": _bold("heading-0", 12.5, before=10, after=4),
    "heading-1": _bold("heading-1", 9.8, before=7, after=3),
    "contents": ParagraphStyle("contents", _ROOT, fontSize=8, leading=10.4),
    "caption": ParagraphStyle("caption", _CELL, spaceBefore=2, spaceAfter=3),
    "cell": _CELL,
    "equations": ParagraphStyle(
        "equations", _SMALL, leading=8.6, backColor=HexColor(PAPER), spaceBefore=3, spaceAfter=5
    ),
    "formula": ParagraphStyle("formula", _CELL, leading=10.6),
    "head": ParagraphStyle("head", _CELL, fontName=BOLD),
    "number": ParagraphStyle("number", _CELL, alignment=TA_RIGHT),
    "head-number": ParagraphStyle("head-number", _CELL, fontName=BOLD, alignment=TA_RIGHT),
    "small-cell": _SMALL,
    "small-head": ParagraphStyle("small-head", _SMALL, fontName=BOLD),
    "small-number": ParagraphStyle("small-number", _SMALL, alignment=TA_RIGHT),
    "small-head-number": ParagraphStyle("small-head-number", _SMALL, fontName=BOLD, alignment=TA_RIGHT),
    "running": ParagraphStyle("running", _ROOT, fontSize=7, leading=9, textColor=HexColor(MUTED)),
    "muted": ParagraphStyle("muted", _CELL, textColor=HexColor(MUTED)),
}

BARE = [(f"{side}PADDING", (0, 0), (-1, -1), 0) for side in ("LEFT", "RIGHT", "TOP", "BOTTOM")]
"""A grid without space around its cells."""


@cache
def register_fonts() -> None:
    """Make the report's fonts known to reportlab, once."""
    for name, face in _FACES.items():
        pdfmetrics.registerFont(TTFont(name, str(font_file(face))))
    pdfmetrics.registerFontFamily(REGULAR, normal=REGULAR, bold=BOLD, italic=ITALIC, boldItalic=BOLD)


def set_letters(canvas: Canvas, style: str) -> None:
    """Write on a canvas in one of STYLES."""
    canvas.setFont(STYLES[style].fontName, STYLES[style].fontSize)
    canvas.setFillColor(STYLES[style].textColor)


def markup(text: str) -> str:
    """Return plain text as reportlab markup that shows it letter for letter."""
    return escape(printable(text))


def paragraph(text: str, style: str, *, colour: str = "", bullet: str | None = None) -> Paragraph:
    """Return plain text as a paragraph in one of STYLES. colour: in place of the style's; bullet: before it."""
    chosen = STYLES[style]
    if colour:
        chosen = ParagraphStyle(f"{style}-{colour}", chosen, textColor=HexColor(colour))
    return Paragraph(markup(text), chosen, bulletText=bullet)


def formula(text: str) -> str:
    """Return a formula as reportlab markup, with its indices and powers."""
    return mark_up(markup(text), index=(_INDEX, "</sub>"), power=(_POWER, "</super>"))


def cut_to_width(text: str, width: float, style: str) -> str:
    """Return a text cut to a width [pt], with an ellipsis at its end."""
    if width_of(text, style) <= width:
        return text
    short = truncate(text, int(width / STYLES[style].fontSize * 4))  # no letter is narrower than a quarter of its size
    while len(short) > 1 and width_of(short, style) > width:
        short = truncate(short, len(short) - 1)
    return short


@lru_cache(maxsize=8192)
def width_of(text: str, style: str) -> float:
    """Return the width of one line of text [pt]."""
    return float(pdfmetrics.stringWidth(printable(text), STYLES[style].fontName, STYLES[style].fontSize))


def _verdict_size(text: str, width: float) -> float:
    """Return the size of letters at which the longest word of a verdict is no wider than `width` [pt]."""
    widest = max(width_of(word, "verdict") for word in text.split())
    return float(STYLES["verdict"].fontSize) * min(1.0, width / widest)


def _table_grid(table: Table, locale: Locale, width: float) -> PagedTable:
    """Return a table as wide as its cells need, at most `width` [pt]; with the head again on each page."""
    prefix = "small-" if table.small else ""
    columns = [tuple(row[place] for row in table.rows) for place in range(len(table.columns))]
    texts = (column_texts(*each, locale) for each in zip(columns, table.columns, strict=True))
    rows = [list(map(printable, row)) for row in zip(*texts, strict=True)]
    right = list(map(is_numeric, columns))
    heads = [printable(_head(column, locale)) for column in table.columns]
    widths = column_widths([heads, *rows], [column.share for column in table.columns], width, f"{prefix}head")
    styles = [f"{prefix}{'number' if each else 'cell'}" for each in right]
    shown = [f"{prefix}head{'-number' if each else ''}" for each in right]
    made: list[list[Any]] = [[paragraph(*each) for each in zip(heads, shown, strict=True)]]
    for place, cells in enumerate(table.rows):
        colour = MUTED if place in table.muted else ""
        made.append([_cell(*each, colour) for each in zip(cells, rows[place], styles, widths, strict=True)])
    cell = STYLES[f"{prefix}cell"]
    letters = [
        ("FONT", (0, 0), (-1, -1), cell.fontName, cell.fontSize, cell.leading),
        ("TEXTCOLOR", (0, 0), (-1, -1), cell.textColor),
    ]
    sides = [("ALIGN", (place, 0), (place, -1), "RIGHT") for place, each in enumerate(right) if each]
    return _grid(made, widths, [*letters, *sides, *_tints(table)])


def _sheet_grid(sheet: Sheet, locale: Locale, width: float) -> PagedTable:
    """Return a calculation sheet, `width` [pt] wide."""
    heads = [paragraph(locale.text(head), "head") for head in SHEET_HEADS]
    rows = [_step(row) for row in sheet_rows(sheet.steps, locale)]
    return _grid([list(heads), *rows], [share * width for share in _SHEET_SHARES], [])


def _head(column: Column, locale: Locale) -> str:
    """Return the head of a column, whose unit is kept where the label is cut."""
    label = truncate(locale.text(column.label), _LONGEST_HEAD)
    return locale.heading(Verbatim(label), column.dimension)


def _shared(
    least: Sequence[float], wanted: Sequence[float], easy: Sequence[float], left: float, *, fills: bool
) -> list[float]:
    """Return what each column gets of the width that is `left`, all of it where it `fills` a line.

    Needs are: `least`, of the longest words; `wanted`, of the longest lines; `easy`, with the head on one line too.
    """
    if sum(easy) <= left:
        return [each * min(left / sum(easy), left if fills else _LOOSEST) for each in easy]
    floors = (wanted, least, [0.0] * len(least))
    floor, enough = next(pair for pair in zip(floors, (easy, wanted, least), strict=True) if sum(pair[0]) <= left)
    return _filled(floor, enough, left)


def _padded(width: float) -> float:
    return width + 2 * _PADDING + 1


def _filled(floor: Sequence[float], wanted: Sequence[float], left: float) -> list[float]:
    """Return widths from `floor` up to what is `wanted`, the same more for each until nothing is left."""
    widths, spare = list(floor), left - sum(floor)
    order = sorted(range(len(floor)), key=lambda place: wanted[place] - floor[place])
    for waiting, place in zip(range(len(order), 0, -1), order, strict=True):
        more = min(wanted[place] - floor[place], spare / waiting)
        widths[place], spare = floor[place] + more, spare - more
    return widths


def _line_width(text: str, style: str) -> float:
    return width_of(text, style) if len(text) <= _LONGEST_MEASURED else 0.6 * float(STYLES[style].fontSize) * len(text)


def _word_width(text: str, style: str) -> float:
    return min(_LEAST, max((width_of(word, style) for word in text[:_LONGEST_MEASURED].split(" ")), default=0.0))


def _cell(cell: Cell, text: str, style: str, width: float, colour: str) -> str | Paragraph:
    """Return the text itself where one line has room for it, which reportlab draws at once, else a paragraph."""
    if isinstance(cell, OutcomeCell):
        ink = HexColor(INK_OF[cell.outcome])
        return Paragraph(f"<b>{markup(text)}</b>", STYLES[style].clone(f"{style}-{cell.outcome}", textColor=ink))
    if not colour and len(text) <= _LONGEST_MEASURED and width_of(text, style) <= width - 2 * _PADDING:
        return text
    return paragraph(text, style, colour=colour)


def _step(row: SheetRow) -> list[Any]:
    style = STYLES["formula"]
    clause = f'<br/><font color="{MUTED}">{markup(row.clause)}</font>' if row.clause else ""
    numbers = f"<br/>{formula(row.numbers)}" if row.numbers else ""
    beside = f"<br/>({markup(row.beside)})" if row.beside else ""
    texts = (
        formula(row.symbol),
        formula(row.description) + clause,
        formula(row.formula) + numbers,
        markup(row.result) + beside,
    )
    return [Paragraph(text, style) for text in texts]


def _tints(table: Table) -> Iterator[tuple[Any, ...]]:
    for row, cells in enumerate(table.rows, start=1):
        for column, cell in enumerate(cells):
            if isinstance(cell, OutcomeCell):
                yield ("BACKGROUND", (column, row), (column, row), HexColor(TINT[cell.outcome]))


def _grid(rows: Sequence[list[Any]], widths: Sequence[float], look: Sequence[Any]) -> PagedTable:
    made = PagedTable(rows, colWidths=widths, repeatRows=1, hAlign="LEFT", spaceAfter=8, style=[*_TABLE_STYLE, *look])
    made.start = min(_DIVIDED, sum(_height(row, widths) for row in rows[:2]))
    return made


def _height(row: Sequence[Any], widths: Sequence[float]) -> float:
    """Return the height of a row [pt]; one of single lines alone is lower than what is anyway left for it."""
    cells = zip(row, widths, strict=True)
    return max((cell.wrap(wide - 2 * _PADDING, 0)[1] for cell, wide in cells if isinstance(cell, Paragraph)), default=0)


def _clip(window: Rectangle | None, canvas: Canvas) -> None:
    if window is not None:
        outline = canvas.beginPath()
        outline.rect(*window)
        canvas.clipPath(outline, stroke=0, fill=0)


def _stroke(mark: Stroke, held: dict[str, object], canvas: Canvas) -> None:
    """Draw one outline; what is `held` already is not set again."""
    for name, value in (*_line(mark), *_filling(mark.filling)):
        if held.get(name) != value:
            held[name] = value
            _SETTING[name](canvas, value)
    paint = _PAINT[mark.line is not None, mark.filling is not None]
    canvas.addLiteral(f"n {operators(mark.codes, mark.numbers)} {paint}")


def _line(mark: Stroke) -> tuple[tuple[str, object], ...]:
    if mark.line is None:
        return ()
    ink = (("line", mark.line[:3]), ("opacity of lines", mark.line[3]))
    return (*ink, ("width", mark.width), ("cap", mark.cap), ("join", mark.join), ("dashes", mark.dashes))


def _filling(ink: Rgba | None) -> tuple[tuple[str, object], ...]:
    return () if ink is None else (("filling", ink[:3]), ("opacity of fillings", ink[3]))


@cache
def _shape(codes: bytes) -> str:
    """Return the operators with room for the numbers: outlines are ten thousands, shapes of them a hundred."""
    return " ".join([_OPERATORS[code] for code in codes])


def _write(mark: Letters, canvas: Canvas, font: str) -> None:
    canvas.saveState()
    canvas.translate(mark.x, mark.y)
    canvas.rotate(mark.angle)
    canvas.setFillColor(Color(*mark.colour))
    canvas.setFont(font, mark.size)
    canvas.drawString(0, 0, mark.text)
    canvas.restoreState()


def _titled_caption(title: str, caption: str, style: str = "caption") -> Paragraph:
    """Return "Figure 5. What it shows"."""
    return Paragraph(f"<b>{markup(title)}.</b> {markup(caption)}", STYLES[style])
