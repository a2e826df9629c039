"""A figure as marks on a page."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.collections import PathCollection
from matplotlib.patches import Circle, PathPatch
from matplotlib.path import Path

from reports.figures.style import PROCEDURES, pen, report_style, sheet
from reports.language.locale import Locale
from reports.render.vector import Letters, Stroke, trace_figure


def test_a_line_lands_where_the_axes_put_it() -> None:
    with report_style():
        figure = sheet(2.0, Locale(), width=4.0)
        figure.set_layout_engine("none")
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0, 4), ylim=(0, 2))
        axes.set_axis_off()
        axes.plot([1, 3], [0.5, 1.5], color=(1.0, 0.0, 0.0))
    traced = trace_figure(figure)
    line = next(mark for mark in traced.marks if isinstance(mark, Stroke) and mark.line == (1.0, 0.0, 0.0, 1.0))
    assert (traced.width, traced.height) == (288.0, 144.0)
    assert list(line.codes) == [Path.MOVETO, Path.LINETO]
    assert line.numbers == pytest.approx((72, 36, 216, 108))


def test_a_circle_is_drawn_in_short_lines() -> None:
    with report_style():
        figure = sheet(2.0, Locale(), width=4.0)
        figure.add_artist(Circle((2.0, 1.0), 0.5, transform=figure.dpi_scale_trans, fill=True, facecolor="#ff0000"))
    circle = next(m for m in trace_figure(figure).marks if isinstance(m, Stroke) and m.filling == (1.0, 0.0, 0.0, 1.0))
    assert set(circle.codes) == {Path.MOVETO, Path.LINETO, Path.CLOSEPOLY}
    x, y = np.reshape(circle.numbers, (-1, 2)).T
    np.testing.assert_allclose(np.hypot(x - 144, y - 72), 36, rtol=0, atol=0.1)
    turned = np.unwrap(np.arctan2(y - 72, x - 144))
    assert np.abs(np.diff(turned)).max() < np.radians(15)


@pytest.mark.parametrize("curved", [False, True])
def test_many_outlines_are_those_of_one_by_one(curved: bool) -> None:
    paths = [Path([(0, 0), (1, 0), (1, 1), (0, 0)], closed=True), Path([(0, 1), (2, 2), (3, 1)])]
    paths += [Path.unit_circle()] if curved else []
    with report_style():
        together, apart = (sheet(2.0, Locale(), width=4.0) for _ in range(2))
        together.add_artist(PathCollection(paths, transform=together.dpi_scale_trans, facecolor="#ff0000"))
        for path in paths:
            apart.add_artist(PathPatch(path, transform=apart.dpi_scale_trans, facecolor="#ff0000"))
    ours, theirs = (
        [m for m in trace_figure(f).marks if isinstance(m, Stroke)][-len(paths) :] for f in (together, apart)
    )
    assert [mark.codes for mark in ours] == [mark.codes for mark in theirs]
    for one, other in zip(ours, theirs, strict=True):
        np.testing.assert_allclose(one.numbers, other.numbers, rtol=1e-12)


def test_user_text_is_kept_letter_for_letter() -> None:
    with report_style():
        figure = sheet(2.0, Locale())
        figure.text(0.5, 0.5, "$x_1$ <b>& \\alpha")
        figure.add_artist(Circle((0.5, 0.5), 0.1))
    marks = trace_figure(figure).marks
    assert [mark.text for mark in marks if isinstance(mark, Letters)] == ["$x_1$ <b>& \\alpha"]


def test_procedures_can_be_told_apart() -> None:
    looks = {(ink.colour, ink.dash) for ink in PROCEDURES.values()}
    assert len(looks) == len(PROCEDURES)
    assert all(ink.dash == "--" for name, ink in PROCEDURES.items() if name.endswith("-thesis"))
    assert pen("no such procedure").dash == ":"
