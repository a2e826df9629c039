"""Tables of a mechanism: rocking parameters, loads, forces at its hinges, capacity curves."""

from __future__ import annotations

from operator import attrgetter

from assess.results import BranchCurve, HingeForceResult, MechanismResult, OscillatorResult, Results
from reports.chapters.check_tables import MECHANISM, uplift_cell
from reports.document import Cell, Column, Table

LIFTS, NOT_GIVEN, ROCKS_FIRST = "lifts", "not given", "rocks first"
PARAMETERS: tuple[tuple[str, str, str], ...] = (
    ("mass_kg", "Moved mass, M", "kg"),
    ("inertia_kg_m2", "Moment of inertia about the hinge, I", "kg m²"),
    ("radius_m", "Radius of the equivalent block, R", "m"),
    ("slenderness_rad", "Slenderness of the equivalent block, α", "rad"),
    ("p_eq_per_s", "Frequency parameter, p", "1/s"),
    ("uplift_multiplier", "Load multiplier at uplift, λ", "-"),
    ("overturning_rad", "Overturning rotation, rigid, φₒᵥ", "rad"),
    ("overturning_flexible_rad", "Overturning rotation on its joints, from rest", "rad"),
    ("equilibrium_rad", "Rotation at rest, φₑ", "rad"),
    ("elastic_frequency_hz", "Frequency of small motions about rest", "Hz"),
    ("restitution", "Coefficient of restitution, η", "-"),
    ("critical_rad", "Rotation about which the equation is linearised, φ_cr", "rad"),
    ("linearised.inertia_kg_m2", "Linearised: inertia, I", "kg m²"),
    ("linearised.stiffness_n_m_per_rad", "Linearised: stiffness, K", "N m/rad"),
    ("linearised.excitation_kg_m", "Linearised: excitation, B", "kg m"),
    ("linearised.moment_n_m", "Linearised: moment of the given forces, M", "N m"),
    ("linearised.overturning_rad", "Linearised: overturning rotation, φₒᵥ = φ_cr − M/K", "rad"),
    ("linearised.uplift_multiplier", "Linearised: load multiplier, λ = K φₒᵥ / (g B)", "-"),
)


def parameters(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the rocking parameters of both branches."""
    columns = (
        Column("Parameter"),
        Column("Unit"),
        Column("Positive", kind="number"),
        Column("Negative", kind="number"),
    )
    rows = tuple(
        (label, unit, *(_parameter(branch, key) for branch in (mechanism.oscillator, mechanism.oscillator_negative)))
        for key, label, unit in PARAMETERS
    )
    one_sided = "" if mechanism.oscillator_negative is not None else " It rocks to one side only: no negative branch."
    return Table(name, f"Rocking parameters of each branch (direction of rotation).{one_sided}", columns, rows)


def _parameter(branch: OscillatorResult | None, key: str) -> Cell:
    if branch is not None and key == "uplift_multiplier":
        return uplift_cell(branch.uplift_multiplier)
    value: float | None = None if branch is None else attrgetter(key)(branch)
    return value


def loads(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the loads of each block and their source."""
    columns = (
        Column("Load"),
        Column("x", "m", "number"),
        Column("z", "m", "number"),
        Column("Mass", "kg", "number"),
        Column("Bearing", kind="given"),
        Column("Force along", "N", "number"),
        Column("Force up", "N", "number"),
        Column("Found"),
    )
    rows = tuple(
        (
            load.name,
            *(round(each, 9) + 0.0 for each in load.at),
            load.mass_kg,
            load.bearing,
            *(load.force_n or (None, None)),
            load.source,
        )
        for load in mechanism.loads
    )
    caption = (
        "Loads, at x along the direction of motion and elevation z; forces along the direction and up. "
        "The weight of a non-bearing mass is carried elsewhere: only its horizontal inertia acts on the "
        "block."
    )
    return Table(name, caption, columns, rows)


def hinge_forces(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the forces at each hinge when the mechanism starts to rock, and the friction that they need."""
    columns = (
        Column("Hinge"),
        Column("Rocks from", "g", "number"),
        Column("H", "N", "number"),
        Column("V", "N", "number"),
        Column("N", "N", "number"),
        Column("T", "N", "number"),
        Column("Friction needed", "-", "number"),
        Column("Friction", "-", "given"),
        Column("Slides from", "g", "number"),
        Column("Remark"),
    )
    rows = tuple(
        (f.hinge, f.activation_g, f.horizontal_n, f.vertical_n, f.normal_n, f.shear_n, *_friction(f), _held(f))
        for f in mechanism.hinge_forces
    )
    caption = (
        "Forces at the hinges when rocking starts, from equilibrium of the blocks: on the block that "
        "presses, H along the direction of the branch and V upwards, N normal to its faces and T along "
        "them. The mechanism slides before it rocks where |T| / N exceeds the friction of the joint; the "
        "ground acceleration at which it slides is then given too."
    )
    return Table(name, caption, columns, rows)


def _friction(forces: HingeForceResult) -> tuple[Cell, Cell, Cell]:
    """Return friction needed, friction available, and the acceleration that slides the hinge or why there is none."""
    needed: Cell = LIFTS if forces.needed_friction is None else forces.needed_friction
    if forces.friction is None:
        return needed, NOT_GIVEN, None
    return needed, forces.friction, ROCKS_FIRST if forces.sliding_g is None else forces.sliding_g


def _held(forces: HingeForceResult) -> str:
    held = "held at the top, by friction or an anchorage" if forces.held else ""
    return held or ("" if forces.face_found else "faces taken level")


def curves(results: Results) -> Table:
    """Tabulate the capacity curves of every mechanism, point by point."""
    columns = (
        MECHANISM,
        Column("Branch"),
        Column("Rotation", "rad", "number"),
        Column("Inertia", "kg m²", "number"),
        Column("Restoring moment", "N m", "number"),
        Column("Excitation", "kg m", "number"),
        Column("Participating mass", "kg", "number"),
        Column("Displacement", "m", "number"),
    )
    rows: list[tuple[Cell, ...]] = []
    for mechanism in results.mechanisms:
        rows += [(mechanism.name, "positive", *point) for point in _points(mechanism.curve.positive)]
        if mechanism.curve.negative is not None:
            rows += [(mechanism.name, "negative", *point) for point in _points(mechanism.curve.negative)]
    return Table("capacity-curves", "Capacity curves of both branches.", columns, tuple(rows))


def _points(curve: BranchCurve) -> list[tuple[float, ...]]:
    quantities = (curve.inertia_kg_m2, curve.restoring_n_m, curve.excitation_kg_m)
    return list(zip(curve.rotation_rad, *quantities, curve.participating_mass_kg, curve.displacement_m, strict=True))
