"""The loads of a mechanism as an engineer states them, before they are seen in the plane of motion.

A place is [x, y, z], or (distance along the direction, elevation) [m]; so is a direction.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from assess.geometry.contact import CONTACT_TOLERANCE
from assess.loads.load import Until

Place = tuple[float, ...]
Through = Literal["joint", "fixed"] | None


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
