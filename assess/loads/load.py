"""What a block carries or is pulled by besides itself: point masses, given forces, ties, in the plane of motion.

Places and forces are (distance along the direction, elevation); a load is fixed to its block. `found` says in parts how
a load was found; it is empty where the user gave its numbers.

A force or tie may end before the mechanism collapses. `until` says when: "collapse" where it is still there then, or
the displacement of its point [m] at which it ends; None where it is not shown to last.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot
from typing import Literal

import numpy as np
from scipy.constants import g

from assess.messages.message import Message, Term

Point = tuple[float, float]
Until = float | Literal["collapse"] | None
SourceParts = tuple[Term | Message, ...]


def source_phrase(found: SourceParts) -> str:
    """Return the parts of a source in one English phrase."""
    return "; ".join(map(str, found))


@dataclass(frozen=True)
class PointMass:
    """A floor, roof or wall that moves with the block at one point.

    mass [kg]; bearing: the block carries its weight, and it shares all its motion; not bearing: its weight is carried
    elsewhere, and only its horizontal inertia acts on the block (thesis 3.2.2, M_i and M_j).
    seat : horizontal displacement of its point at which it falls off the block [m]; None where it is not given.
    """

    name: str
    mass: float
    at: Point
    bearing: bool
    block: int = 0
    found: SourceParts = ()
    seat: float | None = None

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.found)


@dataclass(frozen=True)
class Force:
    """A dead force (x, z) [N] of constant size and direction: the thrust of a vault or roof.

    evidence : where it is shown that it lasts as `until` says; empty where it is not.
    """

    name: str
    force: Point
    at: Point
    block: int = 0
    found: SourceParts = ()
    until: Until = None
    evidence: str = ""

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.found)

    @property
    def missing(self) -> tuple[str, ...]:
        """The keys of the project file that are missing before it counts as lasting to collapse."""
        return _missing_keys({"until": self.until, "source": self.evidence})


@dataclass(frozen=True)
class Tie:
    """A tie of constant pretension `pull` [N] along `direction` (a unit vector), or always towards `anchor`.

    It is slack on the branch where it shortens, unless `both`.
    strength : least of bar, plate, masonry and far wall [N], above which it never pulls
    length, fracture_strain : of the bar [m], [-]; it ends where it has lengthened by more than their product
    evidence : where it is shown that it lasts as `until` says; empty where it is not
    """

    name: str
    pull: float
    at: Point
    direction: Point | None = None
    anchor: Point | None = None
    both: bool = False
    block: int = 0
    found: SourceParts = ()
    until: Until = None
    strength: float | None = None
    length: float | None = None
    fracture_strain: float | None = None
    evidence: str = ""

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.found)

    @property
    def tension(self) -> float:
        """The force with which it pulls [N]: its pretension, and never more than its strength."""
        return self.pull if self.strength is None else min(self.pull, self.strength)

    @property
    def elongation(self) -> float | None:
        """The elongation at which it breaks [m]; None if that is not known."""
        known = self.length is not None and self.fracture_strain is not None
        return (self.length or 0.0) * (self.fracture_strain or 0.0) if known else None

    @property
    def missing(self) -> tuple[str, ...]:
        """The keys of the project file that are missing before it counts as lasting to collapse."""
        shown = {key: getattr(self, key) for key in ("until", "strength", "length", "fracture_strain")}
        return _missing_keys({**shown, "source": self.evidence})


Action = Force | Tie
Load = PointMass | Force | Tie


def pull_at_rest(tie: Tie) -> Point:
    """Return the force (x, z) [N] of a taut tie at rest."""
    if tie.anchor is None:
        along, up = tie.direction or (0.0, 0.0)
        return (tie.tension * along, tie.tension * up)
    to_x, to_z = tie.anchor[0] - tie.at[0], tie.anchor[1] - tie.at[1]
    length = hypot(to_x, to_z)
    return (tie.tension * to_x / length, tie.tension * to_z / length)


def lasts(action: Action) -> bool:
    """Return whether it is shown to last to collapse (NTC 2018, C8.7.1.2.1.6), but for a tie's fracture strain."""
    return action.until == "collapse" and not action.missing


def upward(load: Load) -> float:
    """Return the vertical force of a load at rest, up [N]."""
    if isinstance(load, PointMass):
        return -g * load.mass * load.bearing
    return (load.force if isinstance(load, Force) else pull_at_rest(load))[1]


def mirror_load(load: Load) -> Load:
    """Return the load as the negative branch sees it."""
    at = _mirror_vector(load.at)
    if isinstance(load, PointMass):
        return replace(load, at=at)
    if isinstance(load, Force):
        return replace(load, at=at, force=_mirror_vector(load.force))
    return replace(
        load,
        at=at,
        direction=None if load.direction is None else _mirror_vector(load.direction),
        anchor=None if load.anchor is None else _mirror_vector(load.anchor),
    )


def _missing_keys(shown: dict[str, object]) -> tuple[str, ...]:
    return tuple(key for key, value in shown.items() if value is None or value == "")


def _mirror_vector(vector: Point) -> Point:
    return (-vector[0], vector[1])


def point_in_plane(at: Sequence[float], direction: Sequence[float]) -> Point:
    """Return a place in the plane of motion: (distance along the direction from the origin, elevation) [m].

    Parameters
    ----------
    at : [x, y, z], or two numbers that are in the plane already [m]
    direction : of the motion, horizontal [3]
    """
    if len(at) == 2:
        return (at[0], at[1])
    along = np.asarray(direction) / np.linalg.norm(direction)
    return (float(np.asarray(at) @ along), at[2])


def unit_in_plane(vector: Sequence[float], direction: Sequence[float]) -> Point:
    """Return the part of a unit vector in the plane of motion.

    Parameters
    ----------
    vector : [x, y, z], or (along the direction, up); of any length
    direction : of the motion, horizontal [3]
    """
    x, z = point_in_plane(vector, direction)
    return (x / float(np.linalg.norm(vector)), z / float(np.linalg.norm(vector)))
