"""PEER flatfiles: tables in CSV that say of each recording of the NGA database which earthquake and site it is of.

Understood are the NGA-West flatfiles and the table that the PEER web site gives with a search. Columns are found by
their names, in a header that may follow some lines of text. Numbers of -999 and below, and words like N/A, mean that a
value is unknown. Rows of more or fewer columns than the header, which decimal commas or a lost comma make, are skipped.
A row describes a record by its NGA number, else by a file name that this row alone has.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from assess.messages.message import Message, warning
from records.candidates import Candidate
from records.errors import RecordError
from records.formats.samples import number
from spectra.columns import ColumnError, csv_rows, decode

if TYPE_CHECKING:
    from pandas import DataFrame


NUMBER = ("recordsequencenumber", "rsn", "nga", "ngaid", "nganumber")

COLUMNS: Mapping[str, Sequence[str]] = {
    "event": ("earthquakename", "eventname", "earthquake", "event"),
    "year": ("year",),
    "station": ("stationname", "station"),
    "magnitude": ("earthquakemagnitude", "momentmagnitude", "magnitude", "mw", "mag"),
    "distance": ("clstdkm", "rrupkm", "rrup", "joynerbooredistkm", "rjbkm", "rjb", "epidkm"),
    "vs30": ("vs30msselectedforanalysis", "vs30msec", "vs30ms", "preferredvs30ms", "vs30"),
}
"""Names of each column in lower case without blanks and punctuation, the preferred first; distances are in km."""
DECIDING = ("event", "magnitude", "distance", "vs30")  # what records are selected by
FILES = re.compile(r"(filename(horizontal\d|vertical)|(horizontal\d|vertical)accfilename)")
SEQUENCE = "[0-9]{1,9}"
UNKNOWN = -998.0
UNKNOWN_WORDS = {"", "-", "--", "?", "na", "n/a", "nan", "none", "null", "unknown"}

LIMITS: Mapping[str, tuple[float, float]] = {
    "year": (0.0, 9999.0),
    "magnitude": (-3.0, 10.0),
    "distance": (0.0, 20_000.0),  # km, half of the earth's girth
    "vs30": (1.0, 10_000.0),
}
"""Plausible range of each number; one outside is a typing error, or in another unit."""


@dataclass(frozen=True)
class FlatfileRow:
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
    """A cell with an impossible value; row: from 1, as a spreadsheet counts; column: its label."""

    row: int
    column: str
    value: str


@dataclass(frozen=True)
class Flatfile:
    """The recordings of a flatfile in order, its cells that were skipped, and deciding columns that it lacks."""

    recordings: tuple[FlatfileRow, ...]
    bad: tuple[BadCell, ...]
    missing: tuple[str, ...] = ()


def read_flatfile(path: Path) -> Flatfile:
    """Read every recording of the flatfile at `path`; blank lines and rows without a sequence number are skipped.

    Raises RecordError, naming the file, if it cannot be read, has no column of sequence numbers, or no recording.
    """
    try:
        rows = csv_rows(io.StringIO(decode(path.read_bytes(), where=str(path)), newline=""))
        line, labels = next(((i, row) for i, row in rows if set(NUMBER) & set(map(_plain_label, row))), (0, []))
        if not labels:
            raise RecordError(
                f'{path}: no column "Record Sequence Number"; give a PEER NGA flatfile, saved as CSV with its header'
            )
        columns = _columns([_plain_label(label) for label in labels])
        table = _table(rows, columns, width=_width(labels))
    except OSError as error:
        raise RecordError(f"{path}: the flatfile cannot be read: {error.strerror}") from None
    except ColumnError as error:
        raise RecordError(str(error) if str(error).startswith(str(path)) else f"{path}: {error}") from None
    found = _recordings(table[table["numbered"] & table["fits"]], columns)
    if not found:
        raise RecordError(
            f"{path}: no recording as wide as the header in line {line}, {_width(labels)} columns, below it; the table "
            "is cut short, or commas separate more than columns"
        )
    bad = tuple(
        BadCell(row, "columns" if i < 0 else labels[i].strip(), cell) for row, i, cell in _bad_cells(table, columns)
    )
    return Flatfile(found, bad, tuple(key for key in DECIDING if not columns[key]))


@dataclass(frozen=True)
class FlatfileMatch:
    """How a flatfile matches the records: rows matched and not, records described, bad cells.

    warning : why no row matches, which columns are missing, or how many records have no row; None otherwise
    """

    matched: int
    unmatched: int
    records: int
    bad: tuple[BadCell, ...]
    warning: Message | None


def describe_candidates(candidates: Sequence[Candidate], recordings: Sequence[FlatfileRow]) -> tuple[Candidate, ...]:
    """Describe the candidates by a flatfile, whose values replace those of the record files.

    A recording is found by the NGA number in the name of the candidate's file, else by a file name that it alone has.

    Parameters
    ----------
    candidates : records of a catalogue or of files [n]
    recordings : of the flatfile

    Returns
    -------
    tuple of Candidate : in the same order [n]
    """
    rows = _find_rows(candidates, recordings)
    return tuple(each if row is None else _describe(each, row) for each, row in zip(candidates, rows, strict=True))


def match_flatfile(candidates: Sequence[Candidate], flatfile: Flatfile) -> FlatfileMatch:
    """Count how many rows of a flatfile and candidates match.

    Parameters
    ----------
    candidates : records of a catalogue or of files
    flatfile : as read, with its bad cells
    """
    rows = [row for row in _find_rows(candidates, flatfile.recordings) if row is not None]
    matched = len({row.nga for row in rows})
    if rows:
        message = _columns_missing(flatfile.missing) or _rows_absent(candidates, flatfile.recordings)
    else:
        message = _no_match_reason(candidates, flatfile.recordings)
    return FlatfileMatch(matched, len(flatfile.recordings) - matched, len(rows), flatfile.bad, message)


def _plain_label(label: str) -> str:
    """Return the letters and digits of a label, in lower case."""
    return re.sub(r"[^a-z0-9]+", "", label.lower())


def _columns(header: Sequence[str]) -> dict[str, list[int]]:
    """Find the indices of the columns of each key, the preferred first."""
    found = {key: [header.index(name) for name in names if name in header] for key, names in COLUMNS.items()}
    found["nga"] = [i for i, name in enumerate(header) if name in NUMBER][:1]
    return found | {"files": [i for i, name in enumerate(header) if FILES.fullmatch(name)]}


def _table(rows: Iterable[tuple[int, list[str]]], columns: Mapping[str, Sequence[int]], *, width: int) -> DataFrame:
    """Keep the cells of the columns that are known, of the rows that are not blank.

    The index is the line, a column's label its place in the file; fits: whether the row is as wide as the header;
    size: how wide, in words; numbered: whether it has a sequence number. The rows are split by the standard library,
    since pandas fills up those that have lost a comma.
    """
    from pandas import DataFrame

    used = sorted({i for places in columns.values() for i in places})
    lines, cells = list[int](), list[tuple[object, ...]]()
    for line, row in rows:
        if filled := _width(row):
            kept = (row[i].strip() if i < len(row) else "" for i in used)
            lines.append(line)
            cells.append((filled <= width <= len(row), f"{max(filled, len(row))} of {width}", *kept))
    table = DataFrame(cells, index=lines, columns=["fits", "size", *used], dtype=object)
    numbered = [re.fullmatch(SEQUENCE, cell) is not None for cell in table[columns["nga"][0]]]
    return table.assign(fits=table["fits"].astype(bool), numbered=numbered)


def _width(row: Sequence[str]) -> int:
    """Count the columns up to the last that is not blank."""
    return next((i for i in range(len(row), 0, -1) if row[i - 1].strip()), 0)


def _recordings(table: DataFrame, columns: Mapping[str, list[int]]) -> tuple[FlatfileRow, ...]:
    """Take each row as a recording."""
    event, station = (_first_known(table[columns[key]].replace("", None), "") for key in ("event", "station"))
    year, magnitude, km, vs30 = (_first_known(_plausible(table[columns[key]], LIMITS[key]), None) for key in LIMITS)
    years = ("" if each is None else f"{each:.0f}" for each in year)
    metres = (None if each is None else 1000.0 * each for each in km)
    files = (tuple(filter(None, map(_file_name, row))) for row in table[columns["files"]].to_numpy())
    numbers = map(int, table[columns["nga"][0]])
    rows = zip(numbers, event, years, station, magnitude, metres, vs30, files, strict=True)
    return tuple(FlatfileRow(*row) for row in rows)


def _file_name(path: str) -> str:
    """Return the name of a file without its folders, in lower case."""
    return path.replace("\\", "/").rpartition("/")[2].lower()


def _plausible(cells: DataFrame, limits: tuple[float, float]) -> DataFrame:
    """Return the numbers within the limits; nan for every other cell."""
    values = cells.map(number).astype(float)
    return values.where((values >= limits[0]) & (values <= limits[1]))


def _first_known(cells: DataFrame, unknown: str | None) -> list[Any]:
    """Return the first value of each row that is known; `unknown` where there is none."""
    if cells.shape[1] == 0:
        return [unknown] * len(cells)
    first = cells.bfill(axis=1).iloc[:, 0].astype(object)
    return list(first.where(first.notna(), unknown))


def _bad_cells(table: DataFrame, columns: Mapping[str, list[int]]) -> list[tuple[int, int, str]]:
    """Find the cells that are neither unknown nor plausible, by line and column; -1 and its size for a whole row."""
    nga = columns["nga"][0]
    misnumbered, misfit = ~table["numbered"] & ~table[nga].map(_unknown), table["numbered"] & ~table["fits"]
    found: list[tuple[Any, ...]] = [(line, 0, nga, cell) for line, cell in table.loc[misnumbered, nga].items()]
    found += [(line, 0, -1, size) for line, size in table.loc[misfit, "size"].items()]
    rest, places = table[table["fits"] & ~misnumbered], [(i, key) for key in LIMITS for i in columns[key]]
    for order, (i, key) in enumerate(places, start=1):
        impossible = _plausible(rest[[i]], LIMITS[key])[i].isna() & ~rest[i].map(_unknown)
        found += [(line, order, i, cell) for line, cell in rest.loc[impossible, i].items()]
    return [(line, i, cell) for line, _, i, cell in sorted(found)]


def _unknown(cell: str) -> bool:
    value = number(cell)
    return cell.lower() in UNKNOWN_WORDS or (value is not None and value < UNKNOWN)


def _find_rows(candidates: Sequence[Candidate], recordings: Sequence[FlatfileRow]) -> list[FlatfileRow | None]:
    """Find the row of each candidate; None where there is none."""
    by_number = {row.nga: row for row in recordings}
    by_file: dict[str, FlatfileRow | None] = {}
    for row in recordings:
        for file in row.files:
            by_file[file] = row if by_file.get(file, row) == row else None
    named = ((candidate, by_file.get(_file_name(candidate.path))) for candidate in candidates)
    return [
        by_number.get(candidate.nga or 0) or (row if row is not None and candidate.nga in (None, row.nga) else None)
        for candidate, row in named
    ]


def _columns_missing(keys: Sequence[str]) -> Message | None:
    """Say which columns were not found; None if none is missing."""
    if not keys:
        return None
    known = "; ".join(f"{key}: {', '.join(COLUMNS[key])}" for key in keys)
    return warning("flatfile-columns-missing", keys=", ".join(keys), known=known)


def _rows_absent(candidates: Sequence[Candidate], recordings: Sequence[FlatfileRow]) -> Message | None:
    """Say how many records have no row; None if all have one."""
    rows = zip(candidates, _find_rows(candidates, recordings), strict=True)
    unmatched = [candidate for candidate, row in rows if row is None]
    if not unmatched:
        return None
    counts = {"total": str(len(candidates)), "count": str(len(unmatched))}
    return warning("flatfile-rows-absent", **counts, file=_file_name(unmatched[0].path))


def _no_match_reason(candidates: Sequence[Candidate], recordings: Sequence[FlatfileRow]) -> Message:
    """Say why no row matches a record."""
    if not candidates:
        return warning("flatfile-no-records")
    numbers = sorted(each.nga for each in candidates if each.nga is not None)
    first, last = min(row.nga for row in recordings), max(row.nga for row in recordings)
    if numbers:
        ends = {"first": numbers[0], "last": numbers[-1], "first_row": first, "last_row": last}
        return warning("flatfile-other-numbers", **{key: str(number) for key, number in ends.items()})
    names = sorted(file for row in recordings for file in row.files)
    example = names[0] if names else f"RSN{first}_….AT2"
    return warning("flatfile-no-numbers", file=_file_name(candidates[0].path), example=example)


def _describe(candidate: Candidate, row: FlatfileRow) -> Candidate:
    return replace(
        candidate,
        nga=row.nga,
        event=row.event or candidate.event,
        station=row.station or candidate.station,
        date=candidate.date if candidate.date[:4] == row.year else row.year or candidate.date,
        magnitude=candidate.magnitude if row.magnitude is None else row.magnitude,
        distance=candidate.distance if row.distance is None else row.distance,
        vs30=candidate.vs30 if row.vs30 is None else row.vs30,
    )
