"""What is no accelerogram is refused by name, sample and value."""

from __future__ import annotations

import math

import numpy as np
import pytest

from records.errors import RecordError
from records.record import make_record, scale


@pytest.mark.parametrize(
    ("samples", "dt", "words"),
    [
        ([0.0, math.nan, 1.0], 0.01, r'record "r": sample 2 is nan; .* finite'),
        ([0.0, 1.0, -math.inf], 0.01, r'record "r": sample 3 is -inf; .* finite'),
        ([], 0.01, r'record "r": 0 samples .* at least two'),
        ([1.0], 0.01, r'record "r": 1 samples .* at least two'),
        ([[0.0, 1.0], [1.0, 0.0]], 0.01, r"at least two"),
        ([0.0, 2e3], 0.01, r"sample 2 is 2000 m/s2, over 1000; check the unit"),
        ([0.0, 1.0], 0.0, r"time step 0.0 s; it must be positive"),
        ([0.0, 1.0], -0.01, r"time step -0.01 s; it must be positive"),
        ([0.0, 1.0], math.nan, r"time step nan s; it must be positive"),
        ([0.0, 1.0], math.inf, r"time step inf s; it must be positive"),
    ],
)
def test_bad_samples_and_steps_are_named(samples: list[float], dt: float, words: str) -> None:
    with pytest.raises(RecordError, match=words):
        make_record("r", samples, dt)


def test_a_record_is_a_copy_that_stays_as_it_is() -> None:
    samples = np.array([0.0, 1.0, -2.0])
    record = make_record("r", samples, 0.5)
    samples[1] = 9.0
    assert record.acceleration.tolist() == [0.0, 1.0, -2.0]
    assert (record.npts, record.pga, record.time.tolist()) == (3, 2.0, [0.0, 0.5, 1.0])
    with pytest.raises(ValueError, match="read-only"):
        record.acceleration[0] = 1.0
    half = scale(record, -0.5)
    assert half.acceleration.tolist() == [0.0, -0.5, 1.0]
    assert str(half.processing_history[-1]) == "scaled by -0.5"
