"""The forces at the hinges of a mechanism when it starts to rock, and how much friction they need.

H along the branch's own direction and V up act on the block that presses at a hinge; with n square to the faces there,

    N = H n_x + V n_z        T = H n_z - V n_x        friction needed: |T| / N

Below the acceleration at which the mechanism starts to rock, N and T of a single block are linear in the acceleration.
A chain of blocks is then statically indeterminate: N is taken as when it starts to rock, and T as growing in proportion
to the acceleration.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.messages.message import Message, Term

Vector = tuple[float, float]


@dataclass(frozen=True)
class Pressure:
    """The force on the block that presses, square to the faces (compression > 0) and along them [N]."""

    normal: float
    shear: float


@dataclass(frozen=True)
class HingeForces:
    """One hinge of one branch when the mechanism starts to rock.

    hinge : its letter, with a prime on the negative branch; single : whether it is that of a single block
    horizontal, vertical : force on the block that presses, along the branch's own direction and up [N]
    face : unit vector (x, z) square to the faces, to the block that presses; found : on the geometry, else taken level
    starting, resting : square to the faces and along them, when it starts to rock and without any acceleration
    acceleration : of the ground at which it starts to rock [m/s2]
    friction : coefficient [-], None where it is not known; remedy : the input that would give it
    held : whether a support holds it besides friction, as it does the top of a wall
    """

    hinge: str
    branch: Literal["positive", "negative"]
    single: bool
    horizontal: float
    vertical: float
    face: Vector
    found: bool
    starting: Pressure
    resting: Pressure
    acceleration: float
    friction: float | None
    remedy: Term | Message
    held: bool

    @property
    def required_friction(self) -> float | None:
        """The coefficient of friction below which it slides before it rocks [-]; None where it lifts."""
        return required_friction(self.starting)

    def pressure_at(self, acceleration: float) -> Pressure:
        """Return the force at an acceleration of the ground [m/s2]; beyond incipient motion it does not change."""
        share = min(acceleration / self.acceleration, 1.0)
        low, high = self.resting, self.starting
        return Pressure(
            low.normal + share * (high.normal - low.normal),
            low.shear + share * (high.shear - low.shear),
        )

    def mobilised_friction(self, acceleration: float) -> float | None:
        """Return the friction coefficient needed up to an acceleration of the ground [m/s2]; None where it lifts.

        |T| / N of two linear functions is largest at an end.
        """
        ends = [required_friction(self.resting), required_friction(self.pressure_at(acceleration))]
        known = [each for each in ends if each is not None]
        return max(known) if len(known) == len(ends) else None

    @property
    def sliding_acceleration(self) -> float | None:
        """The ground acceleration at which |T| = mu N [m/s2]; None where that is not before it starts to rock."""
        if self.friction is None:
            return None
        reached = [share for side in (1.0, -1.0) if (share := self._share(side, self.friction)) is not None]
        return min(reached) * self.acceleration if reached else None

    def _share(self, side: float, mu: float) -> float | None:
        """Return the share of the acceleration at which `side` T = mu N; 0 if it slides at rest, None if never."""
        first, last = (side * each.shear - mu * each.normal for each in (self.resting, self.starting))
        if first > 0.0:
            return 0.0
        return -first / (last - first) if last > 0.0 else None


def required_friction(pressure: Pressure) -> float | None:
    """Return |T| / N [-]; None where nothing presses."""
    return abs(pressure.shear) / pressure.normal if pressure.normal > 0.0 else None
