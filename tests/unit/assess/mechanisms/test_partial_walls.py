"""Façades with wedges, corners and horizontal arches: hand formulas, masonry in small cells, random mechanisms."""

from math import atan, cos, degrees, pi, radians, sin, tan

import numpy as np
import pytest

from assess.loads.load import Force, PointMass
from assess.mechanisms.arch_in_plan import thrust_held_beyond
from assess.mechanisms.branch_table import rigid_branch
from assess.mechanisms.chain import uplift_multiplier
from assess.oscillator import multiplier
from spectra.gravity import g
from tests.support.partial_walls import (
    LOWEST,
    CornerLoad,
    SideWall,
    UprightWall,
    corner,
    facade_with_wedges,
    horizontal_arch,
    least_corner,
    least_facade_with_wedges,
)

FACADE = UprightWall(length=5.0, thickness=0.6, height=7.0, density=1900.0)
RUBBLE = SideWall(thickness=0.5, density=1900.0)
BONDED = SideWall(thickness=0.5, density=1900.0, course=0.25, overlap=0.12, friction=0.577)
FLOOR = PointMass("floor", 6000.0, (-0.5, 3.4), True)
PUSH = Force("thrust", (4000.0, 0.0), (-0.3, 6.8))


def by_cells(
    inside, reach: float, top: float, *, along, density=1900.0, across=0.5, size=0.02
) -> tuple[float, float, float]:
    """Mass, and its moments about the foot, of a part of a wall that is cut into small cells."""
    s = np.arange(size / 2.0, reach, size)
    z = np.arange(size / 2.0, top, size)
    S, Z = np.meshgrid(-s, z, indexing="ij")
    mass = inside(S, Z) * density * across * size**2
    return float(mass.sum()), float((mass * along(S)).sum()), float((mass * Z).sum())


def test_without_side_walls_a_facade_is_as_strong_as_thick_over_high() -> None:
    plain = facade_with_wedges(FACADE, (), height=7.0, angle=0.0)
    assert uplift_multiplier(plain) == pytest.approx(0.6 / 7.0)


def test_toothing_holds_at_a_third_of_the_height() -> None:
    found = uplift_multiplier(facade_with_wedges(FACADE, (BONDED, BONDED), height=7.0, angle=0.0))
    weight = g * 1900.0 * 5.0 * 0.6 * 7.0
    friction = 0.577 * g * 1900.0 * 0.5 * 7.0**2 / 2.0 * 0.12 / 0.25
    assert found == pytest.approx((weight * 0.3 + 2.0 * friction * 7.0 / 3.0) / (weight * 3.5))


def test_along_the_steps_of_the_bond_nothing_rubs() -> None:
    steps = BONDED.steepest
    assert BONDED.toothing_friction(height=5.0, angle=steps) == pytest.approx(0.0, abs=1e-9)
    assert uplift_multiplier(facade_with_wedges(FACADE, (BONDED,), height=6.0, angle=steps)) == pytest.approx(
        uplift_multiplier(facade_with_wedges(FACADE, (RUBBLE,), height=6.0, angle=steps))
    )


@pytest.mark.parametrize("reach", [20.0, 1.4])
def test_a_wedge_weighs_and_holds_what_its_cells_do(reach: float) -> None:
    wall = SideWall(thickness=0.5, density=1900.0, reach=reach)
    slope = tan(radians(24.0))
    mass, behind, above = by_cells(
        lambda s, z: (-s < slope * z) & (-s < reach), 4.0, 7.0, along=lambda s: 0.6 - s, size=0.005
    )
    own = 1900.0 * 5.0 * 0.6 * 7.0
    chain = facade_with_wedges(FACADE, (wall,), height=7.0, angle=radians(24.0))
    assert chain.mass == pytest.approx(own + mass, rel=2e-3)
    assert uplift_multiplier(chain) == pytest.approx((own * 0.3 + behind) / (own * 3.5 + above), rel=2e-3)


def test_a_corner_weighs_and_holds_what_its_cells_do() -> None:
    first, second = SideWall(thickness=0.5, density=1900.0), SideWall(thickness=0.7, density=1900.0, reach=1.0)
    angles, direction, height = (radians(20.0), radians(15.0)), radians(35.0), 6.0
    wall_1 = by_cells(
        lambda s, z: (s < -0.7) & (-s - 0.7 < tan(angles[0]) * z),
        4.0,
        height,
        along=lambda s: -(s * cos(direction) - 0.25 * sin(direction)),
        across=0.5,
    )
    wall_2 = by_cells(
        lambda s, z: (s < -0.5) & (-s - 0.5 < np.minimum(tan(angles[1]) * z, 1.0)),
        4.0,
        height,
        along=lambda s: -(s * sin(direction) - 0.35 * cos(direction)),
        across=0.7,
    )
    column = 1900.0 * 0.5 * 0.7 * height
    behind = column * (0.35 * cos(direction) + 0.25 * sin(direction)) + wall_1[1] + wall_2[1]
    above = column * height / 2.0 + wall_1[2] + wall_2[2]
    chain = corner((first, second), top=6.0, height=height, angles=angles, direction=direction)
    assert chain.mass == pytest.approx(column + wall_1[0] + wall_2[0], rel=5e-3)
    assert uplift_multiplier(chain) == pytest.approx(behind / above, rel=5e-3)


def test_a_corner_keeps_its_inertia_in_every_direction() -> None:
    """Of a square column turned about a corner: m (4 h^2 + 4 a^2) / 12 about the foot along an edge, as a box has."""
    wall = SideWall(thickness=0.6, density=2000.0)
    for direction in (0.0, pi / 4.0, pi / 2.0):
        (block,) = corner((wall, wall), top=3.0, height=3.0, angles=(0.0, 0.0), direction=direction).blocks
        assert block.inertia == pytest.approx(block.mass * (0.6**2 + 3.0**2) / 12.0)


def test_without_thrust_a_corner_turns_with_one_of_its_walls() -> None:
    """The thinner wall falls out with its whole wedge, whose middle is high, and the corner with it, of no wedge."""
    walls = (SideWall(thickness=0.5, density=1900.0), SideWall(thickness=0.8, density=1900.0))
    least = least_corner(walls, top=6.0)
    column, wedge = 0.8 * 6.0, 6.0**2 * tan(radians(30.0)) / 2.0
    assert least.value == pytest.approx((column + wedge) * 0.25 / (column * 3.0 + wedge * 4.0), rel=1e-6)
    assert [degrees(each) for each in least.at[1:]] == pytest.approx([30.0, 0.0, 90.0])


def test_a_hip_rafter_that_pushes_a_corner_over_does_so_along_its_thrust() -> None:
    walls = (RUBBLE, RUBBLE)
    hip = CornerLoad(name="hip", at=(-0.25, -0.25, 6.0), mass=400.0, thrust=(30e3, 30e3))
    least = least_corner(walls, top=6.0, loads=(hip,))
    assert least.value < 0.0
    assert degrees(least.at[3]) == pytest.approx(45.0, abs=0.5)


def random_of(bounds, count: int):
    rng = np.random.default_rng(7)
    low, high = np.array(bounds).T
    return (low + (high - low) * rng.random((count, len(bounds)))).tolist()


@pytest.mark.parametrize("count", [200, pytest.param(10_000, marks=pytest.mark.study)])
@pytest.mark.parametrize("loads", [(), (FLOOR,), (FLOOR, PUSH)])
@pytest.mark.parametrize("side", [RUBBLE, BONDED])
def test_no_random_wedge_is_weaker_than_the_least(side: SideWall, loads, count: int) -> None:
    least = least_facade_with_wedges(FACADE, (side, side), loads=loads)
    bounds = ((LOWEST * FACADE.height, FACADE.height), (0.0, side.steepest))
    others = [
        uplift_multiplier(facade_with_wedges(FACADE, (side, side), height=h, angle=b, loads=loads))
        for h, b in random_of(bounds, count)
    ]
    assert least.value <= min(others) + 1e-9
    assert least.value == pytest.approx(min(others), rel=0.2)


@pytest.mark.parametrize("count", [200, pytest.param(10_000, marks=pytest.mark.study)])
@pytest.mark.parametrize("thrust", [0.0, 5e3])
@pytest.mark.parametrize("walls", [(RUBBLE, BONDED), (BONDED, BONDED)])
def test_no_random_corner_is_weaker_than_the_least(walls, thrust: float, count: int) -> None:
    loads = (CornerLoad(name="hip", at=(-0.2, -0.3, 6.4), mass=900.0, thrust=(thrust, 0.4 * thrust)),)
    least = least_corner(walls, top=6.5, loads=loads)
    bounds = ((0.65, 6.5), (0.0, walls[0].steepest), (0.0, walls[1].steepest), (0.0, pi / 2.0))
    others = [
        uplift_multiplier(corner(walls, top=6.5, height=h, angles=(a, b), direction=c, loads=loads))
        for h, a, b, c in random_of(bounds, count)
    ]
    assert least.value <= min(others) + 1e-9


def test_the_capacity_of_a_turning_corner_falls_as_that_of_a_block() -> None:
    """tan(α - φ) of any rigid block without other forces."""
    chain = corner((RUBBLE, RUBBLE), top=6.0, height=6.0, angles=(0.2, 0.3), direction=0.4)
    branch = rigid_branch(chain, restitution=0.9, name="corner")
    slender = atan(uplift_multiplier(chain))
    assert multiplier(branch) == pytest.approx(np.tan(slender - branch.rotation), abs=1e-9)


def test_the_arch_is_that_of_its_moment_in_the_middle() -> None:
    """H r holds the moment α W L / 8 of a load spread over a span on two supports."""
    arch = horizontal_arch(weight=80e3, span=6.0, thickness=0.6, height=3.0, ends=(40e3, 55e3), strength=1e6)
    assert arch.thrust == 40e3
    assert arch.rise == pytest.approx(0.6 - 40e3 / 3e6)
    assert arch.multiplier == pytest.approx(8.0 * 40e3 * arch.rise / (80e3 * 6.0))


def test_the_arch_bears_up_to_its_masonry_and_nothing_without_ends() -> None:
    arch = horizontal_arch(weight=80e3, span=6.0, thickness=0.6, height=3.0, ends=(1e9, 1e9), strength=1e6)
    assert arch.thrust == pytest.approx(0.06 * 3.0 * 1e6)
    assert arch.rise == pytest.approx(0.54)
    assert arch.multiplier * 80e3 / 18.0 < 1e6 * (0.6 / 6.0) ** 2 * 1.01  # q = f_d (t / l)^2 of EN 1996-1-1, per area
    loose = horizontal_arch(weight=80e3, span=6.0, thickness=0.6, height=3.0, ends=(0.0, 1e9), strength=1e6)
    assert loose.multiplier == 0.0


def test_the_capacity_of_an_arch_is_the_work_of_its_ends() -> None:
    """Two straight halves between hinges: what the thrust takes at both ends is what the weight gives on the way."""
    arch = horizontal_arch(weight=60e3, span=5.0, thickness=0.5, height=3.0, ends=(30e3, 30e3), strength=1.5e6)
    half = np.sqrt((5.0 / 2.0) ** 2 + arch.rise**2 - (arch.rise - arch.displacement) ** 2)
    taken = 2.0 * arch.thrust * (half - half[0])
    given = np.concatenate(
        [[0.0], np.cumsum((arch.capacity[1:] + arch.capacity[:-1]) / 2.0 * np.diff(arch.displacement))]
    )
    assert 60e3 * given / 2.0 == pytest.approx(taken, rel=1e-3, abs=1.0)
    assert arch.capacity[-1] == 0.0


@pytest.mark.parametrize("seed", range(20))
def test_no_other_hinge_of_an_arch_is_weaker_than_the_middle(seed: int) -> None:
    """Virtual work with the middle hinge anywhere: H r (1/a + 1/b) against α W / 2, least at a = b = L / 2."""
    place = np.random.default_rng(seed).uniform(0.05, 0.95) * 6.0
    arch = horizontal_arch(weight=80e3, span=6.0, thickness=0.6, height=3.0, ends=(40e3, 40e3), strength=1e6)
    other = 2.0 * arch.thrust * arch.rise * (1.0 / place + 1.0 / (6.0 - place)) / 80e3
    assert arch.multiplier <= other + 1e-12


def test_what_lies_beyond_an_end_rocks_or_slides() -> None:
    assert thrust_held_beyond(weight=100e3, length=4.0, lever=5.0) == pytest.approx(40e3)
    assert thrust_held_beyond(weight=100e3, length=4.0, lever=5.0, friction=0.3) == pytest.approx(30e3)
