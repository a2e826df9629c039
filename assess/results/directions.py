"""The directions in which a mechanism may topple."""

from __future__ import annotations

from dataclasses import dataclass

from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class DirectionSweep(ShortRepr):
    """The resistance to rotation towards each direction, where the weakest was sought.

    angle_deg [n]: from +x towards +y, rising; uplift_multiplier [n]: at rest; weakest_deg: the angle chosen, of several
    with the least multiplier the smallest; variation: 1 - least / largest multiplier; flat_deg: part of the circle
    within one percent of the least.
    """

    angle_deg: Floats
    uplift_multiplier: Floats
    p_eq_per_s: Floats
    overturning_rad: Floats
    weakest_deg: float
    variation: float
    flat_deg: float


@dataclass(frozen=True, repr=False)
class DirectionCandidate(ShortRepr):
    """A direction towards which a mechanism may topple.

    angle_deg: from +x towards +y; uplift_multiplier: at rest, None where it cannot rock that way; d0_m: displacement of
    the control point at overturning, of the weakest only; touching: the bodies that stop it.
    """

    angle_deg: float
    uplift_multiplier: float | None
    d0_m: float | None
    touching: tuple[str, ...]
