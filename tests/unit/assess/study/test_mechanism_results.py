"""Statistics of a suite of histories."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest

from assess.results import HistoryResult
from assess.study.mechanism_results import suite_statistics


def history(ratio: float | None) -> HistoryResult:
    fell = ratio is None
    return HistoryResult("r", 1, 0.2, 1.0, 1.0, ratio, ratio, None, 3, fell, 4.0 if fell else None, None, "positive")


@pytest.mark.parametrize("overturned", [0, 1, 3, 7])
def test_quantiles_count_an_overturned_record_as_the_largest(overturned: int) -> None:
    ratios: list[float | None] = [0.05, 0.31, 0.12, 0.22, 0.4, 0.02, 0.17]
    ratios[:overturned] = [None] * overturned
    found = suite_statistics([history(ratio) for ratio in ratios])
    filled = [inf if ratio is None else ratio for ratio in ratios]
    for share, value in ((0.5, found.median_ratio), (0.84, found.p84_ratio)):
        wanted = float(np.quantile(filled, share, method="inverted_cdf"))
        assert value == (None if wanted == inf else wanted)
