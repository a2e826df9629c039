"""Wilson's interval against scipy's, and how often it covers the truth."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import binom, binomtest

from assess.risk.estimates import wilson_interval


@pytest.mark.parametrize(("reached", "records"), [(0, 1), (1, 1), (0, 7), (7, 7), (3, 10), (1, 200), (150, 200)])
@pytest.mark.parametrize("confidence", [0.68, 0.95])
def test_interval_is_scipys(reached, records, confidence):
    low, high = wilson_interval(reached, records, confidence=confidence)
    oracle = binomtest(reached, records).proportion_ci(confidence, method="wilson")
    np.testing.assert_allclose([low, high], [oracle.low, oracle.high], rtol=1e-12, atol=1e-15)


def test_arrays_keep_their_shape():
    low, high = wilson_interval(np.array([[0, 1], [2, 3]]), np.full((2, 2), 3))
    assert low.shape == high.shape == (2, 2)
    assert (low[0, 0], high[1, 1]) == (0.0, 1.0)


def test_bands_cover_the_truth_in_95_of_100_trials_on_average():
    """The exact probability of covering, averaged over the truth; of one truth it swings about 95 %."""
    records, truth = 40, np.linspace(0.02, 0.98, 97)
    low, high = wilson_interval(np.arange(records + 1), records)
    covers = (low[:, None] <= truth) & (truth <= high[:, None])
    exact = (covers * binom.pmf(np.arange(records + 1)[:, None], records, truth)).sum(axis=0)
    assert exact.mean() == pytest.approx(0.95, abs=0.006)
    assert exact.min() > 0.90
