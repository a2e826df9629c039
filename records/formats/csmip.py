"""CSMIP volumes 1 and 2 of the California Geological Survey: channels one after another, each with its header.

    13200 Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)             volume 1, uncorrected
    3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)               volume 2, corrected

A channel of volume 2 goes on with velocity and displacement, which are not read. The text of its header has count, step
and the time of the peak; the reals, eight to a line of ten characters each, repeat them, and an integer the azimuth.
Volume 1 has count, rate and length. Source: Shakal & Huang (1985), Standard tape format for CSMIP strong-motion data
tapes, report OSMS 85-03.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from assess.messages.message import Message, note, whole_number
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
    nyquist_warning,
)
from records.formats.samples import (
    acceleration_factor,
    number,
    numbers,
    numeric_end,
    positive_number,
    text_lines,
    uniform_numbers,
)
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record
from spectra.arrays import FloatArray

NAME = "CSMIP"

VOLUME_1 = re.compile(
    r"\s*(?P<n>\d+)\s+Accelerogram points at\s+(?P<rate>\S+)\s*pts/sec,?\s+in units of\s+(?P<unit>\S+)", re.I
)

VOLUME_2 = re.compile(
    r"\s*(?P<n>\d+)\s+points of accel\S* data equally spaced at\s+(?P<step>\S+)\s*sec[.,]*\s+"
    r"(?:\(units:\s*(?P<unit>[^)]+)\)|in\s+(?P<in>\S+?)\.?(?:\s|$))",
    re.IGNORECASE,
)
VELOCITY = re.compile(r"\s*\d+\s+points of veloc\S* data .*\bcm/s", re.IGNORECASE)
UNCORRECTED = re.compile(r"\s*uncorrected accelerogram data\b", re.IGNORECASE)  # first line of volume 1
CHANNEL = re.compile(r"\s*Chan\s+(\d+)\s*:\s*(.*?)\s*", re.IGNORECASE)
STATION = re.compile(r"\s*Station No\.\s*(\S+)\s+([\d.]+)\s*([NS]),\s*([\d.]+)\s*([EW])", re.IGNORECASE)
ORIGIN = re.compile(r"Origin\s*(?:\([^()]*\))?\s*:\s*(\d+)/(\d+)/(\d+)\s*,\s*(\d+):(\d+):([\d.]+)\s*UTC", re.IGNORECASE)
HYPOCENTRE = re.compile(r"([\d.]+)\s*([NS])\s*,\s*([\d.]+)\s*([EW])\s*,\s*H\s*=\s*([\d.]+)\s*KM", re.IGNORECASE)
MAGNITUDE = re.compile(r"\b(M[A-Z])\s*=\s*([\d.]+)", re.IGNORECASE)
PEAK_1 = re.compile(r"\bMax\s*=\s*(\S+)\s*(g)\b", re.IGNORECASE)
PEAK_2 = re.compile(r"Peak acceleration\s*=\s*(\S+)\s+(\S+)\s", re.IGNORECASE)
NAME_OF_EVENT, NAME_OF_STATION, OF_CHANNEL = 2, 6, 7  # lines of a header of volume 2, from 0
STATION_1, CHANNEL_1 = 5, 6  # of volume 1

# where the header repeats what its text says
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
CHANNEL_AZIMUTH = re.compile(r"\bChan\s+\d+\s*:\s*(\d+)\s*deg", re.IGNORECASE)


def looks_like(head: bytes) -> bool:
    """Return whether the first bytes are CSMIP: its line of points, step and unit, or the title of volume 1."""
    lines = head.decode("latin-1").splitlines()
    titled = bool(lines) and UNCORRECTED.match(lines[0]) is not None
    return titled or any(VOLUME_1.match(line) or VOLUME_2.match(line) for line in lines)


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the acceleration of every channel in the file at `path`; its headers say all that is needed.

    Raises RecordError, naming the file, for a header without its channel, a step or unit that is none, a count or peak
    that the samples do not have.
    """
    lines = text_lines(path)
    records: list[Record] = []
    start = ended = 0
    for at, line in enumerate(lines):
        found = VOLUME_1.match(line) or VOLUME_2.match(line)
        if found:
            records.append(_channel(lines[start:at], found, lines, at, path=path))
        if line.startswith("/&"):
            start, ended = at + 1, ended + 1
            if records and len(records) < ended:
                raise RecordError(
                    f"{path}: channel {ended}, which ends in line {at + 1}, has no line of points, step and unit that "
                    "can be read; it is damaged: get the file again"
                )
    if not records:
        raise RecordError(
            f"{path}: no channel of points evenly spaced in time; the file is cut short, or of pairs of time and "
            "acceleration, which are not read: give the volume 2 file, or resample it to one step and write CSV"
        )
    if any(line.strip() for line in lines[start:]):
        raise RecordError(f"{path}: the last channel does not end with a line that begins with /&; it is cut short")
    return tuple(records)


def _channel(header: list[str], found: re.Match[str], lines: list[str], at: int, *, path: Path) -> Record:
    """Return the channel whose line of points is at index `at`."""
    first = found.re is VOLUME_1 or (bool(header) and UNCORRECTED.match(header[0]) is not None)
    parts = found.groupdict()
    unit = (parts["unit"] or parts.get("in") or "").strip().rstrip(".")
    factor = acceleration_factor(unit, line=at + 1, path=path)
    end = numeric_end(lines, at + 1)
    samples, uneven = uniform_numbers(lines[at + 1 : end], first=at + 2, path=path)
    check_count(parts["n"], samples.size, path=path, name=f"line {at + 1}")
    peak = (PEAK_1 if first else PEAK_2).search("\n".join(header))
    odd = None
    if peak:
        own = acceleration_factor(peak[2], line=at + 1, path=path)  # printed beside the peak, apart from the unit
        odd = check_peak(number(peak[1]), samples * (factor / own), unit=peak[2], digits=6e-4, path=path)
    chan = _named(header, CHANNEL_1 if first else OF_CHANNEL, path=path, line=at + 1)
    dt = _step(parts, line=at + 1, path=path)
    warnings = _check_header(header, chan[2], samples, dt, path=path, first=first)
    integral = check_integral(
        _velocity(lines, end, path=path), factor * samples, dt, path=path, name=f"channel {chan[1]}"
    )
    return make_record(
        f"{path.stem} chan {chan[1]}",
        factor * samples,
        dt,
        path=str(path),
        event=_column(header, NAME_OF_EVENT - first).removeprefix("Record of "),
        station=_station(header, NAME_OF_STATION - first),
        component=chan[2],
        processing_history=(
            note("read-from-volume", format=NAME, volume=whole_number(1 if first else 2), unit=unit),
            *([note("uncorrected")] if first else []),
        ),
        azimuth=azimuth_of(chan[2]),
        earthquake=_earthquake(header),
        site=_site(header),
        warnings=(uneven, odd, *warnings, integral),
    )


def _velocity(lines: list[str], at: int, *, path: Path) -> FloatArray:
    """Return the velocities [m/s] of the block that begins at index `at`; none where it is another."""
    if at >= len(lines) or not VELOCITY.match(lines[at]):
        return np.empty(0)
    return 0.01 * numbers(lines[at + 1 : numeric_end(lines, at + 1)], first=at + 2, path=path)


def _step(parts: dict[str, str], *, line: int, path: Path) -> float:
    """Return the step [s], from itself or from the rate."""
    if "step" in parts:
        return positive_number(parts["step"], name="step", line=line, path=path)
    return float(f"{1.0 / positive_number(parts['rate'], name='rate', line=line, path=path):.10g}")


def _named(header: list[str], at: int, *, path: Path, line: int) -> re.Match[str]:
    """Return the number and direction of the channel."""
    found = CHANNEL.fullmatch(header[at]) if at < len(header) else None
    if found is None:
        raise RecordError(f"{path}: line {line}: the header above has no line of its channel; it is damaged")
    return found


def _station(header: list[str], at: int) -> str:
    """Return the number and name; the agency follows on the same line."""
    number_of = next((found[1] for line in header if (found := STATION.match(line))), "")
    return f"{number_of} {_column(header, at)}".strip()


def _column(header: list[str], at: int) -> str:
    """Return the text of a line before a wide gap."""
    return re.split(r"\s{3,}", header[at].strip())[0] if at < len(header) else ""


def _earthquake(header: list[str]) -> Earthquake:
    text = "\n".join(header)
    origin, place, size = ORIGIN.search(text), HYPOCENTRE.search(text), MAGNITUDE.search(text)
    return Earthquake(
        time=_time(*origin.groups()) if origin else "",
        magnitude=number(size[2]) if size else None,
        scale=size[1].upper() if size else "",
        latitude=_signed(place[1], place[2]) if place else None,
        longitude=_signed(place[3], place[4]) if place else None,
        depth=1000.0 * float(place[5]) if place and number(place[5]) is not None else None,
    )


def _time(month: str, day: str, year: str, *clock: str) -> str:
    """Return the time as ISO 8601; two digits are a year of 1933 to 2032, as the first accelerograms are of 1933."""
    full = year if len(year) == 4 else str(1900 + int(year) + (100 if int(year) < 33 else 0))
    return iso_time(full, month, day, *clock)


def _site(header: list[str]) -> StationSite:
    found = next((found for line in header if (found := STATION.match(line))), None)
    if found is None:
        return StationSite()
    return StationSite(latitude=_signed(found[2], found[3]), longitude=_signed(found[4], found[5]))


def _signed(degrees: str, side: str) -> float | None:
    value = number(degrees)
    return None if value is None else value if side.upper() in "NE" else -value


def _check_header(
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
    count, rate, interval, length = (
        _search_number(found, text) for found in (COUNT[not first], RATE, INTERVAL, LENGTH)
    )
    reals = _block(header, TEXT[first] + INTEGERS[0], (REALS[0] + 6, *REALS[1:])) if not first else []
    check_same(
        "the header's count", count, "that of the line above the samples", float(samples.size), slack=0.0, path=path
    )
    again = (interval, _entry(reals, STEP), 1.0 / rate if rate and first else None)
    for stated in again:
        check_same("the step above the samples", dt, "the header's", stated, slack=0.01 * dt, path=path)
    check_duration("the header's record length", length, size=samples.size, dt=dt, slack=0.02 + 2.0 * dt, path=path)
    when = _search_number(WHEN_1 if first else WHEN_2, text)
    check_same("the time of the peak", when, "that in the header's reals", _entry(reals, TIME), slack=0.006, path=path)
    check_time_of_peak(when, samples, dt, slack=0.006, path=path)
    _check_azimuths(header[: TEXT[first]], name, _entry(_block(header, TEXT[first], INTEGERS), AZIMUTH), path=path)
    band = BAND.search(text)
    return (nyquist_warning(number(band[2] or band[1]), dt) if band else None,)


def _search_number(pattern: re.Pattern[str], text: str) -> float | None:
    found = pattern.search(text)
    return number(found[1]) if found else None


def _block(header: Sequence[str], start: int, shape: tuple[int, int, int]) -> list[float | None]:
    """Return the header's numbers from a line on, by columns; None for a blank, or zero, which means unknown."""
    lines, each, width = shape
    rows = [line.ljust(each * width) for line in header[start : start + lines]]
    return [number(row[i * width : (i + 1) * width], unknown=(0.0, -999.0)) for row in rows for i in range(each)]


def _entry(values: Sequence[float | None], index: int) -> float | None:
    return values[index] if index < len(values) else None


def _check_azimuths(text: Sequence[str], name: str, again: float | None, *, path: Path) -> None:
    """Refuse a channel whose direction [deg] is another in a second line, or in the integers of the header."""
    printed = [float(found) for line in text for found in CHANNEL_AZIMUTH.findall(line)]
    printed += [again] if printed and again is not None and again <= 360.0 else []
    other = next(
        (each for each in printed if abs((each - printed[0] + 180.0) % 360.0 - 180.0) > 1.5 or each > 360.0), None
    )
    if other is not None:
        raise RecordError(
            f'{path}: channel "{name}" points to {other:.0f} degrees elsewhere in the header; one of them is damaged: '
            "get the file again, or correct it"
        )
