"""A design spectrum: pseudo-acceleration over period at a site, for any damping its code allows for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import inf

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
Ordinates = Callable[[FloatArray, float], FloatArray]


@dataclass(frozen=True)
class Spectrum:
    """An elastic design spectrum.

    Attributes
    ----------
    code : name of the code and edition, as in the project file ("asce7-16", "table", …)
    parameters : what the shape was made from, name -> value, SI, for the report
    damping : damping ratio of the ordinates as the code gives them [-]
    damping_rule : the code's rule for other damping, in words with its clause
    ordinates : f(period [s], damping [-]) -> pseudo-acceleration [m/s2], before `factor`
    factor : what the ordinates are multiplied by; corner periods stay fixed [-]
    clause : where the shape stands
    longest_period : up to which ordinates are known [s]
    """

    code: str
    parameters: Mapping[str, float | str]
    damping: float
    damping_rule: str
    ordinates: Ordinates
    clause: str
    factor: float = 1.0
    longest_period: float = inf

    def acceleration(self, period: ArrayLike, *, damping: float | None = None) -> FloatArray:
        """Pseudo-acceleration [m/s2] at `period` [s] (same shape), at `damping` [-] (default: the spectrum's own)."""
        at = np.asarray(period, dtype=np.float64)
        return self.factor * self.ordinates(at, self.damping if damping is None else damping)

    @property
    def pga(self) -> float:
        """Peak ground acceleration [m/s2]: the ordinate at zero period."""
        return float(self.acceleration(0.0))


def scaled_to_pga(spectrum: Spectrum, pga: float) -> Spectrum:
    """The same shape with its zero-period ordinate at `pga` [m/s2]; corner periods stay fixed."""
    return replace(spectrum, factor=spectrum.factor * pga / spectrum.pga)
