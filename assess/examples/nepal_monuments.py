"""Two readings of the Dharahara tower, Kathmandu, from the few sizes that a text gives.

Mehrotra gives the ring at the foot of the shaft and the tower's weight (Table 7.1), twenty layers of 3.0 m of which the
shaft was built in a discrete-element model, its "tapering form", and the density (section 4.3.2). The shape stands in
figures only. What is left open, how the ring becomes the shaft, is closed by the weight, in two ways:

- `tapered_tower`: the ring shrinks evenly with height, its outline and its hole alike;
- `prismatic_tower`: the outer radius stays, the wall is even and thinner than the ring at the foot.
"""

from __future__ import annotations

from math import pi, sqrt, tan

import numpy as np
from scipy.constants import g

from assess.examples.surface import Surface, revolve
from spectra.arrays import FloatArray

OUTER, INNER = 3.99, 2.12  # m: radii of the ring at the foot, Table 7.1
WEIGHT = 24003.94e3  # N: Table 7.1
DENSITY = 2000.0  # kg/m3: brick, Table 4.5
LAYERS, LAYER = 20, 3.0  # -, m: section 4.3.2
FACES = 24  # of the prism that stands for the round tower

HEIGHT = LAYERS * LAYER
AREA = WEIGHT / (g * DENSITY * HEIGHT)  # m2: of the shaft's section, on average
ROUND = FACES * tan(pi / FACES)  # area of the prism's section over r^2, in place of pi


def tapered_tower() -> Surface:
    """Return a tower whose section shrinks evenly with height.

    The ring times a factor that falls evenly from 1 at the foot to q at the top: mean area A (1 + q + q^2) / 3.
    """
    foot = ROUND * (OUTER**2 - INNER**2)
    q = (sqrt(12.0 * AREA / foot - 3.0) - 1.0) / 2.0
    return _shell(np.linspace(OUTER, q * OUTER, LAYERS + 1), np.linspace(INNER, q * INNER, LAYERS + 1))


def prismatic_tower() -> Surface:
    """Return a tower of constant section: a pipe of the outer radius."""
    inner = sqrt(OUTER**2 - AREA / ROUND)
    return _shell(np.full(LAYERS + 1, OUTER), np.full(LAYERS + 1, inner))


def _shell(outer: FloatArray, inner: FloatArray) -> Surface:
    """Return the shell between two radii at the joints of the layers [LAYERS + 1] [m]."""
    z = np.linspace(0.0, HEIGHT, LAYERS + 1)
    return revolve([*zip(outer, z, strict=True), *zip(inner[::-1], z[::-1], strict=True)], faces=FACES)


def meshes() -> dict[str, Surface]:
    """Return the tower's surfaces, by the file that the project names."""
    return {"tower/tapered.ply": tapered_tower(), "tower/even.ply": prismatic_tower()}
