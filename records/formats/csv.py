"""Two columns of text, time and acceleration, with their units in the header: `time [s], acceleration [g]`.

Comments before the header may say more (`comments`): `# event: Loma Prieta`, `# magnitude: 6.9`.
A file without units, or without a header, is read too where the caller states the unit of its accelerations; its
times are then seconds.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.comments import parse_comments, record_fields
from records.formats.header_overrides import GIVE_UNIT, HeaderOverrides
from records.formats.samples import number
from records.record import Record, make_record
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
