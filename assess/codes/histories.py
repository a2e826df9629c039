"""Answers by time histories: suites of records, their scan at rising PGA, and the numerical spread of the answers.

A history is chaotic where impacts amplify a difference of the motion: with the PGA times (1 + 1e-9) a maximum can move
by 20 %. So each record is also run with twins that differ by too little to be another earthquake, and the nine runs
together say what the records give. Of each record one of its nine runs is drawn, 500 times, by the same seeded draws at
all levels: p is the share of the draws in which the rule of the code holds. A pass needs p >= 0.84. The rule must also
hold for the records as they are, which the code asks about: the spread may take a pass away and never gives one.

Numerical spread is not the scatter from record to record: it would remain if the one earthquake to come were known.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from math import floor, inf, isinf, log10

import numpy as np

from assess.codes.calculation_sheet import Step, step
from assess.codes.check import (
    NEEDED,
    Check,
    NumericalSpread,
    Outcome,
    PgaCurve,
    Reason,
    least_if_all_known,
    reason_message,
)
from assess.messages.message import Message, Quantity, Severity, message
from assess.oscillator import BranchName, Oscillator, threshold
from assess.short_repr import ShortRepr
from spectra.arrays import BoolArray, FloatArray, IntArray
from spectra.gravity import g


@dataclass(frozen=True, eq=False, repr=False)
class RecordRuns(ShortRepr):
    """The runs of each record at one level: the record as it is in the first row, then its twins.

    ratio : largest |rotation| / rigid overturning rotation, inf where it overturned [runs, records] [-]
    negative : whether the largest happened on the negative branch [runs, records]
    """

    ratio: FloatArray
    negative: BoolArray


@dataclass(frozen=True)
class SuiteResponse:
    """The largest responses of one mechanism to all records at one level, the worse polarity of each.

    pga : level, peak ground acceleration of the target [m/s2]
    ratio : largest |rotation| / rigid overturning rotation of each record, None where it overturned
    branch : where the largest of them happened
    branches : where the largest of each record happened; empty: all on `branch`
    twins : the records with their twins; None where they were run without
    """

    pga: float
    ratio: tuple[float | None, ...]
    branch: BranchName
    branches: tuple[BranchName, ...] = ()
    twins: RecordRuns | None = field(default=None, compare=False)

    @property
    def overturned(self) -> int:
        """Number of records that overturned the mechanism."""
        return sum(1 for ratio in self.ratio if ratio is None)

    @property
    def mean(self) -> float | None:
        """Mean of the maxima; None where a record overturned, as it has no maximum."""
        standing = [ratio for ratio in self.ratio if ratio is not None]
        return sum(standing) / len(standing) if len(standing) == len(self.ratio) > 0 else None

    @property
    def runs(self) -> RecordRuns:
        """The runs of each record: with its twins, or the record alone."""
        if self.twins is not None:
            return self.twins
        names = self.branches or (self.branch,) * len(self.ratio)
        ratio = [inf if each is None else each for each in self.ratio]
        return RecordRuns(
            np.array([ratio], dtype=np.float64), np.array([[name == "negative" for name in names]], dtype=bool)
        )


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
    PGA [g]; None without a threshold.
    """
    if linearised:
        return min(branch.linearised.multiplier for branch in oscillator.branches)
    return least_if_all_known([threshold(branch) for branch in oscillator.branches])


def pga_curve(incremental: Sequence[SuiteResponse]) -> PgaCurve:
    """Return the mean of the maxima over PGA, up to the first suite with a record that overturned the mechanism."""
    standing: list[tuple[float, float]] = []
    for suite in incremental:
        if suite.mean is None:
            break
        standing.append((suite.mean, suite.pga / g))
    return PgaCurve(tuple(ratio for ratio, _ in standing), tuple(pga for _, pga in standing))


def fails_below(at_collapse: float | None, level: float) -> tuple[Message, ...]:
    """Return a message where a level passes above the least PGA at which the scan fails, both in g."""
    if at_collapse is None or level <= at_collapse * (1.0 + ROUNDING):
        return ()
    return (message(FAILS_BELOW, {"pga": Quantity(at_collapse, "ground acceleration", 3)}),)


def failure_below(check: Check) -> Message | None:
    """Return what a check says of a failure at a lower PGA than the one at which it passes; None without one."""
    return next((each for each in check.remarks if each.key == FAILS_BELOW), None)


def scan_conditions(incremental: Sequence[SuiteResponse]) -> tuple[Message, ...]:
    """Return what a pass by histories depends on where they were not run at rising PGA.

    Parameters
    ----------
    incremental : suites at rising PGA; empty without a scan

    Returns
    -------
    tuple of Message
    """
    return () if incremental else (message("not-scanned", severity=Severity.WARNING),)


DRAWS, SEED = 500, 1
HALF_OF_DRAWS, LOW_SHARE = 0.5, 0.16
SPREAD_CLAUSE, SCAN_FORMULA = "numerical spread", "last PGA of the scan before the first that fails"


@dataclass(frozen=True)
class RuleShares:
    """A suite under a rule, against the choices of one run for each record.

    ratio : what the rule compares with 1 in every draw, inf where a record overturned [draws]
    standing : p_0, that each record stands, exact: the product of the shares of their runs that do [-]
    within : p_m, the share of draws among the runs that stand in which their mean is within its limit [-]
    """

    ratio: FloatArray
    standing: float
    within: float

    @property
    def holds(self) -> float:
        """p, that the rule holds [-]."""
        return self.standing * self.within


def rule_shares(ratios: FloatArray, stands: BoolArray, *, largest: bool = False) -> RuleShares:
    """Return how often a rule holds: every record stands, and the mean of the ratios, or each, is at most 1.

    The records' runs are chosen independently, so that what must hold for each record has the product of their shares
    as its probability. Only the mean over them is drawn, among the runs that stand.

    Parameters
    ----------
    ratios : of every run of each record, what is compared with 1, inf where it overturned [runs, records] [-]
    stands : whether it stands [runs, records]
    largest : whether each ratio is compared, and not their mean

    Returns
    -------
    RuleShares
    """
    drawn = draw_values(ratios)
    if largest:
        return RuleShares(drawn.max(axis=1), _product_of_shares(stands & (ratios <= 1.0)), 1.0)
    among = _draw_standing(ratios, stands)
    within = 0.0 if among is None else float((among.mean(axis=1) <= 1.0).mean())
    return RuleShares(drawn.mean(axis=1), _product_of_shares(stands), within)


DisplacementMeasure = Callable[[SuiteResponse], RuleShares]


@dataclass(frozen=True)
class SuiteRule:
    """A rule of a code on a suite of records.

    measure : how often it holds among the runs of each record
    passes : whether it holds for the records as they are
    least_records : that a suite must have
    """

    measure: DisplacementMeasure
    passes: Callable[[SuiteResponse], bool]
    least_records: int

    def holds(self, suite: SuiteResponse) -> bool:
        """Return whether the suite is no failure: the records as they are pass, and so do 84 % of the draws."""
        enough = len(suite.ratio) >= self.least_records
        return enough and self.passes(suite) and self.measure(suite).holds >= NEEDED


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


def share_upright(suite: SuiteResponse) -> float:
    """Return the probability that no record overturns the mechanism: p of any rule is at most this [-]."""
    return _product_of_shares(np.isfinite(suite.runs.ratio))


def capacities_by_share(incremental: Sequence[SuiteResponse], rule: SuiteRule) -> Capacities:
    """Return the PGA up to which a rule holds, by the share of the draws.

    Responses are not monotone in PGA: a suite beyond the first failure may pass again and does not count, so that a
    level can pass above this PGA.

    Parameters
    ----------
    incremental : suites at rising PGA
    rule : that is to hold

    Returns
    -------
    Capacities
    """
    last: float | None = None
    found: dict[float, float | None] = {}
    for suite in incremental:
        if len(suite.ratio) < rule.least_records:
            break
        share = rule.measure(suite).holds
        for needed in (NEEDED, HALF_OF_DRAWS, LOW_SHARE):
            if share < needed or (needed == NEEDED and NEEDED not in found and not rule.passes(suite)):
                found.setdefault(needed, last)
        if len(found) == 3:
            break
        last = suite.pga / g
    return Capacities(found.get(NEEDED), found.get(HALF_OF_DRAWS), found.get(LOW_SHARE))


def numerical_spread(
    suite: SuiteResponse, measure: DisplacementMeasure, found: Capacities, *, FC: float = 1.0
) -> NumericalSpread | None:
    """Return the numerical spread of an answer; None where the records were run without twins.

    Parameters
    ----------
    suite : of the answer
    measure : how often its rule holds
    found : the PGA up to which the rule holds in so many draws
    FC : confidence factor, by which the motion of the records is multiplied [-]
    """
    if suite.twins is None or not suite.ratio:
        return None
    found_here = measure(suite)
    low, high = (_finite_or_none(np.quantile(found_here.ratio, q, method="inverted_cdf")) for q in (LOW_SHARE, NEEDED))
    half, least = (None if pga is None else pga / FC for pga in (found.half, found.low))
    return NumericalSpread(
        suite.twins.ratio.shape[0],
        DRAWS,
        SEED,
        found_here.holds,
        low,
        high,
        half,
        least,
        standing=found_here.standing,
        within=found_here.within,
    )


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
    return LOW_SHARE < check.numerical.holds < NEEDED or (
        check.verdict == Outcome.FAIL and check.numerical.holds >= NEEDED
    )


def spread_steps(spread: NumericalSpread | None, capacity_pga_g: float | None) -> tuple[Step, ...]:
    """Write p by its two shares, and the PGA up to which p is at least 0.84, 0.5 and 0.16."""
    if spread is None:
        return ()
    number = float(spread.draws)
    words = "draws of one of nine runs for each record: as it is, or PGA times 1 ± 10^-u, u from 3 to 6"
    standing, within = "share of the choices of runs in which every record stands", "share of N in which the mean holds"
    return (
        step("N", words, SPREAD_CLAUSE, "number of draws", number),
        step("p_0", standing, SPREAD_CLAUSE, "product of the records' shares of runs that stand", spread.standing),
        step("p_m", within, SPREAD_CLAUSE, "share of draws among the runs that stand", spread.within),
        step("p", "how often the rule holds; a pass needs 0.84", SPREAD_CLAUSE, "p_0 · p_m",
             spread.holds, given={"p_0": spread.standing, "p_m": spread.within}),
        step("PGA_84", "PGA up to which p is at least 0.84 and the records as they are pass", SPREAD_CLAUSE,
             SCAN_FORMULA, capacity_pga_g, "g"),
        step("PGA_50", "PGA up to which p is at least 0.5", SPREAD_CLAUSE, SCAN_FORMULA,
             spread.capacity_50_pga_g, "g"),
        step("PGA_16", "PGA up to which p is at least 0.16", SPREAD_CLAUSE, SCAN_FORMULA,
             spread.capacity_16_pga_g, "g"),
    )  # fmt: skip


FIGURES = 4
FARTHEST = 6  # figures of a number that is all but its limit


def ratio_figures(check: Check, *, most: int = FIGURES) -> int:
    """Return to how many figures demand over capacity stands between 16 and 84 % of the draws.

    They are as many, one at least, as keep it on its side of 1.

    Parameters
    ----------
    check : of any procedure; all figures stand where it has no numerical spread
    most : figures to be shown at most
    """
    if check.ratio is None:
        return most
    spread = check.numerical
    ends = () if spread is None else (spread.ratio_16, spread.ratio_84)
    return side_figures(check.ratio, max(1, standing_figures(check.ratio, ends, most=most)))


def side_figures(value: float, figures: int, *, limit: float = 1.0) -> int:
    """Return the least number of figures, of `figures` and more, that shows a number on its side of a limit.

    Parameters
    ----------
    value : the number that is shown
    figures : to which it stands
    limit : what it is compared with
    """
    return next(
        (
            each
            for each in range(figures, FARTHEST)
            if _side_of_limit(value, limit) == _side_of_limit(value, limit, each)
        ),
        FARTHEST,
    )


def margin_figures(margin: float, most: float | None) -> int:
    """Return to how many figures the factor on the action is written up to which a mechanism holds.

    Parameters
    ----------
    margin : the factor
    most : the same up to which 16 % of the draws hold; None where there is no spread
    """
    return side_figures(margin, 3 if most is None else interval_figures(margin, most))


def interval_figures(low: float, high: float, *, most: int = 3, limit: float | None = None) -> int:
    """Return to how many figures the two ends of an interval are written, so that they differ.

    Parameters
    ----------
    low, high : its ends, positive
    most : figures where they hardly differ
    limit : what they are compared with, on whose sides they are to be shown; None for nothing
    """
    figures = most if high <= low else max(1, min(most, floor(log10(high)) - floor(log10(high - low)) + 1))
    return figures if limit is None else max(side_figures(each, figures, limit=limit) for each in (low, high))


def _side_of_limit(value: float, limit: float, figures: int = 12) -> int:
    """Return -1, 0 or 1 for a number, written to some figures, that is below, at or above a limit."""
    shown, of = float(f"{value:.{figures}g}"), float(f"{limit:.12g}")
    return (shown > of) - (shown < of)


def standing_figures(value: float, others: Iterable[float | None], *, most: int = FIGURES) -> int:
    """Return to how many significant figures a number stands: all its runs are within half a unit of the last one.

    Parameters
    ----------
    value : the number that is shown
    others : the same of the other runs; None where they have none, as where the body overturned
    most : figures where the runs agree

    Returns
    -------
    0 where not even the first figure stands.
    """
    far = max((inf if other is None else abs(other - value) for other in others), default=0.0)
    if far == 0.0 or value == 0.0 or isinf(far):
        return most if far == 0.0 else 0
    place = floor(log10(abs(value)))
    return next((figures for figures in range(most, 0, -1) if far <= 0.5 * 10.0 ** (place - figures + 1)), 0)


def _product_of_shares(stands: BoolArray) -> float:
    """Return the probability that every record stands, of runs [runs, records] chosen independently [-]."""
    return float(stands.mean(axis=0).prod())


def _draw_standing(values: FloatArray, stands: BoolArray) -> FloatArray | None:
    """Return values of the runs that stand, drawn for each record [draws, records]; None where one has none.

    More records do not change the draws of the others.
    """
    number, records = stands.sum(axis=0), stands.shape[1]
    if not number.all():
        return None
    standing_first = np.argsort(~stands, axis=0, kind="stable")
    place = (np.random.default_rng(SEED).random((records, DRAWS)).T * number).astype(int)
    columns = np.arange(records)
    drawn: FloatArray = values[standing_first[place, columns], columns]
    return drawn


def _finite_or_none(value: float) -> float | None:
    return None if isinf(value) else float(value)
