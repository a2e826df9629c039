"""A figure as marks on a page."""

from __future__ import annotations

import pytest
from matplotlib.patches import Circle
from matplotlib.path import Path

from reports.style import PROCEDURES, pen, sheet, styled
from reports.vector import Letters, Stroke, trace


def test_a_line_lands_where_the_axes_put_it() -> None:
    with styled():
        figure = sheet(2.0, width=4.0)
        figure.set_layout_engine("none")
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0, 4), ylim=(0, 2))
        axes.set_axis_off()
        axes.plot([1, 3], [0.5, 1.5], color=(1.0, 0.0, 0.0))
    traced = trace(figure)
    line = next(mark for mark in traced.marks if isinstance(mark, Stroke) and mark.line == (1.0, 0.0, 0.0, 1.0))
    assert (traced.width, traced.height) == (288.0, 144.0)
    assert [code for _, code in line.segments] == [Path.MOVETO, Path.LINETO]
    assert line.segments[0][0] == pytest.approx((72, 36))
    assert line.segments[1][0] == pytest.approx((216, 108))


def test_user_text_is_kept_letter_for_letter() -> None:
    with styled():
        figure = sheet(2.0)
        figure.text(0.5, 0.5, "$x_1$ <b>& \\alpha")
        figure.add_artist(Circle((0.5, 0.5), 0.1))
    marks = trace(figure).marks
    assert [mark.text for mark in marks if isinstance(mark, Letters)] == ["$x_1$ <b>& \\alpha"]


def test_procedures_can_be_told_apart() -> None:
    looks = {(ink.colour, ink.dash) for ink in PROCEDURES.values()}
    assert len(looks) == len(PROCEDURES)
    assert all(ink.dash == "--" for name, ink in PROCEDURES.items() if name.endswith("-thesis"))
    assert pen("no such procedure").dash == ":"
