"""The thesis' limit of rotation, theta = k alpha^2 / sin 2 alpha of the block at theta, by hand."""

from __future__ import annotations

from math import atan2, cos, hypot, inf, sin, sqrt

import numpy as np
import pytest
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.asce43_05 import inertia_ratio, thesis_limit, thesis_limit_ratio
from assess.interfaces.contact import JointLaw
from assess.oscillator import block_at, equivalent_block
from tests.support.bodies import rigid_wall, wall_on_joints

L, RHO = 1.0, 2000.0


def limit_of(block):
    """k alpha^2 / sin 2 alpha with k = I / (M R^2); block: M, R, alpha, I."""
    M, R, alpha, inertia = block
    return inertia / (M * R**2) * alpha**2 / sin(2 * alpha)


@pytest.mark.parametrize("slender", [0.1, 0.3, 0.6])
def test_of_a_plain_block_it_is_the_formula(slender):
    """k = 4/3 for any box: 0.667 of alpha for one that is very slender, and more for others."""
    h = 3.0
    b = h * np.tan(slender)
    made = rigid_wall(b, h, length=L, density=RHO).oscillator
    block = equivalent_block(made.positive, mass=made.mass)
    expected = limit_of((made.mass, hypot(b, h) / 2, slender, made.mass * (b**2 + h**2) / 3))
    assert inertia_ratio(block) == pytest.approx(4 / 3, rel=1e-9)
    assert thesis_limit_ratio(block) * slender == pytest.approx(expected, rel=1e-9)
    assert thesis_limit(made.positive, mass=made.mass) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(("b", "h", "stiffness"), [(0.5, 4.0, 1e8), (0.6, 4.0, 2e8), (1.0, 5.0, 1e9)])
def test_on_an_elastic_joint_it_is_the_formula_of_the_block_at_that_rotation(b, h, stiffness):
    """An open joint turns the block about a_f = sqrt(2 N / (k s L)) / 3 inside its edge, s = sin theta (thesis 6.3)."""
    made = wall_on_joints(b, h, JointLaw(stiffness, inf), length=L, density=RHO, restitution=(0.9, 0.9)).oscillator
    found, mass = thesis_limit(made.positive, mass=made.mass), RHO * b * h * L

    def shifted(theta):
        a_f = sqrt(2 * mass * g / (stiffness * sin(theta) * L)) / 3
        R, alpha = hypot(b / 2 - a_f, h / 2), atan2(b / 2 - a_f, h / 2)
        return mass, R, alpha, mass * (b**2 + h**2) / 12 + mass * R**2

    by_hand = brentq(lambda theta: theta - limit_of(shifted(theta)), 0.3 * b / h, b / h, xtol=1e-14)
    assert found < 0.99 * limit_of((mass, hypot(b, h) / 2, atan2(b, h), mass * (b**2 + h**2) / 3))
    assert found == pytest.approx(by_hand, rel=5e-3)  # I of the table moves with the hinge, by hand it is about it
    block = block_at(made.positive, found, mass=made.mass)
    assert found == pytest.approx(limit_of((block.mass, block.radius, block.slenderness, block.inertia)), rel=1e-9)
    assert cos(found) > 0.9
