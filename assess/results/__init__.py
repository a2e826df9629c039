"""What a run found, as one frozen tree: the content of results.json, field by field.

Units stand in the names. The tree is pure data: no clock, no job counts, so the same input gives the same bytes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from assess.codes.check import BranchName, Check, Outcome, Role
from assess.codes.verdict import Decision, Verdict
from assess.messages.message import Message

SCHEMA_VERSION = 2
Floats = tuple[float, ...]
Point = tuple[float, float]
Place = tuple[float, float, float]
Ring = tuple[Point, ...]
Lasting = Literal["to collapse", "to its end", "not shown"]


@dataclass(frozen=True)
class Program:
    """The program that made the results."""

    name: str
    version: str


@dataclass(frozen=True)
class Input:
    """One file that was read: path relative to the project file, and its SHA-256."""

    path: str
    sha256: str


@dataclass(frozen=True)
class SpectrumResult:
    """The site's elastic spectrum."""

    code: str
    parameters: dict[str, float | str]
    damping: float
    damping_rule: str
    clause: str
    pga_g: float
    period_s: Floats
    acceleration_g: Floats


@dataclass(frozen=True)
class RecordSpectrum:
    """Elastic response spectrum of a record after scaling, 5 % damping."""

    period_s: Floats
    acceleration_g: Floats


@dataclass(frozen=True)
class PrimaryPulse:
    """A pulse within a record, scaled as the record is: the shape that matches it best, or another local optimum.

    polarity: of the pulse, 1 or -1. energy_share: of the record's squared acceleration that the pulse explains.
    """

    shape: str
    frequency_hz: float
    amplitude_g: float
    start_s: float
    polarity: int
    energy_share: float


@dataclass(frozen=True)
class RecordResult:
    """A record as used: after scaling to the site's spectrum, before the factor of a level.

    mse: mean squared natural-log misfit to the target after scaling. trail: what was done to it, in order.
    """

    id: str
    path: str
    event: str
    station: str
    component: str
    dt_s: float
    npts: int
    pga_g: float
    scale_factor: float
    mse: float
    trail: tuple[str, ...]
    spectrum: RecordSpectrum
    primary_pulses: tuple[PrimaryPulse, ...] = ()
    date: str = ""
    magnitude: float | None = None
    distance_km: float | None = None
    vs30_m_per_s: float | None = None
    nga: int | None = None


@dataclass(frozen=True)
class EquivalentPeriods:
    """The shortest and longest equivalent period of a mechanism's branches, at the allowable rotation."""

    mechanism: str
    shortest_s: float
    longest_s: float


@dataclass(frozen=True)
class Remaining:
    """How many candidates were left after a step of the selection."""

    step: str
    number: int


@dataclass(frozen=True)
class SelectionResult:
    """How the suite was chosen. misfit: of the suite's mean spectrum to the target; greedy_misfit: before exchanges."""

    fit: Literal["suite", "each"]
    components: Literal["single", "together"]
    one_per_event: bool
    least_factor: float
    largest_factor: float
    remaining: tuple[Remaining, ...]
    misfit: float
    greedy_misfit: float | None


@dataclass(frozen=True)
class RequirementResult:
    """What a code asks of the suite, what was found, and its verdict; from_s, to_s: periods it was taken over.

    caveat: what the clause could not be compared with.
    """

    code: str
    clause: str
    what: str
    value: float | None
    sense: Literal[">=", "<="]
    limit: float
    unit: str
    verdict: Literal["met", "not met", "not answered"]
    from_s: float | None
    to_s: float | None
    remark: str
    caveat: str


@dataclass(frozen=True)
class GroundMotionResult:
    """The suite of records beside its target, 5 % damping.

    from_s, to_s: periods over which it was scaled and chosen; source: of that range, in words. mean_g,
    geometric_mean_g, target_g [k]: at period_s; misfit: of the mean to the target over the range, mean squared
    difference of natural logarithms.
    selection: None where all records that were named are used.
    """

    from_s: float
    to_s: float
    source: str
    equivalent_periods: tuple[EquivalentPeriods, ...]
    period_s: Floats
    target_g: Floats
    mean_g: Floats
    geometric_mean_g: Floats
    misfit: float
    selection: SelectionResult | None
    requirements: tuple[RequirementResult, ...]


@dataclass(frozen=True)
class NamedPoint:
    """A hinge or another named place in the plane of motion: distance along the direction, elevation [m]."""

    name: str
    at: Point


@dataclass(frozen=True)
class DrawnLoad:
    """A load in the plane of motion: where it acts [m], and the unit vector it pushes or pulls along.

    towards is None for a mass that is not bearing: it has no force at rest.
    """

    name: str
    at: Point
    kind: Literal["mass", "force", "tie"]
    towards: Point | None


@dataclass(frozen=True)
class Displaced:
    """The mechanism after a rotation of its leading block, as seen in the plane of motion, not mirrored [m].

    blocks, loads and centroids follow the order of the drawing at rest; hinges are those of the branch that turns, and
    block_of tells its blocks.
    """

    rotation_rad: float
    blocks: tuple[Ring, ...]
    block_of: tuple[int, ...]
    hinges: tuple[NamedPoint, ...]
    loads: tuple[DrawnLoad, ...]
    centroids: tuple[Point, ...]


@dataclass(frozen=True)
class Drawing:
    """The mechanism in its plane of motion, to scale [m]: closed outlines of the blocks, hinges, loads, centroid.

    block_of: the block of the positive branch that each outline belongs to, from 0 at the base, -1 where it does not
    move (an arch may join other voussoirs to blocks each way); centroids: of each block; displaced and
    displaced_negative: turned to either side, far enough to be seen and no farther than overturning; fixed: outlines of
    masonry that stays, as what lies under a cut.
    """

    blocks: tuple[Ring, ...]
    hinges: tuple[NamedPoint, ...]
    loads: tuple[DrawnLoad, ...]
    centroid: Point
    block_of: tuple[int, ...]
    centroids: tuple[Point, ...]
    displaced: Displaced
    displaced_negative: Displaced | None
    fixed: tuple[Ring, ...]


@dataclass(frozen=True)
class Axis:
    """The axis of rotation at a hinge: its two ends [m]."""

    name: str
    ends: tuple[Place, Place]


@dataclass(frozen=True)
class View:
    """The bodies of a mechanism in space [m], simplified and rounded for drawing; not for calculation.

    triangles: indices into vertices, anticlockwise seen from outside; block_of: the block that each triangle belongs
    to, from 0 at the base, -1 where it does not move. sections: closed rings where cuts pass through the masonry.
    size: of the bounding box across x, y, z. given: how many triangles the bodies have before they are simplified.
    """

    vertices: tuple[Place, ...]
    triangles: tuple[tuple[int, int, int], ...]
    block_of: tuple[int, ...]
    axes: tuple[Axis, ...]
    sections: tuple[tuple[Place, ...], ...]
    direction: Place
    size: Place
    given: int


@dataclass(frozen=True)
class LinearisedResult:
    """Kinematic constants of a branch linearised at critical_rad (thesis 3.4-3.12): I, K, B, M, phi_cr, phi_ov.

    uplift_multiplier: lambda of 3.11, to which thesis tables refer; the exact one stands beside it in the oscillator.
    """

    inertia_kg_m2: float
    stiffness_n_m_per_rad: float
    excitation_kg_m: float
    moment_n_m: float
    critical_rad: float
    overturning_rad: float
    uplift_multiplier: float


@dataclass(frozen=True)
class OscillatorResult:
    """Rocking parameters of one branch."""

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


@dataclass(frozen=True)
class BranchCurve:
    """The capacity curve of one branch, all positive."""

    rotation_rad: Floats
    inertia_kg_m2: Floats
    restoring_n_m: Floats
    excitation_kg_m: Floats
    participating_mass_kg: Floats
    displacement_m: Floats


@dataclass(frozen=True)
class Curve:
    """Both branches of the capacity curve."""

    positive: BranchCurve
    negative: BranchCurve | None


@dataclass(frozen=True)
class Factor:
    """What a record was multiplied by for its way up the building."""

    record: str
    factor: float


@dataclass(frozen=True)
class CarriedMotion:
    """The record that is amplified most, scaled to the target: at the ground and at the mechanism's base.

    Response spectra [k] of 5 % damping.
    """

    record: str
    time_s: Floats
    ground_acceleration_g: Floats
    base_acceleration_g: Floats
    period_s: Floats
    ground_spectrum_g: Floats
    base_spectrum_g: Floats


@dataclass(frozen=True)
class AmplificationResult:
    """How the motion was carried from the ground to the mechanism.

    height_m: of its base above the ground, None where nothing is amplified. said: what is done, with which numbers and
    assumptions. motion: where the motion is filtered, not only multiplied.
    """

    method: str
    factors: tuple[Factor, ...]
    height_m: float | None = None
    said: tuple[Message | str, ...] = ()
    motion: CarriedMotion | None = None


@dataclass(frozen=True)
class Trace:
    """A rocking history at the steps of the motion that drove it: signed rotation, ground acceleration.

    base_acceleration_g: what drove it, at the base of the mechanism; None where that is the ground's motion.
    """

    time_s: Floats
    rotation_rad: Floats
    ground_acceleration_g: Floats
    base_acceleration_g: Floats | None = None


@dataclass(frozen=True)
class HistoryResult:
    """Largest rocking response to one record at one level, in the worse polarity.

    max_rotation_rad is signed; it, its ratio and its time are None where the record overturned the mechanism.
    overturning_time_s: when the rotation passed phi_ov for the last time. branch: where the largest rotation was.
    rebound: times the restitution of the mechanism, with which this history was worst; 1 where no range was run.
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
    trace: Trace | None
    branch: BranchName
    rebound: float = 1.0


@dataclass(frozen=True)
class SuiteResult:
    """All records at one level; mean_ratio is None where a record overturned, max_ratio is over those that stood.

    median_ratio, p84_ratio: rotations that half and 84 % of the records do not exceed, an overturned one counting as
    the largest; None where such a record overturned.
    """

    level_pga_g: float
    n: int
    overturned: int
    mean_ratio: float | None
    max_ratio: float | None
    median_ratio: float | None = None
    p84_ratio: float | None = None


@dataclass(frozen=True)
class LoadResult:
    """A load as used: a mass, bearing or not, or the force (along the direction, up) of a force or tie at rest.

    at: distance along the direction, elevation [m]; source: how it was found, or "given". lasting: how long a force or
    tie is shown to be there, where it resists on some branch: to collapse, to its end on the way (at a rotation, where
    its point has moved by end_m), or not at all, for want of the keys `missing`; None where it only drives. A tie that
    lasts has an end too where its fracture strain is reached beyond collapse. seat_m: of a bearing mass.
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


@dataclass(frozen=True)
class DirectionSweep:
    """What resists rotation towards each direction, where the weakest was sought.

    angle_deg [n]: from +x towards +y, rising; uplift_multiplier [n]: at rest; weakest_deg: the angle chosen, the
    smallest of the least multiplier; variation: 1 - least / largest multiplier; flat_deg: how much of the circle is
    within one percent of the least.
    """

    angle_deg: Floats
    uplift_multiplier: Floats
    p_eq_per_s: Floats
    overturning_rad: Floats
    weakest_deg: float
    variation: float
    flat_deg: float


@dataclass(frozen=True)
class DirectionCandidate:
    """A direction towards which a mechanism may topple.

    angle_deg: from +x towards +y; uplift_multiplier: at rest, None where it cannot rock that way; d0_m: displacement of
    the control point where it overturns, of the weakest only; touching: the bodies that stop it.
    """

    angle_deg: float
    uplift_multiplier: float | None
    d0_m: float | None
    touching: tuple[str, ...]


@dataclass(frozen=True)
class BranchMoment:
    """A moment-rotation curve."""

    rotation_rad: Floats
    restoring_n_m: Floats


@dataclass(frozen=True)
class InterfaceCurves:
    """Moments of the positive branch by simpler interfaces, to set beside its own: rigid, and hinges fixed at a_SF."""

    rigid: BranchMoment
    fixed_hinges: BranchMoment


@dataclass(frozen=True)
class EnvelopeResult:
    """Which pulses of the ground overturn a mechanism, in the worse polarity, by n frequencies and m amplitudes.

    gamma, nu_rad: of a mavroeidis-papageorgiou pulse, else None. overturned [n][m]: one row for each frequency.
    lower_bound_g [n]: the least amplitude that overturns, None where none up to the highest does; polarity [n]: of that
    pulse, 0 where there is none. islands [n]: how many of the amplitudes above the bound the mechanism stands.
    uplift_g [n]: amplitude that starts rocking, 0 on joints without a threshold. factor [n]: amplification from the
    ground to the mechanism's base. omega [n]: 2 pi f / p; lower_bound_ratio [n]: factor times bound over g lambda, both
    of the linearised branch that uplifts first, to be read on dimensionless plots. case: of a swept mechanism, the case
    that it is of; empty for others.
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


@dataclass(frozen=True)
class CriticalBand:
    """Frequencies at which one mechanism is critical; None where nothing overturns."""

    mechanism: str | None
    from_hz: float
    to_hz: float


@dataclass(frozen=True)
class CriticalResult:
    """The mechanism that the weakest pulse overturns, at each of n frequencies.

    mechanism [n]: None where nothing overturns; lower_bound_g [n]: its bound. runner_up [n]: the second, margin [n]:
    how much more it needs, as a share of the least. near [n]: all that need at most five percent more than the least.
    """

    frequency_hz: Floats
    mechanism: tuple[str | None, ...]
    lower_bound_g: tuple[float | None, ...]
    runner_up: tuple[str | None, ...]
    margin: tuple[float | None, ...]
    near: tuple[tuple[str, ...], ...]
    bands: tuple[CriticalBand, ...]


@dataclass(frozen=True)
class HingeForceResult:
    """What a hinge passes on when its mechanism starts to rock, at the ground acceleration activation_g.

    horizontal_n, vertical_n: on the block that presses, along the branch's own direction and up; normal_n, shear_n:
    square to its faces (compression positive) and along them; face: unit vector (along, up) square to the faces, to
    that block; face_found: false where the geometry has no faces there and they are taken level.
    needed_friction: |shear_n| / normal_n, None where nothing presses; friction: of the joint, None where not known.
    sliding_g: the ground acceleration that slides it before it rocks, None where it rocks first or friction is not
    known. held: whether a support holds it besides friction, as it does the top of a wall.
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


@dataclass(frozen=True)
class MechanismResult:
    """Everything about one mechanism; direction_sweep is None where its direction was not sought on a whole circle.

    oscillator, curve: with every action that is there at rest. deciding_curve: with those that are shown to last to
    collapse and those that drive, of which displacements and histories are asked, and to whose overturning rotations
    (of rigid joints, positive and negative) their ratios refer; None where both are the same, or where it falls at rest
    without the others.
    direction: of positive rotation, horizontal; None for an equivalent block. candidates: the directions among which
    the weakest was found, or with which a given one was compared. base_elevation_m: of its base over the ground;
    input_height_m: of what holds it, the mean of base and far support where it is held twice; above_ground: whether
    that counts as above the ground; ground_known_from: what says where the ground is.
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
    curve: Curve
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
    deciding_curve: Curve | None = None
    deciding_overturning_rad: tuple[float, float | None] | None = None
    direction: tuple[float, float, float] | None = None
    candidates: tuple[DirectionCandidate, ...] = ()
    base_elevation_m: float | None = None
    input_height_m: float | None = None
    above_ground: bool | None = None
    ground_known_from: str = ""


@dataclass(frozen=True)
class SweepResult:
    """One mechanism for several values of one number of the project.

    value [n]: in `unit`, as the user wrote it, "-" for none. Parameters [n]: of the branch that uplifts first;
    overturning_rad of rigid joints, overturning_flexible_rad and elastic_frequency_hz on its own, None where rigid.
    demand_capacity [n]: the largest of the checks that decide, and capacity_pga_g [n] the least; where none decides, of
    all checks by the letter of a code at all levels; None where the mechanism overturned (overturned is true) or none
    is answered. outcome [n]: the verdict of the mechanism in each case. controlling: the case that is worst, from 0.
    governs: whether that case stands for the mechanism in `mechanisms` and in the comparison, as the worst of
    the mechanism's sweeps does.
    """

    mechanism: str
    key: str
    unit: str
    value: Floats
    p_eq_per_s: Floats
    uplift_multiplier: tuple[float | None, ...]
    overturning_rad: Floats
    overturning_flexible_rad: tuple[float | None, ...]
    elastic_frequency_hz: tuple[float | None, ...]
    restitution: Floats
    demand_capacity: tuple[float | None, ...]
    overturned: tuple[bool, ...]
    capacity_pga_g: tuple[float | None, ...]
    outcome: tuple[Decision, ...]
    controlling: int
    governs: bool


@dataclass(frozen=True)
class SensitivityResult:
    """One answer of a mechanism with one number at its low and at its high value, all others as they are.

    parameter : thickness, density, …; key : where it stands in the project, or the bodies it is of
    base, low, high : of the parameter [unit], None where it is not varied, for which `remark` says why
    role : whether the procedure decides the limit state at this level
    quantity : "demand_capacity" at level_pga_g, None where the body overturns or nothing is known; "index" of what
        decides, named by `index`; or "capacity_pga_g", of all levels, which procedures by histories do not have here;
        "" where nothing is varied
    """

    mechanism: str
    parameter: str
    remark: str
    key: str = ""
    unit: str = ""
    base: float | None = None
    low: float | None = None
    high: float | None = None
    procedure: str = ""
    limit_state: str = ""
    level_pga_g: float | None = None
    quantity: Literal["index", "capacity_pga_g", "demand_capacity", ""] = ""
    at_base: float | None = None
    at_low: float | None = None
    at_high: float | None = None
    verdict_base: Outcome | None = None
    verdict_low: Outcome | None = None
    verdict_high: Outcome | None = None
    role: Role = "comparison"
    index: str = ""


@dataclass(frozen=True)
class ComparisonRow:
    """One line of the comparison; rotation_ratio is None where the mechanism overturned or rotation is not known."""

    mechanism: str
    level_pga_g: float
    procedure: str
    rotation_ratio: float | None
    allowable_ratio: float | None
    demand_capacity: float | None


@dataclass(frozen=True)
class Resolved:
    """One value of the project as it was used: in SI, and whether the user gave it or it is a default."""

    value: Any
    given: bool


@dataclass(frozen=True)
class Results:
    """One run, whole.

    project : maps each key, written with dots, to its resolved value
    stamp : of the inputs and the program, the same in every output made of these results; "" of earlier programs
    """

    schema_version: int
    program: Program
    inputs: tuple[Input, ...]
    warnings: tuple[Message, ...]
    project: dict[str, Resolved]
    spectrum: SpectrumResult | None
    records: tuple[RecordResult, ...]
    mechanisms: tuple[MechanismResult, ...]
    critical: CriticalResult | None
    comparison: tuple[ComparisonRow, ...]
    sweeps: tuple[SweepResult, ...]
    verdict: Verdict | None = None
    ground_motion: GroundMotionResult | None = None
    sensitivity: tuple[SensitivityResult, ...] = ()
    stamp: str = ""
