"""Values of uncertain numbers by their inverse distributions, within what is physically possible.

A distribution that reaches beyond a limit, as a lognormal restitution beyond 1, is cut there and the rest scaled up.
"""

from __future__ import annotations

from math import log1p, sqrt

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ndtr, ndtri

from assess.results.uncertainty import Distribution
from assess.study.study import Sampled
from spectra.arrays import FloatArray

PARTS = 4096
"""Equally likely values that a mean is taken over."""


def values_at(number: Sampled, probability: ArrayLike) -> FloatArray:
    """Return the values of a number that it does not exceed with these probabilities.

    Parameters
    ----------
    number : with its mean m and coefficient of variation V
    probability : in (0, 1) [n]

    Returns
    -------
    [n] [unit of the number]
    """
    given = number.given
    below, above = _beyond(number)
    p = below + np.asarray(probability, dtype=np.float64) * (1.0 - below - above)
    return given.mean * _shares(given.distribution, given.cov, p)


def share_cut_off(number: Sampled) -> float:
    """Return the probability that a number would lie beyond its physical limits, if it had none."""
    return sum(_beyond(number))


def mean_kept(number: Sampled) -> float:
    """Return the mean of the values that a number takes within its physical limits, over the mean that is given."""
    middles = (np.arange(PARTS) + 0.5) / PARTS
    return float(values_at(number, middles).mean() / number.given.mean)


def _beyond(number: Sampled) -> tuple[float, float]:
    """Return the probabilities below the least and above the most share of the mean."""
    kind, cov = number.given.distribution, number.given.cov
    return _probability(kind, cov, number.least), 1.0 - _probability(kind, cov, number.most)


def _shares(kind: Distribution, cov: float, p: FloatArray) -> FloatArray:
    """Return values over the mean: 1 + V z; exp(b z - b^2 / 2) with b^2 = ln(1 + V^2); 1 + sqrt(3) V (2 p - 1)."""
    if kind == "uniform":
        return 1.0 + sqrt(3.0) * cov * (2.0 * p - 1.0)
    z = ndtri(p)
    if kind == "normal":
        return np.asarray(1.0 + cov * z)
    b = sqrt(log1p(cov**2))
    return np.asarray(np.exp(b * z - b**2 / 2.0))


def _probability(kind: Distribution, cov: float, share: float) -> float:
    """Return the probability of a value below a share of the mean: the inverse of `_shares`."""
    if kind == "uniform":
        return float(np.clip(0.5 + (share - 1.0) / (2.0 * sqrt(3.0) * cov), 0.0, 1.0))
    if kind == "normal":
        return float(ndtr((share - 1.0) / cov))
    if share <= 0.0:
        return 0.0
    b = sqrt(log1p(cov**2))
    return float(ndtr((np.log(share) + b**2 / 2.0) / b))
