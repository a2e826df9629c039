"""Verdicts, yes and no in the words of a document."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from reports.document import Cell, Column, Table


def spell_out_table(table: Table, translate: Callable[[str], str]) -> Table:
    """Return the table with its verdicts and truth values in words."""
    rows = tuple(
        tuple(spell_out(cell, column, translate) for cell, column in zip(row, table.columns, strict=True))
        for row in table.rows
    )
    return replace(table, rows=rows)


def outcome_colour(cell: Cell, column: Column) -> str:
    """Return the outcome whose colour a cell has: "pass" or "fail", at the limit too; else empty."""
    word = cell.partition(" ")[0] if isinstance(cell, str) and column.kind == "verdict" else ""
    return word if word in ("pass", "fail") else ""


def spell_out(cell: Cell, column: Column, translate: Callable[[str], str]) -> Cell:
    """Return a verdict as `translate` gives it; a truth value too, where that is another word than the English one."""
    if isinstance(cell, bool):
        word = "yes" if cell else "no"
        return cell if translate(word) == word else translate(word)
    return translate(cell) if isinstance(cell, str) and column.kind == "verdict" else cell
