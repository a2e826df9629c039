"""Lognormal curves with their bootstrap intervals, by earthquake."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.special import ndtr

from assess.results.fragility import FIVE_PERCENT, CurveBand, LognormalResult
from assess.risk.bootstrap import LEAST, basic_interval, event_counts
from spectra.arrays import FloatArray

Fits = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""Takes how often each record counts [draws, records]; returns medians and dispersions [draws], nan where unbounded."""
MOST_UNBOUNDED = 0.05
"""Share of draws that need not bound a curve."""
BAND_POINTS = 25
BAND_REACH = 2.5
"""Dispersions to each side of the median over which the band of a curve is given."""

FARTHEST = 30.0
"""Standard deviations beyond which a draw of the band is as good as certain."""


def lognormal_result(fits: Fits, events: Sequence[str], *, seed: int, draws: int) -> LognormalResult | None:
    """Return the lognormal of all records with its intervals; None where they do not bound one.

    Intervals are None where more than 5 % of the draws do not bound a curve, or earthquakes are fewer than three.

    Parameters
    ----------
    fits : of the curve
    events : earthquake of each record [records]
    seed : of the random draws
    draws : how many
    """
    (median,), (dispersion,) = fits(np.ones((1, len(events))))
    if np.isnan(median + dispersion):
        return None
    plain = LognormalResult(float(median), float(dispersion))
    number = len(set(events))
    if number < LEAST:
        return plain
    medians, dispersions = fits(event_counts(events, seed=seed, draws=draws))
    good = np.isfinite(medians) & np.isfinite(dispersions)
    if np.count_nonzero(~good) > MOST_UNBOUNDED * draws:
        return plain
    return _with_intervals(plain, medians[good], dispersions[good], number)


def _with_intervals(
    plain: LognormalResult, medians: FloatArray, dispersions: FloatArray, events: int
) -> LognormalResult:
    five = medians * np.exp(FIVE_PERCENT * dispersions)
    return LognormalResult(
        median=plain.median,
        dispersion=plain.dispersion,
        median_interval=basic_interval(medians, plain.median, events=events),
        dispersion_interval=basic_interval(dispersions, plain.dispersion, events=events),
        five_percent_interval=basic_interval(five, plain.five_percent, events=events),
        band=_band(plain, medians, dispersions, events),
    )


def _band(plain: LognormalResult, medians: FloatArray, dispersions: FloatArray, events: int) -> CurveBand:
    """Return the band of the curve: at each intensity the interval of its standard normal variable."""
    normal = np.linspace(-BAND_REACH, BAND_REACH, BAND_POINTS)
    at = plain.median * np.exp(normal * plain.dispersion)
    drawn = np.clip(np.log(at / medians[:, None]) / dispersions[:, None], -FARTHEST, FARTHEST)
    bounds = np.array(
        [basic_interval(np.exp(each), float(np.exp(z)), events=events) for each, z in zip(drawn.T, normal, strict=True)]
    )
    low, high = ndtr(np.log(bounds)).T
    return CurveBand(tuple(at.tolist()), tuple(low.tolist()), tuple(high.tolist()))
