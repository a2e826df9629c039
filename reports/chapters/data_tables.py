"""Tables too long to print, for the spreadsheet and the CSV files; thesis Tables 8.6 and 8.10 in form among them."""

from __future__ import annotations

from collections.abc import Iterator
from operator import attrgetter

from assess.codes.check import Check
from assess.results import BranchCurve, ComparisonRow, MechanismResult, RecordSpectrum, Results, SpectrumResult
from reports import governing
from reports.chapters import (
    annex_envelopes,
    annex_histories,
    annex_inputs,
    annex_sheets,
    cells,
    declaration,
    sensitivity,
    suite,
    uncertainty,
)
from reports.document import Cell, Column, Field, Table, tabulate, tabulate_parts
from reports.language.texts import Listing, Term, Verbatim, quantity, say
from reports.mechanisms import file_stem, numbered_title, procedure_title

ROTATION = Column(say("Rotation φ/φₒᵥ"), "ratio")
RATIO = Column(say("Demand / capacity"), "ratio")
INPUT_AT = Column(say("Input at"))


def tables(results: Results) -> Iterator[Table]:
    """Yield every table that has rows."""
    made = (
        checks_table(results),
        _pga_at_capacity_table(results),
        _rotations_table(results),
        comparison_table(results),
        spectra_table(results),
        _capacity_curves_table(results),
        _pga_curves_table(results),
        sensitivity.sensitivity_table(results),
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


CHECK_FIELDS: tuple[Field[Check], ...] = (
    (cells.LEVEL, lambda check: check.level_pga_g),
    (cells.PROCEDURE, lambda check: Verbatim(check.procedure)),
    (cells.METHOD, lambda check: procedure_title(check.procedure)),
    (cells.LIMIT_STATE, lambda check: Verbatim(check.limit_state)),
    (cells.QUANTITY, lambda check: Term(check.quantity)),
    (cells.UNIT, lambda check: Verbatim(check.unit)),
    (Column(say("Demand")), lambda check: cells.unbounded_text(check) or check.demand),
    (Column(say("Allowable")), lambda check: check.capacity),
    (RATIO, lambda check: check.ratio),
    (ROTATION, cells.rotation_cell),
    (Column(say("PGA at uplift"), "ground acceleration"), lambda check: cells.uplift_cell(check.uplift_pga_g)),
    (Column(say("PGA at capacity"), "ground acceleration"), lambda check: check.capacity_pga_g),
    (Column(say("Safety index"), "ratio"), lambda check: check.safety_index),
    (Column(say("Return period"), "return period"), lambda check: check.return_period_years),
    (cells.OUTCOME, cells.outcome_cell),
    (cells.ROLE, lambda check: cells.ROLES[check.role]),
    (Column(say("Reading")), lambda check: cells.READINGS[check.reading]),
    (INPUT_AT, lambda check: cells.INPUTS[check.input_at]),
    (Column(say("Why")), lambda check: check.reason),
    (Column(say("Conditions and remarks")), lambda check: _conditions_and_remarks(check)),
)


def checks_table(results: Results) -> Table:
    """Tabulate every check of every mechanism: demand, allowable, ratio, outcome, role and reason."""
    caption = say("Demand, allowable, ratio and outcome of every check. Readings by Mehrotra (grey) never decide.")
    mechanisms: tuple[Field[MechanismResult], ...] = (
        (cells.MECHANISM, lambda mechanism: numbered_title(results, mechanism.name)),
    )
    checks = (CHECK_FIELDS, attrgetter("checks"))
    return tabulate_parts("verdicts", caption, (mechanisms, results.mechanisms), checks, muted=cells.is_thesis_reading)


ComparedCheck = tuple[ComparisonRow, Check | None]


def comparison_table(results: Results) -> Table:
    """Tabulate all mechanisms by all procedures."""
    fields: tuple[Field[ComparedCheck], ...] = (
        (cells.MECHANISM, lambda pair: numbered_title(results, pair[0].mechanism)),
        (cells.LEVEL, lambda pair: pair[0].level_pga_g),
        (cells.PROCEDURE, lambda pair: Verbatim(pair[0].procedure)),
        (cells.METHOD, lambda pair: procedure_title(pair[0].procedure)),
        (ROTATION, _compared_rotation),
        (Column(say("Allowable φ/φₒᵥ"), "ratio"), lambda pair: pair[0].allowable_ratio),
        (RATIO, _compared_ratio),
        (INPUT_AT, lambda pair: None if pair[1] is None else cells.INPUTS[pair[1].input_at]),
    )
    caption = say(
        "Demand and capacity of all mechanisms. Compare only lines with the same input; readings by Mehrotra are grey."
    )
    pairs = [(row, governing.check_of(results, row)) for row in results.comparison]
    return tabulate(
        "comparison",
        caption,
        fields,
        pairs,
        muted=lambda pair: pair[1] is not None and cells.is_thesis_reading(pair[1]),
    )


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


def _of_mechanisms(results: Results) -> Iterator[Table]:
    for place, mechanism in enumerate(results.mechanisms, start=1):
        stem = file_stem(mechanism.name, place)
        yield annex_sheets.parameters_table(mechanism, name=f"{stem}-parameters")
        yield annex_sheets.loads_table(mechanism, name=f"{stem}-loads")
        if (ties := annex_sheets.ties_table(mechanism, name=f"{stem}-ties")).rows:
            yield ties
        yield annex_sheets.hinge_forces_table(mechanism, name=f"{stem}-hinge-forces")
        yield annex_histories.suites_table(mechanism, name=f"{stem}-suites")
        yield annex_histories.histories_table(mechanism, name=f"{stem}-histories")


def _of_suite(results: Results) -> Iterator[Table]:
    motion = results.ground_motion
    if motion is not None:
        yield suite.requirements_table(motion)
    yield suite.processing_table(results)


def _conditions_and_remarks(check: Check) -> Listing:
    """Return conditions and remarks, each sentence once."""
    return Listing(tuple({each.text: each for each in (*check.conditions, *check.remarks)}.values()), "")


def _pga_at_capacity_table(results: Results) -> Table:
    """Tabulate the PGA at capacity of every mechanism by every procedure (as Mehrotra Table 8.6)."""
    by_mechanism = {m.name: governing.capacities(m.checks) for m in results.mechanisms}
    known = dict.fromkeys(name for found in by_mechanism.values() for name in found)
    columns = (cells.MECHANISM, *(Column(procedure_title(name), "ground acceleration") for name in known))
    rows = tuple(
        (numbered_title(results, m.name), *map(by_mechanism[m.name].get, known))
        for m in results.mechanisms
        if by_mechanism[m.name]
    )
    caption = say(
        "Peak ground acceleration at capacity of every mechanism by every procedure (as Mehrotra Table 8.6), the least "
        "of its limit states of collapse. Readings by Mehrotra never decide."
    )
    return Table("pga-at-capacity", caption, columns, rows)


def _rotations_table(results: Results) -> Table:
    """Tabulate the largest rotation at each level and the allowable one, by procedure (as thesis Table 8.10)."""
    levels = governing.pga_levels(tuple(check for mechanism in results.mechanisms for check in mechanism.checks))
    at_levels = (Column(say("At {pga}", pga=quantity(level, "ground acceleration", 3)), "ratio") for level in levels)
    columns = (cells.MECHANISM, cells.PROCEDURE, cells.METHOD, *at_levels, Column(say("Allowable"), "ratio"))
    rows = tuple(
        (numbered_title(results, m.name), Verbatim(name), procedure_title(name), *_rotation_cells(checks, levels))
        for m in results.mechanisms
        for name, checks in governing.group_by_procedure(m.checks).items()
        if any(check.capacity_rotation_ratio is not None for check in checks)
    )
    caption = say(
        "Largest rotation φ/φₒᵥ at each peak ground acceleration, and the allowable rotation (as Mehrotra Table 8.10)."
    )
    return Table("rotations", caption, columns, rows)


def _rotation_cells(checks: tuple[Check, ...], levels: tuple[float, ...]) -> tuple[Cell, ...]:
    worst = [governing.worst_check(governing.checks_at_level(checks, level)) for level in levels]
    allowed = [check.capacity_rotation_ratio for check in checks if check.capacity_rotation_ratio is not None]
    return (*(None if check is None else cells.rotation_cell(check) for check in worst), min(allowed, default=None))


def _compared_rotation(pair: ComparedCheck) -> Cell:
    row, check = pair
    return cells.rocking_cell(row.rotation_ratio) if check is None else cells.rotation_cell(check)


def _compared_ratio(pair: ComparedCheck) -> Cell:
    row, check = pair
    return row.demand_capacity if check is None else cells.unbounded_text(check) or row.demand_capacity


def _capacity_curves_table(results: Results) -> Table:
    """Tabulate the capacity curves of every mechanism, point by point."""
    columns = (
        cells.MECHANISM,
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
            start = (numbered_title(results, mechanism.name), cells.BRANCHES[branch])
            rows += [] if curve is None else [(*start, *point) for point in _points(curve)]
    return Table("capacity-curves", say("Capacity curves of both branches."), columns, tuple(rows))


def _points(curve: BranchCurve) -> Iterator[tuple[float, ...]]:
    quantities = (curve.inertia_kg_m2, curve.restoring_n_m, curve.excitation_kg_m)
    return zip(curve.rotation_rad, *quantities, curve.participating_mass_kg, curve.displacement_m, strict=True)


def _pga_curves_table(results: Results) -> Table:
    """Tabulate the PGA-rotation curves of every mechanism and procedure, point by point."""
    rows = tuple(
        (numbered_title(results, mechanism.name), Verbatim(check.procedure), Verbatim(check.limit_state), ratio, pga)
        for mechanism in results.mechanisms
        for check in _one_for_each_curve(mechanism.checks)
        for ratio, pga in zip(check.pga_curve.rotation_ratio, check.pga_curve.pga_g, strict=True)
    )
    caption = say("Peak ground acceleration over rotation, by each procedure.")
    columns = (cells.MECHANISM, cells.PROCEDURE, cells.LIMIT_STATE, ROTATION, cells.LEVEL)
    return Table("pga-rotation-curves", caption, columns, rows)


def _one_for_each_curve(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return one check of each procedure and limit state: at all levels they have one curve."""
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())
