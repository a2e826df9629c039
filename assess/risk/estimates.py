"""Three estimates of fragility from histories: a lognormal curve, the share of records that reach a state, a cloud."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import expit, log_expit, log_ndtr, ndtr, ndtri, stdtr, stdtrit

from assess.short_repr import ShortRepr
from spectra.arrays import BoolArray, FloatArray, IntArray


class UnboundedReason(StrEnum):
    """Why data do not bound a lognormal curve."""

    NONE_REACH = "none-reach"
    ALL_REACH = "all-reach"
    ONE_INTENSITY = "one-intensity"
    SEPARATED = "separated"
    """All that reach the state lie above all that do not: any dispersion down to zero fits."""
    FALLING = "falling"
    """The share that reaches the state does not rise with intensity."""


@dataclass(frozen=True, repr=False)
class Lognormal(ShortRepr):
    """A lognormal distribution of the intensity at which a state is reached.

    median [unit of intensity]; dispersion : standard deviation of its natural logarithm [-]
    """

    median: float
    dispersion: float

    def probability(self, intensity: ArrayLike) -> FloatArray:
        """Return the probability that the state is reached at each intensity, any shape, zero at zero [-]."""
        at = np.asarray(intensity, dtype=np.float64)
        with np.errstate(divide="ignore"):
            return np.asarray(ndtr(np.log(at / self.median) / self.dispersion))

    def quantile(self, probability: ArrayLike) -> FloatArray:
        """Return the intensity at which the state is reached with each probability, any shape."""
        return np.asarray(self.median * np.exp(self.dispersion * ndtri(np.asarray(probability, dtype=np.float64))))

    def convolve(self, dispersion: float) -> Lognormal:
        """Return the lognormal of the same median whose variance has that of another independent factor added.

        Parameters
        ----------
        dispersion : standard deviation of the natural logarithm of the factor [-]
        """
        return Lognormal(self.median, float(np.hypot(self.dispersion, dispersion)))

    @property
    def mean(self) -> float:
        """Mean of the intensity: m exp(beta^2 / 2) [unit of intensity]."""
        return float(self.median * np.exp(0.5 * self.dispersion**2))

    @property
    def standard_deviation(self) -> float:
        """Standard deviation of the intensity: mean sqrt(exp(beta^2) - 1) [unit of intensity]."""
        return float(self.mean * np.sqrt(np.expm1(self.dispersion**2)))


def fit_lognormal(intensity: ArrayLike, reached: ArrayLike, records: ArrayLike) -> Lognormal | None:
    """Return the lognormal of greatest likelihood; None where the data do not bound one: see `unbounded_reason`.

    Parameters
    ----------
    intensity : of each stripe, or of each record where all differ; positive, in any order [k]
    reached : how many reach the state at each [k]
    records : how many there are at each [k]
    """
    counts = (np.atleast_2d(np.asarray(each, dtype=np.float64)) for each in (reached, records))
    median, dispersion = fit_lognormals(np.asarray(intensity, dtype=np.float64), *counts)
    return None if np.isnan(median[0]) else Lognormal(float(median[0]), float(dispersion[0]))


def fit_lognormals(intensity: FloatArray, reached: FloatArray, records: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return medians and dispersions [draws] of many sets of counts at once; nan where one does not bound them.

    Parameters
    ----------
    intensity : positive [k]
    reached : how many reach the state at each intensity [draws, k]
    records : how many there are at each intensity [draws, k]
    """
    a, b = _fit_binomial(np.log(intensity), reached, records, link="probit").T
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        median, dispersion = np.exp(-a / b), 1.0 / b
    bounded = (b > 0.0) & np.isfinite(median) & (median > 0.0) & np.isfinite(dispersion)
    return np.where(bounded, median, np.nan), np.where(bounded, dispersion, np.nan)


def unbounded_reason(intensity: ArrayLike, reached: ArrayLike, records: ArrayLike) -> UnboundedReason | None:
    """Return why counts do not bound a lognormal; None where they do.

    Parameters
    ----------
    intensity : positive [k]
    reached : how many reach the state at each [k]
    records : how many there are at each [k]
    """
    x = np.log(np.asarray(intensity, dtype=np.float64))
    reached_counts, record_counts = (np.atleast_2d(np.asarray(each, dtype=np.float64)) for each in (reached, records))
    if not reached_counts.any():
        return UnboundedReason.NONE_REACH
    if np.array_equal(reached_counts, record_counts):
        return UnboundedReason.ALL_REACH
    if np.unique(x[record_counts[0] > 0]).size < 2:
        return UnboundedReason.ONE_INTENSITY
    if not _counts_overlap(x, reached_counts, record_counts)[0]:
        (first_reached, _), (_, last_not) = (
            _least_and_largest(x, reached_counts > 0),
            _least_and_largest(x, record_counts > reached_counts),
        )
        return UnboundedReason.SEPARATED if first_reached[0] >= last_not[0] else UnboundedReason.FALLING
    return UnboundedReason.FALLING if fit_lognormal(intensity, reached, records) is None else None


class _BinomialLikelihood:
    """The likelihood of counts: called with parameters and draws, as `_maximise_likelihood` does."""

    def __init__(self, x: FloatArray, reached: FloatArray, records: FloatArray, link: LinkFunction) -> None:
        self.x, self.reached, self.others, self.link = x, reached, records - reached, link

    def __call__(self, theta: FloatArray, draws: IntArray) -> Likelihood:
        z = theta[:, :1] + theta[:, 1:] * self.x
        reached, others = self.reached[draws], self.others[draws]
        value, slope, bend = (_probit if self.link == "probit" else _logit)(z, reached, others)
        gradient = np.stack([slope.sum(axis=1), slope @ self.x], axis=1)
        curvature = np.stack([bend.sum(axis=1), bend @ self.x, bend @ self.x**2], axis=1)
        return Likelihood(value.sum(axis=1), gradient, curvature)


def fit_first_exceedances(stands: FloatArray, reaches: FloatArray, counts: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return medians and dispersions [draws] with each record counted several times; nan where they are not bounded.

    Parameters
    ----------
    stands : largest intensity below the first exceedance at which each record was run; 0 where it reaches the state at
        its least one [records]
    reaches : intensity of the first exceedance; inf where it stands at its largest scale; equal to `stands` where it is
        known exactly [records]
    counts : how often each record is drawn [draws, records]
    """
    with np.errstate(divide="ignore"):
        lower, upper = np.log(stands), np.log(reaches)
    drawn = counts > 0
    bounded = np.where(drawn, lower, -np.inf).max(axis=1) > np.where(drawn, upper, np.inf).min(axis=1)
    median, dispersion = np.full(len(counts), np.nan), np.full(len(counts), np.nan)
    if bounded.any():
        known = np.concatenate([lower[np.isfinite(lower)], upper[np.isfinite(upper)]])
        middle, spread = float(known.mean()), float(known.std())
        low, high, n = (lower - middle) / spread, (upper - middle) / spread, counts[bounded]
        standard_normal = np.array([[0.0, 1.0]])
        pooled_fit = _maximise_likelihood(_IntervalLikelihood(low, high, n.sum(axis=0, keepdims=True)), standard_normal)
        start = np.tile(pooled_fit if np.isfinite(pooled_fit).all() else standard_normal, (len(n), 1))
        a, b = _maximise_likelihood(_IntervalLikelihood(low, high, n), start).T
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            m, beta = np.exp(middle - a / b * spread), spread / b
        good = (b > 0.0) & np.isfinite(m) & (m > 0.0) & np.isfinite(beta)
        median[bounded], dispersion[bounded] = np.where(good, m, np.nan), np.where(good, beta, np.nan)
    return median, dispersion


class _IntervalLikelihood:
    """The likelihood of normal variables known to lie between bounds, in a + b x: called by `_maximise_likelihood`.

    It is concave in a and b (Burridge 1981, J. R. Stat. Soc. B 43, 41-45).
    """

    def __init__(self, lower: FloatArray, upper: FloatArray, counts: FloatArray) -> None:
        self.exact = lower == upper
        self.lower, self.upper, self.counts = lower, upper, counts

    def __call__(self, theta: FloatArray, draws: IntArray) -> Likelihood:
        between, exact = ~self.exact, self.exact
        n, m = self.counts[draws][:, between], self.counts[draws][:, exact]
        first, second = self._between(theta, self.lower[between], self.upper[between], n), self._exact(theta, m)
        return Likelihood(*(one + other for one, other in zip(first, second, strict=True)))

    def _exact(self, theta: FloatArray, n: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        x, b = self.lower[self.exact], theta[:, 1]
        z = theta[:, :1] + theta[:, 1:] * x
        total = n.sum(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            value = np.where(total > 0.0, total * np.log(b), 0.0) - 0.5 * (n * z**2).sum(axis=1)
            gradient = np.stack([-(n * z).sum(axis=1), total / b - (n * z) @ x], axis=1)
            curvature = np.stack([-total, -(n @ x), -total / b**2 - n @ x**2], axis=1)
        return value, gradient, curvature

    @staticmethod
    def _between(
        theta: FloatArray, lower: FloatArray, upper: FloatArray, n: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        a, b = theta[:, :1], theta[:, 1:]
        # an infinite bound has no density: any finite place does in the derivatives
        x_l, x_u = np.where(np.isinf(lower), 0.0, lower), np.where(np.isinf(upper), 0.0, upper)
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            z_l, z_u = (np.where(np.isinf(x), x, a + b * y) for x, y in ((lower, x_l), (upper, x_u)))
            log_p = _log_probability_between(z_l, z_u)
            w_l, w_u = (np.exp(-0.5 * z**2 - 0.5 * np.log(2.0 * np.pi) - log_p) for z in (z_l, z_u))
        q_l, q_u = (np.where(w > 0.0, w * np.where(np.isinf(z), 0.0, z), 0.0) for w, z in ((w_l, z_l), (w_u, z_u)))
        s_a, s_b = w_u - w_l, w_u * x_u - w_l * x_l
        aa = -(q_u - q_l) - s_a**2
        ab = -(q_u * x_u - q_l * x_l) - s_a * s_b
        bb = -(q_u * x_u**2 - q_l * x_l**2) - s_b**2
        value = np.where(n > 0.0, n * log_p, 0.0).sum(axis=1)
        gradient = np.stack([(n * s_a).sum(axis=1), (n * s_b).sum(axis=1)], axis=1)
        return value, gradient, np.stack([(n * each).sum(axis=1) for each in (aa, ab, bb)], axis=1)


ITERATIONS = 60
HALVINGS = 30
STEP = 1e-10  # relative step at which a draw has converged


@dataclass(frozen=True, repr=False)
class Likelihood(ShortRepr):
    """Log-likelihoods at one point each: value [n], gradient [n, 2], curvature [n, 3] as (aa, ab, bb)."""

    value: FloatArray
    gradient: FloatArray
    curvature: FloatArray


@dataclass(frozen=True, repr=False)
class EmpiricalCurve(ShortRepr):
    """Shares of records at intensities, linear in the logarithm of intensity between them; they need not rise.

    Below the first intensity and above the last its own share is held: nothing is known there.
    intensity [n] positive, rising; share [n] [-]
    """

    intensity: FloatArray
    share: FloatArray

    def probability(self, intensity: ArrayLike) -> FloatArray:
        """Return the share at each intensity, any shape [-]."""
        at = np.asarray(intensity, dtype=np.float64)
        with np.errstate(divide="ignore"):
            return np.asarray(np.interp(np.log(at), np.log(self.intensity), self.share))

    def convolve(self, dispersion: float) -> WidenedCurve:
        """Return the mean of the curve over a lognormal factor of median 1 on the intensity.

        Parameters
        ----------
        dispersion : standard deviation of the natural logarithm of the factor, positive [-]
        """
        return WidenedCurve(self, dispersion)


@dataclass(frozen=True, repr=False)
class WidenedCurve(ShortRepr):
    """The mean of an empirical curve over a lognormal factor of median 1 on the intensity.

    curve : of slopes s_j in u = ln IM; dispersion : beta, of the logarithm of the factor, positive [-]
    """

    curve: EmpiricalCurve
    dispersion: float

    def probability(self, intensity: ArrayLike) -> FloatArray:
        """Return the probability that the state is reached at each positive intensity, any shape [-].

        The curve is its first share and a ramp (s_j - s_(j-1)) max(u - u_j, 0) for each point. The mean of max(x, 0)
        over a normal x of mean m and standard deviation beta is m Phi(m / beta) + beta phi(m / beta).
        """
        beta, u_j = self.dispersion, np.log(self.curve.intensity)
        slopes = np.diff(self.curve.share) / np.diff(u_j)
        d = (np.log(np.asarray(intensity, dtype=np.float64))[..., None] - u_j) / beta
        ramps = beta * (d * ndtr(d) + np.exp(-0.5 * d**2) / np.sqrt(2.0 * np.pi))
        return np.asarray(np.clip(self.curve.share[0] + ramps @ np.diff(slopes, prepend=0.0, append=0.0), 0.0, 1.0))


def wilson_interval(
    reached: ArrayLike, records: ArrayLike, *, confidence: float = 0.95
) -> tuple[FloatArray, FloatArray]:
    """Return the lower and upper bounds of the probability behind each share, each of the shape given.

    Records count as independent: those of one earthquake are not, and their interval is then too narrow.

    Parameters
    ----------
    reached : how many reach the state
    records : how many there are, at least one
    confidence : of the interval [-]
    """
    n = np.asarray(records, dtype=np.float64)
    p = np.asarray(reached, dtype=np.float64) / n
    z = float(ndtri(0.5 + 0.5 * confidence))
    centre = (p + z**2 / (2.0 * n)) / (1.0 + z**2 / n)
    half = z / (1.0 + z**2 / n) * np.sqrt(p * (1.0 - p) / n + z**2 / (4.0 * n**2))
    low = np.where(p == 0.0, 0.0, np.clip(centre - half, 0.0, 1.0))
    return low, np.where(p == 1.0, 1.0, np.clip(centre + half, 0.0, 1.0))


LEAST_EVENTS = 3


def event_counts(event: Sequence[str], *, seed: int, draws: int) -> FloatArray:
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
    draws_of_event = generator.multinomial(events, np.full(events, 1.0 / events), size=draws)
    return draws_of_event[:, index].astype(np.float64)


def mirrored_draws(draws: FloatArray, estimate: float) -> FloatArray:
    """Return e^2 / q of each draw q of a positive number: the basic interval is between the quantiles of these [draws].

    Parameters
    ----------
    draws : of the number [draws]
    estimate : of all records
    """
    return np.asarray(estimate**2 / draws)


def widened_quantiles(draws: FloatArray, *, events: int, confidence: float = 0.95) -> FloatArray:
    """Return the lower and the upper quantile of draws [2, ...], with tails made for few events.

    The probability below the lower quantile is widened for few events (Hesterberg 2015, section 3.2).

    Parameters
    ----------
    draws : of any number of values [draws, ...]
    events : how many earthquakes are drawn, at least three
    confidence : of the interval [-]
    """
    t = float(stdtrit(events - 1, 0.5 - 0.5 * confidence))
    tail = float(ndtr(t * np.sqrt(events / (events - 1))))
    return np.asarray(np.quantile(draws, [tail, 1.0 - tail], axis=0, method="weibull"))


STEEP = 1e6  # slope of a logistic curve that stands for a step
REACH = 7.0  # powers of e beyond the intensities of the records in which an equivalent curve is sought
LEVELS = (0.16, 0.5, 0.84)
BISECTIONS = 50
LEAST = 3  # records, or groups, that a slope with its spread needs


@dataclass(frozen=True, repr=False)
class TrendSlope(ShortRepr):
    """The slope of a straight line through points, with the two-sided p-value of a slope of zero; n : points."""

    slope: float
    p_value: float
    n: int


def equivalent_lognormals(
    intensity: FloatArray, demand: FloatArray, counts: FloatArray, threshold: float
) -> tuple[FloatArray, FloatArray]:
    """Return medians and dispersions [draws] of the lognormals equivalent to clouds; nan where there is none.

    They have the cloud's median and half its logarithmic range from 16 to 84 %; there is none where the cloud does not
    pass through these within a factor exp(7) of the records.

    Parameters
    ----------
    intensity : of each record, positive [records]
    demand : largest rotation, or its ratio to the one that overturns: 0 where it does not rock, inf where it overturns
        [records]
    counts : how often each record is drawn [draws, records]
    threshold : demand at which the state is reached; inf for overturning
    """
    return _equivalents(fit_clouds(intensity, demand, counts), np.log(intensity), threshold)


def trend(residual: ArrayLike, on: ArrayLike, *, event: Sequence[str] | None = None) -> TrendSlope | None:
    """Return the slope of residuals on a property; None with fewer than three points or events, or without spread.

    With events the p-value is that of the cluster-robust variance (CR1) with Student's t of events less one degrees of
    freedom: Cameron and Miller 2015, J. Human Resources 50(2), section II and VI. Without, of least squares.

    Parameters
    ----------
    residual : of the logarithm of intensity [n]
    on : magnitude, or the logarithm of distance or scale [n]
    event : earthquake of each point, whose residuals go together [n]
    """
    y, x = (np.asarray(each, dtype=np.float64) for each in (residual, on))
    groups = np.arange(x.size) if event is None else np.unique(np.asarray(event, dtype=str), return_inverse=True)[1]
    number = int(groups.max(initial=-1)) + 1
    centred = x - x.mean() if x.size else x
    spread = float(centred @ centred)
    if number < LEAST or spread <= 1e-24 * float(x @ x):
        return None
    slope = float(centred @ y) / spread
    left = y - y.mean() - slope * centred
    if event is None:
        variance, freedom = float(left @ left) / (x.size - 2) / spread, x.size - 2
    else:
        scores = np.bincount(groups, weights=centred * left)
        factor = number / (number - 1) * (x.size - 1) / (x.size - 2)
        variance, freedom = factor * float(scores @ scores) / spread**2, number - 1
    error = float(np.sqrt(variance))
    return TrendSlope(slope, float(2.0 * stdtr(freedom, -abs(slope) / error)) if error > 0.0 else 0.0, int(x.size))


def holm(p_values: ArrayLike) -> FloatArray:
    """Return p-values corrected for their number: the chance that any of them comes to be so small, at most [n].

    Source: Holm 1979, Scandinavian J. Statistics 6, 65-70.
    """
    p = np.asarray(p_values, dtype=np.float64)
    order = np.argsort(p, kind="stable")
    corrected = np.empty_like(p)
    corrected[order] = np.maximum.accumulate(np.minimum(p[order] * np.arange(p.size, 0, -1), 1.0))
    return corrected


def fit_clouds(intensity: FloatArray, demand: FloatArray, counts: FloatArray) -> FloatArray:
    """Return the clouds of draws [draws, 7]; nan where fewer than three records at two intensities rock on.

    A row is intercept, slope and sigma of ln D = a + b ln IM + sigma N(0, 1) of those that rock and do not overturn,
    then intercept and slope in ln IM of the logistic probability that a record which does not overturn it makes it
    rock, and those of the probability that a record overturns it.

    Parameters
    ----------
    intensity : as `equivalent_lognormals` takes it [records]
    demand : as `equivalent_lognormals` takes it [records]
    counts : how often each record is drawn [draws, records]
    """
    x, over = np.log(intensity), np.isinf(demand)
    rocks = (demand > 0.0) & ~over
    line = _lines(x[rocks], np.log(demand[rocks]), counts[:, rocks])
    stood = counts[:, ~over]
    return np.hstack([line, _logistic(x[~over], stood * rocks[~over], stood), _logistic(x, counts * over, counts)])


def cloud_probability(row: FloatArray, u: FloatArray, threshold: float) -> FloatArray:
    """Return the probabilities that the demand exceeds a threshold [draws, m].

    Parameters
    ----------
    row : clouds, as `fit_clouds` returns them [draws, 7]
    u : logarithms of intensity [draws, m], or [1, m] for all draws
    threshold : in the demand's unit; inf for overturning
    """
    a, b, sigma, a_r, b_r, a_o, b_o = (each[:, None] for each in row.T)
    overturns, rocks = expit(a_o + b_o * u), expit(a_r + b_r * u)
    if np.isinf(threshold):
        return np.asarray(overturns)
    with np.errstate(divide="ignore", invalid="ignore"):
        exceeds = ndtr((a + b * u - np.log(threshold)) / sigma) if threshold > 0.0 else np.ones_like(u)
    return np.asarray(overturns + (1.0 - overturns) * rocks * exceeds)


LinkFunction = Literal["probit", "logit"]


def _fit_binomial(x: FloatArray, reached: FloatArray, records: FloatArray, *, link: LinkFunction) -> FloatArray:
    """Return intercepts and slopes [draws, 2] by maximum likelihood; nan where the counts do not overlap.

    Parameters
    ----------
    x : variable of each group [k]
    reached : how many reach the state in each group [draws, k]
    records : how many there are in each group [draws, k]
    link : "probit" or "logit"
    """
    theta = np.full((len(reached), 2), np.nan)
    overlap = _counts_overlap(x, reached, records)
    if overlap.any():
        mean, spread = float(np.mean(x)), float(np.std(x))
        u, reached_counts, record_counts = (x - mean) / spread, reached[overlap], records[overlap]
        pooled = _BinomialLikelihood(
            u, reached_counts.sum(axis=0, keepdims=True), record_counts.sum(axis=0, keepdims=True), link
        )
        pooled_fit = _maximise_likelihood(pooled, np.zeros((1, 2)))  # of all draws together: fewer steps for each
        start = np.tile(np.nan_to_num(pooled_fit), (len(reached_counts), 1))
        a, b = _maximise_likelihood(_BinomialLikelihood(u, reached_counts, record_counts, link), start).T
        theta[overlap] = np.stack([a - b * mean / spread, b / spread], axis=1)
    return theta


def _counts_overlap(x: FloatArray, reached: FloatArray, records: FloatArray) -> BoolArray:
    """Tell of each draw whether its likelihood has a finite maximum [draws].

    Parameters
    ----------
    x : variable of each group [k]
    reached : how many reach the state in each group [draws, k]
    records : how many there are in each group [draws, k]
    """
    first_reached, last_reached = _least_and_largest(x, reached > 0)
    first_not, last_not = _least_and_largest(x, records > reached)
    return np.asarray((first_reached < last_not) & (first_not < last_reached))


def _least_and_largest(x: FloatArray, counted: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Return the least and largest variable of the groups counted [draws]; inf and -inf where none is.

    Parameters
    ----------
    x : variable of each group [k]
    counted : which groups count [draws, k]
    """
    least = np.where(counted, x, np.inf).min(axis=1, initial=np.inf)
    return least, np.where(counted, x, -np.inf).max(axis=1, initial=-np.inf)


def _probit(z: FloatArray, reached: FloatArray, others: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the terms of the likelihood with their first and second derivatives by z [draws, k]."""
    log_p, log_q = log_ndtr(z), log_ndtr(-z)
    log_density = -0.5 * z**2 - 0.5 * np.log(2.0 * np.pi)
    u, v = np.exp(log_density - log_p), np.exp(log_density - log_q)
    return reached * log_p + others * log_q, reached * u - others * v, -reached * u * (z + u) - others * v * (v - z)


def _logit(z: FloatArray, reached: FloatArray, others: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the terms of the likelihood with their first and second derivatives by z [draws, k]."""
    p, records = expit(z), reached + others
    return reached * log_expit(z) + others * log_expit(-z), reached - records * p, -records * p * (1.0 - p)


def _log_probability_between(lower: FloatArray, upper: FloatArray) -> FloatArray:
    """Return the logarithm of the normal probability between bounds, taken in the tail where it is accurate."""
    flip = lower > 0.0
    low, high = np.where(flip, -upper, lower), np.where(flip, -lower, upper)
    big, small = log_ndtr(high), log_ndtr(low)
    return np.asarray(big + np.log1p(-np.exp(small - big)))


Terms = Callable[[FloatArray, IntArray], Likelihood]


def _maximise_likelihood(terms: Terms, start: FloatArray) -> FloatArray:
    """Return the parameters [draws, 2] at which each likelihood is largest; nan where the search does not converge.

    Parameters
    ----------
    terms : takes parameters [n, 2] and the draws [n] that they belong to
    start : parameters to begin at, of finite likelihood [draws, 2]
    """
    theta = np.array(start, dtype=np.float64)
    active = np.arange(len(theta))
    likelihood = terms(theta, active)
    for _ in range(ITERATIONS):
        step = _newton_step(likelihood)
        theta[active], likelihood = _halve_steps(terms, theta[active], step, likelihood, active)
        not_converged = ~(np.abs(step).max(axis=1) <= STEP * (1.0 + np.abs(theta[active]).max(axis=1)))
        active, likelihood = active[not_converged], Likelihood(*(each[not_converged] for each in _arrays(likelihood)))
        if not active.size:
            break
    theta[active] = np.nan
    return theta


def _newton_step(likelihood: Likelihood) -> FloatArray:
    """Return Newton's steps [n, 2]; zero curvature gives a step that is not finite."""
    (g_a, g_b), (aa, ab, bb) = likelihood.gradient.T, likelihood.curvature.T
    with np.errstate(divide="ignore", invalid="ignore"):
        step = np.stack([ab * g_b - bb * g_a, ab * g_a - aa * g_b], axis=1) / (aa * bb - ab**2)[:, None]
    return np.asarray(step)


def _halve_steps(
    terms: Terms, theta: FloatArray, step: FloatArray, likelihood: Likelihood, draws: IntArray
) -> tuple[FloatArray, Likelihood]:
    """Return the parameters after steps halved until no likelihood falls, and the likelihoods there."""
    step = np.where(np.isfinite(step), step, 0.0)
    tried = theta + step
    tried_likelihood = terms(tried, draws)
    for _ in range(HALVINGS):
        worse = ~(tried_likelihood.value >= likelihood.value - 1e-12 * np.abs(likelihood.value))
        if not worse.any():
            break
        step[worse] *= 0.5
        tried[worse] = theta[worse] + step[worse]
        halved = terms(tried[worse], draws[worse])
        for whole, part in zip(_arrays(tried_likelihood), _arrays(halved), strict=True):
            whole[worse] = part
    return tried, tried_likelihood


def _arrays(likelihood: Likelihood) -> tuple[FloatArray, FloatArray, FloatArray]:
    return likelihood.value, likelihood.gradient, likelihood.curvature


def _lines(x: FloatArray, y: FloatArray, n: FloatArray) -> FloatArray:
    """Return intercept, slope and standard deviation about the line of each draw [draws, 3]."""
    total = n.sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        x_0, y_0 = n @ x / total, n @ y / total
        u, v = x - x_0[:, None], y - y_0[:, None]
        s_xx = (n * u**2).sum(axis=1)
        slope = (n * u * v).sum(axis=1) / np.where(s_xx > 0.0, s_xx, np.nan)
        left = (n * (v - slope[:, None] * u) ** 2).sum(axis=1)
        sigma = np.sqrt(left / np.where(total >= LEAST, total - 2.0, np.nan))
    return np.stack([y_0 - slope * x_0, slope, sigma], axis=1)


def _logistic(x: FloatArray, reached: FloatArray, records: FloatArray) -> FloatArray:
    """Return logistic curves [draws, 2]; a step half way where data are separated, a constant where all are alike."""
    theta = _fit_binomial(x, reached, records, link="logit")
    (first, last), (first_not, last_not) = _least_and_largest(x, reached > 0), _least_and_largest(x, records > reached)
    apart = ~_counts_overlap(x, reached, records)
    rises = first >= last_not
    with np.errstate(invalid="ignore"):
        middle = np.where(rises, 0.5 * (first + last_not), 0.5 * (last + first_not))
        step = np.stack([np.where(rises, -STEEP, STEEP) * middle, np.where(rises, STEEP, -STEEP)], axis=1)
    none, every = np.isinf(first), np.isinf(first_not)
    theta = np.where(apart[:, None], step, theta)
    theta = np.where(every[:, None], [np.inf, 0.0], theta)
    return np.asarray(np.where(none[:, None], [-np.inf, 0.0], theta))


def _equivalents(row: FloatArray, u: FloatArray, threshold: float) -> tuple[FloatArray, FloatArray]:
    """Return medians and dispersions of the lognormals with the 16, 50 and 84 % of clouds [draws]."""
    start = np.full((len(row), len(LEVELS)), u.min() - REACH)
    low, high = start, np.full_like(start, u.max() + REACH)
    inside = (cloud_probability(row, low, threshold) < LEVELS) & (cloud_probability(row, high, threshold) > LEVELS)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        below = cloud_probability(row, middle, threshold) < LEVELS
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    good = inside.all(axis=1) & (high[:, 2] > high[:, 0])
    return np.where(good, np.exp(high[:, 1]), np.nan), np.where(good, 0.5 * (high[:, 2] - high[:, 0]), np.nan)
