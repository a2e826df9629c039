"""Letters measured against matplotlib's own renderers."""

from __future__ import annotations

import pytest
from matplotlib.backend_bases import RendererBase
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from reports.figures.ruler import RULER, Canvas

from reports.figures.style import report_style, sheet


@pytest.mark.parametrize("text", ["0.25", "rotation φ [rad]", "φₒᵥ, interface", "−1.5"])
def test_letters_are_as_large_as_pixels_show_them(text: str) -> None:
    with report_style():
        figure = Figure(dpi=72)
        pixels = FigureCanvasAgg(figure).get_renderer()
        font = FontProperties(size=7.5)
        measured = RULER.get_text_width_height_descent(text, font, ismath=False)
        assert measured == pytest.approx(pixels.get_text_width_height_descent(text, font, ismath=False), abs=0.5)


def test_a_size_that_changes_later_is_measured_anew() -> None:
    with report_style():
        font = FontProperties(size=7.0)
        small = RULER.get_text_width_height_descent("wall", font, ismath=False)
        font.set_size(14.0)
        assert RULER.get_text_width_height_descent("wall", font, ismath=False)[0] == pytest.approx(
            2 * small[0], rel=0.02
        )


def test_figures_of_the_report_are_laid_out_with_it() -> None:
    with report_style():
        canvas = sheet(2.0).canvas
    assert isinstance(canvas, Canvas)
    assert canvas.get_renderer() is RULER


@pytest.mark.parametrize("weight", ["normal", "bold"])
def test_lines_stand_as_far_apart_as_the_font_says(weight: str) -> None:
    with report_style():
        text = Figure(dpi=72).text(0.0, 0.0, "two\nlines", fontsize=7.5, weight=weight)
        found, plain = (text.get_window_extent(renderer).bounds for renderer in (RULER, RendererBase()))
    assert found == pytest.approx(plain, rel=1e-12, abs=1e-12)
