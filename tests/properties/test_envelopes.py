"""What holds for every overturning envelope."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.constants import g

from assess.dynamics.packing import Equation
from assess.dynamics.pulses import envelope
from assess.oscillator import Oscillator, RockingBlock, plain_branch
from records.pulses import PULSE_SHAPES

ALPHA = 0.2
FREQUENCY = np.array([0.8, 1.0, 1.2]) * 2.0 / (2.0 * np.pi)  # of a block of p = 2 / s
AMPLITUDE = np.linspace(1.0, 1.6, 120) * g * np.tan(ALPHA)
BRANCH = plain_branch(RockingBlock(1.0, g / 4.0, ALPHA, (g / 4.0) ** 2), restitution=0.9)


@pytest.mark.parametrize("equation", ["exact", "linearised"])
@pytest.mark.parametrize("negative", [BRANCH, None], ids=["two-sided", "one-sided"])
@pytest.mark.parametrize("shape", ["sine", "cosine", "ricker-antisymmetric", "mavroeidis-papageorgiou"])
def test_no_pulse_of_the_map_below_the_least_one_overturns(shape: str, negative: object, equation: Equation) -> None:
    """Thin bands of overturning lie between two steps of the scan; where the map meets one, the bound knows it."""
    made = envelope(Oscillator(BRANCH, negative, 1.0), PULSE_SHAPES[shape], FREQUENCY, AMPLITUDE, equation=equation)  # type: ignore[arg-type]
    bound = np.where(np.isnan(made.lower_bound), np.inf, made.lower_bound)
    assert not (made.overturned & (made.amplitude < bound[:, None] * (1.0 - 1e-9))).any()
    assert np.isfinite(bound).any()
