"""Regression of counts on one variable: the probability that a record reaches a state is Phi or logistic of a + b x.

A finite maximum of the likelihood exists where counts overlap: neither do all that reach the state lie above all that
do not, nor the other way round (Albert and Anderson 1984, Biometrika 71, 1-10; Silvapulle 1981).
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from scipy.special import expit, log_expit, log_ndtr

from assess.risk.likelihood import Likelihood, maximise_likelihood
from spectra.arrays import BoolArray, FloatArray, IntArray

Link = Literal["probit", "logit"]


def fit_binomial(x: FloatArray, reached: FloatArray, records: FloatArray, *, link: Link) -> FloatArray:
    """Return intercepts and slopes [draws, 2] by maximum likelihood; nan where the counts do not overlap.

    Parameters
    ----------
    x : variable of each group [k]
    reached : how many reach the state in each group [draws, k]
    records : how many there are in each group [draws, k]
    link : "probit" or "logit"
    """
    theta = np.full((len(reached), 2), np.nan)
    overlap = counts_overlap(x, reached, records)
    if overlap.any():
        middle, spread = float(np.mean(x)), float(np.std(x))
        u, yes, n = (x - middle) / spread, reached[overlap], records[overlap]
        pooled = _Counts(u, yes.sum(axis=0, keepdims=True), n.sum(axis=0, keepdims=True), link)
        near = maximise_likelihood(pooled, np.zeros((1, 2)))  # of all draws together: fewer steps for each
        start = np.tile(np.nan_to_num(near), (len(yes), 1))
        a, b = maximise_likelihood(_Counts(u, yes, n, link), start).T
        theta[overlap] = np.stack([a - b * middle / spread, b / spread], axis=1)
    return theta


def counts_overlap(x: FloatArray, reached: FloatArray, records: FloatArray) -> BoolArray:
    """Tell of each draw whether its likelihood has a finite maximum [draws].

    Parameters
    ----------
    x : variable of each group [k]
    reached : how many reach the state in each group [draws, k]
    records : how many there are in each group [draws, k]
    """
    first_reached, last_reached = ends(x, reached > 0)
    first_not, last_not = ends(x, records > reached)
    return np.asarray((first_reached < last_not) & (first_not < last_reached))


def ends(x: FloatArray, there: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Return the least and largest variable of groups that are there [draws]; inf and -inf where none is.

    Parameters
    ----------
    x : variable of each group [k]
    there : which groups count [draws, k]
    """
    least = np.where(there, x, np.inf).min(axis=1, initial=np.inf)
    return least, np.where(there, x, -np.inf).max(axis=1, initial=-np.inf)


class _Counts:
    """The likelihood of counts: called with parameters and draws, as `maximise_likelihood` does."""

    def __init__(self, x: FloatArray, reached: FloatArray, records: FloatArray, link: Link) -> None:
        self.x, self.reached, self.others, self.link = x, reached, records - reached, link

    def __call__(self, theta: FloatArray, draws: IntArray) -> Likelihood:
        z = theta[:, :1] + theta[:, 1:] * self.x
        yes, no = self.reached[draws], self.others[draws]
        value, slope, bend = (_probit if self.link == "probit" else _logit)(z, yes, no)
        gradient = np.stack([slope.sum(axis=1), slope @ self.x], axis=1)
        curvature = np.stack([bend.sum(axis=1), bend @ self.x, bend @ self.x**2], axis=1)
        return Likelihood(value.sum(axis=1), gradient, curvature)


def _probit(z: FloatArray, yes: FloatArray, no: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the terms of the likelihood with their first and second derivatives by z [draws, k]."""
    above, below = log_ndtr(z), log_ndtr(-z)
    log_density = -0.5 * z**2 - 0.5 * np.log(2.0 * np.pi)
    u, v = np.exp(log_density - above), np.exp(log_density - below)
    return yes * above + no * below, yes * u - no * v, -yes * u * (z + u) - no * v * (v - z)


def _logit(z: FloatArray, yes: FloatArray, no: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the terms of the likelihood with their first and second derivatives by z [draws, k]."""
    p, records = expit(z), yes + no
    return yes * log_expit(z) + no * log_expit(-z), yes - records * p, -records * p * (1.0 - p)
