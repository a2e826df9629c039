"""The faces at hinges as the geometry has them, their friction, and which procedures that asks."""

from __future__ import annotations

from math import cos, radians, sin
from pathlib import Path

import pytest

from assess.mechanisms.mechanism import Face
from assess.messages.message import Term
from assess.model import joint_planes
from tests.support.mesh_files import obj
from tests.support.projects import mechanism_of, mechanism_toml, parameters_of, study_of
from tests.support.solids import cuboid, refine_mesh

HEAD = """
[materials.stone]
density = 2200
friction = 0.6
[materials.brick]
density = 1800
{brick}
[bodies]
tower = {{ material = "stone", box = {{ thickness = 3, length = 2.5, height = 12 }} }}
cap = {{ material = "brick", box = {{ thickness = 3, length = 2.5, height = 2, base = [0, 0, 12] }} }}
plain = {{ mass = 1000, centroid = [0, 2], inertia = 900 }}
"""
ARCH = """
[bodies.arch]
material = "stone"
length = 1
profile = [[-2.5, 0], [-1.8, 1.8], [0, 2.5], [1.8, 1.8], [2.5, 0], [2, 0], [1.4, 1.4], [0, 2], [-1.4, 1.4], [-2, 0]]
[mechanisms.m]
kind = "four-hinge"
blocks = ["arch"]
hinges = "minimum"
joints = { centre = [0, 0], first = "175 deg", last = "5 deg", count = 8 }
"""
SINGLE = mechanism_toml("direction = [1, 0, 0]", blocks=["tower"])
SLOPED = 'cut = { point = [0, 0, 6], angle = "20 deg" }'
FLEXIBLE = f'{SLOPED}\ninterface = {{ model = "flexible", stiffness = "10 GPa/m" }}'


def test_a_tower_stands_on_level_faces(tmp_path: Path) -> None:
    for (face,) in mechanism_of(tmp_path, HEAD.format(brick=""), SINGLE).faces:
        assert (face.normal, face.on_geometry, face.friction) == ((0.0, 1.0), True, 0.6)


def test_the_normal_of_a_fine_base_needs_no_union_of_its_triangles(tmp_path: Path, monkeypatch) -> None:
    """The union took half of the time of a mechanism of 786,432 triangles; their area says that a face is there."""
    fine = refine_mesh(cuboid((-1.5, -1.25, 0), (1.5, 1.25, 12)), 3)
    (tmp_path / "fine.obj").write_bytes(obj(fine.vertices, fine.triangles))
    monkeypatch.setattr(joint_planes, "_faces_in", None)
    head = HEAD.format(brick="").replace("box = { thickness = 3, length = 2.5, height = 12 }", 'mesh = "fine.obj"')
    for (face,) in mechanism_of(tmp_path, head, SINGLE).faces:
        assert (face.normal, face.on_geometry) == ((0.0, 1.0), True)


@pytest.mark.parametrize("more", [SLOPED, FLEXIBLE], ids=["rigid", "flexible"])
def test_a_crack_falls_towards_the_direction_and_rises_for_the_branch_against_it(tmp_path: Path, more: str) -> None:
    (front,), (back,) = mechanism_of(tmp_path, HEAD.format(brick=""), f"{SINGLE}{more}\n").faces
    slope = radians(20)
    assert front.normal == pytest.approx((sin(slope), cos(slope)), abs=1e-6)
    assert back.normal == pytest.approx((-sin(slope), cos(slope)), abs=1e-6)


def test_the_faces_of_an_arch_are_its_radial_joints(tmp_path: Path) -> None:
    """Joints pass through the centre, so n is square to the hinge; it looks to the block nearer the crown."""
    built = mechanism_of(tmp_path, HEAD.format(brick=""), ARCH)
    for chain, faces in zip((built.positive, built.negative), built.faces, strict=True):
        for (x, z), face in zip(chain.hinges, faces, strict=True):
            assert face.on_geometry
            assert x * face.normal[0] + z * face.normal[1] == pytest.approx(0.0, abs=1e-6)
        a, b, c, d = (face.normal for face in faces)
        assert a[1] > 0.0 < d[1]
        assert b[0] > 0.0 > c[0]


def test_the_support_at_the_top_of_a_wall_looks_down(tmp_path: Path) -> None:
    text = '[mechanisms.m]\nkind = "two-block"\nblocks = ["tower"]\ncrack = "6 m"\n'
    (a, b, c), _ = mechanism_of(tmp_path, HEAD.format(brick=""), text).faces
    assert [face.normal for face in (a, b, c)] == [pytest.approx(n, abs=1e-9) for n in ((0, 1), (0, 1), (0, -1))]


@pytest.mark.parametrize(("brick", "expected"), [("friction = 0.4", (0.6, 0.4, 0.4)), ("", (0.6, None, None))])
def test_where_two_materials_meet_the_smoother_counts(tmp_path: Path, brick: str, expected: tuple) -> None:
    text = '[mechanisms.m]\nkind = "two-block"\nblocks = ["tower", "cap"]\n'
    (faces, _) = mechanism_of(tmp_path, HEAD.format(brick=brick), text).faces
    assert tuple(face.friction for face in faces) == expected
    remedies = {str(face.remedy) for face in faces if face.friction is None}
    assert remedies == ({"give materials.brick.friction"} if None in expected else set())


def test_a_body_of_direct_values_stands_level_without_friction(tmp_path: Path) -> None:
    built = mechanism_of(
        tmp_path,
        HEAD.format(brick=""),
        mechanism_toml("direction = [1, 0, 0]\nhinges = { A = [0.4, 0] }\nsides = 'one'", blocks=["plain"]),
    )
    remedy = Term("give its bodies geometry and a material with friction")
    assert built.faces == ((Face((0.0, 1.0), False, None, remedy),),)


def test_the_springing_of_a_vault_against_a_wall_is_no_bed(tmp_path: Path) -> None:
    """The intrados is nearly upright there: what carries the vault is not in the project, so its bed is taken level."""
    text = """
[bodies.vault]
material = "stone"
length = 1
profile = [[0, 3], [0.2, 4], [1, 5], [1, 5.3], [0, 4.3]]
[mechanisms.m]
kind = "single-block"
direction = [1, 0, 0]
blocks = ["vault"]
hinges = { A = [0, 3] }
sides = 'one'
loads = [{ kind = 'mass', mass = 1e5, at = [-1, 0, 4], bearing = true }]
"""
    ((face,),) = mechanism_of(tmp_path, HEAD.format(brick=""), text).faces
    assert (face.normal, face.on_geometry) == ((0.0, 1.0), False)


def test_sliding_is_asked_where_a_material_has_friction_or_the_user_asks(tmp_path: Path) -> None:
    friction_free = HEAD.format(brick="").replace("friction = 0.6", "")
    asked = '[analysis]\nprocedures = ["sliding"]\n'
    for text, expected in (
        (HEAD.format(brick="") + SINGLE, True),
        (friction_free + SINGLE, False),
        (friction_free + asked + SINGLE, True),
    ):
        made = study_of(tmp_path, text)
        assert ("sliding" in made.procedures) is expected
        assert made.resolved["analysis.procedures"].value == list(made.procedures)
        assert made.resolved["analysis.procedures"].given is (asked in text)


def test_results_name_the_forces_of_every_hinge(tmp_path: Path) -> None:
    found = parameters_of(tmp_path, HEAD.format(brick=""), SINGLE, SLOPED)
    front, back = found.hinge_forces
    assert (front.hinge, back.hinge, front.branch, back.branch) == ("A", "A'", "positive", "negative")
    assert front.horizontal_n / front.vertical_n == pytest.approx(-found.oscillator.uplift_multiplier, rel=1e-9)
    assert front.vertical_n == pytest.approx(found.oscillator.mass_kg * 9.80665, rel=1e-9)
    assert front.needed_friction == pytest.approx(abs(front.shear_n) / front.normal_n, rel=1e-12)
    assert front.activation_g == pytest.approx(found.oscillator.uplift_multiplier, rel=1e-9)
