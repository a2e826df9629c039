"""From a mechanism to its oscillator."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assess.mechanisms.flexible_table import flexible_oscillator
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.table import branch
from assess.oscillator import Branch, Oscillator

COLUMNS = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")
NUMBERS = ("restitution", "overturning", "critical", "unstable")


def oscillator(mechanism: Mechanism) -> Oscillator:
    """The mechanism as the dynamics and the codes see it.

    Where both directions are the same they are one branch, so that what is asked of both, or of both polarities of a
    motion, is worked out once.
    """
    made = flexible_oscillator(mechanism) if mechanism.flexible else _rigid(mechanism)
    if made.negative is None or not _alike(made.positive, made.negative):
        return made
    return replace(made, negative=made.positive)


def _rigid(mechanism: Mechanism) -> Oscillator:
    first, second = mechanism.restitution
    negative = mechanism.negative
    return Oscillator(
        positive=branch(mechanism.positive, restitution=first, name=mechanism.name),
        negative=None if negative is None else branch(negative, restitution=second, name=mechanism.name),
        mass=mechanism.positive.mass,
    )


def _alike(one: Branch, other: Branch) -> bool:
    """Whether two branches are the same to the last digit."""
    pairs = [(getattr(one, name), getattr(other, name)) for name in (*NUMBERS, *COLUMNS)]
    flexible = (one.overturning_flexible is None, other.overturning_flexible is None)
    return one is other or (flexible[0] == flexible[1] and all(np.array_equal(*pair) for pair in pairs))
