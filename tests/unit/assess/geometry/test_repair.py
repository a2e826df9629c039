"""Broken meshes mended, against the body they were broken from."""

import numpy as np
import pytest

from assess.errors import GeometryError
from assess.geometry.repair import repair
from assess.geometry.solid import box
from assess.geometry.surface import Surface, find_edges, merge_vertices, volume
from assess.messages.message import whole_number
from tests.support.solids import convex_hull, solid_box

WALL = box(thickness=1.25, length=3.0, height=8.5, base=[0.5, 0.25, 2.0], density=1.0, name="wall")
SEED = 12


def ball(n: int = 900) -> Surface:
    """A convex polyhedron of n corners on a sphere of radius 2 m."""
    points = np.random.default_rng(SEED).normal(size=(n, 3))
    body = convex_hull(points * 2.0 / np.linalg.norm(points, axis=1, keepdims=True), density=1.0, name="ball")
    return merge_vertices(body.vertices, body.triangles)


@pytest.mark.parametrize("share", [0.005, 0.02, 0.05])
def test_missing_triangles_of_a_ball_are_closed(share: float) -> None:
    vertices, triangles = ball()
    kept = np.random.default_rng(SEED).random(len(triangles)) > share
    found, told = repair((vertices, triangles[kept]), where="ball")
    assert find_edges(found[1]).plain
    assert volume(*found) == pytest.approx(volume(vertices, triangles), rel=0.01)  # flat faces over neighbouring gaps
    assert "holes closed by planes" in str(told[0])


@pytest.mark.parametrize("turned", [[2, 1, 0], [0, 2, 1], [1, 0, 2]])
def test_two_triangles_back_to_back_within_a_body_are_dropped(turned: list[int]) -> None:
    vertices, triangles = merge_vertices(WALL.vertices, WALL.triangles)
    film = np.array([0, 1, len(vertices) - 1])
    found, told = repair((vertices, np.vstack([triangles, film, film[turned]])), where="wall")
    assert len(found[1]) == len(triangles)
    assert volume(*found) == pytest.approx(1.25 * 3.0 * 8.5)
    assert told[0].values["number"] == whole_number(2)


def test_a_missing_foot_of_a_hollow_tower_is_a_ring() -> None:
    # Vertices of a ring tower, radii 2 and 1 m, 5 m high; triangles of its skins and top; triangles of its foot
    n = 24
    turn = 2.0 * np.pi * np.arange(n) / n
    rings = [np.column_stack([r * np.cos(turn), r * np.sin(turn), np.full(n, z)]) for r in (2, 1) for z in (0, 5)]
    k, q = np.arange(n), (np.arange(n) + 1) % n
    skin = lambda a, b: np.vstack([np.column_stack([a + k, a + q, b + q]), np.column_stack([a + k, b + q, b + k])])  # noqa: E731
    vertices, foot = np.vstack(rings), skin(2 * n, 0)
    rest = np.vstack([skin(0, n), skin(3 * n, 2 * n), skin(n, 3 * n)])
    found, told = repair((vertices, rest), where="tower")
    whole = volume(vertices, np.vstack([rest, foot]))
    assert volume(*found) == pytest.approx(whole, rel=1e-12)
    assert find_edges(found[1]).plain
    assert "1 with 48 edges and an area of 9.32 m2, " in str(told[0])  # pi (4 - 1) less the segments of 24 sides


def test_windings_by_chance_are_made_alike() -> None:
    vertices, triangles = ball()
    turned = np.random.default_rng(SEED).random(len(triangles)) < 0.5
    found, told = repair((vertices, np.where(turned[:, None], triangles[:, ::-1], triangles)), where="ball")
    assert volume(*found) == pytest.approx(volume(vertices, triangles), rel=1e-13)
    assert "reversed to match their neighbours" in str(told[0])


def test_cracks_between_loose_triangles_are_closed() -> None:
    vertices, triangles = ball(200)
    loose = vertices[triangles].reshape(-1, 3) + np.random.default_rng(SEED).normal(size=(3 * len(triangles), 3)) * 1e-6
    found, told = repair(merge_vertices(loose, np.arange(len(loose)).reshape(-1, 3)), where="ball")
    assert find_edges(found[1]).plain
    assert volume(*found) == pytest.approx(volume(vertices, triangles), rel=1e-5)
    assert told[0].key == "border-corners-joined"
    assert "at most 0.0004 m apart" in told[0].text


def test_an_edge_that_faces_two_is_split() -> None:
    """Finer triangles on one side of an edge than on the other leave a slit without width."""
    a, b, c = WALL.triangles[0]
    middle = (WALL.vertices[a] + WALL.vertices[b]) / 2.0
    third = WALL.vertices[b] + (WALL.vertices[c] - WALL.vertices[b]) / 3.0
    vertices = np.vstack([WALL.vertices, middle, third])
    triangles = np.vstack([[[a, 8, c], [8, b, 9], [8, 9, c]], WALL.triangles[1:]])
    found, told = repair(merge_vertices(vertices, triangles), where="wall")
    assert find_edges(found[1]).plain
    assert volume(*found) == pytest.approx(31.875, rel=1e-13)
    (split,) = told
    assert (split.key, split.values) == ("edges-split", {"number": whole_number(2)})


def test_a_hole_too_uneven_is_refused() -> None:
    """A wall whose foot is torn off along a saddle, a metre high, four metres wide."""
    vertices, triangles = ball(400)
    gone = vertices[triangles].mean(axis=1)
    torn = gone[:, 2] > -1.0 + 0.8 * np.sign(gone[:, 0] * gone[:, 1])
    with pytest.raises(GeometryError, match=r"ball: it is open: \d+ open edges around 1 hole, .* close the surface"):
        repair((vertices, triangles[torn]), where="ball")


def test_a_surface_with_one_side_is_refused() -> None:
    n = 20
    turn = 2.0 * np.pi * np.arange(n) / n
    strip = [
        [np.cos(u) * (1 + w * np.cos(u / 2)), np.sin(u) * (1 + w * np.cos(u / 2)), w * np.sin(u / 2)]
        for u in turn
        for w in (-0.3, 0.3)
    ]
    k = 2 * np.arange(n - 1)
    faces = np.vstack(
        [np.column_stack([k, k + 1, k + 2]), np.column_stack([k + 2, k + 1, k + 3]), [[38, 39, 1], [1, 39, 0]]]
    )
    with pytest.raises(GeometryError, match="strip: "):
        repair(merge_vertices(np.array(strip), faces), where="strip")


def test_an_inner_wall_between_two_rooms_is_refused_by_its_edges() -> None:
    """A face within a box, between two boxes one on the other: its border edges belong to three triangles."""
    lower, upper = solid_box(), solid_box(base=(0, 0, 1))
    at_joint = (upper.vertices[upper.triangles][:, :, 2] == 1.0).all(axis=1)
    rest = upper.triangles[~at_joint] + len(lower.vertices)
    vertices, triangles = merge_vertices(
        np.vstack([lower.vertices, upper.vertices]), np.vstack([lower.triangles, rest])
    )
    with pytest.raises(
        GeometryError, match=r"4 edges shared by three or more triangles .the first from .* remove inner faces"
    ):
        repair((vertices, triangles), where="box")


def test_a_sliver_whose_corners_are_one_after_mending_is_refused() -> None:
    # Two triangles over one edge of 1 m, their apexes 1e-6 m off it: all borders join, and nothing is left.
    vertices = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1e-6, 0.0], [1.0, 0.0, 1e-6]])
    triangles = np.array([[0, 1, 2], [0, 3, 1]])
    with pytest.raises(GeometryError, match="sliver: it encloses nothing"):
        repair((vertices, triangles), where="sliver")
