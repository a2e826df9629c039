"""The numerical spread of answers by histories.

Of each record one of its nine runs is drawn, 500 times, by the same seeded draws at all levels: p is the share of the
draws in which the rule of the code holds. A pass needs p >= 0.84. The rule must also hold for the records as they are,
which the code asks about: the spread may take a pass away and never gives one.

Numerical spread is not the scatter from record to record: it would remain if the one earthquake to come were known.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import isinf

import numpy as np

from assess.codes.check import NEEDED, Check, NumericalSpread, Outcome, Reason, Step, reason_message, step
from assess.codes.incremental import pga_before_failure
from assess.codes.suite import Suite
from assess.messages.message import Message, Quantity, message
from spectra.arrays import BoolArray, FloatArray, IntArray

DRAWS, SEED = 500, 1
HALF, LOW = 0.5, 0.16
CLAUSE, SCAN = "numerical spread", "last PGA of the scan before the first that fails"

Measure = Callable[[Suite], tuple[FloatArray, BoolArray]]
"""Of a suite, in every draw: the ratio that is compared with 1, inf where a record overturned, and whether the rule
holds [draws], [draws]."""


@dataclass(frozen=True)
class Capacities:
    """The PGA up to which p is at least 0.84 (and the records as they are pass), 0.5 and 0.16 at every level below [g].

    None where no level fails so, with too few records, or without a scan.
    """

    sure: float | None = None
    half: float | None = None
    low: float | None = None


def draw_runs(records: int, runs: int) -> IntArray:
    """Return which run of each record every draw takes; more records do not change the draws of the others.

    Parameters
    ----------
    records : their number
    runs : of each record

    Returns
    -------
    array of int [draws, records]
    """
    return np.random.default_rng(SEED).integers(0, runs, size=(records, DRAWS)).T


def draw_values(values: FloatArray) -> FloatArray:
    """Return the values [runs, records] that every draw takes [draws, records]."""
    runs, records = values.shape
    return values[draw_runs(records, runs), np.arange(records)]


def share_upright(suite: Suite) -> float:
    """Return the share of the draws in which no record overturns the mechanism: p of any rule is at most this [-]."""
    return float(np.isfinite(draw_values(suite.runs.ratio)).all(axis=1).mean())


def capacities(
    incremental: Sequence[Suite], measure: Measure, passes: Callable[[Suite], bool], *, least_records: int
) -> Capacities:
    """Return the PGA up to which a rule holds, by the share of the draws.

    Parameters
    ----------
    incremental : suites at rising PGA
    measure : the rule in every draw
    passes : whether the records as they are pass
    least_records : that a suite must have

    Returns
    -------
    Capacities
    """
    shares = {suite.pga: float(measure(suite)[1].mean()) for suite in incremental if len(suite.ratio) >= least_records}

    def at_least(share: float) -> float | None:
        def holds(suite: Suite) -> bool:
            return shares[suite.pga] >= share and (share < NEEDED or passes(suite))

        return pga_before_failure(incremental, holds, least_records=least_records)

    return Capacities(at_least(NEEDED), at_least(HALF), at_least(LOW))


def numerical_spread(suite: Suite, measure: Measure, found: Capacities, *, FC: float = 1.0) -> NumericalSpread | None:
    """Return the numerical spread of an answer; None where the records were run without twins.

    Parameters
    ----------
    suite : of the answer
    measure : its rule in every draw
    found : the PGA up to which the rule holds in so many draws
    FC : confidence factor, by which the motion of the records is multiplied [-]
    """
    if suite.twins is None or not suite.ratio:
        return None
    ratio, holds = measure(suite)
    low, high = (_finite(np.quantile(ratio, q, method="inverted_cdf")) for q in (LOW, NEEDED))
    half, least = (None if pga is None else pga / FC for pga in (found.half, found.low))
    return NumericalSpread(suite.twins.ratio.shape[0], DRAWS, SEED, float(holds.mean()), low, high, half, least)


def _finite(value: float) -> float | None:
    return None if isinf(value) else float(value)


def with_spread(
    verdict: Outcome, reason: Message, spread: NumericalSpread | None
) -> tuple[Outcome, Message, tuple[Message, ...]]:
    """Return outcome, reason and remarks of an answer, of which the records as they are give the first two.

    Parameters
    ----------
    verdict, reason : by the records as they are
    spread : of the answer; None where it is not known
    """
    if spread is None:
        return verdict, reason, ()
    share = Quantity(spread.holds, figures=3)
    if verdict == Outcome.PASS and spread.holds < NEEDED:
        return Outcome.FAIL, reason_message(Reason.NUMERICAL_SPREAD, share=share), ()
    if verdict == Outcome.FAIL and spread.holds >= NEEDED:
        return verdict, reason, (message("spread-would-pass", {"share": share}),)
    return verdict, reason, ()


def is_between(check: Check) -> bool:
    """Return whether the numerical spread leaves an answer open: 16 to 84 % of the draws hold, or more than it says."""
    if check.numerical is None:
        return False
    return LOW < check.numerical.holds < NEEDED or (check.verdict == Outcome.FAIL and check.numerical.holds >= NEEDED)


def spread_steps(spread: NumericalSpread | None, capacity_pga_g: float | None) -> tuple[Step, ...]:
    """Write the draws, p, and the PGA up to which p is at least 0.84, 0.5 and 0.16."""
    if spread is None:
        return ()
    number, holding = float(spread.draws), float(round(spread.holds * spread.draws))
    words = "draws of one of nine runs for each record: as it is, or PGA times 1 ± 10^-u, u from 3 to 6"
    return (
        step("N", words, CLAUSE, "number of draws", number),
        step("N_p", "draws in which the rule holds", CLAUSE, "count of draws", holding),
        step("p", "share of the draws in which the rule holds; a pass needs 0.84", CLAUSE, "N_p / N", spread.holds,
             given={"N_p": holding, "N": number}),
        step("PGA_84", "PGA up to which p is at least 0.84 and the records as they are pass", CLAUSE, SCAN,
             capacity_pga_g, "g"),
        step("PGA_50", "PGA up to which p is at least 0.5", CLAUSE, SCAN, spread.capacity_half_pga_g, "g"),
        step("PGA_16", "PGA up to which p is at least 0.16", CLAUSE, SCAN, spread.capacity_low_pga_g, "g"),
    )  # fmt: skip
