"""IFC files made with ifcopenshell."""

import os
import re
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from assess.errors import GeometryError
from assess.geometry.formats import ifc
from assess.geometry.formats.ifc import refuse_commas
from assess.geometry.formats.isolation import call_in_subprocess
from assess.geometry.mesh import inventory, load_solid, read_selected_meshes

ifcopenshell: Any = pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")


def building(file: Path, *, prefix: str | None) -> dict[str, str]:
    """Two walls, one with a door, and a space; returns the GlobalId of each by name."""
    import ifcopenshell.api.context as context
    import ifcopenshell.api.feature as feature
    import ifcopenshell.api.project as project
    import ifcopenshell.api.root as root
    import ifcopenshell.api.unit as unit

    model = project.create_file()
    root.create_entity(model, ifc_class="IfcProject", name="house")
    unit.assign_unit(model, units=[unit.add_si_unit(model, unit_type="LENGTHUNIT", prefix=prefix)])
    whole = context.add_context(model, context_type="Model")
    body = context.add_context(
        model, context_type="Model", context_identifier="Body", target_view="MODEL_VIEW", parent=whole
    )
    north = element(model, body, "IfcWall", "north", at=(0, 0, 0), size=(3.0, 1.25, 8.0))
    south = element(model, body, "IfcWall", "south", at=(0, 20, 0), size=(4.0, 1.25, 8.0))
    element(model, body, "IfcSpace", "hall", at=(0, 2, 0), size=(4.0, 10.0, 8.0))
    door = element(model, body, "IfcOpeningElement", "door", at=(1, 0, 0), size=(1.0, 1.25, 2.0))
    feature.add_feature(model, feature=door, element=north)
    model.write(str(file))
    return {"north": north.GlobalId, "south": south.GlobalId}


def element(model: Any, body: Any, kind: str, name: str, *, at: tuple[float, ...], size: tuple[float, ...]) -> Any:
    import ifcopenshell.api.geometry as geometry
    import ifcopenshell.api.root as root

    made = root.create_entity(model, ifc_class=kind, name=name)
    place = np.eye(4)
    place[:3, 3] = at
    geometry.edit_object_placement(model, product=made, matrix=place)
    length, thickness, height = size
    shape = geometry.add_wall_representation(model, context=body, length=length, height=height, thickness=thickness)
    geometry.assign_representation(model, product=made, representation=shape)
    return made


@pytest.mark.parametrize("prefix", ["MILLI", None])
def test_elements_are_chosen_by_name_or_identifier_in_metres(tmp_path: Path, prefix: str | None) -> None:
    file = tmp_path / "house.ifc"
    identifiers = building(file, prefix=prefix)
    south, north = 4.0 * 1.25 * 8.0, 3.0 * 1.25 * 8.0 - 1.0 * 1.25 * 2.0
    for name, volume in ((None, south + north), ("south", south), ("north", north), (identifiers["north"], north)):
        found = load_solid(file, density=1.0, name="wall", element=name)
        assert found.mass == pytest.approx(volume, rel=1e-9)
        assert found.history == ()
    assert load_solid(file, density=1.0, name="wall", element="south").vertices[:, 1].min() == pytest.approx(
        20.0, rel=1e-9
    )
    with pytest.raises(GeometryError, match='it has no element "hall"; known: north, south'):
        load_solid(file, density=1.0, name="wall", element="hall")


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("(0.,1.25),(3.,1.25)", "(0.,1,25),(3.,1.25)", "a point has 3 values where it has 2; decimals take a point"),
        ("IFCCARTESIANPOINT((0.,20.,0.))", "IFCCARTESIANPOINT((0.,20,5,0.))", "a point has 4 values where it has 3"),
        ("IFCCARTESIANPOINT((0.,20.,0.))", "IFCCARTESIANPOINT((0.,20,,0.))", "a point has 4 values where it has 3"),
        (",8.);", ",8,5);", "an IFCEXTRUDEDAREASOLID has 5 values where it has 4"),
    ],
)
def test_decimal_commas_in_an_ifc_file_are_told(tmp_path: Path, old: str, new: str, told: str) -> None:
    building(tmp_path / "house.ifc", prefix=None)
    content = (tmp_path / "house.ifc").read_text()
    assert old in content
    (tmp_path / "comma.ifc").write_text(content.replace(old, new, 1))
    with pytest.raises(GeometryError, match=told):
        load_solid(tmp_path / "comma.ifc", density=1.0, name="wall")


def test_a_single_point_without_decimal_point_is_refused_and_a_habit_is_not(tmp_path: Path) -> None:
    file = tmp_path / "points.ifc"
    good, cut, whole = (f"#1=IFCCARTESIANPOINT(({each}));\n" for each in ("1.25,0.,3.E-1", "1,25,0.", "0,0.,1.5"))
    file.write_text(good * 200 + cut)
    with pytest.raises(ValueError, match=r"of the point \(1,25,0.\) a number has no decimal point, as all others have"):
        refuse_commas(file, lambda _: None)
    file.write_text(good * 20 + whole * 10 + "#2=IFCPERSON('a,b(;','IFCCARTESIANPOINT((1,2,3,4))');\n")
    refuse_commas(file, lambda _: None)


@pytest.mark.parametrize("ratios", ["0.,0.,0.", "0,0", "0.,-0.0E+00, 0."])
def test_a_direction_without_length_is_refused(tmp_path: Path, ratios: str) -> None:
    """Of an opening it makes no shape, and the wall would be read without its door."""
    building(tmp_path / "house.ifc", prefix=None)
    content = (tmp_path / "house.ifc").read_text()
    for place in re.finditer(r"(?<=IFCDIRECTION\(\()[^()]*", content):
        (tmp_path / "flat.ifc").write_text(content[: place.start()] + ratios + content[place.end() :])
        with pytest.raises(GeometryError, match=rf"the direction \({ratios[:3]}.*\) in it has no length"):
            load_solid(tmp_path / "flat.ifc", density=1.0, name="wall")


@pytest.mark.parametrize("name", ["IFC" + "9" * 400, "IFC9", ""])
def test_an_unknown_schema_is_refused_however_long_its_name(tmp_path: Path, name: str) -> None:
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    file.write_text(file.read_text().replace("'IFC4'", f"'{name}'", 1))
    with pytest.raises(GeometryError, match="schema"):
        load_solid(file, density=1.0, name="wall", element="south")


@pytest.mark.parametrize("kind", ["CARTESIANPOINT", "DIRECTION"])
@pytest.mark.parametrize("value", ["nan", "inf", "o"])
def test_what_is_no_number_is_refused(tmp_path: Path, kind: str, value: str) -> None:
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    file.write_text(re.sub(rf"(IFC{kind}\(\()[^,)]*", rf"\g<1>{value}", file.read_text(), count=1))
    with pytest.raises(GeometryError, match=rf"\({re.escape(value)},.* in it are not numbers"):
        load_solid(file, density=1.0, name="wall", element="south")


@pytest.mark.parametrize(
    ("kind", "lost"),
    [
        ("IfcWall", r"(=IFCWALL\(.*,)#\d+(,[^,#]*,[^,#]*\);)"),
        ("IfcProductDefinitionShape", r"(=IFCPRODUCTDEFINITIONSHAPE\(.*\()#\d+(\)\);)"),
        ("IfcShapeRepresentation", r"(=IFCSHAPEREPRESENTATION\(.*\()#\d+(\)\);)"),
        ("IfcRelVoidsElement", r"(=IFCRELVOIDSELEMENT\(.*,)#\d+(,#\d+\);)"),
        ("IfcRelVoidsElement", r"(=IFCRELVOIDSELEMENT\(.*,#\d+,)#\d+(\);)"),
    ],
)
def test_what_takes_an_element_or_an_opening_with_it_is_refused(tmp_path: Path, kind: str, lost: str) -> None:
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    text, found = re.subn(lost, r"\g<1>#99999\g<2>", file.read_text(), count=1)
    assert found == 1
    file.write_text(text)
    with pytest.raises(GeometryError, match=rf"{kind} #\d+ refers to an entity that is not in it"):
        load_solid(file, density=1.0, name="wall", element="south")


@pytest.mark.parametrize("part", [0.0, 0.3, 0.6, 0.99])
def test_an_ifc_file_cut_short_is_refused(tmp_path: Path, part: float) -> None:
    building(tmp_path / "house.ifc", prefix=None)
    content = (tmp_path / "house.ifc").read_bytes()
    (tmp_path / "short.ifc").write_bytes(content[: int(part * len(content))])
    with pytest.raises(GeometryError, match=r'body "wall": mesh short.ifc: it cannot be read as IFC .it does not end'):
        load_solid(tmp_path / "short.ifc", density=1.0, name="wall")


@pytest.mark.parametrize("lost", ["((0.,0.,0.));", "(0.,0.,0.);", "($);"])
def test_an_entity_without_its_name_is_refused(tmp_path: Path, lost: str) -> None:
    """A point that has lost its name has crashed ifcopenshell."""
    building(tmp_path / "house.ifc", prefix=None)
    content = (tmp_path / "house.ifc").read_text()
    (tmp_path / "lost.ifc").write_text(re.sub(r"=IFCCARTESIANPOINT\(\([^;]*;", f"={lost}", content, count=1))
    with pytest.raises(GeometryError, match=r"#\d+ has no name of an entity in it"):
        load_solid(tmp_path / "lost.ifc", density=1.0, name="wall")


def test_a_number_that_stands_twice_is_refused(tmp_path: Path) -> None:
    """The same entity under the number of one that it is made of has crashed ifcopenshell."""
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    text = file.read_text()
    first, second = re.findall(r"^#(\d+)=IFCINDEXEDPOLYCURVE", text, re.MULTILINE)[:2]
    file.write_text(text.replace(f"#{first}=", f"#{second}=", 1))
    with pytest.raises(GeometryError, match=f"#{second} is defined twice"):
        load_solid(file, density=1.0, name="wall")


def test_text_that_only_ends_like_one_is_refused(tmp_path: Path) -> None:
    (tmp_path / "junk.ifc").write_text("hello\nEND-ISO-10303-21;\n")
    with pytest.raises(GeometryError, match=r'body "wall": mesh junk.ifc: it cannot be read as IFC'):
        load_solid(tmp_path / "junk.ifc", density=1.0, name="wall")


def test_only_the_elements_asked_for_are_meshed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    calls = []
    monkeypatch.setattr(
        ifc, "call_in_subprocess", lambda call, *a, **k: calls.append(call) or call_in_subprocess(call, *a, **k)
    )
    found = read_selected_meshes({"one": (file, "south"), "two": (file, "s*th"), "three": (file, "south")})
    assert [each.meshes[0].element.names for each in found.values()] == [("south",), ("south",)]
    elements, mesh = calls
    assert elements is ifc._read_elements
    assert mesh.keywords == {"places": (1,)}


def crash_on(call: Any, place: int | None, file: Path) -> Any:
    """Answer as a reader that ends its process when it reads the file, or meshes the element at this place."""
    if place in getattr(call, "keywords", {"places": (None,)})["places"]:
        os.abort()
    return call(file)


@pytest.mark.parametrize("place", [None, 0, 1])
def test_a_crash_is_a_message_and_costs_one_element_its_mesh(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: int | None
) -> None:
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    monkeypatch.setattr(
        ifc, "call_in_subprocess", lambda call, *a, **k: call_in_subprocess(partial(crash_on, call, place), *a, **k)
    )
    if place is None:
        with pytest.raises(GeometryError, match=r"house.ifc: it cannot be read as IFC \(IfcOpenShell crashed on it"):
            inventory(file)
        return
    parts = inventory(file)
    assert [each.closed for each in parts] == [place != 0, place != 1]
    assert parts[place].why_not == ifc.CRASHED
    assert [each.element.names for each in parts] == [("north",), ("south",)]


def test_classes_and_patterns_join_and_say_so(tmp_path: Path) -> None:
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    for wanted in ("IfcWall", "IfcBuildingElement", "*th"):
        found = load_solid(file, density=1.0, name="wall", element=wanted)
        assert found.mass == pytest.approx(4.0 * 1.25 * 8.0 + 3.0 * 1.25 * 8.0 - 1.0 * 1.25 * 2.0, rel=1e-9)
        assert [told.text for told in found.history] == ["elements joined into one body: 2 (north, south)"]


def test_a_broken_element_is_named_and_does_not_refuse_the_others(tmp_path: Path) -> None:
    file = tmp_path / "house.ifc"
    identifiers = building(file, prefix=None)
    model = ifcopenshell.open(str(file))
    model.by_guid(identifiers["north"]).Representation.Representations[0].Items[0].Depth = 0.0
    model.write(str(file))
    assert load_solid(file, density=1.0, name="wall", element="south").mass == pytest.approx(40.0, rel=1e-9)
    for wanted in ("north", "IfcWall", None):
        with pytest.raises(GeometryError) as caught:
            load_solid(file, density=1.0, name="wall", element=wanted)
        assert f'element "north" ({identifiers["north"]}): its body could not be built' in str(caught.value)


def test_elements_of_one_name_are_told_apart_by_their_identifiers(tmp_path: Path) -> None:
    file = tmp_path / "house.ifc"
    identifiers = building(file, prefix=None)
    model = ifcopenshell.open(str(file))
    model.by_guid(identifiers["north"]).Name = "south"
    model.write(str(file))
    with pytest.raises(GeometryError, match='2 elements are called "south"') as caught:
        load_solid(file, density=1.0, name="wall", element="south")
    assert all(each in str(caught.value) for each in identifiers.values())
    assert load_solid(file, density=1.0, name="wall", element=identifiers["south"]).mass == pytest.approx(
        40.0, rel=1e-9
    )


def test_a_body_or_an_opening_that_is_lost_is_told(tmp_path: Path) -> None:
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    model = ifcopenshell.open(str(file))
    (door,) = model.by_type("IfcOpeningElement")
    door.Representation.Representations[0].Items[0].Depth = 0.0
    model.write(str(file))
    whole = load_solid(file, density=1.0, name="wall", element="north")
    assert whole.mass == pytest.approx(3.0 * 1.25 * 8.0, rel=1e-9)
    assert 'element "north": not all of it could be built' in str(whole.history[0])
    assert "IfcExtrudedAreaSolid #" in str(whole.history[0])
    assert load_solid(file, density=1.0, name="wall", element="south").history == ()


def test_what_an_opening_is_made_of_and_the_file_lacks_is_told(tmp_path: Path) -> None:
    """Its wall is meshed whole, 9 % heavier, and ifcopenshell says so in its log alone."""
    file = tmp_path / "house.ifc"
    building(file, prefix=None)
    text = file.read_text()
    holders = {holder: made for made, holder in re.findall(r"#(\d+)=IFCEXTRUDEDAREASOLID\(#(\d+)", text)}
    found = []
    for profile, solid in holders.items():
        file.write_text(re.sub(rf"^#{profile}=.*\n", "", text, flags=re.MULTILINE))
        try:
            trail = load_solid(file, density=1.0, name="wall", element="north").history
        except GeometryError:  # the wall itself
            continue
        found += [solid] if any(f"IfcExtrudedAreaSolid #{solid}" in told.text for told in trail) else []
    assert len(found) == 1  # the door's
