"""Tables of a mechanism: rocking parameters, loads, forces at its hinges."""

from __future__ import annotations

from operator import attrgetter

from assess.messages.message import Quantity
from assess.results import HingeForceResult, MechanismResult, OscillatorResult
from reports.chapters.cells import NONE
from reports.document import Cell, Column, Table
from reports.language.texts import Listing, Phrase, Term, Verbatim, say

LIFTS, NOT_GIVEN, ROCKS_FIRST = say("lifts"), say("not given"), say("rocks first")
PARAMETERS: tuple[tuple[str, Phrase, str, str], ...] = (
    ("mass_kg", say("Moved mass"), "M", "mass"),
    ("inertia_kg_m2", say("Moment of inertia about the hinge"), "I", "inertia"),
    ("radius_m", say("Radius of the equivalent block"), "R", "length"),
    ("slenderness_rad", say("Slenderness of the equivalent block"), "α", "rotation"),
    ("p_eq_per_s", say("Frequency parameter"), "p", "angular frequency"),
    ("uplift_multiplier", say("Load multiplier at uplift"), "λ", "ratio"),
    ("overturning_rad", say("Overturning rotation, rigid"), "φₒᵥ", "rotation"),
    ("overturning_flexible_rad", say("Overturning rotation on its joints, from rest"), "", "rotation"),
    ("equilibrium_rad", say("Rotation at rest"), "φₑ", "rotation"),
    ("elastic_frequency_hz", say("Frequency of small motions about rest"), "", "frequency"),
    ("restitution", say("Coefficient of restitution"), "η", "ratio"),
    ("critical_rad", say("Rotation about which the equation is linearised"), "φ_cr", "rotation"),
    ("linearised.inertia_kg_m2", say("Linearised: inertia"), "I", "inertia"),
    ("linearised.stiffness_n_m_per_rad", say("Linearised: stiffness"), "K", "rotational stiffness"),
    ("linearised.excitation_kg_m", say("Linearised: excitation"), "B", "first moment"),
    ("linearised.moment_n_m", say("Linearised: moment of the applied forces"), "M", "moment"),
    ("linearised.overturning_rad", say("Linearised: overturning rotation"), "φₒᵥ = φ_cr − M/K", "rotation"),
    ("linearised.uplift_multiplier", say("Linearised: load multiplier"), "λ = K φₒᵥ / (g B)", "ratio"),
)
"""The way to each parameter in `OscillatorResult`, what it is called, its symbol and dimension."""


def parameters(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the rocking parameters of both branches."""
    columns: tuple[Column, ...] = (
        Column(say("Parameter")),
        Column(say("Symbol"), share=0.2),
        Column(say("Positive branch"), share=0.18),
        Column(say("Negative branch"), share=0.18),
    )
    branches = (mechanism.oscillator, mechanism.oscillator_negative)
    rows: tuple[tuple[Cell, ...], ...] = tuple(
        (label, Verbatim(symbol), *(parameter_cell(branch, key, dimension) for branch in branches))
        for key, label, symbol, dimension in PARAMETERS
    )
    caption = say("Rocking parameters of each branch, that is, of each direction of rotation.")
    if mechanism.oscillator_negative is None:
        columns, rows = columns[:3], tuple(row[:3] for row in rows)
        caption = say("Rocking parameters. The mechanism rocks to one side only.")
    return Table(name, caption, columns, rows, small=True)


def parameter_cell(branch: OscillatorResult | None, key: str, dimension: str) -> Cell:
    """Return a parameter of a branch with its unit; "none" where joints have no threshold of uplift."""
    if branch is None:
        return None
    value: float | None = attrgetter(key)(branch)
    if value is None:
        return NONE if key == "uplift_multiplier" else None
    return Quantity(value, dimension)


def loads(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the loads of each block and their source."""
    columns = (
        Column(say("Load"), share=0.22),
        Column(say("x"), "length"),
        Column(say("z"), "length"),
        Column(say("Mass"), "mass"),
        Column(say("Bearing")),
        Column(say("Force along"), "force"),
        Column(say("Force up"), "force"),
        Column(say("Found"), share=0.22),
    )
    rows = tuple(
        (
            Verbatim(load.name),
            *(round(each, 9) + 0.0 for each in load.at),
            load.mass_kg,
            load.bearing,
            *(load.force_n or (None, None)),
            Listing(load.found or (Term(load.source),), ""),
        )
        for load in mechanism.loads
    )
    caption = say(
        "Loads, at x along the direction of motion and elevation z; forces along the direction and up. The weight of a "
        "non-bearing mass is carried elsewhere: only its horizontal inertia acts on the block."
    )
    return Table(name, caption, columns, rows, small=True)


def hinge_forces(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the forces at each hinge when the mechanism starts to rock, and the friction that they need."""
    columns = (
        Column(say("Hinge")),
        Column(say("Rocks from"), "ground acceleration"),
        Column(Verbatim("H"), "force"),
        Column(Verbatim("V"), "force"),
        Column(Verbatim("N"), "force"),
        Column(Verbatim("T"), "force"),
        Column(say("Friction needed"), "ratio", figures=3),
        Column(say("Friction"), "ratio", figures=3),
        Column(say("Slides from"), "ground acceleration"),
        Column(say("Remark"), share=0.2),
    )
    rows = tuple(
        (
            Verbatim(f.hinge),
            f.activation_g,
            f.horizontal_n,
            f.vertical_n,
            f.normal_n,
            f.shear_n,
            *_friction(f),
            _held(f),
        )
        for f in mechanism.hinge_forces
    )
    caption = say(
        "Forces at the hinges when rocking starts, from equilibrium of the blocks: on the block that presses, H along "
        "the direction of the branch and V upwards, N normal to its faces and T along them. The mechanism slides "
        "before it rocks where |T| / N exceeds the friction of the joint."
    )
    return Table(name, caption, columns, rows, small=True)


def _friction(forces: HingeForceResult) -> tuple[Cell, Cell, Cell]:
    """Return friction needed, friction available, and the acceleration that slides the hinge or why there is none."""
    needed: Cell = LIFTS if forces.needed_friction is None else forces.needed_friction
    if forces.friction is None:
        return needed, NOT_GIVEN, None
    return needed, forces.friction, ROCKS_FIRST if forces.sliding_g is None else forces.sliding_g


def _held(forces: HingeForceResult) -> Cell:
    if forces.held:
        return say("held at the top, by friction or an anchorage")
    return None if forces.face_found else say("faces taken as level")
