"""A figure's marks as pixels, beside matplotlib's own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from matplotlib.image import imread

from reports.figures.style import report_style, sheet
from reports.language.locale import Locale
from reports.render.png import DPI, write_png
from reports.render.vector import trace_figure


def drawn(figure: Figure | None = None) -> Figure:
    """A scene on a figure; on one of the report if none is given."""
    with report_style():
        figure = figure or sheet(2.0, Locale(), width=4.0)
        axes = figure.add_subplot(xlabel="rotation φ [rad]", ylabel="λ")
        axes.plot([0, 1, 2], [0, 2, 1], color="#c1121f", linestyle="--")
        axes.fill_between([0, 1, 2], [0, 1, 0.5], color="#0072b2", alpha=0.4)
        axes.annotate("turned", (1.0, 1.0), rotation=30, fontweight="bold")
    return figure


def test_pixels_are_those_of_matplotlib(tmp_path: Path) -> None:
    ours = imread(write_png(trace_figure(drawn()), tmp_path / "ours.png", creator="assess"))[..., :3]
    with report_style():
        drawn(Figure(figsize=(4.0, 2.0), layout="constrained")).savefig(tmp_path / "theirs.png", dpi=DPI)
    theirs = imread(tmp_path / "theirs.png")[..., :3]
    assert ours.shape == theirs.shape == (2 * DPI, 4 * DPI, 3)
    apart = np.abs(ours - theirs).max(axis=2)
    assert (apart > 0.5).mean() < 0.01  # letters and lines stand up to a pixel beside: places are not snapped alike
    assert (theirs < 0.5).any(axis=2).mean() > 0.02  # what a blank picture would miss by


def test_the_program_is_named_and_the_resolution_is_told(tmp_path: Path) -> None:
    content = write_png(trace_figure(drawn()), tmp_path / "ours.png", creator="assess 1").read_bytes()
    assert b"assess 1" in content
    density = content[content.index(b"pHYs") + 4 :][:4]
    assert int.from_bytes(density, "big") == round(DPI / 0.0254)
