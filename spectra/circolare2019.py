"""Floor spectra of Circolare 7/2019, C7.2.3: the modes of the building, each with its share at the part's height."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from spectra.arrays import FloatArray
from spectra.damping import check_damping, ec8_eta
from spectra.errors import SpectrumError
from spectra.floor import height_ratio
from spectra.floor_spectrum import first_period, period_array
from spectra.spectrum import Spectrum

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


def circolare2019_peak(spectrum: Spectrum, *, modes: Sequence[Mode]) -> float:
    """Return a_Z [m/s2], the peak acceleration of the floor, the modes combined by squares.

    Source: Circolare 7/2019, C7.2.7, C7.2.8.
    """
    return float(np.sqrt(sum(_modal_peak(spectrum, mode) ** 2 for mode in _some(modes))))


def circolare2019(period: ArrayLike, *, spectrum: Spectrum, modes: Sequence[Mode], damping: float = 0.05) -> FloatArray:
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
    T = period_array(period)
    summed = np.sqrt(sum(_modal_floor_spectrum(T, spectrum, mode, damping) ** 2 for mode in _some(modes)))
    beyond = max(mode.period for mode in modes) < T
    ground = spectrum.acceleration(T, damping=damping)
    return np.asarray(np.where(beyond, np.maximum(summed, ground), summed), dtype=np.float64)


def circolare2019_first_mode(
    period: ArrayLike, *, spectrum: Spectrum, first: ArrayLike, mode_damping: float, share: float, damping: float
) -> FloatArray:
    """Return S_eZ(T, xi, z) of `circolare2019` under one mode, for each of its periods; shapes broadcast.

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
    T, T_1 = period_array(period), np.asarray(first, dtype=np.float64)
    _some([Mode(float(T_1.min()), mode_damping, share)])
    peak = first_mode_peak(T_1, spectrum=spectrum, mode_damping=mode_damping, share=share)
    found = _stretches(T, T_1, peak, _resonance(mode_damping, damping))
    ground = spectrum.acceleration(T, damping=damping)
    return np.asarray(np.where(T_1 < T, np.maximum(found, ground), found), dtype=np.float64)


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
    T_a = period_array(period)
    if not COUPLING[0] <= beta <= COUPLING[1]:
        raise SpectrumError(f"beta = {beta}; Circolare 7/2019, C7.2.4 has {COUPLING[0]} to {COUPLING[1]}")
    squares = [
        (_modal_floor_acceleration(spectrum, mode) * part_amplification(T_a / mode.period, damping, beta=beta)) ** 2
        for mode in _some(modes)
    ]
    return np.asarray(np.sqrt(sum(squares)), dtype=np.float64)


def part_amplification(period_ratio: ArrayLike, damping: float, *, beta: float) -> FloatArray:
    """Return R = [(2 xi_a r)^2 + (1 - r^2)^2]^-beta [-] at r = T_a / T_i (same shape); 1 for a rigid part (C7.2.4)."""
    r, xi = np.asarray(period_ratio, dtype=np.float64), check_damping(damping)
    return np.asarray(((2.0 * xi * r) ** 2 + (1.0 - r**2) ** 2) ** -beta)


def resonance_factor(mode: Mode, damping: float) -> float:
    """Return a = 1.1 xi_k^-0.5 eta(xi) [-], at least 1, with xi_k as a ratio. Source: Circolare 7/2019, C7.2.6."""
    return _resonance(mode.damping, damping)


def _resonance(mode_damping: float, damping: float) -> float:
    return float(max(1.1 * mode_damping**-0.5 * ec8_eta(damping), 1.0))


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
    T_a, T_1 = period_array(period), first_period(building_period, clause="Circolare 7/2019, C7.2.11")
    ratio = height_ratio(height, building_height, clause="Circolare 7/2019, C7.2.11")
    frame = FRAMES["short" if T_1 < 0.5 else "medium" if T_1 <= 1.0 else "long"]
    below, above = np.maximum(1.0 - T_a / (frame.a * T_1), 0.0), np.maximum(T_a / (frame.b * T_1) - 1.0, 0.0)
    resonance = frame.a_p / (1.0 + (frame.a_p - 1.0) * (below**2 + above**2))
    return np.asarray(ground * np.maximum(1.0, (1.0 + ratio) * resonance))


def _modal_peak(spectrum: Spectrum, mode: Mode) -> float:
    """Return a_Z,k = S_e(T_k, xi_k) |gamma_k psi_k| sqrt(1 + 0.0004 xi_k^2) [m/s2], xi_k in per cent (C7.2.7)."""
    return float(first_mode_peak(mode.period, spectrum=spectrum, mode_damping=mode.damping, share=mode.share))


def _modal_floor_acceleration(spectrum: Spectrum, mode: Mode) -> float:
    """Return S_ij = |phi_ij Gamma_i| S_i(T_i) [m/s2] (C7.2.1)."""
    return float(spectrum.acceleration(mode.period, damping=mode.damping)) * abs(mode.share)


def _modal_floor_spectrum(period: FloatArray, spectrum: Spectrum, mode: Mode, damping: float) -> FloatArray:
    """Return S_eZ,k [m/s2] (C7.2.6), which rises from a_Z,k at T = 0 to A a_Z,k about T_k, and falls."""
    return _stretches(period, mode.period, _modal_peak(spectrum, mode), resonance_factor(mode, damping))


def _stretches(period: FloatArray, first: ArrayLike, peak: ArrayLike, A: float) -> FloatArray:
    """Return the three branches of C7.2.6 under modes of period `first` [s], a_Z = `peak` [m/s2]; shapes broadcast."""
    (a, b), T_1 = PLATEAU, np.asarray(first, dtype=np.float64)
    rising = np.maximum(1.0 - period / (a * T_1), 0.0) ** 1.6
    falling = np.maximum(period / (b * T_1) - 1.0, 0.0) ** 1.2
    return np.asarray(A * np.asarray(peak) / (1.0 + (A - 1.0) * (rising + falling)))


def _some(modes: Sequence[Mode]) -> Sequence[Mode]:
    if not modes:
        raise SpectrumError("a floor spectrum of Circolare 7/2019 needs at least one mode of the building")
    for mode in modes:
        if not (mode.period > 0.0 and mode.damping > 0.0):
            raise SpectrumError(f"mode of {mode.period} s, damping {mode.damping}; C7.2.6 needs both positive")
    return modes
