"""Bootstrap intervals of fragility by earthquake: all records of one event are drawn together.

Source: Efron and Tibshirani 1993, "An Introduction to the Bootstrap", chapters 13 and 14; resampling of whole clusters,
Davison and Hinkley 1997, section 3.8.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from assess.risk.censored import fit_firsts
from assess.risk.lognormal import fit_lognormals
from assess.risk.regression import equivalent_lognormals
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

DRAWS = 500
Fit = Callable[[FloatArray], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True, repr=False)
class LognormalIntervals(ShortRepr):
    """Intervals of median and dispersion; None where draws fail.

    median [unit of intensity], dispersion [-] : lower and upper bound
    draws : how many; unbounded : draws whose data do not bound a curve, left out of the intervals
    """

    median: tuple[float, float] | None
    dispersion: tuple[float, float] | None
    draws: int
    unbounded: int


def bootstrap_lognormal(
    intensity: ArrayLike,
    reached: ArrayLike,
    event: Sequence[str],
    *,
    seed: int,
    draws: int = DRAWS,
    run: ArrayLike | None = None,
    confidence: float = 0.95,
) -> LognormalIntervals:
    """Return the intervals of the curve that `fit_lognormal` fits to the counts at each intensity.

    Parameters
    ----------
    intensity : of the stripes [k], or of each run of each record [records, k]
    reached : whether each record reaches the state in each run [records, k]
    event : earthquake of each record [records]
    seed : of the random draws
    draws : how many
    run : which runs there are; absent: all [records, k]
    confidence : of the intervals [-]
    """
    yes = np.asarray(reached, dtype=bool)
    there = np.ones(yes.shape, dtype=bool) if run is None else np.asarray(run, dtype=bool)
    im = np.asarray(intensity, dtype=np.float64)

    def fit(counts: FloatArray) -> tuple[FloatArray, FloatArray]:
        if im.ndim == 1:
            return fit_lognormals(im, counts @ (yes & there), counts @ there)
        each = np.broadcast_to(counts[:, :, None], (len(counts), *there.shape))[:, there]
        return fit_lognormals(im[there], each * yes[there], each)

    return bootstrap(fit, event, seed=seed, draws=draws, confidence=confidence)


def bootstrap_first(
    stands: ArrayLike,
    reaches: ArrayLike,
    event: Sequence[str],
    *,
    seed: int,
    draws: int = DRAWS,
    confidence: float = 0.95,
) -> LognormalIntervals:
    """Return the intervals of the curve that `fit_first` fits to first exceedances.

    Parameters
    ----------
    stands : as `fit_first` takes it [records]
    reaches : as `fit_first` takes it [records]
    event : earthquake of each record [records]
    seed : of the random draws
    draws : how many
    confidence : of the intervals [-]
    """
    lower, upper = (np.asarray(each, dtype=np.float64) for each in (stands, reaches))
    return bootstrap(
        lambda counts: fit_firsts(lower, upper, counts), event, seed=seed, draws=draws, confidence=confidence
    )


def bootstrap_cloud(
    intensity: ArrayLike,
    demand: ArrayLike,
    event: Sequence[str],
    *,
    threshold: float,
    seed: int,
    draws: int = DRAWS,
    confidence: float = 0.95,
) -> LognormalIntervals:
    """Return the intervals of the lognormal equivalent to a cloud.

    Parameters
    ----------
    intensity : as `fit_cloud` takes it [records]
    demand : as `fit_cloud` takes it [records]
    event : earthquake of each record [records]
    threshold : demand at which the state is reached; inf for overturning
    seed : of the random draws
    draws : how many
    confidence : of the intervals [-]
    """
    im, d = (np.asarray(each, dtype=np.float64) for each in (intensity, demand))
    return bootstrap(
        lambda counts: equivalent_lognormals(im, d, counts, threshold),
        event, seed=seed, draws=draws, confidence=confidence,
    )  # fmt: skip


def bootstrap(
    fit: Fit, event: Sequence[str], *, seed: int, draws: int = DRAWS, confidence: float = 0.95
) -> LognormalIntervals:
    """Return the intervals of any fit of median and dispersion.

    Parameters
    ----------
    fit : takes how often each record is drawn [draws, records], returns medians and dispersions [draws], nan where the
        draw does not bound them
    event : earthquake of each record [records]
    seed : of the random draws
    draws : how many
    confidence : of the intervals [-]
    """
    median, dispersion = fit(event_counts(event, seed=seed, draws=draws))
    good = np.isfinite(median) & np.isfinite(dispersion)
    unbounded = int(draws - good.sum())
    if unbounded > (1.0 - confidence) * draws:
        return LognormalIntervals(None, None, draws, unbounded)
    return LognormalIntervals(
        _percentiles(median[good], confidence), _percentiles(dispersion[good], confidence), draws, unbounded
    )


def event_counts(event: Sequence[str], *, seed: int, draws: int = DRAWS) -> FloatArray:
    """Return how often each record is drawn when events are, with replacement [draws, records].

    Parameters
    ----------
    event : earthquake of each record [records]
    seed : of the random draws
    draws : how many
    """
    _, index = np.unique(np.asarray(event, dtype=str), return_inverse=True)
    events = int(index.max()) + 1
    generator = np.random.Generator(np.random.PCG64(seed))
    times = generator.multinomial(events, np.full(events, 1.0 / events), size=draws)
    return times[:, index].astype(np.float64)


def _percentiles(values: FloatArray, confidence: float) -> tuple[float, float]:
    low, high = np.quantile(values, [0.5 - 0.5 * confidence, 0.5 + 0.5 * confidence])
    return float(low), float(high)
