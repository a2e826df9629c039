"""One mechanism as results.json has it: parameters, drawing, loads, joints, directions, and its response to motions.

The response is amplification up to the base, time histories, and overturning envelopes of pulses.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from assess.codes.calculation_sheet import Step
from assess.codes.check import Check
from assess.mechanisms.directions import DirectionCandidate, DirectionSweep
from assess.messages.message import Message, Term
from assess.oscillator import BranchName
from assess.results.provenance import Floats, Place, Point, Ring
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class MechanismResult(ShortRepr):
    """Everything about one mechanism; direction_sweep is None unless its direction was sought on a whole circle.

    oscillator, curve: with every action that is there at rest. deciding_curve: with actions that are shown to last to
    collapse and those that drive; displacements and histories are of this curve, and their ratios refer to its
    overturning rotations (deciding_overturning_rad, of rigid joints, positive and negative). Both are None if the two
    curves are the same, or if the mechanism falls at rest without the other actions.
    direction: of positive rotation, horizontal; None for an equivalent block. candidates: directions among which the
    weakest was found, or with which a given one was compared. base_elevation_m: of its base above the ground;
    input_height_m: of its support, the mean of base and far support if it has both; above_ground: whether that counts
    as above the ground; ground_known_from: source of the level of the ground. restitution_source: the English of
    restitution_said.
    """

    name: str
    label: str
    kind: str
    sides: Literal["one", "two"]
    equation: Literal["exact", "linearised"]
    drawing: Drawing
    view: View | None
    oscillator: OscillatorResult
    oscillator_negative: OscillatorResult | None
    curve: CapacityCurve
    interfaces: tuple[dict[str, Any], ...]
    amplification: AmplificationResult
    checks: tuple[Check, ...]
    histories: tuple[HistoryResult, ...]
    suites: tuple[SuiteResult, ...]
    envelope: EnvelopeResult | None
    restitution_source: str
    loads: tuple[LoadResult, ...]
    direction_sweep: DirectionSweep | None
    interface_curves: InterfaceCurves | None = None
    hinge_forces: tuple[HingeForceResult, ...] = ()
    deciding_curve: CapacityCurve | None = None
    deciding_overturning_rad: tuple[float, float | None] | None = None
    direction: tuple[float, float, float] | None = None
    candidates: tuple[DirectionCandidate, ...] = ()
    base_elevation_m: float | None = None
    input_height_m: float | None = None
    above_ground: bool | None = None
    ground_known_from: str = ""
    restitution_said: tuple[Term | Message, ...] = ()
    contact_sheets: tuple[ContactSheet, ...] = ()


@dataclass(frozen=True, repr=False)
class OscillatorResult(ShortRepr):
    """The rocking parameters of one branch."""

    mass_kg: float
    inertia_kg_m2: float
    radius_m: float
    slenderness_rad: float
    p_eq_per_s: float
    uplift_multiplier: float | None
    overturning_rad: float
    overturning_flexible_rad: float | None
    critical_rad: float
    equilibrium_rad: float
    elastic_frequency_hz: float | None
    restitution: float
    linearised: LinearisedResult


@dataclass(frozen=True, repr=False)
class LinearisedResult(ShortRepr):
    """Kinematic constants of a branch linearised at critical_rad (thesis 3.4-3.12): I, K, B, M, phi_cr, phi_ov.

    uplift_multiplier: lambda of 3.11, to which thesis tables refer; the exact one is that of the oscillator.
    """

    inertia_kg_m2: float
    stiffness_n_m_per_rad: float
    excitation_kg_m: float
    moment_n_m: float
    critical_rad: float
    overturning_rad: float
    uplift_multiplier: float


@dataclass(frozen=True, repr=False)
class CapacityCurve(ShortRepr):
    """Both branches of the capacity curve."""

    positive: BranchCurve
    negative: BranchCurve | None


@dataclass(frozen=True, repr=False)
class BranchCurve(ShortRepr):
    """The capacity curve of one branch, all positive."""

    rotation_rad: Floats
    inertia_kg_m2: Floats
    restoring_n_m: Floats
    excitation_kg_m: Floats
    participating_mass_kg: Floats
    displacement_m: Floats


@dataclass(frozen=True, repr=False)
class Drawing(ShortRepr):
    """The mechanism in its plane of motion, to scale [m]: closed outlines of the blocks, hinges, loads, centroid.

    block_of: block of the positive branch that each outline belongs to, from 0 at the base, -1 if it does not move (an
    arch may divide into other blocks each way); centroids, masses_kg: of each block, without loads, the latter empty
    where none has weight in this plane or it is not known; displaced, displaced_negative: turned to
    either side, far enough to be seen but not beyond overturning; fixed: outlines of masonry that does not move, as
    below a cut.
    """

    blocks: tuple[Ring, ...]
    hinges: tuple[NamedPoint, ...]
    loads: tuple[DrawnLoad, ...]
    centroid: Point
    block_of: tuple[int, ...]
    centroids: tuple[Point, ...]
    displaced: DisplacedDrawing
    displaced_negative: DisplacedDrawing | None
    fixed: tuple[Ring, ...]
    masses_kg: tuple[float, ...] = ()


@dataclass(frozen=True, repr=False)
class DisplacedDrawing(ShortRepr):
    """The mechanism after a rotation of its leading block, in the plane of motion, not mirrored [m].

    blocks, loads and centroids are in the order of the drawing at rest; hinges and block_of are of the branch that
    turns.
    """

    rotation_rad: float
    blocks: tuple[Ring, ...]
    block_of: tuple[int, ...]
    hinges: tuple[NamedPoint, ...]
    loads: tuple[DrawnLoad, ...]
    centroids: tuple[Point, ...]


@dataclass(frozen=True, repr=False)
class DrawnLoad(ShortRepr):
    """A load in the plane of motion: where it acts [m], and the unit vector of its force.

    towards: None for a non-bearing mass, which has no force at rest.
    """

    name: str
    at: Point
    kind: Literal["mass", "force", "tie"]
    towards: Point | None


@dataclass(frozen=True, repr=False)
class NamedPoint(ShortRepr):
    """A hinge or another named point in the plane of motion: distance along the direction, elevation [m]."""

    name: str
    at: Point


@dataclass(frozen=True, repr=False)
class View(ShortRepr):
    """The bodies of a mechanism in space [m], simplified and rounded for drawing; not for calculation.

    triangles: indices into vertices, anticlockwise seen from outside; block_of: the block that each triangle belongs
    to, from 0 at the base, -1 if it does not move. sections: closed rings where cuts pass through the masonry.
    size: of the bounding box along x, y, z. given: number of triangles of the bodies before simplification.
    """

    vertices: tuple[Place, ...]
    triangles: tuple[tuple[int, int, int], ...]
    block_of: tuple[int, ...]
    axes: tuple[HingeAxis, ...]
    sections: tuple[tuple[Place, ...], ...]
    direction: Place
    size: Place
    given: int


@dataclass(frozen=True, repr=False)
class BodyEdges(ShortRepr):
    """A body of which no mechanism moves any part: its sharp edges in space, each by its two ends [m].

    kind : "tie" for a bar that is drawn; empty for all else
    """

    name: str
    edges: tuple[tuple[Place, Place], ...]
    kind: Literal["tie", ""] = ""


TieOutcome = Literal["elastic", "yields", "holds", "slack", "gone", "not counted", "not known"]
"""What becomes of a tie at the rotation demanded: one of given force "holds"; "not counted" is not shown to last."""


@dataclass(frozen=True, repr=False)
class HeldByTie(ShortRepr):
    """What becomes of a tie in a mechanism that it holds, at the rotation that the deciding method demands.

    load : its name among the loads of the mechanism
    elongation_m : from rest, plastic_m : of it for good; None where the rotation is not known or nothing stretches
    pull_n : the most with which it has pulled up to there, N_Ed; None where that is not known, or it does not stretch
    links : what it consists of, in order, each with its design strength
    """

    mechanism: str
    load: str
    outcome: TieOutcome
    elongation_m: float | None = None
    plastic_m: float | None = None
    pull_n: float | None = None
    links: tuple[TieLink, ...] = ()

    @property
    def governing(self) -> TieLink | None:
        """The link of the largest ratio; None where none is known."""
        return max(
            (each for each in self.links if each.ratio is not None), key=lambda each: each.ratio or 0.0, default=None
        )


TieLinkName = Literal[
    "bar",
    "thread",
    "plate",
    "bearing",
    "punching",
    "sliding",
    "between",
    "far end",
    "far wall",
    "anchorage",
    "strength",
]
"""A link of a tie: the bar, those of its plate, or what is stated of its anchorage, or of a restraint without a bar."""


@dataclass(frozen=True, repr=False)
class TieLink(ShortRepr):
    """A link of a tie at the demand.

    strength_n : its design strength N_Rd; None without limit, or where it is not answered
    ratio : D/C, N_Ed over N_Rd; None where either is not known
    """

    name: TieLinkName
    strength_n: float | None
    ratio: float | None


@dataclass(frozen=True, repr=False)
class TieResult(ShortRepr):
    """A tie of the building: its ends in space [m], at what it holds and at its anchor.

    held : the mechanisms that it holds; empty for one that is drawn and that no mechanism counts
    body : the bar of the project that it lies along; empty where none is drawn
    """

    ends: tuple[Place, Place]
    held: tuple[HeldByTie, ...]
    body: str = ""

    @property
    def outcome(self) -> TieOutcome:
        """The worst of what becomes of it in the mechanisms that it holds."""
        outcomes = {each.outcome for each in self.held} or {"not counted"}
        return next(each for each in WORST_FIRST if each in outcomes)


WORST_FIRST: tuple[TieOutcome, ...] = ("gone", "yields", "not known", "elastic", "holds", "slack", "not counted")


@dataclass(frozen=True, repr=False)
class HingeAxis(ShortRepr):
    """The axis of rotation at a hinge: its two ends [m]."""

    name: str
    ends: tuple[Place, Place]


Lasting = Literal["to collapse", "to its end", "not shown"]


@dataclass(frozen=True, repr=False)
class LoadResult(ShortRepr):
    """A load as used: a mass, bearing or not, or the force (along the direction, up) of a force or tie at rest.

    at: distance along the direction, elevation [m]; source: how it was found, or "given", the English of `found`.
    lasting: how long a force or tie that resists on some branch is shown to last: to collapse, to an earlier end
    (at end_rad, where its point has moved by end_m), or not at all, because the keys `missing` are not given; None
    if it only drives. A tie that lasts also has an end if its fracture strain is reached beyond collapse. seat_m:
    length of seat of a bearing mass. tie: what a tie that stretches does; None for all others.
    """

    name: str
    kind: Literal["mass", "force", "tie"]
    block: int
    at: Point
    mass_kg: float | None
    bearing: bool | None
    force_n: Point | None
    source: str
    lasting: Lasting | None = None
    missing: tuple[str, ...] = ()
    end_rad: float | None = None
    end_m: float | None = None
    seat_m: float | None = None
    found: tuple[Term | Message, ...] = ()
    tie: StretchingTie | None = None


@dataclass(frozen=True, repr=False)
class StretchingTie(ShortRepr):
    """A tie that stretches.

    stiffness_n_m: of its bar [N/m]; slack_m: by which its ends move apart before it pulls; yield_n: force at which its
    bar yields; anchorage_n: strength of all the rest, None if not known, as are then the others. ductile: whether the
    bar yields first, with 1.25 to spare; fails: what does; gone_m: elongation from rest at which it breaks, or its
    anchorage fails. steps: the sheet of its anchorage, where that is computed.
    """

    stiffness_n_m: float
    slack_m: float
    yield_n: float
    anchorage_n: float | None
    ductile: bool | None
    fails: Term | None
    gone_m: float | None
    steps: tuple[Step, ...] = ()


@dataclass(frozen=True, repr=False)
class InterfaceCurves(ShortRepr):
    """Moments of the positive branch by simpler interfaces, for comparison: rigid, and hinges fixed at a_SF."""

    rigid: BranchMoment
    fixed_hinges: BranchMoment


@dataclass(frozen=True, repr=False)
class BranchMoment(ShortRepr):
    """A moment-rotation curve."""

    rotation_rad: Floats
    restoring_n_m: Floats


@dataclass(frozen=True, repr=False)
class ContactSheet(ShortRepr):
    """The contact of a joint that yields or crushes, as the lines of a calculation sheet. hinge: with ' if negative."""

    hinge: str
    steps: tuple[Step, ...]


@dataclass(frozen=True, repr=False)
class HingeForceResult(ShortRepr):
    """The force through a hinge when its mechanism starts to rock, at the ground acceleration activation_g.

    horizontal_n, vertical_n: on the block that presses, along the branch's own direction and up; normal_n, shear_n:
    normal to its faces (compression positive) and along them; face: unit normal of the faces (along, up), towards that
    block; face_found: False if the geometry has no faces there and they are taken as level. needed_friction: |shear_n|
    / normal_n, None without compression; friction: of the joint, None if not known. sliding_g: ground acceleration at
    which it slides before it rocks, None if it rocks first or friction is not known. held: whether a support holds it
    besides friction, as at the top of a wall.
    """

    hinge: str
    branch: BranchName
    horizontal_n: float
    vertical_n: float
    needed_friction: float | None
    friction: float | None
    normal_n: float
    shear_n: float
    face: Point
    face_found: bool
    activation_g: float
    sliding_g: float | None
    held: bool


@dataclass(frozen=True, repr=False)
class AmplificationResult(ShortRepr):
    """The amplification of the ground motion up to the mechanism.

    height_m: of its base above the ground, None where nothing is amplified; said: description of the method, with its
    numbers and assumptions; motion: present if the motion is filtered, not only multiplied;
    building_period_ratio: of the building's first period to the elastic one [-], where the mechanism comes off worst by
    histories; building_damping: of that mode, None for the elastic one [-].
    """

    method: str
    factors: tuple[AmplificationFactor, ...]
    height_m: float | None = None
    said: tuple[Message | str, ...] = ()
    motion: CarriedMotion | None = None
    building_period_ratio: float = 1.0
    building_damping: float | None = None


@dataclass(frozen=True, repr=False)
class AmplificationFactor(ShortRepr):
    """The factor by which a record is amplified up the building [-]."""

    record: str
    factor: float


@dataclass(frozen=True, repr=False)
class CarriedMotion(ShortRepr):
    """The record that is amplified most, scaled to the target, at the ground and at the base of the mechanism.

    Response spectra [k]: of 5 % damping.
    """

    record: str
    time_s: Floats
    ground_acceleration_g: Floats
    base_acceleration_g: Floats
    period_s: Floats
    ground_spectrum_g: Floats
    base_spectrum_g: Floats


@dataclass(frozen=True, repr=False)
class HistoryResult(ShortRepr):
    """The largest rocking response to one record at one level, in the worse polarity.

    max_rotation_rad: signed; it, its ratio and its time are None where the record overturned the mechanism.
    overturning_time_s: last passage of phi_ov. branch: of the largest rotation. rebound: factor on the restitution of
    the mechanism with which this history was worst, 1 if no range was run [-]. variant: with which oscillator it was: 0
    without the actions that are not shown to last, 1 and 2 with them, up to where they end or throughout.
    max_rotation_ratio is over phi_ov without them. twin_ratios, twin_times_s: largest |rotation| / phi_ov and its time
    in each of the nine runs, the record as it is and its eight twins (see docs/verdict.md), None where that run
    overturned; twin_impacts: their impacts. Empty where the record was run alone. The number
    of impacts is a result only where all nine agree.
    """

    record: str
    polarity: int
    level_pga_g: float
    scale_factor: float
    amplification: float
    max_rotation_rad: float | None
    max_rotation_ratio: float | None
    time_of_max_s: float | None
    impacts: int
    overturned: bool
    overturning_time_s: float | None
    trace: HistoryTrace | None
    branch: BranchName
    rebound: float = 1.0
    variant: int = 0
    twin_ratios: tuple[float | None, ...] = ()
    twin_times_s: tuple[float | None, ...] = ()
    twin_impacts: tuple[int, ...] = ()


@dataclass(frozen=True, repr=False)
class HistoryTrace(ShortRepr):
    """A rocking history at the steps of its motion: signed rotation, ground acceleration.

    base_acceleration_g: motion at the base of the mechanism; None where that is the ground motion.
    """

    time_s: Floats
    rotation_rad: Floats
    ground_acceleration_g: Floats
    base_acceleration_g: Floats | None = None


@dataclass(frozen=True, repr=False)
class SuiteResult(ShortRepr):
    """Statistics of all records at one level.

    mean_ratio: None where a record overturned; max_ratio: of the records that did not overturn. median_ratio,
    p84_ratio: not exceeded by 50 % and 84 % of the records, an overturned one counting as the largest; None where that
    record overturned. figures: to how many significant figures, one at least, these stand in the nine runs of the
    records.
    """

    level_pga_g: float
    n: int
    overturned: int
    mean_ratio: float | None
    max_ratio: float | None
    median_ratio: float | None = None
    p84_ratio: float | None = None
    figures: int = 4


@dataclass(frozen=True, repr=False)
class EnvelopeResult(ShortRepr):
    """Which pulses of the ground overturn a mechanism, in the worse polarity, by n frequencies and m amplitudes.

    gamma, nu_rad: of a mavroeidis-papageorgiou pulse, else None. overturned [n][m]: one row for each frequency.
    lower_bound_g [n]: least amplitude that overturns, None if none up to the highest does; polarity [n]: of that pulse,
    0 if there is none. islands [n]: number of amplitudes above the bound that do not overturn. uplift_g [n]: amplitude
    that starts rocking, 0 on joints without a threshold. factor [n]: amplification from the ground to the mechanism's
    base. omega [n]: 2 pi f / p; lower_bound_ratio [n]: factor times bound over g lambda, both of the linearised branch
    that uplifts first, for dimensionless plots. case: the case of a swept mechanism; empty for others.
    """

    shape: str
    gamma: float | None
    nu_rad: float | None
    equation: Literal["exact", "linearised"]
    frequency_hz: Floats
    amplitude_g: Floats
    overturned: tuple[tuple[bool, ...], ...]
    lower_bound_g: tuple[float | None, ...]
    polarity: tuple[int, ...]
    islands: tuple[int, ...]
    uplift_g: Floats
    factor: Floats
    omega: Floats
    lower_bound_ratio: tuple[float | None, ...]
    case: str = ""


@dataclass(frozen=True, repr=False)
class CriticalResult(ShortRepr):
    """The mechanism that the weakest pulse overturns, at each of n frequencies.

    mechanism [n]: None where nothing overturns; lower_bound_g [n]: its bound. runner_up [n]: the second; margin [n]:
    of its bound over the least, as a share of the least. near [n]: all with bounds within five percent of the least.
    """

    frequency_hz: Floats
    mechanism: tuple[str | None, ...]
    lower_bound_g: tuple[float | None, ...]
    runner_up: tuple[str | None, ...]
    margin: tuple[float | None, ...]
    near: tuple[tuple[str, ...], ...]
    bands: tuple[CriticalBand, ...]


@dataclass(frozen=True, repr=False)
class CriticalBand(ShortRepr):
    """Frequencies at which one mechanism is critical; None where nothing overturns."""

    mechanism: str | None
    from_hz: float
    to_hz: float
