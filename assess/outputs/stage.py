"""Temporary folders in which outputs are made before they are moved into place, on the same disk."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from secrets import token_hex

from assess.errors import OutputError
from assess.outputs.lock import LOCK, hold_lock, is_abandoned
from assess.outputs.signals import defer_signals

PREFIX = ".assess-partial-"
MADE, OLD, JOURNAL = "made", "old", "journal.json"
_DAY = 86400.0  # s


@contextmanager
def stage(place: Path, *, command: str) -> Iterator[Path]:
    """Give a new hidden folder in `place`, with an empty folder `made`; it is removed unless its journal is open.

    Parameters
    ----------
    place : Path
        The folder to make it in.
    command : str
        The command that uses it, named in its lock.

    Yields
    ------
    Path
        The stage.

    Raises
    ------
    OutputError
        If nothing can be written in `place`.
    """
    folder = place / f"{PREFIX}{token_hex(6)}"
    try:
        _make(folder)
        with hold_lock(folder, command=command):
            try:
                (folder / MADE).mkdir()
                yield folder
            finally:
                with defer_signals():
                    _empty(folder)
    finally:
        with defer_signals():
            if not (folder / JOURNAL).exists():
                remove(folder)


def _make(folder: Path) -> None:
    try:
        folder.mkdir(mode=0o700)
    except OSError as error:
        raise OutputError(
            f"{folder.parent}: nothing can be written there ({error.strerror}); give another place"
        ) from None


def _empty(folder: Path) -> None:
    """Remove the files of a stage except its lock, which goes last; none while moves are unfinished."""
    for each in () if (folder / JOURNAL).exists() else folder.iterdir():
        if each.name != LOCK:
            remove(each)


def left_behind(place: Path, *, alone: bool = False) -> list[Path]:
    """Return the stages in `place` that no command uses; alone: no other command can begin one there now."""
    try:
        found = sorted(place.glob(f"{PREFIX}*"))
    except OSError:
        return []
    return [each for each in found if _left(each, alone=alone)]


def _left(found: Path, *, alone: bool) -> bool:
    """Return whether a stage is abandoned; one without a signed lock may just be beginning, or was stopped then."""
    lock = found / LOCK
    try:
        if lock.is_file():
            return is_abandoned(lock, unsigned=alone or _old(lock))
        return alone or _old(found)
    except OSError:
        return False


def _old(path: Path) -> bool:
    return time.time() - path.lstat().st_mtime > _DAY


def clear(place: Path) -> None:
    """Remove the abandoned stages in `place` that hold no old files."""
    for each in left_behind(place):
        if not (each / OLD).exists():
            remove(each)


def remove(found: Path) -> None:
    """Remove a stage; a link is removed, not followed."""
    if found.is_dir() and not found.is_symlink():
        shutil.rmtree(found, ignore_errors=True)
        return
    with suppress(OSError):
        found.unlink()


def files_in(folder: Path) -> list[str]:
    """Return every file below `folder`, as a sorted list of paths with slashes."""
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if not path.is_dir())


def flush(path: Path) -> None:
    """Flush a file, or the names in a folder, to the disk."""
    if os.name == "nt" and path.is_dir():
        return  # Windows opens no folders
    handle = os.open(path, os.O_RDONLY if path.is_dir() else os.O_RDWR)
    try:
        os.fsync(handle)
    except OSError:
        if not path.is_dir():  # some network disks flush files only
            raise
    finally:
        os.close(handle)
