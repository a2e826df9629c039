"""A mechanism made of plain data, as a Python session has it: its kinds and its rocking parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from assess.declaration import IsHorizontal
from assess.dynamics.packing import Equation
from assess.errors import MechanismError
from assess.geometry.cut import Scene
from assess.interfaces.contact import Interface
from assess.loads.load import LoadDefinition, Place
from assess.mechanisms.arch_in_plan import HorizontalArch
from assess.mechanisms.four_hinge import FourHinge, RadialJoints
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import CutAngle, CutPlane, Mechanism, Sides, Vector
from assess.mechanisms.restitution import Restitution, RestitutionChoice
from assess.mechanisms.side_walls import SideWalls
from assess.mechanisms.single_block import EquivalentBlock, SingleBlock
from assess.mechanisms.two_block import TwoBlock
from assess.mechanisms.wedged_block import Corner, FacadeWithWedges, Wedge, WedgedBlock
from assess.messages.message import Message, locate, message
from assess.model.bodies import Bodies, Body, solids_of
from assess.model.check import check_definition, with_floats
from assess.model.directions import mechanism_in_direction
from assess.oscillator import Oscillator
from assess.results import OscillatorResult
from assess.short_repr import html_table
from assess.study.amplification import lowest_body_elevation
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
    def from_result(cls, result: OscillatorResult) -> RockingParameters:
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

    definition : as given; bodies : by name; mechanism : as built; scene : its bodies in space
    """

    name: str
    definition: Definition
    bodies: Bodies
    mechanism: Mechanism
    scene: Scene | None

    def __repr__(self) -> str:
        parameters = self.oscillator
        multiplier = "none" if parameters.multiplier is None else f"{parameters.multiplier:.4g}"
        return (
            f"Block({self.name!r}, {self.mechanism.kind}, p={parameters.p:.4g} 1/s, "
            f"slenderness={parameters.slenderness:.4g} rad, multiplier={multiplier}, "
            f"overturning={parameters.overturning:.4g} rad, {parameters.mass:.4g} kg)"
        )

    def _repr_html_(self) -> str:
        of = self.oscillator
        return html_table(
            (self.name, self.mechanism.kind),
            ("frequency parameter p [1/s]", of.p),
            ("slenderness [rad]", of.slenderness),
            ("multiplier at rest", "none" if of.multiplier is None else of.multiplier),
            ("overturning rotation [rad]", of.overturning),
            ("restitution", of.restitution),
            ("mass [kg]", of.mass),
        )

    @cached_property
    def oscillator(self) -> RockingParameters:
        """The parameters of positive rotation, which topples towards the direction."""
        positive = self._parameters[0]
        assert positive is not None
        return positive

    @cached_property
    def oscillator_negative(self) -> RockingParameters | None:
        """The parameters of negative rotation; None where it rocks to one side."""
        return self._parameters[1]

    @cached_property
    def rocking(self) -> Oscillator:
        """The oscillator that histories and envelopes move: with what is shown to last up to collapse.

        Raises
        ------
        MechanismError : the mechanism stands only by ties or forces that are not shown to last, or what its impacts
            leave is not known
        """
        if not self.mechanism.rocks:
            text = message("histories-unknown", {}).text
            raise MechanismError(f'mechanism "{self.name}": {text}')
        collapse = self.mechanism.variants.collapse
        if collapse is None:
            names = ", ".join(self.mechanism.variants.depends_on)
            raise MechanismError(
                f'mechanism "{self.name}": it stands only by {names}, not shown to last up to collapse; give until and '
                "evidence"
            )
        return collapse

    @property
    def equation(self) -> Equation:
        """The equation of motion of its histories: linearised for published parameters, else exact."""
        return "linearised" if isinstance(self.definition, EquivalentBlock) else "exact"

    @cached_property
    def lowest(self) -> float | None:
        """The elevation of the lowest body that is more than a load [m]; None without bodies."""
        return lowest_body_elevation({self.name: self.definition}, solids_of(self.bodies))

    @cached_property
    def messages(self) -> tuple[Message, ...]:
        """What the engineer should know before using it: gaps, overlaps, doubtful loads and hinges."""
        return (*locate(self.mechanism.warnings, f"mechanisms.{self.name}"), *self.mechanism.messages)

    @cached_property
    def _parameters(self) -> tuple[RockingParameters, RockingParameters | None]:
        starting = self.mechanism.variants.starting
        rigid, mass = rigid_branches(self.mechanism, starting), starting.mass
        front = oscillator_result(starting.positive, mass=mass, rigid=rigid[0], equilibrium=starting.equilibrium)
        if starting.negative is None:
            return RockingParameters.from_result(front), None
        back = oscillator_result(
            starting.negative, mass=mass, rigid=rigid[-1], equilibrium=starting.equilibrium_negative
        )
        return RockingParameters.from_result(front), RockingParameters.from_result(back)


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
    side_walls: SideWalls | None = None,
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
    side_walls : toothed into its back as seen along a given direction; NTC 2018 counts their friction, and histories
        of a study, not the motion of one record
    around : other bodies of the building: floors that load it, walls that stop it

    Raises
    ------
    MechanismError or GeometryError : it cannot rock as described; the text says why, and what to do
    """
    bodies = _one_or_several(body)
    definition = SingleBlock(
        blocks=(tuple(each.name for each in bodies),),
        cut=cut,
        hinges=None if hinge is None else (hinge,),
        hinges_negative=None if hinge_negative is None else (hinge_negative,),
        side_walls=side_walls,
        **_shared_fields(direction, sides, loads, interface, restitution),
    )
    return _make_block(name, definition, (*bodies, *_bodies("around", around)))


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
    bodies = _one_or_several(body)
    definition = TwoBlock(
        blocks=tuple((each.name,) for each in bodies),
        crack=crack,
        cut=cut,
        hinges=hinges,
        hinges_negative=hinges_negative,
        interfaces={} if interfaces is None else interfaces,
        **_shared_fields(direction, sides, loads, interface, restitution),
    )
    return _make_block(name, definition, (*bodies, *_bodies("around", around)))


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
    bodies = _one_or_several(body)
    definition = FourHinge(
        blocks=tuple((each.name,) for each in bodies),
        hinges=hinges,
        hinges_negative=hinges_negative,
        interfaces={} if interfaces is None else interfaces,
        joints=joints,
        **_shared_fields(direction, sides, loads, interface, restitution),
    )
    return _make_block(name, definition, (*bodies, *_bodies("around", around)))


def facade_with_wedges(
    body: BodyOrBodies,
    *,
    wedges: Sequence[Wedge],
    direction: Vector,
    name: str = "facade",
    cut: float | None = None,
    loads: Sequence[LoadDefinition] = (),
    interface: Interface | None = None,
    hinge: Place | None = None,
    around: Sequence[Body] = (),
) -> Block:
    """Return a wall that overturns with wedges of the walls behind it; no history of it is answered.

    Parameters
    ----------
    body : the wall with those behind it
    wedges : which of these bodies crack, and how
    direction : horizontal (x, y, 0) in which it falls outwards
    cut : elevation of its foot [m]; that of the wall where None
    others : as for `single_block`

    Raises
    ------
    MechanismError or GeometryError : it cannot fall as described; the text says why, and what to do
    """
    return _wedged_block(FacadeWithWedges, body, wedges, direction, name, cut, loads, interface, hinge, around)


def corner(
    body: BodyOrBodies,
    *,
    wedges: Sequence[Wedge],
    direction: Vector | Literal["weakest"] = "weakest",
    name: str = "corner",
    cut: float | None = None,
    loads: Sequence[LoadDefinition] = (),
    interface: Interface | None = None,
    hinge: Place | None = None,
    around: Sequence[Body] = (),
) -> Block:
    """Return the corner of two walls, which turns outwards about its foot; no history of it is answered.

    Parameters
    ----------
    body : the two walls, of one body or more each
    wedges : the crack in each of them
    direction : horizontal (x, y, 0), between the outward ones of both walls; "weakest" for the weakest of these
    cut : elevation of its foot [m]; that of the walls where None
    others : as for `single_block`

    Raises
    ------
    MechanismError or GeometryError : it cannot fall as described; the text says why, and what to do
    """
    return _wedged_block(Corner, body, wedges, direction, name, cut, loads, interface, hinge, around)


def horizontal_arch(
    body: BodyOrBodies,
    *,
    between: tuple[str, str],
    direction: Vector,
    around: Sequence[Body],
    name: str = "panel",
    ends: tuple[float, float] | None = None,
    strength: float | None = None,
    cut: float | None = None,
    loads: Sequence[LoadDefinition] = (),
) -> Block:
    """Return a panel that bulges out between two cross walls as an arch in plan; no history of it is answered.

    Parameters
    ----------
    body : the wall, or bodies that are one wall
    between : names of the cross walls, which are among `around`
    direction : horizontal (x, y, 0) in which it bulges out
    around : the cross walls, and other bodies of the building
    ends : thrust that each end holds [N]; where None, what the masonry of the wall beyond each cross wall does
    strength : of the masonry along the wall [Pa]; 1 MPa where None
    cut : the level from which it bulges out [m]; that of the wall's foot where None
    name, loads : as for `single_block`, point masses and bodies alone

    Raises
    ------
    MechanismError or GeometryError : it cannot fall as described; the text says why, and what to do
    """
    bodies = _one_or_several(body)
    definition = HorizontalArch(
        blocks=(tuple(each.name for each in bodies),),
        between=between,
        ends=ends,
        strength=strength,
        cut=cut,
        **_shared_fields(direction, None, loads, None, None),
    )
    return _make_block(name, definition, (*bodies, *_bodies("around", around)))


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
    return _make_block(name, definition, ())


def _wedged_block(
    kind: type[WedgedBlock],
    body: BodyOrBodies,
    wedges: Sequence[Wedge],
    direction: Direction,
    name: str,
    cut: float | None,
    loads: Sequence[LoadDefinition],
    interface: Interface | None,
    hinge: Place | None,
    around: Sequence[Body],
) -> Block:
    """Return a façade or a corner with its wedges."""
    if not isinstance(wedges, tuple | list) or not all(isinstance(each, Wedge) for each in wedges):
        raise MechanismError(f"wedges = {wedges!r:.60}: give a list of Wedge(walls=…, angle=…)")
    bodies = _one_or_several(body)
    definition = kind(
        blocks=(tuple(each.name for each in bodies),),
        wedges=tuple(wedges),
        cut=cut,
        hinges=None if hinge is None else (hinge,),
        **_shared_fields(direction, None, loads, interface, None),
    )
    return _make_block(name, definition, (*bodies, *_bodies("around", around)))


def _make_block(name: str, definition: Definition, bodies: Sequence[Body]) -> Block:
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


def _one_or_several(body: BodyOrBodies) -> tuple[Body, ...]:
    """One body or several, at least one; raise MechanismError for anything else."""
    several = (body,) if isinstance(body, Body) else _bodies("body", body)
    if not several:
        raise MechanismError("body = (): give one body or more, as box, profile and mesh return them")
    return several


def _bodies(key: str, bodies: Any) -> tuple[Body, ...]:
    """Return a row of bodies; raise MechanismError for anything else."""
    if not isinstance(bodies, tuple | list) or not all(isinstance(each, Body) for each in bodies):
        raise MechanismError(f"{key} = {bodies!r:.60}: give a list of bodies, as box, profile and mesh return them")
    return tuple(bodies)


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


def _loads(loads: Any) -> tuple[LoadDefinition, ...]:
    """Return a row of loads, whose kinds are checked with the mechanism; raise MechanismError for what is no row."""
    if not isinstance(loads, tuple | list):
        raise MechanismError(f"loads = {loads!r:.60}: give a list of loads")
    return tuple(loads)


def _direction(direction: Any) -> Any:
    """The direction as definitions have it: a tuple of floats, a word, or None for the weakest."""
    if direction is None or isinstance(direction, str):
        return None if direction == "weakest" else direction
    try:
        return tuple(map(float, direction))
    except (TypeError, ValueError):
        raise MechanismError(f"direction = {direction!r:.60}: {IsHorizontal.form}") from None


def _restitution(restitution: Any) -> Restitution:
    """One choice for both impacts, or one for each."""
    pair = isinstance(restitution, tuple | list)
    if pair and len(restitution) != 2:
        raise MechanismError(f"restitution = {restitution}: give one value, or one for each of two impacts")
    return Restitution(*restitution) if pair else Restitution(restitution, restitution)
