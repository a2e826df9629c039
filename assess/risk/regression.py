"""Cloud analysis: the demand that records as they are make on a mechanism, regressed on their intensity; and trends.

Source: Jalayer, Ebrahimian, Miano, Manfredi and Sezen 2017, "Analytical fragility assessment using unscaled ground
motion records", Earthquake Engng Struct. Dyn. 46, 2639-2663: linear regression of logarithms for records that do not
collapse, logistic regression for collapse (eq. 5 to 8). Records that leave the mechanism at rest have no logarithm and
are a third class here, with a logistic regression of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import expit, ndtr
from scipy.stats import t as student

from assess.risk.lognormal import counts_overlap, fit_binomial, least_and_largest
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

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
    return TrendSlope(slope, float(2.0 * student.sf(abs(slope) / error, freedom)) if error > 0.0 else 0.0, int(x.size))


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
    theta = fit_binomial(x, reached, records, link="logit")
    (first, last), (first_not, last_not) = least_and_largest(x, reached > 0), least_and_largest(x, records > reached)
    apart = ~counts_overlap(x, reached, records)
    rises = first >= last_not
    with np.errstate(invalid="ignore"):
        middle = np.where(rises, 0.5 * (first + last_not), 0.5 * (last + first_not))
        step = np.stack([np.where(rises, -STEEP, STEEP) * middle, np.where(rises, STEEP, -STEEP)], axis=1)
    none, every = np.isinf(first), np.isinf(first_not)
    theta = np.where(apart[:, None], step, theta)
    theta = np.where(every[:, None], [np.inf, 0.0], theta)
    return np.asarray(np.where(none[:, None], [-np.inf, 0.0], theta))


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
