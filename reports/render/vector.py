"""A matplotlib figure as marks: lines, areas and letters instead of pixels.

`trace` lets the figure draw itself once onto a recorder; pdf_marks.py puts the marks on a page of the PDF, svg.py
writes them to a file of their own.
"""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.backend_bases import GraphicsContextBase, RendererBase
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.text import Text
from matplotlib.transforms import Transform

from reports.document import Document
from reports.figures.style import report_style
from reports.render.processes import Submit

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


Drawings = Mapping[str, Future[FigureMarks]]
"""Figures by name, each of which may still be in the making."""


def trace_figures(document: Document, submit: Submit) -> Drawings:
    """Trace every figure of the document once, by processes that work on the document; by name."""
    return {figure.name: submit(trace_at, place) for place, figure in enumerate(document.figures)}


def trace_at(document: Document, place: int) -> FigureMarks:
    """Return the figure at this place among those of the document as marks."""
    return trace_figure(document.figures[place].draw(document.writer))


def trace_figure(figure: Figure) -> FigureMarks:
    """Return the figure as marks, in points."""
    with report_style():
        FigureCanvasAgg(figure)  # letters are measured on it where the figure lays itself out
        figure.set_dpi(72)
        width, height = (float(72 * side) for side in figure.get_size_inches())
        recorder = _Recorder(width, height)
        figure.draw(recorder)
    return FigureMarks(tuple(recorder.marks), width, height)


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
