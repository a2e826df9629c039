"""Overburdens that act through the joint at the top of a wall of two blocks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import dist

from assess.loads.definitions import Through
from assess.loads.load import Load
from assess.loads.overburden import UPPER
from assess.mechanisms.chain import Chain
from assess.mechanisms.joint import Joint
from assess.mechanisms.jointed_chain import top_loads

ON_MIDDLE = 1e-3  # of the depth of a joint: a load this near its middle acts through it unless the load says otherwise


def through_joint(chain: Chain, joint: Joint | None, through: Mapping[str, Through]) -> Chain:
    """Move the loads that act through the joint at the top of a wall to its hinge.

    On a joint their resultant is still in the middle at rest, and moves to the edge as the wall rotates; on a rigid
    top they press at the hinge of each direction.

    Parameters
    ----------
    chain : of the wall
    joint : at its top, None if rigid
    through : what each load says, by its name
    """
    if len(chain.blocks) != 2:
        return chain
    loads = [
        replace(load, at=chain.hinges[2]) if comes_through(load, chain, joint, through.get(load.name)) else load
        for load in chain.loads
    ]
    return replace(chain, loads=tuple(loads))


def comes_through(load: Load, chain: Chain, joint: Joint | None, through: Through) -> bool:
    """Return whether a load acts through the joint at the top: as it says, else if it is on the middle."""
    if through is not None:
        return through == "joint"
    if joint is None or load.block != UPPER:
        return False
    inside = joint.section.centroid
    middle = tuple(at + inside * way for at, way in zip(chain.hinges[2], joint.inward, strict=True))
    return dist(load.at, middle) <= ON_MIDDLE * joint.section.depth


def under_loads(
    chain: Chain, joints: tuple[Joint | None, ...], through: Mapping[str, Through]
) -> tuple[Joint | None, ...]:
    """Return the joints of a chain, without the one at the top of a wall if all loads at its hinge are fixed there.

    Parameters
    ----------
    chain : of the wall
    joints : under its hinges
    through : what each load says, by its name
    """
    if len(chain.blocks) != 2:
        return joints
    at_hinge = top_loads(chain)
    fixed = bool(at_hinge) and all(through.get(load.name) == "fixed" for load in at_hinge)
    return (*joints[:2], None) if fixed else joints
