"""Bringing the catalogue of a folder up to date: only files that are new or have changed are read.

A file is unchanged where its size and time of change are, or else where its hash is. Batches are committed as they
come, so that an index that was stopped goes on where it ended. Files that cannot be read are kept with the reason.
"""

from __future__ import annotations

import hashlib
import sqlite3
import warnings
from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from records import catalogue
from records.candidates import Candidate, describe_record, map_files
from records.catalogue import MEASURES, Catalogue, problems, seal, with_seal
from records.errors import RecordError
from records.formats import FORMATS
from records.formats.header import NO_OVERRIDES, HeaderOverrides, check_overrides
from records.reading import RecordFile, files_below, read_with_overrides

BATCH = 50  # files to a commit
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class IndexSummary:
    """What an index did: files read, unchanged and gone, records in all, (path, reason) of files that cannot be read.

    damaged : files whose rows were changed since they were written, and that were read again older : whether the
    catalogue was of an older version, so that every file was read again
    """

    read: int
    unchanged: int
    gone: int
    records: int
    problems: tuple[tuple[str, str], ...]
    damaged: tuple[str, ...] = ()
    older: bool = False


@dataclass(frozen=True)
class DescribedFile:
    """What was read from a file; candidates None where its content is that of the last time."""

    found: RecordFile
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
) -> IndexSummary:
    """Bring the catalogue of a folder and its subfolders up to date.

    Parameters
    ----------
    folder : with the record files
    connection : its open catalogue
    overrides : for what headers leave out, kept for later runs (files read with other values are read again)
    executor : of processes, that read where files are many
    progress : called with the number of files read and their total

    Raises
    ------
    RecordError : the folder does not exist; a unit, step or response is invalid
    """
    check_overrides(overrides)
    overrides = overrides.over(catalogue.header_overrides(connection))
    asked = f"{overrides.key} {' '.join(FORMATS)}"
    on_disk = {found.path: found for found in files_below(folder)}
    damaged = catalogue.remove_damaged(connection)
    known = {
        row[0]: row[1:] for row in connection.execute("SELECT path, size, mtime, sha256, asked, problem FROM files")
    }
    catalogue.store_overrides(connection, overrides)
    gone = [path for path in known if path not in on_disk]
    changed = [
        _with_hash(found, known.get(path), asked)
        for path, found in on_disk.items()
        if not _unchanged(found, known.get(path), asked)
    ]
    with connection:
        connection.executemany("DELETE FROM files WHERE path = ?", [(path,) for path in gone])
    _read_changed(folder, changed, connection, overrides=overrides, asked=asked, executor=executor, progress=progress)
    number = int(connection.execute("SELECT COUNT(*) FROM records").fetchone()[0])
    older = isinstance(connection, Catalogue) and connection.older
    counts = (len(changed), len(on_disk) - len(changed), len(gone), number)
    return IndexSummary(*counts, problems(connection), tuple(path for path in damaged if path in on_disk), older)


def _unchanged(found: RecordFile, known: tuple[object, ...] | None, asked: str) -> bool:
    """Return whether the catalogue has the file as it is: size, time and, where it was not read, what was asked."""
    if known is None:
        return False
    size, mtime, _, before, problem = known
    return (
        (size, mtime) == (found.size, found.mtime)
        and before == asked
        and (not found.problem or found.problem == problem)
    )


def _with_hash(found: RecordFile, known: tuple[object, ...] | None, asked: str) -> RecordFile:
    """Return the file with the hash of when it was last read, if it was read with the same overrides."""
    if known is None or known[3] != asked:
        return found
    return RecordFile(found.path, found.size, found.mtime, found.problem, str(known[2]))


def _read_changed(
    folder: Path,
    files: list[RecordFile],
    connection: sqlite3.Connection,
    *,
    overrides: HeaderOverrides,
    asked: str,
    executor: Executor | None,
    progress: Progress,
) -> None:
    describe = partial(describe_file, folder, overrides=overrides)
    results = map_files(describe, files, executor=executor)
    batch: list[DescribedFile] = []
    for done, one in enumerate(results, start=1):
        batch.append(one)
        progress(done, len(files))
        if len(batch) == BATCH:
            _store(connection, batch, asked)
            batch = []
    _store(connection, batch, asked)


def describe_file(folder: Path, found: RecordFile, *, overrides: HeaderOverrides) -> DescribedFile:
    """Read the records of one file with their measures and spectra, or the reason why there are none."""
    if found.problem:
        return DescribedFile(found, "", found.problem, ())
    file = folder / found.path
    try:
        with warnings.catch_warnings(), file.open("rb") as opened:
            warnings.simplefilter("ignore")
            sha256 = hashlib.file_digest(opened, "sha256").hexdigest()
            if sha256 == found.stored:
                return DescribedFile(found, sha256, "", None)
            made = tuple(
                describe_record(record, found.path, i) for i, record in enumerate(read_with_overrides(file, overrides))
            )
    except (RecordError, OSError) as error:
        return DescribedFile(found, "", str(error).removeprefix(f"{file}: "), ())
    except Exception as error:  # of a thousand files one may meet a fault of a reader: the others go on
        return DescribedFile(found, "", f"its reader failed: {type(error).__name__}: {error}", ())
    return DescribedFile(found, sha256, "", made)


def _store(connection: sqlite3.Connection, batch: list[DescribedFile], asked: str) -> None:
    """Store one batch, whole or not at all."""
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
            rows = [_record_row(each) for each in one.candidates]
            if rows:
                marks = ", ".join("?" * len(rows[0]))
                connection.executemany(f"INSERT INTO records VALUES ({marks})", rows)


def _record_row(one: Candidate) -> tuple[object, ...]:
    texts = (_utf8(one.id), _utf8(one.event), _utf8(one.station), _utf8(one.component), _utf8(one.date))
    known = (one.magnitude, one.distance, one.vs30, _utf8(one.place), one.nga)
    spectrum = np.asarray(one.spectrum, dtype="<f8").tobytes()
    of = (one.measures[name] for name in MEASURES)
    return with_seal((one.path, one.position, *texts, *known, one.dt, one.npts, spectrum, *of))


def _utf8(text: str) -> str:
    return text.encode("utf-8", "replace").decode()
