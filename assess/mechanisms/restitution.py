"""Coefficients of restitution of a block: one function for each published formula."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, sin

from assess.messages.message import Message, Term
from assess.oscillator import SingleBlock


@dataclass(frozen=True)
class Restitution:
    """A coefficient [-], at least 0, its source, and a warning if the rule does not apply (else None).

    source : the parts of a phrase: the rule, and what other rules would give
    stopped : the negative value by the rule, if the impact brings the mechanism to rest; else None
    range : factors on an uncertain value in histories, of which the worst counts
    """

    value: float
    source: tuple[Term | Message, ...]
    notice: Message | None = None
    stopped: float | None = None
    range: tuple[float, ...] = (1.0,)


def source_text(source: Iterable[Term | Message]) -> str:
    """Return the parts of a source in one English phrase."""
    return "; ".join(map(str, source))


def housner(block: SingleBlock) -> float:
    """Return the coefficient of two-sided rocking: angular momentum about the new hinge is conserved.

    Housner 1963; thesis eq. 3.44.
    """
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return 1 - 2 * M * R**2 / I_O * sin(alpha) ** 2


def sorrentino(block: SingleBlock) -> float:
    """Return the signed coefficient of one-sided rocking: below zero the block rebounds.

    Sorrentino et al. 2011; thesis eq. 3.45.
    """
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return housner(block) ** 2 * (1 - 2 * M * R**2 / I_O * cos(alpha) ** 2)
