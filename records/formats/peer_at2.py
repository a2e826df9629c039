"""PEER AT2: four lines of header, then accelerations in g, five to a line.

    PEER NGA STRONG MOTION DATABASE RECORD
    Kern County, 7/21/1952, Taft Lincoln School, 21
    ACCELERATION TIME SERIES IN UNITS OF G
    NPTS=   5435, DT=   .0100 SEC,   0 POLE @    13.90000 HZ,  -5 POLE @      .10000

Line 4 comes in several forms: lower case, with or without SEC and the corner frequencies, or as bare numbers
before their names (`4096    0.0100    NPTS, DT`). Line 2 is `Event, m/d/yyyy, Station, Component` in the NGA files
and `EVENT mm/dd/yy hhmm, STATION, COMPONENT (AGENCY)` in the older ones.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.header import (
    HeaderOverrides,
    check_count,
    check_same,
    describe_disagreement,
    filter_warning,
    iso_time,
)
from records.formats.samples import acceleration_factor, number, text_lines, uniform_numbers
from records.record import Earthquake, Record, azimuth_of, make_record

NAME = "PEER AT2"
HEADER_LINES = 4

UNITS = re.compile(r"^\s*ACCELERATION\s+TIME\s+(?:HISTORY|SERIES)\s+IN\s+UNITS\s+OF\s+([^\s.,;]+)", re.IGNORECASE)
NUMBER = r"([-+]?[\w.+-]+)"
STEPS = (
    re.compile(rf"NPTS\s*=\s*{NUMBER}[\s,]*DT\s*=\s*{NUMBER}", re.IGNORECASE),
    re.compile(rf"^\s*{NUMBER}[\s,]+{NUMBER}[\s,]+NPTS\s*,\s*DT", re.IGNORECASE),
)
DATE = re.compile(r"[\s,]*\b(\d{1,2}/\d{1,2}/\d{2,4})\b(?:[ \t]+\d{4}(?=\s*,)|[\s,]+\d{1,2}:\d{2}(?=\s*,))?[\s,]*")
CORNERS = re.compile(r"([-+]?\d+)\s*POLE\s*@\s*([\d.]+)", re.IGNORECASE)
NAMED = re.compile(r"RSN\d+_.*?(\d{3})", re.IGNORECASE)
BESIDE = (".VT2", ".DT2", ".vt2", ".dt2")  # velocities and displacements of the same motion
AGENCY = re.compile(r"\s*\([^()]*\)\s*$")


@dataclass(frozen=True)
class Title:
    """What line 2 says: names of event, station and component, and the date as printed; "" for what it does not say."""

    event: str
    date: str
    station: str
    component: str


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` is PEER AT2: its third line states acceleration and a unit."""
    lines = head.decode("latin-1").splitlines()
    return len(lines) > 2 and UNITS.match(lines[2]) is not None


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`; its header says all that is needed.

    Raises RecordError, naming the file, for a header without NPTS and DT, for more or fewer samples than NPTS says
    and for what is not a number.
    """
    lines = text_lines(path)
    found = UNITS.match(lines[2]) if len(lines) > 2 else None
    if found is None or len(lines) < HEADER_LINES:
        raise RecordError(f"{path}: the header is cut short; PEER AT2 has four lines before the accelerations")
    npts, dt = _steps(lines[3].strip(), path=path)
    factor = acceleration_factor(found[1], line=3, path=path)
    samples, uneven = uniform_numbers(lines[HEADER_LINES:], first=HEADER_LINES + 1, path=path)
    check_count(npts, samples.size, path=path)
    _check_beside(dt, path=path)
    low, high = _corners(lines[3])
    title = parse_title(lines[1].strip())
    history = (_reading(found[1].lower(), title.date),)
    return (
        make_record(
            path.stem,
            factor * samples,
            dt,
            path=str(path),
            event=title.event,
            station=title.station,
            component=title.component,
            processing_history=history,
            azimuth=azimuth_of(title.component),
            earthquake=Earthquake(time=_iso(title.date)),
            warnings=(uneven, filter_warning(samples, dt, low=low, high=high), _misnamed(title.component, path)),
        ),
    )


def parse_title(line: str) -> Title:
    """Parse event, date, station and component from line 2, of the older form or the newer."""
    date = DATE.search(line)
    if date is None:
        event, _, rest = line.partition(",")
    else:
        event, rest = line[: date.start()], line[date.end() :]
    station, _, component = rest.rpartition(",")
    event = re.sub(r"\s+EQ$", "", event.strip(" ,\t"))
    return Title(event, date[1] if date else "", station.strip(" ,\t"), AGENCY.sub("", component).strip())


def _corners(line: str) -> tuple[float | None, float | None]:
    """Return the corners [Hz] of the filters in line 4, None where there is none; the low one has poles below 0."""
    corners = {poles.startswith("-"): number(corner, unknown=(0.0,)) for poles, corner in CORNERS.findall(line)}
    return corners.get(True), corners.get(False)


def _reading(unit: str, date: str) -> Message:
    if not date:
        return note("read-from", format=NAME, unit=unit)
    return note("read-from-event", format=NAME, unit=unit, date=date)


def _misnamed(component: str, path: Path) -> Message | None:
    """Return a warning where the name of the file, as PEER gives it, has another direction than the header."""
    named = NAMED.fullmatch(path.stem)
    if named is None or not component.isdigit() or int(component) % 360 == int(named[1]) % 360:
        return None
    return describe_disagreement("component", component, "file's name", named[1])


def _check_beside(dt: float, *, path: Path) -> None:
    """Refuse a step [s] other than that of the velocities or displacements of the same name in the same folder."""
    for other in (path.with_suffix(ending) for ending in BESIDE):
        try:
            with other.open(encoding="latin-1") as file:
                header = [file.readline() for _ in range(HEADER_LINES)]
        except OSError:
            continue
        found = next((match for match in (pattern.search(header[3].strip()) for pattern in STEPS) if match), None)
        if found:
            check_same("line 4: DT", dt, f"that of {other.name}", number(found[2]), slack=0.01 * dt, path=path)


def _iso(date: str) -> str:
    """Convert mm/dd/yy or m/d/yyyy to ISO 8601; two digits are of the older database, which ends in 1999."""
    month, day, year = (*date.split("/"), "", "", "")[:3]
    return iso_time(year if len(year) == 4 else f"19{year}", month, day)


def _steps(line: str, *, path: Path) -> tuple[str, float]:
    """Return NPTS, as printed, and DT [s] from line 4."""
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
