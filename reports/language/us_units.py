"""A document in US customary units: the cells of its tables and the results of its calculation sheets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from reports.document import Block, Cell, Column, Document, Line, Section, Sheet, Table, Text
from reports.language.customary import Customary, customary

WORKED_IN_SI = (
    "Calculation sheets are worked in SI units, as the constants of the clauses are printed; the result "
    "of each step is also given in US customary units, accelerations in g = 32.174 ft/s². Values of the "
    "project file are listed in SI units, and so are remarks on meshes, loads and records."
)
UNIT, QUANTITY = "Unit", "Quantity, unit"
ROWS: Mapping[str, tuple[str, ...]] = {
    UNIT: ("Value", "Positive", "Negative", "Base", "Low", "High"),
    QUANTITY: ("Demand", "Allowable"),
}
"""Columns that give the unit of a row, and the columns whose numbers are in that unit."""


def in_us_units(document: Document) -> Document:
    """Return the document with every number of its tables in US units, to full precision; sheets in both systems.

    Captions, sentences and figures: `reports.language.measures`, `reports.figures.us_axes`. Headings of tables must be
    English.
    """
    sections = [
        replace(section, blocks=tuple(_block(block) for block in section.blocks)) for section in document.sections
    ]
    return replace(document, sections=_noted(sections), data=tuple(map(table, document.data)))


def _block(block: Block) -> Block:
    if isinstance(block, Table):
        return table(block)
    return replace(block, lines=tuple(map(_line, block.lines))) if isinstance(block, Sheet) else block


def _noted(sections: list[Section]) -> tuple[Section, ...]:
    """Return the sections with the note on sheets in front of the first of them."""
    for place, section in enumerate(sections):
        first = next((at for at, block in enumerate(section.blocks) if isinstance(block, Sheet)), None)
        if first is not None:
            blocks = (*section.blocks[:first], Text((WORKED_IN_SI,)), *section.blocks[first:])
            return (*sections[:place], replace(section, blocks=blocks), *sections[place + 1 :])
    return tuple(sections)


def _line(line: Line) -> Line:
    """Return a step with its result in both systems."""
    found = customary(line.unit)
    if found is None or not isinstance(line.value, float | int):
        return line
    return replace(line, beside=(line.value * found.factor, found.unit))


def table(one: Table) -> Table:
    """Return a table in US units: of columns with a unit, and of rows that give theirs in a cell."""
    rows = tuple(_row(row, one.columns) for row in one.rows)
    return replace(one, columns=tuple(map(_column, one.columns)), rows=rows)


def _column(column: Column) -> Column:
    found = customary(column.unit)
    if found is None:
        return column
    return replace(column, unit=found.unit, kind="number" if column.kind == "given" else column.kind)


def _row(row: tuple[Cell, ...], columns: tuple[Column, ...]) -> tuple[Cell, ...]:
    """Return the cells in the units of their columns, or in the unit of the row."""
    units = {label: customary(_unit(cell)) for cell, label in _unit_cells(row, columns)}
    of_row = {label: found for unit, found in units.items() if found for label in ROWS[unit]}
    made: list[Cell] = []
    for cell, column in zip(row, columns, strict=True):
        own = of_row.get(column.label) if column.unit == "" else customary(column.unit)
        unit = units.get(column.label)
        made.append(_renamed(cell, unit) if unit is not None else _converted(cell, own))
    return tuple(made)


def _unit_cells(row: tuple[Cell, ...], columns: tuple[Column, ...]) -> list[tuple[str, str]]:
    """Return the cells that give a unit, with the label of their column, where the table has columns in that unit."""
    labels = {column.label for column in columns}
    pairs = ((cell, column.label) for cell, column in zip(row, columns, strict=True) if isinstance(cell, str))
    return [(cell, label) for cell, label in pairs if not labels.isdisjoint(ROWS.get(label, ()))]


def _unit(cell: str) -> str:
    """Return the unit in a cell: "m" of "m" and of "displacement, m"."""
    return cell.rpartition(", ")[2]


def _renamed(cell: Cell, unit: Customary) -> str:
    before, comma, _ = str(cell).rpartition(", ")
    return f"{before}{comma}{unit.unit}"


def _converted(cell: Cell, unit: Customary | None) -> Cell:
    if unit is None or isinstance(cell, bool) or not isinstance(cell, int | float):
        return cell
    return cell * unit.factor
