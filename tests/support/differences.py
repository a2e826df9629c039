"""Derivatives of functions that are known only by their values, by central differences of eighth order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

FIRST = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
SECOND = {0: -205 / 144, 1: 8 / 5, 2: -1 / 5, 3: 8 / 315, 4: -1 / 560}
STEP = 4e-3
"""Of rotations [rad]: where rounding and truncation of smooth functions are both near 1e-12."""


def slope(f: Callable[[Any], Any], x: Any, *, step: float = STEP) -> Any:
    """Return the first derivative of `f` at `x`, a number or an array."""
    return sum(weight * (f(x + k * step) - f(x - k * step)) for k, weight in FIRST.items()) / step


def bend(f: Callable[[Any], Any], x: Any, *, step: float = STEP) -> Any:
    """Return the second derivative of `f` at `x`, a number or an array."""
    return sum(weight * (f(x + k * step) + f(x - k * step)) for k, weight in SECOND.items()) / step**2
