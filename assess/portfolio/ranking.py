"""The order of a portfolio: what fails first, by how little it bears; what is broken last."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf, isfinite

from assess.portfolio.row import Row

ORDER = ("fail", "incomplete", "pass")
"""Outcomes in the order of a ranking; a project without any verdict stands with the incomplete ones."""


def rank(rows: Iterable[Row]) -> tuple[Row, ...]:
    """Return the rows in the order in which an owner wants to read them.

    Projects that fail come first, then those without an answer, then those that pass, and broken ones at the end; in
    each of these the least margin first, then those of unknown margin; equals by key.
    """
    return tuple(sorted(rows, key=_place))


def _place(row: Row) -> tuple[int, float, str]:
    if row.status == "broken":
        return len(ORDER), 0.0, row.key
    return ORDER.index(row.outcome or "incomplete"), margin_of(row), row.key


def margin_of(row: Row) -> float:
    """Return the margin that ranks a row [-]: 1 / (D/C) where that of PGA is unknown, infinite if both are."""
    if row.margin is not None and isfinite(row.margin):
        return row.margin
    ratio = row.demand_capacity
    if ratio is None or ratio != ratio or ratio <= 0.0:
        return inf
    return 1.0 / ratio
