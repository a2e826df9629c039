"""The direction where none is given: boxes by hand, bodies beside a wall, what must be given, and warnings."""

from __future__ import annotations

from math import cos, radians, sin
from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.constants import g

from assess.errors import ProjectError
from assess.study.mechanism_results import parameters
from assess.study.study import Study
from tests.support.projects import box_toml, mechanism_of, mechanism_toml, study_of, tables_toml

HEAD = tables_toml(materials={"m": {"density": 2000, "tensile_strength": "0.02 MPa"}})
WALL = """
[bodies.wall]
material = "m"
box = {{ thickness = {}, length = {}, height = 3 }}
"""
ALONG_Y = WALL.format(4, 0.3)  # 4 m along x: it is thin along y
ALONG_X = WALL.format(0.3, 4)


def keys(made: Study) -> set[str]:
    """Of what is told of directions and sides."""
    return {each.key for each in made.messages} - {"confidence-factor"}


@pytest.mark.parametrize(("wall", "direction"), [(ALONG_Y, (0.0, 1.0, 0.0)), (ALONG_X, (1.0, 0.0, 0.0))])
@pytest.mark.parametrize(("kind", "height"), [("single-block", 1.5), ("two-block", None)])
def test_a_wall_falls_across_its_thickness_however_it_is_drawn(
    tmp_path: Path, wall: str, direction: tuple[float, float, float], kind: str, height: float | None
) -> None:
    loads = 'loads = [{ kind = "overburden", force = "40 kN" }]' if kind == "two-block" else ""
    made = study_of(tmp_path, HEAD, wall, mechanism_toml(loads, kind=kind))
    (one,) = made.mechanisms
    assert one.direction == direction
    assert one.sides == "two"
    assert len(one.candidates) == (4 if kind == "single-block" else 2)
    if height is not None:
        (result,) = parameters(made)
        assert result.oscillator.uplift_multiplier == pytest.approx(0.15 / height, rel=1e-12)
        least, *_, most = sorted(each.uplift_multiplier or 0.0 for each in one.candidates)
        assert (least, most) == (pytest.approx(0.15 / 1.5, rel=1e-12), pytest.approx(2.0 / 1.5, rel=1e-12))
        assert result.direction == direction


def test_a_wall_drawn_askew_falls_across_its_thickness(tmp_path: Path) -> None:
    """Turned by 30 degrees: the normals of its long faces are at 30 and 210 degrees."""
    turned = trimesh.creation.box((0.3, 4.0, 3.0))
    turned.apply_translation((0.0, 0.0, 1.5))
    turned.apply_transform(trimesh.transformations.rotation_matrix(radians(30.0), (0, 0, 1)))
    turned.export(tmp_path / "wall.obj", digits=17)
    one = mechanism_of(tmp_path, HEAD, '[bodies.wall]\nmaterial = "m"\nmesh = "wall.obj"\n', mechanism_toml())
    assert one.direction == pytest.approx((cos(radians(30)), sin(radians(30)), 0.0), abs=1e-9)
    (least,) = {round(each.uplift_multiplier or 0.0, 9) for each in one.candidates if each.angle_deg < 31.0}
    assert least == pytest.approx(0.1, abs=1e-8)
    assert not any("askew" in text for text in map(str, one.warnings))


def test_a_load_decides_between_the_two_faces(tmp_path: Path) -> None:
    """A mass beyond the face at +y pulls the centroid that way: the block turns towards it first."""
    load_ = f"loads = [{{ kind = 'mass', mass = {0.1 * 2000 * 0.3 * 4 * 3}, at = [0, 0.3, 1.5] }}]"
    one = mechanism_of(tmp_path, HEAD, ALONG_Y, mechanism_toml(load_))
    assert one.direction == (0.0, 1.0, 0.0)
    other = mechanism_of(tmp_path, HEAD, ALONG_Y, mechanism_toml(load_.replace("0.3, 1.5", "-0.3, 1.5")))
    assert other.direction == (0.0, -1.0, 0.0)
    work = one.candidates[1]
    assert work.uplift_multiplier == pytest.approx((0.15 - 0.1 * (0.3 - 0.15)) / (1.5 * 1.1), rel=1e-9)


def test_a_leaning_wall_falls_the_way_it_leans(tmp_path: Path) -> None:
    leaning = '[bodies.wall]\nmaterial = "m"\nprofile = [[0, 0], [1, 0], [0.7, 5], [-0.3, 5]]\nlength = 4\n'
    one = mechanism_of(tmp_path, HEAD, leaning, mechanism_toml())
    assert one.direction == (-1.0, 0.0, 0.0)  # the centroid stands at 0.35
    assert min(each.uplift_multiplier or 9.0 for each in one.candidates) == pytest.approx(0.35 / 2.5, rel=1e-9)


def test_above_a_cut_the_section_there_counts(tmp_path: Path) -> None:
    """A pier that is square at its foot and slender along y above."""
    pier = box_toml("wall", (1, 1, 2), (0, 0, 0)) + box_toml("upper", (1, 0.4, 2), (0, 0, 2))
    blocks = '[mechanisms.m]\nkind = "single-block"\nblocks = [["wall", "upper"]]\ncut = 2\n'
    assert mechanism_of(tmp_path, HEAD, pier, blocks).direction == (0.0, 1.0, 0.0)


def test_a_wall_joined_at_both_ends_keeps_out_of_its_plane(tmp_path: Path) -> None:
    """Thicker than long, it would be weakest in its own plane; what it is joined to holds it there."""
    pier = WALL.format(1.0, 0.8)
    assert mechanism_of(tmp_path, HEAD, pier, mechanism_toml()).direction == (0.0, 1.0, 0.0)
    neighbours = box_toml("left", (1, 3, 3), (0, -1.9, 0)) + box_toml("right", (1, 3, 3), (0, 1.9, 0))
    made = study_of(tmp_path, HEAD, pier, neighbours, mechanism_toml())
    (one,) = made.mechanisms
    assert one.direction == (1.0, 0.0, 0.0)
    assert one.sides == "two"
    told = [each for each in made.messages if each.key == "direction-stopped"]
    assert len(told) == 2
    assert all("left" in each.text or "right" in each.text for each in told)


def test_a_wall_against_a_building_rocks_away_from_it(tmp_path: Path) -> None:
    building = box_toml("building", (4, 3, 3), (0, 1.65, 0))  # its face touches the wall's at y = 0.15
    made = study_of(tmp_path, HEAD, ALONG_Y, building, mechanism_toml())
    (one,) = made.mechanisms
    assert one.direction == (0.0, -1.0, 0.0)
    assert one.sides == "one"
    assert {"direction-stopped", "sides-by-contact"} <= keys(made)
    apart = mechanism_of(tmp_path, HEAD, ALONG_Y, building.replace("1.65", "1.75"), mechanism_toml())  # 10 cm away
    assert apart.sides == "two"


def test_return_walls_behind_a_facade_let_it_fall_outwards_only(tmp_path: Path) -> None:
    returns = box_toml("a", (0.3, 3, 3), (-1.85, 1.65, 0)) + box_toml("b", (0.3, 3, 3), (1.85, 1.65, 0))
    one = mechanism_of(tmp_path, HEAD, ALONG_Y, returns, mechanism_toml())
    assert (one.direction, one.sides) == ((0.0, -1.0, 0.0), "one")


def test_a_direction_given_along_a_contact_rocks_to_one_side(tmp_path: Path) -> None:
    building = box_toml("building", (4, 3, 3), (0, 1.65, 0))
    away = study_of(tmp_path, HEAD, ALONG_Y, building, mechanism_toml("direction = [0, -1, 0]"))
    assert away.mechanisms[0].sides == "one"
    assert keys(away) == {"sides-by-contact"}
    into = study_of(tmp_path, HEAD, ALONG_Y, building, mechanism_toml("direction = [0, 1, 0]"))
    assert into.mechanisms[0].sides == "two"
    assert "direction-into" in keys(into)
    given = study_of(tmp_path, HEAD, ALONG_Y, building, mechanism_toml('direction = [0, -1, 0]\nsides = "two"'))
    assert given.mechanisms[0].sides == "two"


def test_a_floor_on_the_wall_and_a_pavement_are_no_obstacles(tmp_path: Path) -> None:
    floor = box_toml("floor", (4, 3, 0.2), (0, 1.5, 3))  # rests on the top
    pavement = box_toml("pavement", (4, 3, 0.2), (0, 1.65, 0))  # reaches a fifteenth of the height
    loads = 'loads = [{ kind = "body", body = "floor", share = 0.5, at = [0, 0, 3] }]'
    one = mechanism_of(tmp_path, HEAD, ALONG_Y, floor, pavement, mechanism_toml(loads))
    assert one.sides == "two"


def test_a_body_that_moves_with_the_wall_is_no_obstacle(tmp_path: Path) -> None:
    """A floor against the face of the wall, as a load: its inertia pushes, it holds nothing."""
    floor = box_toml("floor", (4, 3, 0.3), (0, 1.65, 2))
    load_ = 'loads = [{ kind = "body", body = "floor" }]'
    assert mechanism_of(tmp_path, HEAD, ALONG_Y, floor, mechanism_toml(load_)).sides == "two"
    assert mechanism_of(tmp_path, HEAD, ALONG_Y, floor, mechanism_toml()).sides == "one"


def test_a_weak_axis_held_both_ways_is_taken_to_move_all_the_same(tmp_path: Path) -> None:
    """A buttress here and a floor there hold a long wall; that does not make its own plane the weak one."""
    beside = box_toml("buttress", (0.5, 1, 2), (0, 0.65, 0)) + box_toml("floor", (4, 3, 0.2), (0, -1.65, 2))
    made = study_of(tmp_path, HEAD, ALONG_Y, beside, mechanism_toml())
    (one,) = made.mechanisms
    assert one.direction == (0.0, 1.0, 0.0)
    assert one.sides == "two"
    assert "direction-held" in keys(made)


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ('sides = "one"', 'with sides = "one" it says which way'),
        ("hinges = { A = [0.1, 0] }", r"hinges\.A is measured along it"),
        ("loads = [{ kind = 'force', force = [9, 0], at = [0, 0, 2] }]", r"loads\[1\]\.force is measured along it"),
        ("loads = [{ kind = 'mass', mass = 9, at = [0, 2] }]", r"loads\[1\]\.at is measured along it"),
    ],
)
def test_what_is_measured_along_the_direction_asks_for_it_with_the_candidates(
    tmp_path: Path, more: str, words: str
) -> None:
    weak, strong = 0.15 / 1.5, 2.0 / 1.5
    with pytest.raises(ProjectError, match=words) as caught:
        study_of(tmp_path, HEAD, ALONG_Y, mechanism_toml(more))
    text = str(caught.value)
    assert "mechanisms.m.direction: missing" in text
    assert f"[0, 1, 0] with a multiplier of {weak:.4g}, [0, -1, 0] with a multiplier of {weak:.4g}" in text
    assert f"[1, 0, 0] with a multiplier of {strong:.4g}" in text
    assert "\n" not in text
    assert mechanism_of(tmp_path, HEAD, ALONG_Y, mechanism_toml(f"{more}\ndirection = [0, 1, 0]")).direction == (
        0.0,
        1.0,
        0.0,
    )


def test_an_eccentricity_is_measured_along_the_direction(tmp_path: Path) -> None:
    load_ = 'loads = [{ kind = "overburden", force = "40 kN", eccentricity = "0.05 m" }]'
    with pytest.raises(ProjectError, match=r"loads\[1\]\.eccentricity is measured along it"):
        study_of(tmp_path, HEAD, ALONG_Y, mechanism_toml(load_, kind="two-block"))


def test_a_given_direction_is_compared_with_a_weaker_one(tmp_path: Path) -> None:
    made = study_of(tmp_path, HEAD, ALONG_Y, mechanism_toml("direction = [1, 0, 0]"))
    (told,) = [each for each in made.messages if each.key == "direction-weaker"]
    assert told.severity == "warning"
    values = {key: getattr(each, "value", each) for key, each in told.values.items()}
    assert values["direction"] in ("[0, 1, 0]", "[0, -1, 0]")
    assert values["weaker"] == pytest.approx(0.1, rel=1e-12)
    assert values["given"] == pytest.approx(2.0 / 1.5, rel=1e-12)
    alpha, R = np.arctan2(0.15, 1.5), np.hypot(0.15, 1.5)
    assert values["weaker_d0"] == pytest.approx(R * np.sin(alpha), rel=1e-6)  # the centroid ends above the hinge
    assert keys(study_of(tmp_path, HEAD, ALONG_Y, mechanism_toml("direction = [0, 1, 0]"))) == set()


def test_a_free_direction_less_than_a_twentieth_weaker_is_not_warned_of(tmp_path: Path) -> None:
    assert "direction-weaker" not in keys(
        study_of(tmp_path, HEAD, WALL.format(1.0, 0.96), mechanism_toml("direction = [1, 0, 0]"))
    )
    assert "direction-weaker" in keys(
        study_of(tmp_path, HEAD, WALL.format(1.0, 0.94), mechanism_toml("direction = [1, 0, 0]"))
    )


def test_a_hinge_given_in_space_says_on_which_side_it_is(tmp_path: Path) -> None:
    one = mechanism_of(tmp_path, HEAD, WALL.format(1.0, 0.9), mechanism_toml("hinges = { A = [0.45, 0.1, 0] }"))
    assert one.direction == (1.0, 0.0, 0.0)
    assert one.positive.hinges == ((0.45, 0.0),)


def test_a_wall_that_falls_one_way_falls_that_way(tmp_path: Path) -> None:
    thrust = 2000 * 0.3 * 4 * 3 * g * 0.15 / 2.5 * 1.01  # about the edge at +y, a little more than the weight holds
    load_ = f"loads = [{{ kind = 'force', force = {thrust}, direction = [0, 1, 0], at = [0, 0, 2.5] }}]"
    (falling,) = study_of(tmp_path, HEAD, ALONG_Y, mechanism_toml(load_)).falling
    assert "towards [0, 1, 0]" in falling.reason


def test_bodies_of_direct_values_keep_their_one_plane(tmp_path: Path) -> None:
    direct = "[bodies.wall]\nmass = 900\ncentroid = [0, 2]\ninertia = 900\n"
    one = mechanism_of(tmp_path, HEAD, direct, mechanism_toml("hinges = { A = [0.3, 0] }\nsides = 'one'"))
    assert one.direction == (1.0, 0.0, 0.0)


def test_four_hinges_stay_along_x(tmp_path: Path) -> None:
    legs = (
        box_toml("l", (0.5, 1, 3), (0, 0, 0))
        + box_toml("r", (0.5, 1, 3), (4, 0, 0))
        + box_toml("b", (4.5, 1, 0.5), (2, 0, 3))
    )
    portal = (
        '[mechanisms.m]\nkind = "four-hinge"\nblocks = ["l", "b", "r"]\nsides = "one"\n'
        "hinges = { A = [0.25, 0], B = [-0.25, 3], C = [3.75, 3], D = [4.25, 0] }\n"
    )
    assert mechanism_of(tmp_path, HEAD, legs, portal).direction == (1.0, 0.0, 0.0)


def test_the_case_of_a_sweep_finds_its_own_direction(tmp_path: Path) -> None:
    sweep = '[analysis.sweep]\nkey = "bodies.wall.box.thickness"\nvalues = [0.2, 0.6]\n'
    made = study_of(tmp_path, HEAD, WALL.format(0.2, 0.4), mechanism_toml(), sweep)
    ways = [case.study.mechanisms[0].direction for case in made.sweeps[0].cases]
    assert ways == [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]


def test_a_sweep_of_a_body_beside_changes_the_mechanism(tmp_path: Path) -> None:
    building = box_toml("building", (4, 3, 3), (0, 1.65, 0))
    sweep = '[analysis.sweep]\nkey = "bodies.building.box.height"\nvalues = [0.1, 3]\n'
    made = study_of(tmp_path, HEAD, ALONG_Y, building, mechanism_toml(), sweep)
    assert [case.study.mechanisms[0].sides for case in made.sweeps[0].cases] == ["two", "one"]


def test_a_sensitivity_keeps_direction_and_sides(tmp_path: Path) -> None:
    building = box_toml("building", (4, 3, 3), (0, 1.65, 0))
    made = study_of(
        tmp_path, HEAD, ALONG_Y, building, mechanism_toml(), "[analysis]\nsensitivity = { thickness = 0.1 }\n"
    )
    variable = next(each for each in made.variables if each.parameter == "thickness")
    varied = variable.study_at(0.27).mechanisms[0]
    assert (varied.direction, varied.sides) == ((0.0, -1.0, 0.0), "one")
