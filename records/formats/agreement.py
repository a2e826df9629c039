"""Consistency of what a file says twice: the header with itself and with the samples below it.

Contradictions of step, count, unit or direction are refused, since nothing shows which of the two is right. What is
merely odd is a warning to the engineer.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from assess.messages.message import Message, Term, warning
from records.errors import RecordError
from spectra.arrays import FloatArray

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


def disagreement(
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
