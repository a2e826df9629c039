"""From a mechanism to its oscillator, by virtual work over the blocks and loads of its chains.

I = sum m (x'^2 + z'^2) + J theta'^2      dV/dphi = sum m g z'      M = sum F.r'      B = sum m x'      C = sum m z'
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g
from scipy.optimize import brentq

from assess.errors import MechanismError
from assess.loads import Force, PointMass, Tie
from assess.mechanisms.chain import Chain
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.motion import Path, limit, move, place
from assess.oscillator import Branch, Oscillator

FloatArray = NDArray[np.float64]

NODES = 257  # of a branch table; a block's cubic splines are then exact to 1e-11 of their largest value
FLAT = 1e-6  # of the geometric limit: a loop is never taken quite to it, where its rates grow without bound
REACH = 1.5  # tables end at this many overturning rotations


@dataclass(frozen=True)
class Work:
    """The sums of virtual work at rotations [n]: I, dV/dphi, M of the given forces, B, sum m x'^2, C."""

    inertia: FloatArray
    weight: FloatArray
    moment: FloatArray
    excitation: FloatArray
    participation: FloatArray
    lift: FloatArray

    @property
    def restoring(self) -> FloatArray:
        """dV/dphi - M [n] [N m]."""
        return self.weight - self.moment


def virtual_work(chain: Chain, rotation: FloatArray) -> Work:
    """The sums over blocks and loads at `rotation` [n] [rad].

    A mass that is not bearing adds horizontal inertia to I, B and sum m x'^2 only (the thesis' 3.21 leaves it out of
    I, though it moves with the wall).
    """
    motion = move(chain, rotation)
    inertia, moment, excitation, participation, lift = (np.zeros_like(rotation) for _ in range(5))
    for rate, block in zip(motion.rate, chain.blocks, strict=True):
        inertia += block.inertia * rate**2
    blocks = [(block.mass, block.centroid, True, number) for number, block in enumerate(chain.blocks)]
    points = [(load.mass, load.at, load.bearing, load.block) for load in chain.loads if isinstance(load, PointMass)]
    for mass, at, bearing, number in (*blocks, *points):
        moved = place(motion, block=number, at=at)
        excitation += mass * moved.dx
        participation += mass * moved.dx**2
        inertia += mass * (moved.dx**2 + moved.dz**2 if bearing else moved.dx**2)
        lift += mass * moved.dz if bearing else 0.0
    for load in chain.loads:
        if not isinstance(load, PointMass):
            moment += pulled(load, place(motion, block=load.block, at=load.at))
    return Work(inertia, g * lift, moment, excitation, participation, lift)


def pulled(load: Force | Tie, moved: Path) -> FloatArray:
    """Generalised moment F.r' [n] [N m] of a force or tie; positive overturns."""
    if isinstance(load, Force):
        return load.force[0] * moved.dx + load.force[1] * moved.dz
    if load.anchor is None:
        along, up = load.direction or (0.0, 0.0)
        work = load.pull * (along * moved.dx + up * moved.dz)
    else:
        to_x, to_z = load.anchor[0] - moved.x, load.anchor[1] - moved.z
        work = load.pull * (to_x * moved.dx + to_z * moved.dz) / np.hypot(to_x, to_z)
    slack = not load.both and work[0] > 0.0  # the point moves the way the tie pulls: it shortens
    return np.zeros_like(work) if slack else np.asarray(work)


def first_fall(values: FloatArray, rotation: FloatArray, value_at: Callable[[float], float]) -> float | None:
    """The first rotation [rad] where `values` [n] over `rotation` [n] go from + to -; None where they never do."""
    falling = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
    if not falling.size:
        return None
    first = int(falling[0])
    return float(brentq(value_at, rotation[first], rotation[first + 1], xtol=1e-15, rtol=1e-14))


def require_stable(chain: Chain, *, name: str) -> None:
    """Raise MechanismError for a chain that falls by itself, or that no push along the direction would start."""
    rest = virtual_work(chain, np.zeros(1))
    if rest.restoring[0] <= 0.0:
        raise MechanismError(
            f'mechanism "{name}": already falling: its weights resist with {rest.weight[0]:.4g} N m at rest, its '
            f"given forces overturn with {rest.moment[0]:.4g} N m; check loads and hinges"
        )
    if rest.excitation[0] <= 0.0:
        raise MechanismError(
            f'mechanism "{name}": a push along the direction does not start it (sum m x\' = {rest.excitation[0]:.4g} '
            "kg m); its hinges move the masses the other way: check them"
        )


def branch(chain: Chain, *, restitution: float, name: str) -> Branch:
    """The table of one chain, from rest to REACH times its overturning rotation, and at least to phi_cr.

    Raises MechanismError for a chain that falls by itself, or that never overturns before it can turn no further.
    """
    require_stable(chain, name=name)
    reach = limit(chain) * (1.0 - FLAT)
    scan = np.linspace(0.0, reach, 2001)
    whole = virtual_work(chain, scan)

    def at(phi: float) -> Work:
        return virtual_work(chain, np.array([0.0, phi]))  # rest first: it tells whether a tie is slack

    overturning = first_fall(whole.restoring, scan, lambda phi: float(at(phi).restoring[1]))
    critical = first_fall(whole.weight, scan, lambda phi: float(at(phi).weight[1]))
    edge = first_fall(whole.excitation, scan, lambda phi: float(at(phi).excitation[1])) or reach
    if overturning is None or critical is None or max(overturning, critical) >= edge:
        last = "the body lies level with its hinge" if len(chain.blocks) == 1 else "its blocks can turn no further"
        raise MechanismError(
            f'mechanism "{name}": the restoring moment does not fall to zero before {last}, at {edge:.3g} rad; it '
            "cannot overturn as described: check hinges and loads"
        )
    end = min(max(REACH * overturning, 1.05 * critical), 0.5 * (max(overturning, critical) + edge))
    rotation = np.linspace(0.0, end, NODES)
    work = virtual_work(chain, rotation)
    columns = (rotation, work.inertia, work.restoring, work.excitation, work.participation, work.lift)
    for column in columns:
        column.flags.writeable = False
    return Branch(*columns, restitution=restitution, overturning=overturning, critical=critical)


def oscillator(mechanism: Mechanism) -> Oscillator:
    """The mechanism as the dynamics and the codes see it."""
    first, second = mechanism.restitution
    negative = mechanism.negative
    return Oscillator(
        positive=branch(mechanism.positive, restitution=first, name=mechanism.name),
        negative=None if negative is None else branch(negative, restitution=second, name=mechanism.name),
        mass=mechanism.positive.mass,
    )
