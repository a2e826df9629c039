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
