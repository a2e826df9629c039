"""A suite of scaled records as codes look at it, and one requirement on it: the number found, its limit, whether it is
met.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from math import inf
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from records.record import Record
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

DAMPING = 0.05
FINE: FloatArray = np.geomspace(0.02, 10.0, 271)  # s, a hundred to the decade from 50 Hz to 0.1 Hz
FINE.flags.writeable = False


@dataclass(frozen=True)
class Suite:
    """Scaled records and their target, 5 % damping.

    period [k] [s]; target [k], spectra [n, k]: pseudo-acceleration [m/s2]; target_pga, pga [n] [m/s2]; factor [n]: that
    the records were scaled by; dt, duration [n] [s]
    artificial [n] : which of the records were made; stationary [n] : how long their envelope is level, 0 of others [s]
    usable [n] : longest period that the source's processing left usable, infinite where it does not say [s]
    """

    period: FloatArray
    target: FloatArray
    spectra: FloatArray
    target_pga: float
    pga: FloatArray
    factor: FloatArray
    dt: FloatArray
    duration: FloatArray
    artificial: NDArray[np.bool_]
    stationary: FloatArray
    usable: FloatArray

    @property
    def count(self) -> int:
        """Number of records."""
        return int(self.spectra.shape[0])

    @property
    def mean(self) -> FloatArray:
        """Arithmetic mean of the spectra [k] [m/s2]."""
        return np.asarray(self.spectra.mean(axis=0), dtype=np.float64)

    @property
    def period_range(self) -> tuple[float, float]:
        """Shortest and longest period [s]."""
        return float(self.period[0]), float(self.period[-1])


def suite_of(records: Sequence[Record], factors: Sequence[float], spectrum: Spectrum) -> Suite:
    """Set the spectra of scaled records beside their target.

    Parameters
    ----------
    records : before scaling [n]
    factors : scale factor of each [n] [-]
    spectrum : target, 5 % damping
    """
    end = min(float(FINE[-1]), spectrum.longest_period)
    period = np.append(FINE[end > FINE], end)
    spectra = [f * response_spectrum(r, period, damping=DAMPING) for r, f in zip(records, factors, strict=True)]
    return Suite(
        period=period,
        target=spectrum.acceleration(period, damping=DAMPING),
        spectra=np.array(spectra).reshape(len(records), period.size),
        target_pga=spectrum.pga,
        pga=np.array([f * record.pga for record, f in zip(records, factors, strict=True)]),
        factor=np.array(factors, dtype=np.float64),
        dt=np.array([record.dt for record in records]),
        duration=np.array([record.dt * (record.npts - 1) for record in records]),
        artificial=np.array([record.artificial for record in records], dtype=np.bool_),
        stationary=np.array([record.stationary or 0.0 for record in records]),
        usable=np.array([record.longest_period or np.inf for record in records]),
    )


RequirementVerdict = Literal["met", "not met", "not answered"]
Sense = Literal[">=", "<="]
CAVEAT = "from memory, not checked against the printed standard"


class RequirementKind(StrEnum):
    """What a requirement is about."""

    COUNT = "count"
    STEP = "step"
    DURATION = "duration"
    STATIONARY = "stationary"
    USABLE = "usable"
    MEAN_LOW = "mean-low"
    MEAN_HIGH = "mean-high"
    RUN_BELOW = "run-below"
    PEAK = "peak"
    FACTOR = "factor"
    FIT = "fit"
    IN_USE = "in-use"


@dataclass(frozen=True)
class Requirement:
    """One line of a code.

    value, limit : in `unit`, None where not answered; sense : how the value has to compare with the limit
    factors : on every record, the least and the largest with which it is met; (0, inf) where no factor changes it
    periods : range that the value was taken over [s], None where it is not of a spectrum
    remark : a note for the reader, in English; note : its fixed part
    factor : the further factor on every record that would do, where it is not met; else None
    known : the range over which the target is known [s], where it is not answered; else None
    caveat : how far the clause is verified
    """

    code: str
    clause: str
    kind: RequirementKind
    what: str
    value: float | None
    sense: Sense
    limit: float
    unit: str
    verdict: RequirementVerdict
    periods: tuple[float, float] | None = None
    remark: str = ""
    caveat: str = CAVEAT
    factors: tuple[float, float] = (0.0, inf)
    note: str = ""
    factor: float | None = None
    known: tuple[float, float] | None = None


def check_limit(
    code: str,
    clause: str,
    kind: RequirementKind,
    what: str,
    value: float,
    sense: Sense,
    limit: float,
    *,
    unit: str = "-",
    periods: tuple[float, float] | None = None,
    remark: str = "",
) -> Requirement:
    """Compare `value` with `limit`: the requirement is met if the value is in `sense` of it."""
    met = value >= limit * (1 - 1e-12) if sense == ">=" else value <= limit * (1 + 1e-12)
    verdict: RequirementVerdict = "met" if met else "not met"
    return Requirement(
        code, clause, kind, what, float(value), sense, limit, unit, verdict, periods, remark, note=remark
    )


def unanswered_requirement(
    code: str,
    clause: str,
    kind: RequirementKind,
    what: str,
    sense: Sense,
    limit: float,
    periods: tuple[float, float],
    suite: Suite,
) -> Requirement:
    """Return a requirement that cannot be checked, as the target or the records do not cover its range of periods."""
    low, high = suite.period_range
    remark = f"the target is known from {low:.3g} to {high:.4g} s only"
    return Requirement(
        code, clause, kind, what, None, sense, limit, "-", "not answered", periods, remark, known=(low, high)
    )


def mean_at_least(
    suite: Suite, code: str, clause: str, *, share: float, periods: tuple[float, float], remark: str = ""
) -> Requirement:
    """Require that the mean spectrum nowhere in the range falls below `share` of the target."""
    what, ratio = "least ratio of mean spectrum to target", mean_ratio(suite, periods)
    if ratio is None:
        return unanswered_requirement(code, clause, RequirementKind.MEAN_LOW, what, ">=", share, periods, suite)
    least = float(ratio.min())
    found = check_limit(
        code, clause, RequirementKind.MEAN_LOW, what, least, ">=", share, periods=periods, remark=remark
    )
    return with_least_factor(found, share / least)


def mean_at_most(
    suite: Suite, code: str, clause: str, *, share: float, periods: tuple[float, float], remark: str = ""
) -> Requirement:
    """Require that the mean spectrum nowhere in the range exceeds `share` of the target."""
    what, ratio = "largest ratio of mean spectrum to target", mean_ratio(suite, periods)
    if ratio is None:
        return unanswered_requirement(code, clause, RequirementKind.MEAN_HIGH, what, "<=", share, periods, suite)
    most = float(ratio.max())
    found = check_limit(
        code, clause, RequirementKind.MEAN_HIGH, what, most, "<=", share, periods=periods, remark=remark
    )
    return _with_largest_factor(found, share / most)


def usable_to(suite: Suite, code: str, clause: str, *, longest: float) -> tuple[Requirement, ...]:
    """Require that every record is usable up to the longest period [s]; none where no source states its limit."""
    what, least = "longest usable period of the records", float(suite.usable.min())
    return (
        (check_limit(code, clause, RequirementKind.USABLE, what, least, ">=", longest, unit="s"),)
        if least < inf
        else ()
    )


def common_factor(found: Iterable[Requirement]) -> float | None:
    """Find the further factor on every record, nearest to 1, with which all are met that a factor can meet.

    None where there is none: the mean spectrum has another shape than the target.
    """
    every = tuple(found)
    least, most = max(one.factors[0] for one in every), min(one.factors[1] for one in every)
    return min(max(1.0, least), most) if least <= most else None


def with_least_factor(one: Requirement, factor: float) -> Requirement:
    """Add the further factor on every record from which on a requirement is met."""
    return replace(one, factors=(factor, inf), remark=_remark_with(one, factor), factor=_needed(one, factor))


def mean_ratio(suite: Suite, periods: tuple[float, float]) -> FloatArray | None:
    """Return mean spectrum over target at the periods of the range, ends included; None where it is not all covered."""
    low, high = suite.period_range
    if not low * (1 - 1e-9) <= periods[0] <= periods[1] <= high * (1 + 1e-9):
        return None
    inside = (suite.period > periods[0]) & (suite.period < periods[1])
    at = np.concatenate([[periods[0]], suite.period[inside], [periods[1]]])
    return np.asarray(np.interp(np.log(at), np.log(suite.period), suite.mean / suite.target), dtype=np.float64)


def _with_largest_factor(one: Requirement, factor: float) -> Requirement:
    """Add the further factor on every record up to which a requirement is met."""
    return replace(one, factors=(0.0, factor), remark=_remark_with(one, factor), factor=_needed(one, factor))


def _needed(one: Requirement, factor: float) -> float | None:
    return factor if one.verdict == "not met" else None


def _remark_with(one: Requirement, factor: float) -> str:
    would = f"a further factor of {factor:.4g} on every record would do" if one.verdict == "not met" else ""
    return "; ".join(filter(None, (would, one.remark)))
