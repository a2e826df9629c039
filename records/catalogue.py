"""A catalogue of a folder of records: an SQLite file with metadata, measures and 5 % spectra.

Names and texts in it come from files of others: they are bound as parameters and never become part of a statement, and
no path is followed that leads out of the folder. Every row has a seal, a hash of what it says: one that was changed
since, by a disk or by hand, is not believed, and its file is read again.
"""

from __future__ import annotations

import hashlib
import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import astuple, fields
from math import isfinite, isnan
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np

from records.candidates import Candidate
from records.errors import RecordError
from records.flatfile import FlatfileRow, describe_candidates
from records.formats.header import HeaderOverrides
from records.response import Measures

NAME = ".assess-records.sqlite"
APPLICATION = 0x41535345  # marks the file as ours
VERSION = 3
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


def _prepare(connection: Catalogue) -> None:
    """Make tables in an empty file or in one of an older version; refuse one that is newer, damaged, or not ours."""
    connection.execute("PRAGMA foreign_keys = ON")
    application, version = (
        int(connection.execute(f"PRAGMA {key}").fetchone()[0]) for key in ("application_id", "user_version")
    )
    holds = _count_tables(connection) > 0
    if holds and application != APPLICATION:
        raise RecordError(
            f"{connection.file}: a database that is not a catalogue of records; move it away, or give another place"
        )
    if holds and version > VERSION:
        raise RecordError(
            f"{connection.file}: a catalogue of version {version}, made by a newer program; this one knows up to "
            f"{VERSION}: use the newer program, or give another place with --catalogue"
        )
    if holds and version == VERSION:
        found = connection.execute("PRAGMA integrity_check(1)").fetchone()[0]
        if found != "ok":
            raise _damaged(connection, str(found))
        return
    connection.older = holds
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
        connection.executemany("INSERT INTO stated VALUES (?, ?, ?, ?)", [with_seal(row) for row in overrides[:1]])
        marks = ", ".join("?" * (len(FLATFILE) + 1))
        connection.executemany(f"INSERT INTO recordings VALUES ({marks})", [with_seal(row) for row in flatfile])


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
    return text.encode("utf-8", "replace").decode()[:120]


def remove_damaged(connection: sqlite3.Connection) -> tuple[str, ...]:
    """Remove the files of which a row was changed since it was written; return their paths, as far as legible."""
    rows: dict[str, list[bool]] = {}
    for row in connection.execute(ROWS):
        rows.setdefault(str(row[0]), []).append(_seal_matches(row))
    wrong = []
    for number, *row in connection.execute(FILES.replace("SELECT ", "SELECT rowid, ")).fetchall():
        of_file = rows.get(str(row[0]), [])
        if not (_seal_matches(row) and all(of_file) and len(of_file) == row[6]):
            wrong.append((number, _legible(str(row[0]))))
    with connection:
        connection.executemany("DELETE FROM files WHERE rowid = ?", [(number,) for number, _ in wrong])
        connection.execute("DELETE FROM records WHERE path NOT IN (SELECT path FROM files)")
    return tuple(path for _, path in wrong)


def _seal_matches(row: Sequence[Any]) -> bool:
    """Return whether a row still matches its seal, its last value."""
    return bool(row[-1] == seal(row[:-1]))


def catalogue_candidates(connection: sqlite3.Connection) -> tuple[Candidate, ...]:
    """Return every record of the catalogue, by path, described by the flatfile that was stored."""
    overrides = header_overrides(connection)
    rows = connection.execute(ROWS).fetchall()
    for row in rows:
        if not _seal_matches(row):
            raise _damaged(connection, f"record {row[1]} of {row[0]}")
    found = [_candidate(row, overrides) for row in rows]
    return describe_candidates(found, recordings(connection))


def _candidate(row: Sequence[Any], overrides: HeaderOverrides) -> Candidate:
    spectrum = np.frombuffer(row[14], dtype="<f8")
    measures = dict(zip(MEASURES, row[15:-1], strict=True))
    return Candidate(
        **dict(zip(TEXT_COLUMNS, row, strict=False)), measures=measures, spectrum=spectrum, overrides=overrides
    )


def header_overrides(connection: sqlite3.Connection) -> HeaderOverrides:
    """Return the header overrides that the files were read with."""
    row = connection.execute("SELECT unit, step, response, seal FROM stated").fetchone()
    if row is None:
        return HeaderOverrides()
    if not _seal_matches(row):
        raise _damaged(connection, "what was stated of its files (unit, step, response)")
    return HeaderOverrides(row[0], row[1], None if row[2] is None else Path(row[2]))


def store_overrides(connection: sqlite3.Connection, overrides: HeaderOverrides) -> None:
    """Store the header overrides that the files are read with, in place of earlier ones."""
    response = None if overrides.response is None else str(overrides.response)
    with connection:
        connection.execute("DELETE FROM stated")
        connection.execute(
            "INSERT INTO stated VALUES (?, ?, ?, ?)", with_seal((overrides.unit, overrides.step, response))
        )


def store_flatfile(connection: sqlite3.Connection, flatfile: Sequence[FlatfileRow]) -> None:
    """Store a flatfile in the catalogue, in place of an earlier one.

    Parameters
    ----------
    connection : the open catalogue
    flatfile : its recordings
    """
    rows = [with_seal((*astuple(one)[:-1], "\n".join(one.files))) for one in flatfile]
    with connection:
        connection.execute("DELETE FROM recordings")
        connection.executemany("INSERT OR REPLACE INTO recordings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", rows)


def recordings(connection: sqlite3.Connection) -> tuple[FlatfileRow, ...]:
    """Return the flatfile that was taken in."""
    found = []
    for row in connection.execute(f"SELECT {', '.join(FLATFILE)}, seal FROM recordings ORDER BY nga"):
        if not _seal_matches(row):
            raise _damaged(connection, f"recording {row[0]} of the flatfile taken in")
        texts = dict(zip(FLATFILE, row[:-1], strict=True))
        found.append(FlatfileRow(**{**texts, "files": tuple(texts["files"].split("\n"))}))
    return tuple(found)


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


def with_seal(row: Sequence[Any]) -> tuple[Any, ...]:
    """Return the row with its seal."""
    return (*row, seal(row))


def seal(row: Sequence[Any]) -> str:
    """Return a hash of the values of a row, the same before and after SQLite has kept them."""
    digest = hashlib.sha256()
    for value in row:
        plain = _sealed_bytes(value)
        digest.update(f"{len(plain)} ".encode() + plain)
    return digest.hexdigest()[:32]


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
