"""A slender block: lambda = tan(alpha - phi) and d = R (sin alpha - sin(alpha - phi)), so that d0 = R sin alpha."""

from __future__ import annotations

from math import sin

from assess.mechanisms.single_block import equivalent_block

ALPHA, RADIUS = 0.1, 3.0
BLOCK = equivalent_block("w", p=1.6, uplift=ALPHA, radius=RADIUS).oscillator
D0 = RADIUS * sin(ALPHA)


def displacement(share: float) -> float:
    """Return d [m] at a share of alpha."""
    return RADIUS * (sin(ALPHA) - sin(ALPHA * (1 - share)))
