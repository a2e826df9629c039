"""Lognormal curves with their bootstrap intervals, by earthquake."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.special import ndtr

from assess.results.fragility import FIVE_PERCENT, CurveBand, LognormalResult
from assess.risk.bootstrap import event_counts
from spectra.arrays import FloatArray

Fits = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""Takes how often each record counts [draws, records]; returns medians and dispersions [draws], nan where unbounded."""
LIMITS = (0.025, 0.975)
BAND_POINTS = 25
BAND_REACH = 2.5
"""Dispersions to each side of the median over which the band of a curve is given."""


def lognormal_result(fits: Fits, events: Sequence[str], *, seed: int, draws: int) -> LognormalResult | None:
    """Return the lognormal of all records with its intervals; None where they do not bound one.

    An interval is None where more than 5 % of the draws do not bound a curve.

    Parameters
    ----------
    fits : of the curve
    events : earthquake of each record [records]
    seed : of the random draws
    draws : how many
    """
    (median,), (dispersion,) = fits(np.ones((1, len(events))))
    if np.isnan(median):
        return None
    medians, dispersions = fits(event_counts(events, seed=seed, draws=draws))
    good = np.isfinite(medians) & np.isfinite(dispersions)
    plain = LognormalResult(float(median), float(dispersion))
    if np.count_nonzero(good) < (1.0 - (LIMITS[0] + 1.0 - LIMITS[1])) * draws:
        return plain
    return _with_intervals(plain, medians[good], dispersions[good])


def _with_intervals(plain: LognormalResult, medians: FloatArray, dispersions: FloatArray) -> LognormalResult:
    reach = BAND_REACH * plain.dispersion
    at = plain.median * np.exp(np.linspace(-reach, reach, BAND_POINTS))
    low, high = np.quantile(ndtr(np.log(at / medians[:, None]) / dispersions[:, None]), LIMITS, axis=0)
    return LognormalResult(
        median=plain.median,
        dispersion=plain.dispersion,
        median_interval=_interval(medians),
        dispersion_interval=_interval(dispersions),
        five_percent_interval=_interval(medians * np.exp(FIVE_PERCENT * dispersions)),
        band=CurveBand(tuple(at.tolist()), tuple(low.tolist()), tuple(high.tolist())),
    )


def _interval(values: FloatArray) -> tuple[float, float]:
    low, high = np.quantile(values, LIMITS)
    return float(low), float(high)
