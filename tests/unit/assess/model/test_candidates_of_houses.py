"""Mechanisms found on synthetic houses read from files."""

import pytest

import assess
from tests.support.houses import House, turned, write_groups


@pytest.mark.parametrize("angle", [0.0, 0.5236])
def test_a_wall_does_not_take_the_gable_beside_it_along(tmp_path, angle) -> None:
    """A gable also stands on the ends of the walls beside it; with it a wall had 2.9 times its multiplier."""
    house = House(storeys=2, split=False, top="gables", openings=False)
    structure = assess.read_building(write_groups(tmp_path / "house.obj", turned(house.parts(), angle=angle)))
    found = structure.mechanisms()
    moved = [each.parts for each in found if each.kind.startswith("overturning")]
    gables = {part.name: part for part in structure.of_kind("gable")}
    for parts in moved:
        normals = {tuple(round(abs(x), 3) for x in structure.part(name).normal) for name in parts}
        assert len(normals) == 1 or not gables.keys() & set(parts)
    eaves = [each for each in found if each.kind.startswith("overturning") and "0 at 0" in each.parts[0]]
    assert min(each.multiplier for each in eaves) < 0.12  # of a wall of 0.5 by 6.4 m under floors
    assert len([parts for parts in moved if parts[0] in gables]) in (0, len(gables))  # both alike


def test_a_wall_at_a_re_entrant_corner_is_listed_where_another_stops_it(tmp_path) -> None:
    """It bends between floors; what of it is not beside the wall that stops it may turn all the same."""
    structure = assess.read_building(write_groups(tmp_path / "house.obj", House(plan="L", storeys=2).parts()))
    found = structure.mechanisms()
    turned = {name for each in found if each.kind.startswith("overturning") for name in each.parts}
    missing = {part.name for part in structure.walls} - turned
    assert missing == {"wall 2 at 0", "wall 2 at 3.2"}
    assert any(each.kind == "bending" and each.parts[0] in missing for each in found)
    gaps = {gap.kind: gap for gap in found.gaps}
    assert set(gaps) == {"overturning", "overturning-of-storeys", "wedges"}
    assert "wall 3 at 0, wall 3 at 3.2 would stop it" in str(gaps["overturning-of-storeys"])
    stated = {each.name for each in found if each.definition is not None}
    assert found.open_entries("house", stated=stated)["simple-overturning"].gaps


def test_a_wall_between_two_rooms_rocks_both_ways_and_a_facade_one(tmp_path) -> None:
    house = House(storeys=2, split=False, party=True)
    found = assess.read_building(write_groups(tmp_path / "house.obj", house.parts())).mechanisms()
    sides = {(each.parts[0], each.kind): each.definition.sides for each in found if each.definition is not None}
    assert sides["wall 4 at 0", "overturning-of-storeys"] == sides["wall 4 at 0", "bending"] == "two"
    assert sides["wall 0 at 0", "overturning-of-storeys"] == sides["wall 0 at 0", "bending"] == "one"
