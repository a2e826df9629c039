"""Verdicts, yes and no in the words of a document."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from reports.document import Cell, Column, Table


def worded(table: Table, said: Callable[[str], str]) -> Table:
    """The table with its verdicts and truth values in words."""
    rows = tuple(
        tuple(in_words(cell, column, said) for cell, column in zip(row, table.columns, strict=True))
        for row in table.rows
    )
    return replace(table, rows=rows)


def coloured(cell: Cell, column: Column) -> str:
    """The outcome whose colour a cell has: "pass" or "fail", at the limit too; else empty."""
    word = cell.partition(" ")[0] if isinstance(cell, str) and column.kind == "verdict" else ""
    return word if word in ("pass", "fail") else ""


def in_words(cell: Cell, column: Column, said: Callable[[str], str]) -> Cell:
    """A verdict as `said` says it; a truth value too, where that is another word than the English one."""
    if isinstance(cell, bool):
        word = "yes" if cell else "no"
        return cell if said(word) == word else said(word)
    return said(cell) if isinstance(cell, str) and column.kind == "verdict" else cell
