"""Figures of fragility: hollow points, bounds, bands, islands, and every word through the locale."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from matplotlib.colors import to_hex

from assess.results.fragility import FragilityResults
from reports.assessment import fragility_report
from reports.figures import fragility
from reports.intensity_measures import curves_by, first_measure, main_curve, main_risk
from reports.language.locale import Locale
from tests.support.drawn_figures import Bracketed, fixed_words
from tests.support.fragility_results import PGV, SCALED_PGV, fragility_results


@pytest.fixture(scope="module")
def results() -> FragilityResults:
    return fragility_results()


def test_no_word_of_a_figure_is_fixed_in_english(results: FragilityResults) -> None:
    for each in fragility_report(results).figures:
        assert not fixed_words(each.draw(Bracketed())), each.name


def test_everything_is_within_the_sheet(results: FragilityResults) -> None:
    for locale in (Locale(), Locale("it", "US")):
        for each in fragility_report(results).figures:
            figure = each.draw(locale)
            figure.draw_without_rendering()
            box = figure.get_tightbbox()  # in inches
            wide, high = figure.get_size_inches()
            assert min(box.x0, box.y0) >= -0.02, each.name
            assert (box.x1 <= wide + 0.02, box.y1 <= high + 0.02) == (True, True), each.name


def test_points_of_large_scale_factors_are_hollow(results: FragilityResults) -> None:
    curve = main_curve(results.mechanisms[0])
    assert curve is not None
    figure = fragility.draw_fragility(curve, Locale())
    lines = [line for line in figure.axes[0].get_lines() if line.get_marker() == "o"]
    for hollow in (False, True):
        own = [line for line in lines if (to_hex(line.get_markerfacecolor()) == "#ffffff") == hollow]
        drawn = sorted(float(x) for line in own for x in np.atleast_1d(line.get_xdata()))
        points = [point.intensity for point in curve.empirical if (2 * point.hollow > point.records) == hollow]
        assert points
        assert drawn == pytest.approx(points)


def test_intervals_are_those_of_wilson_and_the_bound_is_dashed(results: FragilityResults) -> None:
    curve = main_curve(results.mechanisms[0])
    assert curve is not None
    (axes,) = fragility.draw_fragility(curve, Locale()).axes
    upright = [line.get_ydata() for line in axes.get_lines() if len(set(np.atleast_1d(line.get_xdata()))) == 1]
    wilson = [[100 * point.low, 100 * point.high] for point in curve.empirical]
    assert np.allclose([each for each in upright if len(each) == 2], wilson)
    dashed = [str(line.get_label()) for line in axes.get_lines() if line.get_linestyle() == "--"]
    assert dashed == ["bound: first intensity that reaches it"]


def test_the_lognormal_passes_half_at_its_median(results: FragilityResults) -> None:
    curve = main_curve(results.mechanisms[0])
    assert curve is not None
    assert curve.lognormal is not None
    (axes,) = fragility.draw_fragility(curve, Locale()).axes
    line = next(line for line in axes.get_lines() if line.get_label() == "lognormal")
    at = np.interp(curve.lognormal.median, *map(np.asarray, line.get_data()))
    assert at == pytest.approx(50.0, abs=0.2)  # between 200 points of the curve


def test_a_curve_that_is_not_bounded_has_its_points_alone(results: FragilityResults) -> None:
    curve = main_curve(results.mechanisms[0])
    assert curve is not None
    (axes,) = fragility.draw_fragility(replace(curve, lognormal=None, first=None), Locale()).axes
    assert "lognormal" not in {line.get_label() for line in axes.get_lines()}
    assert not axes.collections
    assert fragility.draw_states((replace(curve, lognormal=None),), Locale()).axes


def test_islands_are_marked_where_records_stand_again(results: FragilityResults) -> None:
    front = results.mechanisms[0]
    measure = first_measure(front)
    assert measure is not None
    units = [run.intensity[0] for run in front.runs]
    (axes,) = fragility.draw_record_runs(front.runs, units, measure, Locale(), reach=1.0).axes
    drawn = next(line for line in axes.get_lines() if line.get_label() == "island: stands again")
    stand = [
        scale * unit
        for run, unit in zip(front.runs, units, strict=True)
        for scale, ratio in zip(run.scale, run.ratio, strict=True)
        if ratio is not None and any(low <= scale <= high for low, high in run.islands)
    ]
    assert stand
    assert [float(x) for x in np.atleast_1d(drawn.get_xdata())] == pytest.approx(stand)


def test_bars_of_contributions_make_up_the_whole_rate(results: FragilityResults) -> None:
    risk = main_risk(results.mechanisms[0])
    assert risk is not None
    for hazard in (results.hazard[0], None):
        _, below = fragility.draw_risk(risk, hazard, Locale()).axes
        heights = [patch.get_height() for patch in below.patches]  # type: ignore[attr-defined]
        assert sum(heights) == pytest.approx(100.0)


def test_axes_have_the_units_of_the_measure(results: FragilityResults) -> None:
    front = results.mechanisms[0]
    for measure, system, unit in ((PGV, "SI", "m/s"), (PGV, "US", "ft/s"), (SCALED_PGV, "US", "-")):
        curves = curves_by(front, measure)
        for draw in (partial(fragility.draw_fragility, curves[-1]), partial(fragility.draw_states, curves)):
            (axes,) = draw(Locale(system=system)).axes  # type: ignore[arg-type]
            assert axes.get_xlabel().endswith(f"[{unit}]")


def test_rows_of_the_hazard_are_points_on_its_curve(results: FragilityResults) -> None:
    risk = main_risk(results.mechanisms[0])
    assert risk is not None
    above, _ = fragility.draw_risk(risk, results.hazard[0], Locale()).axes
    line = above.get_lines()[0]
    assert line.get_marker() == "o"
    assert np.asarray(line.get_xdata()) == pytest.approx(results.hazard[0].intensity)
