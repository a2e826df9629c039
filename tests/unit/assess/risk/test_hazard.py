"""Annual rates against Cornell's closed form and a fine sum; what lies outside the rows of a hazard."""

from __future__ import annotations

import numpy as np
import pytest

from assess.errors import HazardError
from assess.risk.estimates import EmpiricalCurve, Lognormal
from assess.risk.hazard import HazardCurve, probability_of, rate


@pytest.mark.parametrize("rows", [2, 5, 60])
@pytest.mark.parametrize(("median", "dispersion", "k"), [(0.4, 0.45, 2.5), (0.15, 0.3, 1.8), (1.2, 0.6, 3.0)])
def test_rate_is_cornells_closed_form(median, dispersion, k, rows):
    """lambda = k_0 m^-k exp(k^2 beta^2 / 2) for the hazard k_0 im^-k: Cornell et al. 2002, J. Struct. Eng. 128, 526."""
    im, k_0 = np.geomspace(1e-3, 1e3, rows), 2e-5
    found = rate(Lognormal(median, dispersion).probability, HazardCurve(im, k_0 * im**-k))
    closed = k_0 * median**-k * np.exp(0.5 * (k * dispersion) ** 2)
    assert found.annual_rate == pytest.approx(closed, rel=1e-5)
    assert found.contribution.sum() == pytest.approx(found.annual_rate, rel=1e-12)
    assert found.shares.sum() == pytest.approx(1.0, rel=1e-12)


def test_rate_of_a_bent_hazard_is_a_fine_sum():
    hazard = HazardCurve([0.02, 0.1, 0.3, 1.0], [5e-2, 4e-3, 5e-4, 2e-5])
    curve = Lognormal(0.35, 0.5)
    im = np.geomspace(0.02, 1.0, 400_001)
    steps = -np.diff(hazard.rate_at(im)) * curve.probability(np.sqrt(im[1:] * im[:-1]))
    found = rate(curve.probability, hazard)
    assert found.annual_rate == pytest.approx(steps.sum(), rel=1e-6)
    parts = [steps[(im[1:] > low) & (im[1:] <= high)].sum() for low, high in ((0.02, 0.1), (0.1, 0.3), (0.3, 1.0))]
    np.testing.assert_allclose(found.contribution, parts, rtol=1e-4)  # the rows lie within a step of the sum


def test_motions_outside_the_rows_are_bounds_beside_the_rate():
    im, k_0, k = np.geomspace(0.1, 0.5, 6), 2e-5, 2.5
    inside = rate(Lognormal(0.4, 0.45).probability, HazardCurve(im, k_0 * im**-k))
    closed = k_0 * 0.4**-k * np.exp(0.5 * (k * 0.45) ** 2)
    assert inside.beyond == pytest.approx(k_0 * 0.5**-k)
    assert inside.annual_rate < closed < inside.annual_rate + inside.below + inside.beyond


def test_state_that_is_likely_below_the_first_row_has_no_bound_there():
    hazard = HazardCurve([0.1, 1.0], [1e-2, 1e-4])
    assert rate(lambda im: np.full(im.shape, 0.1), hazard).below == np.inf
    assert rate(Lognormal(0.4, 0.3).probability, hazard).below < 1e-7


def test_certain_state_has_the_rate_of_the_first_row():
    hazard = HazardCurve([0.1, 0.3, 1.0], [1e-2, 1e-3, 1e-4])
    found = rate(np.ones_like, hazard)
    assert found.annual_rate + found.beyond == pytest.approx(1e-2, rel=1e-12)


def test_empirical_curve_is_integrated_between_its_points():
    """Shares linear in ln im on a hazard of slope k: integrated by parts in closed form, islands included."""
    im, share, k = np.array([0.2, 0.3, 0.4, 0.6, 0.8]), np.array([0.0, 0.3, 0.2, 0.7, 0.9]), 2.0
    hazard = HazardCurve(np.array([0.01, 0.1, 10.0]), 1e-4 * np.array([0.01, 0.1, 10.0]) ** -k)
    level = lambda x: 1e-4 * x**-k  # noqa: E731
    u = np.log(im)
    slopes = np.diff(share) / np.diff(u)
    parts = share[:-1] * level(im[:-1]) - share[1:] * level(im[1:]) + slopes / k * (level(im[:-1]) - level(im[1:]))
    closed = parts.sum() + share[-1] * (level(0.8) - level(10.0))
    curve = EmpiricalCurve(im, share)
    assert rate(curve.probability, hazard, breaks=curve.intensity).annual_rate == pytest.approx(closed, rel=1e-6)
    assert rate(curve.probability, hazard).annual_rate == pytest.approx(closed, rel=1e-4)


def test_steep_curve_in_a_wide_interval():
    hazard = HazardCurve([0.01, 10.0], [1.0, 1e-6])
    found = rate(Lognormal(0.3, 0.01).probability, hazard)
    closed = float(hazard.rate_at(0.3)) * np.exp(0.5 * (2 * 0.01) ** 2)
    assert found.annual_rate + found.beyond == pytest.approx(closed, rel=1e-6)


def test_probability_in_50_years_is_poissons():
    """NTC: 475 years are 10 % in 50 years under Poisson's process with the rate 1 / 475."""
    assert probability_of(1 / 474.56) == pytest.approx(0.10, rel=1e-5)
    assert probability_of(3e-9) == pytest.approx(1.5e-7, rel=1e-6)


@pytest.mark.parametrize(
    ("intensity", "annual_rate", "words"),
    [
        ([0.1], [1e-2], "at least two rows"),
        ([0.1, 0.2], [1e-2], "at least two rows"),
        ([0.2, 0.1], [1e-2, 1e-3], "0.1 follows 0.2"),
        ([0.1, 0.2], [1e-3, 1e-2], "rises from 0.001 to 0.01"),
        ([0.1, 0.2], [1e-3, 0.0], "annual rate 0 is not a positive number"),
        ([0.0, 0.2], [1e-2, 1e-3], "intensity 0 is not a positive number"),
        ([0.1, np.nan], [1e-2, 1e-3], "intensity nan"),
    ],
)
def test_rows_that_are_no_hazard_are_refused(intensity, annual_rate, words):
    with pytest.raises(HazardError, match=words):
        HazardCurve(intensity, annual_rate)


def test_rows_are_copies_that_cannot_change():
    im = np.array([0.1, 0.2])
    hazard = HazardCurve(im, [1e-2, 1e-3])
    im[0] = 5.0
    assert hazard.intensity[0] == 0.1
    assert not hazard.annual_rate.flags.writeable


def test_a_steep_first_interval_leaves_a_number_below_it():
    """Its slope, 43, makes rates of far smaller motions more than floats hold, and 0 times that is no number."""
    hazard = HazardCurve([0.15, 0.16, 0.30], [1 / 30, 1 / 475, 4e-4])
    step = EmpiricalCurve(np.array([1e-9, 0.2]), np.array([0.0, 1.0]))
    for probability in (Lognormal(0.4, 0.5).probability, Lognormal(0.4, 2.0).probability, step.probability):
        assert rate(probability, hazard).below >= 0.0


def test_contributions_between_other_edges_are_those_of_the_rows_in_parts():
    hazard, edges = HazardCurve([0.02, 0.3, 1.0], [5e-2, 5e-4, 2e-5]), np.geomspace(0.02, 1.0, 33)
    curve = Lognormal(0.35, 0.5)
    found, whole = rate(curve.probability, hazard, edges=edges), rate(curve.probability, hazard)
    assert found.contribution.size == 32
    assert found.annual_rate == pytest.approx(whole.annual_rate, rel=1e-6)
    im = np.geomspace(0.02, 1.0, 320_001)  # 10,000 steps to each part
    steps = -np.diff(hazard.rate_at(im)) * curve.probability(np.sqrt(im[1:] * im[:-1]))
    np.testing.assert_allclose(found.contribution, steps.reshape(32, -1).sum(axis=1), rtol=1e-3)
