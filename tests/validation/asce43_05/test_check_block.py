"""ASCE 43-05 A.2 on a block of half-width 0.5 m and centroid height 2.5 m, evaluated by hand with g = 9.81 m/s2."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.asce43_05 import (
    capacity_acceleration,
    effective_damping,
    effective_frequency,
    stored_work,
    vertical_factor,
)
from assess.mechanisms.single_block import single_block
from tests.support.bodies import planar_box

ALPHA = 0.1973955598
# theta / alpha: f1, SA_CAP [g], f_e [Hz] at g = 9.81
ROWS = {
    0.10: (0.003753, 0.38024, 1.17505),
    0.25: (0.008648, 0.35050, 0.71352),
    0.50: (0.014841, 0.30073, 0.46734),
    1.00: (0.019804, 0.20065, 0.26993),
}


@pytest.fixture(scope="module")
def branch():
    return single_block("block", planar_box(1.0, 5.0, length=2.0, density=2000.0)).oscillator.positive


@pytest.mark.parametrize("ratio", ROWS)
def test_work_capacity_and_frequency(branch, ratio):
    f1, cap, f_e = ROWS[ratio]
    theta = np.array([ratio * ALPHA])
    assert stored_work(branch, theta)[0] == pytest.approx(f1, rel=2e-4)  # printed to four digits
    assert stored_work(branch, theta)[0] == pytest.approx(np.cos(theta[0]) + 0.2 * np.sin(theta[0]) - 1, rel=1e-9)
    assert capacity_acceleration(branch, theta, f_v=1.0)[0] / g == pytest.approx(cap, rel=2e-5)
    assert effective_frequency(branch, theta)[0] == pytest.approx(f_e * np.sqrt(g / 9.81), rel=2e-5)


def test_restitution_and_damping(branch):
    assert branch.restitution == pytest.approx(0.942308, rel=1e-6)  # C_R = 1 - 2 a^2 / C1
    assert effective_damping(branch.restitution) == pytest.approx(0.018912, rel=1e-4)
    assert effective_damping(0.0) == 1.0
    assert effective_damping(1.0) == 0.0


def test_capacity_tends_to_twice_the_uplift_acceleration_at_rest(branch):
    assert capacity_acceleration(branch, np.array([1e-7]), f_v=1.0)[0] == pytest.approx(2 * g * 0.2, rel=1e-6)


def test_vertical_motion_lowers_the_capacity():
    assert vertical_factor(0.2, 0.0) == 1.0
    assert vertical_factor(0.2, 2 / 3) == pytest.approx(np.sqrt(1 + (0.2 * 2 / 3) ** 2), rel=1e-14)
