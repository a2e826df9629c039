"""The spectrum of the motion at the base of a mechanism above the ground, for the method that has no floor clause.

A suite carried up by the first mode gives the response spectra of its motions: their envelope, with the peaks widened
by 15 % to both sides for what is not known of the building's period. The mean would be lower; the clause that allows it
could not be read, and one record that lies low at the building's period would pull it down, so the envelope is taken.
Without such a suite it is C7.2.5 of Circolare 7/2019, where the building's height and storeys are known, its period
varied by 15 % too. Neither is taken below the spectrum of the ground: a suite is finite, and one mode leaves the
others out.
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
from spectra.floor_spectrum import Mode, circolare2019, first_mode_factor
from spectra.spectrum import Spectrum

LEAST_RECORDS = 5  # of the response-history method of the same standard
WIDENED = 0.15  # of the period, to both sides
SHORTEST, LONGEST, APART = 0.02, 15.0, 1.03  # s, s, and the ratio of two periods at which the motions are asked
NEAR_MODE = np.linspace(0.85, 1.15, 61)  # of the building's period, where the peak is
PERIODS = np.linspace(1.0 - WIDENED, 1.0 + WIDENED, 7)  # of the building, over its own
MOST_DAMPING = 0.99  # of an oscillator that still swings
SUITE = "envelope of the response spectra of the suite at the mechanism's base, peaks widened by 15 %"
CIRCULAR = "Circolare 7/2019, C7.2.5, first mode"


def floor_spectrum(
    ground: Spectrum,
    *,
    height: float,
    filtered: ModalFilter | None,
    base: Sequence[BaseMotion],
    motions: Sequence[ScaledRecord],
    building: Building | None,
) -> Spectrum | None:
    """The spectrum at a `height` above the ground [m], at the PGA of `ground`; None where nothing gives one.

    filtered : how the motions got to `base`, where it was through a mode and the suite holds
    """
    if filtered is not None and len(motions) >= LEAST_RECORDS:
        records = [scale(at.record, motion.scaling.factor) for at, motion in zip(base, motions, strict=True)]
        return suite_spectrum(ground, records, mode=filtered.mode)
    if building is not None and building.storeys is not None and height <= building.height:
        return circular_spectrum(ground, height=height, building=building, storeys=building.storeys)
    return None


def suite_spectrum(ground: Spectrum, records: Sequence[Record], *, mode: FirstMode) -> Spectrum:
    """The envelope of the motions at the base, scaled to the site, with its peaks widened."""
    periods = np.unique(np.concatenate(([0.0], _sample_periods(), NEAR_MODE / mode.frequency)))

    @lru_cache(maxsize=8)
    def widened(damping: float) -> FloatArray:
        at = min(damping, MOST_DAMPING)
        return widen(periods, np.max([response_spectrum(record, periods, damping=at) for record in records], axis=0))

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        T = np.asarray(period, dtype=np.float64)
        return np.maximum(np.interp(T, periods, widened(damping)), ground.acceleration(T, damping=damping))

    rule = "response of the motions themselves at that damping"
    parameters = {"records": float(len(records)), "first mode": 1.0 / mode.frequency}
    return Spectrum("floor", parameters, ground.damping, rule, ordinates, SUITE, longest_period=ground.longest_period)


def circular_spectrum(ground: Spectrum, *, height: float, building: Building, storeys: int) -> Spectrum:
    """C7.2.5 at a height [m], the first mode linear over the building's height, the largest over 15 % of its period."""
    share = first_mode_factor(storeys) * height / building.height
    modes = [Mode(building.period * factor, building.damping, share) for factor in PERIODS]

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        T = np.asarray(period, dtype=np.float64)
        above = [circolare2019(T, spectrum=ground, modes=(mode,), damping=damping) for mode in modes]
        largest: FloatArray = np.maximum(np.max(above, axis=0), ground.acceleration(T, damping=damping))
        return largest

    parameters = {"T_1": building.period, "share of the mode": share}
    rule = f"C7.2.6, {ground.damping_rule}"
    return Spectrum(
        "floor", parameters, ground.damping, rule, ordinates, CIRCULAR, longest_period=ground.longest_period
    )


def widen(period: FloatArray, acceleration: FloatArray) -> FloatArray:
    """The largest ordinate within 15 % of each period, to both sides [n]."""
    low = np.searchsorted(period, period * (1.0 - WIDENED), side="left")
    high = np.searchsorted(period, period / (1.0 - WIDENED), side="right")
    return np.array([acceleration[a:b].max() for a, b in zip(low, high, strict=True)])


def _sample_periods() -> FloatArray:
    count = int(np.ceil(np.log(LONGEST / SHORTEST) / np.log(APART))) + 1
    return np.geomspace(SHORTEST, LONGEST, count)
