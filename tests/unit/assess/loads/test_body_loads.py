"""Bodies as loads, from the project file to the oscillator, against hand calculation."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.cli.tables.project import description
from assess.errors import GeometryError, ProjectError
from assess.project.build import build
from assess.project.project_file import load
from assess.study.mechanism_results import parameters
from tests.support import projects
from tests.support.mesh_files import obj
from tests.support.projects import block, body_toml, project_toml, wall
from tests.support.vaults import barrel_section, groined_vault

PROJECT = project_toml(
    site=None,
    materials={
        "stone": {"density": 2000},
        "heavy": {"density": 10000},  # so that the walls stand whatever thrusts are put on them
        "timber": {"density": 500},
    },
    bodies={
        "front": wall(0.6, 5, 6, material="heavy", base=[3, 0, 0]),
        "rear": wall(0.6, 5, 6, material="heavy", base=[-3, 0, 0]),
    },
    mechanisms={"m": block("front", direction=[1, 0, 0], sides="one")},
)
FRONT = 10000 * 0.6 * 5 * 6
FLOOR = """[bodies.floor]
material = "timber"
box = { thickness = 5.8, length = 4, height = 0.2, base = [0, 0, 3] }
"""  # from -2.9 to 2.9: built in by 0.2 m at both ends
ROOF = """[bodies.roof]
material = "timber"
profile = [[-3.3, 6], [-3, 6], [0, 8.3], [3, 6], [3.3, 6], [0, 8.5]]
length = 5
"""


FLAT = """[bodies.roof]
material = "timber"
profile = [[-3.3, 6], [3.3, 6], [3.3, 6.2], [-3.3, 6.2]]
length = 5
"""


def study_of(folder: Path, bodies: str, *loads: str, mechanism: str = ""):
    listed = ", ".join(f'{{ kind = "body", {each} }}' for each in loads)
    text = f"{PROJECT}{mechanism}\nloads = [{listed}]\n{bodies}"
    if mechanism.startswith("direction"):
        text = text.replace("direction = [1, 0, 0]\n", "", 1)
    return projects.study_of(folder, text)


def loads_of(folder: Path, bodies: str, *loads: str, mechanism: str = ""):
    (found,) = study_of(folder, bodies, *loads, mechanism=mechanism).mechanisms
    return found.positive.loads


def texts(study) -> str:
    return "\n".join(notice.text for notice in study.messages if notice.where.startswith("mechanisms."))


def test_a_floor_built_into_two_walls_rests_with_half_its_weight_on_each(tmp_path):
    study = study_of(tmp_path, FLOOR, 'body = "floor"')
    (floor,) = study.mechanisms[0].positive.loads
    mass = 500 * (5.8 - 2 * 0.2) * 4 * 0.2  # the ends in the walls count as these
    assert (floor.name, floor.bearing) == ("floor", True)
    assert floor.mass == pytest.approx(mass / 2, rel=1e-9)
    np.testing.assert_allclose(floor.at, (2.8, 3.0), atol=1e-9)  # middle of the 0.2 m in the wall, its underside
    (result,) = parameters(study)
    resisting = FRONT * 0.3 + mass / 2 * 0.5
    driving = FRONT * 3.0 + mass / 2 * 3.0
    assert result.oscillator.uplift_multiplier == pytest.approx(resisting / driving, rel=1e-9)
    assert result.loads[0].mass_kg == floor.mass
    assert 'share 0.5 (statics; the rest on "rear")' in result.loads[0].source
    assert "bears on 0.8 m2" in result.loads[0].source
    assert "less 80 kg of it that lies in the block" in result.loads[0].source
    assert not texts(study)


def test_a_floor_that_spans_along_the_wall_only_pushes(tmp_path):
    beside = FLOOR.replace("thickness = 5.8", "thickness = 5.4")
    study = study_of(tmp_path, beside, 'body = "floor"')
    (floor,) = study.mechanisms[0].positive.loads
    assert not floor.bearing
    assert floor.mass == pytest.approx(500 * 5.4 * 4 * 0.2, rel=1e-9)
    np.testing.assert_allclose(floor.at, (2.7, 3.1), atol=1e-9)
    assert 'load "floor": nothing in the project carries its weight' in texts(study)
    ledges = """[bodies.ledge]
material = "stone"
box = { thickness = 5, length = 0.6, height = 3, base = [0, 1.8, 0] }
"""
    assert not texts(study_of(tmp_path, beside + ledges, 'body = "floor"'))


def test_numbers_of_the_user_override_what_is_found_and_both_are_told(tmp_path):
    own = 'body = "floor", share = 0.3, bearing = false, at = [2.5, 4.0], mass = "3 t"'
    (floor,) = loads_of(tmp_path, FLOOR, own)
    assert (floor.mass, floor.bearing, floor.at) == (pytest.approx(900.0), False, (2.5, 4.0))
    assert "place given (its contact is at x = 2.8 m, z = 3 m)" in floor.source
    assert "3000 kg (given; by its table 2320 kg)" in floor.source
    assert "share 0.3 (given; by statics 0.5)" in floor.source
    assert "only pushes (given; by its contact it bears on 0.8 m2)" in floor.source


def test_a_floor_on_nothing_else_is_carried_whole_with_a_warning(tmp_path):
    short = FLOOR.replace("thickness = 5.8", "thickness = 1.0").replace("[0, 0, 3]", "[2.4, 0, 3]")
    study = study_of(tmp_path, short, 'body = "floor"')
    assert study.mechanisms[0].positive.loads[0].mass == pytest.approx(500 * 0.8 * 4 * 0.2, rel=1e-9)
    assert 'load "floor": nothing else in the project carries it, so its whole weight is on the block' in texts(study)
    assert 'bodies "front" and "floor" overlap by 0.16 m3, 20 % of the smaller one' in texts(study)


def test_a_gable_roof_thrusts_by_W_L_over_8_f(tmp_path):
    own = 'body = "roof", role = "roof", span = 6, rise = "2.3 m"'
    mass, thrust = loads_of(tmp_path, ROOF, own)
    W = 500 * 5 * 0.5 * 2.5 * 6.6 * g - 500 * 5 * 0.5 * 2.3 * 6.0 * g
    assert (mass.bearing, mass.mass) == (True, pytest.approx(W / g / 2, rel=1e-9))
    assert thrust.force == (pytest.approx(W * 6 / (8 * 2.3), rel=1e-9), 0.0)
    assert thrust.at == mass.at == pytest.approx((3.15, 6.0), abs=1e-6)
    assert "H = V x / f" in thrust.source
    assert "L = 6 m (given); f = 2.3 m (given)" in thrust.source
    found = loads_of(tmp_path, ROOF, 'body = "roof", role = "roof"')[1]
    assert found.force[0] == pytest.approx(W * 6.6 / (8 * 2.5), rel=1e-9)
    assert "L = 6.6 m (found); f = 2.5 m (found)" in found.source


def test_a_roof_thrusts_outwards_whichever_way_the_motion_goes(tmp_path):
    own = 'body = "roof", role = "roof"'
    one = loads_of(tmp_path, ROOF, own)[1]
    other = loads_of(tmp_path, ROOF, own, mechanism="direction = [-2, 0, 0]")[1]
    assert other.force == (pytest.approx(-one.force[0], rel=1e-12), 0.0)
    assert other.at == (pytest.approx(-one.at[0], rel=1e-12), one.at[1])
    askew = loads_of(tmp_path, ROOF, own, mechanism="direction = [4, 3, 0]")[1]
    assert askew.force[0] == pytest.approx(0.8 * one.force[0], rel=1e-9)
    assert " N along the motion" in askew.source


@pytest.mark.parametrize(
    ("keys", "bodies", "mechanism", "words"),
    [
        ("tied = true", ROOF, "", "tied (given)"),
        ("bearing = false", ROOF, "", "does not stand on the block"),
        ("", ROOF, "direction = [0, 1, 0]\nrestitution = 0.9", "its ridge runs that way"),
        ("", FLAT, "", "it is flat or slopes one way only"),
        ("", FLAT.replace("6.2]]", "7]]"), "", "it is flat or slopes one way only"),
    ],
)
def test_why_a_roof_has_no_thrust_is_told(tmp_path, keys, bodies, mechanism, words):
    loads = loads_of(
        tmp_path, bodies, f'body = "roof", role = "roof"{", " + keys if keys else ""}', mechanism=mechanism
    )
    assert [load.name for load in loads] == ["roof"]
    assert "no thrust" in loads[0].source
    assert words in loads[0].source


def test_a_thrust_of_the_user_stands_in_its_place(tmp_path):
    mass, thrust = loads_of(tmp_path, ROOF, 'body = "roof", role = "roof", thrust = "41 kN", share = 0.25')
    assert thrust.force == (41e3, 0.0)
    assert "thrust (given)" in thrust.source
    assert "share 0.25 (given; by statics 0.5)" in mass.source


def test_a_roof_with_one_foot_in_the_project_stands_with_half_on_the_block(tmp_path):
    moved = ROOF.replace("[[-3.3, 6], [-3, 6], [0, 8.3], [3, 6], [3.3, 6], [0, 8.5]]",
                         "[[2.7, 6], [3, 6], [6, 8.3], [9, 6], [9.3, 6], [6, 8.5]]")  # fmt: skip
    study = study_of(tmp_path, moved, 'body = "roof", role = "roof"')
    mass, thrust = study.mechanisms[0].positive.loads
    W = 500 * 5 * 0.5 * (2.5 * 6.6 - 2.3 * 6.0) * g
    assert mass.mass == pytest.approx(W / g / 2, rel=1e-9)
    assert thrust.force[0] == pytest.approx(-W * 6.6 / (8 * 2.5), rel=1e-9)  # the roof lies before the wall
    assert "half of it is taken" in texts(study)


SECTION = barrel_section(radius=2.85, thickness=0.3, springing=6.0, parts=120).round(12).tolist()
BARREL = body_toml("vault", f"profile = {SECTION}\nlength = 5", material="stone")


def test_a_barrel_vault_by_equilibrium_of_its_half(tmp_path):
    """Half a semicircular ring of radii a, b: weight W / 2, centroid 4/(3 pi) (b^3 - a^3)/(b^2 - a^2) off the crown."""
    a, b = 2.7, 3.0
    W = 2000 * g * 5 * np.pi / 2 * (b**2 - a**2)
    lever = b - 4 / (3 * np.pi) * (b**3 - a**3) / (b**2 - a**2)
    mass, thrust = loads_of(tmp_path, BARREL, 'body = "vault", role = "vault", tied = false')
    assert mass.mass * g == pytest.approx(W / 2, rel=5e-4)  # 120 chords stand for the circle
    assert mass.at == pytest.approx((2.85, 6.0), abs=1e-9)
    assert thrust.force[0] == pytest.approx(W / 2 * lever / b, rel=1e-3)
    (even,) = re.findall(r"L / 4 would give (\S+) N", thrust.source)
    assert float(even) == pytest.approx(W * 6.0 / (8 * 3.0), rel=1e-3)
    along = loads_of(tmp_path, BARREL, 'body = "vault", role = "vault"', mechanism="direction = [0, 1, 0]")
    assert [load.name for load in along] == ["vault"]


@pytest.mark.parametrize(("case", "thickness", "density"), [(1, 0.125, 1300), (4, 0.25, 1800), (5, 0.3, 2200)])
def test_a_vault_by_ungewitters_constructions_and_fill(tmp_path, case, thickness, density):
    keys = f'body = "vault", role = "vault", construction = {case}, fill = "100 kg/m^2"'
    mass, thrust = loads_of(tmp_path, BARREL, keys)
    shell, fill = thickness * density * np.pi * 2.7 * 5, 100 * 5.4 * 5
    assert mass.mass == pytest.approx((shell + fill) / 2, rel=1e-3)
    assert f"Ungewitter's case {case}" in mass.source
    ring = 3.0 - 4 / (3 * np.pi) * (3.0**3 - 2.7**3) / (3.0**2 - 2.7**2)
    H = g / 2 * (shell * ring + fill * 6.0 / 4) / 3.0
    assert thrust.force[0] == pytest.approx(H, rel=2e-3)


def test_a_quadripartite_vault_thrusts_along_either_motion_from_its_upright_edges(tmp_path):
    surface = groined_vault(span=5.4, springing=3, thickness=0.15)  # from wall to wall, its edges upright
    (tmp_path / "vault.obj").write_bytes(obj(*surface))
    vault = body_toml("vault", 'mesh = "vault.obj"', material="stone")
    mass, thrust = loads_of(tmp_path, vault, 'body = "vault", role = "vault"')
    W = 2000 * 5.4**2 * 0.15 * g  # its thickness is measured upright: spread evenly over the plan
    assert mass.bearing
    assert mass.mass * g == pytest.approx(W / 2, rel=1e-6)
    assert thrust.force[0] == pytest.approx(W * 5.4 / (8 * 2.15), rel=1e-6)
    barrel_like = loads_of(tmp_path, vault, 'body = "vault", role = "vault", vault = "barrel"')
    assert barrel_like[0].mass == pytest.approx(mass.mass, rel=1e-9)


@pytest.mark.parametrize(
    ("bodies", "loads", "words"),
    [
        (
            FLOOR.replace("5.8", "4.0"),
            ['body = "floor"'],
            r'm\.loads\[1\]: load "floor" touches nothing.* 0\.7 m away',
        ),
        (FLOOR.replace("[0, 0, 3]", "[0, 0, 6.3]"), ['body = "floor"'], r"0\.3 m away; move it, or raise `tolerance`"),
        ("[bodies.d]\nmass = 9\ncentroid = [1, 2]\ninertia = 1\n", ['body = "d"'], "it has no geometry"),
        ("[bodies.d]\nmass = 9\ncentroid = [1, 2]\ninertia = 1\n", ['body = "d", role = "roof"'], "no geometry, from"),
        (
            FLOOR
            + '[bodies.lid]\nmaterial = "stone"\nbox = { thickness = 6.6, length = 5, height = 0.2, base = [0,0,6] }\n',
            ['body = "lid", role = "roof", thrust = "1 kN", at = [0, 6.0]'],
            "which way is outwards",
        ),
    ],
)
def test_what_cannot_load_the_block_is_an_error_by_name(tmp_path, bodies, loads, words):
    with pytest.raises(GeometryError, match=words) as refused:
        study_of(tmp_path, bodies, *loads)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("loads", "words"),
    [
        (['body = "front"'], r"m\.loads\[1\]\.body.*part of a block"),
        (['body = "floor"', 'body = "floor"'], r"m\.loads\[2\]\.body.*already"),
        (['body = "flor"'], "no such body; known"),
        (['body = "floor", rise = 1'], r"rise: 1: only a roof or a vault"),
        (['body = "floor", role = "roof", fill = 100'], "only of a vault"),
        (['body = "floor", role = "vault", construction = 6'], "must be 5 or less"),
        (['body = "floor", role = "vault", construction = 2, mass = 5'], "beside mass"),
        (['body = "floor", role = "roof", tied = true, thrust = 5'], "beside thrust"),
        (['body = "floor", share = 1.5'], "must be 1 or less"),
        (['body = "floor", role = "dome"'], "not allowed"),
    ],
)
def test_wrong_keys_are_refused_in_one_line(tmp_path, loads, words):
    with pytest.raises(ProjectError, match=words):
        study_of(tmp_path, FLOOR, *loads)


def test_direct_values_and_floors_that_touch_nothing_can_be_placed_by_hand(tmp_path):
    direct = "[bodies.d]\nmass = 900\ncentroid = [1, 2]\ninertia = 1\n"
    (mass,) = loads_of(tmp_path, direct, 'body = "d", at = [3, 0, 5], bearing = true')
    assert (mass.mass, mass.at, mass.bearing) == (900.0, (3.0, 5.0), True)
    (far,) = loads_of(
        tmp_path, FLOOR.replace("5.8", "4.0"), 'body = "floor", at = [2.7, 3], bearing = true, share = 0.5'
    )
    assert far.mass == pytest.approx(500 * 4 * 4 * 0.2 / 2, rel=1e-9)


def test_only_what_is_left_above_a_cut_is_touched(tmp_path):
    (floor,) = loads_of(tmp_path, FLOOR, 'body = "floor"', mechanism="cut = 2")
    assert floor.at == pytest.approx((2.8, 3.0), abs=1e-9)
    with pytest.raises(GeometryError, match="touches nothing of the block"):
        loads_of(tmp_path, FLOOR, 'body = "floor"', mechanism="cut = 4")


def test_a_load_in_the_air_is_pointed_out(tmp_path):
    study = study_of(tmp_path, FLOOR, 'body = "floor", at = [0, 3]')
    assert 'load "floor" at x = 0 m, z = 3 m is in the air, 2.7 m from the block' in texts(study)
    assert "in the air" not in texts(study_of(tmp_path, FLOOR, 'body = "floor"'))


def sloping(gap: float) -> str:
    """Return rafters that slope by 0.7 over flat wall tops, a gap above the outer edge of the front one."""
    under, over = [-3.3, 6.0, 0.0, 8.31, 3.3, 6.0 + gap], [3.3, 6.2 + gap, 0.0, 8.51, -3.3, 6.2]
    points = [list(each) for each in zip((*under, *over)[::2], (*under, *over)[1::2], strict=True)]
    return f'[bodies.roof]\nmaterial = "timber"\nprofile = {points}\nlength = 5\n'


@pytest.mark.parametrize("tolerance", ["1.05 cm", "10 cm", "30 cm"])
def test_the_share_of_a_roof_does_not_hang_on_the_tolerance(tmp_path, tolerance):
    """Both feet bear in strips of one width, 0.01 / 0.7, at the outer edges, so that each wall carries half.

    Cross walls with flat tops that the rafters leave at once are there too: they get what their strips let them have.
    """
    cross = "".join(
        f"[bodies.{name}]\nmaterial = 'stone'\n"
        f"box = {{ thickness = 5.4, length = 0.4, height = 6, base = [0, {y}, 0] }}\n"
        for name, y in (("left", -2.3), ("right", 2.3))
    )
    keys = f'body = "roof", role = "roof", tied = true, tolerance = "{tolerance}"'
    (load,) = loads_of(tmp_path, sloping(0.0094), keys)
    whole = 500 * 5 * 0.2 * 6.6
    assert load.mass / whole == pytest.approx(0.5, rel=5e-3)
    assert load.at == pytest.approx((3.3 - 0.01 / 0.7 / 2, 6.0), abs=1e-4)
    (braced,) = loads_of(tmp_path, sloping(0.0094) + cross, keys)
    assert braced.mass == pytest.approx(load.mass, rel=0.02)


def test_a_share_that_hangs_on_how_wide_an_edge_bears_is_asked_for(tmp_path):
    """Rafters bear on the walls along an edge and on a cross gable flat: how much on which hangs on the strip."""
    profile = "profile = [[-2.7, 0], [2.7, 0], [2.7, 6.42], [0, 8.31], [-2.7, 6.42]]"
    gables = f'[bodies.gable]\nmaterial = "stone"\n{profile}\nlength = 0.4\n'
    keys = 'body = "roof", role = "roof", tied = true'
    asked = "of its weight is on the block as drawn, yet"
    assert asked in texts(study_of(tmp_path, sloping(0.0) + gables, keys))
    assert asked not in texts(study_of(tmp_path, sloping(0.0) + gables, keys + ", share = 0.3"))
    assert asked not in texts(study_of(tmp_path, sloping(0.0), keys))


def test_what_loads_share_counts_once_and_is_pointed_out(tmp_path):
    """A slab of 0.2 m half within the floor below it weighs by its upper half; one wholly within it is no load.

    Of both the ends in the wall, 0.2 m of 5.8 m, count as masonry.
    """
    second = FLOOR.replace("bodies.floor", "bodies.slab").replace("[0, 0, 3]", "[0, 0, 3.1]")
    study = study_of(tmp_path, FLOOR + second, 'body = "floor"', 'body = "slab", share = 0.5')
    assert 'bodies "floor" and "slab" overlap by 2.32 m3' in texts(study)
    floor, slab = study.mechanisms[0].positive.loads
    assert (floor.mass, slab.mass) == pytest.approx((500 * 5.4 * 4 * 0.2 / 2, 500 * 5.4 * 4 * 0.1 / 2), rel=1e-9)
    assert "50 % of it, as loads before it count" in slab.source
    stated = study_of(tmp_path, FLOOR + second, 'body = "floor"', 'body = "slab", share = 0.5, mass = "1000 kg"')
    assert stated.mechanisms[0].positive.loads[1].mass == pytest.approx(500.0, rel=1e-9)
    again = FLOOR.replace("bodies.floor", "bodies.slab")
    (only,) = study_of(tmp_path, FLOOR + again, 'body = "floor"', 'body = "slab"').mechanisms[0].positive.loads
    assert only.name == "floor"


@pytest.mark.parametrize("into", [0.2, 0.6])
def test_what_a_slab_shares_with_its_wall_counts_once(tmp_path, into):
    """A slab as heavy as the wall makes no more of the two than there is, however far it is drawn into it."""
    long = FLOOR.replace("timber", "heavy").replace("thickness = 5.8", f"thickness = {5.4 + 2 * into}")
    study = study_of(tmp_path, long, 'body = "floor"')
    (floor,) = study.mechanisms[0].positive.loads
    assert floor.mass == pytest.approx(10000 * 2.7 * 4 * 0.2, rel=1e-9)
    assert "overlap" not in texts(study)


def test_a_roof_that_lies_within_another_load_keeps_its_thrust(tmp_path):
    """What two drawings share weighs once; the thrust of neither goes, as no overlap holds a wall."""
    again = ROOF.replace("bodies.roof", "bodies.cover")
    entries = [f'body = "{name}", role = "roof", span = 6, rise = "2.3 m", share = 0.5' for name in ("roof", "cover")]
    loads = study_of(tmp_path, ROOF + again, *entries).mechanisms[0].positive.loads
    assert [load.name for load in loads] == ["roof", "roof (thrust)", "cover (thrust)"]
    assert loads[1].force == pytest.approx(loads[2].force, rel=1e-9)


def test_a_body_that_stands_where_the_block_does_carries_nothing(tmp_path):
    other = """[bodies."front as it was"]
material = "stone"
box = { thickness = 0.5, length = 5, height = 6, base = [3, 0, 0] }
"""
    study = study_of(tmp_path, FLOOR + other, 'body = "floor"')
    assert study.mechanisms[0].positive.loads[0].mass == pytest.approx(500 * 5.4 * 4 * 0.2 / 2, rel=1e-9)
    assert 'body "front as it was" stands where the block does' in texts(study)


def test_a_floor_that_would_lift_off_is_refused(tmp_path):
    """Its centroid lies 0.4 m beyond a pier, as seen from the wall."""
    pier = '[bodies.pier]\nmaterial = "stone"\nbox = { thickness = 0.4, length = 4, height = 3, base = [0.8, 0, 0] }\n'
    slab = FLOOR.replace("thickness = 5.8", "thickness = 5.0").replace("[0, 0, 3]", "[0.4, 0, 3]")
    with pytest.raises(GeometryError, match='load "floor": by statics it lifts off the block'):
        study_of(tmp_path, slab + pier, 'body = "floor"')
    (floor,) = loads_of(tmp_path, slab + pier, 'body = "floor", share = 0.3')
    assert "share 0.3 (given; by statics none)" in floor.source


def test_hostile_names_appear_as_text(tmp_path):
    name = "<b>&floor\\u0007 $x$ =cmd()\\n"
    hostile = FLOOR.replace("bodies.floor", f'bodies."{name}"')
    study = study_of(tmp_path, hostile, f'body = "{name}"')
    shown = description(load(tmp_path), parameters(study), (), study.messages)
    assert "<b>&floor\\x07 $x$ =cmd()\\n at x = 2.8 m" in shown
    assert all(line.isprintable() for line in shown.splitlines())


def test_a_wall_that_a_thrust_overturns_falls_at_rest(tmp_path):
    (falling,) = study_of(tmp_path, ROOF, 'body = "roof", role = "roof", thrust = "400 kN"').falling
    assert 'load "roof (thrust)" with H = 400 kN, V = +0 kN up (thrust (given); outwards)' in falling.reason
    assert falling.uplift_multiplier < 0.0


def test_a_floor_on_the_upper_block_of_a_cracked_wall(tmp_path):
    on_top = FLOOR.replace("[0, 0, 3]", "[0, 0, 6]")
    masses = []
    for loads in ("[]", '[{ kind = "body", body = "floor", block = 1 }]'):
        text = f"{PROJECT}crack = 2.5\nloads = {loads}\n{on_top}"
        (tmp_path / "project.toml").write_text(text.replace("single-block", "two-block"))
        (result,) = parameters(build(load(tmp_path)))
        masses.append(result.oscillator.mass_kg)
    (floor,) = result.loads
    assert (floor.block, floor.bearing, floor.at) == (1, True, (pytest.approx(2.8), pytest.approx(6.0)))
    assert masses[1] - masses[0] == pytest.approx(500 * 5.8 * 4 * 0.2 / 2, rel=1e-9)


def test_a_tie_anchored_where_it_holds_is_refused(tmp_path):
    tie = 'loads = [{ kind = "tie", force = "5 kN", at = [3, 0, 5], anchor = [3, 2, 5] }]'
    (tmp_path / "project.toml").write_text(PROJECT + tie)
    with pytest.raises(GeometryError, match=r"m\.loads\[1\]\.anchor: seen in the plane of motion"):
        build(load(tmp_path))


def test_a_tie_anchored_on_what_moves_is_told(tmp_path):
    tie = 'loads = [{{ kind = "tie", force = "5 kN", at = [3, 0, 5], anchor = [{}, 0, 4] }}]'
    for x, told in ((2.9, True), (0.0, False)):  # within the wall, on the ground behind it
        (tmp_path / "project.toml").write_text(PROJECT + tie.format(x))
        said = texts(build(load(tmp_path)))
        assert ('"tie 1": its anchor at x = 2.9 m, z = 4 m lies on block 0, which moves too' in said) is told
