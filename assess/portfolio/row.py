"""What one project of a portfolio comes to: a row of the ranked table, and the order of rows.

What fails comes first, by how little it bears; what is broken last.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf, isfinite
from typing import Literal

Status = Literal["done", "broken"]
RowOutcome = Literal["pass", "fail", "incomplete", ""]


@dataclass(frozen=True)
class ProjectRow:
    """One project of a portfolio, assessed or broken. It is plain: processes and the ledger exchange it as it is.

    Attributes
    ----------
    key : path of the project below the folder, or its cell in the table's id column
    title : title of the project
    sha256 : of everything the task reads
    status : "done", or "broken" for a project that could not be assessed
    reason : why it is broken, in one line; "" for one that is done
    outcome : of the verdict; "" where there is none
    basis : what decides, such as "ntc2018"
    limit_state : the limit state that decides
    worst_mechanism : name of the mechanism with the smallest margin
    margin : PGA at its capacity over that of the action [-]; None where unknown
    demand_capacity : its deciding demand over capacity [-]; None where unknown
    procedure : the procedure that gives it
    missing : number of inputs that the verdict lacks
    warnings : number of warnings on the input, as `assess check` prints them
    mechanisms : number of mechanisms
    report : link to the report, relative to the table; "" for none
    results : link to results.json, relative to the table; "" for none
    exit_code : that of `assess run`: 0 pass, 1 fail, 3 incomplete, 2 wrong input, 70 a bug
    """

    key: str
    title: str
    sha256: str
    status: Status
    reason: str = ""
    outcome: RowOutcome = ""
    basis: str = ""
    limit_state: str = ""
    worst_mechanism: str = ""
    margin: float | None = None
    demand_capacity: float | None = None
    procedure: str = ""
    missing: int = 0
    warnings: int = 0
    mechanisms: int = 0
    report: str = ""
    results: str = ""
    exit_code: int = 0


RANKED_OUTCOMES = ("fail", "incomplete", "pass")
"""Outcomes in the order of a ranking; a project without any verdict stands with the incomplete ones."""


def rank(rows: Iterable[ProjectRow]) -> tuple[ProjectRow, ...]:
    """Return the rows in the order in which an owner wants to read them.

    Projects that fail come first, then those without an answer, then those that pass, and broken ones at the end; in
    each of these the least margin first, then those of unknown margin; equals by key.
    """
    return tuple(sorted(rows, key=_rank_key))


def _rank_key(row: ProjectRow) -> tuple[int, float, str]:
    if row.status == "broken":
        return len(RANKED_OUTCOMES), 0.0, row.key
    return RANKED_OUTCOMES.index(row.outcome or "incomplete"), margin_of(row), row.key


def margin_of(row: ProjectRow) -> float:
    """Return the margin that ranks a row [-]: 1 / (D/C) where that of PGA is unknown, infinite if both are."""
    if row.margin is not None and isfinite(row.margin):
        return row.margin
    ratio = row.demand_capacity
    if ratio is None or ratio != ratio or ratio <= 0.0:
        return inf
    return 1.0 / ratio
