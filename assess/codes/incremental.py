"""Suites of time histories at rising PGA: the curve they make, and the PGA at which they begin to fail."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from scipy.constants import g

from assess.codes.check import Check, PgaCurve
from assess.codes.suite import Suite
from assess.codes.worst_branch import least_known
from assess.messages.message import Message, Quantity, Severity, message
from assess.oscillator import Oscillator, threshold

FAILS_BELOW = "fails-below"
ROUNDING = 1e-9  # relative, of a PGA that was multiplied and divided by FC


def uplift_multiplier(oscillator: Oscillator, *, linearised: bool) -> float | None:
    """Return the least PGA at which the equation of the histories lets the mechanism lift off.

    The linearised equation has a threshold even on flexible joints.

    Parameters
    ----------
    oscillator : the mechanism
    linearised : whether the histories solve the linearised equation

    Returns
    -------
    float or None
        PGA [g]; None without a threshold.
    """
    if linearised:
        return min(branch.linearised.multiplier for branch in oscillator.branches)
    return least_known([threshold(branch) for branch in oscillator.branches])


def pga_curve(incremental: Sequence[Suite]) -> PgaCurve:
    """Return the mean of the maxima over PGA, up to the first suite with a record that overturned the mechanism."""
    standing: list[tuple[float, float]] = []
    for suite in incremental:
        if suite.mean is None:
            break
        standing.append((suite.mean, suite.pga / g))
    return PgaCurve(tuple(ratio for ratio, _ in standing), tuple(pga for _, pga in standing))


def pga_before_failure(
    incremental: Sequence[Suite], passes: Callable[[Suite], bool], *, least_records: int
) -> float | None:
    """Return the PGA of the last suite before the first that fails.

    Responses are not monotone in PGA: a suite beyond the first failure may pass again and does not count, so that a
    level can pass above this PGA.

    Parameters
    ----------
    incremental : suites at rising PGA
    passes : whether a suite passes
    least_records : that a suite must have

    Returns
    -------
    float or None
        PGA [g]; None if none failed, with too few records, or without a scan.
    """
    last: float | None = None
    for suite in incremental:
        if len(suite.ratio) < least_records:
            return None
        if not passes(suite):
            return last
        last = suite.pga / g
    return None


def fails_below(at_collapse: float | None, level: float) -> tuple[Message, ...]:
    """Return a message where a level passes above the least PGA at which the scan fails, both in g."""
    if at_collapse is None or level <= at_collapse * (1.0 + ROUNDING):
        return ()
    return (message(FAILS_BELOW, {"pga": Quantity(at_collapse, "ground acceleration", 3)}),)


def failure_below(check: Check) -> Message | None:
    """Return what a check says of a failure at a lower PGA than the one at which it passes; None without one."""
    return next((each for each in check.remarks if each.key == FAILS_BELOW), None)


def scan_conditions(incremental: Sequence[Suite]) -> tuple[Message, ...]:
    """Return what a pass by histories depends on where they were not run at rising PGA.

    Parameters
    ----------
    incremental : suites at rising PGA; empty without a scan

    Returns
    -------
    tuple of Message
    """
    return () if incremental else (message("not-scanned", severity=Severity.WARNING),)
