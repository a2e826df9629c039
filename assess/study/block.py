"""A mechanism made of plain data in a Python session: its kinds, made from bodies, and its rocking parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from assess.dynamics.packing import Equation
from assess.errors import MechanismError
from assess.geometry.cut import Scene
from assess.interfaces.contact import Interface
from assess.loads.load import LoadDefinition, Place
from assess.mechanisms.four_hinge import FourHinge, RadialJoints
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import CutAngle, CutPlane, Mechanism, Sides, Vector
from assess.mechanisms.restitution import Restitution, RestitutionChoice
from assess.mechanisms.single_block import EquivalentBlock, SingleBlock
from assess.mechanisms.two_block import TwoBlock
from assess.messages.message import Message, locate
from assess.model.bodies import Bodies, Body, gaps_of, overlaps_of, solids_of
from assess.model.check import check_definition, with_floats
from assess.model.directions import mechanism_in_direction
from assess.oscillator import Oscillator
from assess.results import OscillatorResult
from assess.study.amplification import lowest_body
from assess.study.mechanism_results import oscillator_result, rigid_branches


@dataclass(frozen=True)
class RockingParameters:
    """What rocking needs to know of one branch of a mechanism, as `assess parameters` prints it.

    p : frequency parameter [1/s]; slenderness : of the equivalent block [rad]; radius : of the equivalent block [m]
    multiplier : acceleration in g that starts the rocking [-], None where a flexible joint lets it start at once
    overturning : rotation beyond which it falls under gravity alone [rad]; restitution : of the impact [-]; mass [kg]
    """

    p: float
    slenderness: float
    radius: float
    multiplier: float | None
    overturning: float
    restitution: float
    mass: float

    @classmethod
    def of(cls, result: OscillatorResult) -> RockingParameters:
        """Return the parameters of a branch of the results."""
        return cls(
            p=result.p_eq_per_s,
            slenderness=result.slenderness_rad,
            radius=result.radius_m,
            multiplier=result.uplift_multiplier,
            overturning=result.overturning_rad,
            restitution=result.restitution,
            mass=result.mass_kg,
        )


@dataclass(frozen=True, repr=False)
class Block:
    """A mechanism made of plain data, ready for histories, envelopes and the procedures of the codes.

    definition : what was asked for; bodies : by name; mechanism : as built; scene : its bodies in space
    """

    name: str
    definition: Definition
    bodies: Bodies
    mechanism: Mechanism
    scene: Scene | None

    def __repr__(self) -> str:
        one = self.oscillator
        multiplier = "none" if one.multiplier is None else f"{one.multiplier:.4g}"
        return (
            f"Block({self.name!r}, {self.mechanism.kind}, p={one.p:.4g} 1/s, slenderness={one.slenderness:.4g} rad, "
            f"multiplier={multiplier}, overturning={one.overturning:.4g} rad, {one.mass:.4g} kg)"
        )

    @cached_property
    def oscillator(self) -> RockingParameters:
        """The parameters of positive rotation, which topples towards the direction."""
        found = self._parameters[0]
        assert found is not None
        return found

    @cached_property
    def oscillator_negative(self) -> RockingParameters | None:
        """The parameters of negative rotation; None where it rocks to one side."""
        return self._parameters[1]

    @cached_property
    def rocking(self) -> Oscillator:
        """The oscillator that histories and envelopes move: with what is shown to last up to collapse.

        Raises
        ------
        MechanismError : the mechanism stands only by ties or forces that are not shown to last
        """
        found = self.mechanism.variants.collapse
        if found is None:
            names = ", ".join(self.mechanism.variants.depends_on)
            raise MechanismError(
                f'mechanism "{self.name}": it stands only by {names}, not shown to last up to collapse; give until and '
                "evidence"
            )
        return found

    @property
    def equation(self) -> Equation:
        """The equation of motion of its histories: linearised for published parameters, else exact."""
        return "linearised" if isinstance(self.definition, EquivalentBlock) else "exact"

    @cached_property
    def lowest(self) -> float | None:
        """The elevation of the lowest body that is more than a load [m]; None without bodies."""
        return lowest_body({self.name: self.definition}, solids_of(self.bodies))

    @cached_property
    def messages(self) -> tuple[Message, ...]:
        """What the engineer should know before using it: gaps, overlaps, doubtful loads and hinges."""
        where, definitions = f"mechanisms.{self.name}", {self.name: self.definition}
        return (
            *overlaps_of(definitions, self.bodies),
            *gaps_of(definitions, self.bodies),
            *locate(self.mechanism.warnings, where),
            *self.mechanism.messages,
        )

    @cached_property
    def _parameters(self) -> tuple[RockingParameters, RockingParameters | None]:
        starting = self.mechanism.variants.starting
        rigid, mass = rigid_branches(self.mechanism, starting), starting.mass
        front = oscillator_result(starting.positive, mass=mass, rigid=rigid[0], equilibrium=starting.equilibrium)
        if starting.negative is None:
            return RockingParameters.of(front), None
        back = oscillator_result(
            starting.negative, mass=mass, rigid=rigid[-1], equilibrium=starting.equilibrium_negative
        )
        return RockingParameters.of(front), RockingParameters.of(back)


def make_block(name: str, definition: Definition, bodies: Sequence[Body]) -> Block:
    """Build a mechanism from its definition and the bodies of the building.

    Raises
    ------
    MechanismError : two bodies have one name, or a value is one that no mechanism can have
    """
    if not isinstance(name, str) or not name:
        raise MechanismError(f"name = {name!r:.60}: give a text, by which messages call the mechanism")
    by_name = {body.name: body for body in bodies}
    if len(by_name) < len(bodies):
        twice = sorted({body.name for body in bodies if sum(body.name == other.name for other in bodies) > 1})
        raise MechanismError(f'mechanism "{name}": several bodies are called {", ".join(twice)}; give each its name')
    definition = with_floats(definition)
    check_definition(name, definition, by_name)
    built = mechanism_in_direction(name, definition, by_name)
    return Block(name, definition, by_name, built.mechanism, built.scene)


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
    moving = _one_or_several(body)
    definition = SingleBlock(
        blocks=(tuple(each.name for each in moving),),
        cut=cut,
        hinges=None if hinge is None else (hinge,),
        hinges_negative=None if hinge_negative is None else (hinge_negative,),
        **_shared_fields(direction, sides, loads, interface, restitution),
    )
    return make_block(name, definition, (*moving, *_bodies("around", around)))


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
    interfaces: Mapping[str, Interface] | None = None,
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
    interfaces : what single hinges press on, by letter, in place of `interface`
    others : as for `single_block`

    Raises
    ------
    MechanismError or GeometryError : it cannot rock as described; the text says why, and what to do
    """
    moving = _one_or_several(body)
    definition = TwoBlock(
        blocks=tuple((each.name,) for each in moving),
        crack=crack,
        cut=cut,
        hinges=hinges,
        hinges_negative=hinges_negative,
        interfaces={} if interfaces is None else interfaces,
        **_shared_fields(direction, sides, loads, interface, restitution),
    )
    return make_block(name, definition, (*moving, *_bodies("around", around)))


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
    interfaces: Mapping[str, Interface] | None = None,
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
    interfaces : what single hinges press on, by letter, in place of `interface`
    others : as for `single_block`

    Raises
    ------
    MechanismError or GeometryError : it cannot rock as described; the text says why, and what to do
    """
    moving = _one_or_several(body)
    definition = FourHinge(
        blocks=tuple((each.name,) for each in moving),
        hinges=hinges,
        hinges_negative=hinges_negative,
        interfaces={} if interfaces is None else interfaces,
        joints=joints,
        **_shared_fields(direction, sides, loads, interface, restitution),
    )
    return make_block(name, definition, (*moving, *_bodies("around", around)))


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


def _one_or_several(body: BodyOrBodies) -> tuple[Body, ...]:
    """One body or several, at least one; raise MechanismError for anything else."""
    several = (body,) if isinstance(body, Body) else _bodies("body", body)
    if not several:
        raise MechanismError("body = (): give one body or more, as box, profile and mesh return them")
    return several


def _bodies(key: str, given: Any) -> tuple[Body, ...]:
    """Return a row of bodies; raise MechanismError for anything else."""
    if not isinstance(given, tuple | list) or not all(isinstance(each, Body) for each in given):
        raise MechanismError(f"{key} = {given!r:.60}: give a list of bodies, as box, profile and mesh return them")
    return tuple(given)


def _shared_fields(
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
        "loads": _loads(loads),
        "interface": Interface() if interface is None else interface,
        "restitution": _restitution(restitution),
    }


def _loads(given: Any) -> tuple[LoadDefinition, ...]:
    """Return a row of loads, whose kinds are checked with the mechanism; raise MechanismError for what is no row."""
    if not isinstance(given, tuple | list):
        raise MechanismError(f"loads = {given!r:.60}: give a list of loads")
    return tuple(given)


def _direction(given: Any) -> Any:
    """The direction as definitions have it: a tuple of floats, a word, or None for the weakest."""
    if given is None or isinstance(given, str):
        return None if given == "weakest" else given
    try:
        return tuple(map(float, given))
    except (TypeError, ValueError):
        raise MechanismError(f'direction = {given!r:.60}: give (x, y, 0), "weakest" or "sweep"') from None


def _restitution(given: Any) -> Restitution:
    """One choice for both impacts, or one for each."""
    pair = isinstance(given, tuple | list)
    if pair and len(given) != 2:
        raise MechanismError(f"restitution = {given}: give one value, or one for each of two impacts")
    return Restitution(*given) if pair else Restitution(given, given)
