"""The marks of a figure on a reportlab canvas."""

from __future__ import annotations

from itertools import groupby

from matplotlib.path import Path
from reportlab.lib.colors import Color
from reportlab.pdfgen.canvas import Canvas
from reportlab.pdfgen.pathobject import PDFPathObject

from reports.vector import Letters, Rectangle, Segment, Stroke, Traced

_CAP = {"butt": 0, "projecting": 2, "round": 1}
_JOIN = {"miter": 0, "round": 1, "bevel": 2}
_OPERATORS = {int(Path.MOVETO): "m", int(Path.LINETO): "l", int(Path.CURVE3): "c", int(Path.CURVE4): "c"}


def replay(traced: Traced, canvas: Canvas, *, font: str, bold: str) -> None:
    """Draw the marks with the lower left corner at the canvas' origin, in the registered fonts `font` and `bold`."""
    for clip, marks in groupby(traced.marks, key=lambda mark: mark.clip if isinstance(mark, Stroke) else None):
        canvas.saveState()
        _clip(clip, canvas)
        last: Stroke | None = None
        for mark in marks:
            if isinstance(mark, Stroke):
                _stroke(mark, last, canvas)
                last = mark
            else:
                _write(mark, canvas, bold if mark.bold else font)
        canvas.restoreState()


def _clip(window: Rectangle | None, canvas: Canvas) -> None:
    if window is not None:
        outline = canvas.beginPath()
        outline.rect(*window)
        canvas.clipPath(outline, stroke=0, fill=0)


def _stroke(mark: Stroke, last: Stroke | None, canvas: Canvas) -> None:
    """One outline; what its line and filling share with the last one is set already."""
    if mark.line is not None and (last is None or _pen(mark) != _pen(last)):
        canvas.setStrokeColor(Color(*mark.line))
        canvas.setLineWidth(mark.width)
        canvas.setLineCap(_CAP[mark.cap])
        canvas.setLineJoin(_JOIN[mark.join])
        canvas.setDash(list(mark.dashes[0]), mark.dashes[1])
    if mark.filling is not None and (last is None or mark.filling != last.filling):
        canvas.setFillColor(Color(*mark.filling))
    outline = PDFPathObject(code=["n", *operators(mark.segments)])
    canvas.drawPath(outline, stroke=int(mark.line is not None), fill=int(mark.filling is not None))


def _pen(mark: Stroke) -> tuple[object, ...]:
    return mark.line, mark.width, mark.cap, mark.join, mark.dashes


def operators(segments: tuple[Segment, ...]) -> list[str]:
    """The outline in the operators of PDF, to 0.001 pt; a curve of second degree raised to the third."""
    made = []
    x, y = 0.0, 0.0
    for at, code in segments:
        if code == Path.CLOSEPOLY:
            made.append("h")
            continue
        if code == Path.CURVE3:
            u, v, x1, y1 = at
            at = ((x + 2 * u) / 3, (y + 2 * v) / 3, (x1 + 2 * u) / 3, (y1 + 2 * v) / 3, x1, y1)
        made.append(" ".join([*[f"{number:.3f}" for number in at], _OPERATORS[code]]))
        x, y = at[-2:]
    return made


def _write(mark: Letters, canvas: Canvas, font: str) -> None:
    canvas.saveState()
    canvas.translate(mark.x, mark.y)
    canvas.rotate(mark.angle)
    canvas.setFillColor(Color(*mark.colour))
    canvas.setFont(font, mark.size)
    canvas.drawString(0, 0, mark.text)
    canvas.restoreState()
