"""One requirement of a code on a suite of records: the number found, its limit, and whether it is met."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from records.compliance.suite import FloatArray, Suite

Verdict = Literal["met", "not met", "not answered"]
Sense = Literal[">=", "<="]

CAVEAT = "from memory, not checked against the printed standard"


@dataclass(frozen=True)
class Requirement:
    """One line of a code.

    value, limit : in `unit`, None where not answered; sense : how the value has to stand to the limit
    periods : range that the value was taken over [s], None where it is not of a spectrum
    remark : what the reader should know; caveat : what the clause could not be compared with
    """

    code: str
    clause: str
    what: str
    value: float | None
    sense: Sense
    limit: float
    unit: str
    verdict: Verdict
    periods: tuple[float, float] | None = None
    remark: str = ""
    caveat: str = CAVEAT


def required(
    code: str,
    clause: str,
    what: str,
    value: float,
    sense: Sense,
    limit: float,
    *,
    unit: str = "-",
    periods: tuple[float, float] | None = None,
    remark: str = "",
) -> Requirement:
    """The requirement that `value` stands in `sense` to `limit`."""
    met = value >= limit * (1 - 1e-12) if sense == ">=" else value <= limit * (1 + 1e-12)
    verdict: Verdict = "met" if met else "not met"
    return Requirement(code, clause, what, float(value), sense, limit, unit, verdict, periods, remark)


def not_answered(
    code: str, clause: str, what: str, sense: Sense, limit: float, periods: tuple[float, float], *, suite: Suite
) -> Requirement:
    """A requirement on a range of periods that the target or the records do not cover."""
    low, high = suite.covered
    remark = f"the target is known from {low:.3g} to {high:.4g} s only"
    return Requirement(code, clause, what, None, sense, limit, "-", "not answered", periods, remark)


def mean_at_least(
    suite: Suite, code: str, clause: str, *, share: float, periods: tuple[float, float], remark: str = ""
) -> Requirement:
    """That the mean spectrum nowhere in the range falls below `share` of the target."""
    what = "least ratio of mean spectrum to target"
    ratio = mean_ratio(suite, periods)
    if ratio is None:
        return not_answered(code, clause, what, ">=", share, periods, suite=suite)
    least = float(ratio.min())
    lift = f"a further factor of {share / least:.4g} on every record would do" if least < share else ""
    said = "; ".join(filter(None, (lift, remark)))
    return required(code, clause, what, least, ">=", share, periods=periods, remark=said)


def mean_at_most(
    suite: Suite, code: str, clause: str, *, share: float, periods: tuple[float, float], remark: str = ""
) -> Requirement:
    """That the mean spectrum nowhere in the range exceeds `share` of the target."""
    what = "largest ratio of mean spectrum to target"
    ratio = mean_ratio(suite, periods)
    if ratio is None:
        return not_answered(code, clause, what, "<=", share, periods, suite=suite)
    return required(code, clause, what, float(ratio.max()), "<=", share, periods=periods, remark=remark)


def mean_ratio(suite: Suite, periods: tuple[float, float]) -> FloatArray | None:
    """Mean spectrum over target at the periods of the range, ends included; None where it is not all covered."""
    low, high = suite.covered
    if not low * (1 - 1e-9) <= periods[0] <= periods[1] <= high * (1 + 1e-9):
        return None
    inside = (suite.period > periods[0]) & (suite.period < periods[1])
    at = np.concatenate([[periods[0]], suite.period[inside], [periods[1]]])
    return np.asarray(np.interp(np.log(at), np.log(suite.period), suite.mean / suite.target), dtype=np.float64)
