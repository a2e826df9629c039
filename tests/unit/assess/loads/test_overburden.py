"""What presses on a wall of two blocks: by numbers and by the bodies that stand on it."""

from __future__ import annotations

from math import atan2

import pytest
from scipy.constants import g

from assess.errors import GeometryError, MechanismError, ProjectError
from tests.support.projects import block, lines, mechanism_of, project_toml, study_of, wall

PROJECT = project_toml(
    site=None,
    materials={"m": {"density": 1800}},
    bodies={
        "wall": wall(0.4, 3, 4, material="m"),
        "other": wall(0.4, 3, 4, material="m", base=[5, 0, 0]),
        "floor": wall(5.1, 3, 0.2, material="m", base=[2.55, 0, 4]),
    },
    mechanisms={"wall": block(kind="two-block", direction=[1, 0, 0])},
)


def test_a_floor_on_two_walls_brings_its_half_where_it_bears(tmp_path):
    wall = mechanism_of(tmp_path, PROJECT, 'loads = [{ kind = "overburden", bodies = ["floor"] }]')
    (force,) = wall.positive.loads
    contact = 0.1  # it covers 0 to 0.2 m of the wall, and 4.8 to 5.1 m of the other
    far = (4.8 + 5.1) / 2
    weight = 1800 * 5.1 * 3 * 0.2 * g
    assert force.force[1] == pytest.approx(-weight * (far - 2.55) / (far - contact), rel=1e-9)
    assert force.at == pytest.approx((contact, 4.0), abs=1e-9)
    assert force.block == 1
    n = -force.force[1] / (1800 * 0.4 * 3 * 4 * g)
    place = 0.5 + 0.1 / 0.4  # the worse face: xi = 0.75 for the side that the load is away from
    ratio = (1 + n) ** 0.5 / ((1 + n) ** 0.5 + ((1 - place) * n) ** 0.5)
    assert wall.positive.hinges[1][1] == pytest.approx(4 * ratio, rel=1e-9)


def test_an_eccentricity_that_is_given_overrides_the_contact(tmp_path):
    wall = mechanism_of(
        tmp_path, PROJECT, 'loads = [{ kind = "overburden", bodies = ["floor"], eccentricity = "-0.05 m" }]'
    )
    assert wall.positive.loads[0].at == pytest.approx((-0.05, 4.0), abs=1e-12)


def test_another_state_of_the_wall_carries_nothing_of_what_presses(tmp_path):
    loads = 'loads = [{ kind = "overburden", bodies = ["floor"] }]\n'
    eroded = """[bodies.eroded]
material = "m"
box = { thickness = 0.3, length = 3, height = 4 }
"""
    alone, beside = mechanism_of(tmp_path, PROJECT, loads), mechanism_of(tmp_path, PROJECT, loads + eroded)
    assert beside.positive.loads[0].force == pytest.approx(alone.positive.loads[0].force, rel=1e-12)
    assert "not shared with eroded, which stands where the wall does" in beside.positive.loads[0].source


def test_a_mass_on_the_lower_block_does_not_hold_the_crack_down(tmp_path):
    """Eq. 3.27 knows the load that presses on the crack, which is that of the upper block."""
    press = '{ kind = "overburden", force = "20 kN" }'
    low = mechanism_of(
        tmp_path, PROJECT, f'loads = [{press}, {{ kind = "mass", mass = 5000, at = [0, 1], block = 0 }}]'
    )
    assert low.positive.hinges[1] == pytest.approx(
        mechanism_of(tmp_path, PROJECT, f"loads = [{press}]").positive.hinges[1]
    )


def test_the_search_is_as_near_wherever_the_wall_stands(tmp_path):
    found = []
    for base in (0.0, -4.0, 1000.0):
        lines = 'crack = "minimum"\nloads = [{ kind = "overburden", force = "20 kN" }]'
        placed = PROJECT.replace("height = 4 }", f"height = 4, base = [0, 0, {base}] }}", 1)
        found.append(study_of(tmp_path, placed + lines).mechanisms[0].positive.hinges[1][1] - base)
    assert found == pytest.approx([found[0]] * 3, abs=2e-5)  # 1e-6 of the height, and the flatness of a minimum


def test_a_mass_that_bears_on_the_upper_block_holds_the_crack_down_as_a_force_does(tmp_path):
    by_force = mechanism_of(tmp_path, PROJECT, 'loads = [{ kind = "overburden", force = "20 kN" }]')
    mass = f'loads = [{{ kind = "mass", mass = {20e3 / g}, at = [0, 4], block = 1 }}]'
    assert mechanism_of(tmp_path, PROJECT, mass).positive.hinges[1] == pytest.approx(
        by_force.positive.hinges[1], rel=1e-12
    )


def test_a_load_across_the_crack_is_pointed_out(tmp_path):
    wall = mechanism_of(tmp_path, PROJECT, 'crack = 2.5\nloads = [{ kind = "mass", mass = 900, at = [0, 3.9] }]')
    assert any("write block = 1" in text for text in map(str, wall.warnings))


@pytest.mark.parametrize(
    ("loads", "error", "words"),
    [
        ('{ kind = "overburden" }', ProjectError, "give either force, or the bodies"),
        ('{ kind = "overburden", force = "1 kN", bodies = ["floor"] }', ProjectError, "give either force"),
        ('{ kind = "overburden", bodies = ["wall"] }', ProjectError, "no body beside the wall"),
        ('{ kind = "overburden", bodies = ["roof"] }', ProjectError, "no body beside the wall"),
        ('{ kind = "overburden", bodies = ["other"] }', GeometryError, "does not bear on the block"),
        ('{ kind = "overburden", force = "-4 kN" }', ProjectError, "greater than 0"),
    ],
)
def test_wrong_overburdens_are_refused_in_one_line(tmp_path, loads, error, words):
    with pytest.raises(error, match=words) as refused:
        mechanism_of(tmp_path, PROJECT, f"loads = [{loads}]")
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("load", ['force = "40 kN"', 'bodies = ["floor"]'])
def test_a_load_beside_the_top_is_refused(tmp_path, load):
    lines = 'crack = 2\nloads = [{{ kind = "overburden", {}, eccentricity = "{} m" }}]'
    for eccentricity in (0.2, -0.2):
        assert mechanism_of(tmp_path, PROJECT, lines.format(load, eccentricity)).positive.loads[0].at == (
            eccentricity,
            4.0,
        )
    for eccentricity in ("0.3", "-0.3"):
        with pytest.raises(GeometryError, match=r"loads\[1\]\.eccentricity = -?0\.3 m: 0\.1 m outside the wall"):
            mechanism_of(tmp_path, PROJECT, lines.format(load, eccentricity))


CRACKED = "crack = 2.5\n"
PRESSING = 'loads = [{{ kind = "overburden", force = "40 kN"{} }}]\n'
STIFF = 'interface = {{ model = "flexible", stiffness = "{} Pa/m", strength = "inf" }}\n'


def overturning(tmp_path, more, joint=""):
    """phi_ov of both directions, of the joints in use where there are any [rad]."""
    found = mechanism_of(tmp_path, PROJECT, CRACKED + PRESSING.format(more) + joint).oscillator
    return [branch.unstable for branch in found.branches]


def test_a_load_through_a_rigid_top_leaves_the_wall_its_slenderness(tmp_path):
    """Thesis 3.33 with xi = 0: phi_ov is the angle of the diagonal of the lower block, whatever presses."""
    alpha = atan2(0.4, 2.5)
    assert overturning(tmp_path, ', through = "joint"') == pytest.approx([alpha, alpha], rel=1e-9)
    kept = overturning(tmp_path, ', through = "fixed"')
    assert kept == overturning(tmp_path, "")
    assert max(kept) < 0.95 * alpha


@pytest.mark.parametrize(("through", "like"), [("joint", "joint"), ("fixed", "fixed"), (None, "joint")])
def test_on_stiff_joints_a_load_is_where_it_is_on_rigid_ones(tmp_path, through, like):
    """The joint moves the resultant by sqrt(N / (k l phi)); without the key the middle of a joint is "joint"."""
    rigid = overturning(tmp_path, f', through = "{like}"')
    more = "" if through is None else f', through = "{through}"'
    off = [1 - overturning(tmp_path, more, STIFF.format(k))[0] / rigid[0] for k in (2.5e10, 1e11)]
    assert 0.0 < off[1] < 2e-2
    assert off[1] == pytest.approx(off[0] / 2, rel=0.1)


def test_a_load_that_stays_has_no_joint_at_the_top(tmp_path):
    """Even where its place is the hinge of one direction."""
    for more in (', through = "fixed"', ', through = "fixed", eccentricity = 0.2'):
        wall = mechanism_of(tmp_path, PROJECT, CRACKED + PRESSING.format(more) + STIFF.format(1e9))
        assert [joint is None for joint in wall.positive.joints] == [False, False, True]
        assert not any("through the joint" in notice for notice in map(str, wall.warnings))
    asked = mechanism_of(tmp_path, PROJECT, CRACKED + PRESSING.format(", eccentricity = 0.2") + STIFF.format(1e9))
    assert asked.positive.joints[2] is not None
    both = PRESSING.format(', through = "fixed", eccentricity = 0.2').replace(
        "]", ', { kind = "overburden", force = 1 }]'
    )
    assert mechanism_of(tmp_path, PROJECT, CRACKED + both + STIFF.format(1e9)).positive.joints[2] is not None


def test_bodies_through_the_joint_press_on_the_middle_at_rest(tmp_path):
    """The crack is that of a load in the middle, eq. 3.27; each direction then has it at its own hinge."""
    wall = mechanism_of(tmp_path, PROJECT, 'loads = [{ kind = "overburden", bodies = ["floor"], through = "joint" }]')
    (force,) = wall.positive.loads
    n = -force.force[1] / (1800 * 0.4 * 3 * 4 * g)
    assert wall.positive.hinges[1][1] == pytest.approx(4 / (1 + (n / (2 * (1 + n))) ** 0.5), rel=1e-9)
    assert force.at == wall.positive.hinges[2] == pytest.approx((0.2, 4.0), abs=1e-9)
    assert wall.negative.loads[0].at == wall.negative.hinges[2] == pytest.approx((0.2, 4.0), abs=1e-9)


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (
            ', through = "joint", eccentricity = 0.1',
            'through: "joint": a load through the joint .* remove eccentricity',
        ),
        (', through = "top"', 'through: "top": not allowed; write "joint" or "fixed"'),
    ],
)
def test_wrong_ways_to_the_wall_are_refused(tmp_path, more, words):
    with pytest.raises(ProjectError, match=words) as refused:
        mechanism_of(tmp_path, PROJECT, CRACKED + PRESSING.format(more))
    assert "\n" not in str(refused.value)


def test_no_tie_ends_at_a_displacement_longer_than_its_point_is_high(tmp_path):
    """The point of a wall that topples moves by no more than its height before the wall lies on the ground."""
    tie = 'kind = "tie", force = "5 kN", at = [-0.2, 3.0], direction = [-1, 0]'
    for until, words in (
        ("2.9 m", ""),
        ("3.1 m", r"loads\[1\]\.until = 3\.1 m: longer than its point .* 3 m"),
    ):
        loads = f'loads = [{{ {tie}, until = "{until}" }}]'
        text = project_toml(mechanisms={"m": lines(block(direction=[1, 0, 0]), loads)})
        if words:
            with pytest.raises(MechanismError, match=words):
                study_of(tmp_path, text)
        else:
            study_of(tmp_path, text)
