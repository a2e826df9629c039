"""One requirement of a code on a suite of records: the number found, its limit, and whether it is met."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import StrEnum
from math import inf
from typing import Literal

import numpy as np

from records.compliance.suite import Suite
from spectra.arrays import FloatArray

Verdict = Literal["met", "not met", "not answered"]
Sense = Literal[">=", "<="]

CAVEAT = "from memory, not checked against the printed standard"


class Rule(StrEnum):
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
    rule: Rule
    what: str
    value: float | None
    sense: Sense
    limit: float
    unit: str
    verdict: Verdict
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
    rule: Rule,
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
    verdict: Verdict = "met" if met else "not met"
    return Requirement(
        code, clause, rule, what, float(value), sense, limit, unit, verdict, periods, remark, note=remark
    )


def no_answer(
    code: str,
    clause: str,
    rule: Rule,
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
        code, clause, rule, what, None, sense, limit, "-", "not answered", periods, remark, known=(low, high)
    )


def mean_at_least(
    suite: Suite, code: str, clause: str, *, share: float, periods: tuple[float, float], remark: str = ""
) -> Requirement:
    """Require that the mean spectrum nowhere in the range falls below `share` of the target."""
    what, ratio = "least ratio of mean spectrum to target", mean_ratio(suite, periods)
    if ratio is None:
        return no_answer(code, clause, Rule.MEAN_LOW, what, ">=", share, periods, suite)
    least = float(ratio.min())
    found = check_limit(code, clause, Rule.MEAN_LOW, what, least, ">=", share, periods=periods, remark=remark)
    return with_least_factor(found, share / least)


def mean_at_most(
    suite: Suite, code: str, clause: str, *, share: float, periods: tuple[float, float], remark: str = ""
) -> Requirement:
    """Require that the mean spectrum nowhere in the range exceeds `share` of the target."""
    what, ratio = "largest ratio of mean spectrum to target", mean_ratio(suite, periods)
    if ratio is None:
        return no_answer(code, clause, Rule.MEAN_HIGH, what, "<=", share, periods, suite)
    most = float(ratio.max())
    found = check_limit(code, clause, Rule.MEAN_HIGH, what, most, "<=", share, periods=periods, remark=remark)
    return with_largest_factor(found, share / most)


def usable_to(suite: Suite, code: str, clause: str, *, longest: float) -> tuple[Requirement, ...]:
    """Require that every record is usable up to the longest period [s]; none where no source states its limit."""
    what, least = "longest usable period of the records", float(suite.usable.min())
    return (check_limit(code, clause, Rule.USABLE, what, least, ">=", longest, unit="s"),) if least < inf else ()


def factor_that_does(found: Iterable[Requirement]) -> float | None:
    """Find the further factor on every record, nearest to 1, with which all are met that a factor can meet.

    None where there is none: the mean spectrum has another shape than the target.
    """
    every = tuple(found)
    least, most = max(one.factors[0] for one in every), min(one.factors[1] for one in every)
    return min(max(1.0, least), most) if least <= most else None


def with_least_factor(one: Requirement, factor: float) -> Requirement:
    """Add the further factor on every record from which on a requirement is met."""
    return replace(one, factors=(factor, inf), remark=_with(one, factor), factor=_needed(one, factor))


def with_largest_factor(one: Requirement, factor: float) -> Requirement:
    """Add the further factor on every record up to which a requirement is met."""
    return replace(one, factors=(0.0, factor), remark=_with(one, factor), factor=_needed(one, factor))


def _needed(one: Requirement, factor: float) -> float | None:
    return factor if one.verdict == "not met" else None


def _with(one: Requirement, factor: float) -> str:
    would = f"a further factor of {factor:.4g} on every record would do" if one.verdict == "not met" else ""
    return "; ".join(filter(None, (would, one.remark)))


def mean_ratio(suite: Suite, periods: tuple[float, float]) -> FloatArray | None:
    """Return mean spectrum over target at the periods of the range, ends included; None where it is not all covered."""
    low, high = suite.period_range
    if not low * (1 - 1e-9) <= periods[0] <= periods[1] <= high * (1 + 1e-9):
        return None
    inside = (suite.period > periods[0]) & (suite.period < periods[1])
    at = np.concatenate([[periods[0]], suite.period[inside], [periods[1]]])
    return np.asarray(np.interp(np.log(at), np.log(suite.period), suite.mean / suite.target), dtype=np.float64)
