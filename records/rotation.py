"""Two horizontal components turned: to an azimuth, and to the median and the largest over all directions."""

from __future__ import annotations

from dataclasses import replace
from math import cos, degrees, isfinite, pi, sin

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq

from assess.messages.message import Quantity, Value, note
from records.errors import RecordError
from records.record import Record, make_record, with_step
from records.response import response_spectrum
from spectra.arrays import FloatArray

ANGLES: FloatArray = np.radians(np.arange(180.0))  # the half turn that is all, since the sign does not count
LEAST_ANGLE = pi / 18.0  # between two components that are solved for north and east
COINCIDE = 1e-6  # relative difference of steps that are one


def rotate_to_azimuth(first: Record, second: Record, *, azimuth: float) -> Record:
    """Return the motion of two horizontal components in one direction; both begin together, the longer is cut.

    Parameters
    ----------
    first, second : components with known azimuths, at least 10 degrees apart
    azimuth : direction, clockwise from north [rad]

    Raises
    ------
    RecordError : an azimuth is unknown, the steps differ, or the components are less than 10 degrees apart
    """
    if not isfinite(azimuth):
        raise RecordError(f'records "{first.id}" and "{second.id}": azimuth {azimuth} to turn to; it must be finite')
    a, b = _side_by_side(first, second)
    one, two = _azimuths(first, second)
    across = sin(two - one)
    if abs(across) < sin(LEAST_ANGLE):
        raise RecordError(
            f'records "{first.id}" and "{second.id}": azimuths {degrees(one):.4g} and {degrees(two):.4g} deg; '
            "two components at least 10 deg apart are needed"
        )
    turned = a * (sin(two - azimuth) / across) + b * (sin(azimuth - one) / across)
    return _turned(first, second, turned, name=f"{degrees(azimuth):.6g}", azimuth=azimuth % (2.0 * pi))


def rotd(first: Record, second: Record, *, percentile: float) -> Record:
    """Return the motion in a direction whose peak is a percentile of the peaks of all directions.

    50 is RotD50 and 100 RotD100 of the peak acceleration. The percentile is that of directions every degree over half a
    turn; the direction itself may lie between them.

    Parameters
    ----------
    first, second : perpendicular horizontal components
    percentile : 0 to 100

    Raises
    ------
    RecordError : the percentile is outside 0 to 100, the steps differ, or the components are not perpendicular

    Source: Boore (2010), BSSA 100, 1830-1835.
    """
    a, b = _perpendicular(first, second)
    angle = _angle(a, b, _checked(percentile))
    turned = a * cos(angle) + b * sin(angle)
    return _turned(first, second, turned, name=f"RotD{percentile:g}", azimuth=_azimuth_at(first, second, angle))


def rotd_spectrum(
    first: Record, second: Record, period: ArrayLike, *, percentile: float, damping: float = 0.05
) -> FloatArray:
    """Return the `percentile` over all directions of the pseudo-acceleration [m/s2] at each `period` [s] (same shape).

    As `rotd`, period by period. Source: Boore (2010), BSSA 100, 1830-1835: RotD50 and RotD100.
    """
    a, b = _perpendicular(first, second)
    at = _checked(percentile)
    each = [
        response_spectrum(make_record(first.id, a * cos(angle) + b * sin(angle), first.dt), period, damping=damping)
        for angle in ANGLES
    ]
    return np.asarray(np.percentile(np.array(each), at, axis=0), dtype=np.float64)


def _angle(a: FloatArray, b: FloatArray, percentile: float) -> float:
    """Return the angle [rad] from `a` towards `b` [n] at which the peak is the `percentile` of those at ANGLES.

    The peak is a continuous function of the angle: where it is on either side of the percentile a degree apart, it is
    the percentile between. Of several such angles the one beside which a peak is nearest.
    """

    def beyond(angle: float) -> float:
        return float(np.max(np.abs(a * cos(angle) + b * sin(angle)))) - wanted

    wanted = 0.0
    peaks = np.array([beyond(angle) for angle in ANGLES])
    wanted = float(np.percentile(peaks, percentile))
    off = np.abs(np.append(peaks, peaks[0]) - wanted)
    if not off.min() > 0.0:
        return float(ANGLES[int(np.argmin(off[:-1]))])
    above = np.append(peaks, peaks[0]) > wanted
    between = np.flatnonzero(above[1:] != above[:-1])
    at = between[np.argmin(np.minimum(off[between], off[between + 1]))]
    return float(brentq(beyond, ANGLES[at], ANGLES[at] + pi / 180.0, xtol=1e-14))


def _side_by_side(first: Record, second: Record) -> tuple[FloatArray, FloatArray]:
    """Return both accelerations over the time that they share, of two components of one recording."""
    for what, one, other in (("station", first.station, second.station), ("event", first.event, second.event)):
        if one and other and one != other:
            raise RecordError(
                f'records "{first.id}" and "{second.id}": {what} {one!r} and {other!r}; two components of one '
                "recording are turned together"
            )
    if abs(first.dt / second.dt - 1.0) > COINCIDE:
        raise RecordError(
            f'records "{first.id}" and "{second.id}": steps of {first.dt:.6g} and {second.dt:.6g} s; '
            "resample one to the other's"
        )
    shared = min(first.npts, second.npts)
    return first.acceleration[:shared], second.acceleration[:shared]


def _perpendicular(first: Record, second: Record) -> tuple[FloatArray, FloatArray]:
    """Return both accelerations; refused where the azimuths are known and not a right angle, to 5 degrees, apart."""
    if first.azimuth is not None and second.azimuth is not None:
        apart = first.azimuth - second.azimuth
        if abs(cos(apart)) > sin(pi / 36.0):
            raise RecordError(
                f'records "{first.id}" and "{second.id}": azimuths {degrees(first.azimuth):.4g} and '
                f"{degrees(second.azimuth):.4g} deg; the two components must be perpendicular"
            )
    return _side_by_side(first, second)


def _azimuths(first: Record, second: Record) -> tuple[float, float]:
    for record in (first, second):
        if record.azimuth is None:
            raise RecordError(
                f'record "{record.id}": the azimuth of its component "{record.component}" is not known; '
                "turn by RotD instead, which does not need it"
            )
    return float(first.azimuth or 0.0), float(second.azimuth or 0.0)


def _azimuth_at(first: Record, second: Record, angle: float) -> float | None:
    """Return the azimuth [rad] at `angle` from the first component towards the second."""
    if first.azimuth is None or second.azimuth is None:
        return None
    clockwise = sin(second.azimuth - first.azimuth) > 0.0
    return (first.azimuth + (angle if clockwise else -angle)) % (2.0 * pi)


def _checked(percentile: float) -> float:
    if not 0.0 <= percentile <= 100.0:
        raise RecordError(f"percentile {percentile} over the directions; it must be from 0 to 100")
    return percentile


def _turned(first: Record, second: Record, samples: FloatArray, *, name: str, azimuth: float | None) -> Record:
    """Return what has become of two components, under the names of the first."""
    values: dict[str, Value] = {"component": second.component, "record": second.id, "name": name}
    step = note("turned", **values)
    if azimuth is not None:
        step = note("turned-to", azimuth=Quantity(azimuth, "angle", 6), **values)
    made = make_record(f"{first.id} {name}", samples, first.dt, path=first.path)
    rotated = replace(first, id=made.id, acceleration=made.acceleration, component=name, azimuth=azimuth)
    return with_step(rotated, step)
