"""The marks of a figure as an SVG file; letters are outlines, so that they look alike without the report's font."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from itertools import chain, groupby
from pathlib import Path as File
from xml.sax.saxutils import escape, quoteattr

from matplotlib.ft2font import FT2Font, LoadFlags
from matplotlib.path import Path

from reports.figures.font import font_file
from reports.render.vector import FigureMarks, Letters, Rectangle, Rgba, Stroke

_PLACE = "%.5g %.5g"  # a hundredth of a point on a page
_COMMANDS = {
    int(Path.MOVETO): f"M{_PLACE}",
    int(Path.LINETO): f"L{_PLACE}",
    int(Path.CURVE3): f"Q{_PLACE} {_PLACE}",
    int(Path.CURVE4): f"C{_PLACE} {_PLACE} {_PLACE}",
    int(Path.CLOSEPOLY): "Z",
}
_CAP = {"projecting": "square"}
_EM = 100.0  # size at which the outline of a letter is taken [pt]


@dataclass(frozen=True)
class Picture:
    """A figure in the elements of SVG; an id refers to the same element in all figures.

    Attributes
    ----------
    marks : its elements, y upwards
    definitions : letters and windows by their ids
    width, height : [pt]
    """

    marks: str
    definitions: Mapping[str, str]
    width: float
    height: float

    @property
    def box(self) -> str:
        """The attribute for the visible part of the plane."""
        return f'viewBox="0 0 {self.width:g} {self.height:g}"'

    @property
    def upright(self) -> str:
        """The marks as SVG, y downwards."""
        return f'<g transform="matrix(1 0 0 -1 0 {self.height:g})">\n{self.marks}\n</g>'


def picture(traced: FigureMarks) -> Picture:
    """Return the marks of a figure as elements."""
    letters = dict.fromkeys((m.bold, sign) for m in traced.marks if isinstance(m, Letters) for sign in m.text)
    windows = dict.fromkeys(m.clip for m in traced.marks if isinstance(m, Stroke) and m.clip is not None)
    definitions = {_name(*letter): f'<path id="{_name(*letter)}" d="{_glyph(*letter)[0]}"/>' for letter in letters}
    definitions |= {_pane(window): _window(window) for window in windows}
    marks = "\n".join(_elements(look, list(marks)) for look, marks in groupby(traced.marks, key=_look))
    return Picture(marks, definitions, traced.width, traced.height)


def write_svg(picture: Picture, path: File, *, creator: str) -> File:
    """Write a picture to `path`; the path written. creator: name and version of the program."""
    lines = [
        '<?xml version="1.0" encoding="utf-8" standalone="no"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" version="1.1"'
        f' width="{picture.width:g}pt" height="{picture.height:g}pt" {picture.box}>',
        f"<desc>{escape(creator)}</desc>",
        "<defs>",
        *picture.definitions.values(),
        "</defs>",
        picture.upright,
        "</svg>",
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def outline(codes: bytes, numbers: tuple[float, ...]) -> str:
    """Return path data of SVG, to five figures."""
    return _shape(codes) % numbers


@cache
def _shape(codes: bytes) -> str:
    """Return the commands with room for the numbers."""
    return "".join([_COMMANDS[code] for code in codes])


def _window(clip: Rectangle) -> str:
    x, y, wide, high = map(_number, clip)
    rectangle = f'<rect x="{x}" y="{y}" width="{wide}" height="{high}"/>'
    return f'<clipPath id="{_pane(clip)}">{rectangle}</clipPath>'


def _pane(clip: Rectangle) -> str:
    return "w" + "_".join(map(_number, clip))


def _elements(look: str, marks: list[Stroke | Letters]) -> str:
    """Return neighbours of one look as elements, which share its attributes where there are several."""
    if len(marks) == 1 and isinstance(marks[0], Stroke):
        return _stroke(marks[0], look)
    made = "\n".join(_stroke(mark) if isinstance(mark, Stroke) else _line_of(mark) for mark in marks)
    return f"<g{look}>\n{made}\n</g>" if look else made


def _look(mark: Stroke | Letters) -> str:
    """Return the attributes of a mark but its colours: of the thousand faces of a body they are all alike."""
    if isinstance(mark, Letters):
        return ""
    clip = "" if mark.clip is None else f' clip-path="url(#{_pane(mark.clip)})"'
    return clip + _pen(mark)


def _stroke(mark: Stroke, look: str = "") -> str:
    line = "" if mark.line is None else _paint("stroke", mark.line)
    return f'<path d="{outline(mark.codes, mark.numbers)}"{_paint("fill", mark.filling)}{line}{look}/>'


def _pen(mark: Stroke) -> str:
    if mark.line is None:
        return ""
    dashes, offset = mark.dashes
    cap = _CAP.get(mark.cap, mark.cap)
    dashed = f' stroke-dasharray="{",".join(map(_number, dashes))}" stroke-dashoffset="{_number(offset)}"'
    return (
        f' stroke-width="{_number(mark.width)}" stroke-linecap="{cap}"'
        f' stroke-linejoin="{mark.join}"{dashed if dashes else ""}'
    )


def _paint(what: str, colour: Rgba | None) -> str:
    if colour is None:
        return f' {what}="none"'
    red, green, blue, opacity = colour
    solid = f"#{round(255 * red):02x}{round(255 * green):02x}{round(255 * blue):02x}"
    return f' {what}="{solid}"' + ("" if opacity == 1.0 else f' {what}-opacity="{_number(opacity)}"')


def _line_of(mark: Letters) -> str:
    """Return a line of text: its letters as outlines, and the text itself for screen readers."""
    pen, used = 0.0, []
    for sign in mark.text:
        used.append(f'<use xlink:href="#{_name(mark.bold, sign)}" x="{_number(pen)}"/>')
        pen += _glyph(mark.bold, sign)[1]
    turn = f" rotate({_number(mark.angle)})" if mark.angle else ""
    place = f"translate({_number(mark.x)} {_number(mark.y)}){turn} scale({_number(mark.size / _EM)})"
    label = f' role="img" aria-label={quoteattr(mark.text)}' if mark.text.strip() else ""
    return f'<g transform="{place}"{_paint("fill", mark.colour)}{label}>{"".join(used)}</g>'


@cache
def _glyph(bold: bool, sign: str) -> tuple[str, float]:
    """Return outline of a letter as path data, and how far the next one is from it, at a size of 100 pt."""
    font = _font(bold)
    glyph = font.load_char(ord(sign), flags=LoadFlags.NO_HINTING)
    vertices, codes = font.get_path()
    segments = [(at, int(code)) for at, code in Path(vertices, codes).iter_segments(simplify=False)]
    numbers = chain.from_iterable(at.tolist() for at, code in segments if code != Path.CLOSEPOLY)
    data = outline(bytes(code for _, code in segments), tuple(numbers))
    return data, glyph.linearHoriAdvance / 65536


@cache
def _font(bold: bool) -> FT2Font:
    font = FT2Font(str(font_file("bold" if bold else "regular")))
    font.set_size(_EM, 72)
    return font


def _name(bold: bool, sign: str) -> str:
    return f"{'b' if bold else 'r'}{ord(sign):x}"


def _number(value: float) -> str:
    return f"{value:.5g}"
