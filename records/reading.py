"""Reading of record files, the format recognised from the first bytes; which files below a folder may be read.

`relative_path` is how a project file writes the path of a file.
"""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from records.errors import RecordError
from records.formats import FORMATS
from records.formats.header import HeaderOverrides, check_overrides
from records.record import Record

FINEST, COARSEST = 1e-5, 1.0  # s, of the steps of instruments and shaking tables
HEAD = 8192  # bytes that show a format
FILES_KEPT = 32  # files whose records are kept in memory


def read_record(
    path: str | Path, *, unit: str | None = None, step: float | None = None, response: str | Path | None = None
) -> Record | list[Record]:
    """Read a record file: one record, or a list where the file holds several components.

    Parameters
    ----------
    path : file in one of the formats of `records.formats`, recognised by its first bytes
    unit : of the accelerations (g, m/s2, cm/s2, gal, mm/s2), only where the file states none
    step : time step [s], only where the file states none
    response : file of the instrument's response (StationXML), for MiniSEED and SAC

    Returns
    -------
    Record or list of Record : accelerations [m/s2], in the order of the file

    Raises
    ------
    RecordError : as `read_with_overrides`
    """
    records = read_records(path, unit=unit, step=step, response=response)
    return records[0] if len(records) == 1 else list(records)


def read_records(
    path: str | Path, *, unit: str | None = None, step: float | None = None, response: str | Path | None = None
) -> tuple[Record, ...]:
    """Read every record of a file: a tuple, also of one.

    Parameters
    ----------
    path : file in one of the formats of `records.formats`, recognised by its first bytes
    unit, step, response : as in `read_record`

    Returns
    -------
    tuple of Record : accelerations [m/s2], in the order of the file

    Raises
    ------
    RecordError : names the file; it cannot be opened, matches no known format or more than one, holds something other
        than a record, has a time step no instrument has, or shows no motion at all
    """
    overrides = HeaderOverrides(unit, step, None if response is None else _as_path(response))
    return read_with_overrides(_as_path(path), overrides)


def read_with_overrides(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Read every record of the file at `path`, with `overrides` for what its header leaves out.

    Parameters
    ----------
    path : file in one of the known formats
    overrides : unit, step and response; refused if they are invalid, even where the file needs none of them

    Returns
    -------
    tuple of Record : accelerations [m/s2], in the order of the file

    Raises
    ------
    RecordError : names the file; it cannot be opened, matches no known format or more than one, holds something other
        than a record, has a time step no instrument has, or shows no motion at all
    """
    check_overrides(overrides)
    if path.is_dir():
        raise RecordError(f"{path}: is a folder; give the files in it, like {path / '*'}")
    try:
        with path.open("rb") as file:
            head = file.read(HEAD)
        with np.errstate(over="ignore", invalid="ignore"):  # values that overflow are refused by their sample below
            records = FORMATS[_format(head, path=path)].read(path, overrides)
    except OSError as error:
        raise RecordError(f"{path}: the file cannot be read: {error.strerror}") from None
    for record in records:
        _check_motion(record, path=path)
    return records


def recall_records(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return what `read_with_overrides` does, from memory if this process has lately read a file of the same content.

    The instrument's response is a file of its own: records that need one are always read.

    Parameters
    ----------
    path : file in one of the known formats
    overrides : as in `read_with_overrides`
    """
    check_overrides(overrides)
    if overrides.response is not None or not path.is_file():
        return read_with_overrides(path, overrides)
    try:
        with path.open("rb") as file:
            content = hashlib.file_digest(file, "sha256").digest()
    except OSError:
        return read_with_overrides(path, overrides)
    return _recall(path, overrides, content)


LARGEST_FILE = 500_000_000  # bytes of one record file


@dataclass(frozen=True)
class RecordFile:
    """A file below the folder as it is; problem "" where it may be read; stored: its hash when it was last read."""

    path: str
    size: int
    mtime: int
    problem: str = ""
    stored: str = ""


def files_below(folder: Path) -> Iterator[RecordFile]:
    """Yield every file below `folder` but hidden ones, in a fixed order; links that lead out of it as problems."""
    if folder.is_file():
        raise RecordError(f"{folder}: is a file; give the folder that holds it, {folder.parent}")
    if not folder.is_dir():
        raise RecordError(f"{folder}: no such folder; give the folder that holds the record files")
    root = folder.resolve()
    for place, folders, names in os.walk(folder, onerror=_unreadable):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in sorted(name for name in names if not name.startswith(".")):
            file = Path(place) / name
            yield _record_file(file, file.relative_to(folder).as_posix(), root)


def relative_path(path: Path, folder: Path) -> str:
    """Return a path as the project file in a folder would write it: relative to the folder if it lies inside.

    Parameters
    ----------
    path : of a file
    folder : of the project file

    Returns
    -------
    the path with slashes
    """
    return path.relative_to(folder).as_posix() if path.is_relative_to(folder) else path.as_posix()


def _as_path(path: str | Path) -> Path:
    """Return a path; raise RecordError for what is none."""
    if not isinstance(path, str | Path) or "\0" in str(path):
        raise RecordError(f"{path!r:.60} is no path; give the path of one file")
    return Path(path)


@lru_cache(maxsize=FILES_KEPT)
def _recall(path: Path, overrides: HeaderOverrides, content: bytes) -> tuple[Record, ...]:
    """Read the file of that content."""
    return read_with_overrides(path, overrides)


def _check_motion(record: Record, *, path: Path) -> None:
    """Refuse a time step that no instrument has, and a record without motion."""
    if not FINEST <= record.dt <= COARSEST:
        raise RecordError(
            f"{path}: a time step of {record.dt:.6g} s; records have {FINEST:g} to {COARSEST:g} s, check its unit"
        )
    if np.ptp(record.acceleration) == 0.0:
        raise RecordError(
            f"{path}: every acceleration is {record.acceleration[0]:.6g} m/s2; there is no motion in the record"
        )


def _format(head: bytes, *, path: Path) -> str:
    """Return the name of the one format that matches `head`, the first bytes of the file."""
    if not head.strip():
        raise RecordError(f"{path}: the file is empty")
    names = [name for name, known in FORMATS.items() if known.looks_like(head)]
    if not names:
        raise RecordError(
            f"{path}: not a record format known here ({', '.join(FORMATS)}); convert the file to one of them"
        )
    if len(names) > 1:
        raise RecordError(f"{path}: the file could be {' or '.join(names)}; convert it so that only one fits")
    return names[0]


def _unreadable(error: OSError) -> None:
    raise RecordError(f"{error.filename}: the folder cannot be read: {error.strerror}")


def _record_file(file: Path, path: str, root: Path) -> RecordFile:
    """Return a file with the reason why it may not be read; `path` from the folder, `root` the folder resolved."""
    shown = path.encode("utf-8", "replace").decode()
    try:
        status = file.stat()
        if shown != path:
            return RecordFile(shown, 0, 0, "its name is not UTF-8; rename it")
        if not file.resolve().is_relative_to(root):
            return RecordFile(path, 0, 0, "a link that leads out of the folder; it is not followed")
    except (OSError, RuntimeError):
        return RecordFile(shown, 0, 0, "cannot be found or opened; a broken link, or no permission")
    if not stat.S_ISREG(status.st_mode):
        return RecordFile(path, 0, 0, "not a regular file")
    problem = f"{status.st_size} bytes are too many for a record" if status.st_size > LARGEST_FILE else ""
    return RecordFile(path, status.st_size, status.st_mtime_ns, problem)
