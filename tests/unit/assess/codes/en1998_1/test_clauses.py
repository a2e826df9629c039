"""EN 1998-1:2004, 4.3.5: every formula on numbers worked by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest
from scipy.constants import g

from assess.codes.en1998_1 import (
    BEHAVIOUR,
    amplification,
    element_period,
    force_over_weight,
    height_ratio,
    period_ratio,
    uplift_pga,
)
from tests.support.straight import GROUND, HOUSE, SOFT, STRAIGHT


@pytest.mark.parametrize(("branch", "period"), [(STRAIGHT, 0.0), (SOFT, 1.0)])  # by the stiffness of SOFT at rest
def test_element_period(branch, period: float) -> None:
    assert element_period(branch) == pytest.approx(period, rel=1e-9)


@pytest.mark.parametrize(
    ("branch", "building", "ratio"),
    [
        (STRAIGHT, HOUSE, 0.0),
        (STRAIGHT, None, 0.0),
        (SOFT, HOUSE, 2.0),  # 1.0 / 0.5
        (SOFT, replace(HOUSE, period=4.0), 0.25),
        (SOFT, None, 1.0),  # the worst
    ],
)
def test_period_ratio(branch, building, ratio: float) -> None:
    assert period_ratio(branch, replace(GROUND, building=building)) == pytest.approx(ratio, rel=1e-9)


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


@pytest.mark.parametrize(("support", "q_a"), [("free", 1.0), ("spanning", 2.0), ("hinged", 1.0)])
def test_behaviour_factors_of_table_4_4(support, q_a: float) -> None:
    assert BEHAVIOUR[support] == q_a
