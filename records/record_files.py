"""The files below a folder of records: which may be read, and why the others may not."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from records.errors import RecordError

LARGEST = 500_000_000  # bytes of one record file


@dataclass(frozen=True)
class Found:
    """A file below the folder as it is; problem "" where it may be read; stored: its hash when it was last read."""

    path: str
    size: int
    mtime: int
    problem: str = ""
    stored: str = ""


def files_below(folder: Path) -> Iterator[Found]:
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
            yield _found(file, file.relative_to(folder).as_posix(), root)


def _unreadable(error: OSError) -> None:
    raise RecordError(f"{error.filename}: the folder cannot be read: {error.strerror}")


def _found(file: Path, path: str, root: Path) -> Found:
    shown = path.encode("utf-8", "replace").decode()
    try:
        status = file.stat()
        if shown != path:
            return Found(shown, 0, 0, "its name is not UTF-8; rename it")
        if not file.resolve().is_relative_to(root):
            return Found(path, 0, 0, "a link that leads out of the folder; it is not followed")
    except (OSError, RuntimeError):
        return Found(shown, 0, 0, "cannot be found or opened; a broken link, or no permission")
    if not stat.S_ISREG(status.st_mode):
        return Found(path, 0, 0, "not a regular file")
    problem = f"{status.st_size} bytes are too many for a record" if status.st_size > LARGEST else ""
    return Found(path, status.st_size, status.st_mtime_ns, problem)
