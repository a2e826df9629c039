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


def vertical(chain):
    """Forces up of the hinges on the block above, of D on the ground [N], and on D's block then."""
    up = incipient_motion(chain).forces[:, 1]
    return np.append(up[:-1], -up[-1]) if len(chain.blocks) == 3 else up


def frame(W1, W2, W3, *, over=(2.3, 4.0), right=4.6):
    """Columns 0.8 m thick and 4 m high, up to x = `right`, and a beam with its centroid at `over`."""
    blocks = (
        RigidBlock(W1 / g, (0.4, 2.0), 500.0),
        RigidBlock(W2 / g, over, 900.0),
        RigidBlock(W3 / g, (right - 0.4, 2.0), 500.0),
    )
    return Chain(blocks, ((0.8, 0.0), (0.0, 4.0), (right - 0.8, 4.0), (right, 0.0)))


def test_halves_of_tables_6_2_and_6_3_by_moments_of_the_beam():
    """Elsewhere: F_3 (x_C - x_B) = W_2 (x_G - x_B) + lambda W_2 (z_G - z_B)."""
    W1, W2, W3 = 40000.0, 90000.0, 70000.0
    chain = frame(W1, W2, W3, over=(2.3, 4.35))
    far = (W2 * 2.3 + incipient_motion(chain).multiplier * W2 * 0.35) / 3.8
    np.testing.assert_allclose(np.abs(vertical(chain)), [W1 + W2 - far, W2 - far, far, W3 + far], rtol=1e-12)


def vault(wall):
    """Two equal halves of a vault of 5 t on a wall of `wall` kg: hinge B at the apex, C at the wall, D below."""
    halves = RigidBlock(2500.0, (1.15, 7.9), 1500.0), RigidBlock(2500.0, (3.85, 7.9), 1500.0)
    return Chain((*halves, RigidBlock(wall, (5.5, 3.7), 1e4)), ((0.0, 7.0), (2.5, 8.3), (5.0, 7.0), (6.2, 0.0)))


def test_table_6_4_has_shear_at_the_apex_where_the_ground_shakes():
    W = 2500.0 * g
    chain = vault(40000.0)
    multiplier, shear = incipient_motion(chain).multiplier, incipient_motion(chain).forces[1, 1]
    assert multiplier > 0.05
    a, _, c, d = np.abs(incipient_motion(chain).forces[:, 1])
    np.testing.assert_allclose([a, c, d], [W + shear, W - shear, W - shear + 40000.0 * g], rtol=1e-12)
    assert abs(shear) > 0.01 * W
