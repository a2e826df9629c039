"""The histories that fragility is found from: every record at rising scales, in the worse polarity.

Rocking is not monotone: a record that overturns a mechanism may leave it standing when it is stronger. So nothing is
bisected, and every level is run. Jobs are run in chunks, of which only the ratio of each record and level is kept.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

import numpy as np
from scipy.constants import g

from assess.dynamics.history import Jobs, make_solver
from assess.oscillator import linear_multiplier
from assess.short_repr import ShortRepr
from assess.study.fragility.question import FragilityQuestion
from assess.study.history_levels import with_restitution_factor
from assess.study.rocking_case import RockingCase
from spectra.arrays import BoolArray, FloatArray, IntArray

CHUNK = 20_000
"""Jobs that are run at a time."""
BELOW_UPLIFT = 0.95
"""The lowest level, as a share of that at which the first record makes the mechanism rock."""
SEARCH_STEP = 1.25
"""Ratio of the levels at which the highest one is sought."""
MOST_SEARCHED = 80

Severity = Callable[[FloatArray], FloatArray]
"""Takes scale factors [records, levels], nan for no run; returns ratios [records, levels] as `Runs` has them."""


@dataclass(frozen=True, repr=False)
class Runs(ShortRepr):
    """The runs of all records on one mechanism.

    scale [records, levels] : rising along each row; nan where a record is not run
    ratio [records, levels] : largest rotation over that which overturns; inf where overturned, nan where not run
    """

    scale: FloatArray
    ratio: FloatArray

    @property
    def run(self) -> BoolArray:
        """Which runs there are [records, levels]."""
        return ~np.isnan(self.scale)

    @property
    def last(self) -> IntArray:
        """The place of the largest scale of each record [records]."""
        return np.asarray(self.run.sum(axis=1) - 1, dtype=np.int64)


def run_levels(case: RockingCase, unit: FloatArray, question: FragilityQuestion, *, threads: int) -> Runs:
    """Run every record at the same intensities of the primary measure.

    A record too weak for the lowest of them runs once, at the largest scale factor.

    Parameters
    ----------
    case : the oscillator and the motions at its base, at scale 1
    unit : intensity of each record in the primary measure at scale 1 [records]
    question : the method, its levels and its bounds
    threads : number of threads; 0 for all cores; the result does not depend on it
    """
    severity = severity_solver(case, threads=threads)
    lowest = lowest_level(case, unit)
    most = question.largest_factor
    end = most * float(unit.max())  # beyond it no record may be scaled
    highest = min(question.largest or highest_level(severity, unit, lowest, most=most), end)
    scale = scales(np.geomspace(min(lowest, 0.5 * highest), highest, question.levels), unit, most=most)
    scale[np.isnan(scale).all(axis=1), 0] = most
    return run_scales(severity, scale)


def run_once(case: RockingCase, factor: float, *, threads: int) -> Runs:
    """Run every record once, times a factor."""
    return run_scales(severity_solver(case, threads=threads), np.full((len(case.base), 1), factor))


def run_scales(severity: Severity, scale: FloatArray) -> Runs:
    """Run every record at its scale factors [records, levels]."""
    return Runs(scale, severity(scale))


def scales(levels: FloatArray, unit: FloatArray, *, most: float) -> FloatArray:
    """Return the factors that scale each record to each level [records, levels]; nan where one exceeds `most`."""
    factor = levels / unit[:, None]
    return np.where(factor <= most * (1.0 + 1e-12), factor, np.nan)


def lowest_level(case: RockingCase, unit: FloatArray) -> float:
    """Return an intensity of the primary measure at which no record makes the mechanism rock [unit of the measure].

    A body on a rigid base lifts off at the uplift acceleration; on joints without a threshold that is the largest
    acceleration that they resist.
    """
    uplift = g * min(linear_multiplier(branch) for branch in case.oscillator.branches)
    peak = np.array([motion.record.pga for motion in case.base])
    return BELOW_UPLIFT * float(np.min(uplift / peak * unit))


def highest_level(severity: Severity, unit: FloatArray, lowest: float, *, most: float) -> float:
    """Return the second of two successive intensities at which all records that may be scaled so far overturn.

    Where that never happens, it is the last to which any record may be scaled.
    """
    end = most * float(unit.max())
    before, level = False, lowest
    for _ in range(MOST_SEARCHED):
        if level * SEARCH_STEP >= end:
            return end
        level *= SEARCH_STEP
        ratio = severity(scales(np.array([level]), unit, most=most))
        now = bool(np.all(np.isinf(ratio[~np.isnan(ratio)])))
        if now and before:
            return level
        before = now
    return level


def severity_solver(case: RockingCase, *, threads: int) -> Severity:
    """Return a solver of the ratios of records at given scale factors, of the worse polarity and the worst rebound.

    A symmetric body is run in one polarity only: the other one mirrors it. Ratios are over the rotation that overturns
    the body on the joints in use, which is less than that on rigid ones.
    """
    oscillators = [with_restitution_factor(case.oscillator, rebound) for rebound in case.rebounds]
    run = make_solver(oscillators, [each.record for each in case.base], equation=case.equation, threads=threads)
    branches = case.oscillator.branches
    signs = np.array([1.0] if case.oscillator.symmetric else [1.0, -1.0])
    ways = np.tile(signs, len(oscillators))
    which = np.repeat(np.arange(len(oscillators)), signs.size)
    first, last = (branch.overturning / branch.unstable for branch in (branches[0], branches[-1]))

    def solve(scale: FloatArray) -> FloatArray:
        ratio = np.full(scale.shape, np.nan)
        motion, level = np.nonzero(~np.isnan(scale))
        size = max(1, CHUNK // ways.size)
        for start in range(0, motion.size, size):
            m, k = motion[start : start + size], level[start : start + size]
            factors = (scale[m, k][:, None] * ways).ravel()
            found = run(Jobs(np.tile(which, m.size), np.repeat(m, ways.size), factors))
            ratios = found.max_ratio * np.where(found.max_rotation < 0.0, last, first)
            severity = np.where(found.overturned, inf, ratios)
            ratio[m, k] = severity.reshape(-1, ways.size).max(axis=1)
        return ratio

    return solve
