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
    ├── HeldError          another command is writing there
    └── FullDiskError      no space is left on the disk

`records.errors.RecordError` and `spectra.errors.SpectrumError` stand beside them, because imports run one way.
Anything else that reaches the command line is a bug (exit code 70).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
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
    beside : what is wrong with a hinge that is stated beside its contact, which may be why it falls; may be empty
    """

    def __init__(self, text: str, multiplier: float | None = None, *, beside: str = "") -> None:
        super().__init__(text)
        self.multiplier, self.beside = multiplier, beside


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


class FullDiskError(OutputError):
    """No space is left on the disk, or no more of it is granted to the user."""


@contextmanager
def locate_errors(where: str) -> Iterator[None]:
    """Put `where` in front of the text of every error that the user can mend and that is raised within the block."""
    try:
        yield
    except (AssessError, SpectrumError) as error:
        located = type(error)(f"{where}: {error}")
        for other in other_faults(error):
            located.add_note(f"{where}: {other}")
        raise located from None


def other_faults(error: Exception) -> tuple[str, ...]:
    """Return what else is wrong with the input besides what an error says, each in one line."""
    return tuple(getattr(error, "__notes__", ()))


class Faults:
    """What is wrong with an input, gathered as far as its parts can be judged one without the other.

    kinds : of errors that are gathered besides our own and those of spectra
    """

    def __init__(self, *kinds: type[Exception]) -> None:
        self._kinds: tuple[type[Exception], ...] = (AssessError, SpectrumError, *kinds)
        self._found: list[Exception] = []

    @contextmanager
    def gather(self, *, besides: tuple[type[Exception], ...] = ()) -> Iterator[None]:
        """Keep the error that is raised within the block, and go on behind it; besides: kinds that are raised."""
        try:
            yield
        except besides:
            raise
        except self._kinds as error:
            self._found.append(error)

    @property
    def any(self) -> bool:
        """Whether an error was gathered."""
        return bool(self._found)

    def raise_all(self) -> None:
        """Raise the first error that was gathered, with the number of the others and each of them as a note."""
        lines = [line for error in self._found for line in _lines_of(error)]
        if lines:
            raise one_of_several(type(self._found[0]), lines)


def one_of_several(kind: type[Exception], lines: Sequence[str]) -> Exception:
    """Return an error that says the first of several faults and how many more there are; these are its notes.

    Parameters
    ----------
    kind : class of the error
    lines : the faults, each a line
    """
    first, *others = dict.fromkeys(lines)
    error = kind(first + _more(others))
    for other in others:
        error.add_note(other)
    return error


def _lines_of(error: Exception) -> tuple[str, ...]:
    others = other_faults(error)
    return (str(error).removesuffix(_more(others)), *others)


def _more(others: Sequence[str]) -> str:
    return f" (and {len(others)} more)" if others else ""
