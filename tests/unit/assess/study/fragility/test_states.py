"""Which runs reach a state, and the step function of each record."""

import numpy as np
import pytest

from assess.results.fragility import StateResult
from assess.study.fragility_runs import FragilityRuns, first_bounds, islands, reaches, state_outcomes

INF, NAN = np.inf, np.nan
OVERTURNING = StateResult("overturning")


def runs_of(*rows: tuple[list[float], list[float]]) -> FragilityRuns:
    """Runs by the scales and ratios of each record, shorter rows ended by what is not run."""
    most = max(len(scale) for scale, _ in rows)
    padded = [[part + [NAN] * (most - len(part)) for part in row] for row in rows]
    return FragilityRuns(np.array([scale for scale, _ in padded]), np.array([ratio for _, ratio in padded]))


def test_states_by_ratio() -> None:
    runs = runs_of(([1.0, 2.0, 4.0, 8.0], [0.0, 0.2, 0.5, INF]), ([1.0, 2.0], [1e-9, 0.7]))
    assert reaches(runs, StateResult("rocking")).tolist() == [[False, True, True, True], [True, True, False, False]]
    assert reaches(runs, StateResult("rotation", 0.5)).tolist() == [
        [False, False, True, True],
        [False, True, False, False],
    ]
    assert reaches(runs, OVERTURNING).tolist() == [[False, False, False, True], [False] * 4]


def test_points_of_the_primary_measure_are_runs() -> None:
    """Records of other scales meet at the same intensities; the second may not be scaled to the last of them."""
    unit = np.array([1.0, 0.5])
    runs = runs_of(([1.0, 2.0, 4.0], [0.1, INF, 0.3]), ([2.0, 4.0], [0.1, 0.2]))
    found = state_outcomes(runs, unit, reaches(runs, OVERTURNING), primary=True)
    np.testing.assert_allclose(found.intensity, [1.0, 2.0, 4.0])
    assert found.reached.tolist() == [[False, True, False], [False, False, False]]
    assert found.known.tolist() == [[True, True, True], [True, True, False]]  # it stands at its largest: censored
    assert found.hollow.tolist() == [[False, False, False]] * 2


def test_a_record_that_overturns_at_its_largest_scale_counts_above_it() -> None:
    runs = runs_of(([1.0, 2.0, 4.0], [0.1, 0.2, 0.3]), ([2.0, 4.0], [0.1, INF]))
    found = state_outcomes(runs, np.array([1.0, 0.5]), reaches(runs, OVERTURNING), primary=True)
    assert found.reached.tolist() == [[False, False, False], [False, True, True]]
    assert found.known.all()


def test_other_measures_take_the_nearest_run() -> None:
    """Scales 1, 2, 4 of a record of 3 are 3, 6, 12: it is as at 6 from 3 sqrt(2) to 6 sqrt(2), in logarithms."""
    runs = runs_of(([1.0, 2.0, 4.0], [0.1, INF, 0.2]), ([1.0, 2.0, 4.0], [0.1, 0.1, INF]))
    found = state_outcomes(runs, np.array([3.0, 1.3]), reaches(runs, OVERTURNING), primary=False)
    at = found.intensity
    assert (at[0], at[-1]) == (pytest.approx(1.3), pytest.approx(12.0))
    assert np.all(np.diff(np.log(at)) <= np.log(2.0) + 1e-9)
    np.testing.assert_array_equal(found.reached[0], (at > 3.0 * 2**0.5) & (at < 6.0 * 2**0.5))
    np.testing.assert_array_equal(found.reached[1], at > 2.6 * 2**0.5)
    np.testing.assert_array_equal(found.known[0], at <= 12.0 * 2**0.5)


def test_first_exceedance_lies_between_two_runs() -> None:
    runs = runs_of(([1.0, 2.0, 4.0], [0.1, INF, 0.3]), ([1.0, 2.0], [INF, INF]), ([1.0, 2.0, 4.0], [0.1, 0.2, 0.3]))
    lower, upper = first_bounds(runs, np.array([0.1, 1.0, 10.0]), reaches(runs, OVERTURNING))
    np.testing.assert_allclose(lower, [0.1, 0.0, 40.0])
    np.testing.assert_allclose(upper, [0.2, 1.0, INF])


def test_islands() -> None:
    scale = np.arange(1.0, 9.0)
    fallen = np.array([0, 1, 0, 0, 1, 0, 1, 0], dtype=bool)
    assert islands(scale, fallen) == ((3.0, 4.0), (6.0, 6.0), (8.0, 8.0))
    assert islands(scale, scale > 3.0) == ()
    assert islands(scale, np.zeros(8, dtype=bool)) == ()


@pytest.mark.parametrize("seed", range(8))
def test_first_exceedance_bounds_the_share(seed: int) -> None:
    """Whatever the islands, no more records reach a state at an intensity than have reached it up to there."""
    generator = np.random.default_rng(seed)
    scale = np.geomspace(1.0, 8.0, 12) * generator.uniform(0.5, 2.0, 15)[:, None]
    ratio = np.where(generator.random(scale.shape) < np.linspace(0.0, 0.9, 12), INF, 0.3)
    runs, unit = FragilityRuns(scale, ratio), 1.0 / scale[:, 0]
    reached = reaches(runs, OVERTURNING)
    found = state_outcomes(runs, unit, reached, primary=True)
    _, upper = first_bounds(runs, unit, reached)
    first = (upper[:, None] <= found.intensity * (1.0 + 1e-9)).sum(axis=0)
    assert np.all(found.reached.sum(axis=0) <= first)
    assert np.any(found.reached.sum(axis=0) < first)
