"""The histories that fragility is found from: which state each run reaches, at which intensity of its motion.

Every record is run at rising scales, in the worse polarity. Rocking is not monotone: a record that overturns a
mechanism may leave it standing when it is stronger. So nothing is bisected, and every level is run. Jobs are run in
chunks, of which only the ratio of each record and level is kept.

Measures of intensity, of the motion of the ground or of that at the base of a mechanism, are proportional to the scale
factor of the record: they are computed once, at scale 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import ceil, inf, log, tan

import numpy as np

from assess.dynamics.history import Jobs
from assess.oscillator import linear_multiplier
from assess.results.fragility import LARGE_SCALE, MeasureResult, StateResult
from assess.short_repr import ShortRepr
from assess.study.level_peaks import RockingCase, run_variants, variant_solver
from assess.study.study import AVERAGE_PERIODS, FragilityQuestion
from records.record import Record
from records.response import pgv, response_spectrum
from spectra.arrays import BoolArray, FloatArray, IntArray
from spectra.gravity import g

CHUNK = 20_000
"""Jobs that are run at a time."""

BELOW_UPLIFT = 0.95
"""The lowest level, as a share of that at which the first record makes the mechanism rock."""

SEARCH_STEP = 1.25
"""Ratio of the levels at which the highest one is sought."""
MOST_SEARCHED = 80

Cases = Sequence[RockingCase | None]
"""One case with all records; or one for each record, None where its wall falls under its own loads."""
SeveritySolver = Callable[[FloatArray], FloatArray]
"""Takes scale factors [records, levels], nan for no run; returns ratios as `FragilityRuns` has them."""


@dataclass(frozen=True, repr=False)
class FragilityRuns(ShortRepr):
    """The runs of all records on one mechanism.

    scale [records, levels] : rising along each row; nan where a record is not run
    ratio [records, levels] : largest rotation over that which overturns; inf where overturned, nan where not run
    stripe [records] : intensity of the primary measure, where each stripe has records of its own, that run once
    """

    scale: FloatArray
    ratio: FloatArray
    stripe: FloatArray | None = None

    @property
    def run(self) -> BoolArray:
        """Which runs there are [records, levels]."""
        return ~np.isnan(self.scale)

    @property
    def last(self) -> IntArray:
        """The place of the largest scale of each record [records]."""
        return np.asarray(self.run.sum(axis=1) - 1, dtype=np.int64)


def run_intensities(cases: Cases, unit: FloatArray, question: FragilityQuestion, *, threads: int) -> FragilityRuns:
    """Run every record at the same intensities of the primary measure.

    A record too weak for the lowest of them runs once, at the largest scale factor.

    Parameters
    ----------
    cases : the oscillator and the motions at its base, at scale 1
    unit : intensity of each record in the primary measure at scale 1 [records]
    question : the method, its levels and its bounds
    threads : number of threads; 0 for all cores; the result does not depend on it
    """
    severity = _severity_solver(cases, threads=threads)
    lowest = _lowest_level(cases, unit)
    most = question.largest_factor
    end = most * float(unit.max())  # beyond it no record may be scaled
    highest = min(question.largest or _highest_level(severity, unit, lowest, most=most), end)
    scale = scale_factors(np.geomspace(min(lowest, 0.5 * highest), highest, question.levels), unit, most=most)
    scale[np.isnan(scale).all(axis=1), 0] = most
    return FragilityRuns(scale, severity(scale))


def run_once(cases: Cases, factor: FloatArray, *, threads: int, stripe: FloatArray | None = None) -> FragilityRuns:
    """Run every record once, times its factor [records]; stripe : the intensity that this gives it, of its stripe."""
    scale = factor[:, None]
    return FragilityRuns(scale, _severity_solver(cases, threads=threads)(scale), stripe)


def scale_factors(levels: FloatArray, unit: FloatArray, *, most: float) -> FloatArray:
    """Return the factors that scale each record to each level [records, levels]; nan where one exceeds `most`."""
    factor = levels / unit[:, None]
    return np.where(factor <= most * (1.0 + 1e-12), factor, np.nan)


@dataclass(frozen=True, repr=False)
class StateOutcomes(ShortRepr):
    """Whether each record reaches a state at the same intensities.

    intensity [n] rising; reached [records, n]; known [records, n] : where the record counts
    hollow [records, n] : where it is scaled by more than 4
    """

    intensity: FloatArray
    reached: BoolArray
    known: BoolArray
    hollow: BoolArray


def reaches(runs: FragilityRuns, state: StateResult) -> BoolArray:
    """Return which runs reach a state [records, levels]; a run that does not exist does not.

    Parameters
    ----------
    runs : of all records
    state : rocking is any rotation, overturning is no return
    """
    with np.errstate(invalid="ignore"):
        if state.name == "overturning":
            return np.isposinf(runs.ratio)
        least = np.nextafter(0.0, 1.0) if state.share is None else state.share
        return np.asarray(runs.ratio >= least)


def state_outcomes(runs: FragilityRuns, unit: FloatArray, reached: BoolArray, *, primary: bool) -> StateOutcomes:
    """Return whether each record reaches a state at the intensities of a measure.

    Each record is a step function of its intensity: at each intensity it is as in its run of nearest logarithm. All
    records are run at the same intensities of the primary measure, so there each point is a run; other measures have
    points in the same ratio. Below its least scale a record is as there, where it does not rock. Above its largest
    scale it counts as reaching the state if it does there; if it stands there, it is censored and does not count.

    Parameters
    ----------
    runs : of all records, at scales of one ratio
    unit : intensity of each record at scale 1 [records]
    reached : which runs reach the state [records, levels]
    primary : whether it is the measure that records are scaled by, or proportional to it
    """
    if runs.stripe is not None:
        levels, place = np.unique(runs.stripe, return_inverse=True)
        known = place[:, None] == np.arange(levels.size)
        return StateOutcomes(levels, known & reached, known, known & (runs.scale > LARGE_SCALE))
    intensity = runs.scale * unit[:, None]
    step = float(np.nanmax(runs.scale[:, 1] / runs.scale[:, 0]))
    levels = np.nanmax(intensity, axis=0) if primary else _intensity_levels(intensity, step)
    known, found, hollow = np.zeros((3, unit.size, levels.size), dtype=bool)
    for record, end in enumerate(runs.last):
        own = intensity[record, : end + 1]
        place = nearest(np.log(own), np.log(levels))
        found[record], hollow[record] = reached[record, place], runs.scale[record, place] > LARGE_SCALE
        known[record] = (levels <= own[-1] * np.sqrt(step) * (1.0 + 1e-9)) | reached[record, end]
    return StateOutcomes(levels, found & known, known, hollow)


def first_bounds(runs: FragilityRuns, unit: FloatArray, reached: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Return the intensities between which each record first reaches a state [records], [records].

    The lower is 0 where it does at its least scale; the upper is inf where it stands at all scales.

    Parameters
    ----------
    runs : of all records
    unit : intensity of each record at scale 1 [records]
    reached : which runs reach the state [records, levels]
    """
    rows = np.arange(unit.size)
    ever, first = reached.any(axis=1), reached.argmax(axis=1)
    below = np.where(ever, first - 1, runs.last)
    lower = np.where(below >= 0, runs.scale[rows, np.maximum(below, 0)], 0.0)
    upper = np.where(ever, runs.scale[rows, first], np.inf)
    return lower * unit, upper * unit


def islands(scale: FloatArray, overturned: BoolArray) -> tuple[tuple[float, float], ...]:
    """Return the ranges of scale in which a record leaves the mechanism standing although a lower one overturns it.

    Parameters
    ----------
    scale : of the runs of one record, rising [n]
    overturned : whether each overturns [n]
    """
    if not overturned.any():
        return ()
    stands = np.concatenate([[False], ~overturned & (np.arange(scale.size) > overturned.argmax()), [False]])
    change = np.diff(stands.astype(np.int8))
    starts, ends = np.flatnonzero(change == 1), np.flatnonzero(change == -1) - 1
    return tuple((float(scale[a]), float(scale[b])) for a, b in zip(starts, ends, strict=True))


DIMENSIONS: Mapping[str, str] = {
    "pga": "ground acceleration",
    "pgv": "velocity",
    "sa": "ground acceleration",
    "sa-average": "ground acceleration",
    "pga/(g tan alpha)": "ratio",
    "p pgv/(g tan alpha)": "ratio",
}
MEASURE_DAMPING = 0.05


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


def measures_at_base(measures: Sequence[MeasureResult]) -> tuple[MeasureResult, ...]:
    """Return the same measures of the motion at the base of a mechanism."""
    return tuple(replace(each, at="base") for each in measures)


def intensities(measure: MeasureResult, records: Sequence[Record], rocker: Rocker) -> FloatArray:
    """Return the intensity of each record at scale 1, in the unit of the measure [records].

    Parameters
    ----------
    measure : the measure
    records : at the place that it measures
    rocker : the mechanism, for measures that depend on it
    """
    return np.array([_INTENSITY_OF[measure.key](record, measure, rocker) for record in records])


def _pga(record: Record, _: MeasureResult, __: Rocker) -> float:
    return record.pga / g


def _pgv(record: Record, _: MeasureResult, __: Rocker) -> float:
    return pgv(record)


def _mean_spectral(record: Record, measure: MeasureResult, _: Rocker) -> float:
    """Return the geometric mean of the 5 % pseudo-acceleration over the periods [g].

    Source: Eads, Miranda & Lignos (2015), Earthquake Eng. Struct. Dyn. 44, 2057-2073, eq. 3.
    """
    S_a = response_spectrum(record, np.array(measure.periods_s), damping=MEASURE_DAMPING)
    return float(np.exp(np.mean(np.log(S_a)))) / g


def _pga_over_uplift(record: Record, _: MeasureResult, rocker: Rocker) -> float:
    return record.pga / (g * tan(rocker.slenderness))


def _pgv_over_impulse(record: Record, _: MeasureResult, rocker: Rocker) -> float:
    """Return p PGV / (g tan alpha), 1 for the impulse that just overturns a slender block.

    Source: Dimitrakopoulos & Paraskeva (2015), Earthquake Eng. Struct. Dyn. 44, 2015-2033.
    """
    return rocker.p * pgv(record) / (g * tan(rocker.slenderness))


_INTENSITY_OF: Mapping[str, Callable[[Record, MeasureResult, Rocker], float]] = {
    "pga": _pga,
    "pgv": _pgv,
    "sa": _mean_spectral,
    "sa-average": _mean_spectral,
    "pga/(g tan alpha)": _pga_over_uplift,
    "p pgv/(g tan alpha)": _pgv_over_impulse,
}


@dataclass(frozen=True, repr=False)
class Intensities(ShortRepr):
    """A measure with the intensity of each record at scale 1 [records].

    primary : whether records are scaled by it, or by a measure that is proportional to it
    """

    measure: MeasureResult
    unit: FloatArray
    primary: bool


def _lowest_level(cases: Cases, unit: FloatArray) -> float:
    """Return an intensity of the primary measure at which no record makes the mechanism rock [unit of the measure].

    A body on a rigid base lifts off at the uplift acceleration; on joints without a threshold that is the largest
    acceleration that they resist.
    """
    shares = [
        np.array([inf])
        if case is None
        else g * min(map(linear_multiplier, case.oscillator.branches)) / np.array([one.record.pga for one in case.base])
        for case in cases
    ]
    return BELOW_UPLIFT * float(np.min(np.concatenate(shares) * unit))


def _highest_level(severity: SeveritySolver, unit: FloatArray, lowest: float, *, most: float) -> float:
    """Return the second of two successive intensities at which all records that may be scaled so far overturn.

    Where that never happens, it is the last to which any record may be scaled.
    """
    end = most * float(unit.max())
    before, level = False, lowest
    for _ in range(MOST_SEARCHED):
        if level * SEARCH_STEP >= end:
            return end
        level *= SEARCH_STEP
        ratio = severity(scale_factors(np.array([level]), unit, most=most))
        now = bool(np.all(np.isinf(ratio[~np.isnan(ratio)])))
        if now and before:
            return level
        before = now
    return level


def _severity_solver(cases: Cases, *, threads: int) -> SeveritySolver:
    """Return a solver of the ratios of records at given scale factors, as `_severity_of_case` does."""
    if len(cases) == 1 and cases[0] is not None:
        return _severity_of_case(cases[0], threads=threads)
    solvers = [None if each is None else _severity_of_case(each, threads=threads) for each in cases]

    def solve(scale: FloatArray) -> FloatArray:
        falls = np.where(np.isnan(scale), np.nan, inf)
        rows = enumerate(solvers)
        return np.concatenate([falls[k : k + 1] if one is None else one(scale[k : k + 1]) for k, one in rows])

    return solve


def _severity_of_case(case: RockingCase, *, threads: int) -> SeveritySolver:
    """Return a solver of the ratios of records at given scale factors, of the worse polarity and the worst rebound.

    Ratios are over the rotation that overturns
    the body on the joints in use, which is less than that on rigid ones.
    """
    polarity, oscillator_number = run_variants(case)
    run = variant_solver(case, [each.record for each in case.base], threads=threads)
    branches = case.oscillator.branches
    first, last = (branch.overturning / branch.unstable for branch in (branches[0], branches[-1]))

    def solve(scale: FloatArray) -> FloatArray:
        ratio = np.full(scale.shape, np.nan)
        motion, level = np.nonzero(~np.isnan(scale))
        size = max(1, CHUNK // polarity.size)
        for start in range(0, motion.size, size):
            m, k = motion[start : start + size], level[start : start + size]
            factors = (scale[m, k][:, None] * polarity).ravel()
            found = run(Jobs(np.tile(oscillator_number, m.size), np.repeat(m, polarity.size), factors))
            ratios = found.max_ratio * np.where(found.max_rotation < 0.0, last, first)
            severity = np.where(found.overturned, inf, ratios)
            ratio[m, k] = severity.reshape(-1, polarity.size).max(axis=1)
        return ratio

    return solve


def _intensity_levels(intensity: FloatArray, step: float) -> FloatArray:
    """Return intensities in the ratio of the runs, from the least to the largest of records that are run twice."""
    twice = intensity[~np.isnan(intensity[:, 1])]
    least, most = float(np.nanmin(twice)), float(np.nanmax(twice))
    return np.geomspace(least, most, 1 + ceil(log(most / least) / log(step) - 1e-9))


def nearest(rising: FloatArray, at: FloatArray) -> IntArray:
    """Return the place of the nearest of rising numbers [n]; of two as near, the upper one."""
    middle = 0.5 * (rising[1:] + rising[:-1])
    return np.asarray(np.searchsorted(middle, at, side="right"), dtype=np.int64)
