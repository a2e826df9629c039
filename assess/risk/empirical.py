"""An empirical fragility curve: the share of records that reach a state, between intensities at which they were run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ndtr

from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray


@dataclass(frozen=True, repr=False)
class Empirical(ShortRepr):
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

    def convolve(self, dispersion: float) -> Widened:
        """Return the mean of the curve over a lognormal factor of median 1 on the intensity.

        Parameters
        ----------
        dispersion : standard deviation of the natural logarithm of the factor, positive [-]
        """
        return Widened(self, dispersion)


@dataclass(frozen=True, repr=False)
class Widened(ShortRepr):
    """The mean of an empirical curve over a lognormal factor of median 1 on the intensity.

    curve : of slopes s_j in u = ln IM; dispersion : beta, of the logarithm of the factor, positive [-]
    """

    curve: Empirical
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
