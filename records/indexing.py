"""Bringing the catalogue of a folder up to date: only files that are new or have changed are read.

A file is unchanged where its size and time of change are, or else where its hash is. Batches are committed as they
come, so that an index that was stopped goes on where it ended. Files that cannot be read are kept with the reason.
"""

from __future__ import annotations

import hashlib
import os
import sqlite3
import stat
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import TypeVar

import numpy as np

from records import catalogue
from records.candidates import DAMPING, PERIODS, Candidate, sequence_number
from records.catalogue import MEASURES, Catalogue, problems
from records.errors import RecordError
from records.formats import FORMATS
from records.formats.header_overrides import NO_OVERRIDES, HeaderOverrides, check_overrides
from records.intensity import measures
from records.reading import read_with
from records.record import Record
from records.response import response_spectrum
from records.seal import seal, with_seal

BATCH = 50  # files to a commit
FEW = 24  # files that are read here rather than by an executor, whose workers take seconds to start
LARGEST = 500_000_000  # bytes of one record file
Progress = Callable[[int, int], None]
T = TypeVar("T")
R = TypeVar("R")


@dataclass(frozen=True)
class Indexed:
    """What an index did: files read and unchanged, those that are gone, records in all, (path, reason) of the rest.

    damaged : files whose rows were changed since they were written, and that were read again
    older : whether the catalogue was of an older version, so that all was read again
    """

    read: int
    unchanged: int
    gone: int
    records: int
    problems: tuple[tuple[str, str], ...]
    damaged: tuple[str, ...] = ()
    older: bool = False


@dataclass(frozen=True)
class Found:
    """A file below the folder as it is; problem "" where it may be read; stored: its hash when it was last read."""

    path: str
    size: int
    mtime: int
    problem: str = ""
    stored: str = ""


@dataclass(frozen=True)
class Described:
    """What was read from a file; candidates None where its content is that of the last time."""

    found: Found
    sha256: str
    problem: str
    candidates: tuple[Candidate, ...] | None


def index(
    folder: Path,
    connection: sqlite3.Connection,
    *,
    overrides: HeaderOverrides = NO_OVERRIDES,
    executor: Executor | None = None,
    progress: Progress = lambda done, total: None,
) -> Indexed:
    """Bring the catalogue `connection` of `folder` and what is below it up to date.

    overrides : what headers leave out, kept in the catalogue for later (files read with other values are read again);
    executor : of processes, that read where files are many. Raises RecordError where the folder is none, and
    for a unit, step or response that cannot be.
    """
    check_overrides(overrides)
    overrides = overrides.over(catalogue.header_overrides(connection))
    asked = f"{overrides.key} {' '.join(FORMATS)}"
    on_disk = {found.path: found for found in files_below(folder)}
    damaged = catalogue.mend(connection)
    known = {
        row[0]: row[1:] for row in connection.execute("SELECT path, size, mtime, sha256, asked, problem FROM files")
    }
    catalogue.store_overrides(connection, overrides)
    gone = [path for path in known if path not in on_disk]
    changed = [
        _with_hash(found, known.get(path), asked)
        for path, found in on_disk.items()
        if not _same(found, known.get(path), asked)
    ]
    with connection:
        connection.executemany("DELETE FROM files WHERE path = ?", [(path,) for path in gone])
    _read(folder, changed, connection, overrides=overrides, asked=asked, executor=executor, progress=progress)
    number = int(connection.execute("SELECT COUNT(*) FROM records").fetchone()[0])
    older = isinstance(connection, Catalogue) and connection.older
    counts = (len(changed), len(on_disk) - len(changed), len(gone), number)
    return Indexed(*counts, problems(connection), tuple(path for path in damaged if path in on_disk), older)


def files_below(folder: Path) -> Iterator[Found]:
    """Every file below `folder`, hidden ones left out, in a fixed order; links that lead out of it as problems."""
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


def _same(found: Found, known: tuple[object, ...] | None, asked: str) -> bool:
    """Whether the catalogue has the file as it is: size, time and, where it was not read, what was asked."""
    if known is None:
        return False
    size, mtime, _, before, problem = known
    return (
        (size, mtime) == (found.size, found.mtime)
        and before == asked
        and (not found.problem or found.problem == problem)
    )


def _with_hash(found: Found, known: tuple[object, ...] | None, asked: str) -> Found:
    """The file with the hash of when it was last read, as long as the same was asked then."""
    if known is None or known[3] != asked:
        return found
    return Found(found.path, found.size, found.mtime, found.problem, str(known[2]))


def _read(
    folder: Path,
    files: list[Found],
    connection: sqlite3.Connection,
    *,
    overrides: HeaderOverrides,
    asked: str,
    executor: Executor | None,
    progress: Progress,
) -> None:
    describe = partial(described, folder, overrides=overrides)
    results = _mapped(describe, files, executor=executor)
    batch: list[Described] = []
    for done, one in enumerate(results, start=1):
        batch.append(one)
        progress(done, len(files))
        if len(batch) == BATCH:
            _store(connection, batch, asked)
            batch = []
    _store(connection, batch, asked)


def _mapped(verb: Callable[[T], R], things: Sequence[T], *, executor: Executor | None) -> Iterable[R]:
    """The verb of each thing, in order; by the executor where they are many."""
    if executor is None or len(things) <= FEW:
        return map(verb, things)
    return executor.map(verb, things, chunksize=4)


def described(folder: Path, found: Found, *, overrides: HeaderOverrides) -> Described:
    """The records of one file with their measures and spectra, or why there are none."""
    if found.problem:
        return Described(found, "", found.problem, ())
    file = folder / found.path
    try:
        with warnings.catch_warnings(), file.open("rb") as opened:
            warnings.simplefilter("ignore")
            sha256 = hashlib.file_digest(opened, "sha256").hexdigest()
            if sha256 == found.stored:
                return Described(found, sha256, "", None)
            made = tuple(candidate(record, found.path, i) for i, record in enumerate(read_with(file, overrides)))
    except (RecordError, OSError) as error:
        return Described(found, "", str(error).removeprefix(f"{file}: "), ())
    except Exception as error:  # of a thousand files one may meet a fault of a reader: the others go on
        return Described(found, "", f"its reader failed: {type(error).__name__}: {error}", ())
    return Described(found, sha256, "", made)


def candidates_of(
    files: Sequence[Path], *, overrides: HeaderOverrides = NO_OVERRIDES, executor: Executor | None = None
) -> tuple[Candidate, ...]:
    """Every record of `files`, in order, without a catalogue. Raises RecordError for the first that cannot be read."""
    return tuple(
        one for made in _mapped(partial(_candidates, overrides=overrides), files, executor=executor) for one in made
    )


def _candidates(file: Path, *, overrides: HeaderOverrides) -> tuple[Candidate, ...]:
    return tuple(
        candidate(record, str(file), i, overrides=overrides) for i, record in enumerate(read_with(file, overrides))
    )


def candidate(record: Record, path: str, position: int = 0, *, overrides: HeaderOverrides = NO_OVERRIDES) -> Candidate:
    """What a catalogue keeps of a record, and what was `overrides` of its file."""
    return Candidate(
        path=path,
        position=position,
        id=record.id,
        event=record.event,
        station=record.station,
        component=record.component,
        date=record.earthquake.time,
        magnitude=record.earthquake.magnitude,
        distance=record.distance,
        vs30=record.site.vs30,
        place=record.site.place,
        nga=sequence_number(path),
        dt=record.dt,
        npts=record.npts,
        measures=asdict(measures(record)),
        spectrum=response_spectrum(record, PERIODS, damping=DAMPING),
        overrides=overrides,
    )


def _store(connection: sqlite3.Connection, batch: list[Described], asked: str) -> None:
    """One batch, whole or not at all."""
    with connection:
        for one in batch:
            found = one.found
            count = 0 if one.candidates is None else len(one.candidates)
            row = (found.path, found.size, found.mtime, one.sha256, asked, one.problem)
            if one.candidates is None:
                count = connection.execute("SELECT COUNT(*) FROM records WHERE path = ?", (found.path,)).fetchone()[0]
                values = (found.size, found.mtime, seal((*row, count)), found.path)
                connection.execute("UPDATE files SET size = ?, mtime = ?, seal = ? WHERE path = ?", values)
                continue
            connection.execute("DELETE FROM files WHERE path = ?", (found.path,))
            connection.execute("INSERT INTO files VALUES (?, ?, ?, ?, ?, ?, ?, ?)", with_seal((*row, count)))
            rows = [_row(each) for each in one.candidates]
            if rows:
                marks = ", ".join("?" * len(rows[0]))
                connection.executemany(f"INSERT INTO records VALUES ({marks})", rows)


def _row(one: Candidate) -> tuple[object, ...]:
    texts = (_text(one.id), _text(one.event), _text(one.station), _text(one.component), _text(one.date))
    known = (one.magnitude, one.distance, one.vs30, _text(one.place), one.nga)
    spectrum = np.asarray(one.spectrum, dtype="<f8").tobytes()
    of = (one.measures[name] for name in MEASURES)
    return with_seal((one.path, one.position, *texts, *known, one.dt, one.npts, spectrum, *of))


def _text(text: str) -> str:
    return text.encode("utf-8", "replace").decode()
