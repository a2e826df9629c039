"""A record as the text of a file, which the readers of this package read again."""

from __future__ import annotations

from scipy.constants import g

from records.formats.comments import comments
from records.record import Record
from spectra.columns import ACCELERATION_UNITS, factor_of

PER_LINE = 5
LONGEST_LINE = 200


def csv_text(record: Record, *, unit: str = "m/s2", stamp: str = "") -> str:
    """Return times [s] and accelerations at full precision as CSV, below comments that the reader of CSV understands.

    Parameters
    ----------
    record : accelerogram
    unit : of the accelerations
    stamp : of what the record was made from, a comment of its own

    Raises
    ------
    ColumnError : the unit is unknown
    """
    samples = record.acceleration / factor_of(unit, known=ACCELERATION_UNITS)
    printed = repr if unit == "m/s2" else "{:.15g}".format  # what was divided has no more digits
    rows = (f"{i * record.dt:.12g},{printed(a)}\n" for i, a in enumerate(samples.tolist()))
    stamped = f"# stamp: {stamp}\n" if stamp else ""
    return "".join(comments(record)) + stamped + f"time [s],acceleration [{unit}]\n" + "".join(rows)


def at2_text(record: Record, *, stamp: str = "") -> str:
    """Return the record in PEER AT2: four lines of header, then accelerations in g, five to a line, of eight digits.

    Parameters
    ----------
    record : accelerogram
    stamp : of what the record was made from, at the head of the first line
    """
    values = [f"{a / g:15.7E}" for a in record.acceleration.tolist()]
    lines = ["".join(values[i : i + PER_LINE]) for i in range(0, len(values), PER_LINE)]
    header = [
        _on_one_line("; ".join([*([f"stamp {stamp}"] if stamp else []), *map(str, record.processing_history)])),
        _on_one_line(_title(record)),
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {record.npts:6d}, DT= {record.dt:.10g} SEC",
    ]
    return "\n".join([*header, *lines]).encode("ascii", "replace").decode("ascii") + "\n"


def _title(record: Record) -> str:
    """Return `Event, m/d/yyyy, Station, Component`; commas separate the fields where there is no date."""
    year, month, day = (*record.earthquake.time[:10].split("-"), "", "", "")[:3]
    if year.isdecimal() and month.isdecimal() and day.isdecimal():
        return f"{record.event}, {int(month)}/{int(day)}/{year}, {record.station}, {_without_commas(record.component)}"
    return f"{_without_commas(record.event)}, {record.station}, {_without_commas(record.component)}"


def _without_commas(text: str) -> str:
    return " ".join(text.replace(",", " ").split())


def _on_one_line(text: str) -> str:
    """Return `text` without line breaks and control characters, cut."""
    return "".join(c if c.isprintable() else " " for c in text)[:LONGEST_LINE]
