"""Which walls carry a floor or roof: by statics, and by the worse where the drawing leaves it open."""

from dataclasses import replace
from math import tan

import numpy as np
import pytest

from assess.geometry.solid import profile
from assess.model.candidates import Candidates, find_candidates
from assess.model.covering_paths import load_paths
from assess.model.structure import Part, Structure
from tests.support.buildings import STONE, TIMBER, block, part_of, touching

FRONT = part_of("Front", block((0, 9), (0, 0.5), (0, 3)), normal=(0, -1), outward=True)
BACK = part_of("Back", block((0, 9), (6.5, 7), (0, 3)), normal=(0, 1), outward=True)
LEFT = part_of("Left", block((0, 0.5), (0.5, 6.5), (0, 3)), normal=(-1, 0), outward=True)
RIGHT = part_of("Right", block((8.5, 9), (0.5, 6.5), (0, 3)), normal=(1, 0), outward=True)


def roof(x=(0.0, 9.0), y=(0.0, 7.0)) -> Part:
    return part_of("Roof", block(x, y, (3.0, 3.3), density=TIMBER), "floor", normal=(0, 1), density=TIMBER)


def building(*parts: Part) -> Structure:
    return Structure(parts=parts, contacts=touching(parts))


def turned(found: Candidates, wall: str):
    return next(each for each in found if each.kind == "overturning" and each.parts == (wall,))


def test_a_covering_on_walls_both_ways_goes_down_by_either_or_by_both() -> None:
    structure = building(FRONT, BACK, LEFT, RIGHT, roof())
    both, *alone = load_paths(structure.part("Roof"), structure)
    assert sum(both.shares.values()) == pytest.approx(1.0)
    assert both.shares["Front"] == pytest.approx(9.0 / 30.0)  # by their areas: 9 and 6 m of wall each way
    assert [each.shares for each in alone] == [
        {"Front": pytest.approx(0.5), "Back": pytest.approx(0.5)},
        {"Left": pytest.approx(0.5), "Right": pytest.approx(0.5)},
    ]


def test_the_worse_path_counts_for_each_mechanism_and_is_stated() -> None:
    """By hand: half of the roof in the middle of the top lowers t/h to (M t/2 + m t/2) / (M h/2 + m h)."""
    found = find_candidates(building(FRONT, BACK, LEFT, RIGHT, roof()))
    weight = TIMBER * 9.0 * 7.0 * 0.3 / 2.0
    for name, length in (("Front", 9.0), ("Left", 6.0)):
        wall = STONE * length * 0.5 * 3.0
        each = turned(found, name)
        assert [load.share for load in each.definition.loads] == [0.5]
        assert each.multiplier == pytest.approx((wall + weight) * 0.25 / (wall * 1.5 + weight * 3.0), rel=1e-3)
        assert "does not tell which walls carry Roof" in str(each.reason)


def test_a_gable_beside_a_party_wall_may_carry_half_of_a_roof_that_statics_put_on_the_eaves() -> None:
    """Purlins that enter a party wall bring half to the one gable; rafters none: by hand the worse is half, at the top.

    Of a front with the roof's edge over its inner half, none is worse: the roof would hold it down.
    """
    inner = part_of("Roof", block((0.0, 8.5), (0.25, 6.75), (3.0, 3.3), density=TIMBER), "floor", density=TIMBER)
    found = find_candidates(building(FRONT, BACK, LEFT, inner))
    weight, wall = TIMBER * 8.5 * 6.5 * 0.3 / 2.0, STONE * 6.0 * 0.5 * 3.0
    left = turned(found, "Left")
    assert [load.share for load in left.definition.loads] == [0.5]
    assert left.multiplier == pytest.approx((wall + weight) * 0.25 / (wall * 1.5 + weight * 3.0), rel=1e-3)
    assert "does not tell which walls carry Roof" in str(left.reason)
    front, wall = turned(found, "Front"), STONE * 9.0 * 0.5 * 3.0
    ways = [(wall * 0.25 + w * 0.375) / (wall * 1.5 + w * 3.0) for w in (0.0, weight)]
    assert front.multiplier == pytest.approx(min(ways), rel=1e-3)
    assert len(front.definition.loads) == ways.index(min(ways))


def test_where_none_is_worse_the_comment_says_that_it_is_no_load() -> None:
    """A floor low on the inner half of a wall holds it, at 0.375 m over 0.8 m: without it the wall has t/h = 0.5/3."""
    floor = part_of("Floor", block((0.25, 8.5), (0.25, 6.75), (0.8, 1.0), density=TIMBER), "floor", density=TIMBER)
    left = turned(find_candidates(building(FRONT, BACK, LEFT, floor)), "Left")
    assert left.multiplier == pytest.approx(0.5 / 3.0, rel=1e-3)
    assert not left.definition.loads
    assert "does not tell whether it carries Floor: without that" in str(left.reason)


def test_where_the_drawing_tells_no_share_is_stated() -> None:
    found = find_candidates(building(FRONT, BACK, LEFT, RIGHT, roof(x=(0.5, 8.5))))
    assert [load.share for load in turned(found, "Front").definition.loads] == [None]
    assert not turned(found, "Left").definition.loads
    assert "does not tell" not in str(turned(found, "Front").reason)


def test_a_floor_of_which_one_seat_is_drawn_is_not_all_on_its_wall() -> None:
    """A floor low on a wall, let in to its inner half, holds it: half of it counts, its other end is not drawn."""
    floor = part_of("Floor", block((0.5, 8.5), (0.25, 6.0), (0.8, 1.0), density=TIMBER), "floor", density=TIMBER)
    structure = building(FRONT, floor)
    whole, half = load_paths(structure.part("Floor"), structure)
    assert (whole.shares, half.shares) == ({"Front": 1.0}, {"Front": 0.5})
    each = next(one for one in find_candidates(structure) if one.kind.startswith("overturning"))
    assert [load.share for load in each.definition.loads] == [0.5]


def test_what_rests_on_something_not_drawn_does_not_press_a_wall_that_bends() -> None:
    found = find_candidates(building(FRONT, roof(y=(0.0, 6.0))))
    assert not [each for each in found if each.kind == "bending"]
    assert "bending" in [gap.kind for gap in found.gaps]
    on_both = find_candidates(building(FRONT, BACK, roof(x=(0.5, 8.5))))
    assert [each.parts for each in on_both if each.kind == "bending"] == [("Front",), ("Back",)]


def test_an_edge_that_would_hold_a_covering_down_carries_nothing() -> None:
    far = replace(BACK, name="Middle", solid=block((0, 9), (1.0, 1.5), (0, 3)))
    structure = building(FRONT, far, roof(y=(0.0, 4.0)))
    (path,) = load_paths(structure.part("Roof"), structure)[:1]
    assert path.shares == {"Front": pytest.approx(0.0), "Middle": pytest.approx(1.0)}


@pytest.mark.parametrize(("density", "tied"), [(100.0, ()), (400.0, ("Roof",))])
def test_a_wall_that_the_thrust_of_its_share_would_push_over_stands_all_the_same(density: float, tied) -> None:
    """At 100 kg/m3 by statics the roof leaves the wall just standing, half of it would not; at 400 neither does."""
    section = [(-3.5, 3.0), (3.5, 3.0), (3.5, 3.2), (0.0, 6.2), (-3.5, 3.2)]
    solid = profile(section, length=9.0, density=density, name="Roof")
    order = [1, 0, 2]
    moved = replace(
        solid, vertices=solid.vertices[:, order] * (-1, 1, 1) + (4.5, 3.5, 0.0),
        centroid=solid.centroid[order] * (-1, 1, 1) + (4.5, 3.5, 0.0), inertia=solid.inertia[np.ix_(order, order)],
    )  # fmt: skip
    roofed = part_of("Roof", moved, "roof", normal=(0, 1), density=density)
    found = find_candidates(building(FRONT, BACK, LEFT, RIGHT, roofed))
    front = turned(found, "Front")
    assert front.found.tied == tied
    assert 0.0 < front.multiplier < (0.05 if not tied else 0.12)
    assert [load.share is None for load in front.definition.loads] == [False]  # its source is asked
    of_front = [each for each in found if "Front" in each.parts and each.kind in ("overturning", "corner")]
    assert {each.kind for each in of_front} == {"overturning", "corner"}
    pushed = {load.tied for each in of_front for load in each.definition.loads}
    assert pushed == {True if tied else None}  # what takes the thrust is there for all mechanisms of the wall


def test_the_worse_path_counts_for_a_corner_by_what_of_its_walls_moves() -> None:
    """By hand: of each wall as much of its share as of its length breaks off at the top."""
    (corner,) = (
        each
        for each in find_candidates(building(FRONT, BACK, LEFT, RIGHT, roof()))
        if each.kind == "corner" and set(each.parts) == {"Front", "Left"}
    )
    length = {"Front": 9.0, "Left": 6.0}
    moves = {
        wall: (3.0 * tan(wedge.angle) + 0.5) / length[wall]
        for wedge in corner.definition.wedges
        for wall in wedge.walls
    }  # fmt: skip
    ways = ({"Front": 0.3, "Left": 0.2}, {"Front": 0.5, "Left": 0.0}, {"Front": 0.0, "Left": 0.5})
    shares = sorted(sum(way[wall] * moves[wall] for wall in moves) for way in ways)
    (load,) = corner.definition.loads
    assert load.share in (pytest.approx(shares[0], abs=1e-3), pytest.approx(shares[-1], abs=1e-3))
    assert "does not tell which walls carry Roof" in str(corner.reason)
