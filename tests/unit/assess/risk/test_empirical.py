"""Empirical curves widened by a lognormal factor on the intensity: quadrature, closed forms and rates."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.stats import norm

from assess.risk.estimates import EmpiricalCurve, Lognormal
from assess.risk.hazard import HazardCurve, rate

RISING = EmpiricalCurve(np.array([0.1, 0.2, 0.35, 0.8]), np.array([0.0, 0.3, 0.4, 1.0]))
FALLING = EmpiricalCurve(np.array([0.2, 0.3, 0.4, 0.6, 0.8]), np.array([0.1, 0.6, 0.2, 0.7, 0.9]))
AT = np.geomspace(0.01, 8.0, 15)


def mean_by_quadrature(curve: EmpiricalCurve, at: float, beta: float) -> float:
    """The mean of the curve over the factor exp(beta z), z a standard normal, with the kinks as breaks."""
    breaks = [float(z) for z in (np.log(curve.intensity) - np.log(at)) / beta if abs(z) < 12.0]
    return float(
        quad(lambda z: norm.pdf(z) * float(curve.probability(at * np.exp(beta * z))), -12.0, 12.0,
             points=breaks or None, limit=400, epsabs=1e-13, epsrel=1e-12)[0]
    )  # fmt: skip


@pytest.mark.parametrize("curve", [RISING, FALLING], ids=["rising", "falling"])
@pytest.mark.parametrize("beta", [0.05, 0.3, 1.5])
def test_the_widened_curve_is_the_mean_over_the_factor(curve: EmpiricalCurve, beta: float) -> None:
    expected = [mean_by_quadrature(curve, float(at), beta) for at in AT]
    np.testing.assert_allclose(curve.convolve(beta).probability(AT), expected, rtol=1e-8, atol=1e-12)


def test_a_step_becomes_a_lognormal() -> None:
    step = EmpiricalCurve(np.array([0.3, 0.3 * (1.0 + 1e-7)]), np.array([0.0, 1.0]))
    np.testing.assert_allclose(step.convolve(0.4).probability(AT), norm.cdf(np.log(AT / 0.3) / 0.4), atol=1e-6)


def test_a_lognormal_counted_finely_becomes_that_with_both_dispersions() -> None:
    at = np.geomspace(0.003, 30.0, 4001)
    counted = EmpiricalCurve(at, Lognormal(0.3, 0.45).probability(at))
    both = Lognormal(0.3, 0.45).convolve(0.6)
    assert (both.median, both.dispersion) == (0.3, pytest.approx(0.75))
    np.testing.assert_allclose(counted.convolve(0.6).probability(AT), both.probability(AT), atol=1e-6)


@pytest.mark.parametrize("share", [0.0, 0.4, 1.0])
def test_one_share_stays_as_it_is(share: float) -> None:
    one = EmpiricalCurve(np.array([0.3]), np.array([share])).convolve(0.5)
    np.testing.assert_allclose(one.probability(AT), share, atol=1e-15)


def test_the_far_tail_does_not_lose_its_digits() -> None:
    """Where hazard is frequent the share is small: there its error counts in itself, not beside 1."""
    at = 0.1 * np.exp(-0.3 * np.array([2.0, 6.0, 12.0]))
    expected = [
        quad(lambda z, at=at: norm.pdf(z) * float(RISING.probability(at * np.exp(0.3 * z))), np.log(0.1 / at) / 0.3,
             np.log(0.1 / at) / 0.3 + 5.0, epsabs=0.0, epsrel=1e-10, limit=400)[0]
        for at in at
    ]  # fmt: skip
    np.testing.assert_allclose(RISING.convolve(0.3).probability(at), expected, rtol=1e-5)


@pytest.mark.parametrize(("beta", "k"), [(0.2, 2.0), (0.4, 2.5), (0.6, 1.8)])
def test_on_a_power_law_the_rate_of_any_curve_grows_by_cornells_factor(beta: float, k: float) -> None:
    """A factor of median 1 on the intensity multiplies the rate by its mean of f^k, exp(k^2 beta^2 / 2)."""
    curve = EmpiricalCurve(FALLING.intensity, np.array([0.0, 0.6, 0.2, 0.7, 0.9]))
    at = np.geomspace(1e-4, 1e4, 3)
    hazard = HazardCurve(at, 1e-4 * at**-k)
    plain = rate(curve.probability, hazard, breaks=curve.intensity).annual_rate
    wide = rate(curve.convolve(beta).probability, hazard, breaks=curve.intensity).annual_rate
    assert wide == pytest.approx(plain * np.exp(0.5 * (k * beta) ** 2), rel=1e-5)
