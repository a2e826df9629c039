"""Floor factors: what a code multiplies the peak ground acceleration by for a part at a height of the building."""

from __future__ import annotations

from math import isfinite

import numpy as np
from numpy.typing import ArrayLike

from spectra.arrays import FloatArray
from spectra.errors import SpectrumError

NZS_LOW = 12.0  # m: height below which 1 + h/6 applies
NZS_SHARE = 0.2  # of the building's height, where 1 + 10 h/H ends


def ec8_floor_factors(
    period_ratio: ArrayLike, *, height: float, building_height: float, soil_factor: float = 1.0
) -> FloatArray:
    """Return S [3 (1 + z/H) / (1 + (1 - T_a/T_1)^2) - 0.5], at least S [-]: the coefficient S_a over alpha.

    Parameters
    ----------
    period_ratio : T_a / T_1, of the part to the building [any shape] [-]
    height : z, above the base of the building [m]
    building_height : H [m]
    soil_factor : S [-]; 1 where the ground motion is already that of the surface

    Returns
    -------
    array [shape of period_ratio] [-]

    Raises
    ------
    SpectrumError : the height is outside 0 <= z <= H

    Source: EN 1998-1:2004, 4.3.5.2, eq. (4.25); not checked against the printed standard.
    """
    ratio = height_ratio(height, building_height, clause="EN 1998-1, 4.3.5.2")
    detuned = (1.0 - np.asarray(period_ratio, dtype=np.float64)) ** 2
    return np.asarray(soil_factor * np.maximum(1.0, 3.0 * (1.0 + ratio) / (1.0 + detuned) - 0.5))


def ec8_floor_factor(height: float, *, building_height: float, period_ratio: float, soil_factor: float = 1.0) -> float:
    """Return `ec8_floor_factors` of one part [-].

    Parameters
    ----------
    height, building_height : z and H [m]
    period_ratio : T_a / T_1 [-]
    soil_factor : S [-]
    """
    return float(
        ec8_floor_factors(period_ratio, height=height, building_height=building_height, soil_factor=soil_factor)
    )


def ec8(height: float, *, building_height: float) -> float:
    """Return 1.5 (1 + z/H) - 0.5 [-], for a rigid part (T_a = 0) on the motion of the surface: 1 at the ground to 2.5.

    Parameters
    ----------
    height, building_height : z and H [m]
    """
    return ec8_floor_factor(height, building_height=building_height, period_ratio=0.0)


def ec8_resonance(height: float, *, building_height: float) -> float:
    """Return 3 (1 + z/H) - 0.5 [-], for a part in resonance with the building (T_a = T_1): 2.5 at the ground already.

    Parameters
    ----------
    height, building_height : z and H [m]
    """
    return ec8_floor_factor(height, building_height=building_height, period_ratio=1.0)


def ec8_at_resonance_with_soil(height: float, *, building_height: float, soil_factor: float) -> float:
    """Return S [3 (1 + z/H) - 0.5] [-], thesis eq. 3.49: the clause at resonance (T_a = T_1) with the soil factor.

    On a motion of the surface it counts the soil twice.

    Parameters
    ----------
    height, building_height : z and H [m]
    soil_factor : S [-]
    """
    return ec8_floor_factor(height, building_height=building_height, period_ratio=1.0, soil_factor=soil_factor)


def nzs1170_5(height: float, *, building_height: float) -> float:
    """Return the floor height coefficient C_Hi [-]: the least of those that apply of 1 + h/6, 1 + 10 h/H and 3.

    Parameters
    ----------
    height : h_i, of the attachment [m]
    building_height : h_n, to the uppermost seismic mass [m]

    Raises
    ------
    SpectrumError : the height is outside 0 <= h <= H

    Source: NZS 1170.5:2004, 8.3; thesis eqs. 3.50-3.52 (3.52 is h >= 0.2 H); not checked against the printed standard.
    """
    ratio = height_ratio(height, building_height, clause="NZS 1170.5, 8.3")
    upper = 1.0 + 10.0 * ratio if ratio < NZS_SHARE else 3.0
    return min(upper, 1.0 + height / 6.0) if height < NZS_LOW else upper


def height_ratio(height: float, building_height: float, *, clause: str) -> float:
    """Return z / H [-]; refuse heights outside the building, citing the clause."""
    if not (isfinite(building_height) and building_height > 0.0):
        raise SpectrumError(f"height of the building {building_height} m; {clause} needs one that is positive")
    if not 0.0 <= height <= building_height * (1.0 + 1e-9):
        raise SpectrumError(
            f"height {height:.6g} m in a building of {building_height:.6g} m; {clause} holds from its base to its top"
        )
    return height / building_height
