"""A lognormal fragility curve and its fit to counts at each intensity by maximum likelihood.

Sources: binomial likelihood of a lognormal, Baker 2015, "Efficient analytical fragility function fitting using dynamic
structural analysis", Earthquake Spectra 31(1), eq. 8 to 11; moments of a lognormal, any textbook.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ndtr, ndtri

from assess.risk.binomial import counts_overlap, ends, fit_binomial
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray


class Unbounded(StrEnum):
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
    a, b = fit_binomial(np.log(intensity), reached, records, link="probit").T
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        median, dispersion = np.exp(-a / b), 1.0 / b
    bounded = (b > 0.0) & np.isfinite(median) & (median > 0.0) & np.isfinite(dispersion)
    return np.where(bounded, median, np.nan), np.where(bounded, dispersion, np.nan)


def unbounded_reason(intensity: ArrayLike, reached: ArrayLike, records: ArrayLike) -> Unbounded | None:
    """Return why counts do not bound a lognormal; None where they do.

    Parameters
    ----------
    intensity : positive [k]
    reached : how many reach the state at each [k]
    records : how many there are at each [k]
    """
    x = np.log(np.asarray(intensity, dtype=np.float64))
    yes, n = (np.atleast_2d(np.asarray(each, dtype=np.float64)) for each in (reached, records))
    if not yes.any():
        return Unbounded.NONE_REACH
    if np.array_equal(yes, n):
        return Unbounded.ALL_REACH
    if np.unique(x[n[0] > 0]).size < 2:
        return Unbounded.ONE_INTENSITY
    if not counts_overlap(x, yes, n)[0]:
        (first_reached, _), (_, last_not) = ends(x, yes > 0), ends(x, n > yes)
        return Unbounded.SEPARATED if first_reached[0] >= last_not[0] else Unbounded.FALLING
    return Unbounded.FALLING if fit_lognormal(intensity, reached, records) is None else None
