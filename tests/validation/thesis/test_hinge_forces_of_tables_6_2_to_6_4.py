"""Thesis Tables 6.1-6.4, the vertical forces of the hinges, where they are not exact.

The program takes them when the mechanism is about to move, so with the horizontal forces of the uplift multiplier. The
tables share a beam out in halves, which is then exact only where its centroid is level with its hinges, midway; the
solved case "tables_6_1_to_6_4" is so.
"""

from __future__ import annotations

import numpy as np
from scipy.constants import g

from assess.mechanisms.chain import Chain, RigidBlock
from assess.mechanisms.hinge_forces import incipient_motion
from tests.support.bodies import PORTAL_HINGES


def test_halves_of_tables_6_2_and_6_3_by_moments_of_the_beam():
    """Elsewhere: F_3 (x_C - x_B) = W_2 (x_G - x_B) + lambda W_2 (z_G - z_B)."""
    W1, W2, W3 = 40000.0, 90000.0, 70000.0
    centroids = ((0.4, 2.0), (2.3, 4.35), (4.2, 2.0))  # of columns 0.8 m thick and 4 m high, and of the beam
    blocks = (RigidBlock(W / g, at, 500.0) for W, at in zip((W1, W2, W3), centroids, strict=True))
    chain = Chain(tuple(blocks), PORTAL_HINGES[0])
    far = (W2 * 2.3 + incipient_motion(chain).multiplier * W2 * 0.35) / 3.8
    np.testing.assert_allclose(
        np.abs(incipient_motion(chain).forces[:, 1]), [W1 + W2 - far, W2 - far, far, W3 + far], rtol=1e-12
    )


def test_table_6_4_has_shear_at_the_apex_where_the_ground_shakes():
    """Two equal halves of a vault of 5 t on a wall of 40 t: hinge B at the apex, C at the wall, D below."""
    W = 2500.0 * g
    blocks = (
        *(RigidBlock(2500.0, (x, 7.9), 1500.0) for x in (1.15, 3.85)),
        RigidBlock(40000.0, (5.5, 3.7), 1e4),
    )
    chain = Chain(blocks, ((0.0, 7.0), (2.5, 8.3), (5.0, 7.0), (6.2, 0.0)))
    multiplier, shear = incipient_motion(chain).multiplier, incipient_motion(chain).forces[1, 1]
    assert multiplier > 0.05
    a, _, c, d = np.abs(incipient_motion(chain).forces[:, 1])
    np.testing.assert_allclose([a, c, d], [W + shear, W - shear, W - shear + 40000.0 * g], rtol=1e-12)
    assert abs(shear) > 0.01 * W
