"""What a run was made from: the program, the files read, and the resolved values of the project."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class Program(ShortRepr):
    """The program that made the results.

    licence : of the package, such as "MIT"; "" in results of older versions, like the next two
    origin : who publishes it, with the address of its sources if the package names one
    sha256 : of its own Python files: of two runs with the same, the same code made both
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
    """A value of the project as used, in SI; given: whether by the user, or by default."""

    value: Any
    given: bool
