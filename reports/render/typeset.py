"""Fonts and paragraphs of the PDF. Text becomes reportlab markup here and only here, escaped."""

from __future__ import annotations

from functools import cache, lru_cache
from xml.sax.saxutils import escape

from reportlab.lib.colors import HexColor
from reportlab.lib.enums import TA_RIGHT
from reportlab.lib.styles import ParagraphStyle
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont
from reportlab.platypus import Paragraph

from reports.figures.font import font_file, printable
from reports.figures.style import FAIL, INK, MUTED, PAPER, PASS

REGULAR, BOLD, ITALIC = "ReportSans", "ReportSans-Bold", "ReportSans-Italic"
_FACES = {REGULAR: "regular", BOLD: "bold", ITALIC: "italic"}
_ROOT = ParagraphStyle("root", fontName=REGULAR, fontSize=8.3, leading=11.6, textColor=HexColor(INK), splitLongWords=1)
_CELL = ParagraphStyle("cell", _ROOT, fontSize=6.7, leading=8.7)

STYLES: dict[str, ParagraphStyle] = {
    "body": ParagraphStyle("body", _ROOT, spaceAfter=5),
    "item": ParagraphStyle("item", _ROOT, spaceAfter=4, leftIndent=11, bulletIndent=1),
    "code": ParagraphStyle("code", _ROOT, fontSize=7.6, leading=10.4, leftIndent=11, backColor=HexColor(PAPER)),
    "title": ParagraphStyle("title", _ROOT, fontName=BOLD, fontSize=19, leading=24, spaceAfter=3),
    "subject": ParagraphStyle("subject", _ROOT, fontSize=10, leading=14, textColor=HexColor(MUTED), spaceAfter=9),
    "verdict": ParagraphStyle("verdict", _ROOT, fontName=BOLD, fontSize=19, leading=24, leftIndent=4),
    "heading-0": ParagraphStyle(
        "heading-0", _ROOT, fontName=BOLD, fontSize=13.5, leading=17, spaceBefore=12, spaceAfter=6
    ),
    "heading-1": ParagraphStyle(
        "heading-1", _ROOT, fontName=BOLD, fontSize=10.5, leading=14, spaceBefore=9, spaceAfter=4
    ),
    "contents-0": ParagraphStyle("contents-0", _ROOT),
    "contents-1": ParagraphStyle("contents-1", _ROOT, fontSize=7.6, leading=10, textColor=HexColor(MUTED)),
    "caption": ParagraphStyle("caption", _CELL, fontSize=7.4, leading=9.6, textColor=HexColor(INK)),
    "cell": _CELL,
    "number": ParagraphStyle("number", _CELL, alignment=TA_RIGHT),
    "head": ParagraphStyle("head", _CELL, fontName=BOLD),
    "head-number": ParagraphStyle("head-number", _CELL, fontName=BOLD, alignment=TA_RIGHT),
    "muted": ParagraphStyle("muted", _CELL, textColor=HexColor(MUTED)),
    "muted-number": ParagraphStyle("muted-number", _CELL, textColor=HexColor(MUTED), alignment=TA_RIGHT),
    "pass": ParagraphStyle("pass", _CELL, fontName=BOLD, textColor=HexColor(PASS)),
    "fail": ParagraphStyle("fail", _CELL, fontName=BOLD, textColor=HexColor(FAIL)),
}
SMALL = "-small"  # the ending of the styles of tables with many columns
_OF_TABLES = ("cell", "number", "head", "head-number", "muted", "muted-number", "pass", "fail")
STYLES |= {f"{name}{SMALL}": STYLES[name].clone(f"{name}{SMALL}", fontSize=5.7, leading=7.5) for name in _OF_TABLES}


class Lines(Paragraph):
    """A paragraph that is broken into lines once for a width."""

    _for: float | None = None

    def wrap(self, availWidth: float, availHeight: float) -> tuple[float, float]:
        if self._for != availWidth or not hasattr(self, "blPara"):  # splitting over pages takes the lines away
            self._for, self._size = availWidth, super().wrap(availWidth, availHeight)
        return self._size


@cache
def register_fonts() -> None:
    """Make the report's fonts known to reportlab, once."""
    for name, face in _FACES.items():
        pdfmetrics.registerFont(TTFont(name, str(font_file(face))))
    pdfmetrics.registerFontFamily(REGULAR, normal=REGULAR, bold=BOLD, italic=ITALIC, boldItalic=BOLD)


def markup(text: str) -> str:
    """Return plain text as reportlab markup that shows it letter for letter."""
    return escape(printable(text))


def paragraph(text: str, style: str) -> Lines:
    """Return plain text as a paragraph in one of STYLES."""
    return Lines(markup(text), STYLES[style])


@lru_cache(maxsize=8192)
def width_of(text: str, style: str) -> float:
    """Return the width of one line of text [pt]."""
    return pdfmetrics.stringWidth(printable(text), STYLES[style].fontName, STYLES[style].fontSize)
