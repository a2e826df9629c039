"""The PGA that takes a mechanism to each rotation, and the two questions asked of it: demand and capacity.

Spectral procedures scale one spectrum with its PGA, so each gives a curve PGA(phi). It starts high (a stiff body
feels the ground's own acceleration), falls where the equivalent period enters the plateau, and rises again as
the period lengthens. An equilibrium on a falling stretch is unstable: a little more rotation asks for less. So
the demand is the first rotation at which the curve rises through the level.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.check import PgaCurve
from assess.oscillator import Branch

FloatArray = NDArray[np.float64]
PgaOf = Callable[[FloatArray], FloatArray]


@dataclass(frozen=True)
class PgaRelation:
    """PGA [m/s2] over rotation [rad], on a grid and as the function behind it."""

    rotation: FloatArray
    pga: FloatArray
    pga_of: PgaOf


def relation(pga_of: PgaOf, *, overturning: float) -> PgaRelation:
    """The relation from nearly rest to `overturning` [rad]: finer near rest, where periods change fastest."""
    ratio = np.concatenate((np.geomspace(1e-4, 0.04, 60, endpoint=False), np.linspace(0.04, 1.0, 97)))
    rotation = ratio * overturning
    return PgaRelation(rotation, pga_of(rotation), pga_of)


def demand(curve: PgaRelation, level: float) -> float | None:
    """Rotation [rad] at PGA `level` [m/s2]: where the curve first rises through it.

    0 where the level lies below the whole curve (no rocking); None where it lies above all that follows the
    first fall (no equilibrium: the body overturns).
    """
    below = curve.pga < level
    if not below.any():
        return 0.0
    rising = np.flatnonzero(below[:-1] & ~below[1:])
    if not rising.size:
        return None
    low, high = curve.rotation[rising[0]], curve.rotation[rising[0] + 1]
    return float(brentq(lambda phi: float(curve.pga_of(np.array([phi]))[0]) - level, low, high, xtol=1e-14))


def capacity(curve: PgaRelation, allowable: float, *, uplift: float) -> float:
    """Largest PGA [m/s2] whose demand does not exceed the rotation `allowable` [rad]; never below `uplift` [m/s2]."""
    grid = np.append(curve.rotation[curve.rotation < allowable], allowable)
    pga = curve.pga_of(grid)
    falling = np.flatnonzero(np.diff(pga) >= 0)
    trough = int(falling[0]) if falling.size else grid.size - 1
    return max(float(pga[trough:].max()), uplift)


def as_curve(curve: PgaRelation, branch: Branch) -> PgaCurve:
    """The relation as it goes into the results: rotation over the branch's overturning rotation, PGA in g."""
    return PgaCurve(
        rotation_ratio=tuple((curve.rotation / branch.overturning).tolist()),
        pga_g=tuple((curve.pga / g).tolist()),
    )
