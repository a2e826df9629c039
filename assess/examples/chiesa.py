"""The façade of the example `chiesa`: a wall with a gable, of our own making."""

from __future__ import annotations

import numpy as np

from assess.examples.surface import Surface, slab
from spectra.arrays import FloatArray

OUTER, INNER = -16.8, -16.0  # m, along the nave: its two faces
HALF_WIDTH, EAVES, RIDGE = 5.0, 7.5, 10.5  # m


def meshes() -> dict[str, Surface]:
    """Return the façade by its path in the folder."""
    return {"facade.ply": slab(_face(INNER), _face(OUTER))}


def _face(y: float) -> FloatArray:
    """Return a face of the façade, from the foot to the edge of the roof, three points in each row."""
    across = np.array([HALF_WIDTH, 0.0, -HALF_WIDTH])
    foot, roof = np.zeros(3), np.array([EAVES, RIDGE, EAVES])
    return np.stack([np.column_stack([across, np.full(3, y), row]) for row in (foot, roof)])
