"""The weakest direction: closed forms of prisms on polygons, and what cannot be sought."""

from pathlib import Path

import numpy as np
import pytest
import trimesh

from assess.errors import MechanismError, ProjectError
from assess.geometry.contact import find_contact
from assess.loads import bearing
from assess.mechanisms.chain import uplift_multiplier
from assess.mechanisms.directions import DirectionSweep
from assess.project.build import build
from assess.project.project_file import load
from assess.study.mechanism_results import parameters
from tests.support.projects import block, mechanism_of, project_toml, study_of

HEIGHT = 10.0
SQUARE = "box = { thickness = 3, length = 3, height = 10 }"


def swept(body: str, mechanism: str = "") -> str:
    """A project of one tower, by the TOML of its body and of what its mechanism has beside a swept direction."""
    return project_toml(
        mechanism,
        site=None,
        materials={"m": {"density": 2000}},
        bodies={"tower": f'material = "m"\n{body}'},
        mechanisms={"tower": block("tower", direction="sweep")},
    )


def sought(folder: Path, body: str, mechanism: str = "") -> DirectionSweep:
    found = mechanism_of(folder, swept(body, mechanism)).directions
    assert found is not None
    return found


def prism(folder: Path, corners: np.ndarray) -> str:
    """A prism on a polygon [n, 2], as a mesh file."""
    sides = len(corners)
    hull = trimesh.convex.convex_hull(
        np.concatenate([np.column_stack([corners, np.full(sides, z)]) for z in (0.0, HEIGHT)])
    )
    hull.export(folder / "body.obj", digits=17)
    return 'mesh = "body.obj"'


def regular(sides: int, *, turned: float = 0.0) -> np.ndarray:
    at = 2.0 * np.pi * np.arange(sides) / sides + turned
    return 1.5 * np.column_stack([np.cos(at), np.sin(at)])


def test_a_square_tower_is_weakest_across_a_face(tmp_path: Path) -> None:
    found = sought(tmp_path, SQUARE)
    assert found.weakest_deg == 0.0  # of four equal ones the smallest
    assert min(found.uplift_multiplier) == pytest.approx(1.5 / 5.0, rel=1e-12)  # b / 2 over the centroid's height
    at = np.radians(found.angle_deg)
    support = 1.5 * (np.abs(np.cos(at)) + np.abs(np.sin(at)))
    np.testing.assert_allclose(found.uplift_multiplier, support / 5.0, rtol=1e-12)
    assert found.variation == pytest.approx(1.0 - np.sqrt(0.5), rel=1e-9)


def test_one_percent_of_a_square_is_eight_times_its_closed_form(tmp_path: Path) -> None:
    # cos(a) + sin(a) = 1.01 at a = 0.579 deg, on both sides of four directions; the lines between 5 deg are near it
    assert sought(tmp_path, SQUARE).flat_deg == pytest.approx(8 * 0.579, abs=0.5)


def test_a_wall_is_weakest_across_its_thickness(tmp_path: Path) -> None:
    found = sought(tmp_path, "box = { thickness = 4, length = 0.5, height = 10 }")
    assert found.weakest_deg == 90.0
    assert min(found.uplift_multiplier) == pytest.approx(0.25 / 5.0, rel=1e-12)


def test_the_chosen_direction_is_the_mechanisms(tmp_path: Path) -> None:
    body = "box = { thickness = 4, length = 0.5, height = 10, base = [1, 2, 0] }"
    mechanism = mechanism_of(tmp_path, swept(body))
    text = swept(body).replace('"sweep"', "[0, 1, 0]")
    study = study_of(tmp_path, text)
    assert study.mechanisms[0].positive == mechanism.positive
    assert study.mechanisms[0].directions is None


def test_a_turned_tower_is_weakest_where_its_face_looks(tmp_path: Path) -> None:
    found = sought(tmp_path, prism(tmp_path, regular(4, turned=np.radians(17.3))))
    assert found.weakest_deg == pytest.approx(17.3 + 45.0, abs=1e-9)
    assert min(found.uplift_multiplier) == pytest.approx(1.5 * np.cos(np.pi / 4) / 5.0, rel=1e-9)


def test_a_round_tower_is_flat(tmp_path: Path) -> None:
    mechanism = mechanism_of(tmp_path, swept(prism(tmp_path, regular(64))))
    found = mechanism.directions
    assert found is not None
    assert found.variation <= 1.0 - np.cos(np.pi / 64) + 1e-12
    assert min(found.uplift_multiplier) == pytest.approx(1.5 * np.cos(np.pi / 64) / 5.0, rel=1e-9)
    assert found.flat_deg == pytest.approx(360.0)
    assert not any("askew" in text for text in map(str, mechanism.warnings))


def test_a_triangle_is_weakest_across_an_edge_and_strongest_towards_a_corner(tmp_path: Path) -> None:
    found = sought(tmp_path, prism(tmp_path, regular(3)))
    assert found.weakest_deg == pytest.approx(60.0, abs=1e-9)
    assert min(found.uplift_multiplier) == pytest.approx(0.75 / 5.0, rel=1e-9)
    assert max(found.uplift_multiplier) == pytest.approx(1.5 / 5.0, rel=1e-9)
    assert found.variation == pytest.approx(0.5, rel=1e-9)


def test_a_leaning_tower_falls_the_way_it_leans(tmp_path: Path) -> None:
    found = sought(tmp_path, "profile = [[0, 0], [3, 0], [2.4, 10], [-0.6, 10]]\nlength = 4")
    assert found.weakest_deg == 180.0  # the centroid stands at 1.2, nearer to the edge at 0
    assert min(found.uplift_multiplier) == pytest.approx(1.2 / 5.0, rel=1e-9)


def test_loads_count_in_every_direction(tmp_path: Path) -> None:
    mass = 0.1 * 2000 * 3 * 3 * 10
    found = sought(tmp_path, SQUARE, f"loads = [{{ kind = 'mass', mass = {mass}, at = [0, -1.5, 10] }}]")
    assert found.weakest_deg == 270.0
    assert min(found.uplift_multiplier) == pytest.approx((1.5 - 0.1 * 0.0) / (5.0 + 0.1 * 10.0), rel=1e-12)


def test_a_floor_counts_in_every_direction_and_is_met_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It bears on 0.5 m of the top, beside one face; where it meets the tower does not turn with the direction."""
    met = []
    monkeypatch.setattr(
        bearing, "find_contact", lambda block, body, **more: met.append(body.name) or find_contact(block, body, **more)
    )
    floor = "[bodies.floor]\nmaterial = 'm'\nbox = { thickness = 4, length = 3, height = 0.5, base = [3, 0, 10] }"
    found = sought(tmp_path, SQUARE, f"sides = 'one'\nloads = [{{ kind = 'body', body = 'floor' }}]\n{floor}")
    readings = 3  # of its contact: as drawn, with bodies farther apart, with a thicker joint
    assert met.count("floor") <= 2 * readings  # while seeking, and for the mechanism in the direction that was chosen
    at = np.radians(found.angle_deg)
    tower, laid = 3 * 3 * 10, 4 * 3 * 0.5
    resisting = (tower + laid) * 1.5 * (np.abs(np.cos(at)) + np.abs(np.sin(at))) - laid * 1.25 * np.cos(at)
    np.testing.assert_allclose(found.uplift_multiplier, resisting / (tower * 5 + laid * 10), rtol=1e-9)


def least_by_brute_force(body: trimesh.Trimesh, normal: np.ndarray) -> float:
    """The least multiplier over 7200 directions of what lies above a plane through (0, 0, 3), cut by trimesh."""
    part = body.slice_plane([0, 0, 3], normal, cap=True)
    foot = part.vertices[np.abs((part.vertices - [0, 0, 3]) @ normal) < 1e-9]
    at = np.radians(np.arange(0.0, 360.0, 0.05))
    along = np.array([np.cos(at), np.sin(at)])
    reach, behind = foot[:, :2] @ along, part.center_mass[:2] @ along
    hinge = reach.argmax(axis=0)
    return float(((reach.max(axis=0) - behind) / (part.center_mass[2] - foot[hinge, 2])).min())


@pytest.mark.parametrize("tilt", [(0.0, 0.0), (0.3, -0.2), (-0.45, 0.1), (0.2, 0.4)])
@pytest.mark.parametrize("seed", [1, 2])
def test_the_weakest_of_bodies_of_chance_by_brute_force(tmp_path: Path, tilt: tuple[float, float], seed: int) -> None:
    """Above an inclined plane the hinge jumps in elevation from corner to corner."""
    rng = np.random.default_rng(seed)
    low, high = rng.uniform(-2, 2, (9, 2)), rng.uniform(-1, 1, (7, 2))
    body = trimesh.convex.convex_hull(
        np.concatenate([np.column_stack([low, np.zeros(9)]), np.column_stack([high, np.full(7, 8.0)])])
    )
    body.export(tmp_path / "body.obj", digits=17)
    normal = np.array([*tilt, 1.0])
    cut = f"cut = {{ point = [0, 0, 3], normal = {normal.tolist()} }}\nsides = 'one'"
    mechanism = mechanism_of(tmp_path, swept('mesh = "body.obj"', cut))
    found = mechanism.directions
    assert found is not None
    assert any("turns about one corner" in text for text in map(str, mechanism.warnings)) == any(tilt)
    least = least_by_brute_force(body, normal / np.linalg.norm(normal))
    assert min(found.uplift_multiplier) == pytest.approx(least, rel=2e-3)  # a step of 0.05 deg beside a corner


@pytest.mark.parametrize("cut", ["cut = 4", "cut = { point = [0, 0, 4], normal = [0, 0, 1] }"])
def test_what_lies_above_a_cut_is_looked_at(tmp_path: Path, cut: str) -> None:
    found = sought(tmp_path, SQUARE, cut)
    assert found.weakest_deg == 0.0
    assert min(found.uplift_multiplier) == pytest.approx(1.5 / 3.0, rel=1e-12)


def test_a_crack_given_by_its_angle_turns_with_the_direction(tmp_path: Path) -> None:
    found = sought(tmp_path, SQUARE, 'cut = { point = [0, 0, 4], angle = "20 deg" }\nsides = "one"')
    quarter = len(found.uplift_multiplier) // 4
    turned = np.roll(found.uplift_multiplier, -quarter)  # a square is the same after a quarter turn
    np.testing.assert_allclose(found.uplift_multiplier, turned, rtol=1e-9)
    assert found.weakest_deg % 90.0 == 0.0


CRACKED = """cut = { point = [X, 0, 4], angle = "60 deg" }
sides = "one"
direction = [1, 0, 0]"""


@pytest.mark.parametrize("x", [1.5, 0.0])
def test_a_crack_begins_at_the_same_height_towards_every_face(tmp_path: Path, x: float) -> None:
    """Left in space it would leave a square tower through its foot in the other directions, and stand on nothing."""
    body = f'material = "m"\n{SQUARE}'
    text = project_toml(
        site=None,
        materials={"m": {"density": 2000}},
        bodies={"tower": body},
        mechanisms={"tower": f'kind = "single-block"\nblocks = ["tower"]\n{CRACKED.replace("X", str(x))}'},
    )
    study = study_of(tmp_path, text)
    (found,) = study.mechanisms
    values = [each.uplift_multiplier for each in found.candidates]
    assert len(values) == 4
    assert values == pytest.approx([values[0]] * 4, rel=1e-9)
    assert found.weaker is None


def test_a_weaker_direction_names_where_the_crack_begins_there(tmp_path: Path) -> None:
    """Of a shaft of 2 by 4 m the narrow way is the weaker; the crack goes on at 5 m, on the face ahead."""
    body = 'material = "m"\nbox = { thickness = 2, length = 4, height = 10 }'
    mechanism = (
        'kind = "single-block"\nblocks = ["tower"]\nsides = "one"\ndirection = [0, 1, 0]\n'
        'cut = { point = [0, 2, 5], angle = "45 deg" }'
    )
    text = project_toml(
        site=None, materials={"m": {"density": 2000}}, bodies={"tower": body}, mechanisms={"tower": mechanism}
    )
    study = study_of(tmp_path, text)
    (found,) = study.mechanisms
    assert found.weaker == pytest.approx((1.0, 0.0, 0.0))
    assert found.weaker_crack == pytest.approx((1.0, 0.0, 5.0))
    (value,) = (each for each in study.replaceables if each.key.endswith("direction"))
    assert value.setting[("mechanisms", "tower", "cut", "point")] == pytest.approx([1.0, 0.0, 5.0])
    (there,) = value.study_at("tower").mechanisms
    least = min(each.uplift_multiplier for each in found.candidates)
    assert uplift_multiplier(there.positive) == pytest.approx(least, rel=1e-9)


def test_the_parameters_are_those_of_the_mechanism_towards_each_angle(tmp_path: Path) -> None:
    body = "box = { thickness = 2, length = 3, height = 10 }"
    found = sought(tmp_path, body)
    text = swept(body).replace('"sweep"', "[0.5, 0.8660254037844386, 0]")
    one = parameters(study_of(tmp_path, text))[0].oscillator
    place = found.angle_deg.index(60.0)
    assert found.p_eq_per_s[place] == pytest.approx(one.p_eq_per_s, rel=1e-12)
    assert found.overturning_rad[place] == pytest.approx(one.overturning_rad, rel=1e-12)
    assert found.uplift_multiplier[place] == pytest.approx(one.uplift_multiplier, rel=1e-12)


@pytest.mark.parametrize(
    ("mechanism", "words"),
    [
        ("hinges = { A = [1.5, 0] }", r"mechanisms\.tower\.hinges\.A: .*two numbers depend on the direction"),
        ("loads = [{ kind = 'mass', mass = 9, at = [0, 9] }]", r"mechanisms\.tower\.loads\[1\]\.at: .*two numbers"),
        ("loads = [{ kind = 'force', force = [9, 0], at = [0, 0, 9] }]", r"loads\[1\]\.force: .*two numbers"),
        (
            "loads = [{ kind = 'tie', force = 9, at = [0, 0, 9], anchor = [9, 9] }]",
            r"loads\[1\]\.anchor: .*two numbers",
        ),
        ("cut = { point = [0, 0, 4], angle = 0.2, normal = [0, 0, 1] }", r"cut\.angle: .*beside normal"),
        ("cut = { point = [0, 0, 4], angle = '90 deg' }", r"cut\.angle: \"90 deg\": not between"),
        ("cut = { point = [0, 0, 4] }", r"cut\.normal: missing; .*or give angle"),
    ],
)
def test_what_depends_on_the_direction_is_refused_by_key(tmp_path: Path, mechanism: str, words: str) -> None:
    with pytest.raises(ProjectError, match=words) as caught:
        mechanism_of(tmp_path, swept(SQUARE, mechanism))
    assert "\n" not in str(caught.value)


def test_a_word_that_is_no_direction_is_refused(tmp_path: Path) -> None:
    (tmp_path / "project.toml").write_text(swept(SQUARE).replace('"sweep"', '"north"'))
    with pytest.raises(ProjectError, match=r'direction: "north": not a direction; .* "sweep" for the weakest'):
        load(tmp_path)


def test_a_body_without_geometry_has_no_other_direction(tmp_path: Path) -> None:
    text = swept("").replace('material = "m"', "mass = 9\ncentroid = [0, 2]\ninertia = 9")
    (tmp_path / "project.toml").write_text(text)
    with pytest.raises(MechanismError, match=r'direction = "sweep": body "tower" has no geometry'):
        build(load(tmp_path))


def test_a_direction_in_which_it_falls_by_itself_is_named(tmp_path: Path) -> None:
    body = "profile = [[0, 0], [1, 0], [-1, 10], [-2, 10]]\nlength = 4"
    (falling,) = study_of(tmp_path, swept(body)).falling
    assert falling.reason.endswith('(direction = "sweep", here 0 deg from +x)')
