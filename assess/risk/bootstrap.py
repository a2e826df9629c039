"""Bootstrap intervals of fragility by earthquake: all records of one event are drawn together.

Intervals are basic ones of the logarithms, 2 ln e - q, with e the estimate, q the quantiles of the draws (Davison and
Hinkley 1997, "Bootstrap Methods and their Application", eq. 5.6; clusters drawn whole as in section 3.8). The quantiles
are those that make a mean's interval as wide as Student's with events less one degrees of freedom (Hesterberg 2015, The
American Statistician 69(4), 371-386, section 3.2). Percentile and BCa intervals of dispersion cover the truth in 69 to
91 % of trials with 10 to 40 events, as maximum likelihood finds it too small; these do in 94 to 97 %.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ndtr, stdtrit

from assess.risk.censored import fit_firsts
from assess.risk.lognormal import fit_lognormals
from assess.risk.regression import equivalent_lognormals
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

DRAWS = 500
LEAST = 3  # events
Fit = Callable[[FloatArray], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True, repr=False)
class LognormalIntervals(ShortRepr):
    """Intervals of median and dispersion; None with fewer than three events, or where too many draws fail.

    median [unit of intensity], dispersion [-] : lower and upper bound
    draws : how many; unbounded : draws whose data do not bound a curve, left out unless more than confidence leaves
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
    (m,), (beta,) = fit(np.ones((1, len(event))))
    good = np.isfinite(median) & np.isfinite(dispersion)
    unbounded, events = int(draws - good.sum()), len(set(event))
    if unbounded > (1.0 - confidence) * draws or np.isnan(m) or events < LEAST:
        return LognormalIntervals(None, None, draws, unbounded)
    tail = _tail(events, confidence)
    return LognormalIntervals(
        _basic(median[good], float(m), tail), _basic(dispersion[good], float(beta), tail), draws, unbounded
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


def basic_interval(draws: FloatArray, estimate: float, *, events: int, confidence: float = 0.95) -> tuple[float, float]:
    """Return the interval of a positive number, of at least three events.

    Parameters
    ----------
    draws : of the number [draws]
    estimate : of all records
    events : how many earthquakes are drawn
    confidence : of the interval [-]
    """
    return _basic(draws, estimate, _tail(events, confidence))


def _tail(events: int, confidence: float) -> float:
    """Return the probability below the lower quantile of the draws, widened for few events (Hesterberg 2015, 3.2)."""
    t = float(stdtrit(events - 1, 0.5 - 0.5 * confidence))
    return float(ndtr(t * np.sqrt(events / (events - 1))))


def _basic(draws: FloatArray, estimate: float, tail: float) -> tuple[float, float]:
    """Return the bounds 2 ln e - q of the draws' quantiles q, as powers of e."""
    low, high = np.quantile(np.log(draws), [tail, 1.0 - tail], method="weibull")
    return float(estimate**2 * np.exp(-high)), float(estimate**2 * np.exp(-low))
