"""What a run was made from: the program, the files read, and the resolved values of the project."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class Program(ShortRepr):
    """The program that made the results.

    licence : of the package, such as "MIT"; "" in results of older versions, like the next two
    origin : who publishes it, with the address of its sources if the package names one
    sha256 : of its own files: of two runs with the same, the same code made both
    """

    name: str
    version: str
    licence: str = ""
    origin: str = ""
    sha256: str = ""


@dataclass(frozen=True, repr=False)
class Input(ShortRepr):
    """A file that was read: its path relative to the project file, and its SHA-256."""

    path: str
    sha256: str


@dataclass(frozen=True, repr=False)
class Resolved(ShortRepr):
    """A value of the project as used, in SI; given: whether by the user, or by default.

    dimensions : what its numbers measure, by the way to them from the key: "" for the value itself, "2.mass" for a key
    of the third of several tables; keys without a dimension are left out
    cov : coefficient of variation of those of its numbers that are means, by the same way; empty where all are certain
    """

    value: Any
    given: bool
    dimensions: dict[str, str] = field(default_factory=dict)
    cov: dict[str, float] = field(default_factory=dict)
