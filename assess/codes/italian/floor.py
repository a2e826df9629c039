"""The floor of a mechanism above the ground: what the clauses take of the building."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.check import InputAt, Outcome
from assess.codes.context import Context
from spectra.circolare2019 import first_mode_factor


@dataclass(frozen=True)
class Floor:
    """The building as the clauses see it: psi = Z/H, gamma = 3N/(2N+1), T1 [s] and xi1 [-] of the first mode."""

    psi: float
    gamma: float
    T1: float
    damping: float


@dataclass(frozen=True)
class Demands:
    """What the motions of ground and floor demand of a mechanism, in one unit; floor: 0 at the ground."""

    ground: float
    floor: float

    def scale(self, factor: float) -> Demands:
        """Return both multiplied by a factor."""
        return Demands(self.ground * factor, self.floor * factor)

    @property
    def largest(self) -> float:
        """The governing one: both must be met."""
        return max(self.ground, self.floor)

    @property
    def at(self) -> InputAt:
        """Where the governing one acts."""
        return "mechanism base" if self.floor > self.ground else "ground"


def floor_of(context: Context) -> Floor | None:
    """Return psi, gamma and T1 of a mechanism above the ground; None at the ground, or where the building is not known.

    Z is the height of what joins the mechanism to the rest of the building: of its base, or of a wall that spans the
    mean of base and top. A mechanism on the ground is checked at the ground alone, a wall that spans included.
    Source: Circolare 617/2009, C8A.4.2.3; 7/2019, C7.2.10.
    """
    building = context.building
    if not context.above_ground or building is None or building.storeys is None:
        return None
    gamma = first_mode_factor(building.storeys)
    return Floor(context.support_height / building.height, gamma, building.period, building.damping)


def outcome_of(ratio: float) -> Outcome:
    """Return pass or fail of a ratio of demand to capacity."""
    return Outcome.FAIL if ratio > 1.0 else Outcome.PASS
