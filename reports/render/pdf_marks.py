"""The marks of a figure on a reportlab canvas."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from itertools import groupby
from typing import Any

from matplotlib.path import Path
from reportlab.lib.colors import Color
from reportlab.pdfgen.canvas import Canvas

from reports.render.vector import FigureMarks, Letters, Rectangle, Rgba, Stroke

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


def replay(traced: FigureMarks, canvas: Canvas, *, font: str, bold: str) -> None:
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


def operators(codes: bytes, numbers: tuple[float, ...]) -> str:
    """Return an outline in the operators of PDF."""
    return _shape(codes) % numbers


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
