"""Measures of the intensity of ground motions, of the motion of the ground or of that at the base of a mechanism.

All are proportional to the scale factor of the record: they are computed once, at scale 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import tan

import numpy as np
from scipy.constants import g

from assess.results.fragility import MeasureResult
from assess.short_repr import ShortRepr
from assess.study.fragility.question import AVERAGE_PERIODS
from records.intensity import pgv
from records.record import Record
from records.response import response_spectrum
from spectra.arrays import FloatArray

DIMENSIONS: Mapping[str, str] = {
    "pga": "ground acceleration",
    "pgv": "velocity",
    "sa": "ground acceleration",
    "sa-average": "ground acceleration",
    "pga/(g tan alpha)": "ratio",
    "p pgv/(g tan alpha)": "ratio",
}
DAMPING = 0.05


@dataclass(frozen=True, repr=False)
class Rocker(ShortRepr):
    """What measures need to know of a mechanism: slenderness alpha [rad] and frequency parameter p [1/s]."""

    slenderness: float
    p: float


def measure(key: str, periods: Sequence[float] = ()) -> MeasureResult:
    """Return a measure of the motion of the ground.

    Parameters
    ----------
    key : of `DIMENSIONS`
    periods : of "sa" one, of "sa-average" those that are averaged [s]; for the latter a default where none are given
    """
    used = tuple(periods) or (AVERAGE_PERIODS if key == "sa-average" else ())
    return MeasureResult(key, DIMENSIONS[key], "ground", used)


def default_measures(period: float | None) -> tuple[MeasureResult, ...]:
    """Return all measures that apply; Sa only at the period of the building [s], which is None where there is none."""
    own = () if period is None else (measure("sa", (period,)),)
    named = (measure(key) for key in ("pgv", "sa-average", "pga/(g tan alpha)", "p pgv/(g tan alpha)"))
    return (measure("pga"), *own, *named)


def at_base(measures: Sequence[MeasureResult]) -> tuple[MeasureResult, ...]:
    """Return the same measures of the motion at the base of a mechanism."""
    return tuple(replace(each, at="base") for each in measures)


def intensities(wanted: MeasureResult, records: Sequence[Record], rocker: Rocker) -> FloatArray:
    """Return the intensity of each record at scale 1, in the unit of the measure [records].

    Parameters
    ----------
    wanted : the measure
    records : at the place that it measures
    rocker : the mechanism, for measures that depend on it
    """
    return np.array([_VALUES[wanted.key](record, wanted, rocker) for record in records])


def _pga(record: Record, _: MeasureResult, __: Rocker) -> float:
    return record.pga / g


def _pgv(record: Record, _: MeasureResult, __: Rocker) -> float:
    return pgv(record)


def _mean_spectral(record: Record, wanted: MeasureResult, _: Rocker) -> float:
    """Return the geometric mean of the 5 % pseudo-acceleration over the periods [g].

    Source: Eads, Miranda & Lignos (2015), Earthquake Eng. Struct. Dyn. 44, 2057-2073, eq. 3.
    """
    S_a = response_spectrum(record, np.array(wanted.periods_s), damping=DAMPING)
    return float(np.exp(np.mean(np.log(S_a)))) / g


def _pga_over_uplift(record: Record, _: MeasureResult, rocker: Rocker) -> float:
    return record.pga / (g * tan(rocker.slenderness))


def _pgv_over_impulse(record: Record, _: MeasureResult, rocker: Rocker) -> float:
    """Return p PGV / (g tan alpha), 1 for the impulse that just overturns a slender block.

    Source: Dimitrakopoulos & Paraskeva (2015), Earthquake Eng. Struct. Dyn. 44, 2015-2033.
    """
    return rocker.p * pgv(record) / (g * tan(rocker.slenderness))


_VALUES: Mapping[str, Callable[[Record, MeasureResult, Rocker], float]] = {
    "pga": _pga,
    "pgv": _pgv,
    "sa": _mean_spectral,
    "sa-average": _mean_spectral,
    "pga/(g tan alpha)": _pga_over_uplift,
    "p pgv/(g tan alpha)": _pgv_over_impulse,
}
