"""Structures read from synthetic houses: every part found, as thick as it was drawn, and none invented."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import assess
from assess.model.structure import Structure
from tests.support.houses import THICKNESS, House, Planted, turned, write_groups, write_ifc, write_merged

CLEAN, DISTORTED = 0.01, 0.02  # of the thickness, and m
NEAR = 0.15  # m: between the centroids of a part as drawn and as read


def read(tmp_path: Path, parts: Sequence[Planted], form: str, *, unit: float = 1.0) -> Structure:
    """Write a house in a format and read it."""
    if form == "ifc":
        pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
        return assess.read_building(write_ifc(tmp_path / "house.ifc", parts, unit=unit))
    write = write_groups if form == "groups" else write_merged
    file = write(tmp_path / ("house.stl" if form == "stl" else "house.obj"), parts, unit=unit)
    return assess.read_building(file, unit=unit)


def faults(parts: Sequence[Planted], structure: Structure, *, noise: float = 0.0) -> Iterator[str]:
    """List what differs between what was drawn and what was read."""
    free = {part.name: part for part in structure.parts}
    for planted in parts:
        away = {name: float(np.linalg.norm(p.solid.centroid - planted.solid.centroid)) for name, p in free.items()}
        name = min(away, key=lambda each: away[each], default=None)
        if name is None or away[name] > NEAR:
            yield f"{planted.name} is lost"
            continue
        found = free.pop(name)
        if found.kind != planted.kind:
            yield f"{planted.name} is a {found.kind}"
        tolerance = DISTORTED if noise else CLEAN * planted.thickness
        if planted.kind != "tower" and abs(found.thickness - planted.thickness) > tolerance:
            yield f"{planted.name} is {found.thickness:.4f} m thick"
    yield from (f"{name} is invented" for name in free)
    yield from (f"{each.name} is left out" for each in structure.left_out)


HOUSES = [
    (House(openings=True), "groups", 1.0, 0.0, 0.0),
    (House(plan="L", storeys=2, overlap=True), "merged", 1.0, 0.4, 0.0),
    (House(plan="court", storeys=2, top="parapets"), "stl", 1e-3, 0.7, 0.0),
    (House(storeys=4, split=False, party=True, gap=0.005), "merged", 1e-3, 1.1, 0.0),
    (House(storeys=2, top="gables", chimney=True, overlap=True), "ifc", 1e-3, 0.3, 0.0),
    (House(tower=True, top="parapets"), "groups", 1.0, 0.2, 0.02),
]


@pytest.mark.parametrize(("house", "form", "unit", "angle", "noise"), HOUSES)
def test_every_part_is_found_and_none_invented(tmp_path, house, form, unit, angle, noise):
    parts = turned(house.parts(), angle=angle, noise=noise)
    assert list(faults(parts, read(tmp_path, parts, form, unit=unit), noise=noise)) == []


def _many() -> Iterator[tuple[House, str, float, float, float]]:
    """Yield 70 houses: each plan, number of storeys and top, with all else turned over from one to the next."""
    forms, units = ("groups", "merged", "stl", "ifc"), (1.0, 1e-3)
    shapes = [
        (plan, storeys, top)
        for plan, storeys, top in product(("rectangle", "L", "court"), (1, 2, 3, 4), ("flat", "parapets", "gables"))
        if top != "gables" or plan == "rectangle"
    ]
    for k in range(70):
        plan, storeys, top = shapes[k % len(shapes)]
        distorted = k % 3 == 2
        house = House(
            plan=plan,
            storeys=storeys,
            top=top,
            split=k % 4 != 3,
            overlap=k % 5 in (1, 3),
            gap=0.005 if distorted and k % 5 not in (1, 3) else 0.0,
            openings=k % 7 != 6,
            party=plan == "rectangle" and k % 2 == 1,
            chimney=top != "parapets" and k % 3 != 1,
            tower=k % 6 == 4,
        )
        form = forms[k % 3] if distorted else forms[k % 4]
        yield house, form, units[k % 2], 0.09 * k, 0.02 if distorted else 0.0


@pytest.mark.study
@pytest.mark.parametrize(("house", "form", "unit", "angle", "noise"), list(_many()))
def test_every_part_of_many_houses_is_found(tmp_path, house, form, unit, angle, noise):
    parts = turned(house.parts(), angle=angle, noise=noise, seed=int(100 * angle))
    assert list(faults(parts, read(tmp_path, parts, form, unit=unit), noise=noise)) == []


def test_party_wall_is_met_from_both_sides_and_façades_face_outwards(tmp_path):
    house = House(party=True, openings=False)
    structure = read(tmp_path, turned(house.parts(), angle=0.5), "groups")
    party = structure.part("wall 4 at 0")
    assert not party.outward
    assert [each.end for each in structure.cross_walls(party.name)] == ["start", "end"]
    for name in (f"wall {k} at 0" for k in range(4)):
        wall = structure.part(name)
        away = np.array(wall.normal) @ (wall.solid.centroid - party.solid.centroid)
        assert wall.outward
        assert away > 0.0
    ends = [each.end for each in structure.cross_walls("wall 0 at 0")]
    assert ends == ["start", "between", "end"]


def test_walls_of_a_courtyard_face_into_it(tmp_path):
    house = House(plan="court", openings=False)
    structure = read(tmp_path, house.parts(), "groups")
    middle = np.array([8.0, 7.0, 0.0])
    for number in range(4, 8):
        wall = structure.part(f"wall {number} at 0")
        assert wall.outward
        assert np.array(wall.normal) @ (middle - wall.solid.centroid) > 0.0


def test_floors_bear_as_deep_as_they_are_built_in(tmp_path):
    structure = read(tmp_path, House(openings=False, storeys=2).parts(), "groups")
    (floor,) = structure.bearing_on("wall 0 at 0")
    contact = next(each for each in structure.contacts_of(floor.name) if each.second == "wall 0 at 0")
    assert contact.relation == "bears-on"
    assert contact.area == pytest.approx(0.15 * (9.0 - 0.85), rel=0.02)  # butts on another wall at its start
    assert contact.elevation == pytest.approx(3.2 - 0.25)
    assert abs(contact.eccentricity) == pytest.approx(THICKNESS / 2.0 - 0.075)
    assert [part.name for part in structure.stack_of("wall 0 at 3.2")] == ["wall 0 at 0", "wall 0 at 3.2"]


def test_corners_drawn_twice_count_once(tmp_path):
    house = House(overlap=True, openings=False)
    walls = [part for part in house.parts() if part.kind == "wall"]
    structure = read(tmp_path, walls, "merged")
    density = structure.parts[0].density
    ring = (9.0 * 7.0 - 8.0 * 6.0) * 3.2
    assert structure.mass == pytest.approx(ring * density)
    assert sum(part.shared for part in structure.parts) == pytest.approx(4 * 0.5 * 0.5 * 3.2)
    assert {each.relation for each in structure.contacts} == {"leans-on"}
    assert len(structure.contacts) == 4


def test_openings_are_measured_along_the_wall(tmp_path):
    structure = read(tmp_path, turned(House().parts(), angle=0.8), "merged")
    doors = [part.openings[0] for part in structure.walls if part.openings[0].base == pytest.approx(0.0, abs=1e-6)]
    assert len(structure.walls) == 4
    assert len(doors) == 2
    assert [each.right - each.left for each in doors] == pytest.approx([1.2, 1.2])
    assert [each.top for each in doors] == pytest.approx([2.2, 2.2])


@pytest.mark.parametrize("named", [True, False])
@pytest.mark.parametrize("tower", [True, False])
def test_a_model_on_its_side_is_asked_about_its_axis(tmp_path, named, tower) -> None:
    """A house drawn with z up, and read with y up: by what its parts are called, or by floors thicker than walls."""
    house = House(storeys=2, chimney=True, tower=tower).parts()
    parts = house if named else [replace(part, name=f"body {number}") for number, part in enumerate(house)]
    file = write_groups(tmp_path / "house.obj", parts)
    keys = ("lying-by-names", "lying-by-thickness")
    upright = [each.key for each in assess.read_building(file).warnings if each.key in keys]
    lying = [each.key for each in assess.read_building(file, up="y").warnings if each.key in keys]
    assert (upright, lying) == ([], [keys[0] if named else keys[1]])
