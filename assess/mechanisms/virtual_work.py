"""From a mechanism to its oscillator, by virtual work over the blocks of its chains.

I = sum m (x'^2 + z'^2) + J theta'^2      dV/dphi = sum m g z'      B = sum m x'      C = sum m z'
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g
from scipy.optimize import brentq

from assess.errors import MechanismError
from assess.mechanisms.chain import Chain, moved
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Branch, Oscillator

FloatArray = NDArray[np.float64]

NODES = 257  # of a branch table; a block's cubic splines are then exact to 1e-11 of their largest value
REACH = 1.5  # tables end at this many overturning rotations


@dataclass(frozen=True)
class Work:
    """The sums of virtual work at rotations [n]: I, dV/dphi, B, sum m x'^2, C."""

    inertia: FloatArray
    weight: FloatArray
    excitation: FloatArray
    participation: FloatArray
    lift: FloatArray


def virtual_work(chain: Chain, rotation: FloatArray) -> Work:
    """The sums over the chain's blocks at `rotation` [n] [rad]."""
    motion = moved(chain, rotation)
    mass = np.array([block.mass for block in chain.blocks])
    about_centroid = np.array([block.inertia for block in chain.blocks])
    lift = mass @ motion.dz
    return Work(
        inertia=mass @ (motion.dx**2 + motion.dz**2) + about_centroid @ motion.dtheta**2,
        weight=g * lift,
        excitation=mass @ motion.dx,
        participation=mass @ motion.dx**2,
        lift=lift,
    )


def overturning_rotation(chain: Chain, *, name: str) -> float:
    """phi_ov [rad]: the first rotation > 0 where the restoring moment goes from + to -.

    Raises MechanismError when the chain never overturns within half a turn.
    """
    scan = np.linspace(0.0, np.pi, 2001)
    moment = virtual_work(chain, scan).weight
    falling = np.flatnonzero((moment[:-1] > 0) & (moment[1:] <= 0))
    if not falling.size:
        raise MechanismError(f'mechanism "{name}": the restoring moment never falls to zero; it cannot overturn')
    first = int(falling[0])

    def moment_at(phi: float) -> float:
        return float(virtual_work(chain, np.array([phi])).weight[0])

    return float(brentq(moment_at, scan[first], scan[first + 1], xtol=1e-15, rtol=1e-14))


def branch(chain: Chain, *, restitution: float, name: str) -> Branch:
    """The table of one chain from rest to REACH times its overturning rotation."""
    overturning = overturning_rotation(chain, name=name)
    rotation = np.linspace(0.0, REACH * overturning, NODES)
    work = virtual_work(chain, rotation)
    columns = (rotation, work.inertia, work.weight, work.excitation, work.participation, work.lift)
    for column in columns:
        column.flags.writeable = False
    return Branch(*columns, restitution=restitution, overturning=overturning, critical=overturning)


def oscillator(mechanism: Mechanism) -> Oscillator:
    """The mechanism as the dynamics and the codes see it."""
    first, second = mechanism.restitution
    negative = mechanism.negative
    return Oscillator(
        positive=branch(mechanism.positive, restitution=first, name=mechanism.name),
        negative=None if negative is None else branch(negative, restitution=second, name=mechanism.name),
        mass=sum(block.mass for block in mechanism.positive.blocks),
    )
