"""The velocities with which a chain leaves or reaches its rest, and the momentum in them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.loads.load import PointMass
from assess.mechanisms.chain import Chain
from assess.mechanisms.motion import move, trace_point
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray


@dataclass(frozen=True, repr=False)
class VelocityField(ShortRepr):
    """Velocities at rest for a unit rate of phi in the sign of the branch; one row for each block, then each mass.

    shaken, borne : mass that moves horizontally and vertically [rows] [kg]; along, up : x' and z' [rows] [m]
    turning : theta' [rows] [-]; inertia : about each centroid [rows] [kg m2]; x, z : places [rows] [m]
    """

    shaken: FloatArray
    borne: FloatArray
    inertia: FloatArray
    along: FloatArray
    up: FloatArray
    turning: FloatArray
    x: FloatArray
    z: FloatArray


def velocity_field(chain: Chain, *, sliding: bool = False) -> VelocityField:
    """Return the velocities with which a chain leaves or reaches its rest.

    sliding : bearing masses slide on their seats and transfer no horizontal momentum
    """
    motion = move(chain, np.zeros(1))
    parts = chain.parts or tuple((block, number) for number, block in enumerate(chain.blocks))
    moving = [(part.mass, part.mass, part.inertia, part.centroid, number) for part, number in parts]
    masses = [load for load in chain.loads if isinstance(load, PointMass)]
    for load in masses:
        shaken = 0.0 if sliding and load.bearing else load.mass
        moving.append((shaken, load.mass * load.bearing, 0.0, load.at, load.block))
    rows = []
    for shaken, borne, turned, at, number in moving:
        if number is None:
            rows.append((shaken, borne, turned, 0.0, 0.0, 0.0, *at))
            continue
        path = trace_point(motion, block=number, at=at)
        rows.append((shaken, borne, turned, path.dx[0], path.dz[0], motion.rate[number, 0], *at))
    return VelocityField(*np.array(rows, dtype=np.float64).T)


def kinetic_product(ending: VelocityField, starting: VelocityField) -> float:
    """Return the kinetic product of two fields [kg m2], the second mirrored back to the sign of the first.

    The product of a field with itself, not mirrored, is the inertia I of the branch.
    """
    along = np.sum(ending.shaken * ending.along * -starting.along)
    up = np.sum(ending.borne * ending.up * starting.up)
    return float(along + up + np.sum(ending.inertia * ending.turning * -starting.turning))


def inertia_at_rest(moving: VelocityField) -> float:
    """Return I of the branch at rest [kg m2]."""
    squares = moving.shaken * moving.along**2 + moving.borne * moving.up**2 + moving.inertia * moving.turning**2
    return float(np.sum(squares))


def angular_momentum(moving: VelocityField, x: float, z: float) -> float:
    """Return the angular momentum about a point (x, z) in the frame of the field, clockwise [kg m2]."""
    arms = (moving.z - z) * moving.shaken * moving.along - (moving.x - x) * moving.borne * moving.up
    return float(np.sum(arms + moving.inertia * moving.turning))
