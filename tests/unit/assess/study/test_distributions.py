"""Inverse distributions against their definitions: mean, coefficient of variation, quantiles, truncation."""

from __future__ import annotations

from math import inf, log, sqrt

import numpy as np
import pytest
from scipy import stats

from assess.results.run import Distribution, UncertainInput
from assess.study.study import SampledNumber
from assess.study.uncertainty import share_cut_off, values_at

EVEN = (np.arange(200_000) + 0.5) / 200_000


def number(kind: Distribution, mean: float, cov: float, *, least: float = 0.0, most: float = inf) -> SampledNumber:
    return SampledNumber(UncertainInput("key", "-", mean, cov, kind, "key"), least, most, ("wall",))


@pytest.mark.parametrize("kind", ["normal", "lognormal", "uniform"])
@pytest.mark.parametrize("mean", [0.6, -3000.0])
def test_mean_and_cov_are_those_given(kind: Distribution, mean: float) -> None:
    values = values_at(number(kind, mean, 0.1), EVEN)
    np.testing.assert_allclose(values.mean(), mean, rtol=1e-5)
    np.testing.assert_allclose(values.std() / abs(mean), 0.1, rtol=1e-3)  # the tails of the last cells
    assert np.all(np.sign(values) == np.sign(mean))


def test_quantiles_are_those_of_scipy() -> None:
    p = np.array([0.01, 0.3, 0.5, 0.9])
    b = sqrt(log(1.04))
    lognormal = stats.lognorm(s=b, scale=2.0 * np.exp(-(b**2) / 2.0))
    np.testing.assert_allclose(values_at(number("lognormal", 2.0, 0.2), p), lognormal.ppf(p), rtol=1e-12)
    np.testing.assert_allclose(
        values_at(number("normal", 2.0, 0.2, least=-inf), p), stats.norm(2.0, 0.4).ppf(p), rtol=1e-12
    )
    uniform = stats.uniform(2.0 - 0.4 * sqrt(3.0), 0.8 * sqrt(3.0))
    np.testing.assert_allclose(values_at(number("uniform", 2.0, 0.2), p), uniform.ppf(p), rtol=1e-12)


@pytest.mark.parametrize("kind", ["normal", "lognormal", "uniform"])
def test_what_lies_beyond_the_possible_is_cut_off(kind: Distribution) -> None:
    """A restitution of mean 0.95: the distribution given that it is at most 1."""
    given = number(kind, 0.95, 0.05, most=1.0 / 0.95)
    values, free = values_at(given, EVEN), values_at(number(kind, 0.95, 0.05), EVEN)
    assert values.max() <= 1.0
    np.testing.assert_allclose(share_cut_off(given), np.mean(free > 1.0), atol=1e-5)
    np.testing.assert_allclose(values.mean(), free[free <= 1.0].mean(), rtol=1e-5)


def test_a_normal_number_that_keeps_its_sign_does_so() -> None:
    assert values_at(number("normal", 0.1, 0.5), EVEN).min() > 0.0
    assert values_at(number("normal", 0.1, 0.5, least=-inf), EVEN).min() < 0.0
