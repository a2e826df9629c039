"""Halves of closed surfaces against manifold3d and trimesh, which share nothing with them, and against invariants."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import manifold3d
import numpy as np
import pytest
import trimesh

from assess.examples import copy_example
from assess.geometry.cut import divide, inclined_plane
from assess.geometry.halves import halve
from assess.geometry.solid import Solid, profile
from assess.geometry.surface import find_edges, volume
from assess.project.build import build_with_cases
from assess.project.project_file import load
from tests.support.solids import assert_same_mass, inside_out, irregular_tower, refine_mesh, solid_box, surfaces_of

LEVEL = np.eye(3)
NORMALS = ((0.0, 0.0, 1.0), (0.4, 0.0, 1.0), (-0.5, 0.7, 1.0), (1.0, 0.2, 0.05))
EXAMPLES = ("casa_grande", "chiesa", "nepal_monuments", "san_leonardo_spire")


def bodies() -> Iterator[Solid]:
    """Bodies that are convex, and that are not: with steps, a doorway and a window, a cavity, 50,000 triangles."""
    yield irregular_tower(density=1900.0)
    steps = [[0.0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3]]
    yield profile(steps, length=2.0, density=1900.0, name="steps")
    openings = [[0.0, 0], [1, 0], [1, 2], [2, 2], [2, 0], [6, 0], [6, 5], [3, 5], [3, 4], [2.5, 4], [2.5, 5], [0, 5]]
    yield profile(openings, length=0.6, density=1900.0, name="openings")
    yield refine_mesh(profile(openings, length=0.6, density=1900.0, name="fine openings"), 5)


@pytest.fixture(scope="module")
def shipped(tmp_path_factory: pytest.TempPathFactory) -> list[Solid]:
    """Return the bodies of examples."""
    found = []
    for name in EXAMPLES:
        project = copy_example(name, Path(tmp_path_factory.mktemp(name)) / "project")
        found += [each for each in build_with_cases(load(project)).solids.values() if each is not None]
    return found


def by_manifold(solid: Solid, point: np.ndarray, normal: np.ndarray) -> list[tuple[float, np.ndarray, float]]:
    """Return volume, centroid from the point and area in the plane of what lies above and below.

    Cut by manifold3d, measured by trimesh.
    """
    moved = np.array(solid.vertices - point, order="C")
    body = manifold3d.Manifold(manifold3d.Mesh64(moved, np.array(solid.triangles, dtype=np.uint64, order="C")))
    found = []
    for half in body.split_by_plane(tuple(normal), 0.0):
        mesh = half.to_mesh64()
        one = trimesh.Trimesh(np.array(mesh.vert_properties)[:, :3], np.array(mesh.tri_verts), process=False)
        in_plane = (np.abs(one.triangles @ normal) < 1e-10).all(axis=1)
        found.append((float(one.volume), np.array(one.center_mass), float(one.area_faces[in_plane].sum())))
    return found


def assert_same_halves(solid: Solid, point: np.ndarray, normal: np.ndarray) -> None:
    """Compare mass and centroid of both halves, and the section, with those of the other programs."""
    unit = normal / np.linalg.norm(normal)
    parts = divide([solid], inclined_plane(point, normal, where="m"), where="m")
    size = float(np.ptp(solid.vertices, axis=0).max())
    density = solid.mass / volume(solid.vertices, solid.triangles)
    expected = by_manifold(solid, point, unit)
    for half, (amount, middle, section) in zip((*parts.above, *parts.below), expected, strict=True):
        assert find_edges(half.triangles).closed
        assert half.mass == pytest.approx(density * amount, rel=1e-12, abs=1e-12 * solid.mass)
        np.testing.assert_allclose(half.centroid - point, middle, rtol=0.0, atol=1e-12 * size * solid.mass / half.mass)
        assert parts.region.area == pytest.approx(section, rel=1e-12, abs=1e-12 * size**2)


@pytest.mark.parametrize("solid", [*bodies()], ids=lambda solid: solid.name)
@pytest.mark.parametrize("normal", NORMALS)
def test_halves_are_those_of_other_programs(solid: Solid, normal: tuple[float, ...]) -> None:
    assert_same_halves(solid, solid.centroid + np.array([0.011, 0.023, 0.037]), np.array(normal))


def test_halves_of_shipped_bodies_are_those_of_other_programs(shipped: list[Solid]) -> None:
    for solid in shipped:
        low, high = np.array(solid.bounds)
        for share in (0.31, 0.57):
            for normal in NORMALS[:3]:
                assert_same_halves(solid, low + share * (high - low) + 1e-4, np.array(normal))


def test_halves_of_a_cube() -> None:
    vertices, triangles = surfaces_of(solid_box(base=(0.0, 0.0, -0.3)))
    upper, lower = halve((vertices, triangles), vertices[:, 2], origin=np.zeros(3), axes=LEVEL)
    assert (volume(*upper.surface), volume(*lower.surface)) == pytest.approx((0.7, 0.3), rel=1e-14)
    assert upper.face.equals(lower.face)
    assert upper.face.area == pytest.approx(1.0, rel=1e-14)


def test_the_face_of_a_corbel_is_its_own_and_the_section_that_of_what_lies_below() -> None:
    corners = [[0.0, 0], [1, 0], [1, 2], [1.5, 2], [1.5, 4], [-0.5, 4], [-0.5, 2], [0, 2]]
    body = profile(corners, length=2.0, density=1000.0, name="T")
    upper, lower = halve(
        (body.vertices, body.triangles), body.vertices[:, 2] - 2.0, origin=np.array([0, 0, 2.0]), axes=LEVEL
    )
    assert (upper.face.area, lower.face.area) == pytest.approx((4.0, 2.0), rel=1e-14)
    assert (volume(*upper.surface), volume(*lower.surface)) == pytest.approx((8.0, 4.0), rel=1e-14)
    assert find_edges(upper.surface[1]).closed


def test_sections_with_holes_that_touch_at_a_corner() -> None:
    """Two cavities whose edges meet: the section is a square without two squares that share a corner."""
    holes = [solid_box((0.5, 0.5, 1.0), base) for base in ((-0.25, -0.25, 0.5), (0.25, 0.25, 0.5))]
    vertices, triangles = surfaces_of(solid_box((2.0, 2.0, 2.0)), *map(inside_out, holes))
    upper, lower = halve((vertices, triangles), vertices[:, 2] - 0.9, origin=np.array([0, 0, 0.9]), axes=LEVEL)
    assert upper.face.area == pytest.approx(4.0 - 2 * 0.25, rel=1e-14)
    assert volume(*upper.surface) == pytest.approx(4.0 * 1.1 - 0.5 * 0.6, rel=1e-14)
    assert volume(*lower.surface) == pytest.approx(4.0 * 0.9 - 0.5 * 0.4, rel=1e-14)


def test_a_plane_through_corners_and_edges_makes_no_vertex() -> None:
    """A cube is halved along a diagonal plane: through four corners, and through diagonals of its faces or not."""
    body = solid_box()
    normal = np.array([1.0, 0.0, 1.0]) / np.sqrt(2.0)
    middle = np.array([0.0, 0.0, 0.5])
    axes = np.array([[normal[2], 0.0, -normal[0]], [0.0, 1.0, 0.0], normal])
    height = np.round((body.vertices - middle) @ normal, 12)
    halves = halve((body.vertices, body.triangles), height, origin=middle, axes=axes)
    assert [volume(*each.surface) for each in halves] == pytest.approx([0.5, 0.5], rel=1e-14)
    assert halves[0].face.area == pytest.approx(np.sqrt(2.0), rel=1e-14)


def test_a_cut_of_a_finer_mesh_is_the_same() -> None:
    body = irregular_tower(density=1000.0)
    plane = inclined_plane(body.centroid, (0.3, 0.1, 1.0), where="m")
    coarse, fine = (divide([each], plane, where="m") for each in (body, refine_mesh(body, 3)))
    for one, other in zip((*coarse.above, *coarse.below), (*fine.above, *fine.below), strict=True):
        assert_same_mass(other, one, rtol=1e-9)  # refined points are rounded to 1e-12 m
    assert fine.region.area == pytest.approx(coarse.region.area, rel=1e-9)


def test_planes_through_corners_leave_closed_halves(shipped: list[Solid]) -> None:
    """Planes through three vertices of a body: sections touch themselves, and triangles are cut through a corner."""
    rng = np.random.default_rng(1)
    for solid in shipped[::3]:
        size, whole = float(np.ptp(solid.vertices, axis=0).max()), volume(solid.vertices, solid.triangles)
        for _ in range(15):
            p, q, r = solid.vertices[rng.choice(len(solid.vertices), 3, replace=False)]
            normal = np.cross(q - p, r - p)
            if np.linalg.norm(normal) < 1e-6 * size**2:
                continue
            normal /= np.linalg.norm(normal)
            first = np.cross(normal, [1.0, 0.0, 0.0] if abs(normal[0]) < 0.9 else [0.0, 1.0, 0.0])
            first /= np.linalg.norm(first)
            height = (solid.vertices - p) @ normal
            height[np.abs(height) < 1e-12 * size] = 0.0
            if height.min() >= 0.0 or height.max() <= 0.0:
                continue
            axes = np.array([first, np.cross(normal, first), normal])
            halves = halve((solid.vertices, solid.triangles), height, origin=p, axes=axes)
            assert all(find_edges(each.surface[1]).closed and each.face.is_valid for each in halves)
            assert sum(volume(*each.surface) for each in halves) == pytest.approx(whole, rel=1e-12)


def test_bodies_that_pass_through_one_another_have_the_section_of_both() -> None:
    one, other = solid_box((1.0, 1.0, 3.0)), solid_box((3.0, 1.0, 1.0), (0.2, 0.1, 1.0))
    vertices, triangles = surfaces_of(one, other)
    upper, _ = halve((vertices, triangles), vertices[:, 2] - 1.4, origin=np.array([0, 0, 1.4]), axes=LEVEL)
    assert upper.face.area == pytest.approx(3.0 + 1.0 - 0.9, rel=1e-9)
    assert volume(*upper.surface) == pytest.approx(1.6 + 3.0 * 0.6, rel=1e-12)  # each counts, as in the whole
