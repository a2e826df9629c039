"""Curves in a measure that is proportional to another: the same ones, in other units."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from assess.results.fragility import CurveBand, FragilityCurve, LognormalResult, MeasureResult
from spectra.arrays import FloatArray

ROUNDING = 1e-9
"""Relative difference below which the ratios of two measures are one number."""


def factor_between(one: FloatArray, other: FloatArray) -> float | None:
    """Return the number that intensities of one measure are times those of another [records]; None if it varies."""
    ratio = other / one
    return float(ratio[0]) if np.ptp(ratio) <= ROUNDING * ratio[0] else None


def convert(curve: FragilityCurve, measure: MeasureResult, factor: float) -> FragilityCurve:
    """Return a curve in another measure.

    Parameters
    ----------
    curve : in its own measure
    measure : the other one
    factor : intensity of the other measure over that of its own
    """
    return replace(
        curve,
        measure=measure,
        empirical=tuple(replace(point, intensity=factor * point.intensity) for point in curve.empirical),
        lognormal=_lognormal(curve.lognormal, factor),
        first=_lognormal(curve.first, factor),
        least_run=None if curve.least_run is None else factor * curve.least_run,
        largest_run=None if curve.largest_run is None else factor * curve.largest_run,
    )


def _lognormal(fitted: LognormalResult | None, factor: float) -> LognormalResult | None:
    if fitted is None:
        return None
    band = fitted.band
    return replace(
        fitted,
        median=factor * fitted.median,
        median_interval=_interval(fitted.median_interval, factor),
        five_percent_interval=_interval(fitted.five_percent_interval, factor),
        band=None if band is None else CurveBand(tuple(factor * at for at in band.intensity), band.low, band.high),
    )


def _interval(found: tuple[float, float] | None, factor: float) -> tuple[float, float] | None:
    return None if found is None else (factor * found[0], factor * found[1])
