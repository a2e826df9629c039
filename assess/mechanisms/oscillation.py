"""From a mechanism to its oscillator."""

from __future__ import annotations

from functools import lru_cache

from assess.mechanisms.flexible_table import flexible_oscillator
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.table import branch
from assess.oscillator import Oscillator


@lru_cache(maxsize=256)
def oscillator(mechanism: Mechanism) -> Oscillator:
    """The mechanism as the dynamics and the codes see it."""
    if mechanism.flexible:
        return flexible_oscillator(mechanism)
    first, second = mechanism.restitution
    negative = mechanism.negative
    return Oscillator(
        positive=branch(mechanism.positive, restitution=first, name=mechanism.name),
        negative=None if negative is None else branch(negative, restitution=second, name=mechanism.name),
        mass=mechanism.positive.mass,
    )
