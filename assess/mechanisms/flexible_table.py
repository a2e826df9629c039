"""From a mechanism on flexible joints to its oscillator: equilibrium, and a table for each branch counted from there.

A joint in full contact deforms under any rotation, so the restoring moment of a symmetric mechanism begins at zero and
passes through rest smoothly. Under an eccentric load the mechanism rests at a rotation phi_e of one of its branches;
the branch on the other side then begins with the way back from phi_e to zero, seen in its own sign:

    other branch:  rotation 0 ... phi_e   the first chain from phi_e back to 0, moments and lifts with the other sign
                   from phi_e on          the second chain from 0
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assess.errors import MechanismError
from assess.mechanisms.chain import Chain, ChainPair, mirror_point
from assess.mechanisms.flexible import FlexibleChain
from assess.mechanisms.joint import Joint
from assess.mechanisms.side import FINE, ZERO, Side, columns_of, make_side
from assess.mechanisms.stages import Moments, Stages, signature, single_stage, zero_moments
from assess.oscillator import Branch, Oscillator


def flexible_oscillator(pair: ChainPair, front: Stages, back: Stages) -> Oscillator:
    """Return the oscillator of chains on their joints, with the stages of each.

    Raises MechanismError if the mechanism finds no stable rest, or never overturns.
    """
    name, (first, second) = pair.name, pair.restitution
    positive = make_side(front, name=name, restitution=first)
    if pair.negative is None:
        return Oscillator(branch_from_rest(positive, None), None, pair.positive.mass, equilibrium=positive.lean)
    alike = same_stages(front, back) and first == second
    negative = positive if alike else make_side(back, name=name, restitution=second)
    if not share_rest(pair.positive, pair.negative) or front[0].absent != back[0].absent:
        return Oscillator(
            positive=branch_from_rest(positive, None),
            negative=branch_from_rest(negative, None),
            mass=pair.positive.mass,
            equilibrium=positive.lean,
            equilibrium_negative=negative.lean,
        )
    if positive.leans and negative.leans:
        raise MechanismError(
            f'mechanism "{name}": it is pushed off its rest both ways, by {-positive.work.restoring[0]:.4g} and '
            f"{-negative.work.restoring[0]:.4g} N m: a hinge inside the edge of its contact does that, as pressure is "
            "counted from the hinge on; put hinges on the edges, give the shape between them, or check loads"
        )
    return Oscillator(
        positive=branch_from_rest(positive, negative),
        negative=branch_from_rest(negative, positive),
        mass=pair.positive.mass,
        equilibrium=positive.lean - negative.lean,
        equilibrium_negative=negative.lean - positive.lean,
    )


def share_rest(positive: Chain, negative: Chain) -> bool:
    """Return whether both directions use the same joints, and so share one equilibrium.

    An arch opens other joints each way: each direction then counts from the equilibrium of its own joints.
    """
    if positive.parts:
        return positive.parts == tuple(
            (replace(block, centroid=mirror_point(block.centroid)), number) for block, number in negative.parts
        )
    return True


def flexible_moments(chain: Chain, *, name: str) -> Moments:
    """Return the moments of the actions on a chain, each as its joints move."""
    flexible = FlexibleChain(chain, name)
    scan = np.unique(make_side(single_stage(chain), name=name, restitution=1.0).rotation)
    return Moments(scan, lambda rotation: flexible.moments(rotation) + zero_moments(chain))


def branch_from_rest(side: Side, other: Side | None) -> Branch:
    """Return the branch of one side, counted from the equilibrium of the mechanism.

    Raises MechanismError if the moment never falls to zero.
    """
    shift = side.lean
    overturning = side.fall(lambda work: work.restoring)
    critical = side.fall(lambda work: work.weight) if side.work.moment.any() else overturning
    if overturning is None or critical is None:
        raise MechanismError(
            f'mechanism "{side.flexible.name}": on its joints the restoring moment does not fall to zero before '
            f"{side.end:.3g} rad; check hinges, ties and joints"
        )
    columns = side.columns()
    if shift:
        columns = columns[:, columns[0] > (1.0 + 0.5 * FINE) * shift]
        stand = np.array([shift])
        work = side.work_at(stand, np.array([side.chain_at(shift, then="right")]))
        columns = np.concatenate([columns_of(stand, work), columns], axis=1)
    elif other is not None and other.lean:
        shift = -other.lean
        back = other.columns(back_from=other.lean)
        back[0] += shift
        columns = np.concatenate([back, columns], axis=1)
    columns[0] -= shift
    if abs(columns[2, 0]) <= ZERO * side.rigid.restoring[0]:
        columns[2, 0] = 0.0
    columns.flags.writeable = False
    phi, inertia, restoring, excitation, participation, lift = columns
    return Branch(
        phi,
        inertia,
        restoring,
        excitation,
        participation,
        lift,
        restitution=side.rigid.restitution,
        overturning=side.rigid.overturning,
        critical=critical - shift,
        overturning_flexible=overturning - shift,
    )


def same_stages(one: Stages, other: Stages) -> bool:
    """Return whether two sides, each in its own sign, are equal to the last digit."""
    return same_chain(one[0].chain, other[0].chain) and signature(one) == signature(other)


def same_chain(one: Chain, other: Chain) -> bool:
    """Return whether two chains, each in its own sign, are equal to the last digit."""
    return (one.blocks, one.hinges, one.loads) == (other.blocks, other.hinges, other.loads) and (
        [_numbers(joint) for joint in one.joints] == [_numbers(joint) for joint in other.joints]
    )


def _numbers(joint: Joint | None) -> tuple[object, ...] | None:
    """Return the parts of a joint as values that compare."""
    if joint is None:
        return None
    section = joint.section
    return (joint.inward, joint.law, joint.model, section.depth, section.pieces.tolist(), section.discs.tolist())
