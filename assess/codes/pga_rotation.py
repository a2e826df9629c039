"""The PGA that takes a mechanism to each rotation, from which spectral procedures read demand, capacity and outcome.

Spectral procedures scale one spectrum with its PGA, so each gives a curve PGA(phi). It starts high (a stiff body
feels the ground's own acceleration), falls where the equivalent period enters the plateau, and rises again as
the period lengthens. An equilibrium on a falling stretch is unstable: a slightly larger rotation needs less PGA. So
below the bottom of the first fall nothing rocks, and above it the demand is the first rotation beyond the bottom
at which the curve reaches the level. `PgaRotation.least` is the PGA that takes the body at least to each rotation
in that sense; it never falls, and demand and capacity are read from it.

A floor spectrum has several peaks, so its curve falls more than once, and the end of its first fall has no meaning.
There `least` is the smallest PGA from each rotation on: the demand is the last rotation at which the curve reaches
the level, whatever lies between.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf

import numpy as np

from assess.codes.check import Outcome, PgaCurve, Reason, reason_message
from assess.codes.context import Context
from assess.messages.message import Message, Quantity, Term
from assess.oscillator import Branch, Oscillator, block_at, plain_branch
from spectra.arrays import FloatArray
from spectra.gravity import g

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
    """Return PGA over rotation, from nearly rest to overturning.

    Points are closer near rest, where periods change fastest.

    Parameters
    ----------
    pga_of : the curve, PGA [m/s2] of rotations [rad]
    overturning : [rad]
    uplift : PGA below which nothing rocks [m/s2]
    period_of : period [s] of rotations [rad]; None where the spectrum has no end
    longest_period : end of the spectrum [s]; the curve ends there

    Returns
    -------
    PgaRotation
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
    """Return PGA over rotation on a floor spectrum, whose curve may fall again; arguments as of `pga_rotation`."""
    rotation, complete = _rotations(overturning, period_of, longest_period)
    least = np.minimum.accumulate(pga_of(rotation)[::-1])[::-1]
    return PgaRotation(rotation, pga_of, 0, np.maximum(least, uplift), complete, falls_again=True)


def rotation_demand(curve: PgaRotation, level: float) -> float | None:
    """Return the rotation at a PGA.

    Parameters
    ----------
    curve : PGA over rotation
    level : PGA [m/s2]

    Returns
    -------
    Rotation [rad], 0 where nothing rocks; None where the level lies above the whole curve: there is no equilibrium and
    the body overturns, or, if the curve is not complete, the spectrum ends too early to tell.
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

    from scipy.optimize import brentq

    return float(brentq(excess, low, high, xtol=1e-14)) if excess(low) < 0 else float(low)


def pga_capacity(curve: PgaRotation, allowable: float) -> float | None:
    """Return the largest PGA whose demand does not exceed an allowable rotation.

    Parameters
    ----------
    curve : PGA over rotation
    allowable : [rad]

    Returns
    -------
    PGA [m/s2]; None beyond the spectrum's end.
    """
    if not curve.least.size or allowable > curve.rotation[-1] * (1 + 1e-12):
        return None
    if curve.falls_again:
        after = int(np.searchsorted(curve.rotation, allowable * (1 - 1e-12)))
        return float(np.clip(curve.pga_of(np.array([allowable]))[0], curve.least[0], curve.least[after]))
    before = np.flatnonzero(curve.rotation <= allowable)
    at = float(curve.pga_of(np.array([allowable]))[0]) if allowable >= curve.rotation[curve.bottom] else 0.0
    return max(float(curve.least[before[-1]] if before.size else curve.least[0]), at)


def to_pga_curve(curve: PgaRotation, branch: Branch) -> PgaCurve:
    """Return the curve of the results: rotation over the branch's overturning rotation, PGA in g."""
    return PgaCurve(
        rotation_ratio=tuple((curve.rotation / branch.overturning).tolist()),
        pga_g=tuple((curve.least / g).tolist()),
    )


@dataclass(frozen=True)
class RotationOutcome:
    """Outcome, reason, and the PGA at capacity [g] where it is known."""

    verdict: Outcome
    reason: Message
    capacity_pga_g: float | None


def rotation_verdict(
    rotation: float | None,
    allowable: float,
    *,
    curve: PgaRotation,
    level: float,
    uplift: float | None,
    context: Context,
) -> RotationOutcome:
    """Compare the demand with the allowable rotation; without an outcome where the spectrum ends before the answer.

    Parameters
    ----------
    rotation : demand [rad]; None where none was found
    allowable : [rad]
    curve : PGA over rotation
    level : PGA [m/s2]
    uplift : multiplier at uplift [-]; None on joints without a threshold
    context : the site

    Returns
    -------
    RotationOutcome
    """
    at_capacity = pga_capacity(curve, allowable)
    in_g = None if at_capacity is None else at_capacity / g
    if rotation is not None:
        within = Outcome.PASS if rotation <= allowable else Outcome.FAIL
        return RotationOutcome(within, _reason_by_rotation(rotation, allowable, level, uplift), in_g)
    if curve.complete:
        return RotationOutcome(Outcome.FAIL, reason_message(Reason.OVERTURNS), in_g)
    if at_capacity is not None:
        return RotationOutcome(Outcome.FAIL, reason_message(Reason.BEYOND_SPECTRUM), in_g)
    end = Quantity(context.spectrum.longest_period, "time")
    return RotationOutcome(
        Outcome.NOT_ANSWERED, reason_message(Reason.SPECTRUM_TOO_SHORT, period=Term("the answer"), end=end), None
    )


def to_equivalent_blocks(oscillator: Oscillator, rotation_of: Callable[[Branch], float]) -> Oscillator:
    """Replace each branch with its equivalent plain block at a rotation; rigid branches stay as they are.

    R, alpha and p at that rotation replace those at rest, as the resultant of the joint has moved inward (6.50-6.52).

    Parameters
    ----------
    oscillator : the mechanism
    rotation_of : gives the rotation of a branch [rad]

    Returns
    -------
    Oscillator
    """
    if all(branch.overturning_flexible is None for branch in oscillator.branches):
        return oscillator
    found = [_equivalent_branch(branch, rotation_of(branch), mass=oscillator.mass) for branch in oscillator.branches]
    return replace(oscillator, positive=found[0], negative=found[1] if len(found) > 1 else None)


def _rotations(overturning: float, period_of: PgaOf | None, longest_period: float) -> tuple[FloatArray, bool]:
    """Return the rotations of a curve [n] [rad], and whether they reach overturning."""
    ratio = np.concatenate((np.geomspace(1e-4, 0.04, 60, endpoint=False), np.linspace(0.04, 1.0, 97)))
    rotation = ratio * overturning
    if period_of is not None:
        rotation = rotation[period_of(rotation) <= longest_period]
    return rotation, rotation.size == ratio.size


def _reason_by_rotation(rotation: float, allowable: float, level: float, uplift: float | None) -> Message:
    if rotation == 0.0:
        return reason_message(_reason_at_rest(level, uplift))
    return reason_message(
        Reason.WITHIN if rotation <= allowable else Reason.BEYOND, capacity=Term("the allowable rotation")
    )


def _reason_at_rest(level: float, uplift: float | None) -> Reason:
    if uplift is None:
        return Reason.ON_JOINTS
    return Reason.NO_ROCKING if level <= uplift * g else Reason.NO_LASTING


def _equivalent_branch(branch: Branch, rotation: float, *, mass: float) -> Branch:
    block = block_at(branch, rotation, mass=mass)
    like = plain_branch(block, restitution=branch.restitution)
    return replace(like, overturning=branch.overturning, overturning_flexible=block.slenderness)
