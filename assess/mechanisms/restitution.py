"""What an impact leaves of a block's angular velocity: one function per published formula."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

from assess.oscillator import SingleBlock


@dataclass(frozen=True)
class Restitution:
    """A coefficient [-], at least 0, where it comes from, and a notice when the rule did not hold ("" otherwise).

    stopped : the negative value that the rule gave, where the impact brings the mechanism to rest; None elsewhere
    range : what a value so uncertain is multiplied by in histories, of which the worst counts
    """

    value: float
    source: str
    notice: str = ""
    stopped: float | None = None
    range: tuple[float, ...] = (1.0,)


def housner(block: SingleBlock) -> float:
    """Two-sided rocking: angular momentum about the new hinge is kept (Housner 1963; thesis eq. 3.44)."""
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return 1 - 2 * M * R**2 / I_O * sin(alpha) ** 2


def sorrentino(block: SingleBlock) -> float:
    """One-sided rocking, signed: below zero the block rebounds (Sorrentino et al. 2011; thesis eq. 3.45)."""
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return housner(block) ** 2 * (1 - 2 * M * R**2 / I_O * cos(alpha) ** 2)
