"""The resultant of a stress that is linear over a stretch of the depth of a section, and its moment, by quadrature.

Written apart from the kernel, which integrates in closed form: what calculation sheets print checks what was solved.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from assess.interfaces.kernel.moments import BEGIN, EDGE, RADIUS, SIGN, W0, W1
from assess.interfaces.section import Section
from spectra.arrays import FloatArray

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(64)
EXACT_POINTS, EXACT_WEIGHTS = np.polynomial.legendre.leggauss(3)
"""Of Gauss' rule: over angles of a disc; and over a piece of linear width, where the integrand is a cubic at most."""


def stress_integrals(section: Section, *, start: float, end: float, stress: tuple[float, float]) -> tuple[float, float]:
    """Return the force [N] and its first moment about the compressed edge [N m] of a stress linear over depth.

    Parameters
    ----------
    section : of the contact
    start, end : depths between which it acts [m]
    stress : at the start and at the end [Pa]

    Returns
    -------
    tuple of float
        Integrals of sigma w dx and of sigma x w dx.
    """
    force, moment = 0.0, 0.0
    for x, area in _strips(section, start, end):
        sigma = stress[0] + (stress[1] - stress[0]) * (x - start) / (end - start)
        force += float(sigma @ area)
        moment += float((sigma * x) @ area)
    return force, moment


def _strips(section: Section, start: float, end: float) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Yield depths [m] with the area that each stands for [m2], a stretch at a time; areas of holes are negative."""
    for piece, after in zip(section.pieces[:-1], section.pieces[1:], strict=True):
        low, high = max(start, piece[BEGIN]), min(end, after[BEGIN])
        if low < high:
            x = 0.5 * (low + high) + 0.5 * (high - low) * EXACT_POINTS
            yield x, 0.5 * (high - low) * EXACT_WEIGHTS * (piece[W0] + piece[W1] * (x - piece[BEGIN]))
    for disc in section.discs:
        radius = disc[RADIUS]
        first, last = (np.arccos(np.clip(1.0 - (x - disc[EDGE]) / radius, -1.0, 1.0)) for x in (start, end))
        if first < last:
            angle = 0.5 * (first + last) + 0.5 * (last - first) * POINTS
            x = disc[EDGE] + radius * (1.0 - np.cos(angle))
            yield x, disc[SIGN] * (last - first) * WEIGHTS * (radius * np.sin(angle)) ** 2
