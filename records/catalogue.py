"""A catalogue of a folder of records: an SQLite file with metadata, measures and 5 % spectra, made by `indexing`.

Names and texts in it come from files of others: they are bound as parameters and never become part of a statement, and
no path is followed that leads out of the folder.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import astuple, fields
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np

from records.candidates import PERIODS, Candidate
from records.errors import RecordError
from records.flatfile import Recording, described_by
from records.formats.stated import Stated
from records.intensity import Measures

NAME = ".assess-records.sqlite"
APPLICATION = 0x41535345  # marks the file as ours
VERSION = 2
MEASURES = tuple(field.name for field in fields(Measures))

TABLES = f"""
CREATE TABLE files (path TEXT PRIMARY KEY, size INTEGER, mtime INTEGER, sha256 TEXT, asked TEXT, problem TEXT);
CREATE TABLE records (
    path TEXT REFERENCES files(path) ON DELETE CASCADE, position INTEGER,
    id TEXT, event TEXT, station TEXT, component TEXT, date TEXT,
    magnitude REAL, distance REAL, vs30 REAL, place TEXT, nga INTEGER,
    dt REAL, npts INTEGER, {", ".join(f"{name} REAL" for name in MEASURES)}, spectrum BLOB,
    PRIMARY KEY (path, position)
);
CREATE TABLE stated (unit TEXT, step REAL, response TEXT);
CREATE TABLE recordings (nga INTEGER PRIMARY KEY, event TEXT, year TEXT, station TEXT,
    magnitude REAL, distance REAL, vs30 REAL, files TEXT);
"""
COLUMNS = (
    "path, position, id, event, station, component, date, magnitude, distance, vs30, place, nga, dt, npts, spectrum"
)
TOLD = tuple(COLUMNS.split(", "))[:-1]
ROWS = f"SELECT {COLUMNS}, {', '.join(MEASURES)} FROM records ORDER BY path, position"


@contextmanager
def opened(file: Path | None) -> Iterator[sqlite3.Connection]:
    """The catalogue in `file`, made if it does not exist; in memory alone if None. Closed at the end.

    Raises RecordError for a file that cannot be written, is damaged, or is not a catalogue.
    """
    if file is not None and file.is_symlink():
        raise RecordError(f"{file}: is a link; a catalogue must be a file of its own: remove the link")
    try:
        connection = sqlite3.connect(":memory:" if file is None else file, timeout=30.0)
    except sqlite3.Error as error:
        raise RecordError(f"{file}: the catalogue cannot be opened ({error}); give another place for it") from None
    try:
        _prepare(connection, file)
        yield connection
    except sqlite3.Error as error:
        raise RecordError(
            f"{file}: the catalogue cannot be used ({error}); if it is damaged delete it and index again, if its "
            "folder cannot be written give another place for it"
        ) from None
    finally:
        connection.close()


def _prepare(connection: sqlite3.Connection, file: Path | None) -> None:
    """Tables in an empty file or one of another version of ours; refuses one that is not ours."""
    connection.execute("PRAGMA foreign_keys = ON")
    application, version = (
        int(connection.execute(f"PRAGMA {key}").fetchone()[0]) for key in ("application_id", "user_version")
    )
    holds = [str(name) for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
    if holds and application != APPLICATION:
        raise RecordError(f"{file}: a database that is not a catalogue of records; move it away, or give another place")
    if holds and version == VERSION:
        return
    connection.executescript(
        "BEGIN;"
        + "".join(f"DROP TABLE IF EXISTS {name};" for name in ("recordings", "stated", "records", "files"))
        + TABLES
        + f"PRAGMA application_id = {APPLICATION}; PRAGMA user_version = {VERSION}; COMMIT;"
    )


def candidates(connection: sqlite3.Connection) -> tuple[Candidate, ...]:
    """Every record of the catalogue, by path, with what a flatfile taken in says of it."""
    said = stated(connection)
    found = [_candidate(row, said) for row in connection.execute(ROWS)]
    return described_by(found, recordings(connection))


def _candidate(row: Sequence[Any], said: Stated) -> Candidate:
    spectrum = np.frombuffer(row[14], dtype="<f8")
    if spectrum.size != PERIODS.size:
        raise RecordError(f'catalogue: record "{row[0]}" has {spectrum.size} ordinates; delete it and index again')
    measures = dict(zip(MEASURES, row[15:], strict=True))
    return Candidate(**dict(zip(TOLD, row, strict=False)), measures=measures, spectrum=spectrum, stated=said)


def stated(connection: sqlite3.Connection) -> Stated:
    """What was stated of the files that do not say it themselves."""
    row = connection.execute("SELECT unit, step, response FROM stated").fetchone() or (None, None, None)
    return Stated(row[0], row[1], None if row[2] is None else Path(row[2]))


def keep(connection: sqlite3.Connection, said: Stated) -> None:
    """Keep what is stated of the files, in place of what was."""
    response = None if said.response is None else str(said.response)
    with connection:
        connection.execute("DELETE FROM stated")
        connection.execute("INSERT INTO stated VALUES (?, ?, ?)", (said.unit, said.step, response))


def take(connection: sqlite3.Connection, flatfile: Sequence[Recording]) -> None:
    """Take a flatfile into the catalogue, in place of an earlier one."""
    rows = [(*astuple(one)[:-1], "\n".join(one.files)) for one in flatfile]
    with connection:
        connection.execute("DELETE FROM recordings")
        connection.executemany("INSERT OR REPLACE INTO recordings VALUES (?, ?, ?, ?, ?, ?, ?, ?)", rows)


def recordings(connection: sqlite3.Connection) -> tuple[Recording, ...]:
    """The flatfile that was taken in."""
    names = [field.name for field in fields(Recording)]
    rows = (dict(zip(names, row, strict=True)) for row in connection.execute("SELECT * FROM recordings ORDER BY nga"))
    return tuple(Recording(**{**row, "files": tuple(row["files"].split("\n"))}) for row in rows)


def problems(connection: sqlite3.Connection) -> tuple[tuple[str, str], ...]:
    """(path, reason) of every file that could not be read."""
    rows = connection.execute("SELECT path, problem FROM files WHERE problem <> '' ORDER BY path")
    return tuple((str(path), str(problem)) for path, problem in rows)


def inside(folder: Path, path: str) -> Path:
    """The file at `path` below `folder`; RecordError where it leads out of it."""
    file = folder / path
    if PurePosixPath(path).is_absolute() or not file.resolve().is_relative_to(folder.resolve()):
        raise RecordError(f'catalogue: "{path}" leads out of {folder}; delete the catalogue and index again')
    return file
