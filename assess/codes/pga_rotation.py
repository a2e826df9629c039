"""The PGA that takes a mechanism to each rotation, and the two questions asked of it: demand and capacity.

Spectral procedures scale one spectrum with its PGA, so each gives a curve PGA(phi). It starts high (a stiff body
feels the ground's own acceleration), falls where the equivalent period enters the plateau, and rises again as
the period lengthens. An equilibrium on a falling stretch is unstable: a little more rotation asks for less. So
below the bottom of the first fall nothing rocks, and above it the demand is the first rotation beyond the bottom
at which the curve reaches the level. `PgaRelation.least` is the PGA that takes the body at least to each rotation
in that sense; it never falls, and both questions are read from it.

A floor spectrum has several peaks, so its curve falls more than once, and where the first fall ends tells nothing. Of
such a curve `least` is the smallest PGA from each rotation on: the demand is the last rotation at which the spectrum
still asks for what the body has, whatever lies between.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.check import PgaCurve
from assess.oscillator import Branch
from spectra.arrays import FloatArray

PgaOf = Callable[[FloatArray], FloatArray]


@dataclass(frozen=True)
class PgaRotation:
    """PGA [m/s2] over rotation [rad], up to overturning or to where the spectrum ends.

    rotation [n]; pga_of: the curve itself; bottom: index where its first fall ends, 0 where it may fall again;
    least [n]: see above; falls_again: whether it may; complete: whether the curve reaches the overturning rotation.
    """

    rotation: FloatArray
    pga_of: PgaOf
    bottom: int
    least: FloatArray
    complete: bool
    falls_again: bool = False


def pga_rotation(
    pga_of: PgaOf,
    *,
    overturning: float,
    uplift: float = 0.0,
    period_of: PgaOf | None = None,
    longest_period: float = inf,
) -> PgaRotation:
    """The relation from nearly rest to `overturning` [rad]: finer near rest, where periods change fastest.

    Nothing rocks below `uplift` [m/s2]. Where `period_of` (rotation -> period [s]) exceeds `longest_period`, the
    spectrum says nothing and the relation ends.
    """
    rotation, complete = _rotations(overturning, period_of, longest_period)
    pga = pga_of(rotation)
    rising = np.flatnonzero(np.diff(pga) >= 0)
    bottom = int(rising[0]) if rising.size else max(rotation.size - 1, 0)
    least = np.maximum.accumulate(np.concatenate((pga[bottom : bottom + 1].repeat(bottom), pga[bottom:])))
    return PgaRotation(rotation, pga_of, bottom, np.maximum(least, uplift), complete)


def floor_pga_rotation(
    pga_of: PgaOf, *, overturning: float, uplift: float, period_of: PgaOf, longest_period: float
) -> PgaRotation:
    """The same on a floor spectrum, whose curve may fall again."""
    rotation, complete = _rotations(overturning, period_of, longest_period)
    least = np.minimum.accumulate(pga_of(rotation)[::-1])[::-1]
    return PgaRotation(rotation, pga_of, 0, np.maximum(least, uplift), complete, falls_again=True)


def _rotations(overturning: float, period_of: PgaOf | None, longest_period: float) -> tuple[FloatArray, bool]:
    """The rotations of a relation [n] [rad], and whether they reach overturning."""
    ratio = np.concatenate((np.geomspace(1e-4, 0.04, 60, endpoint=False), np.linspace(0.04, 1.0, 97)))
    rotation = ratio * overturning
    if period_of is not None:
        rotation = rotation[period_of(rotation) <= longest_period]
    return rotation, rotation.size == ratio.size


def rotation_demand(curve: PgaRotation, level: float) -> float | None:
    """Rotation [rad] at PGA `level` [m/s2].

    0 where nothing rocks; None where the level lies above the whole curve: no equilibrium, the body overturns, or,
    if the curve is not complete, the spectrum ends too early to tell.
    """
    if not curve.least.size:
        return None
    if level <= curve.least[0]:
        return 0.0
    reached = np.flatnonzero(curve.least >= level)
    if not reached.size:
        return None
    low, high = curve.rotation[max(reached[0] - 1, curve.bottom)], curve.rotation[reached[0]]

    def excess(rotation: float) -> float:
        return float(curve.pga_of(np.array([rotation]))[0]) - level

    return float(brentq(excess, low, high, xtol=1e-14)) if excess(low) < 0 else float(low)


def pga_capacity(curve: PgaRotation, allowable: float) -> float | None:
    """Largest PGA [m/s2] whose demand does not exceed `allowable` [rad]; None beyond the spectrum's end."""
    if not curve.least.size or allowable > curve.rotation[-1] * (1 + 1e-12):
        return None
    if curve.falls_again:
        after = int(np.searchsorted(curve.rotation, allowable * (1 - 1e-12)))
        return float(np.clip(curve.pga_of(np.array([allowable]))[0], curve.least[0], curve.least[after]))
    before = np.flatnonzero(curve.rotation <= allowable)
    at = float(curve.pga_of(np.array([allowable]))[0]) if allowable >= curve.rotation[curve.bottom] else 0.0
    return max(float(curve.least[before[-1]] if before.size else curve.least[0]), at)


def to_pga_curve(curve: PgaRotation, branch: Branch) -> PgaCurve:
    """The relation as it goes into the results: rotation over the branch's overturning rotation, PGA in g."""
    return PgaCurve(
        rotation_ratio=tuple((curve.rotation / branch.overturning).tolist()),
        pga_g=tuple((curve.least / g).tolist()),
    )
