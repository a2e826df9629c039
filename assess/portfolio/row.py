"""What one project of a portfolio comes to: a row of the ranked table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Status = Literal["done", "broken"]
RowOutcome = Literal["pass", "fail", "incomplete", ""]


@dataclass(frozen=True)
class Row:
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
