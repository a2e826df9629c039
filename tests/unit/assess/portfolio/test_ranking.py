"""The order of a portfolio: by outcome, then by margin, the broken ones at the end; the same for any order of rows."""

from __future__ import annotations

from itertools import permutations
from math import inf, nan

import pytest

from assess.portfolio.tasks import ProjectRow, RowOutcome, margin_of, rank


def row(key: str, outcome: RowOutcome, margin: float | None = None, ratio: float | None = None) -> ProjectRow:
    return ProjectRow(key, "", "", "done", outcome=outcome, margin=margin, demand_capacity=ratio)


IN_ORDER = (
    row("overturns", "fail", None, inf),
    row("worst", "fail", 0.4, 9.0),
    row("by ratio", "fail", None, 2.0),
    row("less", "fail", 0.9),
    row("unknown", "fail"),
    row("open", "incomplete", 0.2),
    row("no basis", ""),
    row("a twin", "pass", 1.2),
    row("b twin", "pass", 1.2),
    row("best", "pass", 3.0),
    ProjectRow("a broken", "", "", "broken", reason="no such file"),
    ProjectRow("b broken", "", "", "broken", outcome="fail", margin=0.1, reason="no such file"),
)


def test_order_is_that_of_an_owner() -> None:
    assert rank(reversed(IN_ORDER)) == IN_ORDER


def test_order_does_not_depend_on_that_of_the_rows() -> None:
    assert all(rank(rows) == IN_ORDER[5:10] for rows in permutations(IN_ORDER[5:10]))


@pytest.mark.parametrize("ratio", [None, nan, 0.0, -1.0])
def test_margin_without_a_number_is_the_last(ratio: float | None) -> None:
    assert margin_of(row("a", "fail", nan, ratio)) == inf
