"""What `assess records convert` does: one record chosen, processed in a fixed order, and written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite, radians
from pathlib import Path

from assess.errors import AssessError
from assess.outputs.single import write_file
from records.orientation import is_vertical
from records.processing import butterworth, correct_baseline, resample, trim
from records.record import Record, scale
from records.rotation import rotate_to_azimuth, rotd
from records.writing import at2_text, csv_text
from spectra.columns import ColumnError

ENDINGS = (".csv", ".at2")


@dataclass(frozen=True)
class Processing:
    """What is asked for, None what is not.

    azimuth [deg], rotd : percentile; baseline : degree; low_cut, high_cut [Hz], order : of the filter
    trim : shares of Arias intensity; step [s] to resample to; scale : factor
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
        """Whether two components become one."""
        return self.azimuth is not None or self.rotd is not None


def chosen(found: Sequence[Record], *, component: str | None, turned: bool) -> tuple[Record, ...]:
    """The one record to convert, or the two horizontal ones that are turned; AssessError lists those there are."""
    names = ", ".join(f'"{record.component}" of {record.id}' for record in found)
    if turned:
        level = tuple(record for record in found if not is_vertical(record.component))
        if len(level) != 2 or component is not None:
            raise AssessError(f"two horizontal components are turned, without --component; the files hold {names}")
        return level
    kept = tuple(record for record in found if component is None or _plain(record.component) == _plain(component))
    if len(kept) != 1:
        raise AssessError(f"one record is converted, {len(kept)} fit; choose with --component: {names}")
    return kept


def _plain(component: str) -> str:
    """A component's name, capitals and blanks aside."""
    return " ".join(component.casefold().split())


def processed(records: tuple[Record, ...], wanted: Processing) -> Record:
    """One record: turned, baseline corrected, filtered, trim, resampled and scaled, as far as asked for."""
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
        raise AssessError(f"--scale {factor}: it must be a finite number, not zero")
    return scale(record, factor)


def text_of(record: Record, path: Path, *, unit: str | None, stamp: str = "") -> str:
    """The record in the format that the ending of `path` names; CSV in `unit`, m/s2 if None. AT2 is always in g."""
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        raise AssessError(f"{path}: ends in {path.suffix or 'nothing'}; choose one of {', '.join(ENDINGS)}")
    if ending == ".at2":
        if unit not in (None, "g"):
            raise AssessError(f"--to-unit {unit}: PEER AT2 is in g by its format; leave --to-unit out, or write .csv")
        return at2_text(record, stamp=stamp)
    try:
        return csv_text(record, unit=unit or "m/s2", stamp=stamp)
    except ColumnError as error:
        raise AssessError(f"--to-unit: {error}") from None


def write(text: str, path: Path, *, inputs: Sequence[Path]) -> None:
    """The text in the file at `path`, whole or not at all."""
    if path.is_dir() or any(path.exists() and path.samefile(each) for each in inputs):
        raise AssessError(f"{path}: is a folder or a file that is read; give another name with -o")
    with write_file(path, command="assess records convert") as made:
        made.write_text(text, encoding="utf-8", newline="\n")
