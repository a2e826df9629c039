"""Headers of record files: what the caller gives in their place, their dates, and whether the samples below agree.

Contradictions of step, count, unit or direction are refused, since nothing shows which of the two is right. What is
merely odd is a warning to the engineer: so is a motion that goes on far beyond the corners of its source's filter,
where nothing is left of it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from math import isfinite
from pathlib import Path

import numpy as np

from assess.messages.message import Message, Quantity, Term, warning
from records.errors import RecordError
from spectra.arrays import FloatArray, is_number
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

GIVE_UNIT = 'give unit (--unit g on the command line, unit = "g" under [records] of a project)'
GIVE_STEP = "give step, in seconds (--step 0.01 on the command line, step = 0.01 under [records] of a project)"


@dataclass(frozen=True)
class HeaderOverrides:
    """Values for what a header leaves out; where the file states a value itself, the file's value is used.

    unit : of the accelerations (g, m/s2, cm/s2, gal, mm/s2)
    step : time step [s]
    response : file of the instrument's response (StationXML, dataless SEED, RESP, SAC poles and zeros)
    """

    unit: str | None = None
    step: float | None = None
    response: Path | None = None

    @property
    def key(self) -> str:
        """Text that a catalogue keeps with each file, to read it again when another value is given; never reworded."""
        return f"Stated(unit={self.unit!r}, step={self.step!r}, response={self.response!r})"

    def over(self, earlier: HeaderOverrides) -> HeaderOverrides:
        """Return these values, with those of `earlier` where one is not given here."""
        return HeaderOverrides(
            earlier.unit if self.unit is None else self.unit,
            earlier.step if self.step is None else self.step,
            earlier.response if self.response is None else self.response.absolute(),
        )


NO_OVERRIDES = HeaderOverrides()


def check_overrides(overrides: HeaderOverrides) -> None:
    """Raise RecordError for an unknown unit, a step that is not positive, or a response file that does not exist."""
    if overrides.unit is not None:
        if not isinstance(overrides.unit, str):
            raise RecordError(f'unit = {overrides.unit!r}, for files that state none; write it as text, like "g"')
        try:
            factor_of(overrides.unit, known=ACCELERATION_UNITS)
        except ColumnError as error:
            raise RecordError(f"for files that state none, {error}") from None
    if overrides.step is not None and not (
        is_number(overrides.step) and isfinite(overrides.step) and overrides.step > 0.0
    ):
        raise RecordError(f"for files that state none, time step {overrides.step} s; it must be positive")
    if overrides.response is not None and not overrides.response.is_file():
        raise RecordError(f"{overrides.response}: no such file; give the StationXML of the instrument")


SAME_PEAK = 5e-4  # relative; a peak is printed with four digits and more
OTHER_PEAK = 0.02  # relative; a wrong unit is 2 % off or more
SAME_STEP = 0.1  # relative, of a step that is fitted to accelerations and velocities
ALIKE = 0.9  # correlation squared, from which the step so fitted means something
SAME_GAIN = 0.35  # of the largest acceleration times the step, in velocity over BLOCK steps
BLOCK = 16
REMEDY = "one of them is damaged: get the file again, or correct it"


def check_count(stated: str, held: int, *, path: Path, name: str = "NPTS") -> None:
    """Refuse samples that are not as many as the header, as printed, says; however long a number that is."""
    printed = stated.lstrip("0") or "0"
    if printed == str(held):
        return
    short = (len(printed), printed) > (len(str(held)), str(held))
    remedy = "the file is cut short" if short else "the header or the data are wrong"
    raise RecordError(f"{path}: {name} says {stated[:20]} samples, the file holds {held}; {remedy}")


def check_peak(stated: float | None, samples: FloatArray, *, unit: str, digits: float, path: Path) -> Message | None:
    """Refuse samples whose peak is another than `stated` in the header by 2 %; return a warning above 0.05 %.

    Both are in `unit`, and what is printed is rounded to `digits`. Nothing is known where the header states none or
    zero.
    """
    if not stated or not samples.size:
        return None
    found = float(np.max(np.abs(samples)))
    off = abs(found - abs(stated))
    if not off <= OTHER_PEAK * abs(stated) + digits:
        raise RecordError(
            f"{path}: the header states a peak of {abs(stated):.6g} {unit}, the samples have {found:.6g}; "
            "the unit or the data are damaged, get the file again"
        )
    if off <= SAME_PEAK * abs(stated) + digits:
        return None
    return describe_disagreement("stated peak", abs(stated), "largest sample", found)


def check_same(
    name: str, value: float | None, other_name: str, other: float | None, *, slack: float, path: Path
) -> None:
    """Refuse two values of one thing, where both are known, that differ by more than `slack`."""
    if value is not None and other is not None and not abs(value - other) <= slack:
        raise RecordError(f"{path}: {name} is {value:.10g}, {other_name} {other:.10g}; {REMEDY}")


def warn_of_difference(
    name: str, value: float | None, other_name: str, other: float | None, *, slack: float
) -> Message | None:
    """Return a warning about two values of one thing, where both are known, that differ by more than `slack`."""
    known = value is not None and other is not None
    return describe_disagreement(name, value, other_name, other) if known and not abs(value - other) <= slack else None  # type: ignore[operator]


def describe_disagreement(name: str, value: object, other_name: str, other: object) -> Message:
    """Word a warning about two values of one thing; the names are fixed terms."""
    one, two = (f"{each:.10g}" if isinstance(each, float) else str(each)[:40] for each in (value, other))
    names = {"name": Term(name), "other_name": Term(other_name)}
    return warning("header-disagrees", value=one, other=two, **names)


def check_duration(name: str, stated: float | None, *, size: int, dt: float, slack: float, path: Path) -> None:
    """Refuse a duration [s] that `size` samples at `dt` [s] do not last, to the last of them or a step beyond it."""
    if not stated:
        return
    if not (size - 1) * dt - slack <= stated <= size * dt + slack:
        raise RecordError(
            f"{path}: {size} samples at {dt:.6g} s last {size * dt:.6g} s, {name} is {stated:.6g} s; the step or the "
            "duration is damaged: get the file again, or correct it"
        )


def check_time_of_peak(stated: float | None, samples: FloatArray, dt: float, *, slack: float, path: Path) -> None:
    """Refuse a time [s] of the peak at which, to a step and `slack`, no sample comes near the largest."""
    if stated is None or stated <= 0.0 or not samples.size:
        return
    size = np.abs(samples)
    at = dt * np.flatnonzero(size >= (1.0 - SAME_PEAK) * size.max())
    if not np.min(np.abs(at - stated)) <= 1.01 * dt + slack:
        raise RecordError(
            f"{path}: the header has the peak at {stated:.6g} s, the samples at a step of {dt:.6g} s at "
            f"{at[np.argmin(np.abs(at - stated))]:.6g} s; the step or the data are damaged: get the file again, or "
            "correct it"
        )


def check_integral(
    velocity: FloatArray, acceleration: FloatArray, dt: float, *, path: Path, name: str
) -> Message | None:
    """Refuse accelerations whose step by the velocities beside them is not `dt` [s]; return a warning.

    Both are in one unit of length. Gains of velocity over BLOCK steps are fitted by the trapezoidal rule. In files of
    GeoNet and CSMIP, which have other rules, the step so found is up to 3.4 % high, and one gain is off by at most 0.22
    peaks times the step.
    """
    if velocity.size != acceleration.size or velocity.size <= 4 * BLOCK:
        return None
    total = np.concatenate(([0.0], np.cumsum(0.5 * (acceleration[1:] + acceleration[:-1]))))
    gained, summed = velocity[BLOCK:] - velocity[:-BLOCK], total[BLOCK:] - total[:-BLOCK]
    power, gains = float(summed @ summed), float(gained @ gained)
    if not power > 0.0 or not gains > 0.0:
        return None
    step = float(gained @ summed) / power
    alike = float(gained @ summed) ** 2 / (power * gains)
    if alike > ALIKE and abs(step - dt) > SAME_STEP * dt:
        raise RecordError(
            f"{path}: {name}: by the velocities below the accelerations the step is {step:.4g} s, not {dt:.6g} s; the "
            "step, the unit or the data are damaged: get the file again, or correct it"
        )
    off = float(np.max(np.abs(gained / dt - summed))) / float(np.max(np.abs(acceleration)))
    return warning("velocities-disagree", name=name) if off > SAME_GAIN else None


ABOVE, BELOW = 1.3, 0.6  # times the corners, beyond which hardly anything is left
HIGH_SHARE = 5e-3  # of the power of accelerations; 7e-4 at most in fifteen filtered records of ESM, ITACA and PEER
LOW_SHARE = 0.25  # of the power of displacements; 0.06 at most in the same


def filter_warning(samples: FloatArray, dt: float, *, low: float | None, high: float | None) -> Message | None:
    """Return a warning where a motion [n] at a step [s] goes on beyond the corners [Hz] of its filter.

    With another step a motion has other frequencies. None is a corner that is not known.
    """
    odd = nyquist_warning(high, dt)
    if odd or not (low or high) or samples.size < 2:
        return odd
    size = 2 * samples.size  # with zeros behind it
    f, power = np.fft.rfftfreq(size, dt), np.abs(np.fft.rfft(samples - np.mean(samples), size)) ** 2
    if high and float(np.sum(power[f > ABOVE * high])) > HIGH_SHARE * float(np.sum(power)):
        return warning("filter-above", corner=Quantity(high, "frequency", 6), step=Quantity(dt, "time", 6))
    moved = power[1:] / f[1:] ** 4
    if low and float(np.sum(moved[f[1:] < BELOW * low])) > LOW_SHARE * float(np.sum(moved)):
        return warning("filter-below", corner=Quantity(low, "frequency", 6), step=Quantity(dt, "time", 6))
    return None


def nyquist_warning(corner: float | None, dt: float) -> Message | None:
    """Return a warning about a filter's upper corner [Hz] that a step [s] cannot hold."""
    if corner is None or corner <= 1.02 * 0.5 / dt:
        return None
    corners = {"corner": Quantity(corner, "frequency", 6), "most": Quantity(0.5 / dt, "frequency", 6)}
    return warning("filter-beyond-step", step=Quantity(dt, "time", 6), **corners)


DAY_FIRST = re.compile(r"\s*\d{1,2}/\d{1,2}/\d{4}\b")
NUMBERS = re.compile(r"\d+(?:\.\d+)?")


def iso_time(year: str, month: str, day: str, *clock: str, ahead: float = 0.0) -> str:
    """Return a date as ISO 8601 from its parts as printed, like "2018-01-24T10:51:00Z"; the date alone without a clock.

    ahead : hours before UTC. "" for what is no date.
    """
    try:
        at = datetime(int(year), int(month), int(day), tzinfo=UTC)
        hours, minutes, seconds = (float(part) for part in (*clock, "0", "0", "0")[:3])
        at += timedelta(hours=hours - ahead, minutes=minutes, seconds=seconds)
    except (ValueError, OverflowError):
        return ""
    if not clock:
        return at.strftime("%Y-%m-%d")
    return at.strftime("%Y-%m-%dT%H:%M:%S") + f".{at.microsecond // 1000:03d}".rstrip("0").rstrip(".") + "Z"


def iso_time_of_text(text: str, *, ahead: float = 0.0) -> str:
    """Return the same from text in the order year, month, day, hour, minute, second, whatever separates the numbers.

    "20/07/2017 22:30:59", with the year in third place, has the day first.
    """
    compact = re.fullmatch(r"(\d{4})(\d\d)(\d\d)[ _T]*(?:(\d\d)(\d\d)(\d\d(?:\.\d+)?))?", text.strip())
    parts = [part for part in compact.groups() if part] if compact else NUMBERS.findall(text)
    if DAY_FIRST.match(text):
        parts[:3] = parts[2::-1]
    return iso_time(*parts[:6], ahead=ahead) if len(parts) >= 3 else ""
