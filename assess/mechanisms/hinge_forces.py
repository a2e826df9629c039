"""The forces at the hinges of a mechanism at incipient motion, by equilibrium of every block, without virtual work."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import isclose

import numpy as np

from assess.loads.load import Force, Load, Point, PointMass, Tie, pull_at_rest, stretches, upward
from assess.mechanisms.chain import Chain, hinge_names, move, trace_point
from assess.mechanisms.flexible_chain import FlexibleChain
from assess.mechanisms.mechanism import Face, Mechanism
from assess.oscillator import HingeForces, Pressure, Vector
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray
from spectra.gravity import g

ON_TOP = 1e-6  # of a wall's height: a load this near its top rests on it


def hinge_forces(mechanism: Mechanism) -> tuple[HingeForces, ...]:
    """Return the forces of every hinge of both branches; empty if the blocks have no faces (an equivalent block)."""
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    return tuple(
        forces
        for chain, faces, first in zip(chains, mechanism.faces, (True, False), strict=False)
        for forces in _chain_hinge_forces(chain_at_start(chain, name=mechanism.name), faces, positive=first)
    )


def chain_at_start(chain: Chain, *, name: str) -> Chain:
    """Return the chain about its hinges at incipient motion.

    Parameters
    ----------
    chain : of one branch
    name : of the mechanism, for errors

    Returns
    -------
    Its hinges are, on joints, a_SF inside the edges, else at the edges.
    """
    if not any(chain.joints):
        return chain
    fixed = FlexibleChain(chain, name).fixed_hinge_chain
    return fixed if incipient_motion(fixed).multiplier > 0.0 else chain


def is_top_support(chain: Chain, number: int) -> bool:
    """Return whether a hinge is the support at the top of a wall.

    Parameters
    ----------
    chain : of two blocks, if it is a wall held at its top
    number : of the hinge, from 0 at the base
    """
    return len(chain.blocks) == number == 2


@dataclass(frozen=True, repr=False)
class IncipientMotion(ShortRepr):
    """A chain at incipient motion, under horizontal forces of `multiplier` times all weights along the direction.

    forces : (x, z) of each hinge on the block above it [hinges, 2] [N]; of D on the ground
    """

    multiplier: float
    forces: FloatArray


def incipient_motion(chain: Chain) -> IncipientMotion:
    """Solve the equilibrium of every block at incipient motion: as many equations as unknowns."""
    count, hinges = len(chain.blocks), len(chain.hinges)
    rows, right = np.zeros((3 * count, 2 * hinges + 1)), np.zeros(3 * count)
    for number in range(count):
        own = slice(3 * number, 3 * number + 3)
        rows[own, 2 * number : 2 * number + 2] = _moment_arms(chain.hinges[number])
        if number + 1 < hinges:
            rows[own, 2 * number + 2 : 2 * number + 4] = -_moment_arms(chain.hinges[number + 1])
    for number, at, force, inertia_force in _loads(chain):
        own = slice(3 * number, 3 * number + 3)
        rows[own, -1] += _moment_arms(at) @ (inertia_force, 0.0)
        right[own] -= _moment_arms(at) @ force
    known = [2 * hinges - 1] if count == 2 else []  # C slides: it has no vertical reaction
    free = [column for column in range(2 * hinges + 1) if column not in known]
    solved = np.zeros(2 * hinges + 1)
    solved[free] = np.linalg.solve(rows[:, free], right)
    return IncipientMotion(float(solved[-1]), solved[:-1].reshape(-1, 2))


def hinge_compressions(chain: Chain) -> tuple[float, ...]:
    """Return the vertical compression between the blocks that each hinge joins [N]; negative for tension.

    Of two blocks the one with the higher centroid rests on the other; the ground carries both A and D.
    """
    ground = float("-inf")
    heights = [ground, *(block.centroid[1] for block in chain.blocks), ground]
    up = incipient_motion(chain).forces[:, 1]
    return tuple(float(u if high >= low else -u) + 0.0 for u, (low, high) in zip(up, pairwise(heights), strict=False))


def _chain_hinge_forces(chain: Chain, faces: tuple[Face, ...], *, positive: bool) -> list[HingeForces]:
    """Return the forces of the hinges of one branch in its own sign."""
    found, mark, single = incipient_motion(chain), "" if positive else "'", len(chain.blocks) == 1
    made = []
    for number, (hinge_name, face) in enumerate(zip(hinge_names(chain), faces, strict=True)):
        force = _force_on_pressing_block(chain, found, number)
        starting = _resolve_pressure(force, face.normal)
        resting = _resolve_pressure(_force_at_rest(chain), face.normal) if single else Pressure(starting.normal, 0.0)
        made.append(
            HingeForces(
                hinge=f"{hinge_name}{mark}",
                branch="positive" if positive else "negative",
                single=single,
                horizontal=force[0],
                vertical=force[1],
                face=face.normal,
                found=face.on_geometry,
                starting=starting,
                resting=resting,
                acceleration=found.multiplier * g,
                friction=face.friction,
                remedy=face.remedy,
                held=is_top_support(chain, number),
            )
        )
    return made


def _force_on_pressing_block(chain: Chain, found: IncipientMotion, number: int) -> Vector:
    """Return the force (x, z) on the block that presses at a hinge [N].

    At the top of a wall V is the load there, because the support itself has no vertical reaction.
    """
    x, z = found.forces[number].tolist()
    if is_top_support(chain, number):
        return (-x, min(sum(upward(load) for load in chain.loads if _rests_on_top(load, chain)), 0.0) + 0.0)
    return (x, z) if number < 2 else (-x, -z)


def _rests_on_top(load: Load, chain: Chain) -> bool:
    """Return whether a load rests on the top of a wall."""
    top, height = chain.hinges[2][1], chain.hinges[2][1] - chain.hinges[0][1]
    return load.block == 1 and isclose(load.at[1], top, rel_tol=0.0, abs_tol=ON_TOP * height)


def _resolve_pressure(force: Vector, normal: Vector) -> Pressure:
    """Resolve a force (x, z) on the block that presses [N] into parts normal to the faces and along them."""
    (x, z), (n_x, n_z) = force, normal
    return Pressure(x * n_x + z * n_z, x * n_z - z * n_x)


def _force_at_rest(chain: Chain) -> Point:
    """Return the force (x, z) of the hinge on a single block at rest [N]."""
    x, z = (-sum(force[i] for _, _, force, _ in _loads(chain)) + 0.0 for i in (0, 1))
    return (x, z)


def _moment_arms(at: Point) -> FloatArray:
    """Return the matrix from a force (x, z) at a point to (x, z, clockwise moment about the origin) [3, 2]."""
    return np.array([[1.0, 0.0], [0.0, 1.0], [at[1], -at[0]]])


def _loads(chain: Chain) -> list[tuple[int, Point, Point, float]]:
    """List all weights and loads: block, place, force at rest, and horizontal force for a multiplier of one [N]."""
    down = 0.0 if chain.level else -g
    acting = [(n, b.centroid, (0.0, down * b.mass), b.mass * g) for n, b in enumerate(chain.blocks)]
    for load in chain.loads:
        if isinstance(load, PointMass):
            acting.append((load.block, load.at, (0.0, down * load.mass * load.bearing), load.mass * g))
        elif isinstance(load, Force):
            acting.append((load.block, load.at, load.force, 0.0))
        else:
            acting.append((load.block, load.at, _pull(load, chain), 0.0))
    return acting


def _pull(tie: Tie, chain: Chain) -> Point:
    """Return the force of a tie at rest (x, z) [N]; zero if it slackens."""
    along, up = pull_at_rest(tie)
    leaving = trace_point(move(chain, np.zeros(1)), block=tie.block, at=tie.at)
    shortens = along * leaving.dx[0] + up * leaving.dz[0] > 0.0
    return (0.0, 0.0) if shortens and not (tie.both or stretches(tie)) else (along, up)
