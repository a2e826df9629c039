"""Files of results found and read: completed where a run was interrupted, marked where they were changed since."""

from __future__ import annotations

import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from assess.errors import AssessError, ResultsError
from assess.messages.message import Message, warning
from assess.outputs.journal import recover_for_reading
from assess.outputs.manifest import is_changed
from assess.results import Results
from assess.results.fragility import FragilityResults
from assess.results.json import REMEDY, VERIFY_AGAIN, loads, loads_fragility, loads_verification
from assess.results.verification import VerificationResults

NAMES = ("results.json", "envelopes.json")
"""Files of results, as `assess run` and `assess envelope` write them."""

FRAGILITY = "fragility.json"

LARGEST = 500_000_000
"""Bytes of a file of results; one of eight mechanisms and seven records has some three million."""


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


def read(path: Path) -> Results:
    """Read results from a file; raise ResultsError for a file that is missing, not regular, or too large."""
    return loads(_text(path), source=str(path))


def read_fragility(path: Path) -> FragilityResults:
    """Read the results of `assess fragility`, as `read` does those of `assess run`."""
    return loads_fragility(_text(path), source=str(path))


def read_verification(path: Path) -> VerificationResults:
    """Read the results of `assess verify`, as `read` does those of `assess run`."""
    return loads_verification(_text(path, VERIFY_AGAIN), source=str(path))


def _text(path: Path, remedy: str = REMEDY) -> str:
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise ResultsError(f"{path}: {'is a directory' if path.is_dir() else 'not a regular file'}; {remedy}")
        if status.st_size > LARGEST:
            size = f"{status.st_size / 1e6:.0f} MB are more than the {LARGEST / 1e6:.0f} MB"
            raise ResultsError(f"{path}: {size} that results may have; {remedy}")
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise ResultsError(f"{path}: not a text file; {remedy}") from None
    except OSError as error:
        raise ResultsError(f"{path}: {error.strerror or 'cannot be read'}; {remedy}") from None


def find_results(path: Path) -> Path:
    """Find the results file that `path` names: itself, or the one in the folder, or in its only NAME-results folder.

    Raises ResultsError if there is none, or more than one, or if it is that of `assess fragility`.
    """
    if path.name == FRAGILITY:
        raise ResultsError(
            f"{path}: of `assess fragility`, whose curves are not compared; compare its tables, or two results.json"
        )
    if not path.is_dir():
        return path
    here = [file for name in NAMES if (file := path / name).is_file()]
    below = sorted(path.glob(f"*-results/{NAMES[0]}"))
    if here or len(below) == 1:
        return (here or below)[0]
    found = "none of " + " or ".join(NAMES) if not below else f"{len(below)} folders of results"
    raise ResultsError(f"{path}: a folder with {found}; {REMEDY}")
