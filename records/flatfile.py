"""PEER flatfiles: what a CSV table of the NGA database says of each recording, columns found by their names.

Understood are the NGA-West flatfiles and the table that the PEER web site gives with a search; the header may stand
some lines below the top. Numbers of -999 and below mean that a value is not known.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from records.candidates import Candidate
from records.errors import RecordError
from spectra.columns import ColumnError, decode

NUMBER = ("recordsequencenumber", "rsn", "nga", "ngaid", "nganumber")
COLUMNS: Mapping[str, Sequence[str]] = {
    "event": ("earthquakename", "eventname", "earthquake", "event"),
    "year": ("year",),
    "station": ("stationname", "station"),
    "magnitude": ("earthquakemagnitude", "momentmagnitude", "magnitude", "mw", "mag"),
    "distance": ("clstdkm", "rrupkm", "rrup", "joynerbooredistkm", "rjbkm", "rjb", "epidkm"),
    "vs30": ("vs30msselectedforanalysis", "vs30msec", "vs30ms", "preferredvs30ms", "vs30"),
}
"""Names of each column without blanks, capitals and punctuation, the preferred first; distances are in km."""
FILES = re.compile(r"(filename(horizontal\d|vertical)|(horizontal\d|vertical)accfilename)")
UNKNOWN = -998.0


@dataclass(frozen=True)
class Recording:
    """One recording of the NGA database; "" or None for what the table does not say.

    magnitude [-]; distance [m], to the rupture if the table has it; vs30 [m/s]; files: names in lower case, no folders
    """

    nga: int
    event: str
    year: str
    station: str
    magnitude: float | None
    distance: float | None
    vs30: float | None
    files: tuple[str, ...]


def read_flatfile(path: Path) -> tuple[Recording, ...]:
    """Every recording of the flatfile at `path`, in order; lines without a sequence number are passed over.

    Raises RecordError, naming the file, where it cannot be read, has no column of sequence numbers, or no recording.
    """
    try:
        rows = list(csv.reader(io.StringIO(decode(path.read_bytes(), where=str(path)), newline="")))
    except OSError as error:
        raise RecordError(f"{path}: the flatfile cannot be read: {error.strerror}") from None
    except (csv.Error, ColumnError) as error:
        raise RecordError(f"{path}: not a table in CSV: {error}") from None
    at = next((i for i, row in enumerate(rows) if set(NUMBER) & {plain(cell) for cell in row}), None)
    if at is None:
        raise RecordError(
            f'{path}: no column "Record Sequence Number"; give a PEER NGA flatfile, saved as CSV with its header'
        )
    found = tuple(_recordings(rows[at + 1 :], [plain(cell) for cell in rows[at]]))
    if not found:
        raise RecordError(f"{path}: no recording below the header in line {at + 1}; the table is cut short")
    return found


def plain(label: str) -> str:
    """The letters and digits of a label, lower case."""
    return re.sub(r"[^a-z0-9]+", "", label.lower())


def _recordings(rows: Sequence[Sequence[str]], header: Sequence[str]) -> Iterator[Recording]:
    number = next(i for i, name in enumerate(header) if name in NUMBER)
    columns = {key: [header.index(name) for name in names if name in header] for key, names in COLUMNS.items()}
    files = [i for i, name in enumerate(header) if FILES.fullmatch(name)]
    for row in rows:
        nga = row[number].strip() if number < len(row) else ""
        if re.fullmatch(r"\d{1,9}", nga):
            words = {key: _word(row, columns[key]) for key in ("event", "station")}
            numbers = {key: _number(row, columns[key]) for key in ("year", "magnitude", "distance", "vs30")}
            names = tuple(filter(None, (re.split(r"[/\\]", _word(row, [i]))[-1].lower() for i in files)))
            yield Recording(
                nga=int(nga),
                event=words["event"],
                year="" if numbers["year"] is None else f"{numbers['year']:.0f}",
                station=words["station"],
                magnitude=numbers["magnitude"],
                distance=None if numbers["distance"] is None else 1000.0 * numbers["distance"],
                vs30=numbers["vs30"],
                files=names,
            )


def _word(row: Sequence[str], columns: Sequence[int]) -> str:
    return next((row[i].strip() for i in columns if i < len(row) and row[i].strip()), "")


def _number(row: Sequence[str], columns: Sequence[int]) -> float | None:
    """The first of the columns that holds a number which is known."""
    for i in columns:
        try:
            value = float(row[i])
        except (ValueError, IndexError):
            continue
        if np.isfinite(value) and value > UNKNOWN:
            return value
    return None


def described_by(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> tuple[Candidate, ...]:
    """The candidates, with what `recordings` know of them before what their files say.

    They are found by the NGA number in their file's name, else by a file name that one recording alone has.
    """
    by_number = {one.nga: one for one in recordings}
    by_file: dict[str, Recording | None] = {}
    for one in recordings:
        for file in one.files:
            by_file[file] = one if by_file.get(file, one) == one else None
    if not recordings:
        return tuple(candidates)
    return tuple(
        one if found is None else _described(one, found)
        for one in candidates
        for found in (by_number.get(one.nga or 0) or by_file.get(one.path.rsplit("/", 1)[-1].lower()),)
    )


def _described(one: Candidate, by: Recording) -> Candidate:
    return replace(
        one,
        nga=by.nga,
        event=by.event or one.event,
        station=by.station or one.station,
        date=one.date if one.date[:4] == by.year else by.year or one.date,
        magnitude=one.magnitude if by.magnitude is None else by.magnitude,
        distance=one.distance if by.distance is None else by.distance,
        vs30=one.vs30 if by.vs30 is None else by.vs30,
    )
