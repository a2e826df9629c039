"""Plausibility of a record: whether it can be ground motion, or its unit, step or time was misread."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime
from itertools import groupby
from math import asin, cos, hypot, log, radians, sin, sqrt

import numpy as np

from assess.messages.message import Message, Quantity, Term, Value, warning
from records.candidates import Candidate
from records.record import Record
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of
from spectra.gravity import g

LARGEST_PEAK = (
    3.0  # g; the strongest recorded so far have reached 2.7 g (horizontal) to 3.9 g (vertical, Iwate-Miyagi 2008)
)
LEAST_PEAK = 1e-5  # g; far below what a body that rocks can feel
USUAL = 0.1  # g
COARSE = 0.022  # s; instruments sample 50 times a second and more
SLOW, FAST = 2.5, 22.0  # Hz; no real record has 95 % of its power below SLOW at a COARSE step, or half above FAST
BY_SAMPLE = "CSV"  # a time with every sample: nothing is to be doubted
BY_NETWORKS = ("ITACA cor.acc", "ESM/ITACA DYNA", "AFAD")  # whose instruments sample at most at 1000 Hz
FINE = 0.0009  # s
DISTANCE = Term("the distance")

BOUNDS = (
    ("earthquake", "latitude", Term("the latitude of the epicentre"), -90.0, 90.0, "degrees"),
    ("earthquake", "longitude", Term("the longitude of the epicentre"), -180.0, 360.0, "degrees"),
    ("earthquake", "magnitude", Term("the magnitude"), -3.0, 10.0, "ratio"),
    ("earthquake", "depth", Term("the depth of the earthquake"), -10e3, 800e3, "distance"),
    ("site", "latitude", Term("the latitude of the station"), -90.0, 90.0, "degrees"),
    ("site", "longitude", Term("the longitude of the station"), -180.0, 360.0, "degrees"),
    ("site", "elevation", Term("the elevation of the station"), -12e3, 9e3, "length"),
    ("site", "vs30", Term("vs30"), 1.0, 10e3, "velocity"),
)
"""What a header says of the earthquake and of the site, its name, the least and the most that it can be, and of what
dimension."""
FARTHEST = 20_100e3  # m, half of the earth's girth


def record_warning(record: Record) -> str:
    """Return one English line about what is odd in the record; "" where nothing is."""
    text = "; ".join(each.text for each in implausibility_warnings(record))
    return f"{record.id}: {text}" if text else ""


def implausibility_warnings(record: Record) -> tuple[Message, ...]:
    """Return what is odd in the record.

    What its file contradicts; a peak above 3 g or below 1e-5 g, with the unit that is likely meant; a step at which its
    motion is slower or faster than earthquakes are; a peak that comes before or long after waves can; places,
    magnitudes and the like that are impossible.

    Parameters
    ----------
    record : as read
    """
    warnings = (
        *record.warnings,
        _peak_warning(record.pga, _read_value(record, "unit")),
        _step_warning(record),
        _arrival_warning(record),
        *_impossible_values(record),
    )
    return tuple(each for each in warnings if each is not None)


def warnings_among(records: Sequence[Record]) -> Iterator[Message]:
    """Yield a warning for each recording of one station and earthquake whose components have different steps."""
    known = [each for each in records if each.station and each.earthquake.time]
    for _, group in groupby(sorted(known, key=_recording), key=_recording):
        first, *others = group
        other = next((each for each in others if abs(each.dt - first.dt) > 1e-3 * first.dt), None)
        if other is not None:
            steps = {"step": Quantity(first.dt, "time", 6), "other_step": Quantity(other.dt, "time", 6)}
            yield warning("of-record", record=first.id, what=warning("step-other", other=other.id, **steps))


def candidate_warning(candidate: Candidate) -> str:
    """Return a line about the peak of a record of a catalogue, which does not keep its unit; "" where it is not odd."""
    warning_on_peak = _peak_warning(candidate.measures["pga"], "")
    return "" if warning_on_peak is None else f"{candidate.path}: {warning_on_peak}"


def _recording(record: Record) -> tuple[str, str, str]:
    """Return what the components of one recording have in common."""
    return record.station, record.event, record.earthquake.time


def _read_value(record: Record, name: str) -> str:
    """Return the format or the unit in which a record was read; "" where its first step does not say."""
    first = next(iter(record.processing_history), "")
    return str(first.values.get(name, "")) if isinstance(first, Message) else ""


def _step_warning(record: Record) -> Message | None:
    """Return a warning about a step at which the motion has no frequencies of an earthquake.

    Of 210 real records none gets one. With a step ten times too long 99 % do, with one ten times too short two thirds;
    a factor of two cannot be seen from the motion.
    """
    format_name = _read_value(record, "format")
    if record.artificial or not record.processing_history or format_name == BY_SAMPLE:
        return None
    if record.dt < FINE and format_name in BY_NETWORKS:
        return warning("step-fine", step=Quantity(record.dt, "time", 6))
    power = np.abs(np.fft.rfft(record.acceleration - np.mean(record.acceleration))) ** 2
    cumulative = np.cumsum(power)
    if not cumulative[-1] > 0.0:
        return None
    half, most = (
        np.searchsorted(cumulative, share * cumulative[-1]) / (record.npts * record.dt) for share in (0.5, 0.95)
    )
    return _frequency_warning(record.dt, float(half), float(most))


def _frequency_warning(dt: float, half: float, most: float) -> Message | None:
    """Return a warning from the frequencies [Hz] below which half and 95 % of the power lie at a step [s]."""
    step = Quantity(dt, "time", 6)
    if dt > COARSE and most < SLOW:
        return warning("step-slow", step=step, frequency=Quantity(most, "frequency", 3))
    if half > FAST:
        return warning("step-fast", step=step, frequency=Quantity(half, "frequency", 3))
    return None


def _impossible_values(record: Record) -> Iterator[Message]:
    """Yield a warning for each impossible number about the earthquake and the site."""
    known = [(what, getattr(getattr(record, of), key), *limits) for of, key, what, *limits in BOUNDS]
    for what, value, least, most, dimension in (*known, (DISTANCE, record.distance, 0.0, FARTHEST, "distance")):
        if value is not None and not least <= value <= most:
            yield warning("impossible-in-header", what=what, value=_header_value(value, dimension))


def _header_value(value: float, dimension: str) -> Value:
    return f"{value:.6g}°" if dimension == "degrees" else Quantity(value, dimension, 6)


def _peak_warning(pga: float, unit: str) -> Message | None:
    """Return a warning about a peak [m/s2] that is hardly one; unit : in which the file was read, "" if not known."""
    if LEAST_PEAK * g <= pga <= LARGEST_PEAK * g:
        return None
    limit = LARGEST_PEAK if pga > LARGEST_PEAK * g else LEAST_PEAK
    key, likely = "peak-large" if pga > LARGEST_PEAK * g else "peak-small", _likely_unit(pga, unit)
    values: dict[str, Value] = {"peak": _in_g(pga, 4), "limit": _in_g(limit * g, 4)}
    if likely is None:
        return warning(key, **values)
    meant = _in_g(pga / factor_of(unit.rstrip(";,"), known=ACCELERATION_UNITS) * ACCELERATION_UNITS[likely], 3)
    return warning(f"{key}-in-unit", unit=unit, likely=likely, meant=meant, **values)


def _in_g(acceleration: float, figures: int) -> Quantity:
    return Quantity(acceleration / g, "ground acceleration", figures)


def _likely_unit(pga: float, unit: str) -> str | None:
    """Return the unit in which the numbers of the file, read in `unit`, come nearest to a usual peak, if another."""
    try:
        peak = pga / factor_of(unit.rstrip(";,"), known=ACCELERATION_UNITS)
    except ColumnError:
        return None
    likely = min(ACCELERATION_UNITS, key=lambda one: abs(log(peak * ACCELERATION_UNITS[one] / (USUAL * g))))
    return None if peak * ACCELERATION_UNITS[likely] == pga else likely


EARTH = 6_371_000.0  # m, mean radius
FASTEST, SLOWEST = 8_500.0, 500.0  # m/s, of P waves below the crust and of surface waves in soft basins
CLOCK, RUPTURE = 5.0, 60.0  # s, of clocks and origins, and of how long the source of a large earthquake lasts


def _arrival_warning(record: Record) -> Message | None:
    """Return a warning where the peak comes earlier or later after the earthquake's origin than waves take."""
    origin, start, distance = _instant(record.earthquake.time), _instant(record.start), _distance(record)
    if origin is None or start is None or distance is None:
        return None
    after = (start - origin).total_seconds() + record.dt * int(np.argmax(np.abs(record.acceleration)))
    earliest = hypot(distance, record.earthquake.depth or 0.0) / FASTEST - CLOCK
    latest = distance / SLOWEST + RUPTURE + CLOCK
    if earliest <= after <= latest:
        return None
    return warning(
        "peak-time",
        after=Quantity(after, "time"),
        distance=Quantity(distance, "distance"),
        earliest=Quantity(max(earliest, 0.0), "time", 3),
        latest=Quantity(latest, "time", 3),
    )


def _distance(record: Record) -> float | None:
    """Return the distance of the site from the epicentre [m], as given or by the two places; None where unknown."""
    if record.distance is not None:
        return record.distance
    places = (record.earthquake.latitude, record.earthquake.longitude, record.site.latitude, record.site.longitude)
    known = [radians(each) for each in places if each is not None]
    if len(known) < len(places):
        return None
    lat, lon, site_lat, site_lon = known
    half = sin((site_lat - lat) / 2.0) ** 2 + cos(lat) * cos(site_lat) * sin((site_lon - lon) / 2.0) ** 2
    return 2.0 * EARTH * asin(sqrt(min(half, 1.0)))  # haversine


def _instant(text: str) -> datetime | None:
    """Return a time of ISO 8601 with its hour; None for a date alone, or nothing."""
    try:
        return datetime.fromisoformat(text) if "T" in text else None
    except ValueError:
        return None
