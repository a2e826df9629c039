"""From a mechanism to its oscillator."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from assess.mechanisms.flexible_table import flexible_oscillator, same_stages
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.stages import Stages, single_stage
from assess.mechanisms.table import staged_branch
from assess.oscillator import Branch, Oscillator

ROUNDING = 1e-12
"""Of the largest value of a column: what the two ways of a symmetric body may differ by."""
COLUMNS = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")
NUMBERS = ("restitution", "overturning", "critical", "unstable")


@lru_cache(maxsize=256)
def oscillator(mechanism: Mechanism) -> Oscillator:
    """The mechanism as the dynamics and the codes see it, with every action that is there at rest.

    Where both directions are the same but for ROUNDING they are one branch, so that what is asked of both, or of both
    polarities of a motion, is worked out once, and no answer hangs on the last digits of a mesh.
    """
    return make_oscillator(
        mechanism, single_stage(mechanism.positive), single_stage(mechanism.negative or mechanism.positive)
    )


def make_oscillator(mechanism: Mechanism, front: Stages, back: Stages) -> Oscillator:
    """The same as its actions come to an end, with the stages of its chains; of one chain only the first count."""
    made = flexible_oscillator(mechanism, front, back) if mechanism.flexible else _rigid(mechanism, front, back)
    if made.negative is None or not _alike(made.positive, made.negative):
        return made
    return replace(made, negative=made.positive)


def _rigid(mechanism: Mechanism, front: Stages, back: Stages) -> Oscillator:
    first, second = mechanism.restitution
    positive = staged_branch(front, restitution=first, name=mechanism.name)
    if mechanism.negative is None:
        return Oscillator(positive, None, mechanism.positive.mass)
    same = same_stages(front, back) and first == second
    return Oscillator(
        positive=positive,
        negative=positive if same else staged_branch(back, restitution=second, name=mechanism.name),
        mass=mechanism.positive.mass,
    )


def _alike(one: Branch, other: Branch) -> bool:
    """Whether two branches are the same but for ROUNDING."""
    shape = [(branch.rotation.size, branch.overturning_flexible is None) for branch in (one, other)]
    pairs = [(getattr(one, name), getattr(other, name)) for name in (*NUMBERS, *COLUMNS)]
    return shape[0] == shape[1] and all(np.abs(a - b).max() <= ROUNDING * np.abs(a).max() for a, b in pairs)
