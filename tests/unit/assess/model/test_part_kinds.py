"""Each kind of part in a model in which it is found and in one, nearly the same, in which it must not be."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest

import assess
from assess.geometry.boolean import unite
from assess.geometry.formats.mesh_file import Element
from assess.geometry.solid import Solid, polyhedron
from assess.model.part_kinds import masonry_layers, reason_to_leave_out
from assess.model.part_shapes import shape_of
from assess.model.structure import Structure
from tests.support.houses import (
    House,
    Planted,
    bent_wall,
    extrude,
    prism,
    pyramid,
    turned,
    vault,
    write_groups,
    write_ifc,
    write_merged,
)

WALL = prism((-4.0, 2.3, 4.0, 2.9), 0.0, 4.0)
OPPOSITE = prism((-4.0, -2.9, 4.0, -2.3), 0.0, 4.0)
PIERS = {"east": prism((-0.3, 2.3, 0.3, 2.9), 0.0, 4.0), "west": prism((-0.3, -2.9, 0.3, -2.3), 0.0, 4.0)}
GAP = {"left": prism((0, 0, 3, 0.6), 0, 4), "right": prism((5, 0, 8, 0.6), 0, 4)}
BELOW = {"lower": WALL, "opposite": OPPOSITE}
RING = [part.solid for part in House(overlap=True, storeys=2, split=False, openings=False).parts()[:4]]


def planted(solids: Mapping[str, Solid]) -> list[Planted]:
    return [Planted(name, "", 0.0, solid) for name, solid in solids.items()]


def read(tmp_path: Path, solids: Mapping[str, Solid], *, angle: float = 0.3) -> Structure:
    return assess.read_building(write_groups(tmp_path / "model.obj", turned(planted(solids), angle=angle)))


def triangle(rise: float, *, knee: float = 0.0) -> Solid:
    """Return a wall with a pitched top across the street, over the walls below."""
    outline = [(-2.9, 0.0), (2.9, 0.0), (2.9, knee), (0.0, knee + rise), (-2.9, knee)]
    return extrude([*outline[:2], *outline[3:4]] if knee == 0.0 else outline, -4.0, -3.4, 4.0)


FLOOR = prism((-4.0, -2.6, 4.0, 2.6), 3.75, 0.25)
SLOPE = extrude([(-3.0, 0.0), (0.0, 2.0), (0.0, 2.2), (-3.0, 0.2)], -4.0, 4.0, 4.0)
FOUND: list[tuple[str, str, Mapping[str, Solid]]] = [
    ("wall", "it", {"it": WALL}),
    ("gable", "it", {**BELOW, "side": prism((-4.0, -2.3, -3.4, 2.3), 0.0, 4.0), "it": triangle(2.0)}),
    ("parapet", "it", {**BELOW, "floor": FLOOR, "it": prism((-4.0, 2.6, 4.0, 2.9), 4.0, 0.9)}),
    ("pier", "it", {"it": PIERS["east"], "floor": prism((-1.0, 1.6, 1.0, 3.6), 4.0, 0.3)}),
    ("spandrel", "it", {**GAP, "it": prism((3, 0, 5, 0.6), 2.6, 1.4)}),
    ("floor", "it", {**BELOW, "it": FLOOR}),
    ("roof", "it", {**BELOW, "it": SLOPE}),
    ("vault", "it", {**BELOW, "it": vault(2.5, 0.3, length=8.0, base=4.0)}),
    ("arch", "it", {**PIERS, "it": vault(2.5, 0.3, length=0.6, base=4.0)}),
    ("tower", "it", {"it": prism((0.0, 0.0, 4.0, 4.0), 0.0, 15.0)}),
    ("chimney", "it", {**BELOW, "it": prism((1.0, 2.35, 1.6, 2.85), 4.0, 1.6)}),
    ("pinnacle", "it", {**BELOW, "it": pyramid((1.0, 2.35, 1.5, 2.85), 4.0, 1.5)}),
    ("pinnacle", "it", {**BELOW, "it": pyramid((-2.4, -2.4, 2.4, 2.4), 4.0, 6.0)}),  # a spire on the rims of two walls
    ("tie", "it", {**BELOW, "it": prism((0.0, -2.9, 0.03, 2.9), 3.5, 0.03)}),
]  # fmt: skip
ABSENT: list[tuple[str, str, Mapping[str, Solid]]] = [
    ("wall", "a pile as wide as it is long", {"it": prism((0.0, 0.0, 3.0, 3.0), 0.0, 2.5)}),
    ("wall", "a sheet too thin for masonry", {"lower": WALL, "it": prism((0.0, 0.0, 4.0, 0.02), 0.0, 3.0)}),
    ("gable", "a wall with a level top", {**BELOW, "it": prism((-4.0, -2.9, -3.4, 2.9), 4.0, 2.0)}),
    ("gable", "a whole storey under a low pitch", {**BELOW, "it": triangle(1.0, knee=3.0)}),
    ("parapet", "a wall of a whole storey", {**BELOW, "it": prism((-4.0, 2.6, 4.0, 2.9), 4.0, 2.8)}),
    ("parapet", "a low wall on the ground", {"lower": WALL, "it": prism((-4.0, 5.0, 4.0, 5.3), 0.0, 0.9)}),
    ("parapet", "a knee wall under a roof", {
        **BELOW, "knee": prism((-4.0, 2.3, 4.0, 2.9), 4.0, 0.9), "other": prism((-4.0, -2.9, 4.0, -2.3), 4.0, 0.9),
        "roof": prism((-4.0, -2.9, 4.0, 2.9), 4.9, 0.2),
    }),
    ("pier", "a wall three times as long as thick", {"it": prism((0.0, 0.0, 1.8, 0.6), 0.0, 4.0)}),
    ("spandrel", "a panel on the ground between two", {**GAP, "it": prism((3, 0, 5, 0.6), 0.0, 1.4)}),
    ("floor", "a beam", {**BELOW, "it": prism((0.0, -2.6, 0.3, 2.6), 3.7, 0.3)}),
    ("roof", "a flight of stairs under a floor", {
        **BELOW, "floor": FLOOR, "it": extrude([(-2.0, 0.0), (1.5, 3.5), (1.5, 3.75), (-2.0, 0.25)], -1.0, 0.2, 0.0),
    }),
    ("vault", "a roof of two slopes", {
        **BELOW, "one": SLOPE, "other": extrude([(3.0, 0.0), (0.0, 2.0), (0.0, 2.2), (3.0, 0.2)], -4.0, 4.0, 4.0),
    }),
    ("arch", "a wall with a door", {"it": House().parts()[0].solid}),
    ("tower", "a pier", {"it": PIERS["east"]}),
    ("chimney", "a pier of the upper storey, which carries a roof", {
        **BELOW, "it": prism((1.0, 2.35, 1.6, 2.85), 4.0, 1.6), "roof": prism((-4.0, -2.9, 4.0, 2.9), 5.6, 0.2),
    }),
    ("pinnacle", "a stack that does not taper", {**BELOW, "it": prism((1.0, 2.35, 1.6, 2.85), 4.0, 1.6)}),
    ("tie", "a beam", {**BELOW, "it": prism((0.0, -2.9, 0.25, 2.9), 3.5, 0.25)}),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "name", "solids"), FOUND, ids=[kind for kind, _, _ in FOUND])
def test_kind_is_found(tmp_path, kind, name, solids):
    assert read(tmp_path, solids).part(name).kind == kind


@pytest.mark.parametrize(("kind", "what", "solids"), ABSENT, ids=[f"{what} is no {kind}" for kind, what, _ in ABSENT])
def test_kind_is_not_invented(tmp_path, kind, what, solids):
    structure = read(tmp_path, {**solids, "far": prism((20.0, 20.0, 28.0, 20.6), 0.0, 4.0)})
    assert kind not in {part.kind for part in structure.parts if part.name not in ("far", *BELOW)}


def united(solids: Sequence[Solid]) -> Planted:
    """Return several bodies as one closed surface."""
    vertices, triangles = unite([(solid.vertices, solid.triangles) for solid in solids], where="house")
    return Planted("house", "", 0.0, polyhedron(vertices, triangles, density=1.0, name="house"))


def test_one_body_of_four_walls_is_split_into_four(tmp_path):
    structure = assess.read_building(write_merged(tmp_path / "house.obj", turned([united(RING)], angle=0.3)))
    assert [part.kind for part in structure.parts] == ["wall"] * 4
    assert [part.thickness for part in structure.parts] == pytest.approx([0.5] * 4, rel=0.01)
    assert sum(part.volume for part in structure.parts) == pytest.approx((9.0 * 7.0 - 8.0 * 6.0) * 6.4, rel=0.01)
    assert all(part.outward and not part.whole for part in structure.parts)
    assert {each.relation for each in structure.contacts} == {"bonded-to"}
    assert "split-body" in [each.key for each in structure.warnings]


def test_floors_are_found_in_a_house_of_one_body(tmp_path):
    house = House(overlap=True, storeys=2, split=False, openings=False)
    structure = assess.read_building(
        write_merged(tmp_path / "house.stl", [united([each.solid for each in house.parts()])])
    )
    assert [part.kind for part in structure.parts] == ["wall"] * 4 + ["floor"] * 2
    assert [part.thickness for part in structure.parts] == pytest.approx([0.5] * 4 + [0.25] * 2, rel=0.01)


@pytest.mark.parametrize("radius", [3.0, 4.0])
def test_wall_that_bends_is_one_wall(tmp_path, radius):
    structure = read(
        tmp_path,
        {"apse": bent_wall(radius, 0.6, height=6.0), "nave": prism((-radius, -8.0, 0.6 - radius, 0.0), 0.0, 6.0)},
        angle=0.0,
    )
    apse = structure.part("apse")
    assert apse.kind == "wall"
    assert apse.thickness == pytest.approx(
        2.0 * apse.volume / (np.pi * (2.0 * radius - 0.6) * 6.0 + 2 * 0.6 * 6.0), rel=0.01
    )
    assert apse.normal == pytest.approx((0.0, 1.0, 0.0), abs=1e-6)


def test_ring_of_facets_is_a_tower_and_no_wall(tmp_path):
    halves = [
        bent_wall(3.0, 0.8, height=5.0),
        turned(planted({"": bent_wall(3.0, 0.8, height=5.0)}), angle=np.pi)[0].solid,
    ]
    structure = assess.read_building(write_merged(tmp_path / "ring.obj", [united(halves)]))
    assert [part.kind for part in structure.parts] == ["tower"]


def test_ifc_is_read_by_class_and_what_is_no_masonry_is_listed(tmp_path):
    pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    things = {
        "IfcFurniture": prism((2.0, 2.0, 3.0, 3.0), 0.0, 0.8),
        "IfcWindow": prism((4.0, 0.2, 5.2, 0.25), 1.0, 1.4),
        "IfcCovering": prism((0.5, 0.5, 8.5, 0.52), 0.0, 3.0),
        "IfcStair": prism((6.0, 2.0, 7.0, 5.0), 0.0, 2.0),
        "IfcFooting": prism((-0.5, -0.5, 9.5, 1.0), -1.0, 1.0),
        "IfcBeam": prism((0.3, 3.0, 8.7, 3.25), 2.7, 0.25),
    }
    extra = [(kind, Planted(f"thing {kind}", "", 0.0, solid)) for kind, solid in things.items()]
    extra.append(("IfcColumn", Planted("column", "", 0.0, prism((4.2, 3.3, 4.7, 3.8), 0.0, 2.95))))
    structure = assess.read_building(write_ifc(tmp_path / "house.ifc", House(openings=False).parts(), extra=extra))
    assert sorted(each.name for each in structure.left_out) == sorted(f"thing {kind}" for kind in things)
    assert [part.kind for part in structure.parts] == ["wall"] * 4 + ["pier", "floor"]
    furniture = next(each for each in structure.left_out if each.name == "thing IfcFurniture")
    assert furniture.reason.key == "left-out-furniture"
    assert furniture.volume == pytest.approx(0.8)
    assert furniture.size == pytest.approx((1.0, 1.0, 0.8))
    wall = structure.part("wall 0 at 0")
    assert wall.source.startswith("IfcWall ")
    assert wall.element == wall.source.split()[1]
    assert wall.storey == "level 0"
    assert ("level 0", 0.0) in [(storey.name, storey.elevation) for storey in structure.storeys]


STUDS = (("Plasterboard", 0.0125), ("Metal - Stud Layer", 0.07), ("Plasterboard", 0.0125))
CAVITY = (("Brick, Common", 0.102), ("Air Layer - Unspecified", 0.05), ("Concrete Block", 0.1), ("Plaster", 0.012))


@pytest.mark.parametrize(
    ("layers", "reason", "masonry"),
    [
        (STUDS, "left-out-material", []),
        ((("Intonaco", 0.02),), "left-out-finish", []),
        (CAVITY, None, ["Brick, Common", "Concrete Block"]),
        ((("", None),), None, [""]),
        ((), None, []),
    ],
)
def test_layers_of_an_element_tell_whether_it_is_masonry(layers, reason, masonry):
    element = Element(kinds=("IfcWallStandardCase", "IfcWall"), layers=layers)
    found = reason_to_leave_out(element, shape_of(WALL))
    assert (None if found is None else found.key) == reason
    assert [name for name, _ in masonry_layers(element)] == masonry


def test_ifc_states_layers_densities_and_storeys(tmp_path):
    ifcopenshell = pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    import ifcopenshell.api.material as material
    import ifcopenshell.api.pset as pset

    file = write_ifc(tmp_path / "house.ifc", House(openings=False).parts(), unit=1e-3)
    model = ifcopenshell.open(str(file))
    stone, plaster = (material.add_material(model, name=name) for name in ("Stone", "Plaster"))
    pset.edit_pset(
        model, pset=pset.add_pset(model, stone, name="Pset_MaterialCommon"), properties={"MassDensity": 2250.0}
    )
    build = material.add_material_set(model, name="wall", set_type="IfcMaterialLayerSet")
    for each, thickness in ((stone, 480.0), (plaster, 20.0)):
        layer = material.add_layer(model, layer_set=build, material=each)
        material.edit_layer(model, layer=layer, attributes={"LayerThickness": thickness})
    material.assign_material(model, products=model.by_type("IfcWall"), type="IfcMaterialLayerSet", material=build)
    model.write(str(file))
    structure = assess.read_building(file)
    wall, floor = structure.part("wall 0 at 0"), structure.of_kind("floor")[0]
    assert (wall.material, wall.density, wall.density_stated) == ("Stone", 2250.0, True)
    assert not floor.density_stated
    assert [each.key for each in structure.warnings] == ["layers-of-finish", "density-assumed"]
    assert assess.read_building(file, density={"Stone": 2000.0}).part("wall 0 at 0").density == 2000.0


def test_names_of_meshes_tell_what_is_no_masonry(tmp_path):
    things = {
        "Plaster north": prism((-4.0, 2.9, 4.0, 2.93), 0.0, 4.0),
        "Intonaco": prism((-4.0, 2.9, 4.0, 2.98), 0.0, 4.0),
        "Tavolo": prism((0.0, 0.0, 1.0, 2.0), 0.0, 0.8),
        "Terrain": prism((-20.0, -20.0, 20.0, 20.0), -0.5, 0.5),
        "Model Text:600mm Arial:352582": prism((14.0, 0.0, 14.2, 2.0), 0.0, 1.0),
        "Stone pile": prism((10.0, 0.0, 12.0, 2.0), 0.0, 2.0),
    }
    structure = read(tmp_path, {**BELOW, "Window wall": prism((-4.0, -2.3, -3.4, 2.3), 0.0, 4.0), **things})
    assert sorted(part.name for part in structure.parts) == ["Window wall", "lower", "opposite"]
    assert sorted(each.name for each in structure.left_out) == sorted(things)


def test_open_surface_is_left_out_and_the_rest_is_read(tmp_path):
    parts = turned(planted(BELOW), angle=0.0)
    file = write_groups(tmp_path / "model.obj", parts)
    sheet = "\n".join(["o sheet", "v 0 0 0", "v 5 0 0", "v 5 0 3", "v 0 0 3", "f -4 -3 -2", "f -4 -2 -1", ""])
    file.write_text(file.read_text() + sheet)
    structure = assess.read_building(file)
    assert [part.name for part in structure.parts] == ["lower", "opposite"]
    (left,) = structure.left_out
    assert (left.name, left.reason.key) == ("sheet", "left-out-not-closed")
    assert left.size == pytest.approx((5.0, 0.0, 3.0))


def test_files_of_one_building_are_read_together(tmp_path):
    files = [write_groups(tmp_path / f"{name}.obj", planted({name: solid})) for name, solid in BELOW.items()]
    structure = assess.read_building(*files, density=2100.0)
    assert [part.file for part in structure.parts] == ["lower.obj", "opposite.obj"]
    assert [part.mass for part in structure.parts] == pytest.approx([8.0 * 0.6 * 4.0 * 2100.0] * 2)
    assert structure.warnings == ()


def test_wall_drawn_twice_counts_once(tmp_path):
    structure = read(tmp_path, {"it": WALL, "again": WALL})
    assert [part.name for part in structure.parts] == ["it"]
    assert [each.reason.key for each in structure.left_out] == ["left-out-twice"]


@pytest.mark.parametrize(
    ("call", "told"),
    [
        ({}, "nothing in it is read as masonry"),
        ({"up": "x"}, 'up = .x.: write "y" or "z"'),
        ({"density": -1.0}, "density = -1.0: give a positive number"),
    ],
)
def test_errors_say_what_to_do(tmp_path: Path, call, told):
    file = write_groups(tmp_path / "model.obj", planted({"chair": prism((0.0, 0.0, 1.0, 1.0), 0.0, 1.0)}))
    with pytest.raises(assess.errors.GeometryError, match=told):
        assess.read_building(file, **call)
    with pytest.raises(assess.errors.GeometryError, match="give the paths"):
        assess.read_building()
