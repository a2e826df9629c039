"""Plain numbers: accelerations alone, in one column or several to a line, below a short header or none.

    NPTS=  1559, DT= .02000 SEC           as in AT2 files, below any text
    4684 0.0100                           count and step below a line of title

Files of two columns are times and accelerations, which is the format CSV. The unit is read where the header has it,
like "the units are (g)"; unit and step that are not in the file must be stated by the caller.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from assess.messages.message import Term, note
from records.errors import RecordError
from records.formats import peer_at2
from records.formats.header import GIVE_STEP, GIVE_UNIT, HeaderOverrides, check_count, check_same
from records.formats.samples import acceleration_factor, number, positive_number, text_lines, uniform_numbers
from records.record import Record, make_record
from spectra.arrays import FloatArray
from spectra.columns import CONTROL

NAME = "plain"
LONGEST_HEADER = 20
WIDEST_TABLE = 4  # columns; three components, and time

STEPS = re.compile(r"\s*NPTS\s*=\s*(\d+)\s*,?\s*DT\s*=\s*([\d.eE+-]+)", re.IGNORECASE)
COUNT_AND_STEP = re.compile(r"\s*(\d+)\s+(\d*\.\d+(?:[eE][-+]?\d+)?)\s*")
AGAIN = re.compile(r"\s*(\d+)\s+points at equal spacing of\s+([\d.]+)\s+sec", re.IGNORECASE)
UNITS = re.compile(r"\bunits?\s+(?:are|is|of|:|=)\s*\(?\s*([^\s(),;]+)", re.IGNORECASE)
VALUE = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?")
END = re.compile(r"[\s*]*(?:end of data|end data|end)?[\s*]*", re.IGNORECASE)


@dataclass(frozen=True)
class Header:
    """How many lines there are before the values, and what they say of count, step and unit, "" where they do not."""

    length: int
    count: str
    step: str
    unit: str


def looks_like(head: bytes) -> bool:
    """Return whether the first bytes are plain: a header as above or none, then numbers, not two to a line."""
    text = head.decode("latin-1")
    lines = text.split("\n")
    whole = lines[:-1] if len(lines) > 1 else lines  # the last may be cut
    header = _header(whole)
    if header is None or CONTROL.search(text) or peer_at2.looks_like(head):
        return False
    rows = [line.split() for line in whole[header.length :] if line.strip()]
    if not header.count and rows and len(rows[0]) == 2:
        return False
    return bool(rows) and all(VALUE.fullmatch(field) for field in rows[0])


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`, of the unit and step that it or the caller states.

    Raises RecordError, naming the file, for a unit or step that neither states, a first column that is time, samples
    that are not as many as the header says, and what is not a number.
    """
    lines = text_lines(path)
    header = _header(lines)
    if header is None:
        raise RecordError(f"{path}: the header has more than {LONGEST_HEADER} lines; take it off")
    body = lines[header.length :]
    while body and END.fullmatch(body[-1]):
        body = body[:-1]
    samples, uneven = uniform_numbers(body, first=header.length + 1, path=path)
    if header.count:
        check_count(header.count, samples.size, path=path)
    else:
        _refuse_tables(body, samples, path=path)
    for line, found in enumerate(map(AGAIN.match, lines[: header.length]), start=1):
        if found and header.count:
            again = (float(found[1]), number(found[2]))
            check_same(
                "the header's count", float(header.count), f"that of line {line}", again[0], slack=0.0, path=path
            )
            check_same(
                "the header's step", number(header.step), f"that of line {line}", again[1], slack=1e-6, path=path
            )
    unit = header.unit or overrides.unit
    if unit is None:
        raise RecordError(f"{path}: the file does not state the unit of its accelerations; {GIVE_UNIT}")
    dt = _step(header, overrides, path=path)
    reading = note("read-from" if header.unit else "read-from-given", format=Term("plain numbers"), unit=unit)
    return (
        make_record(
            path.stem,
            acceleration_factor(unit, line=1, path=path) * samples,
            dt,
            path=str(path),
            processing_history=(reading,),
            warnings=(uneven,),
        ),
    )


def _header(lines: Sequence[str]) -> Header | None:
    """Return the header; None where the numbers do not begin within it."""
    start = next((i for i, line in enumerate(lines[:LONGEST_HEADER]) if _is_row(line)), None)
    if start is None:
        return None
    text = lines[:start]
    unit = next((found[1] for line in text if (found := UNITS.search(line))), "")
    counted = COUNT_AND_STEP.fullmatch(lines[start]) if start == 1 else None
    if counted:
        return Header(start + 1, counted[1], counted[2], unit)
    steps = next((found for line in text if (found := STEPS.match(line))), None)
    if text and steps is None:
        return None
    return Header(start, steps[1] if steps else "", steps[2] if steps else "", unit)


def _is_row(line: str) -> bool:
    fields = line.split()
    return bool(fields) and all(VALUE.fullmatch(field) for field in fields)


def _step(header: Header, overrides: HeaderOverrides, *, path: Path) -> float:
    if header.step:
        return positive_number(header.step, name="step", line=header.length, path=path)
    if overrides.step is None:
        raise RecordError(f"{path}: the file does not state its time step; {GIVE_STEP}")
    return overrides.step


def _refuse_tables(body: Sequence[str], samples: FloatArray, *, path: Path) -> None:
    """Refuse what may be several records: three or four full columns, or a first one that rises as time does."""
    width = len(body[0].split())
    if width < 3 or samples.size % width or any(len(line.split()) not in (0, width) for line in body):
        return
    step = np.diff(samples.reshape(-1, width)[:, 0])
    if step.size > 1 and step[0] > 0.0 and np.ptp(step) <= 0.1 * step[0]:
        raise RecordError(
            f"{path}: the first of {width} columns rises evenly, as time does; keep it and one column of accelerations"
        )
    if width <= WIDEST_TABLE:
        raise RecordError(
            f"{path}: {width} numbers in every line may be {width} records side by side or one; keep one to a line"
        )
