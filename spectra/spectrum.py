"""A design spectrum: pseudo-acceleration over period at a site, for any damping its code allows for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import inf

import numpy as np
from numpy.typing import ArrayLike
from scipy.constants import g

from assess.messages.message import Message, Quantity, warning
from spectra.arrays import FloatArray, is_number
from spectra.errors import SpectrumError

Ordinates = Callable[[FloatArray, float], FloatArray]

LARGEST_PLAUSIBLE = 3.0  # g: a mapped or peak acceleration beyond it is more likely a slip of unit than a site


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
    clause : that gives the shape
    longest_period : up to which ordinates are known [s]
    displacements : f(period [s], damping [-]) -> spectral displacement [m], before `factor`, where the code gives
        one of its own for long periods; None where it is S_a (T / 2 pi)^2 throughout
    warnings : what the engineer should read before using it, with the clause
    """

    code: str
    parameters: Mapping[str, float | str]
    damping: float
    damping_rule: str
    ordinates: Ordinates
    clause: str
    factor: float = 1.0
    longest_period: float = inf
    displacements: Ordinates | None = None
    warnings: tuple[Message, ...] = ()

    def __repr__(self) -> str:
        """Return one line: code, PGA and damping."""
        return f"Spectrum(code={self.code!r}, pga={self.pga:.4g} m/s2, damping={self.damping:g})"

    def acceleration(self, period: ArrayLike, *, damping: float | None = None) -> FloatArray:
        """Return the pseudo-acceleration [m/s2] at `period` [s] (same shape).

        `damping` [-] is the spectrum's own unless given.
        """
        at = np.asarray(period, dtype=np.float64)
        return self.factor * self.ordinates(at, self.damping if damping is None else damping)

    def displacement(self, period: ArrayLike, *, damping: float | None = None) -> FloatArray:
        """Return the spectral displacement [m] at `period` [s] (same shape): S_a (T / 2 pi)^2, or what the code gives.

        `damping` [-] is the spectrum's own unless given. Some codes give displacements of their own for long periods.
        """
        at = np.asarray(period, dtype=np.float64)
        if self.displacements is None:
            return np.asarray(self.acceleration(at, damping=damping) * (at / (2.0 * np.pi)) ** 2)
        return self.factor * self.displacements(at, self.damping if damping is None else damping)

    @property
    def pga(self) -> float:
        """Peak ground acceleration [m/s2]: the ordinate at zero period."""
        return float(self.acceleration(0.0))


def check_periods(period: FloatArray) -> FloatArray:
    """Return `period` [s]; refuse periods that are negative or not numbers."""
    if not np.all(period >= 0.0):
        raise SpectrumError(f"period {np.min(period)} s: a spectrum is asked at periods from 0 up")
    return period


def check_positive(code: str, **values: float) -> None:
    """Raise SpectrumError, naming the `code`, for the first of `values` that is not a positive number."""
    for name, value in values.items():
        if not (is_number(value) and np.isfinite(value) and value > 0.0):
            raise SpectrumError(f"{code} spectrum: {name} = {value}; it must be a positive number")


def plausibility_warnings(**values: float) -> tuple[Message, ...]:
    """Return a warning for each of `values` [m/s2], accelerations by name, that is larger than any site has."""
    return tuple(
        warning("implausible-site", name=name, value=in_g(value), most=in_g(LARGEST_PLAUSIBLE * g))
        for name, value in values.items()
        if value > LARGEST_PLAUSIBLE * g
    )


def in_g(acceleration: float) -> Quantity:
    """Return an acceleration [m/s2] as a value of a message, in g."""
    return Quantity(acceleration / g, "ground acceleration")


def scale_to_pga(spectrum: Spectrum, pga: float) -> Spectrum:
    """Scale the spectrum's ordinates to a peak ground acceleration; corner periods stay fixed.

    Parameters
    ----------
    spectrum : design spectrum
    pga : its new zero-period ordinate [m/s2]
    """
    return replace(spectrum, factor=spectrum.factor * pga / spectrum.pga)
