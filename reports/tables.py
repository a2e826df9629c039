"""The tables of the assessment: every number is taken from the results as it stands there."""

from __future__ import annotations

import re
from dataclasses import replace
from operator import attrgetter

from assess.codes.check import NO_LASTING as UNLASTING
from assess.codes.check import Check
from assess.results import (
    BranchCurve,
    ComparisonRow,
    HingeForceResult,
    HistoryResult,
    MechanismResult,
    OscillatorResult,
    RecordResult,
    RecordSpectrum,
    Results,
    SpectrumResult,
    SuiteResult,
)
from reports import governing, spectrum_parameters
from reports.document import Cell, Column, Table
from reports.numerals import bounded, entries, given

OVERTURNED, NO_ROCKING, NO_LASTING, NONE = "overturned", "no rocking", "none lasting", "none"
_INDEX, _YEARS = Column("Safety index", "-", "number"), Column("Return period", "years", "number")
LIFTS, NOT_GIVEN, ROCKS_FIRST = "lifts", "not given", "rocks first"
_MECHANISM, _LEVEL, _PROCEDURE = Column("Mechanism"), Column("PGA", "g", "number"), Column("Procedure")

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


def name_of(mechanism: MechanismResult) -> str:
    """What the mechanism is called in the report: its label, or its name."""
    return mechanism.label or mechanism.name


def brief(results: Results) -> Table:
    """One line per mechanism and level: the verdict of each procedure that decides, and the largest ratio."""
    deciding = dict.fromkeys(c.procedure for m in results.mechanisms for c in governing.of_code(m.checks))
    columns = (_MECHANISM, _LEVEL, *(Column(_broken(name), kind="verdict") for name in deciding))
    columns += (Column("Largest ratio", "-", "number"), Column("Verdict", kind="verdict"))
    rows: list[tuple[Cell, ...]] = []
    for mechanism in results.mechanisms:
        for level in governing.levels(mechanism.checks):
            checks = governing.of_code(governing.at_level(mechanism.checks, level))
            each = (governing.verdict(tuple(c for c in checks if c.procedure == name)) for name in deciding)
            asked = {check.procedure for check in checks}
            cells = tuple(v if name in asked else None for name, v in zip(deciding, each, strict=True))
            rows.append((name_of(mechanism), level, *cells, _largest(checks), governing.verdict(checks)))
    caption = "Verdicts of the code procedures; the largest ratio is demand over allowable of the worst of them."
    return Table("summary", caption, columns, tuple(rows))


def verdicts(results: Results) -> Table:
    """Every check of every mechanism: demand, allowable, ratio, verdict."""
    pairs = [(mechanism, check) for mechanism in results.mechanisms for check in mechanism.checks]
    columns = (
        _MECHANISM,
        _LEVEL,
        _PROCEDURE,
        Column("Quantity, unit"),
        Column("Demand", kind="number"),
        Column("Allowable", kind="number"),
        Column("Ratio", "-", "number"),
        Column("Verdict", kind="verdict"),
        Column("Role"),
        Column("Input at"),
    )
    rows = tuple(
        (name_of(mechanism), check.level_pga_g, *_answer(check, mechanism.checks)) for mechanism, check in pairs
    )
    muted = frozenset(place for place, (_, check) in enumerate(pairs) if check.role == "informative")
    caption = "Demand, allowable, ratio and verdict of every check. Informative readings (grey) decide nothing."
    return Table("verdicts", caption, columns, rows, muted)


def inputs(results: Results) -> Table:
    """The files that were read."""
    rows = tuple((each.path, each.sha256) for each in results.inputs)
    return Table("inputs", "Files read, and their SHA-256.", (Column("File"), Column("SHA-256")), rows)


def values(results: Results, *, name: str = "values") -> Table:
    """Every value of the project as it was used."""
    columns = (Column("Key", kind="given"), Column("Value (SI)", kind="given"), Column("Source"))
    rows = tuple(
        (entry, cell, "given" if each.given else "default")
        for key, each in results.project.items()
        for entry, cell in entries(key, each.value)
    )
    muted = frozenset(place for place, (_, _, source) in enumerate(rows) if source == "default")
    caption = "Every value of the project file as it was used, in SI units; defaults (grey) were not given by the user."
    return Table(name, caption, columns, rows, muted)


def values_set(results: Results) -> Table:
    """The same without what is absent: keys that were not given and have no default."""
    project = {key: each for key, each in results.project.items() if each.given or each.value not in (None, "", [], {})}
    return values(replace(results, project=project), name="values-set")


def warnings(results: Results) -> Table:
    """What the engineer should know."""
    rows = tuple((each.code, each.where, each.text) for each in results.warnings)
    columns = (Column("Code", kind="given"), Column("Where", kind="given"), Column("What"))
    return Table("warnings", "Warnings of this run.", columns, rows)


def procedures(results: Results) -> Table:
    """Each procedure with its edition, role, where its input acts, damping, and what could not be compared, once."""
    checks = (check for mechanism in results.mechanisms for check in mechanism.checks)
    rows = dict.fromkeys(
        (check.procedure, check.edition, check.limit_state, check.role, check.input_at, _remark(check))
        for check in checks
    )
    columns = (
        _PROCEDURE,
        Column("Edition"),
        Column("Limit state"),
        Column("Role"),
        Column("Input at"),
        Column("Remark"),
    )
    return Table("procedures", "Procedures, their editions and roles.", columns, tuple(rows))


def site(results: Results) -> Table:
    """What the site's spectrum was made from."""
    spectrum = results.spectrum
    rows: tuple[tuple[Cell, ...], ...] = ()
    if spectrum is not None:
        rows = (
            ("code", "-", spectrum.code),
            ("clause", "-", spectrum.clause),
            *spectrum_parameters.named(spectrum.parameters),
            ("damping ratio", "-", given(spectrum.damping)),
            ("other damping", "-", spectrum.damping_rule),
            ("peak ground acceleration, Sₐ(0)", "g", spectrum.pga_g),
        )
    columns = (Column("Parameter"), Column("Unit"), Column("Value"))
    return Table("site", "The site's elastic response spectrum.", columns, rows)


def records(results: Results) -> Table:
    """The records as scaled to the site's spectrum."""
    columns = (
        Column("Record"),
        Column("Event"),
        Column("NGA", kind="given"),
        Column("Magnitude", kind="given"),
        Column("Component"),
        Column("Step", "s", "given"),
        Column("Samples", kind="number"),
        Column("Misfit", "-", "number"),
        Column("Scale factor", "-", "number"),
        Column("PGA, scaled", "g", "number"),
    )
    rows = tuple(
        (r.id, event_of(r), r.nga, r.magnitude, r.component, r.dt_s, r.npts, r.mse, r.scale_factor, r.pga_g)
        for r in results.records
    )
    caption = (
        "Records, scaled to the site's spectrum (as thesis Table 8.8). Misfit: mean squared difference of the "
        "logarithms of the ordinates."
    )
    return Table("records", caption, columns, rows)


def event_of(record: RecordResult) -> str:
    """The earthquake with its year, where that is known and not part of its name."""
    year = record.date[:4]
    return record.event if year in record.event else f"{record.event} {year}".strip()


def trails(results: Results) -> Table:
    """What was done to each record."""
    columns = (Column("Record"), Column("Station"), Column("File"), Column("Processing, in order"))
    rows = tuple((record.id, record.station, record.path, "; ".join(record.trail)) for record in results.records)
    return Table("processing", "Origin and processing of the records.", columns, rows)


def parameters(mechanism: MechanismResult, *, name: str) -> Table:
    """The rocking parameters of both branches."""
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


def loads(mechanism: MechanismResult, *, name: str) -> Table:
    """What each block carries or is pulled by, and how that was found."""
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
        (load.name, *load.at, load.mass_kg, load.bearing, *(load.force_n or (None, None)), load.source)
        for load in mechanism.loads
    )
    caption = (
        "Loads, at x along the direction of motion and elevation z; forces along the direction and up. A mass that is "
        "not bearing has its weight carried elsewhere: only its horizontal inertia acts on the block."
    )
    return Table(name, caption, columns, rows)


def hinge_forces(mechanism: MechanismResult, *, name: str) -> Table:
    """What each hinge passes on when the mechanism starts to rock, and the friction that takes."""
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
        "Forces at the hinges when it starts to rock, by equilibrium of its blocks: on the block that presses, H along "
        "the branch’s own direction and V up, N square to its faces and T along them. It slides before it rocks where "
        "|T| / N is more than the friction of the joint; then also the ground acceleration from which it slides."
    )
    return Table(name, caption, columns, rows)


def _friction(forces: HingeForceResult) -> tuple[Cell, Cell, Cell]:
    """Friction needed and there is, and the acceleration that slides the hinge, or why there is none."""
    needed: Cell = LIFTS if forces.needed_friction is None else forces.needed_friction
    if forces.friction is None:
        return needed, NOT_GIVEN, None
    return needed, forces.friction, ROCKS_FIRST if forces.sliding_g is None else forces.sliding_g


def _held(forces: HingeForceResult) -> str:
    held = "held at the top, by friction or an anchorage" if forces.held else ""
    return held or ("" if forces.face_found else "faces taken level")


def demands(mechanism: MechanismResult, *, name: str) -> Table:
    """Every check of one mechanism: demand, allowable, ratio and verdict, and the accelerations it stands up to."""
    ratings = [_rating(check) for check in mechanism.checks]
    rated = [column for column in (_INDEX, _YEARS) if any(rating[column] is not None for rating in ratings)]
    columns = (
        _LEVEL,
        _PROCEDURE,
        Column("Quantity, unit"),
        Column("Demand", kind="number"),
        Column("Allowable", kind="number"),
        Column("Ratio", "-", "number"),
        Column("Rotation φ/φₒᵥ", "-", "number"),
        Column("PGA at uplift", "g", "number"),
        Column("PGA at capacity", "g", "number"),
        *rated,
        Column("Verdict", kind="verdict"),
    )
    rows = tuple(
        (*_demand(check, mechanism.checks), *(rating[column] for column in rated), check.verdict)
        for check, rating in zip(mechanism.checks, ratings, strict=True)
    )
    muted = frozenset(place for place, check in enumerate(mechanism.checks) if check.role == "informative")
    soft = any(check.uplift_pga_g is None for check in mechanism.checks)
    rating = " Safety index: PGA at capacity over that demanded; return period: of the capacity." if rated else ""
    return Table(
        name,
        "Demand, allowable, ratio and verdict of every check; the peak ground acceleration at uplift"
        f"{' (none: its joints answer to any motion)' * soft} and at capacity. "
        f"Informative readings (grey) decide nothing.{rating}",
        columns,
        rows,
        muted,
    )


def _rating(check: Check) -> dict[Column, Cell]:
    """What a check has where the code and the site know it."""
    return {_INDEX: check.safety_index, _YEARS: bounded(check.return_period_years, check.return_period_bound)}


def reasons(mechanism: MechanismResult, *, name: str) -> Table:
    """Why a check did not pass, for those that say so."""
    columns = (_PROCEDURE, Column("PGA", "g", "number"), Column("Verdict", kind="verdict"), Column("Reason"))
    rows = tuple(
        (governing.named(c, mechanism.checks), c.level_pga_g, c.verdict, c.reason)
        for c in mechanism.checks
        if c.reason and c.verdict != "pass"
    )
    return Table(name, "Checks that fail or do not apply, and why.", columns, rows)


def suites(mechanism: MechanismResult, *, name: str) -> Table:
    """The record suite at each level."""
    columns = (
        _LEVEL,
        Column("Records", kind="number"),
        Column("Overturned", kind="number"),
        Column("Mean φ/φₒᵥ", "-", "number"),
        Column("Median", "-", "number"),
        Column("84 % of records", "-", "number"),
        Column("Largest of those that stood", "-", "number"),
    )
    rows = tuple(_statistics(suite) for suite in mechanism.suites)
    caption = (
        "Time histories: the suite of records at each level, the worse polarity of each. Half of the records do not "
        "exceed the median, 84 % not the next column; one that overturns counts as the largest."
    )
    return Table(name, caption, columns, rows)


def histories(mechanism: MechanismResult, *, name: str) -> Table:
    """The largest response to each record at each level."""
    columns = (
        Column("Record"),
        _LEVEL,
        Column("Polarity", kind="number"),
        Column("Scale factor", "-", "number"),
        Column("Amplification", "-", "number"),
        Column("Largest φ", "rad", "number"),
        Column("Largest φ/φₒᵥ", "-", "number"),
        Column("At", "s", "number"),
        Column("Impacts", kind="number"),
        Column("Overturns at", "s", "number"),
    )
    rows = tuple(_history(history) for history in mechanism.histories)
    return Table(name, "Time histories: the largest response to each record, in the worse polarity.", columns, rows)


def side_by_side(results: Results) -> Table:
    """Demand over capacity of every procedure beside each other, one line for each mechanism and level."""
    known = dict.fromkeys(row.procedure for row in results.comparison)
    names = {mechanism.name: name_of(mechanism) for mechanism in results.mechanisms}
    lines: dict[tuple[str, float], dict[str, Cell]] = {}
    for row in results.comparison:
        check = governing.check_of(results, row)
        answer: Cell = (check.unbounded if check else "") or row.demand_capacity
        line = lines.setdefault((row.mechanism, row.level_pga_g), {})
        line[row.procedure] = _worse(line.get(row.procedure), answer)
    columns = (_MECHANISM, _LEVEL, *(Column(_broken(name), "-", "number") for name in known))
    caption = (
        "Demand over capacity, procedure beside procedure; above 1 the check fails. Readings named -thesis are "
        "informative. What each procedure takes as its input stands with the procedures."
    )
    rows = tuple(
        (names.get(mechanism, mechanism), level, *(line.get(name) for name in known))
        for (mechanism, level), line in lines.items()
    )
    return Table("side-by-side", caption, columns, rows)


def capacities(results: Results) -> Table:
    """PGA at capacity of every mechanism by every procedure (as thesis Table 8.6)."""
    asked = {m.name: governing.capacities(m.checks) for m in results.mechanisms}
    known = dict.fromkeys(name for found in asked.values() for name in found)
    columns = (_MECHANISM, *(Column(_broken(name), "g", "number") for name in known))
    rows = tuple(
        (name_of(m), *(asked[m.name].get(name) for name in known)) for m in results.mechanisms if asked[m.name]
    )
    caption = (
        "Peak ground acceleration at capacity of every mechanism by every procedure (as thesis Table 8.6), the least "
        "of its limit states of collapse. Readings named -thesis are informative."
    )
    return Table("pga-at-capacity", caption, columns, rows)


def rotations(results: Results) -> Table:
    """Largest rotation at each level beside the allowable, by every procedure (as thesis Table 8.10)."""
    levels = governing.levels(tuple(check for mechanism in results.mechanisms for check in mechanism.checks))
    columns = (
        _MECHANISM,
        _PROCEDURE,
        *(Column(f"{level:.3g} g", "-", "number") for level in levels),
        Column("Allowable", "-", "number"),
    )
    rows = tuple(
        (name_of(mechanism), procedure, *_rotations(checks, levels))
        for mechanism in results.mechanisms
        for procedure, checks in governing.by_procedure(mechanism.checks).items()
        if any(check.capacity_rotation_ratio is not None for check in checks)
    )
    caption = (
        "Largest rotation φ/φₒᵥ at each peak ground acceleration beside the allowable (as thesis Table 8.10). What "
        "each procedure takes as its input stands with the procedures."
    )
    return Table("rotations", caption, columns, rows)


def _rotations(checks: tuple[Check, ...], levels: tuple[float, ...]) -> tuple[Cell, ...]:
    worst = [governing.worst(governing.at_level(checks, level)) for level in levels]
    allowed = [check.capacity_rotation_ratio for check in checks if check.capacity_rotation_ratio is not None]
    return (*(None if check is None else _turned(check) for check in worst), min(allowed, default=None))


def _turned(check: Check) -> Cell:
    """Its rotation; a body that lifts off without a lasting rotation is not at rest."""
    if check.unbounded:
        return check.unbounded
    return NO_LASTING if check.reason.endswith(UNLASTING) else _rocking(check.rotation_ratio)


def _broken(name: str) -> str:
    """A procedure's name that breaks between words in a narrow column."""
    return re.sub(r"-(?=[a-z])", " ", name)


def _worse(one: Cell, other: Cell) -> Cell:
    """The worse of two ratios of one procedure (several limit states)."""
    words = [cell for cell in (one, other) if isinstance(cell, str)]
    numbers = [cell for cell in (one, other) if isinstance(cell, float)]
    if words:
        return OVERTURNED if OVERTURNED in words else words[0]
    return max(numbers, default=None)


def comparison(results: Results) -> Table:
    """All mechanisms by all procedures."""
    columns = (
        _MECHANISM,
        _LEVEL,
        _PROCEDURE,
        Column("Rotation φ/φₒᵥ", "-", "number"),
        Column("Allowable φ/φₒᵥ", "-", "number"),
        Column("Demand / capacity", "-", "number"),
        Column("Input at"),
    )
    names = {mechanism.name: name_of(mechanism) for mechanism in results.mechanisms}
    rows = tuple(_compared(results, row, names) for row in results.comparison)
    caption = (
        "Demand and capacity of all mechanisms. Compare only lines with the same input; informative readings are grey."
    )
    checks = [governing.check_of(results, row) for row in results.comparison]
    muted = frozenset(place for place, check in enumerate(checks) if check is not None and check.role == "informative")
    return Table("comparison", caption, columns, rows, muted)


def ordinates(results: Results) -> Table:
    """The spectra of the target and the records, point by point."""
    columns = (Column("Series"), Column("Period", "s", "number"), Column("Acceleration", "g", "number"))
    curves: list[tuple[str, SpectrumResult | RecordSpectrum]] = []
    curves += [("target", results.spectrum)] if results.spectrum is not None else []
    curves += [(record.id, record.spectrum) for record in results.records]
    rows = tuple(
        (name, period, value)
        for name, curve in curves
        for period, value in zip(curve.period_s, curve.acceleration_g, strict=True)
    )
    return Table("spectra", "Elastic response spectra, target and records.", columns, rows)


def curves(results: Results) -> Table:
    """The capacity curves of every mechanism, point by point."""
    columns = (
        _MECHANISM,
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


def pga_curves(results: Results) -> Table:
    """The PGA-rotation curves of every mechanism and procedure, point by point."""
    columns = (_MECHANISM, _PROCEDURE, Column("Limit state"), Column("Rotation φ/φₒᵥ", "-", "number"), _LEVEL)
    rows = tuple(
        (mechanism.name, check.procedure, check.limit_state, ratio, pga)
        for mechanism in results.mechanisms
        for check in _curved(mechanism.checks)
        for ratio, pga in zip(check.pga_curve.rotation_ratio, check.pga_curve.pga_g, strict=True)
    )
    return Table("pga-rotation-curves", "Peak ground acceleration over rotation, by each procedure.", columns, rows)


def _curved(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())


def _points(curve: BranchCurve) -> list[tuple[float, ...]]:
    quantities = (curve.inertia_kg_m2, curve.restoring_n_m, curve.excitation_kg_m)
    return list(zip(curve.rotation_rad, *quantities, curve.participating_mass_kg, curve.displacement_m, strict=True))


def _largest(checks: tuple[Check, ...]) -> Cell:
    worst = governing.worst(checks)
    if worst is None:
        return None
    return worst.unbounded or worst.ratio


def _answer(check: Check, among: tuple[Check, ...]) -> tuple[Cell, ...]:
    return (*numbers(check, among), check.verdict, check.role, check.input_at)


def numbers(check: Check, among: tuple[Check, ...]) -> tuple[Cell, Cell, Cell, Cell, Cell]:
    """Procedure, quantity with unit, demand, allowable, ratio."""
    quantity = f"{check.quantity}, {check.unit}" if check.unit not in ("", "-") else check.quantity
    demand = check.unbounded or check.demand
    return (governing.named(check, among), quantity, demand, check.capacity, check.ratio)


def _demand(check: Check, among: tuple[Check, ...]) -> tuple[Cell, ...]:
    rotation = _turned(check)
    accelerations = (uplift(check.uplift_pga_g), check.capacity_pga_g)
    return (check.level_pga_g, *numbers(check, among), rotation, *accelerations)


def _remark(check: Check) -> str:
    return "; ".join(text for text in (check.damping_rule, check.caveat) if text)


def _history(history: HistoryResult) -> tuple[Cell, ...]:
    fell = history.overturned
    rotation = OVERTURNED if fell else _rocking(history.max_rotation_rad)
    ratio = OVERTURNED if fell else _rocking(history.max_rotation_ratio)
    scaling = (history.scale_factor, history.amplification)
    times = (history.time_of_max_s, history.impacts, history.overturning_time_s)
    return (history.record, history.level_pga_g, history.polarity, *scaling, rotation, ratio, *times)


def _compared(results: Results, row: ComparisonRow, names: dict[str, str]) -> tuple[Cell, ...]:
    check = governing.check_of(results, row)
    rotation = _rocking(row.rotation_ratio) if check is None else _turned(check)
    place = (names.get(row.mechanism, row.mechanism), row.level_pga_g, row.procedure)
    return (*place, rotation, row.allowable_ratio, row.demand_capacity, check.input_at if check else None)


def _statistics(suite: SuiteResult) -> tuple[Cell, ...]:
    ratios = (suite.mean_ratio, suite.median_ratio, suite.p84_ratio)
    return (
        suite.level_pga_g,
        suite.n,
        suite.overturned,
        *(_mean(r, suite.overturned) for r in ratios),
        suite.max_ratio,
    )


def _mean(mean_ratio: float | None, overturned: int) -> Cell:
    return OVERTURNED if mean_ratio is None and overturned else mean_ratio


def _rocking(rotation: float | None) -> Cell:
    return NO_ROCKING if rotation == 0 else rotation


def _parameter(branch: OscillatorResult | None, key: str) -> Cell:
    if branch is not None and key == "uplift_multiplier":
        return uplift(branch.uplift_multiplier)
    value: float | None = None if branch is None else attrgetter(key)(branch)
    return value


def uplift(at: float | None) -> Cell:
    """Multiplier [-] or PGA [g] at uplift; "none" where a joint answers to any motion: no threshold."""
    return NONE if at is None else at
