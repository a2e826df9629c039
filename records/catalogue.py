"""A catalogue of a folder of records: an SQLite file with metadata, measures and 5 % spectra.

`index` brings it up to date: only files that are new or have changed are read. A file is unchanged where its size and
time of change are, or else where its hash is. Batches are committed as they come, so that an index that was stopped
goes on where it ended. Files that cannot be read are kept with the reason.

Names and texts in it come from files of others: they are bound as parameters and never become part of a statement, and
no path is followed that leads out of the folder. Every row has a seal, a hash of what it says: one that was changed
since, by a disk or by hand, is not believed, and its file is read again.
"""

from __future__ import annotations

import hashlib
import sqlite3
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager
from dataclasses import astuple, dataclass, fields, replace
from functools import partial
from math import isfinite, isnan
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np

from records.candidates import Candidate, describe_record, map_files
from records.errors import RecordError
from records.flatfile import FlatfileRow, describe_candidates
from records.formats import FORMATS
from records.formats.header import NO_OVERRIDES, HeaderOverrides, check_overrides
from records.reading import RecordFile, files_below, read_with_overrides
from records.response import Measures

NAME = ".assess-records.sqlite"
APPLICATION = 0x41535345  # marks the file as ours
VERSION = 3
BATCH = 50  # files to a commit
MEASURES = tuple(field.name for field in fields(Measures))

TABLES = f"""
CREATE TABLE files (path TEXT PRIMARY KEY, size INTEGER, mtime INTEGER, sha256 TEXT, asked TEXT, problem TEXT,
    records INTEGER, seal TEXT);
CREATE TABLE records (
    path TEXT REFERENCES files(path) ON DELETE CASCADE, position INTEGER,
    id TEXT, event TEXT, station TEXT, component TEXT, date TEXT,
    magnitude REAL, distance REAL, vs30 REAL, place TEXT, nga INTEGER,
    dt REAL, npts INTEGER, spectrum BLOB, {", ".join(f"{name} REAL" for name in MEASURES)}, seal TEXT,
    PRIMARY KEY (path, position)
);
CREATE TABLE stated (unit TEXT, step REAL, response TEXT, seal TEXT);
CREATE TABLE recordings (nga INTEGER PRIMARY KEY, event TEXT, year TEXT, station TEXT,
    magnitude REAL, distance REAL, vs30 REAL, files TEXT, seal TEXT);
"""

COLUMNS = (
    "path, position, id, event, station, component, date, magnitude, distance, vs30, place, nga, dt, npts, spectrum"
)
TEXT_COLUMNS = tuple(COLUMNS.split(", "))[:-1]
ROWS = f"SELECT {COLUMNS}, {', '.join(MEASURES)}, seal FROM records ORDER BY path, position"
FILES = "SELECT path, size, mtime, sha256, asked, problem, records, seal FROM files"
FLATFILE = ("nga", "event", "year", "station", "magnitude", "distance", "vs30", "files")

FileProgress = Callable[[int, int], None]


class Catalogue(sqlite3.Connection):
    """An open catalogue; file: where it is; older: whether it was of an older version, and is empty now."""

    file: Path | None = None
    older: bool = False


@contextmanager
def open_catalogue(file: Path | None) -> Iterator[Catalogue]:
    """Open the catalogue in `file`, made if it does not exist, or in memory if None; close it at the end.

    Raises
    ------
    RecordError : the file cannot be written, is damaged, of a newer version, or not a catalogue
    """
    if file is not None and (file.is_symlink() or file.is_dir()):
        what = "a link" if file.is_symlink() else "a folder"
        raise RecordError(
            f"{file}: is {what}; a catalogue must be a file of its own: move it away, or give another place"
        )
    try:
        connection = sqlite3.connect(":memory:" if file is None else file, timeout=30.0, factory=Catalogue)
    except sqlite3.Error as error:
        raise RecordError(f"{file}: the catalogue cannot be opened ({error}); give another place for it") from None
    connection.file = file
    connection.text_factory = lambda text: text.decode("utf-8", "surrogateescape")  # its seal tells what is wrong
    try:
        _prepare(connection)
        yield connection
    except sqlite3.Error as error:
        raise RecordError(
            f"{file}: the catalogue cannot be used ({error}); if it is damaged delete it and index again, if its "
            "folder cannot be written give another place for it"
        ) from None
    finally:
        connection.close()


@dataclass(frozen=True)
class IndexSummary:
    """What an index did: files read, unchanged and gone, records in all, (path, reason) of files that cannot be read.

    damaged : files whose rows were changed since they were written, and that were read again
    older : whether the catalogue was of an older version, so that every file was read again
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

    file: RecordFile
    sha256: str
    problem: str
    candidates: tuple[Candidate, ...] | None


def index(
    folder: Path,
    connection: sqlite3.Connection,
    *,
    overrides: HeaderOverrides = NO_OVERRIDES,
    executor: Executor | None = None,
    progress: FileProgress = lambda done, total: None,
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
    overrides = overrides.over(_header_overrides(connection))
    read_with = f"{overrides.key} {' '.join(FORMATS)}"
    on_disk = {file.path: file for file in files_below(folder)}
    damaged = remove_damaged(connection)
    known = {
        row[0]: row[1:] for row in connection.execute("SELECT path, size, mtime, sha256, asked, problem FROM files")
    }
    _store_overrides(connection, overrides)
    gone = [path for path in known if path not in on_disk]
    changed = [
        _with_hash(file, known.get(path), read_with)
        for path, file in on_disk.items()
        if not _unchanged(file, known.get(path), read_with)
    ]
    with connection:
        connection.executemany("DELETE FROM files WHERE path = ?", [(path,) for path in gone])
    _read_changed(
        folder, changed, connection, overrides=overrides, read_with=read_with, executor=executor, progress=progress
    )
    number = int(connection.execute("SELECT COUNT(*) FROM records").fetchone()[0])
    older = isinstance(connection, Catalogue) and connection.older
    counts = (len(changed), len(on_disk) - len(changed), len(gone), number)
    return IndexSummary(*counts, problems(connection), tuple(path for path in damaged if path in on_disk), older)


def remove_damaged(connection: sqlite3.Connection) -> tuple[str, ...]:
    """Remove the files of which a row was changed since it was written; return their paths, as far as legible."""
    rows: dict[str, list[bool]] = {}
    for row in connection.execute(ROWS):
        rows.setdefault(str(row[0]), []).append(_seal_matches(row))
    damaged = []
    for number, *row in connection.execute(FILES.replace("SELECT ", "SELECT rowid, ")).fetchall():
        of_file = rows.get(str(row[0]), [])
        if not (_seal_matches(row) and all(of_file) and len(of_file) == row[6]):
            damaged.append((number, _legible(str(row[0]))))
    with connection:
        connection.executemany("DELETE FROM files WHERE rowid = ?", [(number,) for number, _ in damaged])
        connection.execute("DELETE FROM records WHERE path NOT IN (SELECT path FROM files)")
    return tuple(path for _, path in damaged)


def catalogue_candidates(connection: sqlite3.Connection) -> tuple[Candidate, ...]:
    """Return every record of the catalogue, by path, described by the flatfile that was stored."""
    overrides = _header_overrides(connection)
    rows = connection.execute(ROWS).fetchall()
    for row in rows:
        if not _seal_matches(row):
            raise _damaged(connection, f"record {row[1]} of {row[0]}")
    return describe_candidates([_candidate(row, overrides) for row in rows], recordings(connection))


def store_flatfile(connection: sqlite3.Connection, flatfile: Sequence[FlatfileRow]) -> None:
    """Store a flatfile in the catalogue, in place of an earlier one.

    Parameters
    ----------
    connection : the open catalogue
    flatfile : its recordings
    """
    rows = [_with_seal((*astuple(row)[:-1], "\n".join(row.files))) for row in flatfile]
    with connection:
        connection.execute("DELETE FROM recordings")
        connection.executemany("INSERT OR REPLACE INTO recordings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", rows)


def recordings(connection: sqlite3.Connection) -> tuple[FlatfileRow, ...]:
    """Return the rows of the flatfile that was stored."""
    rows = []
    for row in connection.execute(f"SELECT {', '.join(FLATFILE)}, seal FROM recordings ORDER BY nga"):
        if not _seal_matches(row):
            raise _damaged(connection, f"recording {row[0]} of the flatfile taken in")
        texts = dict(zip(FLATFILE, row[:-1], strict=True))
        rows.append(FlatfileRow(**{**texts, "files": tuple(texts["files"].split("\n"))}))
    return tuple(rows)


def problems(connection: sqlite3.Connection) -> tuple[tuple[str, str], ...]:
    """Return (path, reason) of every file that could not be read."""
    rows = connection.execute("SELECT path, problem FROM files WHERE problem <> '' ORDER BY path")
    return tuple((str(path), str(problem)) for path, problem in rows)


def path_inside(folder: Path, path: str) -> Path:
    """Return the file at `path` below a folder.

    Parameters
    ----------
    folder : of the catalogue
    path : of the file, relative to the folder, as the catalogue has it

    Raises
    ------
    RecordError : the path leads out of the folder
    """
    file = folder / path
    if PurePosixPath(path).is_absolute() or not file.resolve().is_relative_to(folder.resolve()):
        raise RecordError(f'catalogue: "{path}" leads out of {folder}; delete the catalogue and index again')
    return file


def seal(row: Sequence[Any]) -> str:
    """Return a hash of the values of a row, the same before and after SQLite has kept them."""
    digest = hashlib.sha256()
    for value in row:
        plain = _sealed_bytes(value)
        digest.update(f"{len(plain)} ".encode() + plain)
    return digest.hexdigest()[:32]


def _seal_matches(row: Sequence[Any]) -> bool:
    """Return whether a row still matches its seal, its last value."""
    return bool(row[-1] == seal(row[:-1]))


def _candidate(row: Sequence[Any], overrides: HeaderOverrides) -> Candidate:
    spectrum = np.frombuffer(row[14], dtype="<f8")
    measures = dict(zip(MEASURES, row[15:-1], strict=True))
    return Candidate(
        **dict(zip(TEXT_COLUMNS, row, strict=False)), measures=measures, spectrum=spectrum, overrides=overrides
    )


def _header_overrides(connection: sqlite3.Connection) -> HeaderOverrides:
    """Return the header overrides that the files were read with."""
    row = connection.execute("SELECT unit, step, response, seal FROM stated").fetchone()
    if row is None:
        return HeaderOverrides()
    if not _seal_matches(row):
        raise _damaged(connection, "what was stated of its files (unit, step, response)")
    return HeaderOverrides(row[0], row[1], None if row[2] is None else Path(row[2]))


def _store_overrides(connection: sqlite3.Connection, overrides: HeaderOverrides) -> None:
    """Store the header overrides that the files are read with, in place of earlier ones."""
    response = None if overrides.response is None else str(overrides.response)
    with connection:
        connection.execute("DELETE FROM stated")
        connection.execute(
            "INSERT INTO stated VALUES (?, ?, ?, ?)", _with_seal((overrides.unit, overrides.step, response))
        )


def _unchanged(file: RecordFile, known: tuple[object, ...] | None, read_with: str) -> bool:
    """Return whether the catalogue has the file as it is: its size and time, and what it was read with."""
    if known is None:
        return False
    size, mtime, _, read_before_with, problem = known
    return (
        (size, mtime) == (file.size, file.mtime)
        and read_before_with == read_with
        and (not file.problem or file.problem == problem)
    )


def _with_hash(file: RecordFile, known: tuple[object, ...] | None, read_with: str) -> RecordFile:
    """Return the file with its hash when it was last read, if it was read with the same overrides and formats."""
    if known is None or known[3] != read_with:
        return file
    return replace(file, stored=str(known[2]))


def _read_changed(
    folder: Path,
    files: list[RecordFile],
    connection: sqlite3.Connection,
    *,
    overrides: HeaderOverrides,
    read_with: str,
    executor: Executor | None,
    progress: FileProgress,
) -> None:
    describe = partial(_describe_file, folder, overrides=overrides)
    results = map_files(describe, files, executor=executor)
    batch: list[DescribedFile] = []
    for done, described in enumerate(results, start=1):
        batch.append(described)
        progress(done, len(files))
        if len(batch) == BATCH:
            _store(connection, batch, read_with)
            batch = []
    _store(connection, batch, read_with)


def _describe_file(folder: Path, file: RecordFile, *, overrides: HeaderOverrides) -> DescribedFile:
    """Read the records of one file with their measures and spectra, or the reason why there are none."""
    if file.problem:
        return DescribedFile(file, "", file.problem, ())
    path = folder / file.path
    try:
        with warnings.catch_warnings(), path.open("rb") as opened:
            warnings.simplefilter("ignore")
            sha256 = hashlib.file_digest(opened, "sha256").hexdigest()
            if sha256 == file.stored:
                return DescribedFile(file, sha256, "", None)
            candidates = tuple(
                describe_record(record, file.path, i) for i, record in enumerate(read_with_overrides(path, overrides))
            )
    except (RecordError, OSError) as error:
        return DescribedFile(file, "", str(error).removeprefix(f"{path}: "), ())
    except Exception as error:  # of a thousand files one may meet a fault of a reader: the others go on
        return DescribedFile(file, "", f"its reader failed: {type(error).__name__}: {error}", ())
    return DescribedFile(file, sha256, "", candidates)


def _store(connection: sqlite3.Connection, batch: list[DescribedFile], read_with: str) -> None:
    """Store one batch, whole or not at all."""
    with connection:
        for described in batch:
            file = described.file
            count = 0 if described.candidates is None else len(described.candidates)
            row = (file.path, file.size, file.mtime, described.sha256, read_with, described.problem)
            if described.candidates is None:
                count = connection.execute("SELECT COUNT(*) FROM records WHERE path = ?", (file.path,)).fetchone()[0]
                values = (file.size, file.mtime, seal((*row, count)), file.path)
                connection.execute("UPDATE files SET size = ?, mtime = ?, seal = ? WHERE path = ?", values)
                continue
            connection.execute("DELETE FROM files WHERE path = ?", (file.path,))
            connection.execute("INSERT INTO files VALUES (?, ?, ?, ?, ?, ?, ?, ?)", _with_seal((*row, count)))
            rows = [_record_row(each) for each in described.candidates]
            if rows:
                marks = ", ".join("?" * len(rows[0]))
                connection.executemany(f"INSERT INTO records VALUES ({marks})", rows)


def _record_row(candidate: Candidate) -> tuple[object, ...]:
    texts = (
        _utf8(candidate.id),
        _utf8(candidate.event),
        _utf8(candidate.station),
        _utf8(candidate.component),
        _utf8(candidate.date),
    )
    metadata = (candidate.magnitude, candidate.distance, candidate.vs30, _utf8(candidate.place), candidate.nga)
    spectrum = np.asarray(candidate.spectrum, dtype="<f8").tobytes()
    measures = (candidate.measures[name] for name in MEASURES)
    return _with_seal(
        (candidate.path, candidate.position, *texts, *metadata, candidate.dt, candidate.npts, spectrum, *measures)
    )


def _utf8(text: str) -> str:
    """Return a text that can be encoded: question marks in place of what cannot."""
    return text.encode("utf-8", "replace").decode()


def _prepare(connection: Catalogue) -> None:
    """Make tables in an empty file or in one of an older version; refuse one that is newer, damaged, or not ours."""
    connection.execute("PRAGMA foreign_keys = ON")
    application, version = (
        int(connection.execute(f"PRAGMA {key}").fetchone()[0]) for key in ("application_id", "user_version")
    )
    has_tables = _count_tables(connection) > 0
    if has_tables and application != APPLICATION:
        raise RecordError(
            f"{connection.file}: a database that is not a catalogue of records; move it away, or give another place"
        )
    if has_tables and version > VERSION:
        raise RecordError(
            f"{connection.file}: a catalogue of version {version}, made by a newer program; this one knows up to "
            f"{VERSION}: use the newer program, or give another place with --catalogue"
        )
    if has_tables and version == VERSION:
        integrity = connection.execute("PRAGMA integrity_check(1)").fetchone()[0]
        if integrity != "ok":
            raise _damaged(connection, str(integrity))
        return
    connection.older = has_tables
    _make_tables(connection)


def _count_tables(connection: Catalogue) -> int:
    """Return how many tables there are; the error for a damaged statement of one quotes it, and may be no text."""
    try:
        return int(connection.execute("SELECT COUNT(*) FROM sqlite_master WHERE type = 'table'").fetchone()[0])
    except UnicodeDecodeError:
        raise _damaged(connection, "the names of its tables are no text") from None


def _make_tables(connection: Catalogue) -> None:
    """Make empty tables, and keep the header overrides and the flatfile of an older version."""
    overrides = _older_rows(connection, "SELECT unit, step, response FROM stated")
    flatfile = _older_rows(connection, f"SELECT {', '.join(FLATFILE)} FROM recordings")
    connection.executescript(
        "BEGIN;"
        + "".join(f"DROP TABLE IF EXISTS {name};" for name in ("recordings", "stated", "records", "files"))
        + TABLES
        + f"PRAGMA application_id = {APPLICATION}; PRAGMA user_version = {VERSION}; COMMIT;"
    )
    with connection:
        connection.executemany("INSERT INTO stated VALUES (?, ?, ?, ?)", [_with_seal(row) for row in overrides[:1]])
        marks = ", ".join("?" * (len(FLATFILE) + 1))
        connection.executemany(f"INSERT INTO recordings VALUES ({marks})", [_with_seal(row) for row in flatfile])


def _older_rows(connection: sqlite3.Connection, query: str) -> list[tuple[Any, ...]]:
    """Return the rows of an older version; none where it has no such table, or text that cannot be read."""
    try:
        rows: list[tuple[Any, ...]] = connection.execute(query).fetchall()
        "".join(value for row in rows for value in row if isinstance(value, str)).encode()
    except (sqlite3.Error, UnicodeEncodeError):
        return []
    return rows


def _damaged(connection: sqlite3.Connection, what: str) -> RecordError:
    file = connection.file if isinstance(connection, Catalogue) and connection.file is not None else "catalogue"
    return RecordError(f"{file}: the catalogue is damaged: {_legible(what)}; delete it and index again")


def _legible(text: str) -> str:
    return _utf8(text)[:120]


def _with_seal(row: Sequence[Any]) -> tuple[Any, ...]:
    """Return the row with its seal."""
    return (*row, seal(row))


def _sealed_bytes(value: Any) -> bytes:
    """Return a value as bytes that tell its kind; SQLite may give 1.0 back as 1, and gives nan back as None."""
    if isinstance(value, bytes):
        return b"b" + value
    if isinstance(value, str):
        return b"s" + value.encode("utf-8", "surrogateescape")
    if value is None or (isinstance(value, float) and isnan(value)):
        return b"n"
    if isinstance(value, float) and isfinite(value) and value.is_integer():
        value = int(value)
    return f"{value:d}".encode() if isinstance(value, int) else repr(float(value)).encode()
