"""Plausibility of a record: whether it can be ground motion, or its unit or step was misread."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby
from math import log

import numpy as np
from scipy.constants import g

from records.arrival import arrival_warning
from records.candidates import Candidate
from records.record import Record
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

LARGEST = 3.0  # g; the strongest recorded so far have reached 2.7 g (horizontal) to 3.9 g (vertical, Iwate-Miyagi 2008)
LEAST = 1e-5  # g; far below what a body that rocks can feel
USUAL = 0.1  # g
READ_IN = re.compile(r"\bunit (\S+)")
COARSE = 0.022  # s; instruments sample 50 times a second and more
SLOW, FAST = 2.5, 22.0  # Hz; no real record has 95 % of its power below SLOW at a COARSE step, or half above FAST
BY_SAMPLE = "read from CSV"  # a time with every sample: nothing is to be doubted
BY_NETWORKS = ("read from ITACA", "read from ESM", "read from AFAD")  # whose instruments sample at most at 1000 Hz
FINE = 0.0009  # s
BOUNDS = (
    ("earthquake", "latitude", "the latitude of the epicentre", -90.0, 90.0, " degrees"),
    ("earthquake", "longitude", "the longitude of the epicentre", -180.0, 360.0, " degrees"),
    ("earthquake", "magnitude", "the magnitude", -3.0, 10.0, ""),
    ("earthquake", "depth", "the depth of the earthquake", -10e3, 800e3, " m"),
    ("site", "latitude", "the latitude of the station", -90.0, 90.0, " degrees"),
    ("site", "longitude", "the longitude of the station", -180.0, 360.0, " degrees"),
    ("site", "elevation", "the elevation of the station", -12e3, 9e3, " m"),
    ("site", "vs30", "vs30", 1.0, 10e3, " m/s"),
)
"""What a header says of the earthquake and of the site, its name, the least and the most that it can be, its unit."""
FARTHEST = 20_100e3  # m, half of the earth's girth


def record_warning(record: Record) -> str:
    """Return one line about what is odd in the record; "" where nothing is.

    What its file contradicts; a peak above 3 g or below 1e-5 g, with the unit that is likely meant; a step at which its
    motion is slower or faster than earthquakes are; a peak that comes before or long after waves can; places,
    magnitudes and the like that are impossible.
    """
    texts = [*record.warnings, _of_peak(record), _of_step(record), arrival_warning(record), *_of_origin(record)]
    text = "; ".join(text for text in texts if text)
    return f"{record.id}: {text}" if text else ""


def warnings_among(records: Sequence[Record]) -> Iterator[str]:
    """Yield a line for each recording of one station and earthquake whose components have different steps."""
    known = [one for one in records if one.station and one.earthquake.time]
    for _, group in groupby(sorted(known, key=_recording), key=_recording):
        first, *others = group
        other = next((one for one in others if abs(one.dt - first.dt) > 1e-3 * first.dt), None)
        if other is not None:
            yield f"{first.id}: {_of_steps(first.dt, other.id, other.dt)}"


def candidate_warning(one: Candidate) -> str:
    """Return the same for a record of a catalogue, which does not keep the unit it was read in."""
    texts = _peak_warning(one.measures["pga"])
    return f"{one.path}: {texts}" if texts else ""


def _recording(record: Record) -> tuple[str, str, str]:
    return record.station, record.event, record.earthquake.time


def _of_steps(step: float, other: str, its: float) -> str:
    return (
        f"its step is {step:.6g} s, that of {other}, of the same station and earthquake, {its:.6g} s; check the steps"
    )


def _of_peak(record: Record) -> str:
    texts = _peak_warning(record.pga)
    unit = next((found[1] for step in record.processing_history if (found := READ_IN.search(step))), "")
    return f"{texts}{_likely(record.pga, unit)}" if texts else ""


def _of_step(record: Record) -> str:
    """Return a warning about a step at which the motion has no frequencies of an earthquake.

    Of 210 real records none gets one. With a step ten times too long 99 % do, with one ten times too short two thirds;
    a factor of two cannot be seen from the motion.
    """
    if record.artificial or not record.processing_history or record.processing_history[0].startswith(BY_SAMPLE):
        return ""
    if record.dt < FINE and record.processing_history[0].startswith(BY_NETWORKS):
        return f"a step of {record.dt:.6g} s is finer than instruments of its network have; check the step"
    power = np.abs(np.fft.rfft(record.acceleration - np.mean(record.acceleration))) ** 2
    share = np.cumsum(power)
    if not share[-1] > 0.0:
        return ""
    half, most = (np.searchsorted(share, part * share[-1]) / (record.npts * record.dt) for part in (0.5, 0.95))
    return _of_frequencies(record.dt, float(half), float(most))


def _of_frequencies(dt: float, half: float, most: float) -> str:
    """Return a warning from the frequencies [Hz] below which half and 95 % of the power lie at a step [s]."""
    if dt > COARSE and most < SLOW:
        return (
            f"with a step of {dt:.6g} s its motion stays below {most:.3g} Hz, slower than earthquakes; check the step"
        )
    if half > FAST:
        return f"with a step of {dt:.6g} s half of it is above {half:.3g} Hz, faster than earthquakes; check the step"
    return ""


def _of_origin(record: Record) -> Iterator[str]:
    """Yield a warning for each impossible number about the earthquake and the site."""
    known = [(what, getattr(getattr(record, of), key), *limits) for of, key, what, *limits in BOUNDS]
    for what, value, least, most, unit in (*known, ("the distance", record.distance, 0.0, FARTHEST, " m")):
        if value is not None and not least <= value <= most:
            yield _impossible(what, f"{value:.6g}{unit}")


def _impossible(what: str, value: str) -> str:
    return f"{what} is {value} in its header, which cannot be; the header is damaged"


def _peak_warning(pga: float) -> str:
    if LEAST * g <= pga <= LARGEST * g:
        return ""
    bound = f"above {LARGEST:g} g, as hardly any earthquake reaches" if pga > LARGEST * g else f"below {LEAST:g} g"
    return f"its peak is {pga / g:.4g} g, {bound}; check the unit"


def _likely(pga: float, unit: str) -> str:
    """Return the unit in which the numbers of the file, read in `unit`, come nearest to a usual peak."""
    try:
        peak = pga / factor_of(unit.rstrip(";,"), known=ACCELERATION_UNITS)
    except ColumnError:
        return ""
    likely = min(ACCELERATION_UNITS, key=lambda one: abs(log(peak * ACCELERATION_UNITS[one] / (USUAL * g))))
    meant = peak * ACCELERATION_UNITS[likely]
    return "" if meant == pga else f" (read in {unit}; in {likely} it would be {meant / g:.3g} g)"
