"""Tables too long to print, for the spreadsheet and the CSV files; thesis Tables 8.6 and 8.10 in form among them."""

from __future__ import annotations

from collections.abc import Iterator

from assess.codes.check import Check
from assess.results import BranchCurve, ComparisonRow, RecordSpectrum, Results, SensitivityResult, SpectrumResult
from reports import governing
from reports.chapters import (
    annex_envelopes,
    annex_histories,
    annex_inputs,
    annex_sheets,
    declaration,
    suite,
    uncertainty,
)
from reports.chapters.cells import (
    BRANCHES,
    INPUTS,
    LEVEL,
    LIMIT_STATE,
    MECHANISM,
    METHOD,
    OUTCOME,
    OUTCOMES,
    READINGS,
    ROLES,
    outcome_cell,
    rocking_cell,
    rotation_cell,
    unbounded_text,
    uplift_cell,
)
from reports.chapters.sensitivity import input_name
from reports.document import Cell, Column, Table
from reports.language.texts import Listing, Phrase, Term, Verbatim, quantity, say
from reports.titles import file_stem, numbered_title, procedure_title

PROCEDURE = Column(say("Procedure"))
ROTATION = Column(say("Rotation φ/φₒᵥ"), "ratio")
RATIO = Column(say("Demand / capacity"), "ratio")
QUANTITIES = {
    "index": say("index"),
    "capacity_pga_g": say("PGA at capacity [g]"),
    "demand_capacity": say("demand / capacity"),
}


def tables(results: Results) -> Iterator[Table]:
    """Yield every table that has rows."""
    made = (
        checks_table(results),
        pga_at_capacity_table(results),
        rotations_table(results),
        comparison_table(results),
        spectra_table(results),
        capacity_curves_table(results),
        pga_curves_table(results),
        sensitivity_table(results),
        *uncertainty.data_tables(results),
        declaration.controls_in_full(results),
        *annex_envelopes.data_tables(results),
        annex_envelopes.primary_pulses_table(results.records),
        *_of_mechanisms(results),
        *_of_suite(results),
        annex_inputs.values_table(results),
        annex_inputs.files_table(results),
        annex_inputs.messages_table(results),
    )
    yield from (table for table in made if table.rows)


def _of_mechanisms(results: Results) -> Iterator[Table]:
    for place, mechanism in enumerate(results.mechanisms, start=1):
        stem = file_stem(mechanism.name, place)
        yield annex_sheets.parameters_table(mechanism, name=f"{stem}-parameters")
        yield annex_sheets.loads_table(mechanism, name=f"{stem}-loads")
        yield annex_sheets.hinge_forces_table(mechanism, name=f"{stem}-hinge-forces")
        yield annex_histories.suites_table(mechanism, name=f"{stem}-suites")
        yield annex_histories.histories_table(mechanism, name=f"{stem}-histories")


def _of_suite(results: Results) -> Iterator[Table]:
    motion = results.ground_motion
    if motion is not None:
        yield suite.requirements_table(motion)
    yield suite.processing_table(results)


def checks_table(results: Results) -> Table:
    """Tabulate every check of every mechanism: demand, allowable, ratio, outcome, role and reason."""
    pairs = [(mechanism, check) for mechanism in results.mechanisms for check in mechanism.checks]
    columns = (
        MECHANISM,
        LEVEL,
        PROCEDURE,
        METHOD,
        LIMIT_STATE,
        Column(say("Quantity")),
        Column(say("Unit")),
        Column(say("Demand")),
        Column(say("Allowable")),
        RATIO,
        ROTATION,
        Column(say("PGA at uplift"), "ground acceleration"),
        Column(say("PGA at capacity"), "ground acceleration"),
        Column(say("Safety index"), "ratio"),
        Column(say("Return period"), "return period"),
        OUTCOME,
        Column(say("Role")),
        Column(say("Reading")),
        Column(say("Input at")),
        Column(say("Why")),
        Column(say("Conditions and remarks")),
    )
    rows = tuple((numbered_title(results, mechanism.name), *_check_row(check)) for mechanism, check in pairs)
    muted = frozenset(place for place, (_, check) in enumerate(pairs) if check.reading == "thesis")
    caption = say("Demand, allowable, ratio and outcome of every check. Readings of the thesis (grey) never decide.")
    return Table("verdicts", caption, columns, rows, muted)


def _check_row(check: Check) -> tuple[Cell, ...]:
    return (
        check.level_pga_g,
        Verbatim(check.procedure),
        procedure_title(check.procedure),
        Verbatim(check.limit_state),
        Term(check.quantity),
        Verbatim(check.unit),
        unbounded_text(check) or check.demand,
        check.capacity,
        check.ratio,
        rotation_cell(check),
        uplift_cell(check.uplift_pga_g),
        check.capacity_pga_g,
        check.safety_index,
        check.return_period_years,
        outcome_cell(check),
        ROLES[check.role],
        READINGS[check.reading],
        INPUTS[check.input_at],
        check.reason,
        Listing(tuple({each.text: each for each in (*check.conditions, *check.remarks)}.values()), ""),
    )


def pga_at_capacity_table(results: Results) -> Table:
    """Tabulate the PGA at capacity of every mechanism by every procedure (as thesis Table 8.6)."""
    by_mechanism = {m.name: governing.capacities(m.checks) for m in results.mechanisms}
    known = dict.fromkeys(name for found in by_mechanism.values() for name in found)
    columns = (MECHANISM, *(Column(procedure_title(name), "ground acceleration") for name in known))
    rows = tuple(
        (numbered_title(results, m.name), *map(by_mechanism[m.name].get, known))
        for m in results.mechanisms
        if by_mechanism[m.name]
    )
    caption = say(
        "Peak ground acceleration at capacity of every mechanism by every procedure (as thesis Table 8.6), the least "
        "of its limit states of collapse. Readings of the thesis never decide."
    )
    return Table("pga-at-capacity", caption, columns, rows)


def rotations_table(results: Results) -> Table:
    """Tabulate the largest rotation at each level and the allowable one, by procedure (as thesis Table 8.10)."""
    levels = governing.pga_levels(tuple(check for mechanism in results.mechanisms for check in mechanism.checks))
    columns = (
        MECHANISM,
        PROCEDURE,
        METHOD,
        *(Column(say("At {pga}", pga=quantity(level, "ground acceleration", 3)), "ratio") for level in levels),
        Column(say("Allowable"), "ratio"),
    )
    rows = tuple(
        (
            numbered_title(results, mechanism.name),
            Verbatim(procedure),
            procedure_title(procedure),
            *_rotation_cells(checks, levels),
        )
        for mechanism in results.mechanisms
        for procedure, checks in governing.group_by_procedure(mechanism.checks).items()
        if any(check.capacity_rotation_ratio is not None for check in checks)
    )
    caption = say(
        "Largest rotation φ/φₒᵥ at each peak ground acceleration, and the allowable rotation (as thesis Table 8.10)."
    )
    return Table("rotations", caption, columns, rows)


def _rotation_cells(checks: tuple[Check, ...], levels: tuple[float, ...]) -> tuple[Cell, ...]:
    worst = [governing.worst_check(governing.checks_at_level(checks, level)) for level in levels]
    allowed = [check.capacity_rotation_ratio for check in checks if check.capacity_rotation_ratio is not None]
    return (*(None if check is None else rotation_cell(check) for check in worst), min(allowed, default=None))


def comparison_table(results: Results) -> Table:
    """Tabulate all mechanisms by all procedures."""
    columns = (
        MECHANISM,
        LEVEL,
        PROCEDURE,
        METHOD,
        ROTATION,
        Column(say("Allowable φ/φₒᵥ"), "ratio"),
        RATIO,
        Column(say("Input at")),
    )
    checks = [governing.check_of(results, row) for row in results.comparison]
    rows = tuple(_comparison_row(results, row, check) for row, check in zip(results.comparison, checks, strict=True))
    muted = frozenset(place for place, check in enumerate(checks) if check is not None and check.reading == "thesis")
    caption = say(
        "Demand and capacity of all mechanisms. Compare only lines with the same input; thesis readings are grey."
    )
    return Table("comparison", caption, columns, rows, muted)


def _comparison_row(results: Results, row: ComparisonRow, check: Check | None) -> tuple[Cell, ...]:
    rotation = rocking_cell(row.rotation_ratio) if check is None else rotation_cell(check)
    place: tuple[Cell, ...] = (
        numbered_title(results, row.mechanism),
        row.level_pga_g,
        Verbatim(row.procedure),
        procedure_title(row.procedure),
    )
    unbounded: Phrase | None = None if check is None else unbounded_text(check)
    ratio: Cell = unbounded or row.demand_capacity
    return (*place, rotation, row.allowable_ratio, ratio, None if check is None else INPUTS[check.input_at])


def spectra_table(results: Results) -> Table:
    """Tabulate the spectra of the target and the records, point by point."""
    columns = (Column(say("Series")), Column(say("Period"), "time"), Column(say("Acceleration"), "ground acceleration"))
    curves: list[tuple[Cell, SpectrumResult | RecordSpectrum]] = []
    curves += [(say("target"), results.spectrum)] if results.spectrum is not None else []
    curves += [(Verbatim(record.id), record.spectrum) for record in results.records]
    rows = tuple(
        (name, period, value)
        for name, curve in curves
        for period, value in zip(curve.period_s, curve.acceleration_g, strict=True)
    )
    return Table("spectra", say("Elastic response spectra, target and records."), columns, rows)


def capacity_curves_table(results: Results) -> Table:
    """Tabulate the capacity curves of every mechanism, point by point."""
    columns = (
        MECHANISM,
        Column(say("Branch")),
        Column(say("Rotation"), "rotation"),
        Column(say("Inertia"), "inertia"),
        Column(say("Restoring moment"), "moment"),
        Column(say("Excitation"), "first moment"),
        Column(say("Participating mass"), "mass"),
        Column(say("Displacement"), "length"),
    )
    rows: list[tuple[Cell, ...]] = []
    for mechanism in results.mechanisms:
        for branch, curve in (("positive", mechanism.curve.positive), ("negative", mechanism.curve.negative)):
            start = (numbered_title(results, mechanism.name), BRANCHES[branch])
            rows += [] if curve is None else [(*start, *point) for point in _points(curve)]
    return Table("capacity-curves", say("Capacity curves of both branches."), columns, tuple(rows))


def _points(curve: BranchCurve) -> Iterator[tuple[float, ...]]:
    quantities = (curve.inertia_kg_m2, curve.restoring_n_m, curve.excitation_kg_m)
    return zip(curve.rotation_rad, *quantities, curve.participating_mass_kg, curve.displacement_m, strict=True)


def pga_curves_table(results: Results) -> Table:
    """Tabulate the PGA-rotation curves of every mechanism and procedure, point by point."""
    rows = tuple(
        (numbered_title(results, mechanism.name), Verbatim(check.procedure), Verbatim(check.limit_state), ratio, pga)
        for mechanism in results.mechanisms
        for check in _one_for_each_curve(mechanism.checks)
        for ratio, pga in zip(check.pga_curve.rotation_ratio, check.pga_curve.pga_g, strict=True)
    )
    caption = say("Peak ground acceleration over rotation, by each procedure.")
    return Table("pga-rotation-curves", caption, (MECHANISM, PROCEDURE, LIMIT_STATE, ROTATION, LEVEL), rows)


def _one_for_each_curve(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return one check of each procedure and limit state: at all levels they have one curve."""
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())


def sensitivity_table(results: Results) -> Table:
    """Tabulate every answer of every mechanism with each value at its low and its high end."""
    columns = (
        MECHANISM,
        Column(say("Parameter")),
        Column(say("Key")),
        Column(say("Unit")),
        *map(Column, (say("Base"), say("Low"), say("High"))),
        PROCEDURE,
        LIMIT_STATE,
        Column(say("Role")),
        LEVEL,
        Column(say("Quantity")),
        *map(Column, (say("At base"), say("At low"), say("At high"))),
        *map(Column, (say("Outcome"), say("Outcome at low"), say("Outcome at high"))),
        Column(say("Remark")),
    )
    caption = say(
        "Every check with each value at its low and its high end; there is no ratio where the body overturns."
    )
    return Table("sensitivity", caption, columns, tuple(_sensitivity_row(results, row) for row in results.sensitivity))


def _sensitivity_row(results: Results, row: SensitivityResult) -> tuple[Cell, ...]:
    outcomes = (row.verdict_base, row.verdict_low, row.verdict_high)
    return (
        numbered_title(results, row.mechanism),
        input_name(row),
        Verbatim(row.key),
        Verbatim(row.unit),
        *(row.base, row.low, row.high),
        Verbatim(row.procedure),
        Verbatim(row.limit_state),
        ROLES[row.role],
        row.level_pga_g,
        QUANTITIES.get(row.quantity),
        *(row.at_base, row.at_low, row.at_high),
        *(None if outcome is None else OUTCOMES[outcome.value] for outcome in outcomes),
        Listing(row.remarks or (Term(row.remark),), ""),
    )
