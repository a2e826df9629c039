"""Yim, Chopra and Penzien 1980: more shaking may overturn less, and a smaller block may stand; by DOP853.

The motion is a sum of three sines, sampled at 0.05 s with straight lines between.
"""

from __future__ import annotations

from functools import cache
from math import pi

import numpy as np

from tests.validation.derive.rocking import rocked

SINES, STEP, DURATION = ((3.0, 0.9, 0.3), (2.0, 2.1, 1.1), (1.2, 3.7, 0.2)), 0.05, 8.0
ALPHA, ETA = 0.2, 0.925
BLOCKS = {
    **{f"p = 1.4, {scale}": (1.4, scale) for scale in (0.8, 1.0, 1.3, 1.9, 2.0)},
    **{f"p = 1.8, {scale}": (1.8, scale) for scale in (0.9, 1.1, 1.4)},
    "p = 1.6, 1.0": (1.6, 1.0),
    "p = 1.7, 1.0": (1.7, 1.0),
}


@cache
def _responses():
    times = np.arange(round(DURATION / STEP) + 1) * STEP
    samples = sum(a * np.sin(2 * pi * f * times + phase) for a, f, phase in SINES)
    return {
        row: rocked(lambda t, s=s: s * float(np.interp(t, times, samples)), times, p=p, alpha=ALPHA, restitution=ETA)
        for row, (p, s) in BLOCKS.items()
    }  # fmt: skip


def largest_and_overturned():
    """Largest |theta| / alpha of the blocks that stand, and which overturn."""
    found = _responses()
    return {
        "largest θ/α": {row: ratio for row, (ratio, _, lost) in found.items() if not lost},
        "overturned": {row: float(lost) for row, (_, _, lost) in found.items()},
    }


VALUES = {"yim_1980/shaken_blocks": largest_and_overturned}
