"""Displacements of time histories over d0* and d_LS: of each record as it is, of each of its runs, and of draws."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isinf

import numpy as np

from assess.codes.check import BranchName
from assess.codes.context import Context
from assess.codes.italian.curves import branch_curves
from assess.codes.italian.thresholds import Rule as Limit
from assess.codes.italian.thresholds import threshold_of
from assess.codes.numerical_spread import Measure, draw_values
from assess.codes.suite import Suite
from assess.oscillator import Oscillator, displacement
from spectra.arrays import BoolArray, FloatArray

FOR_THE_MEAN = 7  # NTC 7.3.5
SIDES: tuple[BranchName, BranchName] = ("positive", "negative")


@dataclass(frozen=True)
class DisplacementRatios:
    """One record: d*/d0* and d*/d_LS [-] of the branch of its maximum; None where the body overturned."""

    of_collapse: float | None
    of_limit: float | None


@dataclass(frozen=True)
class Found:
    """The results of the records at one level of one limit state.

    suite : run at FC times `pga`, the PGA of the limit state [m/s2]; displacements [n]: of each record
    """

    suite: Suite
    pga: float
    displacements: tuple[DisplacementRatios, ...]

    @property
    def limit_ratios(self) -> tuple[float, ...]:
        """d*/d_LS of the records that leave the body standing [-]."""
        return tuple(each.of_limit for each in self.displacements if each.of_limit is not None)

    @property
    def largest_collapse_ratio(self) -> float | None:
        """The largest d*/d0* of those [-]; None where all overturn it."""
        return max((each.of_collapse for each in self.displacements if each.of_collapse is not None), default=None)

    @property
    def uses_largest(self) -> bool:
        """Whether the largest is compared, not the mean: few records, or one that passes d0*."""
        return len(self.displacements) < FOR_THE_MEAN or (self.largest_collapse_ratio or 0.0) > 1.0

    @property
    def governing_ratio(self) -> float | None:
        """The d*/d_LS that is compared with 1 [-]; None where a record overturned."""
        if len(self.limit_ratios) < len(self.displacements) or not self.limit_ratios:
            return None
        return max(self.limit_ratios) if self.uses_largest else sum(self.limit_ratios) / len(self.limit_ratios)


def displacement_ratios(
    oscillator: Oscillator, context: Context, suite: Suite, limit: Limit
) -> tuple[DisplacementRatios, ...]:
    """Return d*/d0* and d*/d_LS of each record as it is [-], each by the branch of its maximum."""
    of_collapse, of_limit = run_ratios(oscillator, context, suite, limit)
    return tuple(
        DisplacementRatios(None, None) if isinf(far) else DisplacementRatios(far, near)
        for far, near in zip(of_collapse[0].tolist(), of_limit[0].tolist(), strict=True)
    )


def run_ratios(oscillator: Oscillator, context: Context, suite: Suite, limit: Limit) -> tuple[FloatArray, FloatArray]:
    """Return d*/d0* and d*/d_LS of every run of each record [runs, records] [-]; inf where it overturned."""
    runs = suite.runs
    of_collapse, of_limit = np.full(runs.ratio.shape, inf), np.full(runs.ratio.shape, inf)
    for name in SIDES:
        here = (runs.negative == (name == "negative")) & np.isfinite(runs.ratio)
        if not here.any():
            continue
        curves = branch_curves(oscillator, context, name)
        threshold, branch = threshold_of(curves, limit), curves.lasting
        rotation = np.append(runs.ratio[here] * branch.overturning, branch.unstable)
        moved = displacement(branch, rotation, mass=1.0)
        of_collapse[here] = moved[:-1] / moved[-1]
        of_limit[here] = of_collapse[here] * threshold.collapse / threshold.moved
    return of_collapse, of_limit


def passes(found: Found) -> bool:
    """Return whether all records leave the body short of d0*, and the governing ratio is within 1."""
    return found.governing_ratio is not None and found.governing_ratio <= 1.0 and not beyond_collapse(found)


def beyond_collapse(found: Found) -> int:
    """Return how many records move beyond d0* without overturning."""
    return sum(1 for each in found.displacements if each.of_collapse is not None and each.of_collapse > 1.0)


def measure_of(oscillator: Oscillator, context: Context, limit: Limit) -> Measure:
    """Return the governing ratio and the rule in every draw, as functions of a suite."""

    def measure(suite: Suite) -> tuple[FloatArray, BoolArray]:
        collapse, near = (draw_values(each) for each in run_ratios(oscillator, context, suite, limit))
        few = near.shape[1] < FOR_THE_MEAN
        ratio = near.max(axis=1) if few else near.mean(axis=1)
        return ratio, (ratio <= 1.0) & (collapse <= 1.0).all(axis=1)

    return measure
