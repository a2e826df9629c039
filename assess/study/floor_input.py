"""The floor spectrum at a mechanism above the ground, for the method that has no clause on floor spectra.

If the suite is filtered by the first mode, it is the envelope of the response spectra at the base, with peaks broadened
by 15 % to both sides for the uncertainty of the building's period. The mean would be lower; the clause that allows it
could not be read, and one record that is low at the building's period would reduce it, so the envelope is taken.
Otherwise it is C7.2.5 of Circolare 7/2019, if the building's height and storeys are known, its period varied by 15 %
too. Neither is taken below the spectrum of the ground: a suite is finite, and one mode neglects the others.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from assess.amplification.floor_motion import BaseMotion, FirstMode, ModalFilter
from assess.codes.context import Building
from assess.study.motions import ScaledRecord
from records.record import Record, scale
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.circolare2019 import Mode, circolare2019, first_mode_factor
from spectra.spectrum import Spectrum

LEAST_RECORDS = 5  # of the response-history method of the same standard
BROADENING = 0.15  # of the period, to both sides
SHORTEST, LONGEST, APART = 0.02, 15.0, 1.03  # s, s, and the ratio of two periods at which the motions are asked
NEAR_MODE = np.linspace(0.85, 1.15, 61)  # of the building's period, where the peak is
PERIODS = np.linspace(1.0 - BROADENING, 1.0 + BROADENING, 7)  # of the building, over its own
MOST_DAMPING = 0.99  # of an oscillator that still swings
SUITE = "envelope of the response spectra of the suite at the mechanism's base, peaks widened by 15 %"
CIRCULAR = "Circolare 7/2019, C7.2.5, first mode"
OF_MOTIONS = "response of the motions themselves at that damping"
OF_CIRCULAR = "Circolare 7/2019, C7.2.6, with the rule for damping of the spectrum of the ground"


def floor_spectrum(
    ground: Spectrum,
    *,
    height: float,
    filtered: ModalFilter | None,
    base: Sequence[BaseMotion],
    motions: Sequence[ScaledRecord],
    building: Building | None,
) -> Spectrum | None:
    """Return the floor spectrum at a height, at the PGA of the ground's spectrum.

    Parameters
    ----------
    ground : Spectrum
        The spectrum of the ground.
    height : float
        Height above the ground [m].
    filtered : ModalFilter, optional
        The filter through which the motions reached the base, if they did and the suite meets the rules.
    base, motions : sequence
        The motions at the base, and their factors.
    building : Building, optional
        The building, with its height and storeys.

    Returns
    -------
    Spectrum or None
        None if neither the suite nor the building gives one.
    """
    if filtered is not None and len(motions) >= LEAST_RECORDS:
        records = [scale(at.record, motion.scaling.factor) for at, motion in zip(base, motions, strict=True)]
        return suite_spectrum(ground, records, mode=filtered.mode)
    if building is not None and building.storeys is not None and height <= building.height:
        return circular_spectrum(ground, height=height, building=building, storeys=building.storeys)
    return None


def suite_spectrum(ground: Spectrum, records: Sequence[Record], *, mode: FirstMode) -> Spectrum:
    """Return the envelope of the response spectra at the base, with its peaks broadened.

    The response is computed once for each damping that a procedure uses.
    """
    periods = np.unique(np.concatenate(([0.0], _sample_periods(), NEAR_MODE / mode.frequency)))

    @lru_cache(maxsize=8)
    def broadened(damping: float) -> FloatArray:
        at = min(damping, MOST_DAMPING)
        return broaden(periods, np.max([response_spectrum(record, periods, damping=at) for record in records], axis=0))

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        T = np.asarray(period, dtype=np.float64)
        return np.maximum(np.interp(T, periods, broadened(damping)), ground.acceleration(T, damping=damping))

    parameters = {"records": float(len(records)), "first mode": 1.0 / mode.frequency}
    return Spectrum(
        "floor", parameters, ground.damping, OF_MOTIONS, ordinates, SUITE, longest_period=ground.longest_period
    )


def circular_spectrum(ground: Spectrum, *, height: float, building: Building, storeys: int) -> Spectrum:
    """Return the spectrum of C7.2.5 at a height [m]: first mode linear over the height, envelope within 15 % of T_1."""
    share = first_mode_factor(storeys) * height / building.height
    modes = [Mode(building.period * factor, building.damping, share) for factor in PERIODS]

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        T = np.asarray(period, dtype=np.float64)
        above = [circolare2019(T, spectrum=ground, modes=(mode,), damping=damping) for mode in modes]
        largest: FloatArray = np.maximum(np.max(above, axis=0), ground.acceleration(T, damping=damping))
        return largest

    parameters = {"T_1": building.period, "share of the mode": share}
    return Spectrum(
        "floor", parameters, ground.damping, OF_CIRCULAR, ordinates, CIRCULAR, longest_period=ground.longest_period
    )


def broaden(period: FloatArray, acceleration: FloatArray) -> FloatArray:
    """Return the largest ordinate within 15 % of each period, to both sides [n]."""
    low = np.searchsorted(period, period * (1.0 - BROADENING), side="left")
    high = np.searchsorted(period, period / (1.0 - BROADENING), side="right")
    return np.array([acceleration[a:b].max() for a, b in zip(low, high, strict=True)])


def _sample_periods() -> FloatArray:
    count = int(np.ceil(np.log(LONGEST / SHORTEST) / np.log(APART))) + 1
    return np.geomspace(SHORTEST, LONGEST, count)
