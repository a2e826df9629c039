"""What obspy reads: MiniSEED and SAC, in counts of the instrument.

Neither states a unit that can be relied upon (SAC's `idep` is seldom set), so the caller states the unit of the
samples, or gives the instrument's response, which obspy takes off. obspy is imported here alone, and when such a file
is read.
"""

from __future__ import annotations

import re
import struct
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from math import radians
from pathlib import Path
from typing import Any

import numpy as np

from assess.messages.message import Message, note
from records.errors import RecordError
from records.formats.header import GIVE_UNIT, HeaderOverrides
from records.formats.samples import acceleration_factor, number
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record

MINISEED, SAC = "MiniSEED", "SAC"
QUALITIES = b"DRQM"  # of a MiniSEED 2 record
SAC_HEADER = 632  # bytes
SAC_VERSION, SAC_POINTS, SAC_FORM, SAC_EVEN = 76, 79, 85, 105  # words of the header
SAC_UNKNOWN = (-12345.0,)
NOT_ACCELERATION = {6: "displacement", 7: "velocity"}  # SAC idep
DAMAGE = re.compile(r"integrity check|[Ss]kip")  # in what libmseed warns of
SINGLE = 1e-4  # how well a header in single precision fits, of the largest sample or of the time
WATER_LEVEL = 60.0  # dB below the largest response; obspy's default


def looks_like_miniseed(head: bytes) -> bool:
    """Return whether a file that begins with `head` is MiniSEED: six digits and a quality (SEED 2.4), or "MS" and 3."""
    second = len(head) >= 48 and head[:6].isdigit() and head[6:7] in QUALITIES and head[7:8] in (b" ", b"\0")
    return second or head[:3] == b"MS\x03"


def looks_like_sac(head: bytes) -> bool:
    """Return whether a file that begins with `head` is binary SAC of version 6 or 7, points evenly spaced in time."""
    if len(head) < SAC_HEADER:
        return False
    for order in "<>":
        version, points, form, even = (
            struct.unpack_from(f"{order}i", head, 4 * word)[0] for word in (SAC_VERSION, SAC_POINTS, SAC_FORM, SAC_EVEN)
        )
        if version in (6, 7) and points > 0 and form == 1 and even == 1:
            return True
    return False


def read_miniseed(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return every channel in the file at `path`, by the unit or response given.

    Raises RecordError, naming the file, for neither of them, what obspy cannot read, and channels with gaps.
    """
    return _read(path, overrides, form="MSEED", name=MINISEED)


def read_sac(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`, by the unit or response given.

    Raises RecordError, naming the file, for neither of them, what obspy cannot read, and what is not acceleration.
    """
    return _read(path, overrides, form="SAC", name=SAC)


def _read(path: Path, overrides: HeaderOverrides, *, form: str, name: str) -> tuple[Record, ...]:
    if overrides.unit is None and overrides.response is None:
        raise RecordError(
            f"{path}: {name} does not state the unit of its samples; {GIVE_UNIT}, or response (StationXML)"
        )
    import obspy

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            with _raised():
                traces = list(obspy.read(str(path), format=form, check_compression=False))
        except Exception as error:
            raise RecordError(f"{path}: obspy cannot read it as {name}: {_one_line(error)}") from None
        _check_damage([str(warning.message) for warning in caught], path=path)
        _check(traces, path=path)
        response = None if overrides.response is None else _response(obspy, overrides.response)
        return tuple(_record(trace, overrides, response, name=name, path=path) for trace in traces)


@contextmanager
def _raised() -> Iterator[None]:
    """Raises, at the end, what libmseed's callbacks into obspy can only print: text of a header that is no text."""
    found: list[Any] = []
    before, sys.unraisablehook = sys.unraisablehook, found.append
    try:
        yield
    finally:
        sys.unraisablehook = before
    if found:
        raise ValueError(str(found[0].exc_value))


def _check_damage(texts: list[str], *, path: Path) -> None:
    """Refuse what libmseed only warns of: samples that do not end where their block says, bytes that are no block."""
    damage = next((text for text in texts if DAMAGE.search(text)), None)
    if damage is not None:
        text = " ".join(damage.replace("Warning:", "").split())
        raise RecordError(f"{path}: damaged: {text[:120]}; get the file again")


def _check_ends(trace: Any, *, path: Path) -> None:
    """Refuse a SAC file whose extremes, mean or end, where its header knows them, are not those of its samples."""
    span = (trace.stats.npts - 1) * float(trace.stats.delta)
    data = np.asarray(trace.data, dtype=np.float64)
    least, most = (float(data.min()), float(data.max())) if data.size else (0.0, 0.0)
    begin, scale = _number(trace, "b"), max(abs(least), abs(most))
    for key, found, size in (
        ("depmin", least, scale),
        ("depmax", most, scale),
        ("depmen", float(data.mean()) if data.size else 0.0, scale),
        ("e", None if begin is None else begin + span, max(span, abs(begin or 0.0))),
    ):
        known = _number(trace, key)
        if known is not None and found is not None and abs(known - found) > SINGLE * size:
            raise RecordError(
                f"{path}: {key.upper()} of the header is {known:.7g}, its samples give {found:.7g}; get the file "
                "again, or have SAC write it again if it was changed by a program that leaves its header"
            )


def _check(traces: list[Any], *, path: Path) -> None:
    """Refuse no samples, channels in several pieces, a file cut short, and velocities or displacements."""
    if not traces:
        raise RecordError(f"{path}: no samples in the file")
    names = [trace.id for trace in traces]
    broken = next((name for name in names if names.count(name) > 1), None)
    if broken is not None:
        raise RecordError(f"{path}: channel {broken} has gaps; give a file of one piece")
    length = int(traces[0].stats.get("mseed", {}).get("record_length", 1))
    if path.stat().st_size % length:
        raise RecordError(f"{path}: not a whole number of MiniSEED records of {length} bytes; the file is cut short")
    for trace in traces:
        _check_ends(trace, path=path)
        kind = NOT_ACCELERATION.get(int(trace.stats.get("sac", {}).get("idep", 0)))
        if kind:
            raise RecordError(f"{path}: the file says it holds {kind}; give the file of the acceleration")
        if trace.data.ndim != 1 or trace.data.dtype.kind not in "if":
            raise RecordError(f"{path}: channel {trace.id} holds no numbers; it is not a motion")


def _record(trace: Any, overrides: HeaderOverrides, response: Any, *, name: str, path: Path) -> Record:
    """Return one channel in m/s2."""
    if response is None:
        unit = str(overrides.unit)
        factor = acceleration_factor(unit, line=0, path=path)
        acceleration = factor * np.asarray(trace.data, dtype=np.float64)
        history: tuple[Message, ...] = (note("read-from-given", format=name, unit=unit),)
    else:
        acceleration = _without_response(trace, response, path=path)
        file = Path(overrides.response or "").name
        history = (note("read-from-response", format=name, file=file), note("mean-removed"))
    channel = trace.stats.channel
    return make_record(
        f"{path.stem} {trace.id}",
        acceleration,
        float(trace.stats.delta),
        path=str(path),
        event=_text(trace, "kevnm"),
        station=".".join(part for part in (trace.stats.network, trace.stats.station) if part),
        component=channel,
        processing_history=history,
        azimuth=_azimuth(trace, channel),
        distance=None if (km := _number(trace, "dist")) is None else 1000.0 * km,
        earthquake=Earthquake(
            magnitude=_number(trace, "mag"), latitude=_number(trace, "evla"), longitude=_number(trace, "evlo")
        ),
        site=StationSite(
            latitude=_number(trace, "stla"), longitude=_number(trace, "stlo"), elevation=_number(trace, "stel")
        ),
    )


def _response(obspy: Any, path: Path) -> Any:
    """Return the inventory in a file of responses."""
    try:
        return obspy.read_inventory(str(path))
    except OSError as error:
        raise RecordError(f"{path}: the response cannot be read: {error.strerror or _one_line(error)}") from None
    except Exception as error:
        raise RecordError(f"{path}: obspy cannot read the response: {_one_line(error)}; give StationXML") from None


def _without_response(trace: Any, response: Any, *, path: Path) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return accelerations [m/s2]: counts less their mean, divided by the response over all frequencies."""
    plain = trace.copy().detrend("demean")
    try:
        plain.remove_response(inventory=response, output="ACC", water_level=WATER_LEVEL)
    except Exception as error:
        raise RecordError(
            f"{path}: channel {trace.id} at {trace.stats.starttime}: no response fits: {_one_line(error)}"
        ) from None
    return np.asarray(plain.data, dtype=np.float64)


def _azimuth(trace: Any, channel: str) -> float | None:
    """Return SAC's azimuth of a horizontal component, else that of the channel's name."""
    azimuth, incidence = _number(trace, "cmpaz"), _number(trace, "cmpinc")
    if azimuth is not None and incidence == 90.0:
        return radians(azimuth % 360.0)
    return azimuth_of(channel)


def _number(trace: Any, key: str) -> float | None:
    return number(str(trace.stats.get("sac", {}).get(key, "")), unknown=SAC_UNKNOWN)


def _text(trace: Any, key: str) -> str:
    value = str(trace.stats.get("sac", {}).get(key, "")).strip()
    return "" if value.startswith("-12345") else value


def _one_line(error: Exception) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split())[:120]
