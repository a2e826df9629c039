"""A figure's marks on a page."""

from __future__ import annotations

import io

import numpy as np
import pytest
from matplotlib.path import Path
from pypdf import PdfReader
from reportlab.pdfgen.canvas import Canvas

from reports.inking import operators, replay
from reports.vector import Stroke, Traced

POINTS = ((0.0, 0.0), (3.0, 6.0), (9.0, 0.0))


def test_a_curve_of_second_degree_is_drawn_as_one_of_the_third() -> None:
    (start, control, end) = map(np.array, POINTS)
    made = operators(((POINTS[0], int(Path.MOVETO)), ((*POINTS[1], *POINTS[2]), int(Path.CURVE3))))
    assert made.startswith("0.00 0.00 m ")
    one, two, three = np.array([float(x) for x in made.split()[3:-1]]).reshape(3, 2)
    for t in (0.25, 0.5, 0.9):
        s = 1 - t
        square = s**2 * start + 2 * s * t * control + t**2 * end
        cube = s**3 * start + 3 * s**2 * t * one + 3 * s * t**2 * two + t**3 * three
        assert cube == pytest.approx(square, abs=1e-2)


def stroke(line: str, clip: tuple[float, float, float, float] | None) -> Stroke:
    colour = {"red": (1.0, 0.0, 0.0, 1.0), "blue": (0.0, 0.0, 1.0, 1.0)}[line]
    segments = (((1.0, 2.0), int(Path.MOVETO)), ((3.0, 4.0), int(Path.LINETO)))
    return Stroke(segments, colour, None, 1.0, ((), 0.0), "butt", "miter", clip)


def test_pen_and_window_are_set_where_they_change() -> None:
    window = (0.0, 0.0, 50.0, 50.0)
    marks = (stroke("red", window), stroke("red", window), stroke("blue", window), stroke("blue", None))
    file = io.BytesIO()
    canvas = Canvas(file)
    replay(Traced(marks, 100.0, 100.0), canvas, font="Helvetica", bold="Helvetica-Bold")
    canvas.save()
    content = PdfReader(file).pages[0].get_contents()
    assert content is not None
    text = content.get_data().decode()
    assert text.count("1.0000 0.0000 0.0000 RG") == 1
    assert text.count("0.0000 0.0000 1.0000 RG") == 2  # the window has gone, and with it the pen
    assert text.count(" W* n") == 1
    assert text.split().count("S") == 4
