"""Statistics of a suite of histories."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import numpy as np
import pytest

from assess.results import HistoryResult
from assess.study.mechanism_results import suite_statistics

STANDS = HistoryResult("r", 1, 0.2, 1.0, 1.0, 0.1, 0.1, None, 3, False, None, None, "positive")
FALLS = HistoryResult("r", 1, 0.2, 1.0, 1.0, None, None, None, 3, True, 4.0, None, "positive")


@pytest.mark.parametrize("overturned", [0, 1, 3, 7])
def test_quantiles_count_an_overturned_record_as_the_largest(overturned: int) -> None:
    ratios: list[float | None] = [0.05, 0.31, 0.12, 0.22, 0.4, 0.02, 0.17]
    ratios[:overturned] = [None] * overturned
    found = suite_statistics([FALLS if each is None else replace(STANDS, max_rotation_ratio=each) for each in ratios])
    filled = [inf if ratio is None else ratio for ratio in ratios]
    for share, value in ((0.5, found.median_ratio), (0.84, found.p84_ratio)):
        wanted = float(np.quantile(filled, share, method="inverted_cdf"))
        assert value == (None if wanted == inf else wanted)
