"""A figure's marks on a page."""

from __future__ import annotations

import io

from matplotlib.path import Path
from pypdf import PdfReader
from reportlab.pdfgen.canvas import Canvas

from reports.render.pdf_blocks import draw_marks, operators
from reports.render.vector import FigureMarks, Stroke


def test_outlines_in_the_operators_of_pdf() -> None:
    codes = bytes((Path.MOVETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY, Path.MOVETO, Path.LINETO))
    made = operators(codes, (0.0, 0.0, 3.0, 6.0, 9.0, 0.004, 1.0, 1.0, 2.5, 2.0))
    assert made == "0.00 0.00 m 3.00 6.00 l 9.00 0.00 l h 1.00 1.00 m 2.50 2.00 l"


def stroke(line: str, clip: tuple[float, float, float, float] | None) -> Stroke:
    colour = {"red": (1.0, 0.0, 0.0, 1.0), "blue": (0.0, 0.0, 1.0, 1.0)}[line]
    codes = bytes((Path.MOVETO, Path.LINETO))
    return Stroke(codes, (1.0, 2.0, 3.0, 4.0), colour, None, 1.0, ((), 0.0), "butt", "miter", clip)


def test_pen_and_window_are_set_where_they_change() -> None:
    window = (0.0, 0.0, 50.0, 50.0)
    marks = (stroke("red", window), stroke("red", window), stroke("blue", window), stroke("blue", None))
    file = io.BytesIO()
    canvas = Canvas(file)
    draw_marks(FigureMarks(marks, 100.0, 100.0), canvas, font="Helvetica", bold="Helvetica-Bold")
    canvas.save()
    content = PdfReader(file).pages[0].get_contents()
    assert content is not None
    text = content.get_data().decode()
    assert text.count("1.0000 0.0000 0.0000 RG") == 1
    assert text.count("0.0000 0.0000 1.0000 RG") == 2  # the window has gone, and with it the pen
    assert text.count(" W* n") == 1
    assert text.split().count("S") == 4
