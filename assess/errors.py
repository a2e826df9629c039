"""The exceptions, drawn as a tree.

AssessError                what a user can mend; the command line prints its one line and ends with exit code 2
├── ProjectError           the project file: missing, unreadable, unknown key, wrong unit or value
├── GeometryError          a body or mesh: open, inverted, degenerate
├── MechanismError         a mechanism that cannot rock: no base, already falling, impossible hinges
│   ├── CrackError         a wall whose crack cannot be found; told before its mechanism is named
│   └── FallingError       one that already falls by itself
├── InterfaceError         a contact that cannot carry its load: pulled, crushed at rest, without stiffness
├── ProcedureError         a code procedure asked outside its range
├── HazardError            a hazard curve that cannot be read, or whose rows do not fall as intensity rises
├── ResultsError           a results file that cannot be read
└── OutputError            a folder that cannot be written: files of others, or changed since they were written
    └── HeldError          another command is writing there

`records.errors.RecordError` and `spectra.errors.SpectrumError` stand beside them, because imports run one way.
Anything else that reaches the command line is a bug (exit code 70).
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from spectra.errors import SpectrumError


class AssessError(ValueError):
    """Something the user can mend: the text says what, where, the value and the remedy."""


class ProjectError(AssessError):
    """The project file is missing, unreadable or holds an unknown key, a wrong unit or a wrong value."""


class GeometryError(AssessError):
    """A body has no usable volume: open or inverted mesh, self-intersecting profile, no size."""


class MechanismError(AssessError):
    """A mechanism cannot rock as described: no base, already falling, impossible hinges."""


class CrackError(MechanismError):
    """The crack of a wall cannot be found, or lies where none can be; the mechanism is not named yet."""


class FallingError(MechanismError):
    """A mechanism already falls by itself, towards the direction or under its forces.

    multiplier : uplift multiplier at rest, 0 or negative; None where it is not known
    """

    def __init__(self, text: str, multiplier: float | None = None) -> None:
        super().__init__(text)
        self.multiplier = multiplier


class InterfaceError(AssessError):
    """A contact cannot carry what presses on it: no compression, more than it bears, no stiffness."""


class ProcedureError(AssessError):
    """A code procedure was asked something outside its range, or with an option it does not know."""


class HazardError(AssessError):
    """A hazard curve cannot be read, or its rows are not those of rates of exceedance."""


class ResultsError(AssessError):
    """A results file cannot be read."""


class OutputError(AssessError):
    """A place cannot be written: files that are not ours, or that were changed since they were written."""


class HeldError(OutputError):
    """Another command is writing there."""


@contextmanager
def locate_errors(where: str) -> Iterator[None]:
    """Put `where` in front of the text of every error that the user can mend and that is raised within the block."""
    try:
        yield
    except (AssessError, SpectrumError) as error:
        raise type(error)(f"{where}: {error}") from None
