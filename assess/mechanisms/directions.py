"""The resistance of a mechanism against rotation towards each horizontal direction."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, degrees, radians, sin

import numpy as np

from assess.short_repr import ShortRepr

FLAT = 1.01  # multipliers up to this many times the least are nearly as weak
STEPS = 3600  # of the circle on which they are counted

Vector = tuple[float, float, float]


@dataclass(frozen=True, repr=False)
class Directions(ShortRepr):
    """The resistance against rotation towards each direction of a circle.

    Attributes
    ----------
    angle : of the direction from +x towards +y, rising [n] [deg]
    multiplier : lambda at rest of the rotation towards it [n] [-]
    p : p_eq [n] [1/s]; overturning : phi_ov [n] [rad]
    weakest : the angle of the least multiplier, the smallest of equals [deg]
    """

    angle: tuple[float, ...]
    multiplier: tuple[float, ...]
    p: tuple[float, ...]
    overturning: tuple[float, ...]
    weakest: float

    @property
    def variation(self) -> float:
        """1 - least / largest multiplier [-]: 0 for a body that is equal from all sides."""
        return 1.0 - min(self.multiplier) / max(self.multiplier)

    @property
    def flat(self) -> float:
        """Range of angles within one percent of the least multiplier, interpolated linearly [deg]."""
        circle = np.arange(STEPS) * (360.0 / STEPS)
        around = np.interp(circle, self.angle, self.multiplier, period=360.0)
        return float(np.count_nonzero(around <= FLAT * min(self.multiplier)) * (360.0 / STEPS))


@dataclass(frozen=True)
class Candidate:
    """A direction towards which a mechanism may topple.

    Attributes
    ----------
    angle : from +x towards +y [deg]
    multiplier : lambda at rest [-]; displacement : d0* of the control point where it overturns [m]
        None if it cannot rock this way; d0* is None also if the multiplier alone rules it out
    touching : the bodies that stop it
    why : the reason why it cannot rock this way, empty if it can
    """

    angle: float
    multiplier: float | None = None
    displacement: float | None = None
    touching: tuple[str, ...] = ()
    why: str = ""

    @property
    def way(self) -> Vector:
        """The direction as a unit vector."""
        return towards(self.angle)


def angle_of(direction: Vector) -> float:
    """Return the angle of a horizontal vector from +x towards +y, from 0 to 360 [deg]."""
    return round(degrees(atan2(direction[1], direction[0])), 12) % 360.0


def towards(angle: float) -> Vector:
    """Return the horizontal unit vector at `angle` [deg] from +x towards +y."""
    return (round(cos(radians(angle)), 15), round(sin(radians(angle)), 15), 0.0)
