"""The largest of many concave log-likelihoods of two parameters each, by Newton's method with step halving."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from assess.short_repr import ShortRepr
from spectra.arrays import BoolArray, FloatArray, IntArray

ITERATIONS = 60
HALVINGS = 30
STEP = 1e-10  # relative step at which a draw has converged


@dataclass(frozen=True, repr=False)
class Likelihood(ShortRepr):
    """Log-likelihoods at one point each: value [n], gradient [n, 2], curvature [n, 3] as (aa, ab, bb)."""

    value: FloatArray
    gradient: FloatArray
    curvature: FloatArray


Terms = Callable[[FloatArray, IntArray], Likelihood]


def maximise_likelihood(terms: Terms, start: FloatArray) -> FloatArray:
    """Return the parameters [draws, 2] at which each likelihood is largest; nan where the search does not converge.

    Parameters
    ----------
    terms : takes parameters [n, 2] and the draws [n] that they belong to
    start : parameters to begin at, of finite likelihood [draws, 2]
    """
    theta = np.array(start, dtype=np.float64)
    active = np.arange(len(theta))
    now = terms(theta, active)
    for _ in range(ITERATIONS):
        step = _newton_step(now)
        theta[active], now = _damp(terms, theta[active], step, now, active)
        moving = ~(np.abs(step).max(axis=1) <= STEP * (1.0 + np.abs(theta[active]).max(axis=1)))
        active, now = active[moving], _select(now, moving)
        if not active.size:
            break
    theta[active] = np.nan
    return theta


def _newton_step(at: Likelihood) -> FloatArray:
    """Return Newton's steps [n, 2]; zero curvature gives a step that is not finite."""
    (g_a, g_b), (aa, ab, bb) = at.gradient.T, at.curvature.T
    with np.errstate(divide="ignore", invalid="ignore"):
        step = np.stack([ab * g_b - bb * g_a, ab * g_a - aa * g_b], axis=1) / (aa * bb - ab**2)[:, None]
    return np.asarray(step)


def _damp(
    terms: Terms, theta: FloatArray, step: FloatArray, now: Likelihood, draws: IntArray
) -> tuple[FloatArray, Likelihood]:
    """Return the parameters after steps halved until no likelihood falls, and the likelihoods there."""
    step = np.where(np.isfinite(step), step, 0.0)
    tried = theta + step
    there = terms(tried, draws)
    for _ in range(HALVINGS):
        worse = ~(there.value >= now.value - 1e-12 * np.abs(now.value))
        if not worse.any():
            break
        step[worse] *= 0.5
        tried[worse] = theta[worse] + step[worse]
        again = terms(tried[worse], draws[worse])
        for whole, part in zip(_arrays(there), _arrays(again), strict=True):
            whole[worse] = part
    return tried, there


def _select(at: Likelihood, rows: BoolArray) -> Likelihood:
    return Likelihood(*(each[rows] for each in _arrays(at)))


def _arrays(at: Likelihood) -> tuple[FloatArray, FloatArray, FloatArray]:
    return at.value, at.gradient, at.curvature
