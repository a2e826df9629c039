"""Conversion of records: one record chosen, processed in a fixed order, and written as text."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite, radians
from pathlib import Path

from records.errors import RecordError
from records.orientation import is_vertical
from records.processing import butterworth, correct_baseline, resample, trim
from records.record import Record, scale
from records.rotation import rotate_to_azimuth, rotd
from records.writing import at2_text, csv_text
from spectra.columns import ColumnError

ENDINGS = (".csv", ".at2")


@dataclass(frozen=True)
class Processing:
    """The processing requested; None where a step is not.

    Attributes
    ----------
    azimuth : to which two horizontal components are rotated [deg]
    rotd : percentile of peaks to which they are rotated
    baseline : degree of the polynomial removed
    low_cut, high_cut : corners of the filter [Hz]
    order : of the filter
    trim : shares of Arias intensity that remain
    step : to resample to [s]
    scale : factor
    """

    azimuth: float | None
    rotd: float | None
    baseline: int | None
    low_cut: float | None
    high_cut: float | None
    order: int
    trim: tuple[float, float] | None
    step: float | None
    scale: float | None

    @property
    def turns(self) -> bool:
        """Whether two components are rotated into one."""
        return self.azimuth is not None or self.rotd is not None


def choose_records(found: Sequence[Record], *, component: str | None, turned: bool) -> tuple[Record, ...]:
    """Choose the one record to convert, or the two horizontal ones to rotate.

    Parameters
    ----------
    found : the records of the files
    component : name of the one to convert
    turned : whether two are rotated into one

    Raises
    ------
    RecordError : the choice is not unique; it lists the records there are
    """
    names = ", ".join(f'"{record.component}" of {record.id}' for record in found)
    if turned:
        level = tuple(record for record in found if not is_vertical(record.component))
        if len(level) != 2 or component is not None:
            raise RecordError(f"two horizontal components are turned, without --component; the files hold {names}")
        return level
    kept = tuple(record for record in found if component is None or _plain(record.component) == _plain(component))
    if len(kept) != 1:
        raise RecordError(f"one record is converted, {len(kept)} fit; choose with --component: {names}")
    return kept


def _plain(component: str) -> str:
    """Return a component's name in lower case with single spaces."""
    return " ".join(component.casefold().split())


def process(records: tuple[Record, ...], wanted: Processing) -> Record:
    """Process records into one: rotated, baseline corrected, filtered, trimmed, resampled and scaled, as requested.

    Parameters
    ----------
    records : one record, or the two horizontal ones that are rotated
    wanted : the steps
    """
    record = records[0]
    if wanted.azimuth is not None:
        record = rotate_to_azimuth(*records, azimuth=radians(wanted.azimuth))
    if wanted.rotd is not None:
        record = rotd(*records, percentile=wanted.rotd)
    if wanted.baseline is not None:
        record = correct_baseline(record, degree=wanted.baseline)
    record = butterworth(record, low=wanted.low_cut, high=wanted.high_cut, order=wanted.order)
    if wanted.trim is not None:
        record = trim(record, start=wanted.trim[0], end=wanted.trim[1])
    if wanted.step is not None:
        record = resample(record, dt=wanted.step)
    return record if wanted.scale is None else _scaled(record, wanted.scale)


def _scaled(record: Record, factor: float) -> Record:
    if not isfinite(factor) or factor == 0.0:
        raise RecordError(f"--scale {factor}: it must be a finite number, not zero")
    return scale(record, factor)


def text_of(record: Record, path: Path, *, unit: str | None, stamp: str = "") -> str:
    """Write a record in the format that a file extension names.

    Parameters
    ----------
    record : as processed
    path : ends in .csv or .at2
    unit : of the accelerations of a CSV, m/s2 if None; AT2 is always in g
    stamp : written into the header

    Raises
    ------
    RecordError : another extension, or a unit that the format does not have
    """
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        raise RecordError(f"{path}: ends in {path.suffix or 'nothing'}; choose one of {', '.join(ENDINGS)}")
    if ending == ".at2":
        if unit not in (None, "g"):
            raise RecordError(f"--to-unit {unit}: PEER AT2 is in g by its format; leave --to-unit out, or write .csv")
        return at2_text(record, stamp=stamp)
    try:
        return csv_text(record, unit=unit or "m/s2", stamp=stamp)
    except ColumnError as error:
        raise RecordError(f"--to-unit: {error}") from None
