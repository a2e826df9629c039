"""Floor factors against the clauses worked by hand, and the thesis' table of factors."""

import pytest

from spectra.errors import SpectrumError
from spectra.floor import (
    ec8_floor_factor,
    ec8_resonant_part_factor,
    ec8_resonant_part_factor_with_soil,
    ec8_rigid_part_factor,
    nzs1170_5_height_coefficient,
)


@pytest.mark.parametrize(
    ("z_over_h", "period_ratio", "coefficient"),
    [(0.0, 0.0, 0.300), (0.5, 0.5, 0.930), (1.0, 1.0, 1.650), (1.0, 0.0, 0.750)],
)
def test_en_1998_1_eq_4_25_with_alpha_0_25_and_soil_1_2(z_over_h, period_ratio, coefficient):
    """S_a = alpha S [3 (1 + z/H) / (1 + (1 - T_a/T_1)^2) - 0.5] >= alpha S."""
    factor = ec8_floor_factor(10 * z_over_h, building_height=10.0, period_ratio=period_ratio, soil_factor=1.2)
    assert 0.25 * factor == pytest.approx(coefficient, rel=1e-12)


def test_a_part_of_very_long_period_keeps_the_ground_s_acceleration():
    assert ec8_floor_factor(9.0, building_height=9.0, period_ratio=5.0, soil_factor=1.2) == 1.2


def test_the_three_readings_of_ec8():
    assert [ec8_rigid_part_factor(z, building_height=12.0) for z in (0.0, 6.0, 12.0)] == pytest.approx(
        [1.0, 1.75, 2.5], rel=1e-12
    )
    assert [ec8_resonant_part_factor(z, building_height=12.0) for z in (0.0, 6.0, 12.0)] == pytest.approx(
        [2.5, 4.0, 5.5]
    )
    assert ec8_resonant_part_factor_with_soil(6.0, building_height=12.0, soil_factor=1.15) == pytest.approx(1.15 * 4.0)


def test_thesis_table_4_6_nzs():
    """1.8 for both columns, whose mechanisms begin at 4.60 m (4.3.3): 1 + h/6 governs in a building of 24 m."""
    assert round(nzs1170_5_height_coefficient(4.60, building_height=24.0), 1) == 1.8


@pytest.mark.parametrize(
    ("height", "building", "factor"),
    [
        (6.0, 15.0, 2.0),
        (15.0, 50.0, 3.0),
        (5.0, 50.0, 11 / 6),
        (0.0, 9.0, 1.0),
        (1.0, 90.0, 1 + 1 / 9),
        (13, 80, 2.625),
    ],
)
def test_nzs_takes_the_least_that_applies(height, building, factor):
    """1 + h/6 below 12 m; 1 + 10 h/H below 0.2 H; 3 from there on."""
    assert nzs1170_5_height_coefficient(height, building_height=building) == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize("factor", [ec8_rigid_part_factor, ec8_resonant_part_factor, nzs1170_5_height_coefficient])
@pytest.mark.parametrize(("height", "building"), [(-0.1, 9.0), (9.1, 9.0), (float("nan"), 9.0), (1.0, 0.0)])
def test_heights_outside_the_building_are_refused(factor, height, building):
    with pytest.raises(SpectrumError, match="height"):
        factor(height, building_height=building)
