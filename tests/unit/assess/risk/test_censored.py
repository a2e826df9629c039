"""First exceedance: records known between two scales, known exactly, and censored at their largest."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import CensoredData, norm

from assess.risk.estimates import Lognormal, fit_first_exceedances


def sample(seed, records=40):
    return 0.4 * np.exp(0.45 * np.random.default_rng(seed).standard_normal(records))


def test_exact_values_give_mean_and_standard_deviation_of_logarithms():
    level = sample(1)
    fit = fit_first(level, level)
    np.testing.assert_allclose(
        [np.log(fit.median), fit.dispersion], [np.log(level).mean(), np.log(level).std()], rtol=1e-9
    )


def fit_first(stands, reaches):
    """The lognormal of all records, each counted once."""
    (median,), (dispersion,) = fit_first_exceedances(np.asarray(stands), np.asarray(reaches), np.ones((1, len(stands))))
    return Lognormal(median, dispersion)


@pytest.mark.parametrize("seed", range(4))
def test_censored_and_interval_records_are_fitted_as_scipy_fits_them(seed):
    """scipy.stats fits a normal distribution to the same bounds of the logarithms by a general search."""
    level, scales = sample(seed), np.geomspace(0.15, 0.8, 8)
    at = np.searchsorted(scales, level)
    stands, reaches = np.append(0.0, scales)[at], np.append(scales, np.inf)[at]
    with np.errstate(divide="ignore"):
        bounds = np.stack([np.log(stands), np.log(reaches)], axis=1)
    data = CensoredData(interval=bounds[np.isfinite(bounds).all(axis=1)], left=bounds[np.isinf(bounds[:, 0]), 1],
                        right=bounds[np.isinf(bounds[:, 1]), 0])  # fmt: skip
    oracle = norm.fit(data, optimizer=lambda *a, **k: minimize(a[0], a[1], args=k["args"], method="Nelder-Mead",
                                                               options={"xatol": 1e-9, "fatol": 1e-12}).x)  # fmt: skip
    fit = fit_first(stands, reaches)
    np.testing.assert_allclose([np.log(fit.median), fit.dispersion], oracle, rtol=1e-5)


def test_records_that_stand_are_not_dropped():
    """Without those that stand at 0.4 the median would be below 0.4, as all that are left lie there."""
    level = sample(2, 400)
    over = level <= 0.4
    kept = fit_first(np.where(over, level, 0.4), np.where(over, level, np.inf))
    left = fit_first(level[over], level[over])
    assert kept.median == pytest.approx(0.4, rel=0.08)
    assert left.median < 0.32


def test_fine_intervals_tend_to_exact_values():
    level = sample(3)
    fine, exact = fit_first(level / 1.0001, level), fit_first(level, level)
    np.testing.assert_allclose([fine.median, fine.dispersion], [exact.median, exact.dispersion], rtol=1e-3)


@pytest.mark.parametrize(
    ("stands", "reaches", "bounded"),
    [
        ([0.5, 0.5, 0.5], [np.inf] * 3, False),
        ([0.0, 0.0, 0.0], [0.1, 0.1, 0.2], False),
        ([0.1, 0.1, 0.1], [0.2, 0.2, 0.2], False),
        ([0.3, 0.3, 0.3], [np.inf, 0.4, 0.4], False),
        ([0.1, 0.2, 0.3], [0.2, 0.3, 0.4], True),
        ([0.2, 0.3, 0.3], [0.2, np.inf, np.inf], True),
    ],
)
def test_what_records_do_not_bound_is_no_curve(stands, reaches, bounded):
    assert np.isfinite(fit_first(stands, reaches).median) == bounded


def test_counts_are_records_repeated():
    level, scales = sample(4, 10), np.geomspace(0.15, 0.8, 8)
    at = np.searchsorted(scales, level)
    stands, reaches = np.append(0.0, scales)[at], np.append(scales, np.inf)[at]
    counts = np.array([[0, 1, 2, 0, 1, 1, 3, 0, 1, 1]], dtype=float)
    repeated = np.repeat(np.arange(10), counts[0].astype(int))
    median, dispersion = fit_first_exceedances(stands, reaches, counts)
    fit = fit_first(stands[repeated], reaches[repeated])
    np.testing.assert_allclose([median[0], dispersion[0]], [fit.median, fit.dispersion], rtol=1e-8)
