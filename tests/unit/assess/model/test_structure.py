"""What a structure answers, of two storeys of a façade with a floor, a cross wall and a tie, all set by hand."""

from __future__ import annotations

import pytest

from assess.errors import GeometryError
from assess.geometry.solid import box, profile
from assess.model.part_contacts import find_contacts
from assess.model.structure import TABLES, Part, PartContact, Structure
from tests.support.buildings import TIMBER, block, part_of

X, Y, UP = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def _part(name, kind, *, t, length, height, base, normal=X):
    solid = box(thickness=t, length=length, height=height, base=base, density=1800.0, name=name)
    thickness, across = (t, length) if normal == X else (length, t)
    along = Y if normal == X else (-1.0, 0.0, 0.0)
    return Part(
        name=name, kind=kind, solid=solid, base=base[2], top=base[2] + height, thickness=thickness, length=across,
        height=height, normal=normal, along=along, density=1800.0,
    )  # fmt: skip


def _contact(first, relation, second, *, at=(0.0, 0.0, 0.0), normal=UP):
    return PartContact(first, second, relation, 0.5, 0.0, 0.0, at[2], at, normal)


@pytest.fixture
def house():
    parts = (
        _part("lower", "wall", t=0.5, length=6.0, height=3.0, base=(0.0, 0.0, 0.0)),
        _part("upper", "wall", t=0.4, length=6.0, height=3.0, base=(0.0, 0.0, 3.0)),
        _part("cross", "wall", t=4.0, length=0.3, height=3.0, base=(-2.25, -2.85, 0.0), normal=Y),
        _part("spine", "wall", t=4.0, length=0.3, height=3.0, base=(-2.25, 0.0, 0.0), normal=Y),
        _part("floor", "floor", t=4.0, length=6.0, height=0.2, base=(-2.1, 0.0, 2.8)),
        _part("bar", "tie", t=4.0, length=0.03, height=0.03, base=(-2.0, 1.0, 2.6)),
    )
    contacts = (
        _contact("upper", "stands-on", "lower", at=(0.0, 0.0, 3.0)),
        _contact("cross", "leans-on", "lower", at=(-0.25, -2.85, 1.5), normal=(-1.0, 0.0, 0.0)),
        _contact("lower", "leans-on", "spine", at=(-0.25, 0.0, 1.5), normal=X),
        _contact("floor", "bears-on", "lower", at=(-0.2, 0.0, 2.8)),
        _contact("lower", "held-by", "bar", at=(0.0, 1.0, 2.6), normal=X),
    )
    return Structure(parts, contacts)


def test_graph_is_read_both_ways(house):
    assert [part.name for part in house.standing_on("lower")] == ["upper"]
    assert [part.name for part in house.below("upper")] == ["lower"]
    assert [part.name for part in house.bearing_on("lower")] == ["floor"]
    assert [part.name for part in house.below("floor")] == ["lower"]
    assert [part.name for part in house.ties_of("lower")] == ["bar"]
    assert len(house.contacts_of("lower")) == 5


def test_cross_walls_are_sought_at_ends_and_between(house):
    found = house.cross_walls("lower")
    assert [(each.part.name, each.end) for each in found] == [("cross", "start"), ("spine", "between")]
    assert found[0].at == pytest.approx(0.15)
    assert found[1].at == pytest.approx(3.0)
    assert house.cross_walls("upper") == ()


def test_stack_is_that_of_walls_in_one_plane(house):
    assert [part.name for part in house.stack_of("upper")] == ["lower", "upper"]
    assert [part.name for part in house.stack_of("cross")] == ["cross"]


def test_part_tells_its_mass_and_place(house):
    part = house.part("lower")
    assert part.mass == pytest.approx(0.5 * 6.0 * 3.0 * 1800.0)
    assert part.volume == pytest.approx(9.0)
    assert (part.start, part.middle) == pytest.approx((-3.0, 0.0))
    assert house.lowest == 0.0
    assert [each.name for each in house.walls] == ["lower", "upper", "cross", "spine"]


def test_unknown_part_lists_the_known_ones(house):
    with pytest.raises(GeometryError, match='no part "roof"; it has lower, upper'):
        house.part("roof")


@pytest.mark.parametrize("name", TABLES)
def test_table_has_a_row_to_each(house, name):
    assert len(house.table(name)) == len(getattr(house, name))


def test_table_holds_numbers_in_si(house):
    row = house.table().set_index("name").loc["upper"]
    assert (row.thickness_m, row.base_m, row.mass_kg) == pytest.approx((0.4, 3.0, 0.4 * 6.0 * 3.0 * 1800.0))
    with pytest.raises(GeometryError, match="known are parts, contacts, storeys, left_out"):
        house.table("walls")


def test_a_roof_that_slopes_bears_on_the_edge_of_a_wall() -> None:
    """Rafters at 1 in 2 over the outer edge of a wall bear on it; a slab that ends 2 cm over it does not."""
    wall = part_of("Wall", block((0, 0.5), (-3, 3), (0, 3)), outward=True, normal=(-1, 0))
    slope = [(-0.5, 2.75), (3.5, 4.75), (3.5, 5.0), (-0.5, 3.0)]
    roof = part_of("Roof", profile(slope, length=6.0, density=TIMBER, name="roof"), "roof")
    (found,) = find_contacts((wall, roof)).contacts
    assert (found.first, found.relation, found.second) == ("Roof", "bears-on", "Wall")
    assert found.centroid[0] < 0.05
    slab = part_of("Slab", block((0.48, 4), (-3, 3), (3.0, 3.2)), "roof")
    assert not any(each.relation == "bears-on" for each in find_contacts((wall, slab)).contacts)
