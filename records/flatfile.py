"""PEER flatfiles: what a CSV table of the NGA database says of each recording, columns found by their names.

Understood are the NGA-West flatfiles and the table that the PEER web site gives with a search; the header may stand
some lines below the top. Numbers of -999 and below, and words like N/A, mean that a value is not known. A row of more
or fewer columns than the header, as decimal commas or a lost one make them, is passed over.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from records.candidates import Candidate
from records.errors import RecordError
from records.formats.samples import number
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
DECIDING = ("event", "magnitude", "distance", "vs30")  # by what records are selected
FILES = re.compile(r"(filename(horizontal\d|vertical)|(horizontal\d|vertical)accfilename)")
UNKNOWN = -998.0
UNKNOWN_WORDS = {"", "-", "--", "?", "na", "n/a", "nan", "none", "null", "unknown"}
LIMITS: Mapping[str, tuple[float, float]] = {
    "year": (0.0, 9999.0),
    "magnitude": (-3.0, 10.0),
    "distance": (0.0, 20_000.0),  # km, half of the earth's girth
    "vs30": (1.0, 10_000.0),
}
"""What a number can be; one outside is a slip of the pen, or of another unit."""


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


@dataclass(frozen=True)
class BadCell:
    """A cell that holds no value that can be; row: from 1, as a spreadsheet counts; column: its label."""

    row: int
    column: str
    value: str


@dataclass(frozen=True)
class Flatfile:
    """The recordings of a flatfile in order, its cells that were passed over, and deciding columns that it lacks."""

    recordings: tuple[Recording, ...]
    bad: tuple[BadCell, ...]
    missing: tuple[str, ...] = ()


@dataclass(frozen=True)
class MatchSummary:
    """What became of a flatfile: rows matched and not, the records that they describe, bad cells.

    warning : why no row fits, or which columns are missing, in words; "" where all is well
    """

    matched: int
    unmatched: int
    records: int
    bad: tuple[BadCell, ...]
    warning: str


def read_flatfile(path: Path) -> Flatfile:
    """Every recording of the flatfile at `path`; blank lines and those of unknown sequence number are passed over.

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
    columns = _columns([plain(cell) for cell in rows[at]])
    below = [(number, row) for number, row in enumerate(rows[at + 1 :], start=at + 2) if any(map(str.strip, row))]
    width = _width(rows[at])
    fits = [row for _, row in below if _width(row) <= width <= len(row)]
    found = tuple(one for row in fits if (one := _recording(row, columns)) is not None)
    if not found:
        raise RecordError(
            f"{path}: no recording as wide as the header in line {at + 1}, {width} columns, below it; the table is "
            "cut short, or commas separate more than columns"
        )
    bad = (cell for number, row in below for cell in _bad(row, columns, labels=rows[at], number=number))
    return Flatfile(found, tuple(bad), tuple(key for key in DECIDING if not columns[key]))


def _width(row: Sequence[str]) -> int:
    """How many columns there are up to the last that holds something."""
    return max(i for i, cell in enumerate(row, start=1) if cell.strip())


def plain(label: str) -> str:
    """The letters and digits of a label, lower case."""
    return re.sub(r"[^a-z0-9]+", "", label.lower())


def _columns(header: Sequence[str]) -> dict[str, list[int]]:
    """Indices of the columns of each key, the preferred first."""
    found = {key: [header.index(name) for name in names if name in header] for key, names in COLUMNS.items()}
    found["nga"] = [i for i, name in enumerate(header) if name in NUMBER]
    return found | {"files": [i for i, name in enumerate(header) if FILES.fullmatch(name)]}


def _recording(row: Sequence[str], columns: Mapping[str, Sequence[int]]) -> Recording | None:
    """The recording of a row; None without a sequence number."""
    nga = _word(row, columns["nga"][:1])
    if not re.fullmatch(r"\d{1,9}", nga):
        return None
    known = {key: _number(row, columns[key], limits) for key, limits in LIMITS.items()}
    names = (re.split(r"[/\\]", _word(row, [i]))[-1].lower() for i in columns["files"])
    return Recording(
        nga=int(nga),
        event=_word(row, columns["event"]),
        year="" if known["year"] is None else f"{known['year']:.0f}",
        station=_word(row, columns["station"]),
        magnitude=known["magnitude"],
        distance=None if known["distance"] is None else 1000.0 * known["distance"],
        vs30=known["vs30"],
        files=tuple(filter(None, names)),
    )


def _word(row: Sequence[str], columns: Sequence[int]) -> str:
    return next((row[i].strip() for i in columns if i < len(row) and row[i].strip()), "")


def _number(row: Sequence[str], columns: Sequence[int], limits: tuple[float, float]) -> float | None:
    """The first of the columns that holds a number which is known and can be."""
    values = (number(row[i]) for i in columns if i < len(row))
    return next((value for value in values if value is not None and limits[0] <= value <= limits[1]), None)


def _bad(
    row: Sequence[str], columns: Mapping[str, Sequence[int]], *, labels: Sequence[str], number: int
) -> Iterator[BadCell]:
    """The cells of a row that are neither unknown nor what their column can hold; its width where that is wrong."""
    nga = columns["nga"][0]
    if nga < len(row) and not _unknown(row[nga]) and not re.fullmatch(r"\d{1,9}", row[nga].strip()):
        yield BadCell(number, labels[nga].strip(), row[nga].strip())
        return
    if not _width(row) <= _width(labels) <= len(row):
        if re.fullmatch(r"\d{1,9}", _word(row, [nga])):
            yield BadCell(number, "columns", f"{max(_width(row), len(row))} of {_width(labels)}")
        return
    for key, limits in LIMITS.items():
        for i in columns[key]:
            if i < len(row) and not _unknown(row[i]) and _number(row, [i], limits) is None:
                yield BadCell(number, labels[i].strip(), row[i].strip())


def _unknown(cell: str) -> bool:
    value = number(cell)
    return cell.strip().lower() in UNKNOWN_WORDS or (value is not None and value < UNKNOWN)


def describe_by(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> tuple[Candidate, ...]:
    """The candidates, with what `recordings` know of them before what their files say.

    They are found by the NGA number in their file's name, else by a file name that one recording alone has.
    """
    found = _found(candidates, recordings)
    return tuple(one if by is None else _described(one, by) for one, by in zip(candidates, found, strict=True))


def match_summary(candidates: Sequence[Candidate], flatfile: Flatfile) -> MatchSummary:
    """How far the rows of a flatfile and the candidates found each other."""
    found = [by for by in _found(candidates, flatfile.recordings) if by is not None]
    matched = len({by.nga for by in found})
    warning = _missing(flatfile.missing) if found else _reason(candidates, flatfile.recordings)
    return MatchSummary(matched, len(flatfile.recordings) - matched, len(found), flatfile.bad, warning)


def _found(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> list[Recording | None]:
    """The recording of each candidate, None where there is none."""
    by_number = {one.nga: one for one in recordings}
    by_file: dict[str, Recording | None] = {}
    for one in recordings:
        for file in one.files:
            by_file[file] = one if by_file.get(file, one) == one else None
    named = ((one, by_file.get(_file(one.path))) for one in candidates)
    return [
        by_number.get(one.nga or 0) or (by if by is not None and one.nga in (None, by.nga) else None)
        for one, by in named
    ]


def _missing(keys: Sequence[str]) -> str:
    """Which columns were not found, in words."""
    if not keys:
        return ""
    known = "; ".join(f"{key}: {' or '.join(COLUMNS[key])}" for key in keys)
    return (
        f"the flatfile has no column of {', '.join(keys)} under a name that is known, and the records' own files are "
        f"believed there; is its header misspelt? Known are, however they are spaced: {known}"
    )


def _reason(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> str:
    """Why no row is of a record, in words."""
    if not candidates:
        return "no row of the flatfile fits, for there is no record that can be read"
    numbers = sorted(one.nga for one in candidates if one.nga is not None)
    first, last = min(one.nga for one in recordings), max(one.nga for one in recordings)
    if numbers:
        return (
            f"no row of the flatfile fits: the files have NGA numbers {numbers[0]} to {numbers[-1]}, the table "
            f"{first} to {last}; it may be of another search or another NGA project"
        )
    names = sorted(file for one in recordings for file in one.files)
    example = f"{names[0]} as the table names it" if names else f"RSN{first}_….AT2"
    return (
        f"no row of the flatfile fits: rows are found by the NGA number in a file's name or by the file's name, and "
        f"{_file(candidates[0].path)} has neither; keep the names that files had when downloaded, like {example}"
    )


def _file(path: str) -> str:
    return path.replace("\\", "/").rsplit("/", 1)[-1].lower()


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
