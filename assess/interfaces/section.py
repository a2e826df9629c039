"""The section of a contact: its width over the depth, and the moments of that."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from assess.interfaces.kernel import moments
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray


@dataclass(frozen=True, repr=False)
class Section(ShortRepr):
    """A plane region seen in one direction of rocking: pieces of linear width, and discs.

    The depth x runs from the compressed extreme fibre, 0, to the far one; the offset y along the axis of rotation
    from the centroid, positive to the left of the direction of rocking.

    Attributes
    ----------
    depth : extent in the direction of rocking [m]; breadth : extent across [m]
    area : [m2]
    centroid : its distance from the compressed edge [m]
    pieces : begin of each piece, its width and the integral of the offset over the width as polynomials from there,
        moments up to there; a last row for the far edge; no rows for discs alone; see `kernel.moments` [m + 1, 12]
    discs : radius [m], depth of the disc's own edge [m] and 1 or -1 where it adds or takes away [d, 3]
    """

    depth: float
    breadth: float
    area: float
    centroid: float
    pieces: FloatArray
    discs: FloatArray

    @property
    def table(self) -> moments.Table:
        """The arrays and numbers that the kernel reads."""
        return self.pieces, self.discs, self.depth, self.area, self.centroid


def section_of_pieces(knots: ArrayLike, *, widths: ArrayLike, sides: ArrayLike, breadth: float) -> Section:
    """Make a section whose width is linear between knots.

    Parameters
    ----------
    knots : depths from 0, increasing [m + 1] [m]
    widths : at the start and end of each piece, which need not match those of the next one [m, 2] [m]
    sides : integral of the offset from the centroid over the width, at the start, middle and end of each piece
        [m, 3] [m2]
    breadth : extent across [m]
    """
    X, w, v = (np.asarray(each, dtype=np.float64) for each in (knots, widths, sides))
    L = np.diff(X)
    W0, W1 = w[:, 0], (w[:, 1] - w[:, 0]) / L
    V0, V2 = v[:, 0], 2.0 * (v[:, 2] - 2.0 * v[:, 1] + v[:, 0]) / L**2
    V1 = (v[:, 2] - v[:, 0]) / L - V2 * L
    x = X[:-1]
    A, S, T = (_upto(_integral(each, L)) for each in ((W0, W1), (x * W0, x * W1 + W0, W1), (V0, V1, V2)))
    rises = (W0, W1 / 2.0), (x * W0, (x * W1 + W0) / 2.0, W1 / 3.0), (V0, V1 / 2.0, V2 / 3.0)
    sums = (_upto(_integral((each[:-1], *rise), L)) for each, rise in zip((A, S, T), rises, strict=True))
    last = (np.append(each, 0.0) for each in (W0, W1, V0, V1, V2))
    pieces = np.column_stack([X, *last, A, S, T, *sums])
    return Section(
        float(X[-1]), float(breadth), float(A[-1]), float(S[-1] / A[-1]), _frozen(pieces), _frozen(np.empty((0, 3)))
    )


def section_of_discs(outer: float, *, inner: float = 0.0) -> Section:
    """Make a disc of the outer radius with a concentric hole of the inner radius [m]."""
    discs = np.array([[outer, 0.0, 1.0], [inner, outer - inner, -1.0]])[: 2 if inner > 0.0 else 1]
    area = float(np.pi * (outer - inner) * (outer + inner))
    return Section(2.0 * outer, 2.0 * outer, area, float(outer), _frozen(np.empty((0, 12))), _frozen(discs))


def mirror(section: Section) -> Section:
    """Return the same region rocking the other way."""
    if not section.pieces.size:
        return section  # discs are concentric
    X, (W0, W1, V0, V1, V2) = section.pieces[::-1, moments.BEGIN], section.pieces[-2::-1, moments.W0 : moments.A].T
    L = -np.diff(X)
    widths = np.column_stack([W0 + W1 * L, W0])
    sides = np.column_stack([V0 + d * (V1 + d * V2) for d in (L, L / 2.0, 0.0 * L)])
    return section_of_pieces(X[0] - X, widths=widths, sides=-sides, breadth=section.breadth)


def _integral(powers: Sequence[FloatArray], L: FloatArray) -> FloatArray:
    """Integrate polynomials, coefficients [m] lowest power first, over pieces of lengths L [m]."""
    return np.asarray(sum(c * L ** (n + 1) / (n + 1) for n, c in enumerate(powers)), dtype=np.float64)


def _upto(parts: FloatArray) -> FloatArray:
    """Return the sums up to the start of each piece, and to the end of the last one [m + 1]."""
    return np.append(0.0, np.cumsum(parts))


def _frozen(array: FloatArray) -> FloatArray:
    """Return the array, contiguous and read-only."""
    kept = np.ascontiguousarray(array)
    kept.setflags(write=False)
    return kept
