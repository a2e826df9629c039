"""Two columns of text, time and acceleration, with their units in the header: `time [s], acceleration [g]`.

Comments before the header may say more, as our own files do: `# event: Loma Prieta`, `# magnitude: 6.9`,
`# distance [km]: 12.5`. A file without units, or without a header, is read too where the caller states the unit of its
accelerations; its times are then seconds.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import takewhile
from math import degrees, radians
from pathlib import Path
from typing import Any

import numpy as np

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.header import GIVE_UNIT, HeaderOverrides
from records.formats.samples import number
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record
from spectra.arrays import FloatArray
from spectra.columns import (
    ACCELERATION_UNITS,
    TIME_UNITS,
    ColumnError,
    Columns,
    decode,
    factor_of,
    is_row,
    read_columns,
    separator_of,
    split,
    unit_of,
)
from spectra.formulas import mark_formulas, unmark_formulas

NAME = "CSV"
UNIFORM = 0.05  # largest distance of a printed time from its place, in steps


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` has two columns: two fields a line below at most one header line.

    The first of these lines must be two numbers; a header alone must state a unit. Later faults are for `read` to name.
    """
    try:
        text = decode(head, where="")
    except ColumnError:
        return False
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        return False
    separator = separator_of(lines[0])
    if any(unit_of(label) for label in lines[0].split(separator)) and not lines[1:]:
        return True
    rows = lines if is_row(split(lines[0], separator)) else lines[1:]
    first = [split(line, separator) for line in rows[:3]]
    return bool(first) and all(len(row) == 2 for row in first) and is_row(first[0])


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`; the unit given is used where the header has none.

    Raises RecordError, naming the file, for a missing unit, times that are not uniform to 5 % of a step, and for what
    cannot be read.
    """
    try:
        columns = read_columns(path)
    except ColumnError as error:
        raise RecordError(str(error)) from None
    seconds, si, reading = _units(columns, overrides.unit, path=path)
    dt = _step(seconds * columns.values[:, 0], path=path)
    known = parse_comments(columns.comments)
    _refuse_cut(known.get("samples", ""), len(columns.values), path=path)
    before = (note("before-reading", trail=known["trail"]),) if known.get("trail") else ()
    history = (reading, *before)
    return (
        make_record(
            path.stem, si * columns.values[:, 1], dt, path=str(path), processing_history=history, **record_fields(known)
        ),
    )


def _refuse_cut(stated: str, found: int, *, path: Path) -> None:
    """Refuse a file with fewer or more rows than its comment `# samples:` says, which files written here have."""
    if stated and number(stated) != found:
        raise RecordError(
            f"{path}: {found} rows, and {stated[:20]} by its comment `# samples`; get the whole file, or take the "
            "comment out where rows were changed on purpose"
        )


def _units(columns: Columns, unit: str | None, *, path: Path) -> tuple[float, float, Message]:
    """Return what times and accelerations are multiplied by, and how they were read."""
    time, acceleration = columns.units
    stated = acceleration or unit
    if stated is None:
        raise RecordError(
            f"{path}: the file does not state the unit of its accelerations; write it in the header, or {GIVE_UNIT}"
        )
    if time is None and unit is None:
        raise RecordError(f"{path}: the header gives no unit for the time; write it like: time [s], acceleration [g]")
    try:
        seconds = factor_of(time or "s", known=TIME_UNITS)
        si = factor_of(stated, known=ACCELERATION_UNITS)
    except ColumnError as error:
        raise RecordError(f"{path}: {error}") from None
    return seconds, si, note("read-from" if acceleration else "read-from-given", format=NAME, unit=stated)


def _step(time: FloatArray, *, path: Path) -> float:
    """Return the step of uniform times [n] [s], to ten digits.

    A printed time is rounded, so the step is that of the whole length and each time may be off by 5 % of it.
    """
    bad = np.flatnonzero(~np.isfinite(time))
    if bad.size:
        raise RecordError(f"{path}: time {bad[0] + 1} is {time[bad[0]]}; every time must be a finite number")
    if time.size < 2 or time[-1] <= time[0]:
        raise RecordError(
            f"{path}: {time.size} times from {time[0]:.6g} s to {time[-1]:.6g} s; a record needs two, rising"
        )
    dt = float((time[-1] - time[0]) / (time.size - 1))
    off = np.flatnonzero(np.abs(time - time[0] - dt * np.arange(time.size)) > UNIFORM * dt)
    if off.size:
        at = int(np.argmax(np.abs(np.diff(time) - np.median(np.diff(time)))))
        raise RecordError(
            f"{path}: the times are not uniform: step {at + 1} is {time[at + 1] - time[at]:.6g} s, "
            f"others {np.median(np.diff(time)):.6g} s; resample the record to one step"
        )
    return float(f"{dt:.10g}")


COMMENT = re.compile(r"\s*#\s*([a-z][a-z0-9 ]*(?:\[[^\]]*\])?)\s*:\s*(.*?)\s*")
LONGEST = 2000  # characters of a comment


KNOWN: Mapping[str, Callable[[Record], str | float | None]] = {
    "event": lambda record: record.event,
    "origin": lambda record: record.earthquake.time,
    "magnitude": lambda record: record.earthquake.magnitude,
    "magnitude type": lambda record: record.earthquake.scale,
    "event latitude [deg]": lambda record: record.earthquake.latitude,
    "event longitude [deg]": lambda record: record.earthquake.longitude,
    "event depth [km]": lambda record: _times(0.001, record.earthquake.depth),
    "distance [km]": lambda record: _times(0.001, record.distance),
    "station": lambda record: record.station,
    "station latitude [deg]": lambda record: record.site.latitude,
    "station longitude [deg]": lambda record: record.site.longitude,
    "station elevation [m]": lambda record: record.site.elevation,
    "vs30 [m/s]": lambda record: record.site.vs30,
    "ground": lambda record: record.site.ground,
    "place": lambda record: record.site.place,
    "component": lambda record: record.component,
    "azimuth [deg]": lambda record: None if record.azimuth is None else degrees(record.azimuth),
    "samples": lambda record: float(record.npts),
    "trail": lambda record: "; ".join(map(str, record.processing_history)),
}
"""What is written, in this order, where it is known."""


def comments(record: Record) -> Iterator[str]:
    """Yield a line for each thing that is known of `record`."""
    for key, value_of in KNOWN.items():
        value = value_of(record)
        text = f"{value:.12g}" if isinstance(value, float | int) else value
        if text:
            yield f"# {key}: {mark_formulas(_on_one_line(text))}\n"


def parse_comments(lines: Sequence[str]) -> dict[str, str]:
    """Parse the comments before the first row, by key."""
    above = takewhile(lambda line: not line.strip() or line.lstrip().startswith("#"), lines)
    found = (COMMENT.fullmatch(line) for line in above)
    return {match[1]: unmark_formulas(match[2])[:LONGEST] for match in found if match}


def record_fields(text: Mapping[str, str]) -> dict[str, Any]:
    """Return the fields of a record for `make_record`; a number that cannot be read or cannot be is unknown."""
    known = {key: number(text.get(key, "")) for key in KNOWN}
    component, azimuth = text.get("component", ""), known["azimuth [deg]"]
    return {
        "event": text.get("event", ""),
        "station": text.get("station", ""),
        "component": component,
        "azimuth": azimuth_of(component) if azimuth is None else radians(azimuth % 360.0),
        "distance": _times(1000.0, known["distance [km]"]),
        "earthquake": Earthquake(
            time=text.get("origin", ""),
            magnitude=known["magnitude"],
            scale=text.get("magnitude type", ""),
            latitude=known["event latitude [deg]"],
            longitude=known["event longitude [deg]"],
            depth=_times(1000.0, known["event depth [km]"]),
        ),
        "site": StationSite(
            latitude=known["station latitude [deg]"],
            longitude=known["station longitude [deg]"],
            elevation=known["station elevation [m]"],
            vs30=known["vs30 [m/s]"],
            ground=text.get("ground", ""),
            place=text.get("place", ""),
        ),
    }


def _times(factor: float, value: float | None) -> float | None:
    return None if value is None else float(f"{factor * value:.12g}")


def _on_one_line(text: str) -> str:
    """Return `text` without line breaks and control characters, cut."""
    return "".join(c if c.isprintable() else " " for c in text)[:LONGEST]
