"""What a block carries or is pulled by besides itself: as an engineer states it, and in the plane of motion.

A place that is stated is [x, y, z], or (distance along the direction, elevation) [m]; so is a direction. In the plane
of motion places and forces are (distance along the direction, elevation), and a load is fixed to its block.

A force or tie may end before the mechanism collapses. `until` says when: "collapse" where it is still there then, or
the displacement of its point [m] at which it ends; None where it is not shown to last.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import hypot
from typing import Any, ClassVar, Literal

import numpy as np
from scipy.constants import g

from assess.geometry.contact import CONTACT_TOLERANCE
from assess.messages.message import Message, Term

Place = tuple[float, ...]
Point = tuple[float, float]
Until = float | Literal["collapse"] | None
Through = Literal["joint", "fixed"] | None
SourceParts = tuple[Term | Message, ...]


@dataclass(frozen=True, kw_only=True)
class MassLoad:
    """A point mass: a floor, a roof, a wall that moves with the block.

    mass [kg]; bearing : the block carries its weight, else only its horizontal inertia acts on the block
    seat : how far its point can move along the direction before it falls off [m]; block : from 0 at the base
    """

    kind: ClassVar = "mass"
    mass: float
    at: Place
    bearing: bool = True
    seat: float | None = None
    block: int = 0


@dataclass(frozen=True, kw_only=True)
class ForceLoad:
    """A dead force: the thrust of a vault or roof.

    force : (along the direction, up) [N], or its size with a direction
    until : "collapse" where it is shown to be there up to collapse, with evidence; or the displacement of its point at
    which it ends [m]; None where it counts in the multiplier alone
    """

    kind: ClassVar = "force"
    force: tuple[float, float] | float
    at: Place
    direction: Place | None = None
    until: Until = None
    block: int = 0
    evidence: str = ""


@dataclass(frozen=True, kw_only=True)
class TieLoad:
    """A tie of constant pretension [N], slack on the branch where it shortens.

    direction : the way it pulls, or anchor : its fixed end; both : taut on both branches
    It counts up to collapse only with until = "collapse", strength [N], length [m], fracture strain [-] and evidence.
    """

    kind: ClassVar = "tie"
    force: float
    at: Place
    direction: Place | None = None
    anchor: Place | None = None
    both: bool = False
    until: Until = None
    strength: float | None = None
    length: float | None = None
    fracture_strain: float | None = None
    block: int = 0
    evidence: str = ""


@dataclass(frozen=True, kw_only=True)
class OverburdenLoad:
    """What presses on the top of a wall of two blocks: a dead vertical load, without mass of its own.

    force [N], or the names of the bodies that stand on the wall
    eccentricity : from mid-thickness of the top towards the direction [m]
    through : "joint" where it presses where the top does, "fixed" where it stays in its place on the wall
    """

    kind: ClassVar = "overburden"
    force: float | None = None
    bodies: tuple[str, ...] = ()
    eccentricity: float | None = None
    through: Through = None


@dataclass(frozen=True, kw_only=True)
class BodyLoad:
    """A floor, roof or vault given as a body: what it puts on the block is found where it touches it.

    tolerance : faces this near each other touch [m]; share : part of the body that this block carries, in (0, 1]
    bearing : whether the block carries weight; seat : how far the contact can move before the body falls off [m]
    mass : of the whole body [kg]; thrust [N], span [m], rise [m] : of a roof or vault; from its shape where None
    construction : weight of a vault by Ungewitter's case 1 to 5; fill : over the plan of a vault [kg/m2]
    block : which it acts on, from 0 at the base; None for the one that it touches, or all that it bears on
    """

    kind: ClassVar = "body"
    body: str
    role: Literal["floor", "roof", "vault"] = "floor"
    tolerance: float = CONTACT_TOLERANCE
    share: float | None = None
    bearing: bool | None = None
    seat: float | None = None
    at: Place | None = None
    mass: float | None = None
    thrust: float | None = None
    span: float | None = None
    rise: float | None = None
    tied: bool = False
    vault: Literal["barrel", "quadripartite"] | None = None
    construction: int | None = None
    fill: float | None = None
    block: int | None = None


LoadDefinition = MassLoad | ForceLoad | TieLoad | OverburdenLoad | BodyLoad


def direction_keys(load: Any) -> Iterator[str]:
    """Name what of a load is measured along the direction of motion: points of two numbers, eccentricities.

    load : one of these, or the table of a project file that has the same names
    """
    for key in ("force", "at", "direction", "anchor"):
        value = getattr(load, key, None)
        if isinstance(value, tuple) and len(value) == 2:
            yield key
    if getattr(load, "eccentricity", None):
        yield "eccentricity"


def bodies_of(load: LoadDefinition) -> tuple[str, ...]:
    """Return the names of the bodies that a load stands for."""
    if isinstance(load, OverburdenLoad):
        return load.bodies
    return (load.body,) if isinstance(load, BodyLoad) else ()


def source_phrase(parts: SourceParts) -> str:
    """Return the parts of a source in one English phrase."""
    return "; ".join(map(str, parts))


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
    source_parts: SourceParts = ()
    seat: float | None = None

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.source_parts)


@dataclass(frozen=True)
class Force:
    """A dead force (x, z) [N] of constant size and direction: the thrust of a vault or roof.

    evidence : where it is shown that it lasts as `until` says; empty where it is not.
    """

    name: str
    force: Point
    at: Point
    block: int = 0
    source_parts: SourceParts = ()
    until: Until = None
    evidence: str = ""

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.source_parts)

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
    source_parts: SourceParts = ()
    until: Until = None
    strength: float | None = None
    length: float | None = None
    fracture_strain: float | None = None
    evidence: str = ""

    @property
    def source(self) -> str:
        """How it was found, in English."""
        return source_phrase(self.source_parts)

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


ForceOrTie = Force | Tie
Load = PointMass | Force | Tie


def pull_at_rest(tie: Tie) -> Point:
    """Return the force (x, z) [N] of a taut tie at rest."""
    if tie.anchor is None:
        along, up = tie.direction or (0.0, 0.0)
        return (tie.tension * along, tie.tension * up)
    to_x, to_z = tie.anchor[0] - tie.at[0], tie.anchor[1] - tie.at[1]
    length = hypot(to_x, to_z)
    return (tie.tension * to_x / length, tie.tension * to_z / length)


def lasts(action: ForceOrTie) -> bool:
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
