"""The marks of a figure as a PNG file."""

from __future__ import annotations

from pathlib import Path as File

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.font_manager import FontProperties
from matplotlib.image import imsave
from matplotlib.path import Path
from matplotlib.transforms import Affine2D, Bbox

from reports.figures.font import FAMILY
from reports.figures.style import report_style
from reports.render.vector import FigureMarks, Letters, Stroke

DPI = 200
_POINT = DPI / 72  # pixels


def write_png(traced: FigureMarks, path: File, *, creator: str) -> File:
    """Write the figure to `path`, on white; the path written. creator: name and version of the program."""
    renderer = RendererAgg(round(traced.width * _POINT), round(traced.height * _POINT), DPI)  # type: ignore[no-untyped-call]
    with report_style():
        for mark in (_background(traced), *traced.marks):
            if isinstance(mark, Stroke):
                _stroke(mark, renderer)
            else:
                _write(mark, renderer)
    pixels = np.asarray(renderer.buffer_rgba())  # type: ignore[no-untyped-call]
    imsave(path, pixels, format="png", metadata={"Software": creator}, pil_kwargs={"dpi": (DPI, DPI)})
    return path


def _background(traced: FigureMarks) -> Stroke:
    right, top = traced.width, traced.height
    codes = bytes((Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY))
    corners = (0.0, 0.0, right, 0.0, right, top, 0.0, top)
    return Stroke(codes, corners, None, (1.0, 1.0, 1.0, 1.0), 0.0, ((), 0.0), "butt", "miter", None)


def _stroke(mark: Stroke, renderer: RendererAgg) -> None:
    """Draw one outline; the renderer takes places in pixels, widths and dashes in points."""
    pen = renderer.new_gc()
    pen.set_linewidth(mark.width if mark.line is not None else 0.0)
    pen.set_foreground(mark.line or (0.0, 0.0, 0.0, 0.0), isRGBA=True)
    pen.set_capstyle(mark.cap)  # type: ignore[arg-type]
    pen.set_joinstyle(mark.join)  # type: ignore[arg-type]
    dashes, offset = mark.dashes
    pen.set_dashes(offset, dashes or None)
    if mark.clip is not None:
        x, y, wide, high = (side * _POINT for side in mark.clip)
        pen.set_clip_rectangle(Bbox.from_bounds(x, y, wide, high))
    renderer.draw_path(pen, _path(mark), Affine2D().scale(_POINT), mark.filling)  # type: ignore[no-untyped-call]


def _path(mark: Stroke) -> Path:
    """Return the outline as a path of matplotlib, in which closing has a point too, without meaning."""
    codes = np.frombuffer(mark.codes, dtype=np.uint8)
    points = np.zeros((codes.size, 2))
    points[codes != Path.CLOSEPOLY] = np.reshape(mark.numbers, (-1, 2))
    return Path(points, codes)


def _write(mark: Letters, renderer: RendererAgg) -> None:
    pen = renderer.new_gc()
    pen.set_foreground(mark.colour, isRGBA=True)
    font = FontProperties(family=FAMILY, size=mark.size, weight="bold" if mark.bold else "normal")
    place = (mark.x * _POINT, renderer.height - mark.y * _POINT)
    renderer.draw_text(pen, *place, mark.text, font, mark.angle)  # type: ignore[no-untyped-call]
