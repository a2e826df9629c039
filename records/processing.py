"""Processing of records: each function returns a new record, whose processing history says what was done.

Baseline correction, filtering, resampling, trimming; two horizontal components turned to an azimuth, and to the median
and the largest over all directions; and all of these in a fixed order, as a conversion asks for them, which writes the
record as the text of a file.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil, cos, degrees, isfinite, pi, radians, sin
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq
from scipy.signal import butter, firwin, resample_poly, sosfiltfilt

from assess.messages.message import Message, Quantity, Value, note, whole_number
from records.errors import RecordError
from records.formats.csv import comments
from records.record import Record, is_vertical, make_record, scale, with_step
from records.response import integrate_squared, response_spectrum
from spectra.arrays import FloatArray
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of
from spectra.gravity import g

HIGHEST_DEGREE = 10  # of a baseline: higher ones follow the motion itself
HIGHEST_ORDER = 10  # of a filter
LONGEST = 20_000_000  # samples of what is resample
LARGEST_RATIO = 10_000  # numerator or denominator of the ratio of two steps
CUT_OFF, KAISER, REACH = 0.91, 8.6, 32  # of the anti-aliasing filter: -6 dB there, -90 dB from 1.0 of Nyquist on


def correct_baseline(record: Record, *, degree: int) -> Record:
    """Subtract the polynomial that fits the acceleration best (least squares).

    Parameters
    ----------
    record : accelerogram
    degree : of the polynomial, 0 to 10; 0 subtracts the mean

    Raises
    ------
    RecordError : the degree is outside 0 to 10
    """
    if not 0 <= degree <= HIGHEST_DEGREE:
        raise RecordError(f"{_where(record)}: baseline of degree {degree}; it must be from 0 to {HIGHEST_DEGREE}")
    x = np.linspace(-1.0, 1.0, record.npts)
    baseline = np.polynomial.Legendre.fit(x, record.acceleration, min(degree, record.npts - 1))(x)
    return _with_acceleration(
        record, record.acceleration - baseline, step=note("baseline-removed", degree=whole_number(degree))
    )


def butterworth(record: Record, *, low: float | None = None, high: float | None = None, order: int = 4) -> Record:
    """Filter the record between two corner frequencies, forwards and backwards, so that no phase shifts.

    At a corner the amplitude is halved. Zeros are put before and after, 1.5 order / low each, and removed again.

    Parameters
    ----------
    record : accelerogram
    low, high : corner frequencies [Hz]; None leaves that side open
    order : of the Butterworth filter, 1 to 10

    Raises
    ------
    RecordError : the corners are not 0 < low < high < half the sampling rate, or the order is not from 1 to 10

    Source: Converse & Brady (1992), USGS Open-File Report 92-296A; Boore (2005), BSSA 95, 745-750 (on the zeros).
    """
    nyquist = 0.5 / record.dt
    corners = [corner for corner in (low, high) if corner is not None]
    if not corners:
        return record
    if not (all(0.0 < corner < nyquist for corner in corners) and corners == sorted(set(corners))):
        raise RecordError(
            f"{_where(record)}: {_corners(low, high)}; a corner must lie above 0 and below half the rate, "
            f"{nyquist:.6g} Hz{', and the low one below the high one' if len(corners) == 2 else ''}"
        )
    if not 1 <= order <= HIGHEST_ORDER:
        raise RecordError(f"{_where(record)}: filter of order {order}; it must be from 1 to {HIGHEST_ORDER}")
    kind: Literal["bandpass", "highpass", "lowpass"] = (
        "bandpass" if len(corners) == 2 else "highpass" if high is None else "lowpass"
    )
    sections = butter(order, corners if len(corners) == 2 else corners[0], btype=kind, fs=1.0 / record.dt, output="sos")
    pad = _check_size(1.5 * order / (corners[0] * record.dt), record)
    padded = np.pad(record.acceleration, pad)
    acceleration = sosfiltfilt(sections, padded, padtype=None)[pad : pad + record.npts]
    return _with_acceleration(record, acceleration, step=_filter_step(low, high, order=order))


def resample(record: Record, *, dt: float) -> Record:
    """Resample the record, band-limited: what the new step cannot represent is filtered off first, without phase.

    Frequencies to 0.82 of half the lower rate pass, those above half of it are 90 dB down. The first sample keeps its
    place; the motion is taken as zero before and after the record.

    Parameters
    ----------
    record : accelerogram
    dt : new step [s]

    Raises
    ------
    RecordError : the step is not positive, or its ratio to the record's is not one of whole numbers to 10,000
    """
    if not (np.isfinite(dt) and dt > 0.0):
        raise RecordError(f"{_where(record)}: step {dt} s to resample to; it must be positive")
    ratio = Fraction(record.dt / dt).limit_denominator(LARGEST_RATIO)
    up, down = ratio.numerator, ratio.denominator
    if not 1 <= up <= LARGEST_RATIO or abs(record.dt / dt / float(ratio) - 1.0) > 1e-9:
        raise RecordError(
            f"{_where(record)}: step {dt:.9g} s beside the record's {record.dt:.9g} s; their ratio must be one of "
            f"whole numbers to {LARGEST_RATIO}"
        )
    _check_size(record.npts * up / down, record)
    if up == down:
        return record
    taps = firwin(2 * REACH * max(up, down) + 1, CUT_OFF / max(up, down), window=("kaiser", KAISER))
    acceleration = resample_poly(record.acceleration, up, down, window=taps)  # type: ignore[call-overload]  # stubs: no taps
    return _with_acceleration(
        record,
        acceleration,
        dt=dt,
        step=note("resampled", before=Quantity(record.dt, "time", 9), after=Quantity(dt, "time", 9)),
    )


def trim(record: Record, *, start: float = 0.0, end: float = 1.0) -> Record:
    """Trim the record to the instants when its Arias intensity reaches two shares of the whole.

    Parameters
    ----------
    record : accelerogram
    start, end : shares of the Arias intensity, 0 <= start < end <= 1 [-]

    Raises
    ------
    RecordError : for other shares
    """
    if not 0.0 <= start < end <= 1.0:
        raise RecordError(
            f"{_where(record)}: trimmed from {start} to {end} of its Arias intensity; 0 <= from < to <= 1"
        )
    build_up = integrate_squared(record)
    first = int(np.searchsorted(build_up, start * build_up[-1], side="right")) - 1
    last = int(np.searchsorted(build_up, end * build_up[-1], side="left"))
    first, last = max(min(first, record.npts - 2), 0), max(min(last, record.npts - 1), first + 1)
    step = note(
        "trimmed",
        start=Quantity(start),
        end=Quantity(end),
        first=Quantity(first * record.dt, "time", 6),
        last=Quantity(last * record.dt, "time", 6),
    )
    return _with_acceleration(record, record.acceleration[first : last + 1], step=step)


ANGLES: FloatArray = np.radians(np.arange(180.0))  # the half turn that is all, since the sign does not count
LEAST_ANGLE = pi / 18.0  # between two components that are solved for north and east
COINCIDE = 1e-6  # relative difference of steps that are one


def rotate_to_azimuth(first: Record, second: Record, *, azimuth: float) -> Record:
    """Return the motion of two horizontal components in one direction; both begin together, the longer is cut.

    Parameters
    ----------
    first, second : components with known azimuths, at least 10 degrees apart
    azimuth : direction, clockwise from north [rad]

    Raises
    ------
    RecordError : an azimuth is unknown, the steps differ, or the components are less than 10 degrees apart
    """
    if not isfinite(azimuth):
        raise RecordError(f'records "{first.id}" and "{second.id}": azimuth {azimuth} to turn to; it must be finite')
    a, b = _shared_time(first, second)
    azimuth_1, azimuth_2 = _azimuths(first, second)
    across = sin(azimuth_2 - azimuth_1)
    if abs(across) < sin(LEAST_ANGLE):
        raise RecordError(
            f'records "{first.id}" and "{second.id}": azimuths {degrees(azimuth_1):.4g} and '
            f"{degrees(azimuth_2):.4g} deg; two components at least 10 deg apart are needed"
        )
    acceleration = a * (sin(azimuth_2 - azimuth) / across) + b * (sin(azimuth - azimuth_1) / across)
    return _rotated_record(first, second, acceleration, name=f"{degrees(azimuth):.6g}", azimuth=azimuth % (2.0 * pi))


def rotd(first: Record, second: Record, *, percentile: float) -> Record:
    """Return the motion in a direction whose peak is a percentile of the peaks of all directions.

    50 is RotD50 and 100 RotD100 of the peak acceleration. The percentile is that of directions every degree over half a
    turn; the direction itself may lie between them.

    Parameters
    ----------
    first, second : perpendicular horizontal components
    percentile : 0 to 100

    Raises
    ------
    RecordError : the percentile is outside 0 to 100, the steps differ, or the components are not perpendicular

    Source: Boore (2010), BSSA 100, 1830-1835.
    """
    a, b = _perpendicular(first, second)
    angle = _angle(a, b, _check_percentile(percentile))
    acceleration = a * cos(angle) + b * sin(angle)
    return _rotated_record(
        first, second, acceleration, name=f"RotD{percentile:g}", azimuth=_azimuth_at(first, second, angle)
    )


def rotd_spectrum(
    first: Record, second: Record, period: ArrayLike, *, percentile: float, damping: float = 0.05
) -> FloatArray:
    """Return the `percentile` over all directions of the pseudo-acceleration [m/s2] at each `period` [s] (same shape).

    As `rotd`, period by period. Source: Boore (2010), BSSA 100, 1830-1835: RotD50 and RotD100.
    """
    a, b = _perpendicular(first, second)
    _check_percentile(percentile)
    spectra = [
        response_spectrum(make_record(first.id, a * cos(angle) + b * sin(angle), first.dt), period, damping=damping)
        for angle in ANGLES
    ]
    return np.asarray(np.percentile(np.array(spectra), percentile, axis=0), dtype=np.float64)


ENDINGS = (".csv", ".at2")


@dataclass(frozen=True)
class Processing:
    """The processing requested; None where a step is not.

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
    def rotates(self) -> bool:
        """Whether two components are rotated into one."""
        return self.azimuth is not None or self.rotd is not None


def choose_records(records: Sequence[Record], *, component: str | None, rotated: bool) -> tuple[Record, ...]:
    """Choose the one record to convert, or the two horizontal ones to rotate.

    Parameters
    ----------
    records : of the files
    component : name of the one to convert
    rotated : whether two are combined into one

    Raises
    ------
    RecordError : the choice is not unique; it lists the records there are
    """
    names = ", ".join(f'"{record.component}" of {record.id}' for record in records)
    if rotated:
        horizontal = tuple(record for record in records if not is_vertical(record.component))
        if len(horizontal) != 2 or component is not None:
            raise RecordError(f"two horizontal components are turned, without --component; the files hold {names}")
        return horizontal
    kept = tuple(
        record
        for record in records
        if component is None or _normalised_component(record.component) == _normalised_component(component)
    )
    if len(kept) != 1:
        raise RecordError(f"one record is converted, {len(kept)} fit; choose with --component: {names}")
    return kept


def process(records: tuple[Record, ...], processing: Processing) -> Record:
    """Process records into one: rotated, baseline corrected, filtered, trimmed, resampled and scaled, as requested.

    Parameters
    ----------
    records : one record, or the two horizontal ones that are rotated
    processing : the steps
    """
    record = records[0]
    if processing.azimuth is not None:
        record = rotate_to_azimuth(*records, azimuth=radians(processing.azimuth))
    if processing.rotd is not None:
        record = rotd(*records, percentile=processing.rotd)
    if processing.baseline is not None:
        record = correct_baseline(record, degree=processing.baseline)
    record = butterworth(record, low=processing.low_cut, high=processing.high_cut, order=processing.order)
    if processing.trim is not None:
        record = trim(record, start=processing.trim[0], end=processing.trim[1])
    if processing.step is not None:
        record = resample(record, dt=processing.step)
    return record if processing.scale is None else _scale_by_option(record, processing.scale)


def record_text(record: Record, path: Path, *, unit: str | None, stamp: str = "") -> str:
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
    a = record.acceleration / factor_of(unit, known=ACCELERATION_UNITS)
    printed = repr if unit == "m/s2" else "{:.15g}".format  # what was divided has no more digits
    rows = (f"{i * record.dt:.12g},{printed(value)}\n" for i, value in enumerate(a.tolist()))
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
        _on_one_line(_at2_title(record)),
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {record.npts:6d}, DT= {record.dt:.10g} SEC",
    ]
    return "\n".join([*header, *lines]).encode("ascii", "replace").decode("ascii") + "\n"


def _filter_step(low: float | None, high: float | None, *, order: int) -> Message:
    """Return the step of a filter; low, high : its corners [Hz], one at least."""
    given = {"low": low, "high": high}
    corners = {name: Quantity(corner, "frequency", 6) for name, corner in given.items() if corner is not None}
    key = "band-filtered" if len(corners) == 2 else "low-passed" if low is None else "high-passed"
    return note(key, order=whole_number(order), **corners)


def _with_acceleration(record: Record, acceleration: FloatArray, *, step: Message, dt: float | None = None) -> Record:
    """Replace the acceleration, checked as when read, and add `step` to the processing history."""
    checked = make_record(record.id, acceleration, record.dt if dt is None else dt, path=record.path)
    return with_step(replace(record, acceleration=checked.acceleration, dt=checked.dt), step)


def _corners(low: float | None, high: float | None) -> str:
    """Return those that are given: "low corner 0.1 Hz, high corner 60 Hz"."""
    named = {"low": low, "high": high}
    return ", ".join(f"{name} corner {corner:.6g} Hz" for name, corner in named.items() if corner is not None)


def _check_size(size: float, record: Record) -> int:
    """Return `size` samples, rounded up; refuse too many."""
    if not size <= LONGEST:
        raise RecordError(f"{_where(record)}: {size:.3g} samples would be needed; at most {LONGEST:.0e} are allowed")
    return ceil(size)


def _where(record: Record) -> str:
    return f'record "{record.id}"'


def _angle(a: FloatArray, b: FloatArray, percentile: float) -> float:
    """Return the angle [rad] from `a` towards `b` [n] at which the peak is the `percentile` of those at ANGLES.

    The peak is a continuous function of the angle: where it is on either side of the percentile a degree apart, it is
    the percentile between. Of several such angles the one beside which a peak is nearest.
    """

    def beyond(angle: float) -> float:
        return float(np.max(np.abs(a * cos(angle) + b * sin(angle)))) - peak

    peak = 0.0
    peaks = np.array([beyond(angle) for angle in ANGLES])
    peak = float(np.percentile(peaks, percentile))
    off = np.abs(np.append(peaks, peaks[0]) - peak)
    if not off.min() > 0.0:
        return float(ANGLES[int(np.argmin(off[:-1]))])
    above = np.append(peaks, peaks[0]) > peak
    between = np.flatnonzero(above[1:] != above[:-1])
    at = between[np.argmin(np.minimum(off[between], off[between + 1]))]
    return float(brentq(beyond, ANGLES[at], ANGLES[at] + pi / 180.0, xtol=1e-14))


def _shared_time(first: Record, second: Record) -> tuple[FloatArray, FloatArray]:
    """Return both accelerations over the time that they share, of two components of one recording."""
    for what, name, other in (("station", first.station, second.station), ("event", first.event, second.event)):
        if name and other and name != other:
            raise RecordError(
                f'records "{first.id}" and "{second.id}": {what} {name!r} and {other!r}; two components of one '
                "recording are turned together"
            )
    if abs(first.dt / second.dt - 1.0) > COINCIDE:
        raise RecordError(
            f'records "{first.id}" and "{second.id}": steps of {first.dt:.6g} and {second.dt:.6g} s; '
            "resample one to the other's"
        )
    shared = min(first.npts, second.npts)
    return first.acceleration[:shared], second.acceleration[:shared]


def _perpendicular(first: Record, second: Record) -> tuple[FloatArray, FloatArray]:
    """Return both accelerations; refused where the azimuths are known and not a right angle, to 5 degrees, apart."""
    if first.azimuth is not None and second.azimuth is not None:
        apart = first.azimuth - second.azimuth
        if abs(cos(apart)) > sin(pi / 36.0):
            raise RecordError(
                f'records "{first.id}" and "{second.id}": azimuths {degrees(first.azimuth):.4g} and '
                f"{degrees(second.azimuth):.4g} deg; the two components must be perpendicular"
            )
    return _shared_time(first, second)


def _azimuths(first: Record, second: Record) -> tuple[float, float]:
    """Return both azimuths [rad]; refuse a component whose azimuth is not known."""
    for record in (first, second):
        if record.azimuth is None:
            raise RecordError(
                f'record "{record.id}": the azimuth of its component "{record.component}" is not known; '
                "turn by RotD instead, which does not need it"
            )
    return float(first.azimuth or 0.0), float(second.azimuth or 0.0)


def _azimuth_at(first: Record, second: Record, angle: float) -> float | None:
    """Return the azimuth [rad] at `angle` from the first component towards the second."""
    if first.azimuth is None or second.azimuth is None:
        return None
    clockwise = sin(second.azimuth - first.azimuth) > 0.0
    return (first.azimuth + (angle if clockwise else -angle)) % (2.0 * pi)


def _check_percentile(percentile: float) -> float:
    """Return the percentile, from 0 to 100."""
    if not 0.0 <= percentile <= 100.0:
        raise RecordError(f"percentile {percentile} over the directions; it must be from 0 to 100")
    return percentile


def _rotated_record(
    first: Record, second: Record, acceleration: FloatArray, *, name: str, azimuth: float | None
) -> Record:
    """Return the record made of two components, under the names of the first."""
    values: dict[str, Value] = {"component": second.component, "record": second.id, "name": name}
    step = note("turned", **values)
    if azimuth is not None:
        step = note("turned-to", azimuth=Quantity(azimuth, "angle", 6), **values)
    checked = make_record(f"{first.id} {name}", acceleration, first.dt, path=first.path)
    rotated = replace(first, id=checked.id, acceleration=checked.acceleration, component=name, azimuth=azimuth)
    return with_step(rotated, step)


def _normalised_component(component: str) -> str:
    """Return a component's name in lower case with single spaces."""
    return " ".join(component.casefold().split())


def _scale_by_option(record: Record, factor: float) -> Record:
    if not isfinite(factor) or factor == 0.0:
        raise RecordError(f"--scale {factor}: it must be a finite number, not zero")
    return scale(record, factor)


def _at2_title(record: Record) -> str:
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
