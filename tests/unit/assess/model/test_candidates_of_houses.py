"""Mechanisms found on synthetic houses read from files."""

import pytest

import assess
from assess.model.candidates import CLASSES, find_candidates, texts_of
from assess.model.structure import Structure
from tests.support.buildings import block, part_of, touching
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
    assert set(gaps) == {"overturning", "overturning-of-storeys", "wedges", "bay"}
    assert "wall 3 at 0, wall 3 at 3.2 would stop it" in str(gaps["overturning-of-storeys"])
    stated = {each.name for each in found if each.definition is not None}
    assert found.open_entries("house", stated=stated)["simple-overturning"].gaps


@pytest.mark.parametrize(
    "house",
    [
        House(storeys=2, openings=False),
        House(storeys=2, split=False, party=True),
        House(plan="L", top="gables"),
        House(plan="court", overlap=True, top="parapets"),
        House(tower=True, chimney=True),
    ],
    ids=["plain", "party wall", "L", "court", "tower"],
)
def test_no_class_passes_over_a_wall_in_silence(tmp_path, house) -> None:
    """Of each class that walls can have, each wall is found, possible and not looked for, or ruled out."""
    structure = assess.read_building(write_groups(tmp_path / "house.obj", house.parts()))
    found = structure.mechanisms()
    said = {
        (entry, name)
        for each in found
        for entry in each.examines.values()
        for name in each.parts
    }  # fmt: skip
    entries = {row.key: row.examines.get("house") for row in CLASSES}
    said |= {(entries[gap.kind], gap.part) for gap in (*found.gaps, *found.ruled_out)}
    for wall in structure.walls:
        stack = [part.name for part in structure.stack_of(wall.name)]
        for entry in ("simple-overturning", "compound-overturning", "corner"):
            assert any((entry, name) in said for name in stack), (entry, wall.name)
        for entry in ("vertical-bending", "horizontal-bending"):
            assert (entry, wall.name) in said, (entry, wall.name)


def test_a_front_between_the_corners_of_a_house_has_no_arch_that_is_examined(tmp_path) -> None:
    """Nothing lies beyond its ends to thrust against: the entry stays open, and says why."""
    found = assess.read_building(write_groups(tmp_path / "house.obj", House(party=True).parts())).mechanisms()
    assert not [each for each in found if each.kind == "bay"]
    entry = found.open_entries("house", stated={each.name for each in found})["horizontal-bending"]
    assert {gap.part for gap in entry.gaps} == {f"wall {number} at 0" for number in range(5)}
    (text,) = texts_of(entry.gaps)
    assert text.startswith("horizontal arch between cross walls: wall 0 at 0, ")
    assert "no masonry of the wall lies beyond" in text


def test_nothing_moves_into_a_tower() -> None:
    """A bay and a wall between floors bulge away from the tower that stands against them, or not at all."""
    facade = part_of("Facade", block((0, 0.5), (0, 16), (0, 3)), normal=(-1, 0), outward=True)
    cross = [part_of(f"Cross {y}", block((0.5, 5), (y, y + 0.5), (0, 3)), normal=(0, 1)) for y in (4.0, 11.5)]
    roof = part_of("Roof", block((0, 5), (0, 16), (3, 3.2)), "roof", normal=(0, 1), density=400.0)
    parts = (facade, *cross, roof)
    alone = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    assert {"bay", "bending"} <= {each.kind for each in alone if each.parts[0] == "Facade"}
    tower = part_of("Tower", block((-4, 0), (6, 10), (0, 12)), "tower", normal=(-1, 0))
    beside = find_candidates(Structure(parts=(*parts, tower), contacts=touching((*parts, tower))))
    assert not [each.kind for each in beside if each.kind in ("bay", "bending") and each.parts[0] == "Facade"]
    assert {"bay", "bending"} <= {gap.kind for gap in beside.gaps if gap.part == "Facade" and "Tower" in str(gap)}


def test_a_wall_between_two_rooms_rocks_both_ways_and_a_facade_one(tmp_path) -> None:
    house = House(storeys=2, split=False, party=True)
    found = assess.read_building(write_groups(tmp_path / "house.obj", house.parts())).mechanisms()
    sides = {(each.parts[0], each.kind): each.definition.sides for each in found if each.definition is not None}
    assert sides["wall 4 at 0", "overturning-of-storeys"] == sides["wall 4 at 0", "bending"] == "two"
    assert sides["wall 0 at 0", "overturning-of-storeys"] == sides["wall 0 at 0", "bending"] == "one"
