"""The friction of toothed side walls: sums over courses, a hand-worked wall, random parts and cracks, limits."""

from dataclasses import replace

import numpy as np
import pytest

import assess
from assess.codes.context import Context
from assess.codes.toothing import (
    count_side_walls,
    counted_moment,
    friction_left,
    least_part,
    steepest_slope,
    toothing_friction,
    toothing_steps,
)
from assess.errors import MechanismError
from assess.mechanisms.chain import uplift_multiplier
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Toothing, linear_multiplier
from spectra.gravity import g
from spectra.spectrum import Spectrum
from tests.support.partial_walls import SideWall, UprightWall, facade_with_wedges

DENSITY = 19e3 / g
TOOTHED = assess.SideWalls(bond="toothed", course=0.25, overlap=0.15, thickness=0.5, count=2)


def facade(side_walls: assess.SideWalls = TOOTHED, *, thickness: float = 0.5, loads=(), sides="one") -> Mechanism:
    wall = assess.box(thickness=thickness, length=5.0, height=6.0, density=DENSITY, name="wall")
    return assess.single_block(wall, direction=(1, 0, 0), sides=sides, side_walls=side_walls, loads=loads).mechanism


def toothing(side_walls: assess.SideWalls = TOOTHED, **given) -> Toothing:
    found = facade(side_walls, **given).toothing
    assert found is not None
    return found


def context(spectrum: Spectrum, mechanism: Mechanism) -> Context:
    return Context(spectrum, (1.0,), 1.0, 0.0, None, toothing=mechanism.toothing)


def by_clause(height: float, slope: float, *, thickness: float, walls: int, density: float = DENSITY) -> float:
    """The multiplier of an upright wall with wedges, with 0.4 (1 + 1/n) of the clause in place of a half."""
    one = SideWall(
        thickness=0.5, density=density, course=0.25, overlap=0.15, friction=0.577 * 0.8 * (1.0 + 0.25 / height)
    )
    wall = UprightWall(length=5.0, thickness=thickness, height=6.0, density=DENSITY)
    return uplift_multiplier(facade_with_wedges(wall, (one,) * walls, height=height, angle=float(np.arctan(slope))))


def test_the_formula_is_the_sum_over_courses_with_its_resultant_a_third_of_a_course_higher() -> None:
    h, h_b, length, t_s, w, mu = 6.0, 0.25, 0.15, 0.5, 19e3, 0.577
    i = np.arange(1, 25)
    friction, z = 0.8 * mu * i * h_b * length * t_s * w, h - i * h_b
    found = toothing_friction(height=h, unit_height=h_b, overlap=length, thickness=t_s, unit_weight=w, friction=mu)
    assert found == pytest.approx(friction.sum(), rel=1e-12)
    assert found == pytest.approx(49.334e3, rel=1e-4)
    assert friction @ z / friction.sum() == pytest.approx((h - h_b) / 3.0, rel=1e-12)


def test_the_whole_wall_with_all_its_friction_has_the_multiplier_of_the_worked_example() -> None:
    """Wall 0.5 x 6 x 5 m, 285 kN, F = 49.334 kN of each of two side walls at 2.0 m."""
    found = toothing()
    friction = 2.0 * 49.334e3 * 2.0
    assert found.restoring[-1] / (g * found.excitation[-1]) == pytest.approx(0.08333, rel=1e-4)
    assert (found.restoring[-1] + friction) / (g * found.excitation[-1]) == pytest.approx(0.31414, rel=1e-4)
    assert counted_moment(found) < friction


@pytest.mark.parametrize(("thickness", "walls"), [(0.5, 2), (0.3, 1), (1.2, 2), (2.5, 1)])
def test_no_height_and_no_slope_of_cracks_has_a_lower_multiplier(thickness: float, walls: int) -> None:
    found = toothing(replace(TOOTHED, count=walls), thickness=thickness)
    least = least_part(found)
    assert by_clause(least.height, least.slope, thickness=thickness, walls=walls) == pytest.approx(least.multiplier)
    draw = np.random.default_rng(7)
    random = [
        by_clause(draw.uniform(0.6, 6.0), draw.uniform(0.0, 0.6), thickness=thickness, walls=walls) for _ in range(400)
    ]
    assert least.multiplier <= min(random) * (1.0 + 5e-4)  # 41 levels


@pytest.mark.study
@pytest.mark.parametrize(("thickness", "walls"), [(0.5, 2), (0.3, 1), (1.2, 2), (2.5, 1)])
def test_of_ten_thousand_parts_and_cracks_none_has_a_lower_multiplier(thickness: float, walls: int) -> None:
    least = least_part(toothing(replace(TOOTHED, count=walls), thickness=thickness))
    draw = np.random.default_rng(8)
    random = [
        by_clause(draw.uniform(0.6, 6.0), draw.uniform(0.0, 0.6), thickness=thickness, walls=walls)
        for _ in range(10_000)
    ]
    assert least.multiplier <= min(random) * (1.0 + 5e-4)


def test_a_slender_wall_of_short_overlaps_gives_way_above_a_level_with_wedges_along_the_steps_of_the_bond() -> None:
    """There nothing rubs: the weights of wall and wedges alone, by hand, at every height; friction cannot help."""
    short = replace(TOOTHED, overlap=0.05)
    found = least_part(toothing(short, thickness=0.1))
    h, slope, W, wedge = np.linspace(0.6, 6.0, 20001), 0.2, 19e3 * 5.0 * 0.1, 19e3 * 0.5 / 2.0
    resisting = W * h * 0.05 + 2.0 * wedge * h**2 * slope * (0.1 + h * slope / 3.0)
    alpha = resisting / (W * h**2 / 2.0 + 2.0 * wedge * h**3 * slope * 2.0 / 3.0)
    assert found.multiplier == pytest.approx(alpha.min(), rel=1e-4)
    assert found.height == pytest.approx(h[alpha.argmin()], abs=0.07)
    assert 4.0 < found.height < 5.0
    assert found.slope == pytest.approx(slope)
    rough = least_part(toothing(replace(short, friction=1.0), thickness=0.1))
    assert rough.multiplier == pytest.approx(found.multiplier, rel=1e-12)


@pytest.mark.parametrize("key", ["friction", "overlap"])
def test_without_friction_or_overlap_nothing_counts(key: str) -> None:
    moments = [counted_moment(toothing(replace(TOOTHED, **{key: value}))) for value in (1e-6, 0.02, 0.05, 0.1, 0.15)]
    assert moments[0] == pytest.approx(0.0, abs=10.0)  # N m, of 70 kN m
    assert moments == sorted(moments)


def test_what_rubs_falls_with_the_slope_of_the_crack_to_nothing_along_the_steps_of_the_bond() -> None:
    """α (g B + N W τ 2 h / 3) - R - N W τ (a + h τ / 3) is the friction: linear in τ."""
    found, W = toothing(), 19e3 * 0.5 * 36.0 / 2.0
    slopes = np.linspace(0.0, steepest_slope(found), 7)
    alpha = np.array([by_clause(6.0, each, thickness=0.5, walls=2) for each in slopes])
    rubs = (
        alpha * (g * found.excitation[-1] + 2.0 * W * slopes * 4.0)
        - found.restoring[-1]
        - 2.0 * W * slopes * (0.5 + 2.0 * slopes)
    )
    assert rubs == pytest.approx(np.linspace(2.0 * 49.334e3 * 2.0, 0.0, 7), rel=1e-4, abs=1.0)


def test_as_the_wall_turns_the_joints_lose_their_overlaps_from_the_top() -> None:
    """Against many thin courses, each with what is left of its overlap, and its own lever."""
    found, phi = toothing(), np.array([0.0, 0.005, 0.025, 0.04, 0.08])
    i = np.arange(1, 4001)
    z = 6.0 - i * 6.0 / 4000.0
    left = [i * np.maximum(1.0 - z * np.sin(each) / 0.15, 0.0) @ z * np.cos(each) / (i @ z) for each in phi]
    assert friction_left(found, phi) == pytest.approx(left, rel=1e-3)
    assert friction_left(found, np.array([1e-12]))[0] == pytest.approx(1.0)


def test_it_holds_on_the_way_outwards_alone_and_at_no_collapse() -> None:
    wall = facade(sides="two")
    plain = wall.variants.starting
    spectrum = assess.spectrum("ntc2018", a_g=0.1 * g, f_0=2.5, t_c_star=0.3, soil="A")
    counted = count_side_walls(plain, context(spectrum, wall))
    assert counted.starting is not None
    assert linear_multiplier(counted.starting.positive) == pytest.approx(least_part(toothing()).multiplier)
    assert counted.starting.negative is plain.negative
    assert wall.variants.collapse is plain
    assert count_side_walls(plain, replace(counted, toothing=None)).starting is counted.starting


def test_a_floor_goes_with_the_parts_that_carry_it() -> None:
    floor = assess.MassLoad(mass=4000.0, at=(-0.1, 3.0))
    found = toothing(loads=(floor,))
    below, above = (int(np.searchsorted(found.height, 3.0, side=side)) for side in ("right", "left"))
    step = found.excitation[below] - found.excitation[above]
    assert found.height[above] == pytest.approx(3.0)
    assert step == pytest.approx(0.0, abs=1.0)  # kg m: at the level of its hinge it is not thrown
    assert found.restoring[below] - found.restoring[above] == pytest.approx(4000.0 * g * 0.35, rel=1e-3)


def test_side_walls_rise_to_the_lower_end_of_a_gable() -> None:
    corners = [(0.0, 0.0), (8.0, 0.0), (8.0, 5.0), (4.0, 7.0), (0.0, 5.0)]
    gable = assess.profile(corners, length=0.6, density=DENSITY, name="gable")
    made = assess.single_block(gable, direction=(0, 1, 0), sides="one", side_walls=TOOTHED).mechanism
    assert made.toothing is not None
    assert made.toothing.height[-1] == pytest.approx(5.0, abs=0.25)


def test_what_turns_above_a_level_is_what_a_cut_there_leaves() -> None:
    """Of a wall that steps back at 2 m and leans, and carries a floor: by mechanisms with the cut stated."""
    corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.7, 2.0), (0.6, 6.0), (0.0, 6.0)]
    wall = assess.profile(corners, length=5.0, density=DENSITY, name="wall")
    floor = assess.MassLoad(mass=3000.0, at=(0.2, 4.5))
    made = assess.single_block(wall, direction=(1, 0, 0), sides="one", side_walls=TOOTHED, loads=[floor]).mechanism
    assert made.toothing is not None
    for place in (3, 20, 35):
        height = float(made.toothing.height[place])
        loads = [floor] if height > 1.5 else []
        above = assess.single_block(wall, direction=(1, 0, 0), sides="one", cut=6.0 - height, loads=loads).mechanism
        branch, (edge, _) = above.oscillator.positive, above.positive.hinges[0]
        assert made.toothing.restoring[place] == pytest.approx(branch.restoring[0], rel=2e-4)
        assert made.toothing.excitation[place] == pytest.approx(branch.excitation[0], rel=2e-4)
        assert made.toothing.depth[place] == pytest.approx(edge, rel=1e-4)


def test_where_a_crack_parts_them_nothing_counts() -> None:
    assert facade(assess.SideWalls(bond="detached")).toothing is None


def test_what_a_toothed_joint_lacks_is_told() -> None:
    with pytest.raises(MechanismError, match=r"side_walls.overlap: missing; a toothed joint needs it"):
        facade(replace(TOOTHED, overlap=None))
    with pytest.raises(MechanismError, match=r"side_walls.course = 7 m: more than the 6 m"):
        facade(replace(TOOTHED, course=7.0))
    wall = assess.box(thickness=0.5, length=5.0, height=6.0, density=DENSITY, name="wall")
    with pytest.raises(MechanismError, match="direction: missing, and side_walls stand behind the wall"):
        assess.single_block(wall, side_walls=TOOTHED)


def test_the_sheet_has_the_friction_the_least_multiplier_and_the_moment_that_counts() -> None:
    found = toothing()
    steps = {each.symbol: each for each in toothing_steps(found)}
    assert [each.clause for each in steps.values()] == ["C8.7.1.2"] * 3
    assert steps["F"].value == pytest.approx(49.334e3, rel=1e-4)
    assert steps["α_h"].value == least_part(found).multiplier
    assert steps["M_F"].value == counted_moment(found)
