"""Fonts and paragraphs of the PDF. Text becomes reportlab markup here and only here, escaped."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from xml.sax.saxutils import escape

from reportlab.lib.colors import HexColor
from reportlab.lib.enums import TA_RIGHT
from reportlab.lib.styles import ParagraphStyle
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Paragraph

from reports.figures.style import INK, MUTED, PAPER, font_file, printable
from reports.language.lettering import mark_up, truncate

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


def titled_caption(title: str, caption: str, style: str = "caption") -> Paragraph:
    """Return "Figure 5. What it shows"."""
    return Paragraph(f"<b>{markup(title)}.</b> {markup(caption)}", STYLES[style])


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
