"""A catalogue of a folder of records: an SQLite file with metadata, measures and 5 % spectra, made by `indexing`.

Names and texts in it come from files of others: they are bound as parameters and never become part of a statement, and
no path is followed that leads out of the folder.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import fields
from pathlib import Path, PurePosixPath

import numpy as np

from records.candidates import PERIODS, Candidate
from records.errors import RecordError
from records.flatfile import Recording
from records.intensity import Measures

NAME = ".assess-records.sqlite"
APPLICATION = 0x41535345  # marks the file as ours
VERSION = 1
MEASURES = tuple(field.name for field in fields(Measures))

TABLES = f"""
CREATE TABLE files (path TEXT PRIMARY KEY, size INTEGER, mtime INTEGER, sha256 TEXT, asked TEXT, problem TEXT);
CREATE TABLE records (
    path TEXT REFERENCES files(path) ON DELETE CASCADE, position INTEGER,
    id TEXT, event TEXT, station TEXT, component TEXT, date TEXT,
    magnitude REAL, distance REAL, vs30 REAL, nga INTEGER, file TEXT,
    dt REAL, npts INTEGER, {", ".join(f"{name} REAL" for name in MEASURES)}, spectrum BLOB,
    PRIMARY KEY (path, position)
);
CREATE TABLE recordings (nga INTEGER PRIMARY KEY, event TEXT, year TEXT, station TEXT,
    magnitude REAL, distance REAL, vs30 REAL);
CREATE TABLE named (file TEXT PRIMARY KEY, nga INTEGER);
"""
ROWS = f"""
SELECT r.path, r.position, r.id, COALESCE(NULLIF(f.event, ''), r.event), COALESCE(NULLIF(f.station, ''), r.station),
    r.component, r.date, COALESCE(f.year, ''), COALESCE(f.magnitude, r.magnitude), COALESCE(f.distance, r.distance),
    COALESCE(f.vs30, r.vs30), COALESCE(r.nga, n.nga), r.dt, r.npts, r.spectrum, {", ".join(f"r.{m}" for m in MEASURES)}
FROM records r LEFT JOIN named n ON n.file = r.file LEFT JOIN recordings f ON f.nga = COALESCE(r.nga, n.nga)
ORDER BY r.path, r.position
"""


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
        + "".join(f"DROP TABLE IF EXISTS {name};" for name in ("named", "recordings", "records", "files"))
        + TABLES
        + f"PRAGMA application_id = {APPLICATION}; PRAGMA user_version = {VERSION}; COMMIT;"
    )


def candidates(connection: sqlite3.Connection) -> tuple[Candidate, ...]:
    """Every record of the catalogue, by path; what a flatfile says of it goes before what its file says."""
    return tuple(_candidate(row) for row in connection.execute(ROWS))


def _candidate(row: Sequence[object]) -> Candidate:
    (path, position, id, event, station, component, date, year, magnitude, distance, vs30, nga, dt, npts, blob) = row[
        :15
    ]
    spectrum = np.frombuffer(blob if isinstance(blob, bytes) else b"", dtype="<f8")
    if spectrum.size != PERIODS.size:
        raise RecordError(f'catalogue: record "{path}" has {spectrum.size} ordinates; delete it and index again')
    dated = str(date) if str(date)[:4] == year or not year else str(year)
    return Candidate(
        path=str(path), position=int(str(position)), id=str(id), event=str(event), station=str(station),
        component=str(component), date=dated, magnitude=_known(magnitude), distance=_known(distance),
        vs30=_known(vs30), nga=None if nga is None else int(str(nga)), dt=float(str(dt)), npts=int(str(npts)),
        measures=dict(zip(MEASURES, map(_measure, row[15:]), strict=True)), spectrum=spectrum,
    )  # fmt: skip


def _known(value: object) -> float | None:
    return value if isinstance(value, float) else None


def _measure(value: object) -> float:
    return value if isinstance(value, float) else float("nan")


def merge(connection: sqlite3.Connection, recordings: Sequence[Recording]) -> int:
    """Take a flatfile into the catalogue in place of an earlier one; the number of records that it describes.

    Records are found by the NGA number in their file's name, else by a file name that the flatfile has once.
    """
    named: dict[str, int | None] = {}
    for one in recordings:
        for file in one.files:
            named[file] = one.nga if named.get(file, one.nga) == one.nga else None
    with connection:
        connection.execute("DELETE FROM recordings")
        connection.execute("DELETE FROM named")
        connection.executemany(
            "INSERT OR REPLACE INTO recordings VALUES (?, ?, ?, ?, ?, ?, ?)",
            [(r.nga, r.event, r.year, r.station, r.magnitude, r.distance, r.vs30) for r in recordings],
        )
        connection.executemany(
            "INSERT INTO named VALUES (?, ?)", [(file, n) for file, n in named.items() if n is not None]
        )
    joined = "SELECT COUNT(*) FROM records r LEFT JOIN named n ON n.file = r.file JOIN recordings f"
    return int(connection.execute(f"{joined} ON f.nga = COALESCE(r.nga, n.nga)").fetchone()[0])


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
