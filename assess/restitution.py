"""What an impact leaves of the angular velocity: one function per published formula."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import Literal

from assess.errors import MechanismError
from assess.oscillator import SingleBlock

Rule = Literal["housner", "sorrentino", "momentum"]


@dataclass(frozen=True)
class Restitution:
    """A coefficient [-], at least 0, where it comes from, and a notice when the rule did not hold ("" otherwise)."""

    value: float
    source: str
    notice: str = ""


def housner(block: SingleBlock) -> float:
    """Two-sided rocking: angular momentum about the new hinge is kept (Housner 1963; thesis eq. 3.44)."""
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return 1 - 2 * M * R**2 / I_O * sin(alpha) ** 2


def sorrentino(block: SingleBlock) -> float:
    """One-sided rocking, signed: below zero the block rebounds (Sorrentino et al. 2011; thesis eq. 3.45)."""
    M, R, alpha, I_O = block.mass, block.radius, block.slenderness, block.inertia
    return housner(block) ** 2 * (1 - 2 * M * R**2 / I_O * cos(alpha) ** 2)


def momentum(ending: SingleBlock, starting: SingleBlock) -> float:
    """Two-sided rocking of a block whose two hinges differ: angular momentum about the new hinge is kept.

    With J about the centroid and r from each hinge to the centroid: (J + M r1.r2) / I_2; equal to Housner's for a
    symmetric block.
    """
    M = ending.mass
    J = ending.inertia - M * ending.radius**2
    arm = ending.radius * starting.radius * cos(ending.slenderness + starting.slenderness)
    return (J + M * arm) / starting.inertia


def two_sided(rule: Rule, *, ending: SingleBlock, starting: SingleBlock, name: str) -> Restitution:
    """The coefficient of an impact that ends one branch of `name` and starts the other.

    Raises MechanismError where the rule gives no rocking (a negative coefficient) or is not for two-sided rocking.
    """
    if rule == "sorrentino":
        raise MechanismError(
            f'mechanism "{name}": restitution "sorrentino" is for sides = "one"; use "housner" or a number'
        )
    value = housner(ending) if rule == "housner" else momentum(ending, starting)
    source = "Housner 1963, thesis eq. 3.44" if rule == "housner" else "angular momentum about the new hinge"
    if value**2 * starting.inertia > ending.inertia * (1 + 1e-9):
        raise MechanismError(
            f'mechanism "{name}": restitution by {source} is {value:.3g}, which would add energy at the impact, '
            'for the two hinges differ; use "momentum" or a number'
        )
    if value < 0:
        raise MechanismError(
            f'mechanism "{name}": restitution by {source} is {value:.3g}: so stocky a block does not rock on; '
            "give restitution as a number in [0, 1]"
        )
    return Restitution(value, source)


def one_sided(rule: Rule, *, block: SingleBlock, name: str) -> Restitution:
    """The rebound of a one-sided block; a formula that gives no rebound counts as 0, with a notice."""
    if rule != "sorrentino":
        raise MechanismError(
            f'mechanism "{name}": restitution "{rule}" is for sides = "two"; use "sorrentino" or a number'
        )
    signed = sorrentino(block)
    source = f"Sorrentino et al. 2011, thesis eq. 3.45: {signed:+.3f}"
    if signed >= 0:
        return Restitution(0.0, source, f"{source} is not negative: there is no rebound, restitution 0 is used")
    return Restitution(-signed, source)
