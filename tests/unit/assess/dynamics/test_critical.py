"""The critical mechanism of each frequency, by bounds whose order is known."""

from __future__ import annotations

import numpy as np
import pytest

from assess.dynamics.pulses import TIE, FrequencyBand, find_critical

FREQUENCY = np.linspace(1.0, 5.0, 9)
NAN = np.nan


def test_bands_meet_where_the_bounds_cross() -> None:
    """Exponentials, whose logarithms are lines, cross where (log a - log b) / (beta - alpha) says."""
    rates, sizes, crossings = (0.9, 0.5, 0.1), (1.0, 2.0, 9.0), (np.log(2.0) / 0.4, np.log(4.5) / 0.4)
    bounds = np.array([a * np.exp(rate * FREQUENCY) for a, rate in zip(sizes, rates, strict=True)])
    found = find_critical(FREQUENCY, bounds)
    expected = [0 if f < crossings[0] else 1 if f < crossings[1] else 2 for f in FREQUENCY]
    assert found.mechanism.tolist() == expected
    assert [band.mechanism for band in found.bands] == [0, 1, 2]
    ends = [(band.start, band.end) for band in found.bands]
    assert np.ravel(ends) == pytest.approx(
        [1.0, crossings[0], crossings[0], crossings[1], crossings[1], 5.0], rel=1e-12
    )
    np.testing.assert_array_equal(found.lower_bound, bounds.min(axis=0))
    np.testing.assert_allclose(found.margin, np.sort(bounds, axis=0)[1] / bounds.min(axis=0) - 1, rtol=1e-12)
    assert (found.runner_up != found.mechanism).all()


def test_one_that_leads_twice_has_two_bands() -> None:
    bounds = np.array([np.ones(9), 1.0 + 0.5 * np.cos(np.pi * (FREQUENCY - 1.0) / 2.0)])
    found = find_critical(FREQUENCY, bounds)
    assert [band.mechanism for band in found.bands] == [0, 1, 0]
    starts, ends = [band.start for band in found.bands], [band.end for band in found.bands]
    assert (starts[0], ends[-1], starts[1:]) == (1.0, 5.0, ends[:-1])


def test_ties_go_to_the_first_and_the_near_ones_are_told() -> None:
    bounds = np.array([[2.0], [2.0], [2.0 * (1 + TIE) * (1 - 1e-12)], [2.0 * (1 + TIE) * (1 + 1e-9)], [NAN]])
    found = find_critical(np.array([1.0]), bounds)
    assert (found.mechanism[0], found.runner_up[0], found.margin[0]) == (0, 1, 0.0)
    assert found.near[:, 0].tolist() == [True, True, True, False, False]
    assert found.bands == (FrequencyBand(0, 1.0, 1.0),)


def test_where_nothing_overturns_there_is_no_critical_one() -> None:
    bounds = np.array([[NAN, NAN, 3.0, 2.0], [NAN, NAN, NAN, 1.0]])
    found = find_critical(np.array([1.0, 2.0, 3.0, 4.0]), bounds)
    assert found.mechanism.tolist() == [-1, -1, 0, 1]
    assert found.runner_up.tolist() == [-1, -1, -1, 0]
    np.testing.assert_array_equal(found.lower_bound, [NAN, NAN, 3.0, 1.0])
    np.testing.assert_array_equal(found.margin, [NAN, NAN, NAN, 1.0])
    assert not found.near[:, :2].any()
    assert found.bands == (FrequencyBand(None, 1.0, 2.5), FrequencyBand(0, 2.5, 3.5), FrequencyBand(1, 3.5, 4.0))


def test_never_anything() -> None:
    found = find_critical(FREQUENCY, np.full((2, 9), NAN))
    assert found.bands == (FrequencyBand(None, 1.0, 5.0),)
    assert not found.near.any()


def test_one_mechanism_has_no_rival() -> None:
    found = find_critical(FREQUENCY, np.array([FREQUENCY]))
    assert found.bands == (FrequencyBand(0, 1.0, 5.0),)
    assert found.runner_up.tolist() == [-1] * 9
    assert np.isnan(found.margin).all()


@pytest.mark.parametrize("seed", range(5))
def test_the_least_of_random_bounds_in_any_order(seed: int) -> None:
    rng = np.random.default_rng(seed)
    bounds = rng.uniform(1.0, 4.0, (6, 9))
    order = rng.permutation(6)
    ours, theirs = find_critical(FREQUENCY, bounds), find_critical(FREQUENCY, bounds[order])
    np.testing.assert_array_equal(ours.mechanism, order[theirs.mechanism])
    np.testing.assert_array_equal(ours.margin, theirs.margin)
    assert [b.start for b in ours.bands] == pytest.approx([b.start for b in theirs.bands], rel=1e-12)
    for band in ours.bands:
        inside = (band.start < FREQUENCY) & (band.end > FREQUENCY)
        assert (ours.mechanism[inside] == band.mechanism).all()
