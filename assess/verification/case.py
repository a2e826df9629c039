"""A solved case as its file gives it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any, ClassVar

from assess.results.verification import Source, Tolerance

STRICT: Any = {"extra": "forbid", "strict": True, "allow_inf_nan": False}
"""How the tables of a case are read: no unknown key, no text for a number, no number that is not finite."""

LARGEST = 1e100
"""The largest number of a case, and one over the least that is not zero: differences and ratios stay finite."""


@dataclass(frozen=True)
class Misprint:
    """A printed value that is taken to be a misprint: its likeliest reading, and why."""

    __pydantic_config__: ClassVar = STRICT
    reading: float
    reason: str


@dataclass(frozen=True)
class Quantity:
    """What is compared: the expected values by their rows.

    path : place of the value in the tree that the solver returns, with dots; `{row}` stands for the row. Items of
        lists are found by their `name`, `id`, `procedure`, `symbol` or `record`, or by their number
    over : place of a value that the found one is divided by; none if empty
    values : expected, by row; one row named "" for a single value
    factor : what the found value is multiplied by to get the unit of the source
    misprints : by row
    """

    __pydantic_config__: ClassVar = STRICT
    name: str
    path: str
    tolerance: Tolerance
    values: dict[str, float]
    unit: str = ""
    over: str = ""
    factor: float = 1.0
    misprints: dict[str, Misprint] = field(default_factory=dict)


@dataclass(frozen=True)
class Case:
    """A solved case.

    title, theory, field, source : as in `CaseResult`
    uses : what it exercises, in the words of `assess.results.uses`
    solver : a key of `SOLVERS`
    given : what it solves; for "project" `file`, beside the case, or `example`
    quick : whether `assess verify --quick` runs it
    departures : as in `CaseResult`
    """

    __pydantic_config__: ClassVar = STRICT
    title: str
    theory: str
    field: str
    uses: tuple[str, ...]
    source: Source
    solver: str
    given: dict[str, Any]
    quantities: tuple[Quantity, ...]
    quick: bool = True
    departures: tuple[str, ...] = ()


@dataclass(frozen=True)
class CaseFile:
    """A case with its key, such as "housner_1963/free_rocking", and the path of its file."""

    key: str
    path: Path
    case: Case

    @property
    def names(self) -> tuple[str, ...]:
        """The files that it is given, relative to its own: `file`, and those of `files`."""
        one, several = self.case.given.get("file"), self.case.given.get("files", ())
        return (*(() if one is None else (str(one),)), *map(str, several))

    @property
    def paths(self) -> tuple[Path, ...]:
        """The file itself, and those that it is given."""
        return (self.path, *(self.path.parent / name for name in self.names))

    def beside(self, name: str) -> str:
        """Return the path of a file that stands beside the case, relative to the folder of cases."""
        return (PurePosixPath(self.key).parent / name).as_posix()

    @property
    def project_folder(self) -> str:
        """The folder of its project, relative to that of the cases; an example has one of its own."""
        example = self.case.given.get("example")
        return self.beside(str(PurePosixPath(self.names[0]).parent)) if example is None else f"examples/{example}"
