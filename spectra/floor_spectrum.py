"""Floor spectra: pseudo-acceleration of a part of period T at a height of a building, by each code's rule."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.constants import g

from spectra.arrays import FloatArray
from spectra.errors import SpectrumError
from spectra.floor import ec8_floor_factors
from spectra.floor import nzs1170_5 as floor_height_coefficient
from spectra.spectrum import check_periods

PART_DUCTILITIES = (1.0, 1.25, 1.5, 1.75, 2.0, 3.0)  # NZS 1170.5 Table 8.2; 1.5 and 1.75 after its commentary
PART_RESPONSE_FACTORS = (1.00, 0.85, 0.75, 0.65, 0.55, 0.45)
LARGEST_PART_COEFFICIENT = 3.6  # F_ph / W_p, NZS 1170.5 8.5.1


def ec8(
    period: ArrayLike, *, ground: float, height: float, building_height: float, building_period: float
) -> FloatArray:
    """Return S_a g of a part at a height of a building.

    Parameters
    ----------
    period : T_a of the part [any shape] [s]
    ground : a_g S, peak acceleration of the surface [m/s2]
    height, building_height : z and H [m]
    building_period : T_1 [s]

    Returns
    -------
    array [shape of period] [m/s2]

    Raises
    ------
    SpectrumError : the height is outside the building, or T_1 is not positive

    Source: EN 1998-1:2004, 4.3.5.2, eq. (4.25); not checked against the printed standard.
    """
    T_a = period_array(period)
    T_1 = first_period(building_period, clause="EN 1998-1, 4.3.5.2")
    return ground * ec8_floor_factors(T_a / T_1, height=height, building_height=building_height)


def nzs1170_5(period: ArrayLike, *, ground: float, height: float, building_height: float) -> FloatArray:
    """Return C_p(T_p) g = C(0) C_Hi C_i(T_p) g of a part at a height of a building.

    Parameters
    ----------
    period : T_p of the part [any shape] [s]
    ground : C(0) g, zero-period ordinate of the site spectrum [m/s2]
    height, building_height : h_i and h_n [m]

    Returns
    -------
    array [shape of period] [m/s2]

    Source: NZS 1170.5:2004, 8.2, eq. 8.2(1); not checked against the printed standard.
    """
    return ground * floor_height_coefficient(height, building_height=building_height) * part_shape(period)


def part_shape(period: ArrayLike) -> FloatArray:
    """Return C_i(T_p) [-]: 2 up to 0.75 s, 2 (1.75 - T_p) to 1.5 s, 0.5 beyond. Source: NZS 1170.5:2004, 8.4."""
    return np.asarray(np.clip(2.0 * (1.75 - period_array(period)), 0.5, 2.0))


def part_response_factor(ductility: float) -> float:
    """Return C_ph [-] of a part with ductility mu_p, linear between rows; 0.45 from 3 on.

    Source: NZS 1170.5, Table 8.2.
    """
    if not ductility >= 1.0:
        raise SpectrumError(f"ductility of the part {ductility}; NZS 1170.5 Table 8.2 begins at 1")
    return float(np.interp(ductility, PART_DUCTILITIES, PART_RESPONSE_FACTORS))


def part_action(coefficient: ArrayLike, *, ductility: float = 1.0, risk_factor: float = 1.0) -> FloatArray:
    """Return F_ph / W_p g = C_p C_ph R_p g [m/s2], at most 3.6 g, from C_p(T_p) g [m/s2] (same shape).

    Source: NZS 1170.5:2004, 8.5.1, eq. 8.5(1), Table 8.1 for R_p; not checked against the printed standard.
    """
    action = np.asarray(coefficient, dtype=np.float64) * part_response_factor(ductility) * risk_factor
    return np.asarray(np.minimum(action, LARGEST_PART_COEFFICIENT * g))


def period_array(period: ArrayLike) -> FloatArray:
    return check_periods(np.asarray(period, dtype=np.float64))


def first_period(building_period: float, *, clause: str) -> float:
    if not building_period > 0.0:
        raise SpectrumError(f"period of the building {building_period} s; {clause} needs one that is positive")
    return building_period
