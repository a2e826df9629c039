"""A mechanism made of plain data, as a Python session has it: its kinds, its parameters, the answers of codes to it.

Procedures of codes answer by the same rules as in a run of a project.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite
from typing import Any, Literal

from assess.codes.asce43_05 import VERTICAL_RATIO
from assess.codes.bases import BASES, BY_SITE, Acceptance
from assess.codes.check import Check
from assess.codes.context import Building, Context
from assess.codes.italian_limit_states import FACTORS_BY_LEVEL
from assess.codes.procedures import KNOWLEDGE_CODES, PROCEDURES, CodeOptions, uses_histories
from assess.codes.question import Action, Question
from assess.declaration import IsHorizontal
from assess.dynamics.packing import Equation
from assess.errors import MechanismError, ProcedureError
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
from assess.study.amplification import NOT_AMPLIFIED, GroundLevel, HeightAboveGround, find_height, lowest_body_elevation
from assess.study.assessment import check_mechanism
from assess.study.histories import RockingHistories, mechanism_histories, without_runs
from assess.study.level_peaks import RockingCase
from assess.study.mechanism_results import oscillator_result, rigid_branches
from assess.study.response import check_record
from assess.study.study import Fitting, FragilityQuestion, ScaledRecord, Study
from assess.study.suites import ALL_PERIODS, motions_of, suite_faults
from records.errors import RecordError
from records.record import Record, is_vertical
from records.synthetic import ArtificialRecords
from spectra.arrays import is_number
from spectra.gravity import g
from spectra.spectrum import Spectrum


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
    side_walls : toothed into its back as seen along a given direction; only NTC 2018 counts their friction
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


def answers(
    mechanism: Mechanism,
    spectrum: Spectrum,
    *,
    procedures: Sequence[str] | None = None,
    knowledge_level: str | None = None,
    records: Record | Sequence[Record] = (),
    base_elevation: float | None = None,
    lowest: float | None = None,
    building: Building | None = None,
    threads: int = 0,
) -> tuple[Check, ...]:
    """Return what the procedures say of a mechanism at the spectrum's peak ground acceleration.

    The rules are those of a project: a check that lacks an input is not answered, and its reason names the remedy.

    Parameters
    ----------
    mechanism : the collapse mechanism
    spectrum : elastic spectrum of the site, at its own peak ground acceleration
    procedures : names of `assess.codes.procedures.PROCEDURES`; None: those of the basis of the spectrum's code
    knowledge_level : "LC1", "LC2" or "LC3", which the Italian codes ask for where crushing is modelled; None: not given
    records : horizontal ground motions, taken unscaled as those of the spectrum; without any, procedures by time
        histories are not answered
    base_elevation : height of the base of the mechanism above the ground [m]; None: as it is drawn over `lowest`
    lowest : elevation of the lowest body [m], which stands on the ground; None: the ground is at elevation 0
    building : the structure below the mechanism; None: not known
    threads : that share the time histories; 0 for all cores

    Returns
    -------
    tuple of Check
        In the order of `procedures`, the controlling branch of each limit state.

    Raises
    ------
    ProcedureError
        Where a procedure or the level of knowledge is not known, no procedure is named, or a record is vertical.
    """
    suite = (records,) if isinstance(records, Record) else records
    if not isinstance(suite, Sequence) or isinstance(suite, str):
        raise RecordError(f"records = {records!r:.60}: give one record, or a list of them")
    suite = tuple(suite)
    if procedures is None:
        procedures = _default_procedures(spectrum, suite)
    _check_inputs(procedures, knowledge_level, suite, base_elevation)
    height = _height_above_ground(mechanism, base_elevation, lowest, building)
    knowledge = {mechanism.name: dict.fromkeys(KNOWLEDGE_CODES, knowledge_level) if knowledge_level else {}}
    study = replace(
        _plain_study(((mechanism, height),), suite, spectrum),
        building=building,
        procedures=tuple(dict.fromkeys(procedures)),
        knowledge=knowledge,
    )
    return _checks_of_block(study, mechanism, spectrum, threads=threads)


def fragility_study(
    blocks: Sequence[Block], records: Sequence[Record], question: FragilityQuestion, *, spectrum: Spectrum | None
) -> Study:
    """Return the study that `run_fragility` takes, of mechanisms on the ground or as high above it as they are drawn.

    Parameters
    ----------
    blocks : the mechanisms
    records : horizontal ground motions, unscaled
    question : what is asked
    spectrum : that artificial records are made for where there are no others

    Raises
    ------
    MechanismError : no history of a mechanism is answered, or two have one name
    RecordError : something is no horizontal record of finite samples, or there is none
    """
    if not records and spectrum is None:
        raise RecordError("records: none; give recorded motions, as read_records returns them, or a spectrum")
    for record in records:
        check_record(record)
        if is_vertical(record.component):
            raise RecordError(f'record "{record.id}" is vertical; give a horizontal ground motion')
    names = [block.name for block in blocks]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise MechanismError(f"several mechanisms are called {', '.join(twice)}; give each its name")
    for block in blocks:
        _ = block.rocking  # raises where no history of it is answered
    placed = [(block.mechanism, _height_above_ground(block.mechanism, None, block.lowest, None)) for block in blocks]
    artificial = None if records else ArtificialRecords()
    moving = {  # a session may call two bodies by one name
        block.name: tuple(f"{name} {id(block.bodies[name])}" for name in block.definition.bodies)
        for block in blocks
        if not isinstance(block.definition, EquivalentBlock)
    }
    study = _plain_study(placed, tuple(records), spectrum)
    return replace(study, fragility=question, artificial=artificial, moving=moving)


def _default_procedures(spectrum: Spectrum, records: Sequence[Record]) -> tuple[str, ...]:
    """Return the procedures that the basis of a spectrum's code accepts, those by histories only with records.

    Raises ProcedureError where the code has no basis of its own; the text lists the procedures.
    """
    if spectrum.code not in BY_SITE:
        raise ProcedureError(
            f"procedures: none given, and a spectrum of {spectrum.code} has no default; known are: "
            f"{', '.join(PROCEDURES)}"
        )
    states = BASES[BY_SITE[spectrum.code]].states
    accepted = {
        method.procedure
        for state in states
        for rank in state.ranks
        for method in rank
        if method.acceptance == Acceptance.ACCEPTED
    }
    return tuple(name for name in PROCEDURES if name in accepted and (records or not uses_histories(name)))


def _plain_study(
    placed: Sequence[tuple[Mechanism, HeightAboveGround]], records: tuple[Record, ...], spectrum: Spectrum | None
) -> Study:
    """Return a study of mechanisms that says nothing but where they stand, the motions and the spectrum."""
    pga = 0.0 if spectrum is None else spectrum.pga
    equations: dict[str, Equation] = {
        each.name: "linearised" if each.kind == "equivalent-block" else "exact" for each, _ in placed
    }
    return Study(
        spectrum=spectrum,
        vertical_ratio=VERTICAL_RATIO,
        building=None,
        records=records,
        fitting=Fitting(ALL_PERIODS),
        artificial=None,
        scale_to="none",
        levels=(pga,),
        procedures=(),
        offered=(),
        options=CodeOptions(),
        mechanisms=tuple(mechanism for mechanism, _ in placed),
        equations=equations,
        amplified=dict.fromkeys(equations, NOT_AMPLIFIED),
        scenes={},
        inputs=(),
        resolved={},
        messages=(),
        sweeps=(),
        pulses=None,
        hazard=None,
        free_periods={},
        knowledge={},
        limit_state=None,
        question=Question(None, Action(pga / g, None)),
        facts={},
        heights={mechanism.name: height for mechanism, height in placed},
    )


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


def _height_above_ground(
    mechanism: Mechanism, base_elevation: float | None, lowest: float | None, building: Building | None
) -> HeightAboveGround:
    """Return where a mechanism stands: at the height given, else as drawn over the lowest body or elevation 0."""
    height = 0.0 if building is None else building.height
    if base_elevation is not None:
        return find_height(GroundLevel(None, lowest, height), mechanism, base_elevation=base_elevation)
    return find_height(GroundLevel(0.0 if lowest is None else lowest, lowest, height), mechanism)


def _check_inputs(
    procedures: Sequence[str],
    knowledge_level: str | None,
    records: Sequence[Record],
    base_elevation: float | None,
) -> None:
    """Raise ProcedureError for an unknown name, a vertical record or a height that is not finite."""
    if isinstance(procedures, str):
        raise ProcedureError(f'procedures: "{procedures}" given; give a list of names, ["{procedures}"]')
    if base_elevation is not None and not (is_number(base_elevation) and isfinite(base_elevation)):
        raise ProcedureError(f"base_elevation = {base_elevation}: give a finite height above the ground [m]")
    if not isinstance(procedures, Sequence):
        raise ProcedureError(
            f"procedures = {procedures!r:.60}: give a list of names; known are: {', '.join(PROCEDURES)}"
        )
    if not procedures:
        raise ProcedureError(f"procedures: name one at least; known are: {', '.join(PROCEDURES)}")
    for name in procedures:
        if name not in tuple(PROCEDURES):
            raise ProcedureError(f'procedure "{name}" is not known; known are: {", ".join(PROCEDURES)}')
    if knowledge_level is not None and knowledge_level not in FACTORS_BY_LEVEL:
        raise ProcedureError(
            f'knowledge_level "{knowledge_level}" is not known; known are: {", ".join(FACTORS_BY_LEVEL)}'
        )
    for record in records:
        check_record(record)
        if is_vertical(record.component):
            raise ProcedureError(f'record "{record.id}" is a vertical one: give horizontal ground motions')


def _checks_of_block(study: Study, mechanism: Mechanism, spectrum: Spectrum, *, threads: int) -> tuple[Check, ...]:
    """Return the checks of the study's only mechanism."""
    motions = motions_of(study, spectrum)
    study = replace(study, suite_faults=suite_faults(study, spectrum, motions))

    def run(there: Study, case: RockingCase, context: Context) -> RockingHistories:
        return _histories_of_block(there, spectrum, mechanism, case, motions, threads=threads)

    return check_mechanism(study, spectrum, mechanism, motions, run).checks


def _histories_of_block(
    study: Study,
    spectrum: Spectrum,
    mechanism: Mechanism,
    case: RockingCase,
    motions: tuple[ScaledRecord, ...],
    *,
    threads: int,
) -> RockingHistories:
    """Return the time histories that the procedures ask for; suites without records where there are none."""
    if not any(map(uses_histories, study.procedures)):
        return RockingHistories((), ())
    if motions:
        return mechanism_histories(study, spectrum, motions, mechanism, case, threads=threads)
    return without_runs(study, spectrum, mechanism)
