"""Sentences about overturning envelopes."""

from __future__ import annotations

import numpy as np
import pytest

from assess.dynamics.pulses import envelope
from assess.oscillator import Oscillator, RockingBlock, plain_branch
from assess.study.envelopes import envelope_result
from records.pulses import PULSE_SHAPES
from reports.chapters.annex_envelopes import describe_envelope
from reports.language.locale import Locale

BRANCH = plain_branch(RockingBlock(1.0, 2.0, 0.2, 5.0), restitution=0.9)
BLOCK = Oscillator(BRANCH, BRANCH, 1.0)


@pytest.mark.parametrize(
    ("factor", "shape", "said"),
    [
        ([1.0, 1.0], "sine", "at 0.5 Hz."),
        ([2.5, 2.5], "cosine", "The motion at its base is 2.5 times that of the ground."),
        ([0.5, 2.0], "sine", "is 0.5 to 2 times that of the ground, depending on frequency."),
        ([0.5, 2.0], "cosine", "depending on frequency. These are the factors of a full sine of the same frequency."),
    ],
)
def test_the_factor_of_the_motion_is_told_where_there_is_one(factor: list[float], shape: str, said: str) -> None:
    made = envelope(
        BLOCK, PULSE_SHAPES[shape], np.array([0.5, 0.6]), np.array([0.0, 10.0, 10.1]),
        equation="linearised", factor=np.array(factor),
    )  # fmt: skip
    said_of_it = Locale().text(describe_envelope(envelope_result(made, BLOCK)))
    assert said_of_it.replace("\u00a0", " ").endswith(said)
