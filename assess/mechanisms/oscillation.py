"""From the chains of a mechanism to its oscillator."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assess.mechanisms.chain import ChainPair
from assess.mechanisms.flexible_table import flexible_oscillator, same_stages
from assess.mechanisms.stages import Stages, single_stage
from assess.mechanisms.table import staged_branch
from assess.oscillator import Branch, Oscillator

ROUNDING = 1e-12
"""Largest difference, relative to the largest value of a column, between the two ways of a symmetric body."""
COLUMNS = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")
NUMBERS = ("restitution", "overturning", "critical", "unstable")


def oscillator_at_start(pair: ChainPair) -> Oscillator:
    """Return the oscillator with every action that is there at rest."""
    return make_oscillator(pair, single_stage(pair.positive), single_stage(pair.negative or pair.positive))


def make_oscillator(pair: ChainPair, front: Stages, back: Stages) -> Oscillator:
    """Return the oscillator of a mechanism whose actions end.

    Directions that are the same but for ROUNDING share one branch, so that both directions and both polarities of a
    motion are computed once, and no result depends on the last digits of a mesh.

    Parameters
    ----------
    pair : the chains of both directions
    front, back : the stages of the positive and of the negative chain; back is ignored for one-sided rocking
    """
    made = flexible_oscillator(pair, front, back) if pair.has_joints else _rigid(pair, front, back)
    if made.negative is None or not _alike(made.positive, made.negative):
        return made
    return replace(made, negative=made.positive)


def _rigid(pair: ChainPair, front: Stages, back: Stages) -> Oscillator:
    """Return the oscillator of chains on rigid hinges."""
    first, second = pair.restitution
    positive = staged_branch(front, restitution=first, name=pair.name)
    if pair.negative is None:
        return Oscillator(positive, None, pair.positive.mass)
    same = same_stages(front, back) and first == second
    return Oscillator(
        positive=positive,
        negative=positive if same else staged_branch(back, restitution=second, name=pair.name),
        mass=pair.positive.mass,
    )


def _alike(one: Branch, other: Branch) -> bool:
    """Return whether two branches are the same but for ROUNDING."""
    shape = [(branch.rotation.size, branch.overturning_flexible is None) for branch in (one, other)]
    pairs = [(getattr(one, name), getattr(other, name)) for name in (*NUMBERS, *COLUMNS)]
    return shape[0] == shape[1] and all(np.abs(a - b).max() <= ROUNDING * np.abs(a).max() for a, b in pairs)
