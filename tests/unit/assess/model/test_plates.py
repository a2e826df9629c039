"""Where plates sit on walls: leaf, edges, openings, weight and neighbours, against arithmetic by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.constants import g

import assess
from assess.errors import AssessError
from assess.geometry.boolean import subtract
from assess.loads.anchorage import Anchorage, Plate
from assess.loads.load import Tie

LENGTH, HEIGHT, THICKNESS = 12.0, 8.0, 0.6
BAR = {"area": 314e-6, "young_modulus": 210e9, "yield_stress": 235e6, "fracture_strain": 0.1}
FULL: dict[str, Any] = {
    "width": 0.3, "height": 0.3, "thickness": 0.015, "yield_stress": 235e6, "nut": 0.05,
    "thread_area": 245e-6, "tensile_strength": 360e6, "shear_strength": 0.02e6, "bearing_strength": 1e6,
    "far_strength": 80e3, "between": 90e3,
}  # fmt: skip


def tie(y: float, z: float, **changes: Any) -> assess.TieLoad:
    plate = Plate(**{**FULL, **changes})
    return assess.TieLoad(at=[0.3, y, z], anchor=[-9.7, y, z], length=10.0, evidence="tests", plate=plate, **BAR)


def facade(*ties: assess.TieLoad, body: Any = None) -> list[Anchorage]:
    wall = body or assess.box(thickness=THICKNESS, length=LENGTH, height=HEIGHT, density=2000.0)
    block = assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=ties)
    found = [load for load in block.mechanism.positive.loads if isinstance(load, Tie)]
    assert all(each.anchorage is not None and each.strength == each.anchorage.strength for each in found)
    return [each.anchorage for each in found if each.anchorage is not None]


def surface(found: Anchorage) -> float:
    assert found.site.surface is not None
    return found.site.surface[0]


def test_in_the_middle_of_a_wall_it_has_all_of_its_cone() -> None:
    (found,) = facade(tie(0, 5))
    assert found.leaf == pytest.approx(THICKNESS, rel=1e-9)
    assert surface(found) == pytest.approx(2.16, rel=1e-6)
    assert found.site.bearing_area == pytest.approx(0.09, rel=1e-6)
    assert (found.strength, found.governing) == (pytest.approx(16e3, rel=1e-6), "punching")


def test_at_the_top_a_side_is_lacking() -> None:
    """The upper edge of the plate at the top: 1.26 m2, by hand in the tests of `weakest_cone`."""
    (found,) = facade(tie(0, HEIGHT - 0.15))
    assert surface(found) == pytest.approx(1.26, rel=1e-3)


def test_beds_of_units_that_slide_are_those_in_the_wall() -> None:
    """A course of 0.2 m above the plate, of which the top leaves 0.05 m; all of both lower down."""
    units = {"course": 0.2, "overlap": 0.1}
    (high,), (low,) = facade(tie(0, HEIGHT - 0.2, **units)), facade(tie(0, 5, **units))
    assert high.site.beds == pytest.approx(1.25, rel=1e-6)
    assert low.site.beds == pytest.approx(2.0, rel=1e-6)


@pytest.mark.parametrize(("y", "z"), [(0, HEIGHT - 0.05), (LENGTH / 2 - 0.05, 5), (1.7, 5)])
def test_a_plate_that_sticks_out_over_an_edge_is_refused(y: float, z: float) -> None:
    """By 0.1 m each: half of 0.3 m less the 0.05 m to the top, to the end, and to a window that begins at y = 1.75."""
    wall = assess.box(thickness=THICKNESS, length=LENGTH, height=HEIGHT, density=2000.0)
    window = assess.box(thickness=2.0, length=1.5, height=1.5, base=[0, 2.5, 4.25], density=1.0)
    with pytest.raises(AssessError, match="sticks out by 100 mm"):
        facade(tie(y, z), body=replace(wall, solid=subtract(wall.solid, [window.solid])))


def test_masonry_above_the_cone_presses_on_it() -> None:
    """Its cone ends 0.15 + 0.6 m above 5 m: 2.25 m of 2000 kg/m3 are 44.1 kPa; 0.6 of it counts."""
    (found,) = facade(tie(0, 5, friction=0.4))
    assert found.site.weights[0] == pytest.approx(2000 * g * 2.25, rel=1e-6)
    assert found.normal_stress == pytest.approx(0.6 * 2000 * g * 2.25, rel=1e-6)
    assert found.strength == pytest.approx(2.16 * (0.02e6 + 0.4 * 0.6 * 2000 * g * 2.25) / 2.7, rel=1e-4)


def without(*cuts: tuple[float, float, float, float], height: float = HEIGHT) -> Any:
    """The wall, `height` high, without rectangles y0, z0, y1, z1."""
    wall = assess.box(thickness=THICKNESS, length=LENGTH, height=height, density=2000.0)
    parts = [
        assess.box(thickness=2.0, length=y1 - y0, height=z1 - z0, base=[0, (y0 + y1) / 2, z0], density=1.0).solid
        for y0, z0, y1, z1 in cuts
    ]
    return replace(wall, solid=subtract(wall.solid, parts))


def test_a_tower_elsewhere_does_not_press_on_a_cone() -> None:
    """From 5.5 m a cone ends at 6.25 m, under 0.25 m of 6.5 m of wall, and under 7.75 m where it rises to 14 m."""
    body = without((-7, 6.5, 2, 15), height=14.0)
    low, high = facade(tie(-3, 5.5, friction=0.1), tie(4, 5.5, friction=0.1), body=body)
    assert low.site.weights[0] == pytest.approx(2000 * g * 0.25, rel=1e-6)
    assert high.site.weights[0] == pytest.approx(2000 * g * 7.75, rel=1e-6)
    assert low.strength == pytest.approx(2.16 * (0.02e6 + 0.1 * 0.6 * 2000 * g * 0.25) / 2.7, rel=1e-4)


def test_the_least_column_above_a_cone_presses_on_it() -> None:
    """Under a gable that falls from 10 m in the middle to 6 m at y = 6 the end of the cone at 2.75 m has 8.167 m."""
    wall = assess.profile([[-6, 0], [6, 0], [6, 6], [0, 10], [-6, 6]], length=THICKNESS, density=2000.0, name="gable")
    held = replace(tie(0, 5, friction=0.4), at=[2, 0.3, 5], anchor=[2, -9.7, 5])
    block = assess.single_block(wall, direction=[0, 1, 0], sides="one", loads=[held])
    (load,) = block.mechanism.positive.loads
    assert isinstance(load, Tie)
    assert load.anchorage is not None
    assert load.anchorage.site.weights[0] == pytest.approx(2000 * g * (10 - 4 / 6 * 2.75 - 5.75), rel=1e-4)


def test_above_an_opening_over_the_cone_nothing_presses_on_it() -> None:
    """A cone that ends at 5.75 m under a window at 6 m has 0.25 m above it; beside that window all of 2.25 m."""
    (under,) = facade(tie(0, 5, friction=0.1), body=without((-1, 6, 1, 7)))
    (beside,) = facade(tie(0, 5, friction=0.4), body=without((0.8, 4, 1.8, 5.5)))
    assert under.site.weights[0] == pytest.approx(2000 * g * 0.25, rel=1e-6)
    assert beside.site.weights[0] == pytest.approx(2000 * g * 2.25, rel=1e-6)


def test_a_cone_that_runs_out_to_the_top_has_no_weight_above_it() -> None:
    """1 m under the top: up to it 0.9 m below and 1.45 m at either side, 2.28 m2; else 2.16 under 0.25 m, and more."""
    (found,) = facade(tie(0, HEIGHT - 1, friction=1.0))
    assert found.site.weights[0] == 0.0
    assert found.strength == pytest.approx(2.28 * 0.02e6 / 2.7, rel=1e-4)
    assert 2.16 * (0.02e6 + 0.6 * 2000 * g * 0.25) > 2.28 * 0.02e6


def test_plates_whose_cones_meet_share_their_outline() -> None:
    """0.5 m apart: 2.82 m2 for both, by hand in the tests of `weakest_cone`; one farther away stands alone."""
    near, other, far = facade(tie(0, 5), tie(0.5, 5), tie(4, 5))
    for found in (near, other):
        assert found.site.group == 2
        assert found.strength == pytest.approx(2.82 / 2 * 0.02e6 / 2.7, rel=2e-3)
    assert (far.site.group, far.strength) == (1, pytest.approx(16e3, rel=1e-6))


def test_a_third_plate_whose_cone_barely_meets_takes_nothing_off_two_close_ones() -> None:
    """0.3 m apart two are one of 0.6 x 0.3 m: 2 (0.9 + 1.2) 0.6 = 2.52 m2, 1.26 each; the third is 1.4 m away."""
    first, second, third = facade(tie(0, 5), tie(0.3, 5), tie(1.7, 5))
    for found in (first, second):
        assert (found.site.group, found.site.meeting) == (2, 3)
        assert found.strength == pytest.approx(1.26 * 0.02e6 / 2.7, rel=1e-3)
    assert third.site.meeting == 3
    assert third.strength is not None
    assert second.strength is not None
    assert third.strength > second.strength


def test_plates_that_overlap_are_refused() -> None:
    for apart in (0.0, 0.2):
        with pytest.raises(AssessError, match=r"loads\[1\]\.plate: overlaps the plate of another tie"):
            facade(tie(0, 5), tie(apart, 5))


def test_a_tie_of_two_mechanisms_is_one_plate() -> None:
    (found,) = facade(replace(tie(0, 5), others=(tie(0.02, 5), tie(0, 5))))
    assert (found.site.meeting, found.strength) == (1, pytest.approx(16e3, rel=1e-6))


@pytest.mark.parametrize(
    ("places", "bays"),
    [
        ((0.0,), ((12.0, True),)),
        ((-4.5, -1.5, 1.5, 4.5), ((3.0, True), (3.0, False), (3.0, False), (3.0, True))),
        ((-2.0, 2.0), ((8.0, True), (8.0, True))),
        ((-4.5, 0.0, 4.5), ((4.5, True), (4.5, True), (4.5, True))),
        ((-5.5, -3.5, 0.0, 3.5, 5.5), ((2.0, False), (3.5, False), (3.5, False), (3.5, False), (2.0, False))),
    ],
)
def test_the_farthest_neighbour_or_end_is_its_bay(
    places: tuple[float, ...], bays: tuple[tuple[float, bool], ...]
) -> None:
    found = facade(*(tie(y, 5) for y in places))
    assert [(pytest.approx(each.site.bay), each.site.at_end) for each in found] == [*bays]


def test_an_opening_beside_a_plate_takes_its_side() -> None:
    """A window that touches the right side of the plate and is as high as the cone: as at an edge, 1.26 m2."""
    wall = assess.box(thickness=THICKNESS, length=LENGTH, height=HEIGHT, density=2000.0)
    window = assess.box(thickness=2.0, length=1.5, height=1.5, base=[0, 0.9, 4.25], density=1.0)
    (found,) = facade(tie(0, 5), body=replace(wall, solid=subtract(wall.solid, [window.solid])))
    assert surface(found) == pytest.approx(1.26, rel=1e-3)


def test_a_leaf_is_no_thicker_than_drawn() -> None:
    (found,) = facade(tie(0, 5, leaf=0.25))
    assert surface(found) == pytest.approx(2 * (0.6 + 0.5) * 0.25, rel=1e-6)
    with pytest.raises(AssessError, match=r"is drawn is 0\.6 m thick"):
        facade(tie(0, 5, leaf=0.7))


def test_beside_the_wall_it_is_refused() -> None:
    with pytest.raises(AssessError, match="no masonry behind it"):
        facade(tie(7, 5))


@pytest.mark.parametrize("x", [-0.3, 0.0])
def test_off_the_outer_face_it_is_refused_with_its_place(x: float) -> None:
    """The wall, 0.6 m thick, is about x = 0, and the anchor at -x: the outer face is at 0.3 m."""
    with pytest.raises(AssessError, match=r"off the outer face.*it is at = \[0\.3, 1, 5\]"):
        facade(replace(tie(1, 5), at=[x, 1, 5]))
    facade(replace(tie(1, 5), at=[0.27, 1, 5]))


def test_the_outer_of_two_leaves_is_gripped() -> None:
    """Two solids of 0.25 and 0.35 m: the plate is on the side away from the anchor, at +x, and grips the 0.25 m."""
    outer = assess.box(thickness=0.25, length=LENGTH, height=HEIGHT, base=[0.175, 0, 0], density=2000.0, name="outer")
    inner = assess.box(thickness=0.35, length=LENGTH, height=HEIGHT, base=[-0.125, 0, 0], density=2000.0, name="inner")
    block = assess.single_block([inner, outer], direction=[1, 0, 0], sides="one", loads=[tie(0, 5, friction=0.4)])
    (load,) = block.mechanism.positive.loads
    assert isinstance(load, Tie)
    assert load.anchorage is not None
    assert load.anchorage.leaf == pytest.approx(0.25)
    assert np.isclose(load.anchorage.normal_stress, 0.6 * 2000 * g * (HEIGHT - 5 - 0.15 - 0.25))


def test_it_does_not_depend_on_the_way_the_wall_moves() -> None:
    """Nor do ties of another face, as at a corner, punch with it."""
    corner = assess.TieLoad(
        at=[0.1, 6.0, 5], anchor=[-0.1, -4, 5], length=9.9, evidence="tests", plate=Plate(**FULL), **BAR
    )
    wall = assess.box(thickness=THICKNESS, length=LENGTH, height=HEIGHT, density=2000.0)
    for direction in ([1, 0, 0], [-1, 0, 0]):
        block = assess.single_block(wall, direction=direction, sides="two", loads=[tie(0, 5), corner])
        found = next(load for load in block.mechanism.positive.loads if isinstance(load, Tie))
        assert found.anchorage is not None
        assert surface(found.anchorage) == pytest.approx(2.16, rel=1e-6)
        assert found.anchorage.site.group == 1


def test_an_upright_tie_has_no_plate_on_a_face() -> None:
    upright = assess.TieLoad(at=[0, 0, 7], anchor=[0, 0, -3], length=10.0, plate=Plate(**FULL), **BAR)
    with pytest.raises(AssessError, match="its tie is upright"):
        facade(upright)


def test_a_pretension_above_what_the_anchorage_bears_is_refused() -> None:
    with pytest.raises(AssessError, match=r"loads\[1\]\.force: a pretension of 17 kN, above .* 16 kN \(punching\)"):
        facade(replace(tie(0, 5), force=17e3))


def test_places_of_two_numbers_do_not_say_where_a_plate_is() -> None:
    given = assess.TieLoad(at=[0, 5], anchor=[-10, 5], length=10.0, plate=Plate(**FULL), **BAR)
    with pytest.raises(AssessError, match=r"it must be \[x, y, z\]"):
        facade(given)


@pytest.mark.parametrize(("direction", "held"), [([1, 0, 0], True), ([-1, 0, 0], False)])
def test_an_anchor_in_front_of_a_wall_is_refused(direction: list[float], *, held: bool) -> None:
    """The anchor is at x = -9.7 m: a wall that overturns to +x lengthens the tie, one to -x shortens it."""
    wall = assess.box(thickness=THICKNESS, length=LENGTH, height=HEIGHT, density=2000.0)
    if held:
        assess.single_block(wall, direction=direction, sides="one", loads=[tie(0, 5)])
    else:
        with pytest.raises(AssessError, match="10 m in front of the wall"):
            assess.single_block(wall, direction=direction, sides="one", loads=[tie(0, 5)])
    assess.single_block(wall, direction=direction, sides="two", loads=[tie(0, 5)])


def test_a_wall_may_fall_away_from_what_holds_it_where_no_direction_is_given() -> None:
    """Anchored on the side of +x it falls to +x as if free; against a wall on that of -x it can fall nowhere else."""
    wall = assess.box(thickness=0.6, length=4.0, height=6.0, density=2000.0, name="front")
    bar = {**BAR, "length": 9.0, "strength": 1e5}
    held = assess.TieLoad(at=[-0.3, 0, 5], anchor=[8.7, 0, 5], **bar)
    free = assess.single_block(wall, loads=[held]).mechanism
    assert free.negative is not None
    angles = {each.angle_deg: each.uplift_multiplier for each in free.candidates}
    assert angles[0.0] == pytest.approx(0.1)
    assert angles[180.0] == pytest.approx(0.1)
    behind = assess.box(thickness=4.0, length=0.4, height=6.0, density=2000.0, base=[-2.3, 0, 0], name="cross")
    with pytest.raises(AssessError, match="9 m in front of the wall"):
        assess.single_block(wall, loads=[held], around=[behind])
