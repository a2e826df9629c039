"""Mechanisms on flexible joints in the formulas of rigid blocks, as in the thesis (8.4, Table 8.7)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from assess.oscillator import Branch, Oscillator, block_at, plain_branch


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
    found = [_plain(branch, rotation_of(branch), mass=oscillator.mass) for branch in oscillator.branches]
    return replace(oscillator, positive=found[0], negative=found[1] if len(found) > 1 else None)


def _plain(branch: Branch, rotation: float, *, mass: float) -> Branch:
    block = block_at(branch, rotation, mass=mass)
    like = plain_branch(block, restitution=branch.restitution)
    return replace(like, overturning=branch.overturning, overturning_flexible=block.slenderness)
