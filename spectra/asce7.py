"""The two-corner design spectrum of ASCE 7, editions 2005 to 2016, with the IBC that copies it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from spectra.damping import asce7_b_factor
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum

FloatArray = NDArray[np.float64]
Hazard = Literal["design", "mce"]

ZERO_PERIOD_RATIO = 0.4  # S_a(0) / S_DS
HAZARD_FACTOR: Mapping[str, float] = {"design": 1.0, "mce": 1.5}


@dataclass(frozen=True)
class Edition:
    """Where an edition keeps the design spectrum, the MCE spectrum and the damping coefficients."""

    design: str
    mce: str
    damping: str


EDITIONS: Mapping[str, Edition] = {
    "asce7-05": Edition("ASCE 7-05 §11.4.5", "ASCE 7-05 §11.4.6", "ASCE 7-05 Table 18.6-1"),
    "ibc2009": Edition(
        "IBC 2009 §1613.5 with ASCE 7-05 §11.4.5", "IBC 2009 §1613.5 with ASCE 7-05 §11.4.6", "ASCE 7-05 Table 18.6-1"
    ),
    "asce7-10": Edition("ASCE 7-10 §11.4.5", "ASCE 7-10 §11.4.6", "ASCE 7-10 Table 18.6-1"),
    "asce7-16": Edition("ASCE 7-16 §11.4.6", "ASCE 7-16 §11.4.7", "ASCE 7-16 Table 18.7-1"),
}


def design_spectrum(
    *, s_ds: float, s_d1: float, t_l: float, code: str = "asce7-16", hazard: str = "design"
) -> Spectrum:
    """The design spectrum from S_DS [m/s2], S_D1 (the ordinate at 1 s) [m/s2] and T_L [s].

        T < T_0          S_DS (0.4 + 0.6 T / T_0)         T_0 = 0.2 T_S
        T_0 <= T <= T_S  S_DS                             T_S = S_D1 / S_DS
        T_S < T <= T_L   S_D1 / T
        T > T_L          S_D1 T_L / T^2

    `hazard` "mce" multiplies every ordinate by 1.5. Damping other than 5 % divides the ordinates from T_0 on by B.
    The code divides S_a by B and is silent on T < T_0; a rigid body feels the ground whatever its damping, so
    here the zero-period ordinate is kept and the ordinates are linear in between.

    Raises SpectrumError for an unknown code or hazard, for values that are not positive, and where T_S > T_L.
    Source: ASCE 7-16 §11.4.6-11.4.7, 7-10 and 7-05 §11.4.5-11.4.6; damping Table 18.7-1 (18.6-1).
    """
    edition = _edition(code)
    if hazard not in HAZARD_FACTOR:
        raise SpectrumError(f'hazard "{hazard}" is not known; choose one of {", ".join(HAZARD_FACTOR)}')
    for name, value in (("s_ds", s_ds), ("s_d1", s_d1), ("t_l", t_l)):
        if not (np.isfinite(value) and value > 0.0):
            raise SpectrumError(f"{code} spectrum: {name} = {value}; it must be a positive number")
    t_s = s_d1 / s_ds
    if t_s > t_l:
        raise SpectrumError(
            f"{code} spectrum: T_S = S_D1 / S_DS = {t_s:.4g} s exceeds t_l = {t_l:.4g} s ({edition.design})"
        )
    shape, factor = _Shape(s_ds, s_d1, t_l), HAZARD_FACTOR[hazard]
    return Spectrum(
        code=code,
        parameters={"s_ds": s_ds, "s_d1": s_d1, "t_l": t_l, "t_0": shape.t_0, "t_s": t_s, "hazard": hazard},
        damping=0.05,
        damping_rule=_damping_rule(edition),
        ordinates=lambda period, damping: factor * shape.ordinates(period, damping),
        clause=edition.design if hazard == "design" else edition.mce,
    )


def _edition(code: str) -> Edition:
    if code not in EDITIONS:
        raise SpectrumError(f'"{code}" is no edition of ASCE 7 known here; choose one of {", ".join(EDITIONS)}')
    return EDITIONS[code]


def _damping_rule(edition: Edition) -> str:
    return (
        f"{edition.damping}: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between "
        "(the code is silent below T_0); not checked against the printed standard"
    )


@dataclass(frozen=True)
class _Shape:
    """The spectrum's curve: S_DS, S_D1 [m/s2], T_L [s]."""

    s_ds: float
    s_d1: float
    t_l: float

    @property
    def t_0(self) -> float:
        """T_0 = 0.2 S_D1 / S_DS [s]."""
        return 0.2 * self.s_d1 / self.s_ds

    def ordinates(self, period: FloatArray, damping: float) -> FloatArray:
        """S_a [m/s2] at `period` [s] (same shape) and `damping` [-]."""
        if not np.all(period >= 0.0):
            raise SpectrumError(f"period {np.min(period)} s: a spectrum is asked at periods from 0 up")
        S_DS, S_D1, T_L, T_0, B = self.s_ds, self.s_d1, self.t_l, self.t_0, asce7_b_factor(damping)
        T = np.maximum(period, T_0)
        falling = np.minimum(S_DS, S_D1 / T * np.minimum(1.0, T_L / T)) / B
        rising = S_DS * (ZERO_PERIOD_RATIO + (1.0 / B - ZERO_PERIOD_RATIO) * period / T_0)
        return np.asarray(np.where(period < T_0, rising, falling), dtype=np.float64)
