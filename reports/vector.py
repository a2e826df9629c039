"""A matplotlib figure as marks on a PDF page: lines, areas and letters instead of pixels.

`trace` lets the figure draw itself once onto a recorder; `replay` draws the marks on a reportlab canvas.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.backend_bases import GraphicsContextBase, RendererBase
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.text import Text
from matplotlib.transforms import Transform
from reportlab.lib.colors import Color
from reportlab.pdfgen.canvas import Canvas
from reportlab.pdfgen.pathobject import PDFPathObject

from reports.style import styled

Rgba = tuple[float, float, float, float]
Segment = tuple[tuple[float, ...], int]
Rectangle = tuple[float, float, float, float]
_CAP = {"butt": 0, "round": 1, "projecting": 2}
_JOIN = {"miter": 0, "round": 1, "bevel": 2}


@dataclass(frozen=True)
class Stroke:
    """An outline with its line and its filling; lengths in points."""

    segments: tuple[Segment, ...]
    line: Rgba | None
    filling: Rgba | None
    width: float
    dashes: tuple[tuple[float, ...], float]
    cap: int
    join: int
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
class Traced:
    """A figure as marks, and its size [pt]."""

    marks: tuple[Stroke | Letters, ...]
    width: float
    height: float


class _Recorder(RendererBase):
    """A matplotlib renderer that writes down what it is asked to draw; origin at the lower left, unit 1 pt."""

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

    def draw_path(self, gc: GraphicsContextBase, path: Path, transform: Transform, rgbFace: Any = None) -> None:
        width = float(gc.get_linewidth())
        simplify = rgbFace is None and path.should_simplify
        segments = []
        for vertices, code in path.iter_segments(transform, simplify=simplify):
            at = np.asarray(vertices, dtype=np.float64)
            segments.append((tuple(at.tolist()), int(code)))
        offset, dashes = gc.get_dashes()
        clip = gc.get_clip_rectangle()
        self.marks.append(
            Stroke(
                segments=tuple(segments),
                line=_rgba(gc.get_rgb()) if width > 0 else None,
                filling=None if rgbFace is None else _filling(gc, rgbFace),
                width=width,
                dashes=(
                    () if dashes is None else tuple(np.asarray(dashes, dtype=np.float64).tolist()),
                    float(offset or 0),
                ),
                cap=_CAP[str(gc.get_capstyle())],
                join=_JOIN[str(gc.get_joinstyle())],
                clip=None if clip is None else (float(clip.x0), float(clip.y0), float(clip.width), float(clip.height)),
            )
        )

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


def trace(figure: Figure) -> Traced:
    """The figure as marks, in points."""
    with styled():
        figure.set_dpi(72)
        width, height = (float(72 * side) for side in figure.get_size_inches())
        recorder = _Recorder(width, height)
        figure.draw(recorder)
    return Traced(tuple(recorder.marks), width, height)


def replay(traced: Traced, canvas: Canvas, *, font: str, bold: str) -> None:
    """Draw the marks with the lower left corner at the canvas' origin, in the registered fonts `font` and `bold`."""
    for mark in traced.marks:
        canvas.saveState()
        if isinstance(mark, Stroke):
            _stroke(mark, canvas)
        else:
            _write(mark, canvas, bold if mark.bold else font)
        canvas.restoreState()


def _stroke(mark: Stroke, canvas: Canvas) -> None:
    if mark.clip is not None:
        window = canvas.beginPath()
        window.rect(*mark.clip)
        canvas.clipPath(window, stroke=0, fill=0)
    if mark.line is not None:
        canvas.setStrokeColor(Color(*mark.line))
        canvas.setLineWidth(mark.width)
        canvas.setLineCap(mark.cap)
        canvas.setLineJoin(mark.join)
        if mark.dashes[0]:
            canvas.setDash(list(mark.dashes[0]), mark.dashes[1])
    if mark.filling is not None:
        canvas.setFillColor(Color(*mark.filling))
    canvas.drawPath(_outline(mark, canvas), stroke=int(mark.line is not None), fill=int(mark.filling is not None))


def _outline(mark: Stroke, canvas: Canvas) -> PDFPathObject:
    outline = canvas.beginPath()
    x, y = 0.0, 0.0
    for at, code in mark.segments:
        if code == Path.CLOSEPOLY:
            outline.close()
            continue
        if code == Path.MOVETO:
            outline.moveTo(*at)
        elif code == Path.LINETO:
            outline.lineTo(*at)
        elif code == Path.CURVE4:
            outline.curveTo(*at)
        elif code == Path.CURVE3:
            (u, v, x1, y1) = at
            outline.curveTo((x + 2 * u) / 3, (y + 2 * v) / 3, (x1 + 2 * u) / 3, (y1 + 2 * v) / 3, x1, y1)
        x, y = at[-2:]
    return outline


def _write(mark: Letters, canvas: Canvas, font: str) -> None:
    canvas.translate(mark.x, mark.y)
    canvas.rotate(mark.angle)
    canvas.setFillColor(Color(*mark.colour))
    canvas.setFont(font, mark.size)
    canvas.drawString(0, 0, mark.text)


def _filling(gc: GraphicsContextBase, face: Any) -> Rgba:
    r, g, b, *alpha = map(float, face)
    opacity = gc.get_alpha() if gc.get_forced_alpha() or not alpha else alpha[0]
    return r, g, b, float(1.0 if opacity is None else opacity)


def _rgba(colour: Any) -> Rgba:
    r, g, b, *alpha = map(float, colour)
    return r, g, b, alpha[0] if alpha else 1.0
