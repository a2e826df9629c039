"""The distribution of the intensity at which records first reach a state, censored ones included.

A record that is run at rising scales is known to reach the state first between two of them: above the last scale at
which it had not reached it, at most at the first at which it does. One that stands at its largest scale is known to lie
above it. The likelihood is that of a lognormal between the two bounds (Turnbull 1976, J. R. Stat. Soc. B 38, 290-295;
Klein and Moeschberger 2003, section 3.5). As rocking is not monotone this bounds fragility from above: a record may
stand again at a higher intensity.
"""

from __future__ import annotations

import numpy as np
from scipy.special import log_ndtr

from assess.risk.likelihood import Likelihood, maximise_likelihood
from spectra.arrays import FloatArray, IntArray


def fit_firsts(stands: FloatArray, reaches: FloatArray, counts: FloatArray) -> tuple[FloatArray, FloatArray]:
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
        plain = np.array([[0.0, 1.0]])
        near = maximise_likelihood(_Between(low, high, n.sum(axis=0, keepdims=True)), plain)
        start = np.tile(near if np.isfinite(near).all() else plain, (len(n), 1))
        a, b = maximise_likelihood(_Between(low, high, n), start).T
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            m, beta = np.exp(middle - a / b * spread), spread / b
        good = (b > 0.0) & np.isfinite(m) & (m > 0.0) & np.isfinite(beta)
        median[bounded], dispersion[bounded] = np.where(good, m, np.nan), np.where(good, beta, np.nan)
    return median, dispersion


class _Between:
    """The likelihood of normal variables known to lie between bounds, in a + b x: called as `maximise_likelihood` does.

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
            log_p = _log_between(z_l, z_u)
            w_l, w_u = (np.exp(-0.5 * z**2 - 0.5 * np.log(2.0 * np.pi) - log_p) for z in (z_l, z_u))
        q_l, q_u = (np.where(w > 0.0, w * np.where(np.isinf(z), 0.0, z), 0.0) for w, z in ((w_l, z_l), (w_u, z_u)))
        s_a, s_b = w_u - w_l, w_u * x_u - w_l * x_l
        aa = -(q_u - q_l) - s_a**2
        ab = -(q_u * x_u - q_l * x_l) - s_a * s_b
        bb = -(q_u * x_u**2 - q_l * x_l**2) - s_b**2
        value = np.where(n > 0.0, n * log_p, 0.0).sum(axis=1)
        gradient = np.stack([(n * s_a).sum(axis=1), (n * s_b).sum(axis=1)], axis=1)
        return value, gradient, np.stack([(n * each).sum(axis=1) for each in (aa, ab, bb)], axis=1)


def _log_between(lower: FloatArray, upper: FloatArray) -> FloatArray:
    """Return the logarithm of the normal probability between bounds, taken in the tail where it is accurate."""
    flip = lower > 0.0
    low, high = np.where(flip, -upper, lower), np.where(flip, -lower, upper)
    big, small = log_ndtr(high), log_ndtr(low)
    return np.asarray(big + np.log1p(-np.exp(small - big)))
