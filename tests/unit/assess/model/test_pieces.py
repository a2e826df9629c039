"""Bodies from project files: meshes of every kind and state, several bodies and densities, openings, leaning walls."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely

from assess.errors import GeometryError, ProjectError
from assess.geometry.boolean import count_once
from assess.geometry.solid import join, profile
from assess.loads.load import PointMass
from assess.messages.message import Message
from assess.project.build import build
from assess.project.project_file import load, resolve
from assess.study.mechanism_results import parameters
from assess.study.run import run_study
from assess.study.study import Study
from tests.support.mesh_files import obj
from tests.support.projects import ASCE7, body_toml, box_toml, study_of, tables_toml
from tests.support.solids import solid_box, surfaces_of

MECHANISM = '\n[mechanisms.m]\nkind = "single-block"\ndirection = {direction}\nblocks = [{blocks}]\n'
OF_MESH = body_toml("w", 'mesh = "wall.obj"', material="stone")
WALL = solid_box((0.6, 4.0, 4.5))
HEAD = tables_toml(materials={"stone": {"density": 2400}, "rubble": {"density": 1800}})
SITE = tables_toml(
    site={"spectrum": ASCE7},
    records={"synthetic": {"count": 1, "duration": "8 s"}},
    analysis={"procedures": ["asce43-05-spectrum"]},
)


def study(folder: Path, bodies: str, *, blocks: str = '["w"]', more: str = "", direction: str = "[1, 0, 0]") -> Study:
    table = MECHANISM.format(blocks=blocks, direction=direction)
    return study_of(folder, HEAD + bodies + table + more)


def of_bodies(made: Study) -> list[Message]:
    """The warnings on bodies."""
    return [notice for notice in made.messages if notice.where.startswith("bodies.") or "overlap" in notice.key]


def test_a_mended_mesh_is_told_in_the_results(tmp_path: Path) -> None:
    pair = join([WALL, solid_box((0.6, 4.0, 1.0), (0.3, 0.0, 4.0))], name="pair")  # the cornice is half a metre in
    (tmp_path / "wall.obj").write_bytes(obj(*surfaces_of(pair)))
    made = study(tmp_path, OF_MESH, more=SITE)
    results = run_study(made)
    (notice,) = [notice for notice in results.warnings if notice.key == "mesh"]
    assert notice.where == "bodies.w"
    volume, shared = 0.6 * 4 * 5.5, 0.3 * 4 * 0.5
    assert notice.text.startswith("wall.obj: its 2 closed shells, some of which overlap")
    assert f"the volume changes by {-100 * shared / (volume - shared):.3g} %" in notice.text
    assert results.mechanisms[0].oscillator.mass_kg == pytest.approx(2400 * (volume - shared), rel=1e-12)


def test_a_good_mesh_is_the_box_and_nothing_is_told(tmp_path: Path) -> None:
    (tmp_path / "wall.obj").write_bytes(obj(*surfaces_of(WALL)))
    made = study(tmp_path, OF_MESH)
    assert of_bodies(made) == []
    by_box = study(tmp_path, box_toml("w", (0.6, 4, 4.5), material="stone"))
    (found,), (wanted,) = parameters(made), parameters(by_box)
    assert found.oscillator.p_eq_per_s == pytest.approx(wanted.oscillator.p_eq_per_s, rel=1e-12)


def test_unit_up_and_element_of_a_mesh(tmp_path: Path) -> None:
    turned = WALL.vertices[:, [0, 2, 1]] * [1000.0, 1000.0, -1000.0]  # y up, in millimetres
    (tmp_path / "wall.obj").write_bytes(obj(turned, WALL.triangles))
    made = study(tmp_path, body_toml("w", 'mesh = "wall.obj"\nmesh_unit = "mm"\nmesh_up = "y"', material="stone"))
    assert parameters(made)[0].oscillator.mass_kg == pytest.approx(2400 * 0.6 * 4 * 4.5, rel=1e-12)
    stated = resolve(load(tmp_path))
    assert [stated[f"bodies.w.{key}"].value for key in ("mesh_unit", "mesh_up", "element")] == [0.001, "y", None]
    with pytest.raises(GeometryError, match=r'body "w": mesh wall.obj: it has no element "tower"'):
        study(tmp_path, body_toml("w", 'mesh = "wall.obj"\nelement = "tower"', material="stone"))
    with pytest.raises(ProjectError, match=r'bodies.w.mesh_up: "x": not allowed; write "y" or "z"'):
        study(tmp_path, body_toml("w", 'mesh = "wall.obj"\nmesh_up = "x"', material="stone"))


def test_a_wrong_unit_is_refused_with_the_likely_one_and_inches_are_suspected(tmp_path: Path) -> None:
    (tmp_path / "wall.obj").write_bytes(obj(*surfaces_of(solid_box((600.0, 4000.0, 4500.0)))))
    with pytest.raises(GeometryError, match=r'4500 m .* With mesh_unit = "mm" \(--unit\) it would measure 4.5 m'):
        study(tmp_path, OF_MESH)
    (tmp_path / "wall.obj").write_bytes(obj(*surfaces_of(solid_box((15.0, 80.0, 120.0)))))
    (notice,) = of_bodies(study(tmp_path, OF_MESH))
    assert (notice.key, notice.where) == ("size-thick-in-unit", "bodies.w")
    assert 'about 15 m thick; is its unit right? With mesh_unit = "in" (--unit) it would measure 3.048 m' in notice.text


def test_several_bodies_of_several_densities(tmp_path: Path) -> None:
    made = study(
        tmp_path,
        box_toml("w", (0.6, 4, 4.5), material="stone") + box_toml("v", (0.4, 4, 2), (0.5, 0, 0), material="rubble"),
        blocks='["w", "v"]',
    )
    one, other = 2400 * 0.6 * 4 * 4.5, 1800 * 0.4 * 4 * 2.0
    (block,) = made.mechanisms[0].positive.blocks
    assert block.mass == pytest.approx(one + other, rel=1e-12)
    wanted = ((other * 0.5) / (one + other), (one * 2.25 + other * 1.0) / (one + other))
    np.testing.assert_allclose(block.centroid, wanted, rtol=1e-12, atol=0.0)
    assert of_bodies(made) == []  # they touch
    np.testing.assert_allclose(made.mechanisms[0].positive.hinges[0], (0.7, 0.0), rtol=1e-12, atol=1e-12)


def planar_block(made: Study) -> tuple[float, float, float, float]:
    """The mass, centroid and moment of inertia of the one block that moves."""
    (block,) = made.mechanisms[0].positive.blocks
    return (block.mass, *block.centroid, block.inertia)


@pytest.mark.parametrize(("x", "told"), [(0.4, "0.8 m3, 25 %"), (0.5, None)])
def test_what_bodies_of_one_block_share_counts_once(tmp_path: Path, x: float, told: str | None) -> None:
    """A pier in a wall, 0.4 x 4 x 2 m: by hand the wall whole and what stands out of it."""
    bodies = box_toml("w", (0.6, 4, 4.5), material="stone") + box_toml("v", (0.4, 4, 2), (x, 0, 0), material="rubble")
    made = study(tmp_path, bodies, blocks='["w", "v"]')
    out = x + 0.2 - 0.3  # of the pier beyond the face of the wall
    wall, pier = 2400 * 0.6 * 4 * 4.5, 1800 * out * 4 * 2.0
    centre_x, centre_z = pier * (0.3 + out / 2) / (wall + pier), (wall * 2.25 + pier * 1.0) / (wall + pier)
    own = wall * (0.6**2 + 4.5**2) / 12 + pier * (out**2 + 2.0**2) / 12
    moved = wall * (centre_x**2 + (2.25 - centre_z) ** 2)
    moved += pier * ((0.3 + out / 2 - centre_x) ** 2 + (1.0 - centre_z) ** 2)
    np.testing.assert_allclose(planar_block(made), (wall + pier, centre_x, centre_z, own + moved), rtol=1e-9, atol=0.0)
    warnings = of_bodies(made)
    if told is None:
        assert warnings == []
        return
    (notice,) = warnings
    assert (notice.key, notice.where) == ("overlap", "mechanisms.m")
    assert notice.text.startswith(f'bodies "w" and "v" overlap by {told} of the smaller')
    assert 'counts once, with "w"' in notice.text
    turned = planar_block(study(tmp_path, bodies, blocks='["v", "w"]'))
    assert turned[0] == pytest.approx(2400 * (0.6 * 4 * 4.5 - 0.8) + 1800 * 0.4 * 4 * 2.0, rel=1e-9)


def test_the_walls_of_a_corner_are_one_l(tmp_path: Path) -> None:
    """Two walls that cross at their corner, as IFC draws them, move as the L drawn in one piece."""
    legs = box_toml("w", (0.6, 4, 4.5), (0, 0, 0), material="stone")
    legs += box_toml("v", (3, 0.6, 4.5), (1.2, 1.7, 0), material="stone")
    third = box_toml("u", (0.6, 0.6, 4.5), (0, 1.7, 0), material="stone")  # drawn once more, wholly within both
    piece = box_toml("w", (0.6, 4, 4.5), (0, 0, 0), material="stone")
    piece += box_toml("v", (2.4, 0.6, 4.5), (1.5, 1.7, 0), material="stone")
    for cut in ("", "cut = 1.0\n"):
        drawn = planar_block(study(tmp_path, legs, blocks='["w", "v"]', more=cut))
        np.testing.assert_allclose(
            drawn, planar_block(study(tmp_path, piece, blocks='["w", "v"]', more=cut)), rtol=1e-9, atol=0.0
        )
        whole = study(tmp_path, legs + third, blocks='["w", "u", "v"]', more=cut)
        np.testing.assert_allclose(planar_block(whole), drawn, rtol=1e-9, atol=0.0)


def test_a_body_within_its_block_carries_no_load_beside_it(tmp_path: Path) -> None:
    """A beam over the wall bears on it alone, also where a block within the wall is drawn and reaches its top."""
    wall = box_toml("w", (0.6, 4, 4.5), material="stone") + box_toml("f", (3, 1, 0.2), (1.2, 0, 4.5), material="stone")
    wall += box_toml("p", (0.4, 1, 3), (2.5, 0, 1.5), material="stone")
    inner = box_toml("u", (0.2, 1, 4.5), material="stone")
    load = '[[mechanisms.m.loads]]\nkind = "body"\nbody = "f"\nrole = "floor"\n'
    (alone,) = study(tmp_path, wall, more=load).mechanisms[0].positive.loads
    (beside,) = study(tmp_path, wall + inner, blocks='["w", "u"]', more=load).mechanisms[0].positive.loads
    assert isinstance(alone, PointMass)
    assert isinstance(beside, PointMass)
    assert beside.mass == pytest.approx(alone.mass, rel=1e-9)
    assert beside.at == pytest.approx(alone.at, rel=1e-9)


def test_bodies_that_only_touch_are_not_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object, **__: object) -> None:
        raise AssertionError("no boolean operation where the boxes share no volume")

    monkeypatch.setattr("assess.geometry.boolean._manifold", never)
    touching = (solid_box(), solid_box(base=(1, 0, 0)), solid_box(base=(0, 0, 1)))
    assert all(one is other for one, other in zip(count_once(touching), touching, strict=True))


CHAINS = {
    "two-block": """["w"], ["v"]]
""",
    "four-hinge": """["w"], ["v"], ["u"]]
hinges = { A = [0.3, 0], B = [-0.3, FOOT], C = [3.7, FOOT], D = [4.3, 0] }
hinges_negative = { A = [-0.3, 0], B = [0.3, FOOT], C = [4.3, FOOT], D = [3.7, 0] }
""",
}


@pytest.mark.parametrize(("kind", "width", "pairs"), [("two-block", 0.6, ["1 2"]), ("four-hinge", 4.6, ["1 2", "2 3"])])
@pytest.mark.parametrize("deep", [0.2, 0.0])
def test_blocks_of_one_chain_that_overlap_are_told(
    tmp_path: Path, kind: str, width: float, pairs: list[str], deep: float
) -> None:
    """The upper block is as deep in the lower ones as that, 0.6 m x 4 m each; or stands on them."""
    leg, beam = (0.6, 4, 4.5), (width, 4, 1.2)
    boxes = ("w", leg), ("v", beam, ((width - 0.6) / 2, 0, 4.5 - deep)), ("u", leg, (4, 0, 0))
    bodies = "".join(box_toml(*each, material="stone") for each in boxes)
    chain = f'[mechanisms.m]\nkind = "{kind}"\nblocks = [{CHAINS[kind]}'.replace("FOOT", str(4.5 - deep))
    warnings = of_bodies(study_of(tmp_path, HEAD + bodies + chain))
    told = [(each.key, each.where, each.text.split(" one,")[0]) for each in warnings]
    share = 100 * deep * 0.6 * 4 / min(0.6 * 4 * 4.5, width * 4 * 1.2)
    shared = f"1150 kg, {share:.3g} % of the lighter"
    named = ["blocks {} and {}".format(*pair.split()) for pair in pairs if deep]
    assert told == [("blocks-overlap", "mechanisms.m", f"{names} overlap by {shared}") for names in named]


HOLLOW = [[-1, 0], [-0.4, 0], [-0.4, 1.5], [0.6, 1.5], [0.6, 0], [1, 0], [1, 6], [-1, 6]]
UNDERCUT = [[-0.7, 0], [1, 0], [1, 6], [-1, 6], [-1, 0.8], [-0.7, 0.5]]


@pytest.mark.parametrize(("outline", "feet"), [(HOLLOW, (-1.0, 1.0)), (UNDERCUT, (-0.7, 1.0))])
def test_hinges_and_radius_of_a_hollow_and_an_eroded_base(
    tmp_path: Path, outline: list[list[float]], feet: tuple[float, float]
) -> None:
    """The extreme points of what stands on the ground; the centroid is shapely's."""
    made = study(tmp_path, body_toml("w", f"profile = {outline}\nlength = 3", material="stone"))
    (found,) = parameters(made)
    centre = shapely.Polygon(outline).centroid
    for branch, foot in ((found.oscillator_negative, feet[0]), (found.oscillator, feet[1])):
        assert branch is not None
        assert branch.radius_m == pytest.approx(np.hypot(centre.x - foot, centre.y), rel=1e-12)
    assert not any("lowest face" in text for text in map(str, made.mechanisms[0].warnings))


def test_a_base_that_is_not_plane_is_told(tmp_path: Path) -> None:
    """Half of the foot is a tenth of a millimetre short, as in a mesh that was drawn or scanned so."""
    stepped = [[-1, 0.0001], [0, 0.0001], [0, 0], [1, 0], [1, 6], [-1, 6]]
    (mechanism,) = study(tmp_path, body_toml("w", f"profile = {stepped}\nlength = 3", material="stone")).mechanisms
    assert mechanism.negative is not None
    assert mechanism.negative.hinges[0][0] == 0.0
    assert any("lowest face alone, 1 m wide" in text and "is 2 m wide" in text for text in map(str, mechanism.warnings))
    cut = study(
        tmp_path, body_toml("w", f"profile = {stepped}\nlength = 3", material="stone"), more="cut = 0.0002\n"
    ).mechanisms[0]
    assert cut.negative is not None
    assert cut.negative.hinges[0][0] == pytest.approx(1.0, rel=1e-12)
    assert not any("lowest face" in text for text in map(str, cut.warnings))


def test_a_wall_with_an_opening(tmp_path: Path) -> None:
    """A profile across the wall with a doorway, as a mesh that lies along x: the solid less the door."""
    outline = [[-2, 0], [-0.5, 0], [-0.5, 2.1], [0.5, 2.1], [0.5, 0], [2, 0], [2, 4.5], [-2, 4.5]]
    pierced = profile(outline, length=0.6, density=2400.0, name="w")
    (tmp_path / "wall.obj").write_bytes(obj(*surfaces_of(pierced)))
    made = study(tmp_path, OF_MESH, direction="[0, 1, 0]")
    whole, door = 2400 * 4 * 4.5 * 0.6, 2400 * 1.0 * 2.1 * 0.6
    (block,) = made.mechanisms[0].positive.blocks
    assert block.mass == pytest.approx(whole - door, rel=1e-12)
    assert block.centroid[1] == pytest.approx((whole * 2.25 - door * 1.05) / (whole - door), rel=1e-12)
    about = whole * (0.6**2 + 4.5**2) / 12 + whole * (2.25 - block.centroid[1]) ** 2
    about -= door * (0.6**2 + 2.1**2) / 12 + door * (1.05 - block.centroid[1]) ** 2
    assert block.inertia == pytest.approx(about, rel=1e-12)


def test_a_leaning_wall(tmp_path: Path) -> None:
    """Sheared by 0.1 over its height: it resists more against its lean than with it."""
    made = study(
        tmp_path,
        body_toml("w", "profile = [[-0.3, 0], [0.3, 0], [0.75, 4.5], [0.15, 4.5]]\nlength = 4", material="stone"),
    )
    (found,) = parameters(made)
    assert found.oscillator.uplift_multiplier == pytest.approx((0.3 - 0.225) / 2.25, rel=1e-9)
    assert found.oscillator_negative is not None
    assert found.oscillator_negative.uplift_multiplier == pytest.approx((0.3 + 0.225) / 2.25, rel=1e-9)


def test_an_open_mesh_is_one_line_with_the_file(tmp_path: Path) -> None:
    (tmp_path / "wall.obj").write_bytes(obj(WALL.vertices, WALL.triangles[:6]))
    with pytest.raises(GeometryError) as caught:
        study(tmp_path, OF_MESH)
    line = str(caught.value)
    assert "\n" not in line
    assert line.startswith(f'{tmp_path / "project.toml"}: body "w": mesh wall.obj: it is open: ')
    assert "open edges around" in line


@pytest.mark.parametrize(
    ("corners", "message"),
    [
        ("[[0, 0], [1, 1], [1, 0], [0, 1]]", "its sides cross or touch one another at [0.5, 0.5] m; list its corners"),
        ("[[0, 0], [3, 0], [2, 0], [2, 2]]", "its sides cross or touch one another at"),
        ("[[0, 0], [1, 1], [2, 2]]", "no area, its corners lie on a line; give corners that enclose one"),
        ("[[1, 1], [1, 1], [1, 1]]", "no area"),
    ],
)
def test_a_bad_profile_is_told_at_its_key_in_our_words(tmp_path: Path, corners: str, message: str) -> None:
    with pytest.raises(ProjectError) as error:
        study(tmp_path, body_toml("w", f"profile = {corners}\nlength = 3", material="stone"))
    text = str(error.value)
    assert f"project.toml: bodies.w.profile: {corners}: {message}" in text
    assert "\n" not in text
    assert "elf-intersection" not in text


def test_a_profile_may_be_closed_and_have_a_corner_twice(tmp_path: Path) -> None:
    made = study(
        tmp_path,
        body_toml("w", "profile = [[0, 0], [1, 0], [1, 0], [1, 4], [0, 4], [0, 0]]\nlength = 3", material="stone"),
    )
    assert made.mechanisms[0].positive.blocks[0].mass == pytest.approx(2400.0 * 12.0, rel=1e-12)


def test_a_file_is_read_once_however_many_bodies_and_cases_of_a_sweep_name_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from assess.geometry import mesh
    from assess.project.project_file import load

    corners = [(x, y, z) for z in (0, 4) for x, y in ((0, 0), (0.6, 0), (0.6, 3), (0, 3))]
    faces = [(1, 4, 3, 2), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8), (5, 6, 7, 8)]
    text = ""
    for number, name in enumerate(("left", "right")):
        text += f"o {name}\n" + "".join(f"v {x + 9 * number} {y} {z}\n" for x, y, z in corners)
        text += "".join("f " + " ".join(str(corner + 8 * number) for corner in face) + "\n" for face in faces)
    (tmp_path / "house.obj").write_text(text)
    bodies = "".join(
        f'[bodies.{name}]\nmaterial = "brick"\nmesh = "house.obj"\nelement = "{name}"\n'
        f'[mechanisms.{name}]\nkind = "single-block"\nblocks = ["{name}"]\ndirection = [1, 0, 0]\n'
        for name in ("left", "right")
    )
    sweep = '[analysis.sweep]\nkey = "materials.brick.density"\nvalues = [1600, 1800, 2000]\n'
    (tmp_path / "project.toml").write_text(f"[materials.brick]\ndensity = 1800\n{bodies}{sweep}")
    files: list[Path] = []
    really = mesh.read_mesh_file
    monkeypatch.setattr(mesh, "read_mesh_file", lambda file, *, where: files.append(file) or really(file, where=where))
    study = build(load(tmp_path))
    assert [file.name for file in files] == ["house.obj"]
    assert len(study.sweeps[0].cases) == 3
    masses = [case.study.mechanisms[0].positive.mass for case in study.sweeps[0].cases]
    assert masses == pytest.approx([7.2 * 1600, 7.2 * 1800, 7.2 * 2000], rel=1e-9)
