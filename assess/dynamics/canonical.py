"""Branches in the coordinate of the kernel, in which the inertia is constant.

With s(phi) = sqrt(I(phi) / I(0)) and dy = s dphi / L, where y = 1 at overturning, the kinetic energy is
I(0) L^2 y'^2 / 2, and the rocking equation loses its velocity:

    I phi'' + 1/2 I' phi'^2 + R = -B a        becomes        y'' = -r(y) - b(y) a,     r, b = (R, B) / (I(0) L s)

Where I is constant, as for a rigid block, y is phi / phi_ov. Where it jumps, y' and so the energy is continuous.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicHermiteSpline, PPoly

from assess.oscillator import Branch, interpolant
from assess.short_repr import ShortRepr
from spectra.arrays import BoolArray, FloatArray, IntArray

NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)


SAME = 1e-10
"""Fraction of the largest value of a table below which a difference between two nodes at one rotation is rounding."""


@dataclass(frozen=True, repr=False)
class Canonical(ShortRepr):
    """A branch over y, on its n segments of nonzero width.

    turn : dphi / dy at rest, L [rad]
    y : ends of the segments [n + 1] [-]
    restoring, excitation : cubics of r [1/s2] and b [1/m] on each segment, highest power first [4, n]
    stored : integral of r up to each end [n + 1] [1/s2]
    smooth : first and last segment of the piece between jumps that each segment lies in [n, 2]
    back : phi [rad] over y
    inertia : I / I(0) over phi [-]
    """

    turn: float
    y: FloatArray
    restoring: FloatArray
    excitation: FloatArray
    stored: FloatArray
    smooth: IntArray
    back: CubicHermiteSpline
    inertia: PPoly

    def rotation(self, y: FloatArray) -> FloatArray:
        """Return phi [rad] at y (same shape)."""
        return np.asarray(self.back(y))

    def velocity(self, y: FloatArray, v: FloatArray) -> FloatArray:
        """Return phi' [rad/s] at y with y' (same shapes)."""
        return np.asarray(self.turn * v / np.sqrt(self.inertia(self.back(y))))

    def at(self, rotation: float) -> float:
        """Return y at a rotation [rad], by Newton's method from the chord."""
        y = float(np.interp(rotation, self.back(self.y), self.y))
        for _ in range(4):
            y -= float((self.back(y) - rotation) / self.back(y, 1))
        return y


def linear_form(turn: float) -> Canonical:
    """Return the coordinate of the linearised equation, y = phi / turn: its inertia is constant and needs no table."""
    ends, none = np.array([0.0, 1.0]), np.empty((4, 0))
    line, one = CubicHermiteSpline(ends, turn * ends, [turn, turn]), PPoly([[1.0]], turn * ends)
    return Canonical(turn, ends, none, none, np.empty(0), np.empty((0, 2), dtype=np.int64), line, one)


def canonical_form(branch: Branch) -> Canonical:
    """Return the branch over y: cubics with its values and slopes at the ends of each segment."""
    wide = np.diff(branch.rotation) > 0.0
    left, width = branch.rotation[:-1][wide], np.diff(branch.rotation)[wide]
    at_rest = float(branch.inertia[0])

    columns = np.stack([branch.inertia, branch.restoring, branch.excitation], axis=1)
    inertia, moment, push = np.moveaxis(interpolant(branch.rotation, columns).c[:, wide], 2, 0)
    length = _lengths(inertia / at_rest, width)
    over = int(np.clip(np.searchsorted(left, branch.unstable) - 1, 0, left.size - 1))
    rest_of_it = _lengths(inertia[:, over : over + 1] / at_rest, np.array([branch.unstable - left[over]]))
    turn = float(length[:over].sum() + rest_of_it[0])
    w, ends = length / turn, np.stack([np.zeros_like(width), width])
    s = np.sqrt(_values(inertia, ends) / at_rest)
    bend = _values(_slopes(inertia), ends) / (2.0 * at_rest * s)

    def over_y(cubics: FloatArray) -> FloatArray:
        value, slope = _values(cubics, ends), _values(_slopes(cubics), ends)
        return _hermite(value / s, (slope - value * bend / s) * turn / s**2, w) / (at_rest * turn)

    restoring, y = over_y(moment), np.r_[0.0, np.cumsum(w)]
    work = w * (((restoring[0] * w / 4 + restoring[1] / 3) * w + restoring[2] / 2) * w + restoring[3])
    return Canonical(
        turn=turn,
        y=y,
        restoring=restoring,
        excitation=over_y(push),
        stored=np.r_[0.0, np.cumsum(work)],
        smooth=_smooth(branch, wide),
        back=CubicHermiteSpline(y, np.r_[left, left[-1] + width[-1]], turn / np.r_[s[0], s[1, -1]]),
        inertia=PPoly(inertia / at_rest, np.r_[left, left[-1] + width[-1]]),
    )


def _lengths(inertia: FloatArray, width: FloatArray) -> FloatArray:
    """Integrate s over each segment [n] [rad] by Gauss; inertia: cubics of I / I(0) [4, n]."""
    return np.asarray(0.5 * width * (WEIGHTS @ np.sqrt(_values(inertia, 0.5 * width * (1.0 + NODES[:, None])))))


def _values(polynomials: FloatArray, d: FloatArray) -> FloatArray:
    """Return polynomials [k, n] at distances d [m, n] from the start of their segments [m, n]."""
    value: FloatArray = np.zeros_like(d)
    for row in polynomials:
        value = value * d + row
    return value


def _slopes(cubics: FloatArray) -> FloatArray:
    """Return the derivatives [3, n] of cubics [4, n]."""
    return np.asarray(cubics[:-1] * np.array([[3.0], [2.0], [1.0]]))


def _hermite(value: FloatArray, slope: FloatArray, width: FloatArray) -> FloatArray:
    """Return the cubics [4, n] with these values and slopes at both ends [2, n] of segments of these widths [n]."""
    rise = (value[1] - value[0]) / width
    third, second = slope[0] + slope[1] - 2.0 * rise, 3.0 * rise - 2.0 * slope[0] - slope[1]
    return np.stack([third / width**2, second / width, slope[0], value[0]])


def _smooth(branch: Branch, wide: BoolArray) -> IntArray:
    """Return the first and last segment of nonzero width between the jumps around each [n, 2].

    Two nodes at one rotation with equal values, but for rounding, are a kink and not a jump: steps may pass it.
    """
    columns = np.array([branch.restoring, branch.excitation, branch.inertia])
    leaps = (np.abs(np.diff(columns)) > SAME * np.abs(columns).max(axis=1, keepdims=True)).any(axis=0)
    jumps = np.cumsum(leaps & ~wide)[wide]  # the number before each segment
    first, beyond = np.searchsorted(jumps, jumps), np.searchsorted(jumps, jumps, side="right")
    return np.asarray(np.stack([first, beyond - 1], axis=1), dtype=np.int64)
