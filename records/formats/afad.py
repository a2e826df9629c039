"""AFAD's text files of three components: a header of `KEY : VALUE` lines, then columns N-S, E-W and U-D.

    NUMBER OF DATA          : 9036
    SAMPLING INTERVAL (sec) : 0.01
    RAW PGA VALUES (gal)    : (N-S) 78.7235 (E-W) 87.939778 (U-D) 45.10789

The unit is printed with the peaks. AFAD's present portal gives DYNA files instead.
"""

from __future__ import annotations

import re
from pathlib import Path

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.header import HeaderOverrides, check_count, check_peak, iso_time_of_text
from records.formats.samples import acceleration_factor, number, positive_number, text_lines, uniform_numbers
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record
from spectra.arrays import FloatArray

NAME = "AFAD"
LONGEST_HEADER = 40

TITLE = re.compile(rb"\s*STRONG GROUND MOTION RECORDS? OF T", re.IGNORECASE)
COLUMNS = re.compile(r"\s*([NSEWUD]-[NSEWUD])\s+([NSEWUD]-[NSEWUD])\s+([NSEWUD]-[NSEWUD])\s*")
PEAK = re.compile(r"\(([NSEWUD]-[NSEWUD])\)\s*([-+0-9.eE]+)")
PEAKS = re.compile(r"(?:RAW )?PGA VALUES \(([^()]+)\)")
DEGREES = re.compile(r"([0-9.]+)\s*([NS])\s*-\s*([0-9.]+)\s*([EW])")
NEEDED = ("NUMBER OF DATA", "SAMPLING INTERVAL (sec)")


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` is of AFAD: its title."""
    return TITLE.match(head) is not None


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the three records in the file at `path`; its header says all that is needed.

    Raises RecordError, naming the file, for a key that is absent, rows that are not three numbers, a count or peak that
    the columns do not have.
    """
    lines = text_lines(path)
    after, names = _columns_named(lines)
    text = _header(lines[:after])
    absent = [key for key in NEEDED if key not in text]
    if not names or absent:
        raise RecordError(f"{path}: the header of {NAME} has no {(*absent, 'columns')[0]}; it is cut short or damaged")
    unit, peaks = _peaks(text, path=path)
    dt = positive_number(text["SAMPLING INTERVAL (sec)"], name="SAMPLING INTERVAL", line=after, path=path)
    columns, uneven = _columns(lines, after, path=path)
    check_count(text["NUMBER OF DATA"], len(columns), path=path, name="NUMBER OF DATA")
    texts = [
        (uneven, check_peak(peaks.get(name), column, unit=unit, digits=1e-6, path=path))
        for name, column in zip(names, columns.T, strict=True)
    ]
    factor = acceleration_factor(unit, line=after, path=path)
    return tuple(
        _record(text, name, factor * column, dt, unit, warnings, path=path)
        for name, column, warnings in zip(names, columns.T, texts, strict=True)
    )


def _record(
    text: dict[str, str],
    name: str,
    acceleration: FloatArray,
    dt: float,
    unit: str,
    warnings: tuple[Message | None, ...],
    *,
    path: Path,
) -> Record:
    """Return the component `name` of the header's station."""
    return make_record(
        f"{path.stem} {name}",
        acceleration,
        dt,
        path=str(path),
        station=text.get("STATION ID", ""),
        component=name,
        processing_history=(note("read-from", format=NAME, unit=unit),),
        azimuth=azimuth_of(name),
        earthquake=_earthquake(text),
        site=_site(text),
        start=iso_time_of_text(text.get("RECORD TIME", "")),
        warnings=warnings,
    )


def _columns_named(lines: list[str]) -> tuple[int, tuple[str, ...]]:
    """Return the index of the first row, and the names above it; none where no line has them."""
    for i, line in enumerate(lines[:LONGEST_HEADER]):
        names = COLUMNS.fullmatch(line)
        if names:
            return i + 1, names.groups()
    return 0, ()


def _columns(lines: list[str], after: int, *, path: Path) -> tuple[FloatArray, Message | None]:
    """Return every row of three numbers [n, 3], and a warning about their layout."""
    uneven = next((i for i, line in enumerate(lines[after:]) if line.strip() and len(line.split()) != 3), None)
    if uneven is not None:
        line = after + 1 + uneven
        raise RecordError(f'{path}: line {line}: "{lines[line - 1].strip()[:40]}" is not three numbers')
    values, warning = uniform_numbers(lines[after:], first=after + 1, path=path)
    if values.size % 3:
        raise RecordError(f"{path}: {values.size} numbers below the header; they are not three in every line")
    return values.reshape(-1, 3), warning


def _header(lines: list[str]) -> dict[str, str]:
    """Return the value of each key."""
    parts = (line.partition(":") for line in lines if ":" in line)
    return {key.strip(): value.strip() for key, _, value in parts}


def _peaks(text: dict[str, str], *, path: Path) -> tuple[str, dict[str, float | None]]:
    """Return the unit, and the peak of each component in it."""
    for key, value in text.items():
        found = PEAKS.fullmatch(key)
        if found:
            return found[1], {name: number(peak) for name, peak in PEAK.findall(value)}
    raise RecordError(f"{path}: the header of {NAME} has no PGA VALUES with their unit; it is cut short or damaged")


def _earthquake(text: dict[str, str]) -> Earthquake:
    size, _, scale = text.get("EARTHQUAKE MAGNITUDE", "").partition(" ")
    depth = number(text.get("EARTHQUAKE DEPTH (km)", ""))
    latitude, longitude = _degrees(text.get("EPICENTER COORDINATES", ""))
    return Earthquake(
        time=iso_time_of_text(text.get("EARTHQUAKE DATE", "")),
        magnitude=number(size),
        scale=scale.strip() if number(size) is not None else "",
        latitude=latitude,
        longitude=longitude,
        depth=None if depth is None else 1000.0 * depth,
    )


def _site(text: dict[str, str]) -> StationSite:
    latitude, longitude = _degrees(text.get("STATION COORDINATES", ""))
    return StationSite(latitude=latitude, longitude=longitude, elevation=number(text.get("STATION ALTITUDE (m)", "")))


def _degrees(text: str) -> tuple[float | None, float | None]:
    """Return the latitude and longitude of "36.91980N-27.44350E"."""
    found = DEGREES.search(text)
    if found is None:
        return None, None
    latitude, longitude = number(found[1]), number(found[3])
    return (
        None if latitude is None else latitude if found[2] == "N" else -latitude,
        None if longitude is None else longitude if found[4] == "E" else -longitude,
    )
