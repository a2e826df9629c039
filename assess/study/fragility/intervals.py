"""Lognormal curves with their bootstrap intervals, by earthquake."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.special import ndtr

from assess.results.fragility import FIVE_PERCENT, CurveBand, LognormalResult
from assess.risk.bootstrap import LEAST, event_counts, mirrored_draws, widened_quantiles
from spectra.arrays import FloatArray

Fits = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""Takes how often each record counts [draws, records]; returns medians and dispersions [draws], nan where unbounded."""
MOST_UNBOUNDED = 0.05
"""Share of draws that need not bound a curve."""
BAND_POINTS = 25
BAND_REACH = 2.5
"""Dispersions to each side of the median over which the band of a curve is given."""


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
    """Return a lognormal with the quantiles of the curves of mirrored draws.

    Medians and dispersions are mirrored, and not the standard normal variable ln(im / m) / beta: draws of small
    dispersion make that so skewed that its basic interval reaches far below the curve above the median. So the band is
    at 50 % and at 5 % where the intervals of these intensities end.
    """
    m, beta = mirrored_draws(medians, plain.median), mirrored_draws(dispersions, plain.dispersion)

    def ends(draws: FloatArray) -> tuple[float, float]:
        low, high = np.exp(widened_quantiles(np.log(draws), events=events)).tolist()
        return low, high

    normal = np.linspace(-BAND_REACH, BAND_REACH, BAND_POINTS)
    at = plain.median * np.exp(normal * plain.dispersion)
    band = ndtr(widened_quantiles(np.log(at / m[:, None]) / beta[:, None], events=events))
    return LognormalResult(
        median=plain.median,
        dispersion=plain.dispersion,
        median_interval=ends(m),
        dispersion_interval=ends(beta),
        five_percent_interval=ends(m * np.exp(FIVE_PERCENT * beta)),
        band=CurveBand(*(tuple(each.tolist()) for each in (at, *band))),
    )
