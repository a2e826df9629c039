"""Figures in US units: ticks round in feet, where they belong, under a label that says so."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.text import Text
from reports.figures.us_axes import convert
from reports.localisation import localise

from assess.results import Resolved, Results
from reports.assessment import assessment
from reports.figures import sketch
from reports.figures.style import report_style, sheet

FOOT, INCH, PSI = 0.3048, 0.0254, 4.4482216152605 / 0.0254**2


def drawn(axes: Axes) -> Axes:
    with report_style():
        axes.figure.draw_without_rendering()  # type: ignore[union-attr]
    return axes


def ticks(axis: Axis) -> list[tuple[float, float]]:
    """Place on the axis and number written, of each tick in sight."""
    low, high = sorted(axis.get_view_interval())
    pairs = zip(axis.get_majorticklocs().tolist(), axis.get_ticklabels(), strict=True)
    return [(at, float(text.get_text().replace("−", "-"))) for at, text in pairs if low <= at <= high]


def test_ticks_of_the_sketch_are_round_in_feet_and_in_their_place(results: Results) -> None:
    figure = sketch.draw(results.mechanisms[0])
    convert(figure)
    axes = drawn(figure.axes[0])
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x [ft]", "elevation z [ft]")
    for axis in (axes.xaxis, axes.yaxis):
        found = ticks(axis)
        assert len(found) >= 2
        for at, number in found:
            assert at == pytest.approx(number * FOOT, abs=1e-9)
        step = found[1][1] - found[0][1]
        assert f"{step:.0e}"[0] in "125"


def test_panels_without_a_label_have_the_unit_of_those_beside_them(results: Results) -> None:
    figure = sketch.draw(results.mechanisms[0])
    convert(figure)
    first, second = (drawn(axes).get_yticks() for axes in figure.axes[:2])
    assert figure.axes[1].get_ylabel() == ""
    assert second == pytest.approx(first, abs=1e-12)


def panel(label: str, highest: float, **keys: str) -> tuple[Figure, Axes]:
    with report_style():
        figure = sheet(2.0)
        axes = figure.subplots()
        axes.plot([0.01 * highest, highest], [0.01 * highest, highest])
        axes.set(xlabel="time t [s]", ylabel=label, **keys)
    return figure, axes


def test_large_numbers_are_written_with_a_power_in_us_units() -> None:
    figure, axes = panel("stiffness [Pa/m]", 5e12)
    convert(figure)
    drawn(axes)
    offset = axes.yaxis.get_offset_text().get_text()
    power = float(offset.replace("−", "-"))
    for at, number in ticks(axes.yaxis):
        assert at * INCH / PSI == pytest.approx(number * power, rel=1e-9, abs=1e-6)


def test_logarithmic_axes_have_powers_of_ten_in_us_units() -> None:
    figure, axes = panel("stress [MPa]", 5.0, yscale="log")
    convert(figure)
    drawn(axes)
    low, high = axes.yaxis.get_view_interval()
    shown = [at * 1e6 / PSI for at in axes.get_yticks() if low <= at <= high]
    assert shown
    assert np.log10(shown) == pytest.approx(np.round(np.log10(shown)), abs=1e-9)


def test_curves_and_axes_of_other_units_stay() -> None:
    figure, axes = panel("moment [kN m]", 5.0)
    before, curve = axes.get_ylim(), axes.lines[0].get_ydata()
    convert(figure)
    drawn(axes)
    assert axes.get_ylim() == before
    assert axes.lines[0].get_ydata() is curve
    assert axes.get_xlabel() == "time t [s]"
    assert all(at == pytest.approx(number, abs=1e-12) for at, number in ticks(axes.xaxis))


def test_a_scale_that_panels_share_is_converted_once() -> None:
    with report_style():
        figure = sheet(2.0)
        for axes in figure.subplots(2, 1, sharex=True):
            axes.plot([0.0, 10.0], [0.0, 1.0])
            axes.set_xlabel("x [m]")
    convert(figure)
    for at, number in ticks(drawn(figure.axes[1]).xaxis):
        assert at == pytest.approx(number * FOOT, abs=1e-9)


def test_no_figure_of_a_report_in_us_units_has_metres(results: Results) -> None:
    project = {**results.project, "report.units": Resolved("US", True)}
    document = localise(assessment(replace(results, project=project)))
    texts = [str(text.get_text()) for one in document.figures for text in one.draw().findobj(Text)]  # type: ignore[attr-defined]
    units = {unit for text in texts for unit in re.findall(r"\[([^\]]+)\]", text)}
    assert {"ft", "kip ft", "g", "rad"} <= units
    assert not any(re.search(r"\b[kMG]?(m|N|Pa|kg)\b", unit) for unit in units)
