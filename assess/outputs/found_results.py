"""Results read again: completed where a run was interrupted, marked where they were changed since."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from assess.errors import AssessError, ResultsError
from assess.messages.message import Message, warning
from assess.outputs.journal import recover_for_reading
from assess.outputs.manifest import is_changed
from assess.results import Results
from assess.results.files import find_results, read, read_fragility
from assess.results.fragility import FragilityResults


@dataclass(frozen=True)
class FoundResults:
    """Results read from a file.

    Attributes
    ----------
    results : as read, with a warning where they were changed since they were written
    path : the file
    as_written : whether the folder's manifest shows them to be as they were written
    """

    results: Results
    path: Path
    as_written: bool

    @contextmanager
    def blame_changes(self) -> Iterator[None]:
        """Attribute errors in the block to the results, unless they are as the program wrote them."""
        try:
            yield
        except (AssessError, OSError):
            raise
        except Exception as error:
            if self.as_written:
                raise
            what = f"{type(error).__name__}: {error}"
            raise ResultsError(
                f"{self.path}: its parts do not fit together ({what[:200]}); run the project again"
            ) from error


def open_results(path: Path, *, tell: Callable[[Message], None]) -> FoundResults:
    """Read the results that a file or folder names, after completing what an interrupted command left there.

    Parameters
    ----------
    path : results.json, or a folder that contains it
    tell : called with each message on interrupted or changed files
    """
    for folder in (path, *sorted(path.glob("*-results"))) if path.is_dir() else (path.parent,):
        recover_for_reading(folder, tell=tell)
    file = find_results(path)
    results, differs = read(file), is_changed(file)
    if differs:
        found = warning("results-changed", str(file))
        tell(found)
        results = replace(results, warnings=(replace(found, where=file.name), *results.warnings))
    return FoundResults(results, file, as_written=differs is False)


def open_fragility(path: Path, *, tell: Callable[[Message], None]) -> FragilityResults:
    """Read the results of `assess fragility`, as `open_results` does those of `assess run`.

    Parameters
    ----------
    path : fragility.json
    tell : called with each message on interrupted or changed files
    """
    recover_for_reading(path.parent, tell=tell)
    results = read_fragility(path)
    if not is_changed(path):
        return results
    found = warning("results-changed", str(path))
    tell(found)
    return replace(results, warnings=(replace(found, where=path.name), *results.warnings))
