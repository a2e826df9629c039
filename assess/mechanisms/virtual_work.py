"""Virtual work over the blocks and loads of a chain.

I = sum m (x'^2 + z'^2) + J theta'^2      dV/dphi = sum m g z'      M = sum F.r'      B = sum m x'      C = sum m z'
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.errors import FallingError, MechanismError
from assess.loads.load import Force, PointMass, Tie, pull_at_rest
from assess.mechanisms.chain import Chain
from assess.mechanisms.motion import Path, move, trace_point
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

FACES = {
    1: "A lies on the face ahead",
    2: "A and C lie on the face ahead, B on the one behind",
    3: "as a portal sways, A and D lie on the faces ahead of its posts, B and C on those behind",
}
"""Faces on which hinges must lie for the blocks to rise, by the number of blocks; ahead is the way of the branch."""


@dataclass(frozen=True, repr=False)
class Work(ShortRepr):
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
    """Return the sums of virtual work over blocks and loads.

    A non-bearing mass adds horizontal inertia to I, B and sum m x'^2 only (thesis 3.21 leaves it out of I, though it
    moves with the wall).

    Parameters
    ----------
    chain : on rigid hinges
    rotation : of its leading block [n] [rad]
    """
    motion = move(chain, rotation)
    inertia, moment, excitation, participation, lift = (np.zeros_like(rotation) for _ in range(5))
    for rate, block in zip(motion.rate, chain.blocks, strict=True):
        inertia += block.inertia * rate**2
    blocks = [(block.mass, block.centroid, True, number) for number, block in enumerate(chain.blocks)]
    points = [(load.mass, load.at, load.bearing, load.block) for load in chain.loads if isinstance(load, PointMass)]
    for mass, at, bearing, number in (*blocks, *points):
        moved = trace_point(motion, block=number, at=at)
        excitation += mass * moved.dx
        participation += mass * moved.dx**2
        inertia += mass * (moved.dx**2 + moved.dz**2 if bearing else moved.dx**2)
        lift += mass * moved.dz if bearing else 0.0
    for load in chain.loads:
        if not isinstance(load, PointMass):
            moment += generalised_moment(load, trace_point(motion, block=load.block, at=load.at))
    return Work(inertia, g * lift, moment, excitation, participation, lift)


def generalised_moment(load: Force | Tie, moved: Path) -> FloatArray:
    """Return the generalised moment F.r' of a force or tie [n] [N m]; positive overturns."""
    if isinstance(load, Force):
        return load.force[0] * moved.dx + load.force[1] * moved.dz
    if load.anchor is None:
        along, up = load.direction or (0.0, 0.0)
        work = load.tension * (along * moved.dx + up * moved.dz)
    else:
        to_x, to_z = load.anchor[0] - moved.x, load.anchor[1] - moved.z
        work = load.tension * (to_x * moved.dx + to_z * moved.dz) / np.hypot(to_x, to_z)
    slack = not load.both and work[0] > 0.0  # the point moves along the pull of the tie: the tie shortens
    return np.zeros_like(work) if slack else np.asarray(work)


def require_stable(chain: Chain, *, name: str) -> None:
    """Raise MechanismError for a chain that falls by itself, or that a push along the direction does not start."""
    rest = virtual_work(chain, np.zeros(1))
    if rest.restoring[0] <= 0.0:
        raise FallingError(
            f'mechanism "{name}": already falling: its weights resist with {rest.weight[0]:.4g} N m at rest, '
            f"{_blamed(chain, rest)}"
        )
    if rest.excitation[0] <= 0.0:
        raise MechanismError(
            f'mechanism "{name}": a push along the direction does not start it (sum m x\' = {rest.excitation[0]:.4g} '
            "kg m); its hinges move the masses the other way: check them"
        )


def _blamed(chain: Chain, rest: Work) -> str:
    """Name what makes a chain fall: the forces that overturn it, or else the faces on which its hinges lie."""
    moments = {load: _moment(load, chain) for load in chain.loads if not isinstance(load, PointMass)}
    forces = sorted((load for load, moment in moments.items() if moment > 0.0), key=lambda load: -moments[load])
    if not forces:
        return f"and no given force overturns it; check its hinges: {FACES[len(chain.blocks)]}"
    named = "; ".join(_described(load) for load in forces[:3])
    return f"its given forces overturn with {rest.moment[0]:.4g} N m: {named}; check loads and hinges"


def _moment(load: Force | Tie, chain: Chain) -> float:
    """Return the generalised moment of a force or tie at rest [N m]; positive overturns."""
    return float(generalised_moment(load, trace_point(move(chain, np.zeros(1)), block=load.block, at=load.at))[0])


def _described(load: Force | Tie) -> str:
    """Describe a force or tie by its name, its components at rest, and its source."""
    along, up = load.force if isinstance(load, Force) else pull_at_rest(load)
    found = f" ({load.source})" if load.source else ""
    return f'load "{load.name}" with H = {abs(along) / 1e3:.4g} kN, V = {up / 1e3:+.4g} kN up{found}'
