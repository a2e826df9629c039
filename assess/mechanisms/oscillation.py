"""From a mechanism to its oscillator."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from assess.mechanisms.flexible_table import flexible_oscillator, same_chain
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.table import branch
from assess.oscillator import Branch, Oscillator

ROUNDING = 1e-12
"""Of the largest value of a column: what the two ways of a symmetric body may differ by."""
COLUMNS = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")
NUMBERS = ("restitution", "overturning", "critical", "unstable")


@lru_cache(maxsize=256)
def oscillator(mechanism: Mechanism) -> Oscillator:
    """The mechanism as the dynamics and the codes see it.

    Where both directions are the same but for ROUNDING they are one branch, so that what is asked of both, or of both
    polarities of a motion, is worked out once, and no answer hangs on the last digits of a mesh.
    """
    made = flexible_oscillator(mechanism) if mechanism.flexible else _rigid(mechanism)
    if made.negative is None or not _alike(made.positive, made.negative):
        return made
    return replace(made, negative=made.positive)


def _rigid(mechanism: Mechanism) -> Oscillator:
    first, second = mechanism.restitution
    chain, back = mechanism.positive, mechanism.negative
    positive = branch(chain, restitution=first, name=mechanism.name)
    if back is None:
        return Oscillator(positive, None, chain.mass)
    same = same_chain(chain, back) and first == second
    return Oscillator(
        positive=positive,
        negative=positive if same else branch(back, restitution=second, name=mechanism.name),
        mass=chain.mass,
    )


def _alike(one: Branch, other: Branch) -> bool:
    """Whether two branches are the same but for ROUNDING."""
    shape = [(branch.rotation.size, branch.overturning_flexible is None) for branch in (one, other)]
    pairs = [(getattr(one, name), getattr(other, name)) for name in (*NUMBERS, *COLUMNS)]
    return shape[0] == shape[1] and all(np.abs(a - b).max() <= ROUNDING * np.abs(a).max() for a, b in pairs)
