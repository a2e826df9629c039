"""COSMOS V1 and V2: text lines, blocks of integers, reals and comments, each with its own count, then the samples.

    Corrected acceleration    (Format v01.20 with 13 text lines)
    100 Real-header values follow on  20 lines, Format= (5F15.6)
    42000 acceleration pts, approx  210 secs, units=cm/sec2(04),Format=(1E15.6)

The step is real value 62 [ms]; real value 34 is that of the raw data. Files may hold several channels, and velocity
and displacement beside acceleration, which alone is read. What the header says in words it says again in numbers, and
the samples below must agree with both. Source: COSMOS strong-motion data format v1.20 (2001), tables of text, integer
and real header values.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.header import (
    HeaderOverrides,
    check_count,
    check_duration,
    check_peak,
    check_same,
    check_time_of_peak,
    describe_disagreement,
    iso_time,
    nyquist_warning,
    warn_of_difference,
)
from records.formats.samples import acceleration_factor, number, numbers, numeric_end, text_lines, uniform_numbers
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record
from spectra.arrays import FloatArray

NAME = "COSMOS"
FIRST = re.compile(r".*\(Format v\d[\d.]* with\s+\d+ text lines\)")
BLOCK = re.compile(r"\s*\d+\s+(Integer|Real)-header values follow on\s+(\d{1,4})\s+lines")

SERIES = re.compile(
    r"\s*(\d+)\s+(.*?)\s*(?:pts|points),?\s*approx\s+([\d.]+)\s*secs?,\s*units=\s*([^,(]+?)\s*(?:\(\s*\d+\s*\))?\s*,"
)
SCNL = re.compile(r"\|\s*<SCNL>\s*(\w+)\.(\w+)\.(\w+)")
CHANNEL = re.compile(r"Sta\s+Chan?\s*:?\s*[\w?]*\s*:\s*(.*?)\s*\(")
CODE = re.compile(r"Code:\s*(\S+)\s*(.*)")
ORIGIN = re.compile(r"Origin:\s*(\d+)/(\d+)/(\d+)[,\s]+(\d+):(\d+):([\d.]+)\s*UTC")
TITLE = re.compile(r"(?:Record of )?(.*?)(?: of \w{3} \w{3} \d.*| {2,}.*)?")
MAGNITUDES = {12: "Mw", 14: "ML", 13: "Ms"}
UNKNOWN = -999.0
# indices of the header's numbers, from 0
STATION, EPICENTRE, DISTANCE, SECONDS, STEP_MS, LENGTH, PEAK, TIME = 0, 9, 16, 29, 61, 62, 63, 64  # of reals
STARTED, AZIMUTH = 39, 53  # of integers: year, day of the year, month, day, hour, minute; 1 to 360, north is 360

# what the text says again of the numbers
CHANNEL_AZIMUTH = re.compile(r"Sta\s+Cha?n?\s*:?\s*[\w?]*\s*:\s*(\d+)\s*deg", re.IGNORECASE)
PROCESSED = re.compile(r"Processed.*\bMax\s*=\s*([-+\d.]+)\s+\S+\s+at\s+([\d.]+)\s*sec", re.IGNORECASE)
PLACES = (
    ("latitude", "longitude", re.compile(r"Coords:\s*([-+\d.]+)[\s,]+([-+\d.]+)"), STATION),
    (
        "epicentre's latitude",
        "epicentre's longitude",
        re.compile(r"Hypocenter:\s*([-+\d.]+)[\s,]+([-+\d.]+)"),
        EPICENTRE,
    ),
)
RECORDER = re.compile(r"Rcrd start time:\s*(\d+)/(\d+)/(\d+)[,\s]+(\d+):(\d+):([\d.]+)")
FILTER = re.compile(r"Record filtered below.*\babove\s+([\d.]+)\s*Hz", re.IGNORECASE)
NUMBER = "number in the header"


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` is COSMOS: its first line states the version of the format."""
    return FIRST.match(head.decode("latin-1").split("\n", 1)[0]) is not None


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return every acceleration record in the file at `path`; its headers say all that is needed.

    Raises RecordError, naming the file, for a header cut short, a step that is absent or does not fit the duration,
    a count or peak that the samples do not have, and a file without acceleration.
    """
    lines = text_lines(path)
    starts = [i for i, line in enumerate(lines) if FIRST.match(line)]
    ends = [*starts[1:], len(lines)]
    found = [_channel(lines, start, end, path=path) for start, end in zip(starts, ends, strict=True)]
    records = tuple(record for record in found if record is not None)
    if not records:
        raise RecordError(f"{path}: no acceleration in the file; give the one of the acceleration")
    return records


def _channel(lines: list[str], start: int, end: int, *, path: Path) -> Record | None:
    """Return the record whose lines are from index `start` to `end`; None where it is not acceleration."""
    at = next((i for i in range(start, end) if SERIES.match(lines[i])), None)
    series = None if at is None else SERIES.match(lines[at])
    if at is None or series is None:
        raise RecordError(
            f"{path}: line {start + 1}: a channel without its line of points, even step and unit; cut short, or of "
            "uneven steps (volume 1A), which are not read: give the volume 2 file of the agency"
        )
    if re.search(r"\braw\b|counts?\b", f"{series[2]} {series[4]}", re.IGNORECASE) or "volt" in series[4].lower():
        raise RecordError(
            f'{path}: line {at + 1}: raw data in "{series[4][:20]}" (volume 0), not yet accelerations; give the volume '
            "1 or 2 file of the agency, or MiniSEED with the instrument's response"
        )
    if not series[2].lower().replace("uncor.", "").strip().startswith("acc"):
        return None
    integers, reals = _block(lines, start, at, "Integer", path=path), _block(lines, start, at, "Real", path=path)
    factor = acceleration_factor(series[4], line=at + 1, path=path)
    samples, uneven = uniform_numbers(lines[at + 1 : numeric_end(lines, at + 1)], first=at + 2, path=path)
    check_count(series[1], samples.size, path=path, name=f"line {at + 1}")
    odd = check_peak(_known(reals, PEAK), samples, unit=series[4], digits=1e-3, path=path)
    dt = _step(reals, samples.size, float(series[3]), path=path)
    warnings = _check_header(lines[start:at], integers, reals, samples, dt, path=path, line=start + 1)
    station, component = _names(lines[start:at])
    degrees = _known(integers, AZIMUTH)
    return make_record(
        f"{path.stem} {component}",
        factor * samples,
        dt,
        path=str(path),
        event=_title(lines[start + 1]),
        station=station,
        component=component,
        processing_history=(note("read-from", format=NAME, unit=series[4]), lines[start].split("(")[0].strip()),
        azimuth=azimuth_of(f"{degrees:.0f}") if degrees and 0 < degrees <= 360 else azimuth_of(component),
        distance=_metres(_known(reals, DISTANCE)),
        earthquake=_earthquake(lines[start:at], reals),
        site=StationSite(_known(reals, STATION), _known(reals, STATION + 1), _known(reals, STATION + 2)),
        warnings=(uneven, odd, *warnings),
    )


def _block(lines: list[str], start: int, end: int, kind: str, *, path: Path) -> FloatArray:
    """Return the header values of one `kind`, between two indices."""
    for i in range(start, end):
        found = BLOCK.match(lines[i])
        if found and found[1] == kind:
            return numbers(lines[i + 1 : min(end, i + 1 + int(found[2]))], first=i + 2, path=path)
    raise RecordError(f"{path}: line {start + 1}: a channel without {kind.lower()} header values; it is damaged")


def _known(values: FloatArray, index: int) -> float | None:
    """Return a header value, None where it is unknown."""
    value = float(values[index]) if index < values.size else UNKNOWN
    return None if value == UNKNOWN or value != value else value


def _step(reals: FloatArray, size: int, duration: float, *, path: Path) -> float:
    """Return the step [s], held against the duration [s], which is printed in whole seconds."""
    step = (_known(reals, STEP_MS) or 0.0) / 1000.0
    if not 0.0 < step < float("inf"):
        raise RecordError(f"{path}: real header value 62, the step in ms, is {1000.0 * step:.6g}; it must be positive")
    if abs(size * step - duration) > 1.0 + 0.01 * duration:
        raise RecordError(
            f"{path}: {size} samples at {step:.6g} s last {size * step:.6g} s, the file says {duration:.6g} s; "
            "the header is damaged"
        )
    return float(f"{step:.10g}")


def _names(header: list[str]) -> tuple[str, str]:
    """Return station and component: by network, station and channel where the file has them, else from its text."""
    text = "\n".join(header)
    scnl, code, channel = SCNL.search(text), CODE.search(text), CHANNEL.search(text)
    if scnl:
        return f"{scnl[3]}.{scnl[1]}", scnl[2]
    station = re.sub(r"\s+", " ", f"{code[1]} {code[2]}") if code else ""
    return station.strip(), channel[1] if channel else ""


def _title(line: str) -> str:
    found = TITLE.fullmatch(line.strip())
    return found[1].strip() if found else line.strip()


def _metres(kilometres: float | None) -> float | None:
    return None if kilometres is None else 1000.0 * kilometres


def _earthquake(header: list[str], reals: FloatArray) -> Earthquake:
    origin = ORIGIN.search("\n".join(header))
    first = next(((_known(reals, i), scale) for i, scale in MAGNITUDES.items() if _known(reals, i)), (None, ""))
    return Earthquake(
        time=_time(origin) if origin else "",
        magnitude=first[0],
        scale=first[1],
        latitude=_known(reals, EPICENTRE),
        longitude=_known(reals, EPICENTRE + 1),
        depth=_metres(_known(reals, EPICENTRE + 2)),
    )


def _time(date_and_clock: re.Match[str]) -> str:
    """Return the time as ISO 8601; dates are month/day/year, or year/month/day where the year comes first."""
    one, two, three, *clock = date_and_clock.groups()
    return iso_time(one, two, three, *clock) if len(one) == 4 else iso_time(three, one, two, *clock)


def _check_header(
    text: Sequence[str],
    integers: FloatArray,
    reals: FloatArray,
    samples: FloatArray,
    dt: float,
    *,
    path: Path,
    line: int,
) -> list[Message | None]:
    """Refuse step [s], length, peak and azimuth that are not the same everywhere; return warnings about the rest.

    Parameters
    ----------
    text : every line above the samples; it begins on `line`
    integers, reals : its numbers
    samples : accelerations as printed [n]
    """
    words = "\n".join(text)
    where = f"line {line}: the header's"
    check_duration(f"{where} length", _finite_value(reals, LENGTH), size=samples.size, dt=dt, slack=0.006, path=path)
    check_time_of_peak(_finite_value(reals, TIME), samples, dt, slack=0.006, path=path)
    processed, channel = PROCESSED.search(words), CHANNEL_AZIMUTH.search(words)
    peak, when = (number(processed[1]), number(processed[2])) if processed else (None, None)
    check_same(f"{where} peak", peak, "real value 64", _finite_value(reals, PEAK), slack=0.002, path=path)
    check_same(f"{where} time of the peak", when, "real value 65", _finite_value(reals, TIME), slack=0.006, path=path)
    azimuth = _finite_value(integers, AZIMUTH)
    printed = number(channel[1]) if channel else None
    if printed is not None and azimuth is not None and 0.0 < azimuth <= 360.0:
        check_same(f"{where} azimuth", printed % 360.0, "integer value 54", azimuth % 360.0, slack=1.0, path=path)
    passed = FILTER.search(words)
    return [
        *_place_warnings(words, reals),
        _start_warning(words, integers, reals),
        nyquist_warning(number(passed[1]) if passed else None, dt),
    ]


def _finite_value(values: FloatArray, index: int) -> float | None:
    return number(str(values[index]), unknown=(UNKNOWN,)) if index < values.size else None


def _place_warnings(words: str, reals: FloatArray) -> Iterator[Message | None]:
    """Yield warnings about where the site and the epicentre are, sign and all."""
    for *names, pattern, at in PLACES:
        found = pattern.search(words)
        for i, name in enumerate(names):
            printed = number(found[i + 1]) if found else None
            yield warn_of_difference(name, printed, NUMBER, _finite_value(reals, at + i), slack=1e-3)


def _start_warning(words: str, integers: FloatArray, reals: FloatArray) -> Message | None:
    """Return a warning about when the recorder started, to the second."""
    found = RECORDER.search(words)
    seconds, start = _finite_value(reals, SECONDS), [_finite_value(integers, STARTED + i) for i in (0, 2, 3, 4, 5)]
    if found is None or seconds is None or None in start:
        return None
    again = iso_time(*(f"{each:.0f}" for each in start), str(seconds))
    printed = _time(found)
    return describe_disagreement("start", printed, NUMBER, again) if printed[:19] != again[:19] else None
