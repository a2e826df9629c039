"""A solved case as its file gives it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from assess.results.verification import Source, Tolerance


@dataclass(frozen=True)
class Misprint:
    """A printed value that is held for a misprint: its likeliest reading, and why."""

    reading: float
    reason: str


@dataclass(frozen=True)
class Quantity:
    """What is compared: the expected values by their rows.

    path : place of the value in the tree that the solver returns, with dots; `{row}` stands for the row. Items of
        lists are found by their `name`, `id`, `procedure` or `symbol`, or by their number
    values : expected, by row; one row named "" for a single value
    factor : what the found value is multiplied by to get the unit of the source
    misprints : by row
    """

    name: str
    path: str
    tolerance: Tolerance
    values: dict[str, float]
    unit: str = ""
    factor: float = 1.0
    misprints: dict[str, Misprint] = field(default_factory=dict)


@dataclass(frozen=True)
class Case:
    """A solved case.

    title, theory, field, uses, source : as in `CaseResult`
    solver : a key of `SOLVERS`
    given : what it solves; for "project" `file`, beside the case, or `example`
    quick : whether `assess verify --quick` runs it
    """

    title: str
    theory: str
    field: str
    uses: tuple[str, ...]
    source: Source
    solver: str
    given: dict[str, Any]
    quantities: tuple[Quantity, ...]
    quick: bool = True


@dataclass(frozen=True)
class CaseFile:
    """A case with its key, such as "housner_1963/free_rocking", and the path of its file."""

    key: str
    path: Path
    case: Case
