"""Bodies from mesh files: the same box by every way in, and what is mended or refused."""

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from assess.errors import GeometryError
from assess.geometry.formats.mesh_file import Up
from assess.geometry.mesh import load_solid, size_warning
from assess.geometry.planar import planar_body
from assess.geometry.solid import Solid, box, join, polyhedron, profile
from tests.support.mesh_files import obj, ply_binary, ply_text, stl_binary, stl_text
from tests.support.solids import assert_same_mass, inside_out, solid_box, surfaces_of

DENSITY = 2240.0
WALL = box(
    thickness=1.25, length=3.0, height=8.5, base=[0.5, 0.25, 2.0], density=DENSITY, name="wall"
)  # exact in binary
Triangles = Sequence[Sequence[int]]


WRITERS = {
    "text.stl": stl_text,
    "binary.stl": stl_binary,
    "mesh.obj": obj,
    "text.ply": ply_text,
    "binary.PLY": ply_binary,
}
EXACT = [name for name in WRITERS if name != "binary.stl"]  # binary STL holds single precision


def loaded(
    folder: Path, vertices: ArrayLike, triangles: ArrayLike, *, file: str = "mesh.obj", scale: float = 1.0
) -> Solid:
    path = folder / file
    path.write_bytes(WRITERS[file](vertices, triangles))
    return load_solid(path, density=DENSITY, name="wall", scale=scale)


@pytest.mark.parametrize("file", WRITERS)
def test_mesh_box_is_the_box(tmp_path: Path, file: str) -> None:
    found = loaded(tmp_path, WALL.vertices, WALL.triangles, file=file)
    assert_same_mass(found, WALL, rtol=1e-12)
    assert (found.vertices.shape, found.triangles.shape) == ((8, 3), (12, 3))


@pytest.mark.parametrize(("unit", "scale"), [("mm", 1e-3), ("cm", 1e-2), ("ft", 0.3048), ("in", 0.0254)])
@pytest.mark.parametrize("file", EXACT)
def test_mesh_box_in_another_unit_is_the_box(tmp_path: Path, file: str, unit: str, scale: float) -> None:
    assert_same_mass(loaded(tmp_path, WALL.vertices / scale, WALL.triangles, file=file, scale=scale), WALL, rtol=1e-12)


@pytest.mark.parametrize("file", EXACT)
def test_mesh_box_turned_in_space_is_the_box_turned(tmp_path: Path, file: str) -> None:
    turn = Rotation.from_rotvec([0.4, -0.9, 1.3]).as_matrix()
    found = loaded(tmp_path, WALL.vertices @ turn.T, WALL.triangles, file=file)
    assert_same_mass(
        found,
        Solid("wall", WALL.mass, turn @ WALL.centroid, turn @ WALL.inertia @ turn.T, WALL.vertices, WALL.triangles),
        rtol=1e-9,
    )


@pytest.mark.parametrize("file", EXACT)
def test_mesh_box_in_national_coordinates_is_the_box(tmp_path: Path, file: str) -> None:
    there = np.array([512345.625, 4123456.75, 250.5])
    wall = box(thickness=1.25, length=3.0, height=8.5, base=there, density=DENSITY, name="wall")
    assert_same_mass(loaded(tmp_path, wall.vertices, wall.triangles, file=file), wall, rtol=1e-9)


def test_mesh_of_a_profile_is_the_profile(tmp_path: Path) -> None:
    pier = profile([[0, 0], [2, 0], [2, 1], [1, 1], [1.3, 3], [0, 3]], length=2.7, density=DENSITY, name="pier")
    assert_same_mass(loaded(tmp_path, pier.vertices, pier.triangles, file="text.stl"), pier, rtol=1e-12)


def test_quadrilaterals_and_counting_from_the_end_are_read(tmp_path: Path) -> None:
    places = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in WALL.vertices.tolist())
    quads = [[0, 1, 2, 3], [7, 6, 5, 4], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]]
    for name, shift in (("forwards.obj", 1), ("backwards.obj", -8)):
        faces = "".join("f " + " ".join(str(i + shift) for i in quad) + "\n" for quad in quads)
        (tmp_path / name).write_text(places + faces)
        assert_same_mass(load_solid(tmp_path / name, density=DENSITY, name="wall"), WALL, rtol=1e-12)


def test_unused_vertices_and_collapsed_triangles_do_not_count(tmp_path: Path) -> None:
    vertices = np.concatenate([WALL.vertices, [[99.0, 99.0, -99.0], [np.nan, 0.0, 0.0], WALL.vertices[0]]])
    triangles = np.concatenate([WALL.triangles, [[0, 10, 1], [3, 3, 3]]])  # vertex 10 lies on vertex 0
    found = loaded(tmp_path, vertices, triangles)
    assert_same_mass(found, WALL, rtol=1e-12)
    assert found.vertices.shape == (8, 3)


def test_shells_beside_one_another_add(tmp_path: Path) -> None:
    for other in (
        solid_box(base=(3.0, 0.0, 0.0), density=DENSITY),
        solid_box(base=(1.0, 0.25, 0.25), density=DENSITY),
        solid_box(base=(1.0, 1.0, 1.0), density=DENSITY),
    ):  # apart, in contact, at a corner
        parts = (solid_box(density=DENSITY), other)
        assert_same_mass(loaded(tmp_path, *surfaces_of(*parts), file="text.stl"), join(parts, name="pair"), rtol=1e-12)


def test_shells_in_contact_at_a_slant_add(tmp_path: Path) -> None:
    turn = Rotation.from_rotvec([0.4, -0.9, 1.3]).as_matrix()
    vertices, triangles = surfaces_of(
        solid_box((2.0, 3.0, 1.0), density=DENSITY),
        solid_box(base=(0.2, 0.3, 1.0), density=DENSITY),
        solid_box(base=(-0.5, -1.0, 1.0), density=DENSITY),
    )
    found = loaded(tmp_path, vertices @ turn.T + [30.0, 20.0, 10.0], triangles, file="text.ply")
    assert found.mass == pytest.approx(8.0 * DENSITY, rel=1e-12)


def test_a_cavity_is_taken_off(tmp_path: Path) -> None:
    outer, inner = (
        solid_box((4.0, 4.0, 4.0), density=DENSITY),
        solid_box((2.0, 2.0, 2.0), (0.5, 0.0, 1.0), density=DENSITY),
    )
    found = loaded(tmp_path, *surfaces_of(outer, inside_out(inner)))
    assert found.mass == pytest.approx(DENSITY * (64.0 - 8.0), rel=1e-14)
    np.testing.assert_allclose(found.centroid, [-0.5 * 8.0 / 56.0, 0.0, 2.0], rtol=0.0, atol=1e-14)
    shelf = solid_box((0.5, 0.5, 0.5), (0.5, 0.0, 1.5), density=DENSITY)
    with_shelf = loaded(tmp_path, *surfaces_of(outer, inside_out(inner), shelf))
    assert with_shelf.mass == pytest.approx(DENSITY * (64.0 - 8.0 + 0.125), rel=1e-14)


def refused(folder: Path, vertices: ArrayLike, triangles: ArrayLike, *, text: str) -> None:
    for file in EXACT:
        with pytest.raises(GeometryError, match=text) as caught:
            loaded(folder, vertices, triangles, file=file)
        assert "\n" not in str(caught.value)
        assert str(caught.value).startswith('body "wall"')


def repaired(folder: Path, vertices: ArrayLike, triangles: ArrayLike, *, volume: float, text: str) -> Solid:
    """What is read from every format: of this volume, and the sentence that says what was done."""
    for file in EXACT:
        found = loaded(folder, vertices, triangles, file=file)
        assert found.mass == pytest.approx(volume * DENSITY, rel=1e-12), file
        assert re.search(text, "; ".join(map(str, found.history))), found.history
    return found


def test_a_good_mesh_is_not_touched(tmp_path: Path) -> None:
    found = loaded(tmp_path, WALL.vertices, WALL.triangles)
    assert found.history == ()
    order = np.lexsort(WALL.vertices.T)
    np.testing.assert_array_equal(found.vertices, WALL.vertices[order])
    np.testing.assert_array_equal(found.vertices[found.triangles], WALL.vertices[WALL.triangles])


def test_a_missing_triangle_is_closed(tmp_path: Path) -> None:
    triangle = WALL.vertices[WALL.triangles]
    areas = np.linalg.norm(np.cross(triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]), axis=1) / 2.0
    size = f"{areas[0]:.3g} m2, {100 * areas[0] / areas.sum():.3g} % of the surface"
    text = rf"planes: 1 with 3 edges and an area of {size}, .* the volume changes by 8.33 % "  # 1 of 12 equal cones
    found = repaired(tmp_path, WALL.vertices, WALL.triangles[1:], volume=31.875, text=text)
    assert_same_mass(found, WALL, rtol=1e-12)


def test_a_mesh_that_is_largely_open_is_refused_with_number_and_place(tmp_path: Path) -> None:
    sheet = WALL.triangles[:2]
    text = (
        r"mesh .*: it is open: 4 open edges around 1 hole, the largest around .0.5, -1.25, 6.25. m, 50 % of the surface"
    )
    refused(tmp_path, WALL.vertices, sheet, text=text)


def test_triangles_are_turned_alike(tmp_path: Path) -> None:
    turned = np.array([5, 8])
    triangles = WALL.triangles.copy()
    triangles[turned] = triangles[turned, ::-1]
    found = repaired(
        tmp_path, WALL.vertices, triangles, volume=31.875, text="triangles reversed to match their neighbours: 2"
    )
    assert_same_mass(found, WALL, rtol=1e-12)


def test_an_inverted_mesh_is_turned(tmp_path: Path) -> None:
    found = repaired(
        tmp_path, WALL.vertices, WALL.triangles[:, ::-1], volume=31.875, text="faced inwards and were reversed"
    )
    assert_same_mass(found, WALL, rtol=1e-12)
    outer, inner = (
        solid_box((4.0, 4.0, 4.0), density=DENSITY),
        solid_box((2.0, 2.0, 2.0), (0.5, 0.0, 1.0), density=DENSITY),
    )
    vertices, triangles = surfaces_of(outer, inside_out(inner))
    repaired(tmp_path, vertices, triangles[:, ::-1], volume=56.0, text="faced inwards and were reversed")


def test_boxes_that_share_an_edge_or_a_face_are_two(tmp_path: Path) -> None:
    for other in (solid_box(base=(1.0, 1.0, 0.0), density=DENSITY), solid_box(base=(1.0, 0.0, 0.0), density=DENSITY)):
        found = loaded(tmp_path, *surfaces_of(solid_box(density=DENSITY), other))
        assert (found.mass, found.history) == (pytest.approx(2.0 * DENSITY, rel=1e-14), ())


def test_double_triangles_count_once(tmp_path: Path) -> None:
    repaired(
        tmp_path,
        *surfaces_of(WALL, WALL),
        volume=31.875,
        text="double triangles removed: 12; the volume changes by -100 %",
    )
    both_sides = np.concatenate([WALL.triangles, WALL.triangles[:, ::-1]])
    repaired(tmp_path, WALL.vertices, both_sides, volume=31.875, text="double triangles removed: 12")


def test_a_mesh_without_volume_is_refused(tmp_path: Path) -> None:
    refused(tmp_path, [[0, 0, 0], [1, 0, 0], [0, 0, 1]], [[0, 1, 2], [0, 2, 1]], text="encloses no volume")
    refused(tmp_path, WALL.vertices * [0.0, 1.0, 1.0], WALL.triangles, text="no volume")
    refused(tmp_path, [[0, 0, 0]] * 3, [[0, 1, 2]], text="shrunk to lines or points")


@pytest.mark.parametrize(
    ("where", "size", "volume"),
    [
        ((0.3, 0.2, 0.4), (1.0, 1.0, 1.0), 2.0 - 0.7 * 0.8 * 0.6),  # at a corner
        ((0.5, 0.0, 0.0), (1.0, 1.0, 1.0), 1.5),  # pushed in with four faces flush
        ((0.0, 0.0, 0.0), (0.5, 3.0, 1.0), 2.0),  # a cross, top and bottom flush
        ((0.0, 0.0, 0.5), (0.25, 0.25, 3.0), 1.0 + 0.25**2 * 2.5),  # a bar through the top face
        ((0.25, 0.0, 0.0), (0.5, 0.5, 0.5), 1.0),  # inside, two faces flush
        ((0.0, 0.0, 0.0), (1.0, 1.0, 2.0), 2.0),  # around, five faces flush and the same corners
        ((0.0, 0.0, -0.99999), (1.0, 1.0, 1.0), 1.99999),  # by a hundredth of a millimetre
    ],
)
@pytest.mark.parametrize("angle", [0.0, 0.7])
def test_overlapping_shells_are_united(
    tmp_path: Path,
    where: tuple[float, float, float],
    size: tuple[float, float, float],
    volume: float,
    angle: float,
) -> None:
    vertices, triangles = surfaces_of(solid_box(density=DENSITY), solid_box(size, where, density=DENSITY))
    turn = Rotation.from_rotvec([angle, 2.0 * angle, -angle]).as_matrix()
    found = loaded(tmp_path, vertices @ turn.T, triangles, file="text.ply")
    assert found.mass == pytest.approx(volume * DENSITY, rel=1e-9)
    assert "closed shells, some of which overlap" in str(found.history[0])
    moved = 100.0 * (volume - (1.0 + np.prod(size))) / volume
    assert f"the volume changes by {moved:.3g} %" in str(found.history[0])


def test_a_shell_inside_another_counts_once_unless_it_is_a_cavity(tmp_path: Path) -> None:
    outer, inner = (
        solid_box((4.0, 4.0, 4.0), density=DENSITY),
        solid_box((2.0, 2.0, 2.0), (0.5, 0.0, 1.0), density=DENSITY),
    )
    repaired(
        tmp_path,
        *surfaces_of(outer, inner),
        volume=64.0,
        text="2 closed shells, .* united .*the volume changes by -12.5 %",
    )
    text = "closed shells that faced inwards reversed: 1, the first around x = 9 m, y = 0 m, z = 0.5 m"
    repaired(
        tmp_path,
        *surfaces_of(outer, inside_out(solid_box(base=(9.0, 0.0, 0.0), density=DENSITY))),
        volume=65.0,
        text=text,
    )
    repaired(
        tmp_path,
        *surfaces_of(outer, inside_out(solid_box(base=(0.0, 0.0, 4.0), density=DENSITY))),
        volume=65.0,
        text="closed shells that faced inwards reversed: 1",
    )


def test_cavities_that_break_through_or_meet_are_taken_off_once(tmp_path: Path) -> None:
    outer = solid_box((4.0, 4.0, 4.0), density=DENSITY)
    through = solid_box((2.0, 2.0, 3.1), (0.0, 0.0, 1.0), density=DENSITY)
    repaired(tmp_path, *surfaces_of(outer, inside_out(through)), volume=64.0 - 12.0, text="overlap")
    pair = [inside_out(solid_box(base=(x, 0.0, 1.0), density=DENSITY)) for x in (-0.4, 0.4)]
    repaired(tmp_path, *surfaces_of(outer, *pair), volume=64.0 - 1.8, text="overlap")


def test_a_flat_shell_beside_a_body_is_left_out(tmp_path: Path) -> None:
    vertices = np.concatenate([WALL.vertices, [[9.0, 0.0, 0.0], [9.0, 1.0, 0.0], [9.0, 0.0, 1.0]]])
    triangles = np.concatenate([WALL.triangles, [[8, 9, 10], [8, 10, 9]]])
    repaired(tmp_path, vertices, triangles, volume=31.875, text="closed shells without volume removed: 1")


@pytest.mark.parametrize("unit", [1e-3, 1e3])
def test_what_is_flat_does_not_depend_on_the_unit(tmp_path: Path, unit: float) -> None:
    """Two walls of which one is a thin sheet, in millimetres and in kilometres: neither is dropped."""
    sheet = box(thickness=0.02, length=3.0, height=8.0, base=[9.0, 0.0, 0.0], density=DENSITY, name="sheet")
    vertices, triangles = surfaces_of(WALL, sheet)
    found = loaded(tmp_path, vertices / unit, triangles, scale=unit)
    assert found.mass == pytest.approx(WALL.mass + sheet.mass, rel=1e-9)


def test_a_surface_that_cuts_itself_is_refused(tmp_path: Path) -> None:
    """A prism over a star that is wound twice around its middle: the pentagon there counts twice."""
    turn = 4.0 * np.pi * np.arange(5) / 5.0
    ring = np.column_stack([np.cos(turn), np.zeros(5), np.sin(turn)])
    k, q = np.arange(5), (np.arange(5) + 1) % 5
    ends = np.column_stack([k, q, np.full(5, 10)]), np.column_stack([q + 5, k + 5, np.full(5, 11)])
    sides = np.concatenate([np.column_stack([k, k + 5, q]), np.column_stack([q, k + 5, q + 5])])
    vertices = np.concatenate([ring, np.add(ring, [0.0, 2.0, 0.0]), [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0]]])
    triangles = np.concatenate([*ends, sides])
    refused(
        tmp_path, vertices, triangles, text=r"intersects itself near .* so that about \d+ % of its volume counts twice"
    )


@pytest.mark.parametrize("up", ["y", "z"])
def test_the_axis_that_points_up_is_turned_to_z(tmp_path: Path, up: Up) -> None:
    turned = WALL.vertices if up == "z" else WALL.vertices @ Rotation.from_euler("x", -90, degrees=True).as_matrix().T
    (tmp_path / "wall.obj").write_bytes(obj(turned, WALL.triangles))
    assert_same_mass(load_solid(tmp_path / "wall.obj", density=DENSITY, name="wall", up=up), WALL, rtol=1e-12)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -1e38])
def test_numbers_that_are_not_finite_are_refused(tmp_path: Path, value: float) -> None:
    vertices = WALL.vertices.copy()
    vertices[3, 1] = value
    for file in WRITERS:
        with pytest.raises(GeometryError, match=r"not finite or beyond 1e\+12|cannot be read"):
            loaded(tmp_path, vertices, WALL.triangles, file=file)


def test_a_triangle_of_a_vertex_that_is_not_there_is_refused(tmp_path: Path) -> None:
    for file in ("mesh.obj", "text.ply", "binary.PLY"):
        with pytest.raises(GeometryError, match=r"uses vertex 77 of 8|cannot be read as OBJ .index 77"):
            loaded(tmp_path, WALL.vertices, np.concatenate([WALL.triangles, [[0, 1, 77]]]), file=file)


JUNK = bytes(np.random.default_rng(0).integers(0, 256, 5000, dtype=np.uint8))


@pytest.mark.parametrize("ending", ["stl", "obj", "ply"])
@pytest.mark.parametrize(
    "content",
    [b"", JUNK, b"hello\nworld\n", b"solid a\nendsolid a\n", b"v 1 2 3\n", b"f 1 2 3\n", b"v a b c\nf 1 1 1\n"],
)
def test_files_without_a_mesh_are_refused(tmp_path: Path, ending: str, content: bytes) -> None:
    path = tmp_path / f"wall.{ending}"
    path.write_bytes(content)
    with pytest.raises(GeometryError, match=r"no triangles found|cannot be read as") as caught:
        load_solid(path, density=DENSITY, name="wall")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("file", WRITERS)
def test_a_file_cut_short_is_refused(tmp_path: Path, file: str) -> None:
    content = WRITERS[file](WALL.vertices, WALL.triangles)
    path = tmp_path / file
    for part in (0.3, 0.6, 0.9):
        path.write_bytes(content[: int(part * len(content))])
        with pytest.raises(GeometryError, match=f'body "wall": mesh {file}'):
            load_solid(path, density=DENSITY, name="wall")


def test_missing_files_folders_and_other_kinds_are_refused(tmp_path: Path) -> None:
    with pytest.raises(
        GeometryError, match=r'body "wall": mesh wall.stl: No such file or directory .*; check the path'
    ):
        load_solid(tmp_path / "wall.stl", density=DENSITY, name="wall")
    (tmp_path / "folder.stl").mkdir()
    with pytest.raises(GeometryError, match="Is a directory"):
        load_solid(tmp_path / "folder.stl", density=DENSITY, name="wall")
    with pytest.raises(GeometryError, match=r'files of kind ".dwg" are not read; export it as one of .stl, .obj, .ply'):
        load_solid(tmp_path / "wall.dwg", density=DENSITY, name="wall")


def test_scale_and_density_must_be_positive(tmp_path: Path) -> None:
    for scale in (0.0, -1.0, float("nan")):
        with pytest.raises(GeometryError, match="its unit is"):
            loaded(tmp_path, WALL.vertices, WALL.triangles, scale=scale)
    (tmp_path / "wall.obj").write_bytes(obj(WALL.vertices, WALL.triangles))
    with pytest.raises(GeometryError, match="density is -1 kg/m3"):
        load_solid(tmp_path / "wall.obj", density=-1.0, name="wall")


def test_a_size_that_suggests_a_wrong_unit_is_told_with_the_likely_one() -> None:
    assert size_warning(WALL) is None
    for factor, unit, hint in (
        (1000.0, 1.0, ' With mesh_unit = "mm" (--unit) it would measure 8.5 m'),
        (0.001, 0.001, ' With mesh_unit = "m" (--unit) it would measure 8.5 m'),
        (1000.0, None, ""),
    ):
        body = polyhedron(WALL.vertices * factor, WALL.triangles, density=DENSITY, name="wall")
        wanted = f'body "wall" measures {8.5 * factor:.4g} m at its longest; is its unit right?{hint}'
        assert str(size_warning(body, unit=unit)) == wanted


def test_single_precision_far_from_the_origin_is_refused_beyond_a_hundredth_of_the_thickness(tmp_path: Path) -> None:
    """In UTM coordinates numbers stand 0.25 or 0.5 m apart, at 60 km 4 mm: 0.3 % of 1.25 m, which is told."""
    text = r"resolves 0.2[56] m, more than 1 % of its thickness of .* m; move the model near the origin"
    far = WALL.vertices + np.array([512345.1, 4123456.7, 250.3])
    for unit in (1.0, 1e-3):  # coordinates written in millimetres are as coarse
        with pytest.raises(GeometryError, match=text):
            loaded(tmp_path, far / unit, WALL.triangles, file="binary.stl", scale=unit)
    assert size_warning(loaded(tmp_path, far, WALL.triangles)) is None
    near = loaded(tmp_path, WALL.vertices + np.array([60000.1, 0.2, 0.3]), WALL.triangles, file="binary.stl")
    assert "in single precision, which resolves 0.0039 m there" in str(size_warning(near))


@pytest.mark.parametrize(
    ("kind", "single"), [("float", True), ("float32", True), ("double", False), ("float64", False)]
)
def test_a_ply_file_says_by_its_type_how_finely_it_resolves(tmp_path: Path, kind: str, single: bool) -> None:
    """What is written in double precision may have been drawn at such places."""
    far = (WALL.vertices + np.array([512345.1, 4123456.7, 250.3])).astype(np.float32)
    file = tmp_path / "far.ply"
    file.write_bytes(ply_text(far, WALL.triangles).replace(b"property double", f"property {kind}".encode()))
    if single:
        with pytest.raises(GeometryError, match="in single precision"):
            load_solid(file, density=DENSITY, name="wall", scale=1.0)
    else:
        assert load_solid(file, density=DENSITY, name="wall", scale=1.0).mass > 0.0


@pytest.mark.parametrize(
    ("factor", "unit", "hint"),
    [
        (1000.0, None, 'With mesh_unit = "mm" (--unit) it would measure 8.5 m'),
        (100.0, None, 'With mesh_unit = "cm" (--unit) it would measure 8.5 m'),
        (1000.0, 1.0, 'give another mesh_unit (--unit). With mesh_unit = "mm" (--unit) it would measure 8.5 m'),
        (1.0, 1000.0, 'give another mesh_unit (--unit). With mesh_unit = "m" (--unit) it would measure 8.5 m'),
        (0.001, None, 'With mesh_unit = "km" (--unit) it would measure 8.5 m'),
        (1e-9, None, "No usual unit makes it a wall"),
    ],
)
def test_a_size_of_no_masonry_is_refused_with_the_likely_unit(
    tmp_path: Path, factor: float, unit: float | None, hint: str
) -> None:
    (tmp_path / "wall.obj").write_bytes(obj(WALL.vertices * factor, WALL.triangles))
    with pytest.raises(GeometryError, match=re.escape(hint)):
        load_solid(tmp_path / "wall.obj", density=DENSITY, name="wall", scale=unit)


def test_a_small_specimen_is_believed_where_its_unit_is_given(tmp_path: Path) -> None:
    (tmp_path / "wall.obj").write_bytes(obj(WALL.vertices * 2.0, WALL.triangles))
    small = load_solid(tmp_path / "wall.obj", density=DENSITY, name="wall", scale=1e-3)
    assert small.mass == pytest.approx(WALL.mass * 8e-9, rel=1e-12)
    assert "measures 0.017 m at its longest" in str(size_warning(small, unit=1e-3))


def test_inches_read_as_metres_are_suspected() -> None:
    inches = box(thickness=15.0, length=80.0, height=120.0, base=[0, 0, 0], density=DENSITY, name="wall")
    wanted = 'body "wall" measures 120 m at its longest and is about 15 m thick; is its unit right?'
    assert str(size_warning(inches)) == wanted
    assert str(size_warning(inches, unit=1.0)) == wanted + ' With mesh_unit = "in" (--unit) it would measure 3.048 m'
    tower = box(thickness=8.0, length=8.0, height=45.0, base=[0, 0, 0], density=DENSITY, name="tower")
    assert size_warning(tower, unit=1.0) is None


def test_a_flipped_byte_of_a_mesh_is_read_or_refused(tmp_path: Path) -> None:
    """Every third byte of a small binary STL or PLY, all bits or one of the exponent: our error, or a body."""
    for file in ("binary.stl", "binary.PLY"):
        content = WRITERS[file](WALL.vertices, WALL.triangles)
        path = tmp_path / file
        for at in range(0, len(content), 3):  # 3 meets every byte of the numbers, of four or eight
            for bits in (0xFF, 0x40):
                path.write_bytes(content[:at] + bytes([content[at] ^ bits]) + content[at + 1 :])
                try:
                    found = load_solid(path, density=DENSITY, name="wall")
                except GeometryError as problem:
                    assert "\n" not in str(problem)  # noqa: PT017
                else:
                    assert np.isfinite(found.mass)
                    assert found.mass > 0.0


def test_a_drum_with_a_rough_skin_has_the_mass_of_its_circle(tmp_path: Path) -> None:
    """Load and outline of a drum with a rough skin."""
    n, m = 400, 40
    rng = np.random.default_rng(4)
    turn, rise = 2.0 * np.pi * np.arange(n) / n, np.linspace(0.0, 8.0, m)
    radius = 1.5 + 0.002 * rng.normal(size=(m, n))
    rings = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.broadcast_to(rise[:, None], (m, n))], axis=2)
    vertices = np.concatenate([rings.reshape(-1, 3), [[0.0, 0.0, 0.0], [0.0, 0.0, 8.0]]])
    i, k = np.meshgrid(np.arange(n), np.arange(m - 1))
    a, b = (k * n + i).ravel(), (k * n + (i + 1) % n).ravel()
    ring = np.arange(n)
    foot = np.column_stack([np.full(n, n * m), (ring + 1) % n, ring])
    head = np.column_stack([np.full(n, n * m + 1), ring + (m - 1) * n, (ring + 1) % n + (m - 1) * n])
    triangles = np.concatenate([np.column_stack([a, b, a + n]), np.column_stack([b, b + n, a + n]), foot, head])
    path = tmp_path / "drum.stl"
    path.write_bytes(stl_binary(vertices, triangles))
    drum = load_solid(path, density=DENSITY, name="drum")
    body = planar_body(drum, direction=[0.8, 0.6, 0.0])
    assert len(drum.triangles) == 2 * n * m
    assert drum.mass == pytest.approx(DENSITY * np.pi * 1.5**2 * 8.0, rel=1e-3)  # 400 sides, rough skin
    assert len(body.outline) == 1


def test_many_small_triangles_are_the_wall_they_cover(tmp_path: Path) -> None:
    vertices, triangles = WALL.vertices, WALL.triangles
    for _ in range(5):
        corners = vertices[triangles]
        middles = (corners + np.roll(corners, -1, axis=1)) / 2.0
        a, b, c, ab, bc, ca = (*corners.swapaxes(0, 1), *middles.swapaxes(0, 1))
        four = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        vertices = np.concatenate([np.stack(each, axis=1) for each in four]).reshape(-1, 3)
        triangles = np.arange(len(vertices)).reshape(-1, 3)
    path = tmp_path / "wall.stl"
    path.write_bytes(stl_binary(vertices, triangles))
    found = load_solid(path, density=DENSITY, name="wall")
    assert len(found.triangles) == 12 * 4**5
    assert_same_mass(found, WALL, rtol=1e-12)
