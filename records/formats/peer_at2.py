"""PEER AT2: four lines of header, then accelerations in g, five to a line.

    PEER NGA STRONG MOTION DATABASE RECORD
    Kern County, 7/21/1952, Taft Lincoln School, 21
    ACCELERATION TIME SERIES IN UNITS OF G
    NPTS=   5435, DT=   .0100 SEC,   0 POLE @    13.90000 HZ,  -5 POLE @      .10000

Line 4 comes in several dresses: lower case, with or without SEC and the corner frequencies, or as bare numbers
before their names (`4096    0.0100    NPTS, DT`). Line 2 is `Event, m/d/yyyy, Station, Component` in the NGA files
and `EVENT mm/dd/yy hhmm, STATION, COMPONENT (AGENCY)` in the older ones.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from records.errors import RecordError
from records.record import Record, make_record
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

FloatArray = NDArray[np.float64]

NAME = "PEER AT2"
HEADER_LINES = 4

UNITS = re.compile(r"^\s*ACCELERATION\s+TIME\s+(?:HISTORY|SERIES)\s+IN\s+UNITS\s+OF\s+([^\s.,;]+)", re.IGNORECASE)
NUMBER = r"([-+]?[\w.+-]+)"
STEPS = (
    re.compile(rf"NPTS\s*=\s*{NUMBER}[\s,]*DT\s*=\s*{NUMBER}", re.IGNORECASE),
    re.compile(rf"^\s*{NUMBER}[\s,]+{NUMBER}[\s,]+NPTS\s*,\s*DT", re.IGNORECASE),
)
DATE = re.compile(r"[\s,]*\b(\d{1,2}/\d{1,2}/\d{2,4})\b(?:[ \t]+\d{4}(?=\s*,)|[\s,]+\d{1,2}:\d{2}(?=\s*,))?[\s,]*")
AGENCY = re.compile(r"\s*\([^()]*\)\s*$")
TOUCHING = re.compile(rb"(?<=[0-9.])(?=[-+])")


@dataclass(frozen=True)
class Title:
    """What line 2 says: names of event, station and component, and the date as printed; "" for what it does not say."""

    event: str
    date: str
    station: str
    component: str


def looks_like(head: bytes) -> bool:
    """Whether a file that begins with `head` is PEER AT2: its third line states acceleration and a unit."""
    lines = head.decode("latin-1").splitlines()
    return len(lines) > 2 and UNITS.match(lines[2]) is not None


def read(path: Path, *, unit: str | None = None) -> tuple[Record, ...]:
    """The one record in the file at `path`; its header states its unit, so `unit` is not needed.

    Raises RecordError, naming the file, for a header without NPTS and DT, for more or fewer samples than NPTS says
    and for what is not a number.
    """
    parts = path.read_bytes().split(b"\n", HEADER_LINES)
    lines = [part.decode("latin-1").strip() for part in parts[:HEADER_LINES]]
    found = UNITS.match(lines[2]) if len(lines) > 2 else None
    if found is None or len(lines) < HEADER_LINES:
        raise RecordError(f"{path}: the header is cut short; PEER AT2 has four lines before the accelerations")
    npts, dt = _steps(lines[3], path=path)
    samples = _factor(found[1], path=path) * _samples(
        parts[HEADER_LINES] if len(parts) > HEADER_LINES else b"", path=path
    )
    _check_count(npts, samples.size, path=path)
    title = parse_title(lines[1])
    trail = (f"read from {NAME}, unit {found[1].lower()}" + (f", event of {title.date}" if title.date else ""),)
    return (
        make_record(
            path.stem,
            samples,
            dt,
            path=str(path),
            event=title.event,
            station=title.station,
            component=title.component,
            trail=trail,
        ),
    )


def parse_title(line: str) -> Title:
    """Event, date, station and component from line 2, of the older form or the newer."""
    date = DATE.search(line)
    if date is None:
        event, _, rest = line.partition(",")
    else:
        event, rest = line[: date.start()], line[date.end() :]
    station, _, component = rest.rpartition(",")
    event = re.sub(r"\s+EQ$", "", event.strip(" ,\t"))
    return Title(event, date[1] if date else "", station.strip(" ,\t"), AGENCY.sub("", component).strip())


def _steps(line: str, *, path: Path) -> tuple[str, float]:
    """NPTS, as printed, and DT [s] from line 4."""
    found = next((match for match in (pattern.search(line) for pattern in STEPS) if match), None)
    if found is None:
        raise RecordError(f'{path}: line 4: "{line[:60]}" does not state NPTS and DT, like: NPTS=  4000, DT= .0100 SEC')
    if not re.fullmatch(r"\d+\.?", found[1]):
        raise RecordError(f'{path}: line 4: NPTS = "{found[1][:20]}"; it must be a count of samples')
    try:
        dt = float(found[2])
    except ValueError:
        dt = 0.0
    if not (np.isfinite(dt) and dt > 0.0):
        raise RecordError(f'{path}: line 4: DT = "{found[2][:20]}"; it must be a time step in seconds, above zero')
    return found[1].rstrip("."), dt


def _factor(unit: str, *, path: Path) -> float:
    try:
        return factor_of(unit, known=ACCELERATION_UNITS)
    except ColumnError as error:
        raise RecordError(f"{path}: line 3: {error}") from None


def _samples(body: bytes, *, path: Path) -> FloatArray:
    """The numbers below the header, as printed [n]; a sign ends the number before it."""
    try:
        return np.array(body.split(), dtype=np.float64)
    except ValueError:
        pass
    try:
        return np.array(TOUCHING.sub(b" ", body).split(), dtype=np.float64)
    except ValueError:
        raise RecordError(f"{path}: {_first_bad(body)}") from None


def _first_bad(body: bytes) -> str:
    """Where the first field that is not a number stands."""
    for number, line in enumerate(body.split(b"\n"), start=HEADER_LINES + 1):
        for field in TOUCHING.sub(b" ", line).split():
            try:
                float(field)
            except ValueError:
                return f'line {number}: "{field.decode("latin-1")[:20]!s}" is not a number'
    return "the accelerations are not all numbers"


def _check_count(npts: str, size: int, *, path: Path) -> None:
    """Refuses a file whose samples are not as many as NPTS, as printed, says; however long a number that is."""
    stated, held = npts.lstrip("0") or "0", str(size)
    if stated != held:
        short = (len(stated), stated) > (len(held), held)
        remedy = "the file is cut short" if short else "the header or the data are wrong"
        raise RecordError(f"{path}: NPTS says {npts[:20]} samples, the file holds {size}; {remedy}")
