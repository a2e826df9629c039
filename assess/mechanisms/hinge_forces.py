"""The forces at the hinges of a mechanism at incipient motion, by equilibrium of its blocks."""

from __future__ import annotations

from math import isclose

from scipy.constants import g

from assess.hinge_forces import HingeForces, Pressure, Vector
from assess.loads.load import Load, upward
from assess.mechanisms.chain import Chain, hinge_names
from assess.mechanisms.face import Face
from assess.mechanisms.flexible import FlexibleChain
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.statics import IncipientMotion, force_at_rest, incipient_motion

ON_TOP = 1e-6  # of a wall's height: a load this near its top rests on it


def hinge_forces(mechanism: Mechanism) -> tuple[HingeForces, ...]:
    """Return the forces of every hinge of both branches; empty if the blocks have no faces (an equivalent block)."""
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    return tuple(
        forces
        for chain, faces, first in zip(chains, mechanism.faces, (True, False), strict=False)
        for forces in of_chain(chain_at_start(chain, name=mechanism.name), faces, positive=first)
    )


def chain_at_start(chain: Chain, *, name: str) -> Chain:
    """Return the chain about its hinges at incipient motion.

    Parameters
    ----------
    chain : of one branch
    name : of the mechanism, for errors

    Returns
    -------
    Chain
        Its hinges are, on joints, a_SF inside the edges, else at the edges.
    """
    if not any(chain.joints):
        return chain
    fixed = FlexibleChain(chain, name).fixed_hinge_chain
    return fixed if incipient_motion(fixed).multiplier > 0.0 else chain


def of_chain(chain: Chain, faces: tuple[Face, ...], *, positive: bool) -> list[HingeForces]:
    """Return the forces of the hinges of one branch in its own sign."""
    found, mark, single = incipient_motion(chain), "" if positive else "'", len(chain.blocks) == 1
    made = []
    for number, (letter, face) in enumerate(zip(hinge_names(chain), faces, strict=True)):
        force = force_on_pressing_block(chain, found, number)
        starting = pressure(force, face.normal)
        resting = pressure(force_at_rest(chain), face.normal) if single else Pressure(starting.normal, 0.0)
        made.append(
            HingeForces(
                hinge=f"{letter}{mark}",
                branch="positive" if positive else "negative",
                single=single,
                horizontal=force[0],
                vertical=force[1],
                face=face.normal,
                found=face.found,
                starting=starting,
                resting=resting,
                acceleration=found.multiplier * g,
                friction=face.friction,
                remedy=face.remedy,
                held=at_top(chain, number),
            )
        )
    return made


def force_on_pressing_block(chain: Chain, found: IncipientMotion, number: int) -> Vector:
    """Return the force (x, z) on the block that presses at a hinge [N].

    At the top of a wall V is the load there, because the support itself has no vertical reaction.
    """
    x, z = found.forces[number].tolist()
    if at_top(chain, number):
        return (-x, min(sum(upward(load) for load in chain.loads if on_top(load, chain)), 0.0) + 0.0)
    return (x, z) if number < 2 else (-x, -z)


def at_top(chain: Chain, number: int) -> bool:
    """Return whether a hinge is the support at the top of a wall.

    Parameters
    ----------
    chain : of two blocks, if it is a wall held at its top
    number : of the hinge, from 0 at the base
    """
    return len(chain.blocks) == number == 2


def on_top(load: Load, chain: Chain) -> bool:
    """Return whether a load rests on the top of a wall."""
    top, height = chain.hinges[2][1], chain.hinges[2][1] - chain.hinges[0][1]
    return load.block == 1 and isclose(load.at[1], top, rel_tol=0.0, abs_tol=ON_TOP * height)


def pressure(force: Vector, normal: Vector) -> Pressure:
    """Resolve a force (x, z) on the block that presses [N] into parts normal to the faces and along them."""
    (x, z), (n_x, n_z) = force, normal
    return Pressure(x * n_x + z * n_z, x * n_z - z * n_x)
