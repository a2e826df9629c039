"""Interfaces as the project file describes them: which contact lies under which hinge, and what is told or refused."""

from __future__ import annotations

import re
from math import cos, inf, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
import shapely
import trimesh
from scipy.constants import g

from assess.errors import FallingError, MechanismError
from assess.oscillator import elastic_frequency
from assess.study.mechanism_results import parameters
from tests.support.projects import mechanism_of, refusal_of, study_of

STONE = """
[materials.stone]
density = 1800
young_modulus = "1 GPa"
compressive_strength = "1.5 MPa"
[bodies.wall]
material = "stone"
box = { thickness = 1, length = 2, height = 6 }
"""
SINGLE = """
[mechanisms.wall]
kind = "single-block"
direction = [1, 0, 0]
blocks = ["wall"]
"""
SOFT = 'interface = { model = "flexible", stiffness = "0.2 GPa/m" }\n'
LEGS = """
[bodies.left]
material = "stone"
box = { thickness = 0.6, length = 1, height = 3 }
[bodies.right]
material = "stone"
box = { thickness = 0.6, length = 1, height = 3, base = [4.6, 0, 0] }
[bodies.beam]
material = "stone"
box = { thickness = 5.2, length = 1, height = 0.7, base = [2.3, 0, 3] }
[mechanisms.portal]
kind = "four-hinge"
blocks = ["left", "beam", "right"]
hinges = { A = [0.3, 0], B = [-0.3, 3], C = [4.3, 3], D = [4.9, 0] }
hinges_negative = { A = [-0.3, 0], B = [0.3, 3], C = [4.9, 3], D = [4.3, 0] }
"""


# ------------------------------------------------------------------------------------------------------------- sections


def test_outline_of_a_box_is_its_rectangle(tmp_path):
    for chain in (
        mechanism_of(tmp_path, STONE, SINGLE, SOFT).positive,
        mechanism_of(tmp_path, STONE, SINGLE, SOFT).negative,
    ):
        (joint,) = chain.joints
        assert (joint.section.depth, joint.section.breadth, joint.section.area) == pytest.approx((1.0, 2.0, 2.0))
        assert joint.inward == pytest.approx((-1.0, 0.0))
        assert (joint.law.stiffness, joint.law.strength) == (2e8, 1.5e6)
        assert joint.model == "flexible"


@pytest.mark.parametrize("turn", [30.0, 137.0])
def test_direction_that_is_oblique_to_the_box(tmp_path, turn):
    """The rotated rectangle is deep b |cos| + l |sin|; its corner is the hinge."""
    c, s = cos(radians(turn)), sin(radians(turn))
    found = mechanism_of(tmp_path, (STONE + SINGLE).replace("[1, 0, 0]", f"[{c}, {s}, 0]"), SOFT)
    (joint,) = found.positive.joints
    depth = 1.0 * abs(c) + 2.0 * abs(s)
    assert joint.section.depth == pytest.approx(depth, rel=1e-9)
    assert joint.section.breadth == pytest.approx(1.0 * abs(s) + 2.0 * abs(c), rel=1e-9)
    assert joint.section.area == pytest.approx(2.0, rel=1e-9)
    assert found.positive.hinges[0][0] == pytest.approx(depth / 2, rel=1e-9)


def test_an_oblique_direction_is_told_with_how_far_the_resultant_leaves_the_plane(tmp_path):
    """A rectangle is not symmetric about an oblique plane: at a corner that alone bears, the resultant is there."""
    c, s = cos(radians(30.0)), sin(radians(30.0))
    (text,) = [
        n.text
        for n in mechanism_of(tmp_path, (STONE + SINGLE).replace("[1, 0, 0]", f"[{c}, {s}, 0]"), SOFT).warnings
        if "symmetric" in n.text
    ][:1]
    assert text.startswith(
        "interface A: the contact is not symmetric about the plane of motion: its resultant moves by"
    )
    straight = [n for n in mechanism_of(tmp_path, STONE, SINGLE, SOFT).warnings if "symmetric" in n.text]
    assert straight == []
    moved = float(text.split("up to ")[1].split(" m")[0])
    corner = abs(0.5 * s - 1.0 * c)  # across, of the extreme corner from the middle
    assert 0.1 * corner < moved < corner


def test_material_strength_unless_the_interface_says_another(tmp_path):
    for more, expected in (("", 1.5e6), (', strength = "3 MPa"', 3e6), (', strength = "inf"', inf)):
        (joint,) = mechanism_of(tmp_path, STONE, SINGLE, SOFT.replace('m" }', f'm"{more} }}')).positive.joints
        assert joint.law.strength == expected


def test_course_thickness_is_that_over_which_the_material_yields(tmp_path):
    (joint,) = mechanism_of(
        tmp_path, STONE, SINGLE, 'interface = { model = "flexible", course_thickness = "0.69 m" }'
    ).positive.joints
    assert joint.law.stiffness == pytest.approx(1e9 / 0.69, rel=1e-12)


@pytest.mark.parametrize(
    ("shape", "area", "depth"),
    [
        ("{ rectangle = [0.8, 2] }", 1.6, 0.8),
        ("{ hollow_rectangle = [1, 2, 0.4, 1.2] }", 2 - 0.48, 1.0),
        ("{ circle = 1 }", pi / 4, 1.0),
        ("{ annulus = [1, 0.6] }", pi * 0.16, 1.0),
        ("{ polygon = [[-0.5, -1], [0.5, -1], [0.5, 1]] }", 1.0, 1.0),
    ],
)
def test_shapes_by_their_sizes(tmp_path, shape, area, depth):
    (joint,) = mechanism_of(tmp_path, STONE, SINGLE, SOFT.replace(" }", f", shape = {shape} }}")).positive.joints
    assert joint.section.area == pytest.approx(area, rel=1e-12)
    assert joint.section.depth == pytest.approx(depth, rel=1e-12)


def test_a_polygon_is_seen_from_the_side_it_is_pressed(tmp_path):
    """A triangle with its upright side at +x: pressed flat there, at its tip from the other side."""
    triangle = "shape = { polygon = [[0.5, -1], [0.5, 1], [-0.5, 0]] }"
    found = mechanism_of(tmp_path, STONE, SINGLE, SOFT.replace(" }", f", {triangle} }}"))
    assert found.positive.joints[0].section.centroid == pytest.approx(1 / 3, rel=1e-9)
    assert found.negative.joints[0].section.centroid == pytest.approx(2 / 3, rel=1e-9)


def of_mesh(tmp_path, mesh, lines=SOFT):
    mesh.export(tmp_path / "wall.stl")
    text = (STONE + SINGLE).replace("box = { thickness = 1, length = 2, height = 6 }", 'mesh = "wall.stl"')
    return mechanism_of(tmp_path, text, lines)


def test_outline_of_a_hollow_tower(tmp_path):
    """A square tube: the hole counts."""
    square = shapely.box(-1, -1, 1, 1).difference(shapely.box(-0.6, -0.6, 0.6, 0.6))
    (joint,) = of_mesh(tmp_path, trimesh.creation.extrude_polygon(square, 8.0)).positive.joints
    assert joint.section.area == pytest.approx(4 - 1.44, rel=1e-6)  # STL holds seven digits
    assert joint.section.centroid == pytest.approx(1.0, rel=1e-6)
    W, I = (4 - 1.44) * 8 * 1800 * g, (2**4 - 1.2**4) / 12  # noqa: E741
    side = of_mesh(tmp_path, trimesh.creation.extrude_polygon(square, 8.0)).oscillator.positive
    assert elastic_frequency(side) == pytest.approx(sqrt((2e8 * I - 4 * W) / side.inertia[0]) / 2 / pi, rel=1e-5)


def test_outline_at_a_level_cut_of_a_taper(tmp_path):
    """A pyramid of 2 m with its top cut off, cut again where it is 1.5 m wide."""
    low, high = (np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * k for k in (1.0, 0.5))
    points = np.vstack([np.c_[low, np.zeros(4)], np.c_[high, np.full(4, 6.0)]])
    (joint,) = of_mesh(tmp_path, trimesh.convex.convex_hull(points), SOFT + 'cut = "3 m"').positive.joints
    assert joint.section.area == pytest.approx(2.25, rel=1e-9)
    assert joint.section.depth == pytest.approx(1.5, rel=1e-9)


def test_outline_at_an_inclined_cut_lies_in_its_plane(tmp_path):
    """A crack that rises by 20 degrees along the motion: as deep as the wall over its cosine, along the crack."""
    slope = radians(20.0)
    cut = f"cut = {{ point = [0, 0, 1], normal = [{-sin(slope)}, 0, {cos(slope)}] }}"
    found = mechanism_of(tmp_path, STONE, SINGLE, SOFT + cut)
    (joint,) = found.positive.joints
    assert joint.section.depth == pytest.approx(1.0 / cos(slope), rel=1e-9)
    assert joint.section.area == pytest.approx(2.0 / cos(slope), rel=1e-9)
    assert joint.inward == pytest.approx((-cos(slope), -sin(slope)), rel=1e-9)
    assert found.positive.hinges[0] == pytest.approx((0.5, 1 + 0.5 * tan(slope)), rel=1e-9)
    assert found.negative.joints[0].inward == pytest.approx((-cos(slope), sin(slope)), rel=1e-9)


def test_joints_of_a_portal(tmp_path):
    """Feet and heads of the columns, each seen from its hinge."""
    found = mechanism_of(tmp_path, STONE, LEGS, SOFT)
    for chain in (found.positive, found.negative):
        ways = [joint.inward[0] for joint in chain.joints]
        assert ways == pytest.approx([-1.0, 1.0, 1.0, -1.0])
        assert [joint.section.area for joint in chain.joints] == pytest.approx([0.6] * 4, rel=1e-9)


def test_interfaces_of_single_hinges(tmp_path):
    lines = (
        'interfaces = { A = { model = "flexible", stiffness = 2e8 }, C = { model = "semi-flexible", stiffness = 1e8 } }'
    )
    a, b, c, d = mechanism_of(tmp_path, STONE, LEGS, lines).positive.joints
    assert b is d is None
    assert (a.law.stiffness, a.model) == (2e8, "flexible")
    assert (c.law.stiffness, c.model) == (1e8, "semi-flexible")


def test_one_interface_for_all_but_one(tmp_path):
    lines = SOFT + 'interfaces = { A = { model = "flexible", stiffness = 5e8 } }'
    assert [j.law.stiffness for j in mechanism_of(tmp_path, STONE, LEGS, lines).positive.joints] == [5e8] + [2e8] * 3


def test_results_hold_every_hinge(tmp_path):
    (found,) = parameters(study_of(tmp_path, STONE + LEGS + SOFT))
    assert [one["hinge"] for one in found.interfaces] == ["A", "B", "C", "D", "A'", "B'", "C'", "D'"]
    W1, W2 = 3 * 0.6 * 1800 * g, 5.2 * 0.7 * 1800 * g
    forces = [one["normal_force_n"] for one in found.interfaces[:4]]
    assert forces == pytest.approx([W1 + W2 / 2, W2 / 2, W2 / 2, W1 + W2 / 2], rel=1e-9)
    foot = found.interfaces[0]
    assert foot["opening_rad"] == pytest.approx(2 * forces[0] / (2e8 * 0.6**2), rel=1e-9)  # thesis 6.2
    assert foot["crushing_rad"] == pytest.approx(1.5e6**2 / (2 * 2e8 * forces[0]), rel=1e-9)  # 6.4
    assert max(foot["curve"]["peak_stress_pa"]) == pytest.approx(1.5e6, rel=1e-12)
    assert foot["curve"]["resultant_m"][0] == pytest.approx(0.3, rel=1e-9)


# ------------------------------------------------------------------------------------------------------------ told


def test_no_strength_known_is_told(tmp_path):
    text = (STONE + SINGLE).replace('compressive_strength = "1.5 MPa"\n', "")
    found = mechanism_of(tmp_path, text, SOFT)
    assert any(
        "interface A: no strength is known, so its joint never crushes" in text for text in map(str, found.warnings)
    )
    asked = mechanism_of(tmp_path, text, SOFT.replace(" }", ', strength = "inf" }'))
    assert not any("strength" in text for text in map(str, asked.warnings))


def test_a_hinge_away_from_the_edge_is_told(tmp_path):
    found = mechanism_of(tmp_path, STONE, SINGLE, "hinges = { A = [0.4, 0, 0] }\n" + SOFT)
    (text,) = [text for text in map(str, found.warnings) if "edge of its contact" in text]
    assert text.startswith("interface A: the hinge lies 0.1 m inside the edge of its contact, which is 1 m deep")


def test_a_hinge_outside_its_contact_is_refused_with_both_numbers(tmp_path):
    words = "hinge A at x = 0.6 m, z = 0 m lies outside its contact, which reaches from x = -0.5 m, z = 0 m to x = 0.5"
    with pytest.raises(MechanismError, match=words):
        mechanism_of(tmp_path, STONE, SINGLE, "hinges = { A = [0.6, 0, 0] }\n" + SOFT)


@pytest.mark.parametrize("sides", ["one", "two"])
def test_a_hinge_outside_its_contact_about_which_the_wall_falls_is_refused_too(tmp_path, sides):
    """A typing error is no wall that falls: it ends with the hinge and its contact, not with a verdict."""
    with pytest.raises(MechanismError, match="hinge A at x = -50 m, z = 0 m lies outside its contact") as caught:
        mechanism_of(tmp_path, STONE, SINGLE, f'sides = "{sides}"\nhinges = {{ A = [-50, 0] }}\n')
    assert not isinstance(caught.value, FallingError)


TWO_BLOCKS = """
[materials.stone]
density = 1800
[bodies.low]
material = "stone"
box = { thickness = 0.6, length = 2, height = 2 }
[bodies.high]
material = "stone"
box = { thickness = 0.4, length = 2, height = 1.5, base = [0, 0, 2] }
[building]
height = 3.5
[mechanisms.wall]
kind = "two-block"
direction = [1, 0, 0]
blocks = ["low", "high"]
sides = "one"
"""


def hinged(a: float = 0.3, b: float = -0.2, c: float = 0.2) -> str:
    return f"hinges = {{ A = [{a}, 0], B = [{b}, 2], C = [{c}, 3.5] }}\n"


@pytest.mark.parametrize(
    ("hinges", "words"),
    [
        (hinged(a=0.34), "A at x = 0.34 m, z = 0 m lies 0.04 m outside block 0, whose nearest point is x = 0.3 m, z"),
        (hinged(b=-0.3), "B at x = -0.3 m, z = 2 m lies 0.1 m outside block 1, whose nearest point is x = -0.2 m, z"),
        (hinged(a=-2.0), "A at x = -2 m, z = 0 m lies 1.7 m outside block 0, whose nearest point is x = -0.3 m, z"),
        (hinged(c=0.25), "C at x = 0.25 m, z = 3.5 m lies 0.05 m outside block 1, whose nearest point is x = 0.2 m, z"),
    ],
)
def test_a_hinge_of_a_chain_outside_its_contact_is_refused_with_both_numbers(tmp_path, hinges, words):
    """B at the edge of the wider block below is outside the contact with the narrower one above."""
    with pytest.raises(MechanismError, match=re.escape(words)):
        mechanism_of(tmp_path, TWO_BLOCKS, hinges)


def test_a_hinge_of_a_portal_outside_its_contact_is_refused(tmp_path):
    with pytest.raises(MechanismError, match=r"hinge B at x = -0.4 m, z = 3 m lies 0.1 m outside block 0"):
        mechanism_of(tmp_path, STONE, LEGS.replace("B = [-0.3, 3]", "B = [-0.4, 3]"))


def test_an_honest_hinge_at_the_edge_stays_where_drawings_and_surveys_put_it(tmp_path):
    """To 5 % of the thickness; the survey's 20 mm, here all of that, and 50 mm are tried all the same."""
    assert not [each for each in mechanism_of(tmp_path, TWO_BLOCKS, hinged()).warnings if "hinge" in each.key]
    (told,) = [each for each in mechanism_of(tmp_path, TWO_BLOCKS, hinged(c=0.219)).warnings if "hinge" in each.key]
    assert told.key == "loose-hinge"
    study = study_of(tmp_path, TWO_BLOCKS + hinged() + '[verdict]\nsurvey_tolerance = "50 mm"\n')
    moved = [each for each in study.survey("wall") if each.parameter == "hinge"]
    assert {each.key.rpartition(".")[2] for each in moved} == set("ABC")
    for each in moved:
        for shift in (each.low, each.high):
            (there,) = each.study_at(shift).mechanisms
            assert there.positive.hinges != study.mechanisms[0].positive.hinges


def test_a_hinge_at_the_wrong_face_of_a_portal_is_told(tmp_path):
    text = (STONE + LEGS).replace("C = [4.3, 3], D = [4.9, 0] }\nh", "C = [4.9, 3], D = [4.9, 0] }\nh")
    (told,) = [each.text for each in mechanism_of(tmp_path, text, SOFT).warnings if each.key == "hinge-inside-contact"]
    assert told.startswith("interface C: the hinge lies 0.6 m inside the edge of its contact, which is 0.6 m deep")


# ----------------------------------------------------------------------------------------------------------- refused


def test_crushed_at_rest(tmp_path):
    text = refusal_of(
        tmp_path, STONE, SINGLE, 'interface = { model = "flexible", stiffness = 2e8, strength = "0.1 MPa" }'
    )
    most = 1800 * 6 * g / 0.1e6
    assert "mechanisms.wall: interface A: its normal force" in text
    assert f"{most:.4g} times what it can carry" in text
    assert "more strength or area" in text


def test_crushed_at_rest_on_a_rigid_joint(tmp_path):
    assert "times what it can carry" in refusal_of(tmp_path, STONE, SINGLE, 'interface = { strength = "0.1 MPa" }')


def test_a_body_without_geometry_needs_a_shape(tmp_path):
    text = (STONE + SINGLE).replace(
        'material = "stone"\nbox = { thickness = 1, length = 2, height = 6 }',
        "mass = 21600\ncentroid = [0, 3]\ninertia = 66600",
    )
    lines = "hinges = { A = [0.5, 0] }\nhinges_negative = { A = [-0.5, 0] }\n"
    strong = SOFT.replace(" }", ', strength = "1.5 MPa" }')
    line = refusal_of(tmp_path, text, lines, strong)
    assert "interface A: its body has no geometry, so its contact is not known; give shape" in line
    shaped = strong.replace(" }", ", shape = { rectangle = [1, 2] } }")
    (joint,) = mechanism_of(tmp_path, text, lines, shaped).positive.joints
    assert joint.section.area == 2.0


@pytest.mark.parametrize(
    ("interface", "message"),
    [
        ('{ model = "flexible", stiffness = 2e8, course_thickness = 1 }', "give either stiffness or course_thickness"),
        ('{ model = "flexible" }', "give either stiffness or course_thickness"),
        ("{ stiffness = 2e8 }", 'is for flexible interfaces; write model = "flexible"'),
        ('{ model = "flexible", stiffness = -1 }', "stiffness"),
        ('{ model = "flexible", stiffness = "2e8 Pa" }', "stiffness"),
        ('{ model = "flexible", stiffness = 2e8, strength = "0 MPa" }', "strength"),
        ('{ model = "flexible", stiffness = 2e8, strength = "nan" }', "strength"),
        ('{ model = "elastic", stiffness = 2e8 }', "flexible"),
        ('{ model = "flexible", stifness = 2e8 }', 'did you mean "stiffness"'),
        ('{ model = "flexible", stiffness = 2e8, shape = { circle = 1, rectangle = [1, 2] } }', "one shape is needed"),
        ('{ model = "flexible", stiffness = 2e8, shape = {} }', "one shape is needed"),
        ('{ model = "flexible", stiffness = 2e8, shape = "round" }', "shape"),
        ('{ model = "flexible", stiffness = 2e8, shape = { hollow_rectangle = [1, 2, 1.5, 1] } }', "hole"),
        ('{ model = "flexible", stiffness = 2e8, shape = { annulus = [1, 1] } }', "smaller than the outside, 1 m"),
        ('{ model = "flexible", stiffness = 2e8, shape = { polygon = [[0, 0], [1, 1], [1, 0], [0, 1]] } }', "outline"),
    ],
)
def test_interfaces_that_say_too_much_or_too_little(tmp_path, interface, message):
    text = refusal_of(tmp_path, STONE, SINGLE, f"interface = {interface}")
    assert message in text
    assert "interface" in text


@pytest.mark.parametrize(
    ("shape", "key", "message"),
    [
        ('"circle"', "", 'not allowed; write "outline", or { circle = d }'),
        ('"round"', "", "{ circle = d }, { annulus = [d, d_in] }, { polygon = [[x, y], …] }"),
        ("3", "", 'not allowed; write "outline", or { rectangle = [t, l] }'),
        ("{ annulus = [1, 1.5] }", ".annulus", "the hole, 1.5 m, must be smaller than the outside, 1 m"),
        ("{ hollow_rectangle = [1, 2, 0.5, 2] }", ".hollow_rectangle", "the hole, 2 m, must be smaller"),
        ("{ polygon = [[-1, -1], [1, 1], [1, -1], [-1, 1]] }", ".polygon", "its sides cross or touch one another"),
        ("{ polygon = [[0, 0], [1, 1], [3, 3]] }", ".polygon", "no area, its corners lie on a line"),
        ("{ polygon = [[1, 1], [1, 1], [1, 1]] }", ".polygon", "no area"),
    ],
)
def test_a_shape_that_is_none_is_told_at_its_key(tmp_path, shape, key, message):
    found = refusal_of(
        tmp_path, STONE, SINGLE, f'interface = {{ model = "flexible", stiffness = 2e8, shape = {shape} }}'
    )
    assert f"project.toml: mechanisms.wall.interface.shape{key}: " in found
    assert message in found
    assert "Self-intersection" not in found
    letter = refusal_of(
        tmp_path, STONE, SINGLE, f'interfaces = {{ A = {{ model = "flexible", stiffness = 2e8, shape = {shape} }} }}'
    )
    assert f"mechanisms.wall.interfaces.A.shape{key}: " in letter


def test_course_thickness_without_a_modulus(tmp_path):
    text = (STONE + SINGLE).replace('young_modulus = "1 GPa"\n', "")
    found = refusal_of(tmp_path, text, 'interface = { model = "flexible", course_thickness = 1 }')
    assert "course_thickness needs young_modulus of the material" in found


def test_a_hinge_that_is_not_there(tmp_path):
    text = refusal_of(tmp_path, STONE, SINGLE, 'interfaces = { B = { model = "flexible", stiffness = 2e8 } }')
    assert "interfaces" in text
    assert "B" in text
    text = refusal_of(tmp_path, STONE, SINGLE, 'interfaces = { E = { model = "flexible", stiffness = 2e8 } }')
    assert "E" in text


def test_blocks_that_do_not_touch_at_a_hinge(tmp_path):
    text = (STONE + LEGS).replace("base = [2.3, 0, 3]", "base = [2.3, 0, 3.5]")
    found = refusal_of(tmp_path, text, SOFT)
    assert "interface B: no faces of its blocks touch with an edge at the hinge" in found


def test_a_contact_that_is_not_in_one_place_for_both_directions_is_told(tmp_path):
    lines = SOFT.replace(" }", ", shape = { rectangle = [0.6, 2] } }")
    told = [notice.text for notice in study_of(tmp_path, STONE + SINGLE + lines).messages]
    assert any("interface A: its contact lies 0.4 m apart for the two directions" in text for text in told)
    lines = SOFT.replace(" }", ", shape = { rectangle = [1, 2] } }")
    assert not any("apart" in notice.text for notice in study_of(tmp_path, STONE + SINGLE + lines).messages)


@pytest.mark.parametrize(("eccentricity", "told"), [(0.0, True), (0.1, False)])
def test_a_load_that_comes_through_the_joint_at_the_top_is_told(tmp_path, eccentricity, told):
    wall = SINGLE.replace("single-block", "two-block") + "crack = 3.6\n"
    load = f'loads = [{{ kind = "overburden", force = "40 kN", eccentricity = {eccentricity} }}]\n'
    texts = [notice.text for notice in study_of(tmp_path, STONE + wall + SOFT + load).messages]
    assert (
        any("interface C: the load on the middle of the top comes through the joint" in each for each in texts) == told
    )


ARCH = (
    STONE.replace(
        "box = { thickness = 1, length = 2, height = 6 }",
        'length = "1 m"\nprofile = [[-2.5, 0], [-1.8, 1.8], [0, 2.5], [1.8, 1.8], [2.5, 0], [2, 0], [1.4, 1.4], '
        "[0, 2], [-1.4, 1.4], [-2, 0]]",
    )
    + """
[mechanisms.arch]
kind = "four-hinge"
sides = "one"
blocks = ["wall"]
hinges = "minimum"
joints = { centre = [0, 0], first = "175 deg", last = "5 deg", count = 8 }
"""
)


def test_joints_of_an_arch_lie_in_the_planes_of_its_voussoirs(tmp_path):
    """Every joint runs from its hinge along the ray to the centre, as deep as the arch is there."""
    found = mechanism_of(tmp_path, ARCH, 'interface = { strength = "1.5 MPa" }\n')
    outline = shapely.Polygon(
        [(-2.5, 0), (-1.8, 1.8), (0, 2.5), (1.8, 1.8), (2.5, 0), (2, 0), (1.4, 1.4), (0, 2), (-1.4, 1.4), (-2, 0)]
    )
    for hinge, joint in zip(found.positive.hinges, found.positive.joints, strict=True):
        ray = np.array(hinge) / np.hypot(*hinge)
        np.testing.assert_allclose(abs(np.dot(joint.inward, ray)), 1.0, rtol=1e-9)
        deep = outline.intersection(shapely.LineString([(0.0, 0.0), 4.0 * ray])).length
        assert joint.section.depth == pytest.approx(deep, rel=1e-6)
        inside = np.add(hinge, np.multiply(joint.inward, 0.5 * deep))
        assert outline.contains(shapely.Point(*inside))


def test_an_arch_on_stiff_joints_is_nearly_the_rigid_one(tmp_path):
    stiff = 'interface = { model = "flexible", stiffness = "1e12 Pa/m", strength = "inf" }\n'
    rigid = mechanism_of(tmp_path, ARCH).oscillator.positive
    found = mechanism_of(tmp_path, ARCH, stiff).oscillator.positive
    assert found.overturning == pytest.approx(rigid.overturning, rel=1e-9)
    assert found.overturning_flexible == pytest.approx(rigid.overturning, rel=1e-2)
    assert found.overturning_flexible < rigid.overturning


def test_joints_more_than_a_right_angle_apart_keep_their_faces(tmp_path):
    """An arch and its mirror image resist alike, though the second joint is turned from the first by 95 degrees."""
    ring = [
        (r * cos(radians(t)), r * sin(radians(t))) for r, way in ((2.5, 1), (2.0, -1)) for t in range(0, 181, 5)[::way]
    ]
    arch = ARCH[: ARCH.index("profile")] + f"profile = {[list(point) for point in ring]}\n"
    found = []
    for angles in ((180, 85, 40, 0), (180, 140, 95, 0)):
        lines = [[[r * cos(radians(t)), r * sin(radians(t))] for r in (2.0, 2.5)] for t in angles]
        joints = f'[mechanisms.arch]\nkind = "four-hinge"\nblocks = ["wall"]\nhinges = "minimum"\njoints = {lines}\n'
        found.append(mechanism_of(tmp_path, arch, joints).oscillator)
    first, mirrored = found
    assert first.positive.linearised.multiplier == pytest.approx(mirrored.negative.linearised.multiplier, rel=1e-9)
    assert first.negative.linearised.multiplier == pytest.approx(mirrored.positive.linearised.multiplier, rel=1e-9)


def test_each_direction_of_an_arch_rests_on_joints_of_its_own(tmp_path):
    """It opens other joints each way, and a symmetric one alike."""
    both = mechanism_of(tmp_path, ARCH.replace('sides = "one"\n', ""), SOFT).oscillator
    alone = mechanism_of(tmp_path, ARCH, SOFT).oscillator
    assert both.negative is not None
    assert both.equilibrium == pytest.approx(alone.equilibrium, rel=1e-9)
    assert both.equilibrium_negative == pytest.approx(alone.equilibrium, rel=1e-6)
    assert both.equilibrium > 0.0
    np.testing.assert_allclose(both.positive.restoring, alone.positive.restoring, rtol=1e-9, atol=1e-6)
    assert both.negative.restoring[0] == 0.0
    assert both.negative.overturning_flexible == pytest.approx(alone.positive.overturning_flexible, rel=1e-6)
