"""Scaling of a body along one direction at constant density, and of its density."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assess.geometry.solid import Solid


def scale_along(solid: Solid, *, direction: Sequence[float], middle: float, factor: float) -> Solid:
    """Scale a solid along a direction, measured from a plane square to it.

    The map is r -> A r + b with A = E + (factor - 1) u u^T, so volume and mass grow by det A = factor, and the second
    moment S = int r r^T dm about the centroid becomes factor A S A^T. S and the inertia tensor I determine each other:
    I = tr(S) E - S, S = tr(I) / 2 E - I.

    Parameters
    ----------
    direction : a vector of any length [3]
    middle : distance of the fixed plane along the direction from the origin [m]
    factor : ratio of new to old distances from that plane, positive [-]
    """
    u = np.asarray(direction, dtype=np.float64) / np.linalg.norm(direction)
    A = np.eye(3) + (factor - 1.0) * np.outer(u, u)
    shift = (1.0 - factor) * middle * u
    S = np.trace(solid.inertia) / 2.0 * np.eye(3) - solid.inertia
    S = factor * A @ S @ A.T
    centroid, vertices = A @ solid.centroid + shift, solid.vertices @ A.T + shift
    inertia = np.trace(S) * np.eye(3) - S
    for array in (centroid, vertices, inertia):
        array.setflags(write=False)
    return replace(solid, mass=factor * solid.mass, centroid=centroid, inertia=inertia, vertices=vertices)


def scale_density(solid: Solid, factor: float) -> Solid:
    """Return a solid of another density.

    Parameters
    ----------
    factor : ratio of new to old density, positive [-]
    """
    if factor == 1.0:
        return solid
    inertia = factor * solid.inertia
    inertia.setflags(write=False)
    return replace(solid, mass=factor * solid.mass, inertia=inertia)
