"""Directions towards which a mechanism may topple, by their angles, and how it resists towards each."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, degrees, radians, sin

from assess.short_repr import ShortRepr

Direction = tuple[float, float, float]
"""A horizontal vector."""


@dataclass(frozen=True, repr=False)
class DirectionSweep(ShortRepr):
    """The resistance to positive rotation towards each direction, where the weakest was sought all around.

    angle_deg [n]: from +x towards +y, rising; uplift_multiplier [n]: at rest; weakest_deg: the angle chosen, of several
    with the least multiplier the smallest; variation: 1 - least / largest multiplier, 0 for a body that is equal from
    all sides; flat_deg: part of the circle within one percent of the least.
    """

    angle_deg: tuple[float, ...]
    uplift_multiplier: tuple[float, ...]
    p_eq_per_s: tuple[float, ...]
    overturning_rad: tuple[float, ...]
    weakest_deg: float
    variation: float
    flat_deg: float


@dataclass(frozen=True, repr=False)
class DirectionCandidate(ShortRepr):
    """A direction towards which a mechanism may topple.

    angle_deg: from +x towards +y; uplift_multiplier: at rest, None where it cannot rock that way; d0_m: displacement of
    the control point at overturning, None also where the multiplier alone rules it out; touching: the bodies that stop
    it.
    """

    angle_deg: float
    uplift_multiplier: float | None
    d0_m: float | None
    touching: tuple[str, ...]

    @property
    def direction(self) -> Direction:
        """The direction as a unit vector."""
        return direction_at(self.angle_deg)


def direction_angle(direction: Direction) -> float:
    """Return the angle of a horizontal vector from +x towards +y, from 0 to 360 [deg]."""
    return round(degrees(atan2(direction[1], direction[0])), 12) % 360.0


def direction_at(angle: float) -> Direction:
    """Return the horizontal unit vector at `angle` [deg] from +x towards +y."""
    return (round(cos(radians(angle)), 15), round(sin(radians(angle)), 15), 0.0)
