"""Mechanisms found on buildings of boxes: each where it is planted and none where it is not, by hand and at random."""

from dataclasses import replace
from math import cos, degrees, pi, radians, sin, tan

import numpy as np
import pytest

import assess
from assess.codes.checklists import possible_mechanism
from assess.examples import copy_example
from assess.geometry.solid import polyhedron, profile
from assess.mechanisms.chain import uplift_multiplier
from assess.mechanisms.mechanism import CutAngle
from assess.mechanisms.single_block import SingleBlock
from assess.messages.message import Quantity
from assess.model.assembly import on_rigid_hinges
from assess.model.candidates import CLASSES, Candidates, find_candidates
from assess.model.least_multipliers import Drawing
from assess.model.structure import Structure
from spectra.gravity import g
from tests.support.buildings import STONE, TIMBER, block, house, part_of, touching


def of_kind(found: Candidates, kind: str):
    return [each for each in found if each.kind == kind]


def one(found: Candidates, kind: str, part: str):
    return next(each for each in of_kind(found, kind) if each.parts[0] == part)


@pytest.fixture(scope="module")
def found() -> Candidates:
    return find_candidates(house(caps=True))


def test_every_class_answers_entries_of_the_lists() -> None:
    for row in CLASSES:
        assert row.examines
        for building_type, entry in row.examines.items():
            assert possible_mechanism(building_type, entry) is not None


def test_a_house_has_its_mechanisms_and_no_wall_is_without(found: Candidates) -> None:
    count = {row.key: len(of_kind(found, row.key)) for row in CLASSES}
    assert count == {
        "overturning": 4, "overturning-of-storeys": 4, "wedges": 0, "corner": 4, "gable": 1, "bending": 4, "bay": 0,
        "upper-part": 0, "parapet": 0, "chimney": 1,
        "pinnacle": 0, "arch": 0, "portal": 0, "belfry": 0, "apse": 0, "tower": 0, "spire": 0,
    }  # fmt: skip
    assert not found.without
    assert len({each.name for each in found}) == len(found)


def test_candidates_rise_by_their_multiplier(found: Candidates) -> None:
    values = [each.multiplier for each in found]
    assert values == sorted(values)
    assert all(each.multiplier <= 1.1 * values[0] for each in found.weakest)


def test_a_facade_turns_with_the_floors_that_bear_on_it(found: Candidates) -> None:
    """By hand: half of floor and roof, at the middle of their seats, on a wall of 0.5 by 9 by 6 m.

    What lies of the floor in the masonry counts once, as masonry.
    """
    facade = one(found, "overturning-of-storeys", "Front 1")
    assert facade.found.direction == (0.0, -1.0, 0.0)
    assert facade.carries == ("Floor 1", "Roof 2")
    wall = STONE * 9.0 * 0.5 * 6.0
    floor, roof = TIMBER * 8.0 * 6.0 * 0.2 / 2.0, TIMBER * 8.0 * 7.0 * 0.2 / 2.0
    held = wall * 0.25 + floor * (0.25 + 0.125) + roof * 0.25
    driven = wall * 3.0 + floor * 2.8 + roof * 6.0
    assert facade.multiplier == pytest.approx(held / driven, rel=1e-6)
    assert facade.found.parameters == {"hinge": Quantity(0.0, "length")}
    assert "Floor 1 bears on it at z = 2.8 m" in str(facade.reason)


def test_the_top_storey_turns_above_the_floor_that_bears_below_it(found: Candidates) -> None:
    top = one(found, "overturning", "Left 2")
    assert top.multiplier == pytest.approx(
        (6.0 * 3.0 * 0.25 + 6.0 * 1.0 * 0.25) / (6.0 * 3.0 * 1.5 + 6.0 * 1.0 * (3.0 + 2.0 / 3.0)), rel=1e-6
    )  # with the gable on it
    assert top.parts == ("Left 2", "Gable")


def test_a_gable_and_a_chimney_turn_on_what_they_stand_on(found: Candidates) -> None:
    assert one(found, "gable", "Gable").multiplier == pytest.approx(0.25 / (2.0 / 3.0), rel=1e-6)
    assert one(found, "chimney", "Chimney").multiplier == pytest.approx(0.5 / 1.8, rel=1e-6)
    assert len(one(found, "chimney", "Chimney").ties) == 3  # as weak in all four directions


def test_a_gable_that_ends_on_a_corner_of_a_facade_stays_where_it_is() -> None:
    """A façade 3 m high and 0.5 m thick turns at 0.5/3, though the gable of the side wall ends on its corner."""
    front = part_of("Front", block((0, 6), (0, 0.5), (0, 3)), normal=(0, -1), outward=True)
    side = part_of("Side", block((0, 0.5), (0.5, 6), (0, 3)), normal=(-1, 0), outward=True)
    gable = part_of("Gable", block((0, 0.5), (0, 6), (3, 5)), "gable", normal=(-1, 0), outward=True)
    parts = (front, side, gable)
    found = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    assert one(found, "overturning", "Front").parts == ("Front",)
    assert one(found, "overturning", "Front").multiplier == pytest.approx(0.5 / 3.0, rel=1e-6)
    assert one(found, "overturning", "Side").parts == ("Side", "Gable")


def test_what_a_wall_has_above_those_that_meet_it_is_a_gable() -> None:
    end = profile([(-3, 0), (3, 0), (3, 3), (0, 5), (-3, 3)], length=0.5, density=STONE, name="end")
    wall = part_of("End", end, normal=(0, 1), outward=True)
    sides = [part_of(f"Side {x}", block((x, x + 0.4), (-4, -0.25), (0, 3)), normal=(1, 0)) for x in (-3.0, 2.6)]
    parts = (wall, *sides)
    (gable,) = of_kind(find_candidates(Structure(parts=parts, contacts=touching(parts))), "gable")
    assert gable.definition.cut == pytest.approx(3.0)
    assert gable.multiplier == pytest.approx(0.25 / (2.0 / 3.0), rel=1e-6)


@pytest.mark.parametrize(
    ("top", "kind", "entry"), [(5.4, "upper-part", "simple-overturning"), (4.0, "parapet", "parapet")]
)
def test_a_level_wall_above_those_that_meet_it_is_no_gable_and_turns_with_its_chimney(top, kind, entry) -> None:
    """By hand: wall 6 m by 0.5 m above z = 3 m, chimney 0.6 m by 0.5 m by 1.5 m on it: sum W t/2 over sum W h."""
    wall = part_of("Party", block((-3, 3), (0, 0.5), (0, top)), normal=(0, 1), outward=True)
    sides = [part_of(f"Side {x}", block((x, x + 0.4), (-4, 0), (0, 3)), normal=(1, 0)) for x in (-3.0, 2.6)]
    chimney = part_of("Chimney", block((-1, -0.4), (0, 0.5), (top, top + 1.5)), "chimney", normal=(0, 1))
    parts = (wall, *sides, chimney)
    found = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    upper = one(found, kind, "Party")
    rise, own, above = top - 3.0, 6.0 * (top - 3.0), 0.6 * 1.5
    by_hand = 0.25 * (own + above) / (own * rise / 2.0 + above * (rise + 0.75))
    assert upper.multiplier == pytest.approx(by_hand, rel=1e-6)
    assert (upper.definition.bodies, upper.definition.cut) == (("Party", "Chimney"), 3.0)
    assert upper.examines["house"] == entry
    assert not of_kind(found, "gable")


def test_what_stands_on_a_tower_falls_with_it() -> None:
    """By hand, of the level crack at the foot: sum W b/2 over sum W h bounds the least from above."""
    tower = part_of("Tower", block((0, 4), (0, 4), (0, 12)), "tower", normal=(1, 0), outward=True)
    top = part_of("Pinnacle", block((1, 3), (1, 3), (12, 16)), "pinnacle", normal=(1, 0))
    parts = (tower, top)
    fall = one(find_candidates(Structure(parts=parts, contacts=touching(parts))), "tower", "Tower")
    assert fall.parts == fall.definition.bodies == ("Tower", "Pinnacle")
    assert fall.multiplier <= 2.0 * (192.0 + 16.0) / (192.0 * 6.0 + 16.0 * 14.0)


def test_a_roof_that_would_push_a_wall_over_is_taken_as_tied() -> None:
    """Two walls under a steep roof fall by its thrust, and they stand."""
    walls = [
        part_of(f"Wall {y}", block((0, 6), (y, y + 0.3), (0, 5)), normal=(0, way), outward=True)
        for y, way in ((0.0, -1), (6.7, 1))
    ]
    section = [(0, 5), (0.3, 5), (3.5, 7), (6.7, 5), (7, 5), (7, 5.3), (3.5, 7.4), (0, 5.3)]
    roof = profile(section, length=6.0, density=1000.0, name="roof")
    turned = roof.vertices[:, [1, 0, 2]] * (-1, 1, 1) + (3.0, 0.0, 0.0)
    centroid = np.array([3.0, 3.5, roof.centroid[2]])
    moved = replace(roof, vertices=turned, centroid=centroid, inertia=roof.inertia[np.ix_([1, 0, 2], [1, 0, 2])])
    parts = (*walls, part_of("Roof", moved, "roof", normal=(0, 1), density=1000.0))
    found = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    first = of_kind(found, "overturning")[0]
    assert first.found.tied == ("Roof",)
    assert first.definition.loads[0].tied is True
    assert 0.0 < first.multiplier < 0.3 / 5.0 * 1.1
    assert "to be confirmed" in str(first.reason)


def test_a_wall_bends_between_floors_under_what_stands_on_it(found: Candidates) -> None:
    wall = one(found, "bending", "Front 2")
    roof, own = TIMBER * 8.0 * 7.0 * 0.2 / 2.0, STONE * 9.0 * 0.5 * 3.0

    def by_hand(z: float) -> float:
        """Virtual work of the two parts of a wall of 0.5 by 3 m that turn by 1 and by -z / (3 - z)."""
        back, share = z / (3.0 - z), z / 3.0
        lift = own * (share * 0.25 + share * 0.5 * 0.0) + 0.0
        lower, upper = own * share, own * (1.0 - share)
        lift = lower * 0.25 + upper * (0.5 + back * 0.25) + roof * (0.5 + back * 0.25)
        return lift / (lower * z / 2.0 + upper * z / 2.0)

    least = min(by_hand(z) for z in np.linspace(0.5, 2.98, 2000))
    assert wall.multiplier == pytest.approx(least, rel=1e-4)
    assert wall.definition.crack in ("sorrentino", "minimum")


def test_corners_turn_at_the_least_of_the_formula(found: Candidates) -> None:
    """The back wall of no openings falls out with its whole wedge, and the roof that bears on it."""
    corner = next(each for each in of_kind(found, "corner") if set(each.parts) >= {"Back 1", "Right 1"})
    reach = 6.0 * tan(radians(30.0))
    line = TIMBER * 7.0 * 0.2 * 8.0 / 2.0 / 9.0
    floor = TIMBER * 6.5 * 0.2 * 8.0 / 2.0 / 9.0
    column, wedge = STONE * 0.25 * 6.0, STONE * 0.5 * 6.0 * reach / 2.0
    held = (column + wedge + (line + floor) * (0.5 + reach)) * 0.25
    driven = column * 3.0 + wedge * 4.0 + line * (0.5 + reach) * 6.0 + floor * (0.5 + reach) * 2.8
    assert corner.multiplier == pytest.approx(held / driven, rel=5e-3)  # a floor loads by what touches
    assert corner.definition.kind == "corner"
    assert corner.examines == {"house": "corner"}
    assert len({str(each.title) for each in of_kind(found, "corner")}) == 4  # each names both of its walls
    assert str(corner.title).startswith(("Back 1, Right 1: ", "Right 1, Back 1: "))


def test_a_project_states_all_of_them_with_the_multiplier_that_is_listed(found: Candidates) -> None:
    drawing = Drawing(house(caps=True))
    for each in found:
        made, _ = on_rigid_hinges("m", each.definition, drawing.around(each.definition))
        assert min(map(uplift_multiplier, made.chains)) == pytest.approx(each.multiplier, rel=1e-9)


@pytest.mark.parametrize("count", [20, pytest.param(1000, marks=pytest.mark.study)])
def test_no_random_cut_is_weaker(found: Candidates, count: int) -> None:
    bodies = Drawing(house(caps=True)).bodies
    rng = np.random.default_rng(3)
    for each in of_kind(found, "overturning"):
        low = each.found.parameters["hinge"].value
        for z in rng.uniform(low + 0.01, 5.5, count):
            other, _ = on_rigid_hinges("other", replace(each.definition, cut=float(z)), bodies)
            assert each.multiplier <= uplift_multiplier(other.positive) + 1e-9


def test_a_wall_between_rooms_is_held_and_bends_alone() -> None:
    walls = house(storeys=1).parts
    inner = part_of("Inner", block((4.3, 4.6), (0.5, 6.5), (0.0, 3.0)), normal=(1, 0))
    one_side = part_of("Left room", block((0.5, 4.3), (3.0, 3.3), (0.0, 3.0)), normal=(0, 1))
    other_side = part_of("Right room", block((4.6, 8.5), (3.0, 3.3), (0.0, 3.0)), normal=(0, 1))
    parts = (*walls, inner, one_side, other_side)
    found = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    kinds = {each.kind for each in found if each.parts[0] == "Inner"}
    assert "overturning" not in kinds
    assert "bending" in kinds


def test_a_wall_that_everything_holds_is_named() -> None:
    wall = part_of("Held", block((0, 0.4), (0, 4), (0, 3)), normal=(1, 0))
    props = [
        part_of("Ahead", block((0.4, 3), (1.8, 2.2), (0, 3)), normal=(0, 1)),
        part_of("Behind", block((-3, 0), (1.8, 2.2), (0, 3)), normal=(0, 1)),
    ]
    parts = (wall, *props)
    found = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    assert list(found.without) == ["Held"]
    assert "no mechanism found" in str(found.without["Held"])


def test_an_arch_forms_between_cross_walls_with_masonry_beyond() -> None:
    facade = part_of("Facade", block((0, 0.5), (0, 16), (0, 3)), normal=(-1, 0), outward=True)
    cross = [part_of(f"Cross {y}", block((0.5, 5), (y, y + 0.5), (0, 3)), normal=(0, 1)) for y in (4.0, 11.5)]
    parts = (facade, *cross)
    found = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    (bay,) = of_kind(found, "bay")
    span, beyond = 7.0, 4.0
    weight = g * STONE * 0.5 * 3.0
    thrust = weight * beyond**2 / (2.0 * 3.0)
    rise = 0.5 - thrust / (1e6 * 3.0)
    assert bay.multiplier == pytest.approx(8.0 * thrust * rise / (weight * span * span))
    assert not of_kind(find_candidates(house()), "bay")  # at corners nothing stands beyond


def spire(*, height: float = 8.0, side: float = 2.0, top: float = 0.3):
    a, b = side / 2.0, top / 2.0
    corners = [
        (-a, -a, 0),
        (a, -a, 0),
        (a, a, 0),
        (-a, a, 0),
        (-b, -b, height),
        (b, -b, height),
        (b, b, height),
        (-b, b, height),
    ]
    quads = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    triangles = [t for q in quads for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]
    return polyhedron(np.array(corners, float), np.array(triangles), density=STONE, name="spire")


def test_the_crack_of_a_spire_is_the_weakest_of_all_in_sixty_cuts() -> None:
    part = part_of("Spire", spire(), "pinnacle")
    (found,) = of_kind(find_candidates(Structure(parts=(part,))), "spire")
    at = {name: value.value for name, value in found.found.parameters.items()}
    bodies = Drawing(Structure(parts=(part,))).bodies

    def multiplier(angle: float) -> float:
        cut = CutAngle(found.definition.cut.point, angle)
        other, _ = on_rigid_hinges(
            "other", SingleBlock(blocks=(("Spire",),), direction=found.found.direction, sides="one", cut=cut), bodies
        )
        return uplift_multiplier(other.positive)

    angles = np.radians(np.arange(0.0, 75.5, 0.5))
    values = [multiplier(float(angle)) for angle in angles]
    assert degrees(at["angle"]) == pytest.approx(np.degrees(angles[int(np.argmin(values))]), abs=1.0)
    assert found.multiplier <= min(values) + 1e-6
    assert found.found.evaluations <= 60


def test_the_spire_of_a_published_study_cracks_at_its_steepest_angle(tmp_path) -> None:
    """Mehrotra 2019, Table 5.1: 0.42, 0.34 and 0.23 at 45, 60 and 75 degrees; a cone is weakest at the steepest."""
    copy_example("san_leonardo_spire", tmp_path / "spire")
    structure = assess.read_building(tmp_path / "spire" / "spire.ply")
    (found,) = of_kind(structure.mechanisms(), "spire")
    assert found.multiplier == pytest.approx(0.233, abs=0.005)
    assert degrees(found.found.parameters["angle"].value) == pytest.approx(75.0, abs=1.0)
    assert found.found.parameters["crack"].value >= structure.lowest  # a crack through its foot parts nothing
    assert found.found.evaluations <= 60


def test_two_piers_sway_under_what_they_carry() -> None:
    """A portal of equal piers: each turns about its foot, the lintel moves with them; half width over height."""
    piers = [part_of(f"Pier {y}", block((0, 0.6), (y, y + 0.8), (0, 3)), "pier", normal=(1, 0)) for y in (0.0, 3.0)]
    lintel = part_of("Lintel", block((0, 0.6), (0, 3.8), (3, 3.5)), "spandrel", normal=(1, 0))
    parts = (*piers, lintel)
    found = find_candidates(Structure(parts=parts, contacts=touching(parts)))
    (portal,) = of_kind(found, "portal")
    pier, over = 0.8 * 3.0, 3.8 * 0.5
    assert portal.multiplier == pytest.approx(
        (2.0 * pier * 0.4 + over * 0.8) / (2.0 * pier * 1.5 + over * 3.0), rel=1e-6
    )
    assert not of_kind(found, "belfry")
    tower = part_of("Tower", block((-1, 2), (-1, 5), (-6, 0)), "tower")
    tall = (tower, *parts)
    assert of_kind(find_candidates(Structure(parts=tall, contacts=touching(tall))), "belfry")


def test_an_arch_is_cut_at_even_joints() -> None:
    """A thick half ring of radii 2 and 2.5 m: its least multiplier by joints is found, and grows with thickness."""

    def least(thickness: float) -> float:
        turn = np.linspace(0.0, pi, 33)
        outer, inner = 2.0 + thickness, 2.0
        corners = [(outer * cos(t), outer * sin(t)) for t in turn] + [
            (inner * cos(t), inner * sin(t)) for t in turn[::-1]
        ]
        ring = profile(corners, length=0.8, density=STONE, name="arch")
        part = part_of("Arch", ring, "arch", normal=(0, 1))
        (found,) = of_kind(find_candidates(Structure(parts=(part,))), "arch")
        assert found.found.parameters["radius"].value == pytest.approx(2.0, rel=0.01)
        return found.multiplier

    assert 0.0 < least(0.5) < least(0.8)


def test_a_table_has_a_row_for_each(found: Candidates) -> None:
    table = found.table()
    assert list(table.name) == [each.name for each in found]
    assert set(table.columns) >= {"class", "multiplier", "parameters", "reason", "in_project_file"}
    assert found.by_entry("house")["gable"] == ("gable-gable",)
