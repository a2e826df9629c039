"""GeoNet V2A: components one after another, each of 16 lines of text, 10 of numbers and three blocks of ten columns.

    Number of points  8192    Duration 163.82 sec
    Instrument corrected data at 0.020 sec intervals
    Component N28W  Longitudinal Accelerometer Axis
    Acceleration:  peak  -9733.1 mm/s/s at  44.88 sec     rms    719.0 mm/s/s

The blocks are acceleration, velocity and displacement; each begins on a new line. The hundred numbers of the header, of
eight characters, ten to a line, are 40 integers and 60 reals; what the text says is held against them and against the
samples. Source: GeoNet, New Zealand, strong motion data formats
(https://www.geonet.org.nz/data/supplementary/strong_motion_file_formats), tables B and C.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from datetime import datetime
from math import degrees
from pathlib import Path

import numpy as np

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.header import (
    HeaderOverrides,
    check_count,
    check_duration,
    check_integral,
    check_peak,
    check_same,
    check_time_of_peak,
    iso_time,
    warn_of_difference,
)
from records.formats.samples import (
    acceleration_factor,
    count,
    number,
    numbers,
    numeric_end,
    positive_number,
    text_lines,
    uniform_numbers,
)
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record
from spectra.arrays import FloatArray

NAME = "GeoNet V2A"
POINTS = re.compile(r"\s*Number of points\s+(\S+)")
INTERVAL = re.compile(r"\s*Instrument corrected data at\s+(\S+)\s+sec")
UNCORRECTED = re.compile(r"\s*Raw readings in units of")  # where a V2A has its interval
COMPONENT = re.compile(r"\s*Component\s+([NS] ?\d{1,2}[EW]\b|\S+)")
PEAK = re.compile(r"\s*Acceleration:\s+peak\s+(\S+)\s+(\S+)\s+at")
DATE = re.compile(r"\s*(\d{4})\s+([A-Z][a-z]+)\s+(\d+)\s+(\d+):(\d+):([\d.]+)\s+UT")

TEXT_LINES, NUMBER_LINES, COLUMNS = 16, 10, 10
UNIT = "mm/s/s"

# indices among the hundred numbers, from 0
LATITUDE, LONGITUDE, AZIMUTH, SIZE, PREPENDED, DURATION, STEP, PEAK_NUMBER, TIME = 20, 23, 27, 33, 61, 63, 65, 75, 76
MINUTE = 1.0 / 60.0  # deg, to which a place should be the same
LASTS = re.compile(r"\s*Number of points\s+\S+\s+Duration\s+([\d.]+)")
PEAKED = re.compile(r"\s*Acceleration:\s+peak\s+(\S+)\s+\S+\s+at\s+([\d.]+)\s+sec(?:\s+rms\s+([\d.]+))?")
DEGREES = re.compile(r"(\d+)\s+(\d+)\s+(\d+)\s*([NS])\s+(\d+)\s+(\d+)\s+(\d+)\s*([EW])")


def looks_like(head: bytes) -> bool:
    """Return whether the first bytes are V2A, or V1A, which is refused: lines of the points and the interval."""
    lines = head.decode("latin-1").splitlines()
    if len(lines) <= 10 or POINTS.match(lines[9]) is None:
        return False
    return INTERVAL.match(lines[10]) is not None or UNCORRECTED.match(lines[10]) is not None


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the records in the file at `path`; its headers say all that is needed.

    Raises RecordError, naming the file, for a header without points, interval, component or unit, and blocks or a peak
    that are not as the header says.
    """
    lines = text_lines(path)
    records: list[Record] = []
    start = 0
    if UNCORRECTED.match(lines[10]):
        raise RecordError(
            f"{path}: line 11: uncorrected readings (V1A), which are not read; give the V2A file of GeoNet"
        )
    while any(line.strip() for line in lines[start:]):
        records.append(_component(lines, start, path=path))
        start = numeric_end(lines, start + TEXT_LINES)
    return tuple(records)


def _component(lines: list[str], start: int, *, path: Path) -> Record:
    """Return the component whose header begins at index `start`."""
    interval = _match_header_line(INTERVAL, lines, start + 10, path=path)[1]
    name = _match_header_line(COMPONENT, lines, start + 12, path=path)[1]
    peak = _match_header_line(PEAK, lines, start + 13, path=path)
    if peak[2] != UNIT:
        raise RecordError(f'{path}: line {start + 14}: unit "{peak[2][:20]}"; {NAME} is in {UNIT}, the file is damaged')
    dt = positive_number(interval, name="interval", line=start + 11, path=path)
    samples, velocity, uneven = _samples(lines, start, path=path)
    header = lines[start : start + TEXT_LINES + NUMBER_LINES]
    warnings = _check_header(header, name, samples, dt, path=path, line=start + 1)
    return make_record(
        f"{path.stem} {name}",
        acceleration_factor(UNIT, line=start + 14, path=path) * samples,
        dt,
        path=str(path),
        event=_place(lines[start + 6]),
        station=_station(lines[start + 1]),
        component=name,
        processing_history=(note("read-from", format=NAME, unit=UNIT), lines[start + 11].strip()),
        azimuth=azimuth_of(name),
        distance=_kilometres(lines[start + 8], "Dist"),
        earthquake=_earthquake(lines[start + 7], lines[start + 8]),
        site=StationSite(*_coordinates(lines[start + 1])),
        warnings=(uneven, *warnings, check_integral(velocity, samples, dt, path=path, name=name)),
    )


def _samples(lines: list[str], start: int, *, path: Path) -> tuple[FloatArray, FloatArray, Message | None]:
    """Return accelerations and velocities of the component at index `start`, as printed and complete, and a warning."""
    points = _match_header_line(POINTS, lines, start + 9, path=path)[1]
    size = count(points, name="Number of points", line=start + 10, path=path)
    first = start + TEXT_LINES + NUMBER_LINES
    end, height = numeric_end(lines, first), -(-size // COLUMNS)
    held = sum(1 for line in lines[first:end] if line.strip())
    if held != 3 * height:
        raise RecordError(
            f"{path}: line {first + 1}: {held} lines of numbers, {size} points three times are {3 * height}; "
            f"the file is {'cut short' if held < 3 * height else 'damaged'}"
        )
    samples, uneven = uniform_numbers(lines[first : first + height], first=first + 1, path=path)
    check_count(str(size), samples.size, path=path, name="Number of points")
    velocity = numbers(lines[first + height : first + 2 * height], first=first + height + 1, path=path)
    return samples, velocity, uneven


def _match_header_line(pattern: re.Pattern[str], lines: list[str], at: int, *, path: Path) -> re.Match[str]:
    """Match a line of the header; refuse another."""
    found = pattern.match(lines[at]) if at < len(lines) else None
    if found is None:
        held = lines[at].strip()[:40] if at < len(lines) else "the end of the file"
        expected = pattern.pattern.split("\\s+(")[0].removeprefix("\\s*").replace("\\s+", " ")
        raise RecordError(f'{path}: line {at + 1}: "{held}" where {NAME} has "{expected} …"; the file is damaged')
    return found


def _station(line: str) -> str:
    """Return the code behind "Site"."""
    return [*line.split(), "", ""][1]


def _place(line: str) -> str:
    """Return where the epicentre is, in words: "5 km south-west of Waiau"; "" where the line is another."""
    return line.strip() if re.fullmatch(r"\s*\d+ km \S+ of \S.*", line) else ""


def _kilometres(line: str, key: str) -> float | None:
    """Return the kilometres behind `key`, in metres."""
    found = re.search(rf"{key}\s+([\d.]+)\s*km", line)
    value = number(found[1]) if found else None
    return None if value is None else 1000.0 * value


def _earthquake(date: str, place: str) -> Earthquake:
    at, size = DATE.match(date), re.search(r"\b(M[A-Za-z]*)\s+([\d.]+)\s*$", place)
    latitude, longitude = _coordinates(place)
    return Earthquake(
        time=iso_time(at[1], _month(at[2]), at[3], at[4], at[5], at[6]) if at else "",
        magnitude=number(size[2]) if size else None,
        scale=size[1] if size else "",
        latitude=latitude,
        longitude=longitude,
        depth=_kilometres(place, "Depth"),
    )


def _month(name: str) -> str:
    try:
        return str(datetime.strptime(name, "%B").month)
    except ValueError:
        return ""


def _check_header(
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
        ("peak", peak, numbers[PEAK_NUMBER], 0.06),
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
        warn_of_difference("stated rms", rms, "rms of the samples", found, slack=0.01 * found + 0.06),
        *_place_warnings(header[1], numbers),
    ]


def _coordinates(line: str) -> tuple[float | None, float | None]:
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


def _place_warnings(line: str, numbers: Sequence[float | None]) -> Iterator[Message | None]:
    """Yield warnings about the site's latitude and longitude, which the numbers repeat without a sign."""
    for words, value, at in zip(("latitude", "longitude"), _coordinates(line), (LATITUDE, LONGITUDE), strict=True):
        parts = [each or 0.0 for each in numbers[at : at + 3]]
        again = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0
        if value is not None and again:
            yield warn_of_difference(words, abs(value), "number in the header", again, slack=MINUTE)
