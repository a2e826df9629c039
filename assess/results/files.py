"""Files of results, found and read."""

from __future__ import annotations

import stat
from pathlib import Path

from assess.errors import ResultsError
from assess.results.fragility import FragilityResults
from assess.results.json import REMEDY, VERIFY_AGAIN, loads, loads_fragility, loads_verification
from assess.results.run import Results
from assess.results.verification import VerificationResults

NAMES = ("results.json", "envelopes.json")
"""Files of results, as `assess run` and `assess envelope` write them."""

FRAGILITY = "fragility.json"

LARGEST = 500_000_000
"""Bytes of a file of results; one of eight mechanisms and seven records has some three million."""


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
