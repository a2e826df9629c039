"""GeoNet V2A: components one after another, each of 16 lines of text, 10 of numbers and three blocks of ten columns.

    Number of points  8192    Duration 163.82 sec
    Instrument corrected data at 0.020 sec intervals
    Component N28W  Longitudinal Accelerometer Axis
    Acceleration:  peak  -9733.1 mm/s/s at  44.88 sec     rms    719.0 mm/s/s

The blocks are acceleration, velocity and displacement; each begins on a new line. Source: GeoNet, New Zealand, strong
motion data formats (https://www.geonet.org.nz/data/supplementary/strong_motion_file_formats).
"""

from __future__ import annotations

import re
from datetime import datetime
from pathlib import Path

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.agreement import check_count, check_integral
from records.formats.geonet_header import COLUMNS, NUMBER_LINES, TEXT_LINES, UNIT, check_header, coordinates
from records.formats.header_overrides import HeaderOverrides
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
from records.formats.times import iso
from records.orientation import azimuth_of
from records.record import Earthquake, Record, Site, make_record
from spectra.arrays import FloatArray

NAME = "GeoNet V2A"

POINTS = re.compile(r"\s*Number of points\s+(\S+)")
INTERVAL = re.compile(r"\s*Instrument corrected data at\s+(\S+)\s+sec")
UNCORRECTED = re.compile(r"\s*Raw readings in units of")  # where a V2A has its interval
COMPONENT = re.compile(r"\s*Component\s+([NS] ?\d{1,2}[EW]\b|\S+)")
PEAK = re.compile(r"\s*Acceleration:\s+peak\s+(\S+)\s+(\S+)\s+at")
DATE = re.compile(r"\s*(\d{4})\s+([A-Z][a-z]+)\s+(\d+)\s+(\d+):(\d+):([\d.]+)\s+UT")


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
    interval = _found(INTERVAL, lines, start + 10, path=path)[1]
    name = _found(COMPONENT, lines, start + 12, path=path)[1]
    peak = _found(PEAK, lines, start + 13, path=path)
    if peak[2] != UNIT:
        raise RecordError(f'{path}: line {start + 14}: unit "{peak[2][:20]}"; {NAME} is in {UNIT}, the file is damaged')
    dt = positive_number(interval, name="interval", line=start + 11, path=path)
    samples, velocity, uneven = _samples(lines, start, path=path)
    header = lines[start : start + TEXT_LINES + NUMBER_LINES]
    warnings = check_header(header, name, samples, dt, path=path, line=start + 1)
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
        site=Site(*coordinates(lines[start + 1])),
        warnings=(uneven, *warnings, check_integral(velocity, samples, dt, path=path, name=name)),
    )


def _samples(lines: list[str], start: int, *, path: Path) -> tuple[FloatArray, FloatArray, Message | None]:
    """Return accelerations and velocities of the component at index `start`, as printed and complete, and a warning."""
    points = _found(POINTS, lines, start + 9, path=path)[1]
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


def _found(pattern: re.Pattern[str], lines: list[str], at: int, *, path: Path) -> re.Match[str]:
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
    latitude, longitude = coordinates(place)
    return Earthquake(
        time=iso(at[1], _month(at[2]), at[3], at[4], at[5], at[6]) if at else "",
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
