"""The return period of a capacity by the hazard of the site in PGA, against a power law of rates."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.results.fragility import HazardResult, MeasureResult
from assess.study.checks import with_return_periods
from assess.study.fragility_runs import measure
from tests.support.facade import with_ties

PGA = (0.05, 0.1, 0.2, 0.4)
HAZARD = HazardResult(measure("pga"), "analysis.risk.hazard", PGA, tuple(1e-5 / pga**3 for pga in PGA))


def dated(capacity: float | None, hazard: HazardResult | None = HAZARD):
    """The first check of a mechanism with a capacity [g] that no hazard has dated."""
    mechanism = with_ties().mechanisms[0]
    check = replace(mechanism.checks[0], capacity_pga_g=capacity, return_period_years=None, return_period_bound="")
    return with_return_periods(replace(mechanism, checks=(check,)), hazard).checks[0]


@pytest.mark.parametrize("capacity", [0.05, 0.07, 0.15, 0.33, 0.4])
def test_between_rows_it_is_exact_for_rates_that_fall_by_a_power(capacity):
    check = dated(capacity)
    assert (check.return_period_years, check.return_period_bound) == (pytest.approx(capacity**3 / 1e-5, rel=1e-12), "")


@pytest.mark.parametrize(("capacity", "years", "bound"), [(0.01, 12.5, "<="), (0.9, 6400.0, ">=")])
def test_beyond_the_rows_it_is_a_bound(capacity, years, bound):
    check = dated(capacity)
    assert (check.return_period_years, check.return_period_bound) == (pytest.approx(years), bound)


OTHERS = (
    None,
    replace(HAZARD, measure=MeasureResult("pgv", "velocity", "ground")),
    replace(HAZARD, source="site.spectrum.hazard"),
)


@pytest.mark.parametrize("hazard", OTHERS)
def test_without_a_hazard_in_pga_it_is_not_known(hazard):
    assert dated(0.2, hazard).return_period_years is None
    assert dated(None).return_period_years is None


def test_what_the_check_knows_already_stays():
    mechanism = with_ties().mechanisms[0]
    after = with_return_periods(mechanism, HAZARD).checks
    pairs = [(old, new) for old, new in zip(mechanism.checks, after, strict=True) if old.return_period_years]
    assert pairs
    assert all(old == new for old, new in pairs)
