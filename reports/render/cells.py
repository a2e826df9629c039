"""The text of a table's cell: broken into lines once, and drawn without the cost of a paragraph.

A report has twenty thousand cells. Lines break where a paragraph of reportlab breaks them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import groupby

from reportlab.lib.colors import Color, HexColor
from reportlab.lib.enums import TA_RIGHT
from reportlab.pdfbase.pdfmetrics import stringWidth
from reportlab.pdfgen.canvas import Canvas
from reportlab.pdfgen.textobject import PDFTextObject

from reports.figures.font import printable
from reports.language.formula import split_formula
from reports.render.typeset import STYLES

_SHRUNK = 0.05  # of a space, by which each space of a line may be too wide: where reportlab breaks lines
_SPACES = re.compile(r"[^\S\u00a0]+")
_LOWERED, _RAISED, _SIZE_OF_INDEX = -1.2, 2.4, 5.2  # [pt]


@dataclass(frozen=True)
class Look:
    """How letters look. rise : of their feet above the line [pt]; colour : "#rrggbb"."""

    font: str
    size: float
    colour: str
    rise: float = 0.0


Piece = tuple[str, Look]
"""Text in one look."""


@dataclass(frozen=True)
class Word:
    """Adjacent pieces and their width [pt]; also a line of text."""

    pieces: tuple[Piece, ...]
    width: float


@dataclass(frozen=True)
class Cell:
    """Text broken into lines for a cell of `width`; lengths in points."""

    lines: tuple[Word, ...]
    width: float
    size: float
    leading: float
    right: bool

    @property
    def height(self) -> float:
        """Height of all lines [pt]."""
        return self.leading * len(self.lines)

    def place_lines(self, x: float, top: float) -> Iterator[tuple[Word, float, float]]:
        """Yield each line and where it begins, for a cell whose upper left corner is at (x, top)."""
        for place, line in enumerate(self.lines):
            indent = self.width - line.width if self.right else 0.0
            yield line, x + indent, top - self.size - place * self.leading


def plain_cell(text: str, style: str, *, width: float) -> Cell:
    """Return a cell of plain text in one of STYLES."""
    return cell([text_pieces(text, style)], style, width=width)


def cell(paragraphs: Iterable[Sequence[Piece]], style: str, *, width: float) -> Cell:
    """Return a cell of paragraphs, set as in one of STYLES."""
    of = STYLES[style]
    lines = tuple(line for pieces in paragraphs for line in _lines(pieces, width=width))
    return Cell(lines, width, of.fontSize, of.leading, of.alignment == TA_RIGHT)


def text_pieces(text: str, style: str) -> list[Piece]:
    """Return plain text in one of STYLES."""
    return [(_spaced(text), _look(style))]


def formula_pieces(text: str) -> list[Piece]:
    """Return plain text of which indices are lowered and powers raised."""
    base = _look("cell")
    index, power = (Look(base.font, _SIZE_OF_INDEX, base.colour, rise) for rise in (_LOWERED, _RAISED))
    looks = {"": base, "index": index, "power": power}
    return [(part, looks[kind]) for part, kind in split_formula(_spaced(text))]


def draw_cells(canvas: Canvas, cells: Iterable[tuple[Cell, float, float]]) -> None:
    """Draw cells by their upper left corners, as one text: each cell, x, top."""
    text, last = canvas.beginText(), None
    for cell, left, top in cells:
        for line, x, y in cell.place_lines(left, top):
            text.setTextOrigin(x, y)
            for letters, look in line.pieces:
                _change(text, look, last)
                text.textOut(letters)
                last = look
    canvas.drawText(text)


def _change(text: PDFTextObject, look: Look, last: Look | None) -> None:
    """Set what differs from the last look."""
    if last is None or look.colour != last.colour:
        text.setFillColor(_colour(look.colour))
    if last is None or (look.font, look.size) != (last.font, last.size):
        text.setFont(look.font, look.size)
    if look.rise != (last.rise if last else 0.0):
        text.setRise(look.rise)


@cache
def _colour(code: str) -> Color:
    colour: Color = HexColor(code)
    return colour


@cache
def _look(style: str) -> Look:
    of = STYLES[style]
    return Look(of.fontName, of.fontSize, f"#{of.textColor.hexval()[2:]}")


def _spaced(text: str) -> str:
    """Return `text` in letters of the font, with one plain space between words; a no-break space is a letter."""
    return " ".join(_SPACES.split(printable(text))).strip(" ")


def _lines(pieces: Sequence[Piece], *, width: float) -> list[Word]:
    """Return one paragraph, as wide as `width` at most; most paragraphs of tables have one line."""
    whole = _word(pieces)
    if whole.width <= width:
        return [whole]
    space = (" ", pieces[0][1])
    wide = _width(space)
    lines, used = [list[Word]()], -wide
    for word in _words(pieces):
        room = width - used - wide
        if word.width <= room + _SHRUNK * wide * len(lines[-1]):
            lines[-1].append(word)
            used += wide + word.width
        elif word.width <= width:
            lines.append([word])
            used = word.width
        else:
            first, *rest = _cut(word, room, width)
            lines[-1] += [first] if first.pieces else []
            lines += [[part] for part in rest]
            used = lines[-1][-1].width
    return [_joined(line, space) for line in lines]


def _words(pieces: Iterable[Piece]) -> list[Word]:
    """Return the words of a paragraph."""
    words: list[list[Piece]] = [[]]
    for text, look in pieces:
        first, *others = text.split(" ")
        words[-1].append((first, look))
        words += [[(each, look)] for each in others]
    return [_word([piece for piece in word if piece[0]]) for word in words]


def _cut(word: Word, first: float, width: float) -> list[Word]:
    """Return a word too long for a line, cut between letters: what has room in `first`, then in `width` each."""
    cuts, used, room = [list[Piece]()], 0.0, first
    for letter in ((sign, look) for text, look in word.pieces for sign in text):
        wide = _width(letter)
        if used + wide > room and (cuts[-1] or len(cuts) == 1):
            cuts.append([])
            used, room = 0.0, width
        cuts[-1].append(letter)
        used += wide
    return [_word(_merged(letters)) for letters in cuts]


def _joined(words: Sequence[Word], space: Piece) -> Word:
    """Return the words as one line."""
    first, others = words[:1], words[1:]
    pieces = [piece for word in first for piece in word.pieces]
    pieces += [piece for word in others for piece in (space, *word.pieces)]
    return Word(tuple(_merged(pieces)), sum(word.width for word in words) + len(others) * _width(space))


def _merged(pieces: Iterable[Piece]) -> list[Piece]:
    """Return neighbours of one look as one piece."""
    return [("".join(text for text, _ in same), look) for look, same in groupby(pieces, key=lambda piece: piece[1])]


def _word(pieces: Sequence[Piece]) -> Word:
    return Word(tuple(pieces), sum(map(_width, pieces)))


def _width(piece: Piece) -> float:
    text, look = piece
    return stringWidth(text, look.font, look.size)
