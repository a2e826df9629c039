"""Outputs are written whole or not at all.

Everything is made in a folder of its own, then moved into place file by file. If anything fails, also half-way
through the moving, the folder is as it was. A hidden list remembers which files are ours: the next run replaces them
and takes away those it no longer makes, so that an old report never lies beside new results. Other files stay.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path, PurePosixPath

from assess.errors import AssessError

LIST = ".assess-outputs"
RESULTS = "results.json"
LISTS = {RESULTS: LIST, (ENVELOPES := "envelopes.json"): ".assess-envelopes"}
"""What each command writes its results to, and where it remembers its files: one takes away none of the other's."""


@contextmanager
def staged(folder: Path, *, results: str = RESULTS) -> Iterator[Path]:
    """A temporary folder; what the block leaves in it stands in `folder` afterwards, if the block raised nothing.

    results : the file of results among it, of `LISTS`
    """
    if folder.exists() and not folder.is_dir():
        raise AssessError(f"{folder}: is a file; give a folder for the output")
    stage = _stage(folder)
    try:
        made, old = stage / "made", stage / "old"
        made.mkdir()
        yield made
        _move_into_place(made, folder, old, results=results)
    finally:
        shutil.rmtree(stage, ignore_errors=True)


def _stage(folder: Path) -> Path:
    """A new folder beside what is to be written."""
    place = _nearest_folder(folder)
    try:
        return Path(tempfile.mkdtemp(prefix=".assess-partial-", dir=place))
    except OSError as error:
        raise AssessError(
            f"{folder}: nothing can be written in {place} ({error.strerror}); give another folder"
        ) from None


def _nearest_folder(folder: Path) -> Path:
    """`folder` or the nearest above it that exists: on the same disk, so that moving is one step."""
    return next(place for place in (folder, *folder.absolute().parents) if place.is_dir())


def _move_into_place(made: Path, folder: Path, old: Path, *, results: str) -> None:
    files, listing = _files(made), LISTS[results]
    ours = _ours(folder / listing)
    gone = [name for name in ours if name not in files and name != results]  # a report made again keeps its results
    kept = [results] if results in ours and results not in files else []
    (made / listing).write_text("".join(f"{name}\n" for name in sorted([*files, *kept])), encoding="utf-8")
    _refuse_what_is_not_ours(folder, files, ours)
    done: list[tuple[Path, Path]] = []
    try:
        for name in [*files, *gone, listing]:
            _move(folder / name, old / name, done)
            _move(made / name, folder / name, done)
    except BaseException:
        for source, target in reversed(done):
            os.replace(target, source)
        _remove_empty(folder, files)
        raise
    _remove_empty(folder, gone)


def _move(source: Path, target: Path, done: list[tuple[Path, Path]]) -> None:
    if source.is_file():
        target.parent.mkdir(parents=True, exist_ok=True)
        os.replace(source, target)
        done.append((source, target))


def _remove_empty(folder: Path, names: list[str]) -> None:
    """Remove the folders below `folder` that held or were to hold `names` and are empty."""
    for parent in {str(PurePosixPath(name).parent) for name in names} - {"."}:
        with suppress(OSError):
            (folder / parent).rmdir()


def _refuse_what_is_not_ours(folder: Path, files: list[str], ours: list[str]) -> None:
    for name in files:
        if (folder / name).is_dir():
            raise AssessError(f"{folder / name}: is a folder where a file is to be written; move it away")
        if (folder / name).exists() and name not in ours:
            raise AssessError(
                f"{folder / name}: was not written by assess, or by another of its commands; move it away, "
                "or give another folder with -o"
            )


def _files(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def _ours(listing: Path) -> list[str]:
    """What the last run wrote here. Names that lead out of the folder are not ours."""
    try:
        names = listing.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return []
    paths = [PurePosixPath(name) for name in names if name]
    return [str(path) for path in paths if not path.is_absolute() and ".." not in path.parts]
