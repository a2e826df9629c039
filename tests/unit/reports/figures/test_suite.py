"""The limits in the figure of the suite are those of the code that decides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assess.results import Results
from assess.results.run import GroundMotionResult, RequirementResult
from reports.figures import spectrum
from reports.language.locale import Locale
from tests.support.sample_results import with_verdict

PERIOD = tuple(np.geomspace(0.02, 5.0, 60).tolist())


RULES = tuple(
    RequirementResult(code, "2.4", what, 1.0, sense, limit, "-", "met", 0.1, 2.0, "", "")  # type: ignore[arg-type]
    for code, what, sense, limit in (
        ("ASCE 43-05", "least ratio of mean spectrum to target", ">=", 0.9),
        ("ASCE 43-05", "largest ratio of mean spectrum to target", "<=", 1.3),
        ("ASCE 43-05", "points side by side below the target", "<=", 9.0),
        ("NTC 2018", "least ratio of mean spectrum to target", ">=", 0.9),
    )
)


@pytest.fixture
def chosen(results: Results) -> Results:
    target = tuple(0.4 for _ in PERIOD)
    motion = GroundMotionResult(0.1, 2.0, "", (), PERIOD, target, target, target, 0.0, None, RULES)
    return replace(results, ground_motion=motion)


@pytest.mark.parametrize(("basis", "count"), [("asce43-05", 2), ("ntc2018", 1), ("ec8", 0), ("own", 0)])
def test_the_limits_are_those_of_the_basis(chosen: Results, basis: str, count: int) -> None:
    judged = with_verdict(chosen, basis=basis)
    assert len(spectrum.mean_limits(judged)) == count
    assert spectrum.mean_limits(replace(judged, verdict=None)) == ()


def test_a_limit_is_drawn_over_its_periods_at_its_share_of_the_target(chosen: Results) -> None:
    judged = with_verdict(chosen, basis="asce43-05")
    lines = spectrum.draw_suite(judged, Locale()).axes[0].get_lines()
    most = next(line for line in lines if "130" in str(line.get_label()))
    np.testing.assert_allclose(most.get_ydata(), 0.52, rtol=1e-12)
    assert 0.1 <= np.min(most.get_xdata()) < np.max(most.get_xdata()) <= 2.0


def test_results_without_a_suite_are_refused(results: Results) -> None:
    with pytest.raises(ValueError, match="no suite"):
        spectrum.draw_suite(replace(results, ground_motion=None), Locale())
