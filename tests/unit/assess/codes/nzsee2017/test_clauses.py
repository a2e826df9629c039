"""NZSEE/MBIE 2017, C8.8.5 with NZS 1170.5, section 8: every formula on numbers worked by hand."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest
from scipy.constants import g

from assess.codes import nzsee2017
from assess.codes.context import Context, Gravity
from assess.codes.nzsee2017 import FaceLoadedWall, MomentLine, gravity_of
from tests.support.straight import GROUND, HOUSE, SOFT, STRAIGHT

HAND = 2e-5  # hand values have six figures


@pytest.mark.parametrize(("level", "factor"), [(1, 0.5), (2, 1.0), (3, 1.3), (4, 1.8)])
def test_required_return_factor(level: int, factor: float) -> None:
    """R of 100, 500, 1000 and 2500 years."""
    assert nzsee2017.required_return_factor(level) == factor


@pytest.mark.parametrize(("moment", "inertia", "b", "J"), [(0.0, 0.0, 4000.0, 8000.0), (1500.0, 300.0, 2500.0, 7700.0)])
def test_seated_wall(moment: float, inertia: float, b: float, J: float) -> None:
    """What the hinge at the edge gives beyond the drawing comes off; the fall a and B stay."""
    wall = FaceLoadedWall(MomentLine(4000.0, 20000.0), 8000.0, 2000.0)
    seat = replace(gravity_of(wall, "positive", replace(GROUND, support="spanning")), edge_moment=moment)
    found = nzsee2017.seated_wall(wall, replace(seat, edge_inertia=inertia))
    assert found == FaceLoadedWall(MomentLine(b, 20000.0), J, 2000.0)


@pytest.mark.parametrize(("slope", "b"), [(0.0, 4000.0), (0.005, 3901.9335), (0.25, -903.325)])
def test_tilted_line(slope: float, b: float) -> None:
    """4000 - psi 9.80665 x 2000 N m; the fall a stays."""
    wall = FaceLoadedWall(MomentLine(4000.0, 20000.0), 8000.0, 2000.0)
    assert nzsee2017.tilted_line(wall, slope) == MomentLine(pytest.approx(b, rel=1e-9), 20000.0)


@pytest.mark.parametrize(
    ("overburden", "k"), [(0.0, 0.975), (1.0, 0.95), (10.0, 0.725), (39.0, 0.0), (50.0, 0.0), (-1.0, 0.975)]
)
def test_thickness_factor(overburden: float, k: float) -> None:
    assert nzsee2017.thickness_factor(overburden) == pytest.approx(k, abs=1e-12)


@pytest.mark.parametrize(
    ("branch", "b", "a"),
    # at rest 2000 g 0.2, slope 2000 g; on joints 2 E(0.2) / 0.2 with E = c 0.2^3 / 6 = 2105.516 J, c = 1579136.7
    [(STRAIGHT, 3922.66, 19613.3), (SOFT, 21055.16, 105275.8)],
)
def test_straight_line(branch, b: float, a: float) -> None:
    line = nzsee2017.straight_line(branch)
    assert (line.b, line.a, line.instability) == pytest.approx((b, a, 0.2), rel=HAND)
    assert nzsee2017.nominal(branch) == FaceLoadedWall(line, 8000.0, 2000.0)


def test_weight_and_load_not_known_apart_count_as_the_wall_s_own() -> None:
    at = Context(GROUND.spectrum, (1.0,), 0.0, 0.0, None, support="spanning")
    whole = FaceLoadedWall(MomentLine(4000.0, 20000.0), 8000.0, 2000.0)
    assert gravity_of(whole, "positive", at) == Gravity(0.0, 4000.0, 0.0, 20000.0, 8000.0, 0.0, 2000.0)
    assert gravity_of(whole, "positive", replace(at, support="free")) is None


@pytest.mark.parametrize(
    ("overburden", "b", "a", "J", "B"),
    [
        # k = 0.95: b - 0.0975 x 1000 - 0.05 x 500, a - 0.05 x 2000, J - 0.05 x 800 - 0.0975 x 400, B - 0.05 x 600
        (1.0, 3877.5, 19900.0, 7921.0, 1970.0),
        # k = 0.975: 1 - k^2 = 0.049375
        (0.0, 3938.125, 19950.0, 7960.25, 1985.0),
    ],
)
def test_with_effective_thickness(overburden: float, b: float, a: float, J: float, B: float) -> None:
    gravity = Gravity(overburden, 1000.0, 500.0, 2000.0, 800.0, 400.0, 600.0)
    found = nzsee2017.with_effective_thickness(FaceLoadedWall(MomentLine(4000.0, 20000.0), 8000.0, 2000.0), gravity)
    assert (found.line.b, found.line.a, found.J, found.B) == pytest.approx((b, a, J, B), rel=1e-9)


@pytest.mark.parametrize(
    ("support", "factor"),
    # 4 ln(x + sqrt(x^2 - 1)) with x = 1 / 0.64 = 1.5625 and 1 / 0.76 = 1.315789
    [("spanning", 4.065393), ("free", 3.100661)],
)
def test_period_factor(support, factor: float) -> None:
    assert nzsee2017.period_factor(support) == pytest.approx(factor, rel=HAND)


@pytest.mark.parametrize(("support", "T_p"), [("spanning", 6.098090), ("free", 4.650992)])  # sqrt(9 / 4) = 1.5
def test_period(support, T_p: float) -> None:
    assert nzsee2017.part_period(FaceLoadedWall(MomentLine(1.0, 4.0), 9.0, 1.0), support=support) == pytest.approx(
        T_p, rel=HAND
    )


@pytest.mark.parametrize(
    ("elevation", "height", "factor"),
    [
        (0.0, 9.0, 1.0),
        (4.0, 8.0, 1.666667),  # 1 + 4 / 6
        (1.0, 10.0, 1.166667),  # 1 + 1 / 6, less than 1 + 10 x 0.1
        (5.0, 100.0, 1.5),  # 1 + 10 x 0.05, less than 1 + 5 / 6
        (20.0, 40.0, 3.0),
        (3.0, None, 1.5),
        (30.0, None, 3.0),
        (9.0, 6.0, 2.0),  # above the building: at its top
    ],
)
def test_floor_factor(elevation: float, height: float | None, factor: float) -> None:
    building = None if height is None else replace(HOUSE, height=height)
    at = replace(GROUND, elevation=elevation, building=building)
    assert nzsee2017.floor_factor(at) == pytest.approx(factor, rel=HAND)


@pytest.mark.parametrize(
    ("T_p", "floor", "coefficient"),
    [(0.5, 1.0, 2.0), (0.75, 1.0, 2.0), (1.0, 2.0, 3.0), (1.5, 1.0, 0.5), (2.0, 3.0, 1.5)],
)
def test_part_coefficient(T_p: float, floor: float, coefficient: float) -> None:
    """C_i(T_p) = 2 (1.75 - T_p), between 0.5 and 2."""
    assert nzsee2017.part_coefficient(T_p, floor=floor) == pytest.approx(coefficient, rel=1e-12)


@pytest.mark.parametrize(
    ("T_p", "floor", "risk", "demand"),
    # B / J = 0.25: x 0.25 x 2 x 0.5 x 1.5; x (1 / 2 pi)^2 x 1.5
    [(pi, 2.0, 1.5, 0.09375), (1.0, 1.0, 1.0, 0.00949886)],
)
def test_demand_per_pga(T_p: float, floor: float, risk: float, demand: float) -> None:
    part = FaceLoadedWall(MomentLine(1.0, 1.0), 8000.0, 2000.0)
    assert nzsee2017.demand_per_pga(part, T_p, floor=floor, risk_factor=risk) == pytest.approx(demand, rel=HAND)


@pytest.mark.parametrize(
    ("multiplier", "floor", "risk", "in_g"),
    [(0.2, 1.0, 1.0, 0.1), (0.2, 5.0 / 3.0, 1.0, 0.06), (0.2, 1.0, 0.5, 0.2), (None, 1.0, 1.0, None)],  # C_i(0) = 2
)
def test_uplift_pga(multiplier: float | None, floor: float, risk: float, in_g: float | None) -> None:
    found = nzsee2017.uplift_pga(multiplier, floor=floor, risk_factor=risk)
    assert found == (None if in_g is None else pytest.approx(in_g * g, rel=1e-9))
