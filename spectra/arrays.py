"""The arrays that all packages compute with, and what counts as a number."""

from __future__ import annotations

from numbers import Real
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
ComplexArray = NDArray[np.complex128]


def is_number(value: Any) -> TypeGuard[float]:
    """Tell whether a value is one real number, not True or False."""
    return isinstance(value, Real) and not isinstance(value, bool)


def plain_float(text: str) -> float:
    """Return the number in a text.

    Raises
    ------
    ValueError : it is none, or not in the digits 0 to 9: Python reads those of every script, and 1_000
    """
    refuse_other_digits(text)
    return float(text)


def plain_int(text: str) -> int:
    """Return the whole number in a text; raise ValueError as `plain_float`."""
    refuse_other_digits(text)
    return int(text)


def refuse_other_digits(text: str) -> None:
    """Raise ValueError for a text that is no number in the digits 0 to 9, whatever Python makes of it."""
    if not text.isascii() or "_" in text:
        raise ValueError(f"{text:.40}: a number is written with the digits 0 to 9")
