"""A lognormal curve, its moments, and its fit to counts against an independent search."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import binom, lognorm

from assess.risk.estimates import Lognormal, UnboundedReason, fit_lognormal, fit_lognormals, unbounded_reason

STRIPES = np.geomspace(0.05, 2.0, 12)
TRUE = Lognormal(0.4, 0.45)


def test_moments_and_quantiles_are_scipys():
    oracle = lognorm(s=TRUE.dispersion, scale=TRUE.median)
    np.testing.assert_allclose(TRUE.probability(STRIPES), oracle.cdf(STRIPES), rtol=1e-12)
    np.testing.assert_allclose(TRUE.quantile([0.16, 0.5, 0.84]), oracle.ppf([0.16, 0.5, 0.84]), rtol=1e-12)
    np.testing.assert_allclose([TRUE.mean, TRUE.standard_deviation], [oracle.mean(), oracle.std()], rtol=1e-12)
    assert TRUE.probability(0.0) == 0.0


def test_fit_recovers_the_truth_from_200_records_at_each_stripe():
    """Counts are the expected ones but for rounding to whole records, so that only the fit can err."""
    reached = np.round(200 * TRUE.probability(STRIPES))
    fit = fit_lognormal(STRIPES, reached, np.full(12, 200))
    assert fit is not None
    assert fit.median == pytest.approx(TRUE.median, rel=0.02)
    assert fit.dispersion == pytest.approx(TRUE.dispersion, abs=0.03)


def test_fit_recovers_the_truth_from_random_counts():
    """Of 300 sets of 200 records at each stripe the mean fit has no bias; one set spreads by 2 % and 0.02 about it."""
    reached = np.random.default_rng(1).binomial(200, TRUE.probability(STRIPES), size=(300, 12)).astype(float)
    median, dispersion = fit_lognormals(STRIPES, reached, np.full((300, 12), 200.0))
    assert np.mean(median) == pytest.approx(TRUE.median, rel=0.005)
    assert np.mean(dispersion) == pytest.approx(TRUE.dispersion, abs=0.005)
    assert np.std(np.log(median)) < 0.03
    assert np.std(dispersion) < 0.03


@pytest.mark.parametrize("seed", range(5))
def test_fit_is_where_a_search_finds_the_largest_likelihood(seed):
    rng = np.random.default_rng(seed)
    records = rng.integers(5, 40, 12)
    reached = rng.binomial(records, TRUE.probability(STRIPES))
    found = minimize(
        lambda at: -binom.logpmf(reached, records, lognorm.cdf(STRIPES, np.exp(at[1]), scale=np.exp(at[0]))).sum(),
        [np.log(0.5), np.log(0.5)], method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-12},
    )  # fmt: skip
    fit = fit_lognormal(STRIPES, reached, records)
    np.testing.assert_allclose([fit.median, fit.dispersion], np.exp(found.x), rtol=1e-6)


def test_records_one_by_one_give_the_fit_of_their_counts():
    reached, records = np.array([0, 1, 4, 7, 9, 10]), np.full(6, 10)
    im = np.geomspace(0.1, 1.0, 6)
    each = np.concatenate([np.arange(10) < number for number in reached])
    alone = fit_lognormal(np.repeat(im, 10), each, np.ones(60))
    together = fit_lognormal(im, reached, records)
    np.testing.assert_allclose([alone.median, alone.dispersion], [together.median, together.dispersion], rtol=1e-9)


def test_unit_of_intensity_goes_through():
    reached, records = [0, 1, 4, 7, 9, 10], [10] * 6
    im = np.geomspace(0.1, 1.0, 6)
    one, other = fit_lognormal(im, reached, records), fit_lognormal(981.0 * im, reached, records)
    np.testing.assert_allclose([other.median, other.dispersion], [981.0 * one.median, one.dispersion], rtol=1e-9)


@pytest.mark.parametrize(
    ("reached", "reason"),
    [
        ([0, 0, 0, 0], UnboundedReason.NONE_REACH),
        ([10, 10, 10, 10], UnboundedReason.ALL_REACH),
        ([0, 0, 10, 10], UnboundedReason.SEPARATED),
        ([0, 0, 0, 3], UnboundedReason.SEPARATED),
        ([0, 4, 10, 10], UnboundedReason.SEPARATED),
        ([10, 10, 0, 0], UnboundedReason.FALLING),
        ([8, 5, 3, 1], UnboundedReason.FALLING),
        ([0, 1, 9, 10], None),
        ([2, 9, 5, 10], None),
    ],
)
def test_what_data_do_not_bound_is_no_curve(reached, reason):
    im = [0.1, 0.2, 0.3, 0.4]
    assert unbounded_reason(im, reached, [10] * 4) == reason
    assert (fit_lognormal(im, reached, [10] * 4) is None) == (reason is not None)


def test_one_intensity_bounds_nothing():
    assert unbounded_reason([0.2, 0.2], [3, 4], [10, 10]) == UnboundedReason.ONE_INTENSITY
    assert fit_lognormal([0.2, 0.2], [3, 4], [10, 10]) is None


def test_far_tails_converge():
    """Stripes far from the median: a step that is not halved would leave the range of the normal distribution."""
    im = np.geomspace(1e-3, 1e3, 25)
    reached = np.where(im < 0.35, 0, np.where(im > 0.45, 1000, 500))
    reached[11], reached[13] = 1, 999
    fit = fit_lognormal(im, reached, np.full(25, 1000))
    assert fit is not None
    assert 0.05 < fit.median < 5.0
