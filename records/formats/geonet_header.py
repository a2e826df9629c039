"""What the header of a GeoNet component says in words, against its hundred numbers and the samples below.

Numbers of eight characters, ten to a line: 40 integers and 60 reals. Source: GeoNet, strong motion file formats
(https://www.geonet.org.nz/data/supplementary/strong_motion_file_formats), tables B and C.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import degrees
from pathlib import Path

import numpy as np

from assess.messages.message import Message
from records.errors import RecordError
from records.formats.agreement import check_duration, check_peak, check_same, check_time_of_peak, disagreement
from records.formats.samples import number
from records.orientation import azimuth_of
from spectra.arrays import FloatArray

TEXT_LINES, NUMBER_LINES, COLUMNS = 16, 10, 10
UNIT = "mm/s/s"
# indices among the hundred numbers, from 0
LATITUDE, LONGITUDE, AZIMUTH, SIZE, PREPENDED, DURATION, STEP, PEAK, TIME = 20, 23, 27, 33, 61, 63, 65, 75, 76
MINUTE = 1.0 / 60.0  # deg, to which a place should be the same

LASTS = re.compile(r"\s*Number of points\s+\S+\s+Duration\s+([\d.]+)")
PEAKED = re.compile(r"\s*Acceleration:\s+peak\s+(\S+)\s+\S+\s+at\s+([\d.]+)\s+sec(?:\s+rms\s+([\d.]+))?")
DEGREES = re.compile(r"(\d+)\s+(\d+)\s+(\d+)\s*([NS])\s+(\d+)\s+(\d+)\s+(\d+)\s*([EW])")


def check_header(
    header: Sequence[str], name: str, samples: FloatArray, dt: float, *, path: Path, line: int
) -> list[Message | None]:
    """Refuse step [s], size, peak and azimuth that `header`, from `line` on, does not say alike; return warnings.

    Parameters
    ----------
    header : its 26 lines
    name : of the component, as in its text
    samples : accelerations as printed [n] [mm/s2]
    """
    lasts, peaked = LASTS.match(header[9]), PEAKED.match(header[13])
    peak, when, rms = (number(text or "") for text in peaked.groups()) if peaked else (None, None, None)
    numbers = [_number(header, index) for index in range(NUMBER_LINES * COLUMNS)]
    where = f"line {line}: the header's"
    for words, value, again, slack in (
        ("interval", dt, numbers[STEP], 0.01 * dt),
        ("count", float(samples.size), numbers[SIZE], 0.0),
        ("peak", peak, numbers[PEAK], 0.06),
        ("time of the peak", when, numbers[TIME], 0.011),
    ):
        check_same(f"{where} {words}", value, "the same in its numbers", again, slack=slack, path=path)
    for stated in (number(lasts[1]) if lasts else None, numbers[DURATION]):
        check_duration("the header's duration", stated, size=samples.size, dt=dt, slack=0.006, path=path)
    before = numbers[PREPENDED] or 0.0  # s of samples put before the instrument's, which times do not count
    check_time_of_peak(None if when is None else when + before, samples, dt, slack=0.006, path=path)
    _check_azimuth(name, numbers[AZIMUTH], path=path, line=line)
    found = float(np.sqrt(np.mean(samples**2))) if samples.size else 0.0
    return [
        check_peak(peak, samples, unit=UNIT, digits=0.06, path=path),
        disagreement("stated rms", rms, "rms of the samples", found, slack=0.01 * found + 0.06),
        *_places(header[1], numbers),
    ]


def coordinates(line: str) -> tuple[float | None, float | None]:
    """Return the latitude and longitude [deg] of "42 37 10S  173 03 13E"."""
    found = DEGREES.search(line)
    if found is None:
        return None, None
    north, east = (int(found[i]) + int(found[i + 1]) / 60 + int(found[i + 2]) / 3600 for i in (1, 5))
    return north if found[4] == "N" else -north, east if found[8] == "E" else -east


def _number(header: Sequence[str], index: int) -> float | None:
    """Return one of the numbers; None for a blank or zero, which means unknown."""
    row, column = divmod(index, COLUMNS)
    return number(header[TEXT_LINES + row][8 * column : 8 * column + 8], unknown=(0.0,))


def _check_azimuth(name: str, again: float | None, *, path: Path, line: int) -> None:
    """Refuse a component whose name and number point to directions more than a degree apart."""
    azimuth = azimuth_of(name)
    if azimuth is None or again is None:
        return
    if abs((again - degrees(azimuth) + 180.0) % 360.0 - 180.0) > 1.5:
        raise RecordError(
            f"{path}: line {line + 12}: component {name} points to {degrees(azimuth):.0f} degrees, the header's number "
            f"is {again:.0f}; one of them is damaged: get the file again, or correct it"
        )


def _places(line: str, numbers: Sequence[float | None]) -> Iterator[Message | None]:
    """Yield warnings about the site's latitude and longitude, which the numbers repeat without a sign."""
    for words, value, at in zip(("latitude", "longitude"), coordinates(line), (LATITUDE, LONGITUDE), strict=True):
        parts = [each or 0.0 for each in numbers[at : at + 3]]
        again = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0
        if value is not None and again:
            yield disagreement(words, abs(value), "number in the header", again, slack=MINUTE)
