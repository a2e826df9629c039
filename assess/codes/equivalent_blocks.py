"""Mechanisms on flexible joints as the thesis put them into rigid formulas (8.4, Table 8.7)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from assess.oscillator import Branch, Oscillator, block_at, plain_branch


def to_equivalent_blocks(oscillator: Oscillator, rotation_of: Callable[[Branch], float]) -> Oscillator:
    """Each branch as the plain block that it is like at a rotation [rad]; rigid ones as they are.

    R, alpha and p at that rotation stand for those at rest, as the resultant of the joint has moved inward (6.50-6.52).
    """
    if all(branch.overturning_flexible is None for branch in oscillator.branches):
        return oscillator
    found = [_plain(branch, rotation_of(branch), mass=oscillator.mass) for branch in oscillator.branches]
    return replace(oscillator, positive=found[0], negative=found[1] if len(found) > 1 else None)


def _plain(branch: Branch, rotation: float, *, mass: float) -> Branch:
    block = block_at(branch, rotation, mass=mass)
    like = plain_branch(block, restitution=branch.restitution)
    return replace(like, overturning=branch.overturning, overturning_flexible=block.slenderness)
