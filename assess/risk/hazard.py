"""The hazard of a site and the annual rate of a state, hazard and fragility together.

The rate is the integral of the fragility over the hazard, lambda = int P(state | im) |d lambda(im)|: Cornell and
Krawinkler 2000, PEER Center News 3(2); Jalayer and Cornell 2003, PEER 2003/08, eq. 2.5. The hazard is straight between
its rows in logarithms of intensity and rate.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from assess.errors import HazardError
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

Probability = Callable[[FloatArray], FloatArray]
ACCURACY = 1e-6  # relative change of the rate at which panels are halved no more
HALVINGS = 10
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(6)
DEPTH = 30  # powers of e below the first row


LARGEST_LOGARITHM = 600.0  # of a rate: a steep first interval, extended far below, is more than floats hold


@dataclass(frozen=True, repr=False)
class HazardCurve(ShortRepr):
    """Annual rates at which intensities are exceeded, at least two rows; wrong rows raise HazardError.

    intensity [n] : positive, rising; annual_rate [n] : positive, not rising [1/year]
    """

    intensity: FloatArray
    annual_rate: FloatArray

    def __post_init__(self) -> None:
        for name in ("intensity", "annual_rate"):
            values = np.array(getattr(self, name), dtype=np.float64)
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        _check(self.intensity, self.annual_rate)

    def rate_at(self, intensity: ArrayLike) -> FloatArray:
        """Return annual rates of exceedance at intensities, any shape; beyond the rows those of the first and last."""
        at = np.log(np.asarray(intensity, dtype=np.float64))
        return np.asarray(np.exp(np.interp(at, np.log(self.intensity), np.log(self.annual_rate))))


@dataclass(frozen=True, repr=False)
class Rate(ShortRepr):
    """The annual rate of a state, within the rows of the hazard and what may come from outside them.

    annual_rate : within the rows [1/year]
    contribution [n-1] : its parts between neighbouring rows of the hazard, or other edges [1/year]
    beyond : what motions above the last row add if every one reaches the state, a bound: the last row's rate [1/year]
    below : what motions below the first row add if the hazard goes on with the slope of its first interval, which is
        more than true where the hazard flattens towards small motions; inf where the state is too likely there [1/year]
    """

    annual_rate: float
    contribution: FloatArray
    beyond: float
    below: float

    @property
    def shares(self) -> FloatArray:
        """Parts of the rate between neighbouring edges [n-1] [-]; zeros where the rate is zero."""
        return self.contribution / self.annual_rate if self.annual_rate > 0.0 else np.zeros_like(self.contribution)


def rate(probability: Probability, hazard: HazardCurve, *, breaks: ArrayLike = (), edges: ArrayLike = ()) -> Rate:
    """Return the annual rate of a state.

    Parameters
    ----------
    probability : of the state at intensities [m], in the hazard's unit
    hazard : of the site
    breaks : intensities at which the probability has kinks, as an empirical curve at its points [k]
    edges : rising intensities from the first row to the last that part the contributions; the rows if empty [n]
    """
    u, v = np.log(hazard.intensity), np.log(hazard.annual_rate)
    slopes = -np.diff(v) / np.diff(u)
    kinks = np.log(np.asarray(breaks, dtype=np.float64))
    parting = np.log(np.asarray(edges, dtype=np.float64)) if np.size(edges) else u
    also = np.concatenate([kinks, parting])
    corners = np.unique(np.concatenate([u, also[(also > u[0]) & (also < u[-1])]]))
    row = np.clip(np.searchsorted(u, corners[:-1], side="right") - 1, 0, slopes.size - 1)
    parts = _integrate(probability, corners, u[row], v[row], slopes[row])
    place = np.clip(np.searchsorted(parting, corners[:-1], side="right") - 1, 0, parting.size - 2)
    contribution = np.asarray(np.bincount(place, weights=parts, minlength=parting.size - 1), dtype=np.float64)
    return Rate(
        float(contribution.sum()),
        contribution,
        float(hazard.annual_rate[-1]),
        _below(probability, u[0], v[0], slopes[0], kinks),
    )


def probability_of(annual_rate: float, *, years: float = 50.0) -> float:
    """Return the probability of at least one occurrence of Poisson's process: 1 - exp(-rate years).

    Parameters
    ----------
    annual_rate : of the state [1/year]
    years : of exposure
    """
    return float(-np.expm1(-annual_rate * years))


def _check(intensity: FloatArray, annual_rate: FloatArray) -> None:
    if intensity.ndim != 1 or intensity.shape != annual_rate.shape or intensity.size < 2:
        raise HazardError("hazard: give at least two rows of intensity and annual rate of exceedance")
    for name, values in (("intensity", intensity), ("annual rate", annual_rate)):
        wrong = values[~(np.isfinite(values) & (values > 0.0))]
        if wrong.size:
            raise HazardError(f"hazard: {name} {wrong[0]:g} is not a positive number; leave that row out")
    if (np.diff(intensity) <= 0.0).any():
        at = int(np.argmax(np.diff(intensity) <= 0.0))
        raise HazardError(
            f"hazard: intensity {intensity[at + 1]:g} follows {intensity[at]:g}; give rows at rising intensity"
        )
    if (np.diff(annual_rate) > 0.0).any():
        at = int(np.argmax(np.diff(annual_rate) > 0.0))
        raise HazardError(
            f"hazard: the annual rate rises from {annual_rate[at]:g} to {annual_rate[at + 1]:g} at intensity "
            f"{intensity[at + 1]:g}; rates of exceedance fall as intensity rises"
        )


def _integrate(
    probability: Probability, corners: FloatArray, u_0: FloatArray, v_0: FloatArray, k: FloatArray
) -> FloatArray:
    """Return the integrals of P k lambda du between corners [m], lambda = exp(v_0 - k (u - u_0)), halving panels."""
    before = _gauss(probability, corners, u_0, v_0, k, panels=4)
    for halving in range(1, HALVINGS + 1):
        parts = _gauss(probability, corners, u_0, v_0, k, panels=4 * 2**halving)
        if np.abs(parts - before).sum() <= ACCURACY * parts.sum():
            break
        before = parts
    return parts


def _gauss(
    probability: Probability, corners: FloatArray, u_0: FloatArray, v_0: FloatArray, k: FloatArray, *, panels: int
) -> FloatArray:
    width = np.diff(corners)[:, None] / panels
    starts = corners[:-1, None] + width * np.arange(panels)
    u = starts[:, :, None] + 0.5 * width[:, :, None] * (1.0 + POINTS)
    logarithm = v_0[:, None, None] - k[:, None, None] * (u - u_0[:, None, None])
    density = k[:, None, None] * np.exp(np.minimum(logarithm, LARGEST_LOGARITHM))
    inside = probability(np.exp(u).ravel()).reshape(u.shape) * density
    return np.asarray((inside @ WEIGHTS).sum(axis=1) * 0.5 * width[:, 0])


def _below(probability: Probability, u: float, v: float, k: float, kinks: FloatArray) -> float:
    """Return the rate below the first row, the first slope going on; inf where it does not converge."""
    corners = np.unique(np.concatenate([u - np.arange(DEPTH + 1.0), kinks[(kinks < u) & (kinks > u - DEPTH)]]))
    same = np.ones(corners.size - 1)
    parts = _integrate(probability, corners, u * same, v * same, k * same)
    return float("inf") if parts[0] > ACCURACY * parts.sum() else float(parts.sum())
