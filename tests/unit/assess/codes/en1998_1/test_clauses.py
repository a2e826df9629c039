"""EN 1998-1:2004, 4.3.5: every formula on numbers worked by hand."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.context import Wall
from assess.codes.en1998_1 import (
    BEHAVIOUR,
    amplification,
    behaviour_factor,
    bending_period,
    force_over_weight,
    height_ratio,
    joint_period,
    longest_period,
    period_ratio,
    uplift_pga,
)
from tests.support.straight import GROUND, HOUSE, SOFT, STRAIGHT

PARAPET, PANEL = Wall(1.0, 0.3), Wall(4.0, 0.4)
PACE = 0.003829708  # s/m: sqrt(2200 / 0.15e9)


@pytest.mark.parametrize(("branch", "period"), [(STRAIGHT, 0.0), (SOFT, 1.0)])  # by the stiffness of SOFT at rest
def test_joint_period(branch, period: float) -> None:
    assert joint_period(branch) == pytest.approx(period, rel=1e-9)


@pytest.mark.parametrize(
    ("wall", "support", "period"),
    [
        (PARAPET, "free", 0.0791473),  # 6.2 x 1 / 0.3 x PACE
        (PANEL, "free", 0.949768),  # 6.2 x 16 / 0.4 x PACE
        (PANEL, "spanning", 0.337014),  # 2.2 x 16 / 0.4 x PACE
    ],
)
def test_bending_period(wall: Wall, support, period: float) -> None:
    """The first mode of a beam: beta^2 / (2 pi) sqrt(E I / (rho A)) / L^2 with beta = 1.8751, or pi, in Hz."""
    assert bending_period(wall, support) == pytest.approx(period, rel=1e-5)
    beta = {"free": 1.8751041, "spanning": pi}[support]
    beam = 2 * pi * sqrt(12) / beta**2 * wall.height**2 / wall.thickness * PACE
    assert bending_period(wall, support) == pytest.approx(beam, rel=3e-3)  # 6.2 and 2.2 have two digits


@pytest.mark.parametrize(
    ("branch", "wall", "support", "period"),
    [
        (STRAIGHT, PARAPET, "free", 0.0791473),
        (SOFT, PARAPET, "free", 1.003127),  # with 1 s on the joints: sqrt(1 + 0.0791473^2)
        (STRAIGHT, None, "free", None),
        (STRAIGHT, PARAPET, "hinged", None),
    ],
)
def test_longest_period(branch, wall, support, period: float | None) -> None:
    found = longest_period(branch, replace(GROUND, wall=wall, support=support))
    assert found == (None if period is None else pytest.approx(period, rel=1e-5))


@pytest.mark.parametrize(
    ("branch", "wall", "building", "ratio"),
    [
        (STRAIGHT, PARAPET, HOUSE, 0.158295),  # 0.0791473 / 0.5
        (STRAIGHT, PANEL, HOUSE, 1.0),  # longer than T_1, which lies within the range
        (SOFT, PARAPET, replace(HOUSE, period=4.0), 0.250782),
        (STRAIGHT, PARAPET, None, 1.0),  # the worst
        (STRAIGHT, None, HOUSE, 1.0),
    ],
)
def test_period_ratio(branch, wall, building, ratio: float) -> None:
    at = replace(GROUND, building=building, wall=wall)
    assert period_ratio(branch, at) == pytest.approx(ratio, rel=1e-5)
    longest = longest_period(branch, at)
    if building is not None and longest is not None:  # none of the range asks for more
        demands = [amplification(T_a / building.period, at) for T_a in np.linspace(0.0, longest, 1001)]
        assert amplification(ratio, at) == pytest.approx(max(demands), rel=1e-5)


@pytest.mark.parametrize(
    ("elevation", "rise", "building", "ratio"),
    [
        (0.0, 0.0, HOUSE, 0.0),
        (4.5, 0.0, HOUSE, 0.5),
        (3.0, 3.0, HOUSE, 0.5),
        (12.0, 0.0, HOUSE, 1.0),
        (4.5, 0.0, None, 0.0),
    ],
)
def test_height_ratio(elevation: float, rise: float, building, ratio: float) -> None:
    at = replace(GROUND, elevation=elevation, rise=rise, building=building)
    assert height_ratio(at) == pytest.approx(ratio, rel=1e-12)


@pytest.mark.parametrize(
    ("elevation", "ratio", "factor"),
    [
        (0.0, 0.0, 1.0),  # 3 / 2 - 0.5
        (9.0, 1.0, 5.5),  # 3 x 2 / 1 - 0.5
        (4.5, 0.5, 3.1),  # 3 x 1.5 / 1.25 - 0.5
        (9.0, 0.0, 2.5),  # 3 x 2 / 2 - 0.5
        (0.0, 3.0, 1.0),  # 3 / 5 - 0.5 = 0.1, at least 1
    ],
)
def test_amplification(elevation: float, ratio: float, factor: float) -> None:
    assert amplification(ratio, replace(GROUND, elevation=elevation, building=HOUSE)) == pytest.approx(
        factor, rel=1e-12
    )


@pytest.mark.parametrize(
    ("S_a", "q_a", "gamma_a", "force"), [(0.9, 2.0, 1.5, 0.675), (0.9, 1.0, 1.0, 0.9), (0.435, 2.0, 1.0, 0.2175)]
)
def test_force_over_weight(S_a: float, q_a: float, gamma_a: float, force: float) -> None:
    found = force_over_weight(S_a, behaviour_factor=q_a, importance_factor=gamma_a)
    assert found == pytest.approx(force, rel=1e-12)


@pytest.mark.parametrize(
    ("branch", "amplified", "in_g"), [(STRAIGHT, 1.0, 0.2), (STRAIGHT, 2.5, 0.08), (SOFT, 2.5, None)]
)
def test_uplift_pga(branch, amplified: float, in_g: float | None) -> None:
    found = uplift_pga(branch, amplified)
    assert found == (None if in_g is None else pytest.approx(in_g * g, rel=1e-9))


@pytest.mark.parametrize(
    ("support", "held", "q_a"),
    [
        ("free", {}, 1.0),
        ("free", {"positive": 0.25}, 2.0),
        ("free", {"positive": 0.24}, 1.0),
        ("free", {"negative": 0.25}, 1.0),
        ("spanning", {}, 2.0),
    ],
)
def test_the_behaviour_factor_goes_by_what_holds_the_element(support, held, q_a: float) -> None:
    """Table 4.4: 1.0 for cantilevers, 2.0 for what is held at or above its centre of mass, in the direction held.

    A force of 0.5 W leaves 0.25 W at q_a = 2, which the ties must resist alone.
    """
    context = replace(GROUND, support=support, held=held)
    assert behaviour_factor(context, "positive", 0.5) == q_a


@pytest.mark.parametrize(("support", "q_a"), [("free", 1.0), ("spanning", 2.0), ("hinged", 1.0)])
def test_behaviour_factors_of_table_4_4(support, q_a: float) -> None:
    assert BEHAVIOUR[support] == q_a
