"""Floor factors and floor spectra: what shakes a part at a height of a building, by the rule of each code.

A floor factor multiplies the peak ground acceleration; a floor spectrum is the pseudo-acceleration of a part of period
T. EN 1998-1 and NZS 1170.5 have both. Circolare 7/2019, C7.2.3, combines the modes of the building, each with its
share at the height of the part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite

import numpy as np
from numpy.typing import ArrayLike

from spectra.arrays import FloatArray
from spectra.damping import check_damping, ec8_eta
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.spectrum import Spectrum, check_periods

NZS_LOW = 12.0  # m: height below which 1 + h/6 applies
NZS_SHARE = 0.2  # of the building's height, where 1 + 10 h/H ends


def ec8_floor_factor(height: float, *, building_height: float, period_ratio: float, soil_factor: float = 1.0) -> float:
    """Return `_ec8_floor_factors` of one part [-].

    Parameters
    ----------
    height, building_height : z and H [m]
    period_ratio : T_a / T_1 [-]
    soil_factor : S [-]
    """
    return float(
        _ec8_floor_factors(period_ratio, height=height, building_height=building_height, soil_factor=soil_factor)
    )


def ec8_rigid_part_factor(height: float, *, building_height: float) -> float:
    """Return 1.5 (1 + z/H) - 0.5 [-], for a rigid part (T_a = 0) on the motion of the surface: 1 at the ground to 2.5.

    Parameters
    ----------
    height, building_height : z and H [m]
    """
    return ec8_floor_factor(height, building_height=building_height, period_ratio=0.0)


def ec8_resonant_part_factor(height: float, *, building_height: float) -> float:
    """Return 3 (1 + z/H) - 0.5 [-], for a part in resonance with the building (T_a = T_1): 2.5 at the ground already.

    Parameters
    ----------
    height, building_height : z and H [m]
    """
    return ec8_floor_factor(height, building_height=building_height, period_ratio=1.0)


def ec8_resonant_part_factor_with_soil(height: float, *, building_height: float, soil_factor: float) -> float:
    """Return S [3 (1 + z/H) - 0.5] [-], thesis eq. 3.49: the clause at resonance (T_a = T_1) with the soil factor.

    On a motion of the surface it counts the soil twice.

    Parameters
    ----------
    height, building_height : z and H [m]
    soil_factor : S [-]
    """
    return ec8_floor_factor(height, building_height=building_height, period_ratio=1.0, soil_factor=soil_factor)


def nzs1170_5_height_coefficient(height: float, *, building_height: float) -> float:
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


PART_DUCTILITIES = (1.0, 1.25, 1.5, 1.75, 2.0, 3.0)  # NZS 1170.5 Table 8.2; 1.5 and 1.75 after its commentary
PART_RESPONSE_FACTORS = (1.00, 0.85, 0.75, 0.65, 0.55, 0.45)
LARGEST_PART_COEFFICIENT = 3.6  # F_ph / W_p, NZS 1170.5 8.5.1


def ec8_floor_spectrum(
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
    T_a = _period_array(period)
    T_1 = _first_period(building_period, clause="EN 1998-1, 4.3.5.2")
    return ground * _ec8_floor_factors(T_a / T_1, height=height, building_height=building_height)


def nzs1170_5_floor_spectrum(period: ArrayLike, *, ground: float, height: float, building_height: float) -> FloatArray:
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
    return ground * nzs1170_5_height_coefficient(height, building_height=building_height) * part_shape(period)


def part_shape(period: ArrayLike) -> FloatArray:
    """Return C_i(T_p) [-]: 2 up to 0.75 s, 2 (1.75 - T_p) to 1.5 s, 0.5 beyond. Source: NZS 1170.5:2004, 8.4."""
    return np.asarray(np.clip(2.0 * (1.75 - _period_array(period)), 0.5, 2.0))


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


COUPLING = (0.4, 0.5)  # beta of C7.2.4
PLATEAU = (0.8, 1.1)  # a, b of C7.2.6: the level branch lies between a T_k and b T_k


@dataclass(frozen=True)
class Mode:
    """A mode of the building: T_k [s], damping xi_k [-], and |gamma_k psi_k(z)|, its share at the part's height [-]."""

    period: float
    damping: float
    share: float


@dataclass(frozen=True)
class FrameCoefficients:
    """a, b and a_p of C7.2.11 [-]."""

    a: float
    b: float
    a_p: float


FRAMES: Mapping[str, FrameCoefficients] = {  # Circolare 7/2019, after C7.2.11
    "short": FrameCoefficients(0.8, 1.4, 5.0),  # T_1 < 0.5 s
    "medium": FrameCoefficients(0.3, 1.2, 4.0),  # 0.5 s to 1.0 s
    "long": FrameCoefficients(0.3, 1.0, 2.5),  # T_1 > 1.0 s
}


def first_mode_factor(storeys: int) -> float:
    """Return gamma_1 = 3 n / (2 n + 1) [-] of a linear first mode.

    Source: Circolare 7/2019, C7.2.10; 617/2009, C8A.4.2.3.
    """
    if storeys < 1:
        raise SpectrumError(f"{storeys} storeys; C7.2.10 needs at least one")
    return 3.0 * storeys / (2.0 * storeys + 1.0)


def circolare2019_peak_acceleration(spectrum: Spectrum, *, modes: Sequence[Mode]) -> float:
    """Return a_Z [m/s2], the peak acceleration of the floor, the modes combined by squares.

    Source: Circolare 7/2019, C7.2.7, C7.2.8.
    """
    return float(np.sqrt(sum(_modal_peak(spectrum, mode) ** 2 for mode in _check_modes(modes))))


def circolare2019_floor_spectrum(
    period: ArrayLike, *, spectrum: Spectrum, modes: Sequence[Mode], damping: float = 0.05
) -> FloatArray:
    """Return S_eZ(T, xi, z), the floor spectrum of a building's modes, combined by squares.

    Beyond the longest of their periods S_eZ is at least S_e of the ground. The text says xi_k is in per cent. That
    suits C7.2.7; in A of C7.2.6 it can only be the ratio, else A is below 1. Where high damping brings A below 1 all
    the same, it is kept at 1, as the curve would turn negative.

    Parameters
    ----------
    period : T of the part [any shape] [s]
    spectrum : of the ground
    modes : of the building, with their shares at the height of the part
    damping : xi of the part [-]

    Returns
    -------
    array [shape of period] [m/s2]

    Source: Circolare 7/2019, C7.2.5-C7.2.7, by a public transcription of the text.
    """
    T = _period_array(period)
    S_eZ = np.sqrt(sum(_modal_floor_spectrum(T, spectrum, mode, damping) ** 2 for mode in _check_modes(modes)))
    beyond = max(mode.period for mode in modes) < T
    ground = spectrum.acceleration(T, damping=damping)
    return np.asarray(np.where(beyond, np.maximum(S_eZ, ground), S_eZ), dtype=np.float64)


def circolare2019_first_mode(
    period: ArrayLike, *, spectrum: Spectrum, first: ArrayLike, mode_damping: float, share: float, damping: float
) -> FloatArray:
    """Return S_eZ(T, xi, z) of one mode for each of its periods, as `circolare2019_floor_spectrum`; shapes broadcast.

    Parameters
    ----------
    period : T of the part [s]
    spectrum : of the ground
    first : periods of the mode [s]
    mode_damping : xi_1 of the building [-]
    share : |gamma_1 psi_1(z)| [-]
    damping : xi of the part [-]

    Returns
    -------
    array [shapes broadcast] [m/s2]
    """
    T, T_1 = _period_array(period), np.asarray(first, dtype=np.float64)
    _check_modes([Mode(float(T_1.min()), mode_damping, share)])
    peak = first_mode_peak(T_1, spectrum=spectrum, mode_damping=mode_damping, share=share)
    S_eZ = _three_branches(T, T_1, peak, _resonance(mode_damping, damping))
    ground = spectrum.acceleration(T, damping=damping)
    return np.asarray(np.where(T_1 < T, np.maximum(S_eZ, ground), S_eZ), dtype=np.float64)


def first_mode_peak(first: ArrayLike, *, spectrum: Spectrum, mode_damping: float, share: float) -> FloatArray:
    """Return a_Z under one mode, for each of its periods.

    Parameters
    ----------
    first : periods of the mode [any shape] [s]
    spectrum : of the ground
    mode_damping : xi_1 of the building [-]
    share : |gamma_1 psi_1(z)| [-]

    Returns
    -------
    array [shape of first] [m/s2]

    Source: Circolare 7/2019, C7.2.7, C7.2.8.
    """
    xi = 100.0 * check_damping(mode_damping)
    ordinate = spectrum.acceleration(first, damping=mode_damping)
    return np.asarray(ordinate * abs(share) * np.sqrt(1.0 + 0.0004 * xi**2))


def circolare2019_modal(
    period: ArrayLike, *, spectrum: Spectrum, modes: Sequence[Mode], damping: float = 0.05, beta: float = 0.5
) -> FloatArray:
    """Return S_a of a part, mode by mode, combined by squares.

        S_a,ij = R S_ij     S_ij = phi_ij Gamma_i S_i(T_i)

    Parameters
    ----------
    period : T_a of the part [any shape] [s]
    spectrum : of the ground
    modes : of the building, `share` = |phi_ij Gamma_i| at the floor of the part
    damping : xi_a of the part [-]
    beta : of the coupling between part and building, 0.4 to 0.5 [-]; 0.5 is the larger near resonance

    Raises
    ------
    SpectrumError : beta is outside its range, or there are no modes

    Source: Circolare 7/2019, C7.2.1-C7.2.4, by a public transcription of the text.
    """
    T_a = _period_array(period)
    if not COUPLING[0] <= beta <= COUPLING[1]:
        raise SpectrumError(f"beta = {beta}; Circolare 7/2019, C7.2.4 has {COUPLING[0]} to {COUPLING[1]}")
    squares = [
        (_modal_floor_acceleration(spectrum, mode) * part_amplification(T_a / mode.period, damping, beta=beta)) ** 2
        for mode in _check_modes(modes)
    ]
    return np.asarray(np.sqrt(sum(squares)), dtype=np.float64)


def part_amplification(period_ratio: ArrayLike, damping: float, *, beta: float) -> FloatArray:
    """Return R = [(2 xi_a r)^2 + (1 - r^2)^2]^-beta [-] at r = T_a / T_i (same shape); 1 for a rigid part (C7.2.4)."""
    r, xi = np.asarray(period_ratio, dtype=np.float64), check_damping(damping)
    return np.asarray(((2.0 * xi * r) ** 2 + (1.0 - r**2) ** 2) ** -beta)


def circolare2019_frame(
    period: ArrayLike, *, ground: float, height: float, building_height: float, building_period: float
) -> FloatArray:
    """Return S_a g of a part in a building of frames.

    Parameters
    ----------
    period : T_a of the part [any shape] [s]
    ground : a_g S [m/s2]
    height, building_height : z and H [m]
    building_period : T_1 [s]

    Source: Circolare 7/2019, C7.2.11, by a public transcription of the text.
    """
    T_a, T_1 = _period_array(period), _first_period(building_period, clause="Circolare 7/2019, C7.2.11")
    ratio = height_ratio(height, building_height, clause="Circolare 7/2019, C7.2.11")
    frame = FRAMES["short" if T_1 < 0.5 else "medium" if T_1 <= 1.0 else "long"]
    below, above = np.maximum(1.0 - T_a / (frame.a * T_1), 0.0), np.maximum(T_a / (frame.b * T_1) - 1.0, 0.0)
    resonance = frame.a_p / (1.0 + (frame.a_p - 1.0) * (below**2 + above**2))
    return np.asarray(ground * np.maximum(1.0, (1.0 + ratio) * resonance))


def _ec8_floor_factors(
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


def _period_array(period: ArrayLike) -> FloatArray:
    """Return periods [s] as an array; refuse periods that are negative or not numbers."""
    return check_periods(np.asarray(period, dtype=np.float64))


def _first_period(building_period: float, *, clause: str) -> float:
    """Return T_1 of the building [s]; refuse one that is not positive, citing the clause."""
    if not building_period > 0.0:
        raise SpectrumError(f"period of the building {building_period} s; {clause} needs one that is positive")
    return building_period


def _resonance_factor(mode: Mode, damping: float) -> float:
    """Return a = 1.1 xi_k^-0.5 eta(xi) [-], at least 1, with xi_k as a ratio. Source: Circolare 7/2019, C7.2.6."""
    return _resonance(mode.damping, damping)


def _resonance(mode_damping: float, damping: float) -> float:
    return float(max(1.1 * mode_damping**-0.5 * ec8_eta(damping), 1.0))


def _modal_peak(spectrum: Spectrum, mode: Mode) -> float:
    """Return a_Z,k = S_e(T_k, xi_k) |gamma_k psi_k| sqrt(1 + 0.0004 xi_k^2) [m/s2], xi_k in per cent (C7.2.7)."""
    return float(first_mode_peak(mode.period, spectrum=spectrum, mode_damping=mode.damping, share=mode.share))


def _modal_floor_acceleration(spectrum: Spectrum, mode: Mode) -> float:
    """Return S_ij = |phi_ij Gamma_i| S_i(T_i) [m/s2] (C7.2.1)."""
    return float(spectrum.acceleration(mode.period, damping=mode.damping)) * abs(mode.share)


def _modal_floor_spectrum(period: FloatArray, spectrum: Spectrum, mode: Mode, damping: float) -> FloatArray:
    """Return S_eZ,k [m/s2] (C7.2.6), which rises from a_Z,k at T = 0 to A a_Z,k about T_k, and falls."""
    return _three_branches(period, mode.period, _modal_peak(spectrum, mode), _resonance_factor(mode, damping))


def _three_branches(period: FloatArray, first: ArrayLike, peak: ArrayLike, A: float) -> FloatArray:
    """Return the three branches of C7.2.6 under modes of period `first` [s], a_Z = `peak` [m/s2]; shapes broadcast."""
    (a, b), T_1 = PLATEAU, np.asarray(first, dtype=np.float64)
    rising = np.maximum(1.0 - period / (a * T_1), 0.0) ** 1.6
    falling = np.maximum(period / (b * T_1) - 1.0, 0.0) ** 1.2
    return np.asarray(A * np.asarray(peak) / (1.0 + (A - 1.0) * (rising + falling)))


def _check_modes(modes: Sequence[Mode]) -> Sequence[Mode]:
    """Return the modes, at least one, with positive periods and damping."""
    if not modes:
        raise SpectrumError("a floor spectrum of Circolare 7/2019 needs at least one mode of the building")
    for mode in modes:
        if not (mode.period > 0.0 and mode.damping > 0.0):
            raise SpectrumError(f"mode of {mode.period} s, damping {mode.damping}; C7.2.6 needs both positive")
    return modes
