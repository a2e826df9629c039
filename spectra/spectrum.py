"""A design spectrum: pseudo-acceleration over period at a site, for any damping its code allows for.

With it the curve that EN 1998-1 and the Italian code share: rising, level, falling as 1/T, falling as 1/T^2.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf

import numpy as np
from numpy.typing import ArrayLike

from assess.messages.message import Message, Quantity, warning
from spectra.arrays import FloatArray, is_number
from spectra.damping import ec8_eta
from spectra.errors import SpectrumError
from spectra.gravity import g

Ordinates = Callable[[FloatArray, float], FloatArray]
LARGEST_PLAUSIBLE = 3.0  # g: a mapped or peak acceleration beyond it is more likely a slip of unit than a site


@dataclass(frozen=True)
class Spectrum:
    """An elastic design spectrum.

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

    @cached_property
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


DISPLACEMENT_FACTOR = 0.025  # of d_g = 0.025 a_g S T_C T_D; 1 / (2 pi)^2 rounded, so that S_De steps by 1.3 % at T_E


@dataclass(frozen=True)
class FourBranches:
    """An elastic spectrum of four branches.

    ground : ordinate at zero period, a_g S [m/s2]
    amplification : ordinate of the level branch over `ground` at 5 % damping: 2.5, 3.0 or F_0 [-]
    t_b, t_c, t_d : corner periods [s]
    """

    ground: float
    amplification: float
    t_b: float
    t_c: float
    t_d: float

    def ordinates(self, period: FloatArray, damping: float) -> FloatArray:
        """Return S_e [m/s2] at `period` [s] (same shape) and `damping` [-].

            T < T_B           a (1 + T / T_B (eta F - 1))         a = ground, F = amplification
            T_B <= T <= T_C   a eta F
            T_C < T <= T_D    a eta F T_C / T
            T > T_D           a eta F T_C T_D / T^2

        Source: EN 1998-1:2004 (3.2)-(3.5); NTC 2018 (3.2.2), whose first branch is the same in other letters.
        """
        a, F, T_B = self.ground, ec8_eta(damping) * self.amplification, self.t_b
        T = np.maximum(check_periods(period), T_B)
        falling = a * F * np.minimum(1.0, self.t_c / T) * np.minimum(1.0, self.t_d / T)
        return np.asarray(np.where(period < T_B, a * (1.0 + period / T_B * (F - 1.0)), falling), dtype=np.float64)

    def displacements(self, period: FloatArray, damping: float, *, t_e: float, t_f: float) -> FloatArray:
        """Return S_De [m] at `period` [s] (same shape): S_e (T / 2 pi)^2 up to T_E, then towards d_g, reached at T_F.

        Source: EN 1998-1:2004 (3.7), Annex A (A.1), (A.2), (3.12); NTC 2018 (3.2.10)-(3.2.12).
        """
        F, T = ec8_eta(damping) * self.amplification, check_periods(period)
        d_g = DISPLACEMENT_FACTOR * self.ground * self.t_c * self.t_d
        towards = np.clip((T - t_e) / (t_f - t_e), 0.0, 1.0)
        short = self.ordinates(np.minimum(T, t_e), damping) * (np.minimum(T, t_e) / (2.0 * np.pi)) ** 2
        return np.asarray(np.where(towards > 0.0, d_g * (F + towards * (1.0 - F)), short), dtype=np.float64)
