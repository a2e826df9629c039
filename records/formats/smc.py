"""SMC of the U.S. Geological Survey: 11 lines of text, 6 of integers, 10 of reals, comments, then eight columns of ten.

Integer 16 counts the comments and 17 the samples; real 2 is the rate [1/s]; 1.7e38 and -32768 mean unknown.
Columns touch: `1.5057E+0-2.2223E+0`. Accelerations are in cm/s2 by the definition of the format, which states no unit
in the file. Source: Converse & Brady (1992), BAP: Basic strong-motion accelerogram processing software, USGS Open-File
Report 92-296A; the format's page at https://escweb.wr.usgs.gov/nsmp-data/smcfmt.html.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.header import (
    HeaderOverrides,
    check_count,
    check_peak,
    check_same,
    check_time_of_peak,
    iso_time,
    warn_of_difference,
)
from records.formats.samples import number, numbers, text_lines, uniform_numbers
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record
from spectra.arrays import FloatArray

NAME = "SMC"
UNIT, FACTOR = "cm/s2", 0.01
TEXT_LINES, INTEGER_LINES, REAL_LINES = 11, 6, 10
INTEGERS, REALS = 48, 50
POINTS, YEAR, VERTICAL, AZIMUTH = 16, 1, 12, 13  # indices of integers of the header, from 0
RATE, PEAKS, DISTANCE = 1, (29, 31), 16  # of reals; the time of each peak comes before it
MAGNITUDES = {5: "Mw", 7: "ML", 6: "Ms"}
UNKNOWN = (1.7e38, -32768.0)

ACCELERATION = re.compile(r"\s*[12*]?\s*(?:UN)?CORRECTED ACCELEROGRAM", re.IGNORECASE)
TEXT_PEAK = re.compile(r"epicentral dist\s*=\s*([\d.]*)\s*pk\s*=\s*([-+\d.]*)")
STATION = re.compile(r"\s*station\s*=\s*(.*?)\s*component\s*=\s*(.*?)\s*", re.IGNORECASE)
EVENT = re.compile(r"\s*(\d{4})\s+(\d{1,2})\s+(\d{1,2})\s+(\d\d)(\d\d)\s+(.*?)\s*")


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` is SMC: its lines of station and distance."""
    lines = head.decode("latin-1").splitlines()
    return len(lines) > 6 and lines[5].startswith("station =") and lines[6].startswith("epicentral dist")


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`; its header says all that is needed.

    Raises RecordError, naming the file, for what is not acceleration, a header cut short, a rate that is none, a count
    or peak that the samples do not have.
    """
    lines = text_lines(path)
    if not ACCELERATION.match(lines[0]):
        raise RecordError(f'{path}: line 1: "{lines[0].strip()[:40]}"; give the file of the acceleration')
    integers = _values(lines, TEXT_LINES, INTEGER_LINES, INTEGERS, path=path)
    reals = _values(lines, TEXT_LINES + INTEGER_LINES, REAL_LINES, REALS, path=path)
    rate = _known(reals, RATE) or 0.0
    if not 0.0 < rate < float("inf"):
        raise RecordError(f"{path}: line 18: rate of {rate:.6g} samples a second; it must be positive")
    dt = float(f"{1.0 / rate:.10g}")
    samples, warnings = _samples(lines, integers, reals, dt, path=path)
    station = STATION.fullmatch(lines[5])
    event = EVENT.fullmatch(lines[3])
    component = station[2] if station else ""
    return (
        make_record(
            path.stem,
            FACTOR * samples,
            dt,
            path=str(path),
            event=event[6] if event else "",
            station=station[1] if station else "",
            component=component,
            processing_history=(
                note("read-from-by-format", format=NAME, unit=UNIT),
                lines[0].strip(" 0123456789").lower(),
            ),
            azimuth=azimuth_of(component),
            distance=_metres(_known(reals, 16)),
            earthquake=_earthquake(event, reals),
            site=StationSite(latitude=_known(reals, 10), longitude=_known(reals, 11), elevation=_known(reals, 12)),
            warnings=(*warnings, *_warnings(lines, event, component, integers, reals, path=path)),
        ),
    )


def _samples(
    lines: list[str], integers: FloatArray, reals: FloatArray, dt: float, *, path: Path
) -> tuple[FloatArray, tuple[Message | None, ...]]:
    """Return the samples as printed, checked against count, peaks and their times; and warnings."""
    after = TEXT_LINES + INTEGER_LINES + REAL_LINES
    after = next((i for i in range(after, len(lines)) if not lines[i].startswith("|")), len(lines))
    samples, uneven = uniform_numbers(lines[after:], first=after + 1, path=path)
    check_count(f"{integers[POINTS]:.0f}", samples.size, path=path, name="integer 17 of the header")
    peak = max((abs(value) for i in PEAKS if (value := _known(reals, i)) is not None), default=None)
    warnings = [uneven, check_peak(peak, samples, unit=UNIT, digits=1e-3, path=path)]
    for i, side in zip(PEAKS, (1.0, -1.0), strict=True):
        value = _known(reals, i)
        if value is not None and side * value > 0.0:
            one_sided = np.maximum(side * samples, 0.0)
            check_time_of_peak(_known(reals, i - 1), one_sided, dt, slack=0.5 * dt, path=path)
            warnings.append(check_peak(value, one_sided, unit=UNIT, digits=1e-3, path=path))
    return samples, tuple(warnings)


def _warnings(
    lines: list[str],
    event: re.Match[str] | None,
    component: str,
    integers: FloatArray,
    reals: FloatArray,
    *,
    path: Path,
) -> Iterator[Message | None]:
    """Refuse a direction that is another in the integers; warnings about what the text says again."""
    azimuth = number(component)
    known = _known(integers, AZIMUTH) if _known(integers, VERTICAL) == 90.0 else None
    if azimuth is not None and known is not None:
        check_same(
            "line 6: component", azimuth % 360.0, "integer 14 of the header", known % 360.0, slack=1.0, path=path
        )
    text = TEXT_PEAK.match(lines[6])
    if text:
        peak = max((value for i in PEAKS if (value := _known(reals, i)) is not None), key=abs, default=None)
        yield warn_of_difference(
            "distance", number(text[1]), "number in the header", _known(reals, DISTANCE), slack=0.06
        )
        yield warn_of_difference("peak", number(text[2]), "number in the header", peak, slack=0.06)
    if event:
        yield warn_of_difference("year", number(event[1]), "number in the header", _known(integers, YEAR), slack=0.0)


def _values(lines: list[str], start: int, height: int, size: int, *, path: Path) -> FloatArray:
    """Return a block of `size` header values in `height` lines."""
    values = numbers(lines[start : start + height], first=start + 1, path=path)
    if values.size != size:
        raise RecordError(
            f"{path}: lines {start + 1} to {start + height} hold {values.size} header values, {size} are expected; "
            "the file is cut short or damaged"
        )
    return values


def _known(values: FloatArray, index: int) -> float | None:
    return number(str(values[index]), unknown=UNKNOWN)


def _metres(kilometres: float | None) -> float | None:
    return None if kilometres is None else 1000.0 * kilometres


def _earthquake(event: re.Match[str] | None, reals: FloatArray) -> Earthquake:
    first = next(((_known(reals, i), scale) for i, scale in MAGNITUDES.items() if _known(reals, i)), (None, ""))
    return Earthquake(
        time=iso_time(*event.groups()[:5]) if event else "",
        magnitude=first[0],
        scale=first[1],
        latitude=_known(reals, 2),
        longitude=_known(reals, 3),
        depth=_metres(_known(reals, 4)),
    )
