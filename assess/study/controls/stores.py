"""Where the energy of a moving mechanism is: in its speed, its height, and the work of the ground on its masses.

Three sources give the same four numbers over rotation. `of_masses` adds them up from the masses and loads of a chain in
its displaced place, without any derivative of the height and without the table of the branch; `of_table` integrates the
table, where joints deform or actions end; `of_line` is the linearised equation.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.loads.load import Force, PointMass, Tie
from assess.mechanisms.chain import Chain
from assess.mechanisms.motion import Path, move, trace_point
from assess.oscillator import Branch, Linearised
from spectra.arrays import FloatArray


@dataclass(frozen=True)
class Stores:
    """A branch at n rotations, in its own sign.

    inertia : twice the kinetic energy at a rate of one [kg m2]
    stored : potential energy of weights, forces and joints, from rest [J]
    push : sum of mass times horizontal displacement [kg m]; slope : its derivative [kg m]
    """

    inertia: FloatArray
    stored: FloatArray
    push: FloatArray
    slope: FloatArray


StoresAt = Callable[[FloatArray], Stores]


def of_masses(chain: Chain) -> StoresAt:
    """Return the energies of a rigid chain over its rotation, whose forces and ties act throughout."""

    def at(rotation: FloatArray) -> Stores:
        motion = move(chain, np.concatenate([[0.0], rotation]))  # rest first: heights count from it
        inertia, stored, push, slope = np.zeros((4, rotation.size + 1))
        for rate, block in zip(motion.rate, chain.blocks, strict=True):
            inertia += block.inertia * rate**2
        masses = [(block.mass, block.centroid, True, number) for number, block in enumerate(chain.blocks)]
        masses += [
            (load.mass, load.at, load.bearing, load.block) for load in chain.loads if isinstance(load, PointMass)
        ]
        for mass, place, bearing, number in masses:
            moved = trace_point(motion, block=number, at=place)
            inertia += mass * (moved.dx**2 + bearing * moved.dz**2)
            stored += mass * g * bearing * (moved.z - moved.z[0])
            push += mass * (moved.x - moved.x[0])
            slope += mass * moved.dx
        for load in chain.loads:
            if not isinstance(load, PointMass):
                stored -= _work(load, trace_point(motion, block=load.block, at=load.at))
        return Stores(inertia[1:], stored[1:], push[1:], slope[1:])

    return at


def of_table(branch: Branch) -> StoresAt:
    """Return the energies of a branch over its rotation, integrated from its table."""
    return lambda rotation: Stores(
        np.asarray(branch.inertia_spline(rotation)),
        np.asarray(branch.energy_spline(rotation)),
        np.asarray(branch.excitation_integral(rotation)),
        np.asarray(branch.excitation_spline(rotation)),
    )


def of_line(line: Linearised) -> StoresAt:
    """Return the energies of the linearised equation: a constant inertia, and a moment that falls evenly."""
    inertia, K, B, end = line.inertia, line.stiffness, line.excitation, line.overturning
    return lambda rotation: Stores(
        np.full_like(rotation, inertia),
        K * rotation * (end - 0.5 * rotation),
        B * rotation,
        np.full_like(rotation, B),
    )


def _work(load: Force | Tie, moved: Path) -> FloatArray:
    """Return the work of a force or tie of constant size from rest [n] [J]; none of a tie that shortens."""
    if isinstance(load, Force):
        return np.asarray(load.force[0] * (moved.x - moved.x[0]) + load.force[1] * (moved.z - moved.z[0]))
    if load.anchor is None:
        along, up = load.direction or (0.0, 0.0)
        work = load.tension * (along * (moved.x - moved.x[0]) + up * (moved.z - moved.z[0]))
        starting = along * moved.dx[0] + up * moved.dz[0]
    else:
        to_x, to_z = load.anchor[0] - moved.x, load.anchor[1] - moved.z
        length = np.hypot(to_x, to_z)
        work = load.tension * (length[0] - length)
        starting = to_x[0] * moved.dx[0] + to_z[0] * moved.dz[0]
    return np.zeros_like(work) if starting > 0.0 and not load.both else np.asarray(work)
