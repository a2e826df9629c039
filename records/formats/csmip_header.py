"""What the header of a CSMIP channel says in words, again in numbers, and in the samples below.

Of volume 2 the text has count, step and the time of the peak; the reals, eight to a line of ten characters each, repeat
them, and an integer the azimuth. Volume 1 has count, rate and length. Source: Shakal & Huang (1985), OSMS 85-03.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from assess.messages.message import Message
from records.errors import RecordError
from records.formats.agreement import check_duration, check_same, check_time_of_peak
from records.formats.corners import nyquist_warning
from records.formats.samples import number
from spectra.arrays import FloatArray

TEXT = {True: 13, False: 25}  # lines, of volume 1 and of volume 2
INTEGERS, REALS = (7, 16, 5), (7, 8, 10)  # lines, numbers in a line and characters of a number; volume 2 has more reals
AZIMUTH = 26  # index of the integer; codes above 360 stand for other directions
STEP, TIME, PEAK = 60, 64, 65  # indices of reals of volume 2

LENGTH = re.compile(r"Record\s+length\s*=\s*([\d.]+)\s*sec", re.IGNORECASE)
COUNT = (
    re.compile(r"No\. of Points\s*=\s*(\d+)", re.IGNORECASE),
    re.compile(r"^\s*(\d+)\s+points of instrument", re.IGNORECASE | re.MULTILINE),
)
RATE = re.compile(r"\bat\s+([\d.]+)\s*samples/sec", re.IGNORECASE)
INTERVAL = re.compile(r"equally-spaced intervals of\s+([\d.]+)\s+sec", re.IGNORECASE)
WHEN_1 = re.compile(r"\bMax\s*=\s*\S+\s*g\b\s*,\s*at\s+([\d.]+)\s*sec", re.IGNORECASE)
WHEN_2 = re.compile(r"Peak acceleration\s*=\s*\S+\s+\S+\s+at\s+([\d.]+)\s*sec", re.IGNORECASE)
BAND = re.compile(r"filtered with .*?\band\s+([\d.]+)(?:\s*-\s*([\d.]+))?\s*cyc/sec", re.IGNORECASE)
CHANNEL = re.compile(r"\bChan\s+\d+\s*:\s*(\d+)\s*deg", re.IGNORECASE)


def check_header(
    header: Sequence[str], name: str, samples: FloatArray, dt: float, *, path: Path, first: bool
) -> tuple[Message | None, ...]:
    """Refuse step [s], count, length, time of the peak and azimuth that are not the same everywhere; return warnings.

    Parameters
    ----------
    header : all lines above the samples
    name : the component, as in its text
    samples : accelerations as printed [n]
    first : whether it is volume 1
    """
    text = "\n".join(header[: TEXT[first]])
    count, rate, interval, length = (_of(found, text) for found in (COUNT[not first], RATE, INTERVAL, LENGTH))
    reals = _block(header, TEXT[first] + INTEGERS[0], (REALS[0] + 6, *REALS[1:])) if not first else []
    check_same(
        "the header's count", count, "that of the line above the samples", float(samples.size), slack=0.0, path=path
    )
    again = (interval, _at(reals, STEP), 1.0 / rate if rate and first else None)
    for stated in again:
        check_same("the step above the samples", dt, "the header's", stated, slack=0.01 * dt, path=path)
    check_duration("the header's record length", length, size=samples.size, dt=dt, slack=0.02 + 2.0 * dt, path=path)
    when = _of(WHEN_1 if first else WHEN_2, text)
    check_same("the time of the peak", when, "that in the header's reals", _at(reals, TIME), slack=0.006, path=path)
    check_time_of_peak(when, samples, dt, slack=0.006, path=path)
    _check_azimuths(header[: TEXT[first]], name, _at(_block(header, TEXT[first], INTEGERS), AZIMUTH), path=path)
    band = BAND.search(text)
    return (nyquist_warning(number(band[2] or band[1]), dt) if band else None,)


def _of(pattern: re.Pattern[str], text: str) -> float | None:
    found = pattern.search(text)
    return number(found[1]) if found else None


def _block(header: Sequence[str], start: int, shape: tuple[int, int, int]) -> list[float | None]:
    """Return the header's numbers from a line on, by columns; None for a blank, or zero, which means unknown."""
    lines, each, width = shape
    rows = [line.ljust(each * width) for line in header[start : start + lines]]
    return [number(row[i * width : (i + 1) * width], unknown=(0.0, -999.0)) for row in rows for i in range(each)]


def _at(values: Sequence[float | None], index: int) -> float | None:
    return values[index] if index < len(values) else None


def _check_azimuths(text: Sequence[str], name: str, again: float | None, *, path: Path) -> None:
    """Refuse a channel whose direction [deg] is another in a second line, or in the integers of the header."""
    printed = [float(found) for line in text for found in CHANNEL.findall(line)]
    printed += [again] if printed and again is not None and again <= 360.0 else []
    other = next(
        (each for each in printed if abs((each - printed[0] + 180.0) % 360.0 - 180.0) > 1.5 or each > 360.0), None
    )
    if other is not None:
        raise RecordError(
            f'{path}: channel "{name}" points to {other:.0f} degrees elsewhere in the header; one of them is damaged: '
            "get the file again, or correct it"
        )
