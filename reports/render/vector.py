"""A matplotlib figure as marks, lines, areas and letters instead of pixels, and as a file: SVG, PDF or PNG.

`trace_figure` lets the figure draw itself once onto a recorder; `pdf_blocks` puts the marks on a page of the PDF.
Letters of an SVG file are outlines, so that they look alike without the report's font. Where a process can be forked,
several trace the figures of a document while its pages are set.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import chain, groupby
from multiprocessing import get_context
from pathlib import Path as File
from typing import Any
from xml.sax.saxutils import escape, quoteattr

import numpy as np
from matplotlib.backend_bases import FigureCanvasBase, GraphicsContextBase, RendererBase
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.ft2font import FT2Font, LoadFlags
from matplotlib.path import Path
from matplotlib.text import Text
from matplotlib.transforms import Transform

from assess.outputs.writing import write_file
from assess.workers import become_worker, end_on_error, hold_signals
from reports.document import Document
from reports.figures.style import font_file, report_style

Rgba = tuple[float, float, float, float]
Rectangle = tuple[float, float, float, float]


@dataclass(frozen=True)
class Stroke:
    """An outline of straight lines with its line and its filling; lengths in points.

    codes : of matplotlib.path.Path, one each: MOVETO, LINETO, CLOSEPOLY
    numbers : x and y of all that move or draw, one after the other; closing needs none
    cap : "butt", "projecting" or "round"; join : "miter", "round" or "bevel"
    """

    codes: bytes
    numbers: tuple[float, ...]
    line: Rgba | None
    filling: Rgba | None
    width: float
    dashes: tuple[tuple[float, ...], float]
    cap: str
    join: str
    clip: Rectangle | None


@dataclass(frozen=True)
class Letters:
    """A line of text at (x, y) [pt], turned by `angle` [deg]."""

    text: str
    x: float
    y: float
    angle: float
    size: float
    bold: bool
    colour: Rgba


@dataclass(frozen=True)
class FigureMarks:
    """A figure as marks, and its size [pt]."""

    marks: tuple[Stroke | Letters, ...]
    width: float
    height: float


class _Recorder(RendererBase):
    """A matplotlib renderer that records what it draws; origin at the lower left, unit 1 pt."""

    def __init__(self, width: float, height: float) -> None:
        super().__init__()
        self.width, self.height = width, height
        self.marks: list[Stroke | Letters] = []

    def flipy(self) -> bool:
        return False

    def points_to_pixels(self, points: Any) -> Any:
        return points

    def get_canvas_width_height(self) -> tuple[float, float]:
        return self.width, self.height

    def get_text_width_height_descent(self, s: str, prop: FontProperties, ismath: Any) -> tuple[float, float, float]:
        return _text_size(s, prop.copy())

    def draw_path(self, gc: GraphicsContextBase, path: Path, transform: Transform, rgbFace: Any = None) -> None:
        width, (offset, dashes), clip = float(gc.get_linewidth()), gc.get_dashes(), gc.get_clip_rectangle()
        codes, numbers = _outline(path, transform, simplify=rgbFace is None and path.should_simplify)
        made = Stroke(
            codes,
            numbers,
            line=_rgba(gc.get_rgb()) if width > 0 else None,
            filling=None if rgbFace is None else _filling(gc, rgbFace),
            width=width,
            dashes=(() if dashes is None else tuple(np.asarray(dashes, dtype=float).tolist()), float(offset or 0)),
            cap=str(gc.get_capstyle()),
            join=str(gc.get_joinstyle()),
            clip=None if clip is None else (float(clip.x0), float(clip.y0), float(clip.width), float(clip.height)),
        )
        self.marks.append(made)

    def draw_text(
        self,
        gc: GraphicsContextBase,
        x: float,
        y: float,
        s: str,
        prop: FontProperties,
        angle: float,
        ismath: Any = False,
        mtext: Text | None = None,
    ) -> None:
        bold = str(prop.get_weight()) in {"bold", "700"}
        size = float(prop.get_size_in_points())
        self.marks.append(Letters(s, float(x), float(y), float(angle), size, bold, _rgba(gc.get_rgb())))


class _Canvas(FigureCanvasBase):
    """Where a figure finds the recorder while it lays itself out."""

    def __init__(self, figure: Figure, recorder: _Recorder) -> None:
        super().__init__(figure)
        self.recorder = recorder

    def get_renderer(self) -> _Recorder:
        return self.recorder


@lru_cache(maxsize=1 << 14)
def _text_size(text: str, font: FontProperties) -> tuple[float, float, float]:
    """Return width, height and descent [pt] of a line of text, which stands in many figures."""
    return RendererBase().get_text_width_height_descent(text, font, ismath=False)


TracedFigures = Mapping[str, Future[FigureMarks]]
"""Figures by name, each of which may still be under way."""


def trace_figures(document: Document, submit: Submit) -> TracedFigures:
    """Trace every figure of the document once, by processes that work on the document; by name."""
    return {figure.name: submit(_trace_figure_at, place) for place, figure in enumerate(document.figures)}


def trace_figure(figure: Figure) -> FigureMarks:
    """Return the figure as marks, in points."""
    with report_style():
        figure.set_dpi(72)
        width, height = (float(72 * side) for side in figure.get_size_inches())
        recorder = _Recorder(width, height)
        _Canvas(figure, recorder)
        figure.draw(recorder)
    return FigureMarks(tuple(recorder.marks), width, height)


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
class SvgPicture:
    """A figure in the elements of SVG; an id refers to the same element in all figures.

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


def svg_picture(traced: FigureMarks) -> SvgPicture:
    """Return the marks of a figure as elements."""
    letters = dict.fromkeys((m.bold, sign) for m in traced.marks if isinstance(m, Letters) for sign in m.text)
    windows = dict.fromkeys(m.clip for m in traced.marks if isinstance(m, Stroke) and m.clip is not None)
    definitions = {_name(*letter): f'<path id="{_name(*letter)}" d="{_glyph(*letter)[0]}"/>' for letter in letters}
    definitions |= {_pane(window): _window(window) for window in windows}
    marks = "\n".join(_elements(look, list(marks)) for look, marks in groupby(traced.marks, key=_attributes))
    return SvgPicture(marks, definitions, traced.width, traced.height)


def write_svg(picture: SvgPicture, path: File, *, creator: str) -> File:
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


def path_data(codes: bytes, numbers: tuple[float, ...]) -> str:
    """Return path data of SVG, to five figures."""
    return _shape(codes) % numbers


Submit = Callable[..., Future[Any]]
"""Submits a function, which is called with the subject and then the arguments, and returns the future of its result."""
_kept: object = None  # the subject; set in copies of this process only


@contextmanager
def document_processes(jobs: int, subject: object) -> Iterator[Submit]:
    """Provide `jobs` copies of this process to work on a subject, however large; this one at 1 and if not on Linux.

    Copies need not import anything again, and have no threads but their own. None of this program's holds a lock at
    that moment: those of the dynamics have ended, that of the progress bar locks its console only, to which no copy
    writes. Python warns all the same.
    """
    if jobs == 1 or sys.platform != "linux":
        yield lambda function, *arguments: _done(function(subject, *arguments))
        return
    fork = get_context("fork")
    pool = ProcessPoolExecutor(jobs, mp_context=fork, initializer=become_worker, initargs=(_keep, subject))

    def submit(function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        with hold_signals(), warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*use of fork", category=DeprecationWarning)
            return pool.submit(_of_kept, function, *arguments)

    with end_on_error(pool):
        yield submit


def write_png(figure: Figure, path: File, creator: str) -> None:
    """Write a figure as pixels. creator: name and version of the program."""
    with report_style():
        figure.savefig(path, dpi=PNG_DPI, metadata={"Software": creator})


def _outline(path: Path, transform: Transform, *, simplify: bool) -> tuple[bytes, tuple[float, ...]]:
    """Return codes and numbers of a path, cleaned by matplotlib: without what is not a number, curves as lines."""
    clean = path.cleaned(transform=transform, remove_nans=True, simplify=simplify)
    codes = np.asarray(clean.codes, dtype=np.uint8)
    drawn = codes[: codes.tobytes().index(Path.STOP)]
    points = np.asarray(clean.vertices)[: drawn.size][drawn != Path.CLOSEPOLY]
    return drawn.tobytes(), tuple(points.ravel().tolist())


def _filling(gc: GraphicsContextBase, face: Any) -> Rgba:
    r, g, b, *alpha = map(float, face)
    opacity = gc.get_alpha() if gc.get_forced_alpha() or not alpha else alpha[0]
    return r, g, b, float(1.0 if opacity is None else opacity)


def _rgba(colour: Any) -> Rgba:
    r, g, b, *alpha = map(float, colour)
    return r, g, b, alpha[0] if alpha else 1.0


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


def _attributes(mark: Stroke | Letters) -> str:
    """Return the attributes of a mark but its colours: of the thousand faces of a body they are all alike."""
    if isinstance(mark, Letters):
        return ""
    clip = "" if mark.clip is None else f' clip-path="url(#{_pane(mark.clip)})"'
    return clip + _pen(mark)


def _stroke(mark: Stroke, look: str = "") -> str:
    line = "" if mark.line is None else _paint("stroke", mark.line)
    return f'<path d="{path_data(mark.codes, mark.numbers)}"{_paint("fill", mark.filling)}{line}{look}/>'


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
    data = path_data(bytes(code for _, code in segments), tuple(numbers))
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


PNG_DPI = 200


def _write_svg_figure(figure: Figure, path: File, creator: str) -> None:
    write_svg(svg_picture(trace_figure(figure)), path, creator=creator)


def _write_pdf_figure(figure: Figure, path: File, creator: str) -> None:
    with report_style():
        figure.savefig(path, metadata={"Creator": creator, "CreationDate": None})


WRITERS: Mapping[str, Callable[[Figure, File, str], None]] = {
    ".svg": _write_svg_figure,
    ".pdf": _write_pdf_figure,
    ".png": write_png,
}


def write_figure(figure: Figure, path: File, *, creator: str) -> File:
    """Write a figure in the report's style to a file, whole or not at all.

    Parameters
    ----------
    figure : of matplotlib
    path : its ending names the form
    creator : for the metadata of the file

    Returns
    -------
    The path written.
    """
    with write_file(path, command="a command that draws a figure") as made:
        WRITERS[path.suffix.lower()](figure, made, creator)
    return path


def _trace_figure_at(document: Document, place: int) -> FigureMarks:
    """Return the figure at this place among those of the document as marks."""
    return trace_figure(document.figures[place].draw(document.writer))


def _done(answer: object) -> Future[Any]:
    done: Future[Any] = Future()
    done.set_result(answer)
    return done


def _keep(subject: object) -> None:
    global _kept
    _kept = subject


def _of_kept(function: Callable[..., Any], *arguments: Any) -> Any:
    return function(_kept, *arguments)
