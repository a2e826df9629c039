"""The kinds of mechanism by plain data, as a Python session makes them from bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

from assess.errors import MechanismError
from assess.interfaces.definition import Interface
from assess.loads.definitions import LoadDefinition, Place
from assess.mechanisms.impact import RestitutionChoice
from assess.mechanisms.mechanism import Sides
from assess.model.body import Body
from assess.model.definitions import (
    CutAngle,
    CutPlane,
    EquivalentBlock,
    FourHinge,
    RadialJoints,
    Restitution,
    SingleBlock,
    TwoBlock,
    Vector,
)
from assess.study.block import Block, make_block

BodyOrBodies = Body | Sequence[Body]
Direction = Vector | Literal["weakest", "sweep"]


def single_block(
    body: BodyOrBodies,
    *,
    name: str = "block",
    direction: Direction = "weakest",
    cut: float | CutPlane | CutAngle | None = None,
    sides: Sides | None = None,
    loads: Sequence[LoadDefinition] = (),
    interface: Interface | None = None,
    restitution: float | str | tuple[RestitutionChoice, RestitutionChoice] | None = None,
    hinge: Place | None = None,
    hinge_negative: Place | None = None,
    around: Sequence[Body] = (),
) -> Block:
    """Return a block that rocks about the edges of its base.

    Parameters
    ----------
    body : the body that rocks, or several that move as one
    name : of the mechanism
    direction : horizontal (x, y, 0) in which positive rotation topples; "weakest" for that of least resistance, looked
        for among the normals of the base's edges; "sweep" for the weakest all around
    cut : only what lies above moves: an elevation [m], or an inclined crack
    sides : "one" where something behind stops negative rotation; as the bodies touch where None
    loads : point masses, forces, ties, and bodies among `around`
    interface : what the hinges press on; rigid without limit of strength where None
    restitution : velocity after over before the impact [-], or a rule: "thesis", "housner", "sorrentino", "momentum"
    hinge, hinge_negative : given hinges, in space or in the plane of motion; as the geometry shows where None
    around : other bodies of the building: floors that load it, walls that stop it

    Raises
    ------
    MechanismError or GeometryError : it cannot rock as described; the text says why, and what to do
    """
    moving = _several(body)
    definition = SingleBlock(
        blocks=(tuple(each.name for each in moving),),
        cut=cut,
        hinges=None if hinge is None else (hinge,),
        hinges_negative=None if hinge_negative is None else (hinge_negative,),
        **_common(direction, sides, loads, interface, restitution),
    )
    return make_block(name, definition, (*moving, *around))


def two_block(
    body: BodyOrBodies,
    *,
    name: str = "wall",
    direction: Direction = "weakest",
    crack: float | Literal["sorrentino", "minimum"] | None = None,
    cut: float | CutPlane | CutAngle | None = None,
    sides: Sides | None = None,
    loads: Sequence[LoadDefinition] = (),
    interface: Interface | None = None,
    restitution: float | str | tuple[RestitutionChoice, RestitutionChoice] | None = None,
    hinges: tuple[Place, ...] | None = None,
    hinges_negative: tuple[Place, ...] | None = None,
    around: Sequence[Body] = (),
) -> Block:
    """Return a wall held at its base and its top that opens at a crack between.

    Parameters
    ----------
    body : one body, cut at the crack, or two, the lower first
    crack : an elevation [m], "sorrentino" (thesis eq. 3.27) or "minimum" (least uplift multiplier)
    hinges, hinges_negative : A, B and C, where they are given
    others : as for `single_block`

    Raises
    ------
    MechanismError or GeometryError : it cannot rock as described; the text says why, and what to do
    """
    moving = _several(body)
    definition = TwoBlock(
        blocks=tuple((each.name,) for each in moving),
        crack=crack,
        cut=cut,
        hinges=hinges,
        hinges_negative=hinges_negative,
        **_common(direction, sides, loads, interface, restitution),
    )
    return make_block(name, definition, (*moving, *around))


def four_hinge(
    body: BodyOrBodies,
    *,
    hinges: tuple[Place, ...] | Literal["minimum"],
    hinges_negative: tuple[Place, ...] | None = None,
    joints: RadialJoints | tuple[tuple[tuple[float, float], tuple[float, float]], ...] | None = None,
    name: str = "frame",
    direction: Vector = (1.0, 0.0, 0.0),
    sides: Sides | None = None,
    loads: Sequence[LoadDefinition] = (),
    interface: Interface | None = None,
    restitution: float | str | tuple[RestitutionChoice, RestitutionChoice] | None = None,
    around: Sequence[Body] = (),
) -> Block:
    """Return three blocks between two fixed hinges, or an arch that opens where it resists least.

    Parameters
    ----------
    body : the bodies A-B, B-C and C-D, or one arch
    hinges, hinges_negative : A, B, C and D of each rotation, or "minimum" for an arch with `joints`
    sides : "one" where something stops negative rotation, which then has no hinges
    joints : where an arch may open, in order
    others : as for `single_block`

    Raises
    ------
    MechanismError or GeometryError : it cannot rock as described; the text says why, and what to do
    """
    moving = _several(body)
    definition = FourHinge(
        blocks=tuple((each.name,) for each in moving),
        hinges=hinges,
        hinges_negative=hinges_negative,
        joints=joints,
        **_common(direction, sides, loads, interface, restitution),
    )
    return make_block(name, definition, (*moving, *around))


def equivalent_block(
    *,
    p: float,
    uplift: float,
    radius: float,
    mass: float = 1.0,
    name: str = "block",
    sides: Sides = "two",
    elevation: float = 0.0,
    restitution: float | str | tuple[RestitutionChoice, RestitutionChoice] | None = None,
) -> Block:
    """Return a mechanism by its rocking parameters, as published tables give them.

    Parameters
    ----------
    p : frequency parameter [1/s]
    uplift : multiplier that starts rocking, taken as the slenderness [rad]
    radius : distance from the hinge to the centre of mass [m]
    mass : [kg]
    name : of the mechanism
    sides : "one" where something behind stops negative rotation
    elevation : of its base above the ground [m]
    restitution : as for `single_block`
    """
    definition = EquivalentBlock(
        p=p,
        uplift=uplift,
        radius=radius,
        mass=mass,
        sides=sides,
        elevation=elevation,
        restitution=_restitution(restitution),
    )
    return make_block(name, definition, ())


def _several(body: BodyOrBodies) -> tuple[Body, ...]:
    """One body or several, at least one; raise MechanismError for anything else."""
    several = (body,) if isinstance(body, Body) else tuple(body)
    if not several or not all(isinstance(each, Body) for each in several):
        raise MechanismError(f"body = {body!r}: give one body or more, as box, profile and mesh return them")
    return several


def _common(
    direction: Direction,
    sides: Sides | None,
    loads: Sequence[LoadDefinition],
    interface: Interface | None,
    restitution: float | str | tuple[RestitutionChoice, RestitutionChoice] | None,
) -> dict[str, Any]:
    """What all mechanisms of blocks share."""
    return {
        "direction": _direction(direction),
        "sides": sides,
        "loads": tuple(loads),
        "interface": interface or Interface(),
        "restitution": _restitution(restitution),
    }


def _direction(given: Any) -> Any:
    """The direction as definitions have it: a tuple of floats, a word, or None for the weakest."""
    if given is None or isinstance(given, str):
        return None if given == "weakest" else given
    return tuple(map(float, given))


def _restitution(given: Any) -> Restitution:
    """One choice for both impacts, or one for each."""
    if isinstance(given, tuple) and len(given) != 2:
        raise MechanismError(f"restitution = {given}: give one value, or one for each of two impacts")
    return Restitution(*given) if isinstance(given, tuple) else Restitution(given, given)
