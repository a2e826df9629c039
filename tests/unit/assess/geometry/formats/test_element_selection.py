"""Which elements a name, an identifier, a class or a pattern means."""

import pytest

from assess.errors import GeometryError
from assess.geometry.formats.mesh_file import Element, select_elements

WALL = ("IfcWallStandardCase", "IfcWall", "IfcElement")
HOUSE = (
    Element(("Wand-1",), "id-1", WALL),
    Element(("Wand-2",), "id-2", WALL[1:]),
    Element(("Wand-[2]",), "id-3", ("IfcBeam", "IfcElement")),
    Element(("slab",), "id-4", ("IfcSlab", "IfcElement")),
    Element(("slab",), "id-5", ("IfcSlab", "IfcElement")),
    Element(("leaf",), "id-6", ("IfcBuildingElementPart",), within=("Giebel", "id-7", "IfcWall")),
)


@pytest.mark.parametrize(
    ("wanted", "places"),
    [
        (None, (0, 1, 2, 3, 4, 5)),
        ("Wand-1", (0,)),
        ("id-5", (4,)),
        ("Wand-*", (0, 1, 2)),
        ("Wand-?", (0, 1)),
        ("Wand-[13]", (0,)),
        ("Wand-[2]", (2,)),  # the name as it stands before the pattern
        ("s[l]ab", (3, 4)),
        ("IfcWallStandardCase", (0,)),
        ("Giebel", (5,)),
        ("Gie*", (5,)),
        ("IfcSlab", (3, 4)),
        ("IfcBeam", (2,)),
    ],
)
def test_a_name_an_identifier_a_class_or_a_pattern(wanted: str | None, places: tuple[int, ...]) -> None:
    assert select_elements(HOUSE, wanted, where="mesh") == places


def test_a_class_takes_the_special_ones_and_the_parts_of_such_elements() -> None:
    assert select_elements(HOUSE, "IfcWall", where="mesh") == (0, 1, 5)
    assert select_elements(HOUSE, "IfcElement", where="mesh") == (0, 1, 2, 3, 4)


def test_one_name_of_several_is_refused_with_their_identifiers() -> None:
    with pytest.raises(GeometryError, match=r'2 elements are called "slab": id-4, id-5; give the identifier'):
        select_elements(HOUSE, "slab", where="mesh")


def test_one_name_of_several_that_nothing_tells_apart_means_all() -> None:
    assert select_elements([Element(("pier",)), Element(("pier",)), Element()], "pier", where="mesh") == (0, 1)


@pytest.mark.parametrize(
    ("wanted", "told"),
    [
        ("Wand-11", "did you mean Wand-1"),
        ("IfcWal", "did you mean IfcWall"),
        ("ifcslab", "did you mean IfcSlab?"),
        ("IfcDoor", "its classes are IfcBeam, IfcBuildingElementPart, IfcSlab, IfcWall, IfcWallStandardCase"),
        ("Q*", "known: Wand-1, Wand-2, Wand-"),
    ],
)
def test_what_fits_nothing_is_refused_with_what_is_near(wanted: str, told: str) -> None:
    with pytest.raises(GeometryError) as caught:
        select_elements(HOUSE, wanted, where="mesh")
    assert f'mesh: it has no element "{wanted}"; {told}' in str(caught.value)


def test_a_name_is_typed_as_tables_show_it() -> None:
    broken = [Element(("Mauer\r\n  Ost",), "id-1"), Element(("Mauer West",), "id-2")]
    for wanted in ("Mauer Ost", "Mauer\r\n  Ost", "*r Ost"):
        assert select_elements(broken, wanted, where="mesh") == (0,)
    with pytest.raises(GeometryError, match="did you mean Mauer Ost"):
        select_elements(broken, "Mauer Osten", where="mesh")


def test_a_long_name_is_cut_where_one_sees_it() -> None:
    with pytest.raises(GeometryError, match=f"known: {'n' * 39}…"):
        select_elements([Element(("n" * 50,))], "wall", where="mesh")


def test_a_file_without_names_says_so() -> None:
    with pytest.raises(GeometryError, match="its parts have no names; remove the key"):
        select_elements([Element()], "wall", where="mesh")
