"""Thrust of three-hinged arches against joints and bars solved by themselves, and the weights of vaults."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.constants import g

from assess.loads.roofs_and_vaults import (
    CONSTRUCTIONS,
    LIGHT_BRICK,
    SANDSTONE,
    STRONG_BRICK,
    arch_thrust,
    uniform_lever_arm,
)


def horizontal_reaction(x, weight, *, span, rise):
    """Horizontal reaction of an arch of three hinges at (0, 0), (L/2, f), (L, 0) under weights [n] at x [n].

    Unknowns: both reactions and the force at the crown; equations: three for each half.
    """
    left = x < span / 2
    W = [weight[left].sum(), weight[~left].sum()]
    M = [(weight * x)[left].sum(), (weight * x)[~left].sum()]
    a = np.zeros((6, 6))  # H1 V1 H2 V2 Hc Vc; the crown force acts on the left half, reversed on the right
    a[0, [0, 4]] = 1.0, 1.0
    a[1, [1, 5]] = 1.0, 1.0
    a[2, [4, 5]] = -rise, span / 2  # about the left foot
    a[3, [2, 4]] = 1.0, -1.0
    a[4, [3, 5]] = 1.0, -1.0
    a[5, [3, 4, 5]] = span, rise, -span / 2
    H1, V1, *_ = np.linalg.solve(a, [0.0, W[0], M[0], 0.0, W[1], M[1]])
    return H1, V1


def test_rafters_by_the_method_of_joints():
    """Two bars meet at the ridge; half of each rafter's weight goes to its upper end."""
    W, L, f = 30e3, 8.0, 3.0
    bar = np.hypot(L / 2, f)
    directions = np.array([[L / 2, -L / 2], [f, f]]) / bar  # of the pushes of both bars on the ridge
    pushes = np.linalg.solve(directions, [0.0, W / 2])
    expected = pushes[0] * (L / 2) / bar
    assert arch_thrust(W / 2, lever=uniform_lever_arm(L), rise=f) == pytest.approx(expected, rel=1e-12)
    assert arch_thrust(W / 2, lever=uniform_lever_arm(L), rise=f) == pytest.approx(W * L / (8 * f), rel=1e-12)


@pytest.mark.parametrize("heavier_at_the_feet", [0.0, 2.0])
def test_any_symmetric_weight_by_equilibrium_of_both_halves(heavier_at_the_feet):
    L, f = 6.0, 2.0
    x = (np.arange(6000) + 0.5) * L / 6000
    weight = 1.0 + heavier_at_the_feet * np.abs(2 * x / L - 1) ** 2
    H, V = horizontal_reaction(x, weight, span=L, rise=f)
    lever = weight @ np.minimum(x, L - x) / weight.sum()
    assert weight.sum() / 2 == pytest.approx(V, rel=1e-12)
    assert arch_thrust(V, lever=lever, rise=f) == pytest.approx(H, rel=1e-9)
    if not heavier_at_the_feet:
        assert lever == pytest.approx(uniform_lever_arm(L), rel=1e-9)


def test_a_flat_arch_thrusts_without_bound_and_a_steep_one_not_at_all():
    assert arch_thrust(1.0, lever=1.0, rise=1e-9) == pytest.approx(1e9)
    assert arch_thrust(1.0, lever=1.0, rise=1e9) == pytest.approx(1e-9)


def test_the_two_constructions_of_each_case_weigh_alike():
    """Thesis 3.2.2 puts them into one case: so they weigh the same in Ungewitter's table."""
    pairs = {2: 0.190 * LIGHT_BRICK, 3: 0.250 * LIGHT_BRICK, 4: 0.200 * SANDSTONE}
    for case, other in pairs.items():
        assert CONSTRUCTIONS[case].mass_per_area == pytest.approx(other, rel=0.1)  # the densities are assumed
    weights = [CONSTRUCTIONS[case].mass_per_area * g for case in range(1, 6)]
    assert weights == sorted(weights)
    assert CONSTRUCTIONS[2].mass_per_area == 0.125 * STRONG_BRICK
