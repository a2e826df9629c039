"""The chapter that compares procedures and mechanisms (as thesis Tables 8.6 and 8.10)."""

from __future__ import annotations

from functools import partial

from assess.codes.check import Check
from assess.results import ComparisonRow, Results
from reports import governing
from reports.chapters import descriptions, interface_variants, sweeps
from reports.chapters.check_tables import (
    LEVEL,
    MECHANISM,
    OVERTURNED,
    PROCEDURE,
    breakable_name,
    rocking_cell,
    rotation_cell,
)
from reports.document import Cell, Column, Figure, Section, Table, Text, nonempty
from reports.figures import comparison as figure
from reports.mechanism_title import mechanism_title


def chapter(results: Results) -> list[Section]:
    """Return the chapter; none without a comparison."""
    if not results.comparison:
        return []
    names = {mechanism.name: mechanism_title(mechanism) for mechanism in results.mechanisms}
    draw = partial(figure.draw, governing.rows_to_draw(results), names, governing.overturned_rows(results))
    caption = (
        "Demand over capacity of every mechanism by every procedure; right of the line the check fails. Open markers "
        "are readings of the thesis, a cross marks overturning, an arrow a ratio beyond the axis or the end of "
        "the spectrum."
    )
    standing = sweeps.controlling_cases(results.sweeps, names)
    unlike = descriptions.unequal_inputs(results)
    blocks = (
        *standing,
        *((Text(unlike),) if unlike else ()),
        Figure("comparison", caption, draw),
        *nonempty(capacities(results)),
        side_by_side(results),
        *nonempty(rotations(results)),
        *interface_variants.blocks(results, name="interfaces"),
    )
    return [Section("Comparison of the mechanisms", 0, blocks, starts_page=True)]


def side_by_side(results: Results) -> Table:
    """Tabulate demand over capacity, a column for each procedure, a line for each mechanism and level."""
    known = dict.fromkeys(row.procedure for row in results.comparison)
    names = {mechanism.name: mechanism_title(mechanism) for mechanism in results.mechanisms}
    lines: dict[tuple[str, float], dict[str, Cell]] = {}
    for row in results.comparison:
        check = governing.check_of(results, row)
        answer: Cell = (check.unbounded if check else "") or row.demand_capacity
        line = lines.setdefault((row.mechanism, row.level_pga_g), {})
        line[row.procedure] = _worse(line.get(row.procedure), answer)
    columns = (MECHANISM, LEVEL, *(Column(breakable_name(name), "-", "number") for name in known))
    caption = (
        "Demand over capacity of each procedure; above 1 the check fails. Readings of the thesis never "
        "decide. The table of procedures gives the input of each."
    )
    rows = tuple(
        (names.get(mechanism, mechanism), level, *(line.get(name) for name in known))
        for (mechanism, level), line in lines.items()
    )
    return Table("side-by-side", caption, columns, rows)


def _worse(one: Cell, other: Cell) -> Cell:
    """Return the worse of two ratios of one procedure (several limit states)."""
    words = [cell for cell in (one, other) if isinstance(cell, str)]
    numbers = [cell for cell in (one, other) if isinstance(cell, float)]
    if words:
        return OVERTURNED if OVERTURNED in words else words[0]
    return max(numbers, default=None)


def capacities(results: Results) -> Table:
    """Tabulate the PGA at capacity of every mechanism by every procedure (as thesis Table 8.6)."""
    by_mechanism = {m.name: governing.capacities(m.checks) for m in results.mechanisms}
    known = dict.fromkeys(name for found in by_mechanism.values() for name in found)
    columns = (MECHANISM, *(Column(breakable_name(name), "g", "number") for name in known))
    rows = tuple(
        (mechanism_title(m), *(by_mechanism[m.name].get(name) for name in known))
        for m in results.mechanisms
        if by_mechanism[m.name]
    )
    caption = (
        "Peak ground acceleration at capacity of every mechanism by every procedure (as thesis Table 8.6), the least "
        "of its limit states of collapse. Readings of the thesis never decide."
    )
    return Table("pga-at-capacity", caption, columns, rows)


def rotations(results: Results) -> Table:
    """Tabulate the largest rotation at each level and the allowable one, by procedure (as thesis Table 8.10)."""
    levels = governing.levels(tuple(check for mechanism in results.mechanisms for check in mechanism.checks))
    columns = (
        MECHANISM,
        PROCEDURE,
        *(Column(f"{level:.3g} g", "-", "number") for level in levels),
        Column("Allowable", "-", "number"),
    )
    rows = tuple(
        (mechanism_title(mechanism), procedure, *_rotations(checks, levels))
        for mechanism in results.mechanisms
        for procedure, checks in governing.group_by_procedure(mechanism.checks).items()
        if any(check.capacity_rotation_ratio is not None for check in checks)
    )
    caption = (
        "Largest rotation φ/φₒᵥ at each peak ground acceleration, and the allowable rotation (as thesis "
        "Table 8.10). The table of procedures gives the input of each."
    )
    return Table("rotations", caption, columns, rows)


def _rotations(checks: tuple[Check, ...], levels: tuple[float, ...]) -> tuple[Cell, ...]:
    worst = [governing.worst(governing.at_level(checks, level)) for level in levels]
    allowed = [check.capacity_rotation_ratio for check in checks if check.capacity_rotation_ratio is not None]
    return (*(None if check is None else rotation_cell(check) for check in worst), min(allowed, default=None))


def comparison(results: Results) -> Table:
    """Tabulate all mechanisms by all procedures."""
    columns = (
        MECHANISM,
        LEVEL,
        PROCEDURE,
        Column("Rotation φ/φₒᵥ", "-", "number"),
        Column("Allowable φ/φₒᵥ", "-", "number"),
        Column("Demand / capacity", "-", "number"),
        Column("Input at"),
    )
    names = {mechanism.name: mechanism_title(mechanism) for mechanism in results.mechanisms}
    rows = tuple(_compared(results, row, names) for row in results.comparison)
    caption = "Demand and capacity of all mechanisms. Compare only lines with the same input; thesis readings are grey."
    checks = [governing.check_of(results, row) for row in results.comparison]
    muted = frozenset(place for place, check in enumerate(checks) if check is not None and check.reading == "thesis")
    return Table("comparison", caption, columns, rows, muted)


def _compared(results: Results, row: ComparisonRow, names: dict[str, str]) -> tuple[Cell, ...]:
    check = governing.check_of(results, row)
    rotation = rocking_cell(row.rotation_ratio) if check is None else rotation_cell(check)
    place = (names.get(row.mechanism, row.mechanism), row.level_pga_g, row.procedure)
    return (*place, rotation, row.allowable_ratio, row.demand_capacity, check.input_at if check else None)
