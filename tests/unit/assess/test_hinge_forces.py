"""When a hinge slides: closed forms of Coulomb's friction on level and inclined planes."""

from __future__ import annotations

from dataclasses import replace
from math import atan, cos, sin, tan

import pytest
from scipy.constants import g

from assess.oscillator import HingeForces, Pressure, required_friction
from tests.support.answered import HINGE


def on_a_plane(
    *, slope: float, friction: float | None, weight: float = 1000.0, activation: float = 0.4 * g, thrust: float = 0.0
) -> HingeForces:
    """A block on a plane that falls by `slope` [rad] along the motion; thrust: a given force along the motion [N]."""
    n_x, n_z = sin(slope), cos(slope)

    x, start = -thrust, -weight * activation / g - thrust
    pressed = {
        name: Pressure(along * n_x + weight * n_z, along * n_z - weight * n_x)
        for name, along in (("starting", start), ("resting", x))
    }
    return replace(HINGE, horizontal=start, vertical=weight, face=(n_x, n_z), acceleration=activation,
                   friction=friction, **pressed)  # fmt: skip


@pytest.mark.parametrize("mu", [0.05, 0.2, 0.399])
def test_a_block_on_level_ground_slides_at_mu_g_if_that_is_before_it_rocks(mu: float) -> None:
    assert on_a_plane(slope=0.0, friction=mu).sliding_acceleration == pytest.approx(mu * g, rel=1e-12)
    assert on_a_plane(slope=0.0, friction=mu, activation=0.99 * mu * g).sliding_acceleration is None


@pytest.mark.parametrize("slope", [0.05, 0.2, -0.15])
@pytest.mark.parametrize("mu", [0.3, 0.5])
def test_a_block_on_a_slope_slides_at_the_angle_of_friction_less_the_slope(slope: float, mu: float) -> None:
    block = on_a_plane(slope=slope, friction=mu, activation=2.0 * g)
    assert block.sliding_acceleration == pytest.approx(g * tan(atan(mu) - slope), rel=1e-12)
    assert block.pressure_at(block.sliding_acceleration).shear == pytest.approx(
        -mu * block.pressure_at(block.sliding_acceleration).normal, rel=1e-12
    )
    assert block.mobilised_friction(0.0) == pytest.approx(abs(tan(slope)), rel=1e-12)


def test_a_slope_steeper_than_the_angle_of_friction_slides_at_rest() -> None:
    assert on_a_plane(slope=0.5, friction=tan(0.49)).sliding_acceleration == 0.0


def test_a_thrust_along_the_motion_leaves_less_for_the_ground() -> None:
    pushed = on_a_plane(slope=0.0, friction=0.3, thrust=100.0)
    assert pushed.sliding_acceleration == pytest.approx((0.3 - 0.1) * g, rel=1e-12)
    assert pushed.required_friction == pytest.approx(0.4 + 0.1, rel=1e-12)


def test_a_pull_against_the_motion_may_need_more_friction_at_rest_than_later() -> None:
    held = on_a_plane(slope=0.0, friction=0.3, thrust=-250.0)
    found = [held.mobilised_friction(a * g) for a in (0.0, 0.1, 0.25, 0.4, 0.9)]
    assert found == pytest.approx([0.25] * 5, rel=1e-12)
    assert held.sliding_acceleration is None
    assert on_a_plane(slope=0.0, friction=0.2, thrust=-250.0).sliding_acceleration == 0.0


def test_friction_that_is_not_known_gives_no_acceleration() -> None:
    assert on_a_plane(slope=0.0, friction=None).sliding_acceleration is None


@pytest.mark.parametrize("normal", [0.0, -3.0])
def test_a_hinge_on_which_nothing_presses_lifts(normal: float) -> None:
    assert required_friction(Pressure(normal, 2.0)) is None
