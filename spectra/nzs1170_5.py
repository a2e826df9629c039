"""The elastic site spectra of NZS 1170.5:2004 with Amendment 1.

Not compared with the printed standard: the numbers agree with three public implementations (eqdes, a spreadsheet module
and a Python one); the vertical ratio is from memory.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from assess.messages.message import Message, Quantity, warning
from spectra.arrays import FloatArray
from spectra.damping import ec8_eta
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.spectrum import Spectrum, check_periods, check_positive

LARGEST_ZR = 0.7  # Z R need not be taken larger, 3.1.1
LARGEST_Z = 2.0  # beyond it is a slip: Table 3.3 ends at 0.6
RISE = 0.1  # s: end of the rising branch
VERTICAL_RATIO = 0.7  # 3.2
FREQUENT = 0.75  # R of 250 years: N = 1 for what is as frequent or more, 3.1.6.1
NEAR, FAR = 2e3, 20e3  # m: distances from the fault between which N falls from N_max to 1, 3.1.6.2
NEAR_FAULT_PERIODS = (1.5, 2.0, 3.0, 4.0, 5.0)  # s, Table 3.7
NEAR_FAULT_FACTORS = (1.00, 1.12, 1.36, 1.60, 1.72)
RETURN_PERIODS = (20.0, 25.0, 50.0, 100.0, 250.0, 500.0, 1000.0, 2000.0, 2500.0)  # years, Table 3.5
RETURN_FACTORS = (0.20, 0.25, 0.35, 0.50, 0.75, 1.00, 1.30, 1.70, 1.80)
DAMPING_RULE = (
    "EN 1998-1 eq. (3.6), applied to NZS 1170.5, which states no rule of its own here: zero-period ordinate kept, eta "
    "in full from 0.1 s on, linear in between"
)


@dataclass(frozen=True)
class Subsoil:
    """Spectral shape C_h(T) of a site subsoil class: commentary C3.1.2, which Table 3.1 rounds to two decimals.

    ground, plateau : C_h at T = 0, and from 0.1 s to `plateau_end` [s]
    reference : C_h = coefficient (reference / T)^0.75 from there to 1.5 s
    velocity : C_h = velocity / T from 1.5 to 3 s, 3 velocity / T^2 beyond
    """

    ground: float
    plateau: float
    plateau_end: float
    coefficient: float
    reference: float
    velocity: float

    def shape(self, period: FloatArray, eta: float) -> FloatArray:
        """Return C_h(T) [-] at `period` [s] (same shape), damped by `eta` [-]; branches join within 0.5 %."""
        T = np.maximum(period, RISE)
        middle = np.minimum(self.coefficient * (self.reference / T) ** 0.75, self.plateau)
        long = self.velocity / T * np.minimum(1.0, 3.0 / T)
        falling = eta * np.where(T > 1.5, long, np.where(self.plateau_end < T, middle, self.plateau))
        rising = self.ground + period / RISE * (eta * self.plateau - self.ground)
        return np.asarray(np.where(period < RISE, rising, falling), dtype=np.float64)


SUBSOILS: Mapping[str, Subsoil] = {
    "A": Subsoil(1.00, 2.35, 0.3, 1.60, 0.5, 1.05),
    "B": Subsoil(1.00, 2.35, 0.3, 1.60, 0.5, 1.05),
    "C": Subsoil(1.33, 2.93, 0.3, 2.00, 0.5, 1.32),
    "D": Subsoil(1.12, 3.00, 0.56, 2.40, 0.75, 2.14),
    "E": Subsoil(1.12, 3.00, 1.0, 3.00, 1.0, 3.32),
}


def site_spectrum(*, subsoil: str, z: float, r: float, near_fault_distance: float | None = None) -> Spectrum:
    """Return the horizontal elastic site spectrum C(T) = C_h(T) Z R N(T, D).

    C_h is that of modal and time-history analysis. Table 3.1 ends at 4.5 s; beyond, its last branch continues. Where Z
    R is reduced to 0.7 the spectrum has a warning.

    Parameters
    ----------
    subsoil : site subsoil class, "A" (strong rock) to "E" (very soft)
    z : hazard factor Z [-]
    r : return period factor R [-]; Z R is taken up to 0.7
    near_fault_distance : D, to the nearest major fault of Table 3.6 [m]; None where there is none

    Raises
    ------
    SpectrumError : the class is unknown, a number is not positive, or Z is above 2

    Source: NZS 1170.5:2004, 3.1.1, eq. 3.1(1), Table 3.1 (commentary C3.1.2), 3.1.6.
    """
    check_positive("nzs1170.5", z=z, r=r)
    if z > LARGEST_Z:
        raise SpectrumError(
            f"nzs1170.5 spectrum: z = {z:.4g}; the hazard factor is at most 0.6 (Table 3.3), a number without unit; is "
            "it in per cent?"
        )
    soil, distance = _subsoil(subsoil), _distance(near_fault_distance)
    zr = min(z * r, LARGEST_ZR)

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        N = near_fault_factor(check_periods(period), distance=distance, r=r)
        return soil.shape(period, ec8_eta(damping)) * zr * g * N

    return Spectrum(
        code="nzs1170.5",
        parameters={
            "subsoil": subsoil,
            "z": z,
            "r": r,
            "zr": zr,
            "near_fault_distance": distance if distance < np.inf else "none",
            "c_0": soil.ground * zr,
        },
        damping=0.05,
        damping_rule=DAMPING_RULE,
        ordinates=ordinates,
        clause="NZS 1170.5:2004, 3.1.1",
        warnings=_cap_warning(z, r),
    )


def vertical_spectrum(*, subsoil: str, z: float, r: float, near_fault_distance: float | None = None) -> Spectrum:
    """Return the vertical elastic site spectrum, C_v(T) = 0.7 C(T).

    Parameters
    ----------
    subsoil, z, r, near_fault_distance : as in `site_spectrum`

    Source: NZS 1170.5:2004, 3.2.
    """
    level = site_spectrum(subsoil=subsoil, z=z, r=r, near_fault_distance=near_fault_distance)
    return replace(
        level,
        parameters={**level.parameters, "vertical_ratio": VERTICAL_RATIO},
        ordinates=lambda period, damping: VERTICAL_RATIO * level.ordinates(period, damping),
        clause="NZS 1170.5:2004, 3.2 (vertical)",
    )


def return_period_factor(years: float) -> float:
    """Return R [-] for a return period of 20 to 2500 years, linear between the rows.

    Raises SpectrumError outside the table. Source: NZS 1170.5:2004, Table 3.5.
    """
    if not RETURN_PERIODS[0] <= years <= RETURN_PERIODS[-1]:
        raise SpectrumError(f"return period {years} years; NZS 1170.5 Table 3.5 has 20 to 2500 years")
    return float(np.interp(years, RETURN_PERIODS, RETURN_FACTORS))


def near_fault_factor(period: ArrayLike, *, distance: float, r: float) -> FloatArray:
    """Return N(T, D) [-] at `period` [s] (same shape): N_max up to D = 2 km, 1 from 20 km on, linear in between.

    distance : D [m]; r : R [-], as an event of 250 years or less (R <= 0.75) has N = 1. Source: NZS 1170.5:2004, 3.1.6,
    Table 3.7.
    """
    N_max = np.interp(np.asarray(period, dtype=np.float64), NEAR_FAULT_PERIODS, NEAR_FAULT_FACTORS)
    share = 0.0 if r <= FREQUENT else float(np.clip((FAR - distance) / (FAR - NEAR), 0.0, 1.0))
    return np.asarray(1.0 + share * (N_max - 1.0))


def _cap_warning(z: float, r: float) -> tuple[Message, ...]:
    """Return a warning where Z R is more than the standard asks for."""
    if z * r <= LARGEST_ZR:
        return ()
    values = {"z": Quantity(z), "r": Quantity(r), "product": Quantity(z * r), "most": Quantity(LARGEST_ZR)}
    return (warning("site-factors-capped", **values),)


def _subsoil(name: str) -> Subsoil:
    if name not in SUBSOILS:
        raise SpectrumError(f"nzs1170.5 spectrum: subsoil = {name}; choose one of {', '.join(SUBSOILS)}")
    return SUBSOILS[name]


def _distance(given: float | None) -> float:
    """Return D [m]; infinite where no fault is near."""
    if given is not None and not given >= 0.0:
        raise SpectrumError(f"nzs1170.5 spectrum: near_fault_distance = {given} m; it must be 0 or more")
    return np.inf if given is None else given
