"""Processing of records: each function returns a new record, whose processing history says what was done."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import ceil
from typing import Literal

import numpy as np
from scipy.signal import butter, firwin, resample_poly, sosfiltfilt

from assess.messages.message import Message, Quantity, note, whole_number
from records.errors import RecordError
from records.integration import integrate_squared
from records.record import Record, make_record, with_step
from spectra.arrays import FloatArray

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
    time = np.linspace(-1.0, 1.0, record.npts)
    baseline = np.polynomial.Legendre.fit(time, record.acceleration, min(degree, record.npts - 1))(time)
    return _with(record, record.acceleration - baseline, step=note("baseline-removed", degree=whole_number(degree)))


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
    pad = _fitting(1.5 * order / (corners[0] * record.dt), record)
    padded = np.pad(record.acceleration, pad)
    filtered = sosfiltfilt(sections, padded, padtype=None)[pad : pad + record.npts]
    return _with(record, filtered, step=_filtering(low, high, order=order))


def _filtering(low: float | None, high: float | None, *, order: int) -> Message:
    """Return the step of a filter; low, high : its corners [Hz], one at least."""
    given = {"low": low, "high": high}
    corners = {name: Quantity(corner, "frequency", 6) for name, corner in given.items() if corner is not None}
    key = "band-filtered" if len(corners) == 2 else "low-passed" if low is None else "high-passed"
    return note(key, order=whole_number(order), **corners)


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
    _fitting(record.npts * up / down, record)
    if up == down:
        return record
    taps = firwin(2 * REACH * max(up, down) + 1, CUT_OFF / max(up, down), window=("kaiser", KAISER))
    samples = resample_poly(record.acceleration, up, down, window=taps)  # type: ignore[call-overload]  # stubs: no taps
    return _with(
        record,
        samples,
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
    return _with(record, record.acceleration[first : last + 1], step=step)


def _with(record: Record, samples: FloatArray, *, step: Message, dt: float | None = None) -> Record:
    """Replace the samples, checked as when read, and add `step` to the processing history."""
    checked = make_record(record.id, samples, record.dt if dt is None else dt, path=record.path)
    return with_step(replace(record, acceleration=checked.acceleration, dt=checked.dt), step)


def _corners(low: float | None, high: float | None) -> str:
    """Return those that are given: "low corner 0.1 Hz, high corner 60 Hz"."""
    named = {"low": low, "high": high}
    return ", ".join(f"{name} corner {corner:.6g} Hz" for name, corner in named.items() if corner is not None)


def _fitting(size: float, record: Record) -> int:
    """Return `size` samples, rounded up; refuse too many."""
    if not size <= LONGEST:
        raise RecordError(f"{_where(record)}: {size:.3g} samples would be needed; at most {LONGEST:.0e} are allowed")
    return ceil(size)


def _where(record: Record) -> str:
    return f'record "{record.id}"'
