"""DYNA, the text format of ESM and ITACA (and of AFAD's present portal): `KEY: VALUE` lines, then one value a line.

    NDATA: 19128
    UNITS: cm/s^2
    PGA_CM/S^2: 0.300022

Source: ESM, Engineering Strong-Motion database, description of DYNA 1.2 (https://esm-db.eu).
"""

from __future__ import annotations

import re
from pathlib import Path

from assess.messages.message import Message, Quantity, note
from records.errors import RecordError
from records.formats.header import (
    HeaderOverrides,
    check_count,
    check_duration,
    check_peak,
    check_time_of_peak,
    describe_disagreement,
    filter_warning,
    iso_time_of_text,
)
from records.formats.samples import acceleration_factor, number, positive_number, text_lines, uniform_numbers
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record, usable_period

NAME = "ESM/ITACA DYNA"

KEY = re.compile(r"\s*([A-Z][A-Z0-9_/^]*)\s*:\s*(.*)")
NEEDED = ("SAMPLING_INTERVAL_S", "NDATA", "UNITS")
NAMED = re.compile(r"\w+\.\w+\.\w*\.([A-Z][A-Z][A-Z0-9])\.")


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` is DYNA: the first key, the step and the count."""
    return head.lstrip().startswith(b"EVENT_NAME:") and b"\nSAMPLING_INTERVAL_S:" in head and b"\nNDATA:" in head


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`; its header says all that is needed.

    Raises RecordError, naming the file, for what is not acceleration, a key that is absent, a count or peak that the
    samples do not have.
    """
    lines = text_lines(path)
    header, after = _header(lines)
    _check_header(header, path=path)
    at = {key: line for key, (line, _) in header.items()}
    text = {key: value for key, (_, value) in header.items()}
    unit = text["UNITS"]
    factor = acceleration_factor(unit, line=at["UNITS"], path=path)
    dt = positive_number(
        text["SAMPLING_INTERVAL_S"], name="SAMPLING_INTERVAL_S", line=at["SAMPLING_INTERVAL_S"], path=path
    )
    samples, uneven = uniform_numbers(lines[after:], first=after + 1, path=path)
    check_count(text["NDATA"], samples.size, path=path, name="NDATA")
    peak = number(text.get("PGA_CM/S^2", ""))
    odd = check_peak(peak, samples * (factor / 0.01), unit="cm/s2", digits=1e-6, path=path)
    low, high = (number(text.get(f"{side}_CUT_FREQUENCY_HZ", "")) for side in ("LOW", "HIGH"))
    duration, when = number(text.get("DURATION_S", "")), number(text.get("TIME_PGA_S", ""))
    check_duration("DURATION_S", duration, size=samples.size, dt=dt, slack=0.006, path=path)
    check_time_of_peak(when, samples, dt, slack=0.006, path=path)
    return (
        make_record(
            path.stem,
            factor * samples,
            dt,
            path=str(path),
            event=_event(text),
            station=_station(text),
            component=text.get("STREAM", ""),
            processing_history=(note("read-from", format=NAME, unit=unit), *_processing(text)),
            longest_period=usable_period(low),
            azimuth=azimuth_of(text.get("STREAM", "")),
            distance=_metres(text.get("EPICENTRAL_DISTANCE_KM", "")),
            earthquake=_earthquake(text),
            site=_site(text),
            start=iso_time_of_text(text.get("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS", "")),
            warnings=(
                uneven,
                odd,
                filter_warning(samples, dt, low=low, high=high),
                _misnamed(text, path),
            ),
        ),
    )


def _header(lines: list[str]) -> tuple[dict[str, tuple[int, str]], int]:
    """Return the line number and value of each key, and the index of the first line after them."""
    header: dict[str, tuple[int, str]] = {}
    for i, line in enumerate(lines):
        found = KEY.fullmatch(line)
        if found is None:
            return header, i
        header[found[1]] = (i + 1, found[2].strip())
    return header, len(lines)


def _check_header(header: dict[str, tuple[int, str]], *, path: Path) -> None:
    absent = [key for key in NEEDED if not header.get(key, (0, ""))[1]]
    if absent:
        raise RecordError(f"{path}: the header of {NAME} has no {absent[0]}; it is cut short or damaged")
    line, kind = header.get("DATA_TYPE", (0, ""))
    if kind and kind.upper() != "ACCELERATION":
        raise RecordError(f'{path}: line {line}: DATA_TYPE "{kind[:30]}"; give the file of the acceleration')


def _station(text: dict[str, str]) -> str:
    """Return network and code, with the name where there is one: `HI.ARS1 Town Hall, Argos`."""
    code = ".".join(part for part in (text.get("NETWORK", ""), text.get("STATION_CODE", "")) if part)
    return f"{code} {text.get('STATION_NAME', '')}".strip()


def _event(text: dict[str, str]) -> str:
    """Return the name of the event, else its number in the archive; "" where both are bare digits, a time stamp."""
    names = (text.get("EVENT_NAME", ""), text.get("EVENT_ID", ""))
    return next((name for name in names if re.search(r"[^\W\d_]", name)), "")


def _processing(text: dict[str, str]) -> tuple[Message, ...]:
    """Return the filter that the source has applied."""
    low, high = (number(text.get(f"{side}_CUT_FREQUENCY_HZ", "")) for side in ("LOW", "HIGH"))
    if low is None and high is None:
        return ()
    begin = Quantity(low or 0.0, "frequency", 6)
    if high is None:
        return (note("filtered-by-source-from", low=begin),)
    return (note("filtered-by-source", low=begin, high=Quantity(high, "frequency", 6)),)


def _misnamed(text: dict[str, str], path: Path) -> Message | None:
    """Return a warning where the name of the file, network.station.location.stream.…, has another stream."""
    stream, named = text.get("STREAM", ""), NAMED.match(path.name)
    if not stream or named is None or named[1] == stream:
        return None
    return describe_disagreement("STREAM", stream, "file's name", named[1])


def _metres(kilometres: str) -> float | None:
    value = number(kilometres)
    return None if value is None else 1000.0 * value


def _earthquake(text: dict[str, str]) -> Earthquake:
    moment, local = number(text.get("MAGNITUDE_W", "")), number(text.get("MAGNITUDE_L", ""))
    return Earthquake(
        time=iso_time_of_text(f"{text.get('EVENT_DATE_YYYYMMDD', '')} {text.get('EVENT_TIME_HHMMSS', '')}"),
        magnitude=local if moment is None else moment,
        scale="Mw" if moment is not None else "ML" if local is not None else "",
        latitude=number(text.get("EVENT_LATITUDE_DEGREE", "")),
        longitude=number(text.get("EVENT_LONGITUDE_DEGREE", "")),
        depth=_metres(text.get("EVENT_DEPTH_KM", "")),
    )


def _site(text: dict[str, str]) -> StationSite:
    ground = text.get("SITE_CLASSIFICATION_EC8", "")
    depth = number(text.get("SENSOR_DEPTH_M", ""))
    return StationSite(
        latitude=number(text.get("STATION_LATITUDE_DEGREE", "")),
        longitude=number(text.get("STATION_LONGITUDE_DEGREE", "")),
        elevation=number(text.get("STATION_ELEVATION_M", "")),
        vs30=number(text.get("VS30_M/S", "")),
        ground=f"EC8 {ground}" if ground else "",
        place=f"{depth:.6g} m deep" if depth else "",
    )
