"""Record files: which format a file has, and its records."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from records.errors import RecordError
from records.formats import FORMATS
from records.formats.stated import Stated, check
from records.record import Record

FINEST, COARSEST = 1e-5, 1.0  # s, of the steps of instruments and shaking tables
HEAD = 8192  # bytes that show a format


def read(
    path: Path, *, unit: str | None = None, step: float | None = None, response: Path | None = None
) -> tuple[Record, ...]:
    """Every record of the file at `path`, with accelerations in m/s2.

    `unit` (g, m/s2, cm/s2, gal, mm/s2) of the accelerations, `step` of time [s] and `response` of the instrument (for
    MiniSEED and SAC: a StationXML file) are used only where the file states none, but refused in any case where
    they cannot be. Raises RecordError, naming the file, where it cannot be opened, has no format known or more than
    one, holds what is not a record, or no motion at all.
    """
    stated = Stated(unit, step, response)
    check(stated)
    if path.is_dir():
        raise RecordError(f"{path}: is a folder; give the files in it, like {path / '*'}")
    try:
        with path.open("rb") as file:
            head = file.read(HEAD)
        with np.errstate(over="ignore", invalid="ignore"):  # what is not finite afterwards is refused by its sample
            records = FORMATS[_format(head, path=path)].read(path, stated)
    except OSError as error:
        raise RecordError(f"{path}: the file cannot be read: {error.strerror}") from None
    for record in records:
        if not FINEST <= record.dt <= COARSEST:
            raise RecordError(
                f"{path}: a time step of {record.dt:.6g} s; records have {FINEST:g} to {COARSEST:g} s, check its unit"
            )
        if np.ptp(record.acceleration) == 0.0:
            raise RecordError(
                f"{path}: every acceleration is {record.acceleration[0]:.6g} m/s2; there is no motion in the record"
            )
    return records


def _format(head: bytes, *, path: Path) -> str:
    """The name of the one format that `head`, the start of the file, is of."""
    if not head.strip():
        raise RecordError(f"{path}: the file is empty")
    names = [name for name, known in FORMATS.items() if known.looks_like(head)]
    if not names:
        raise RecordError(
            f"{path}: not a record format known here ({', '.join(FORMATS)}); convert the file to one of them"
        )
    if len(names) > 1:
        raise RecordError(f"{path}: the file could be {' or '.join(names)}; convert it so that only one fits")
    return names[0]
