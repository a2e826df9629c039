"""Mass properties of solids against closed forms, other ways to the same body, and chance."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from assess.errors import GeometryError
from assess.geometry.solid import box, join, polyhedron, profile
from tests.support.solids import assert_same_mass, irregular_tower

DENSITY = 2240.0
TOWER = irregular_tower(density=DENSITY)
TETRAHEDRON = (
    np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]),
    np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]),
)


def test_box_is_the_textbook_box() -> None:
    wall = box(thickness=1.25, length=3.0, height=8.0, base=[10.0, 20.0, 30.0], density=DENSITY, name="wall")
    M = 30.0 * DENSITY
    assert wall.mass == pytest.approx(M, rel=1e-15)
    np.testing.assert_allclose(wall.centroid, [10.0, 20.0, 34.0], rtol=1e-15, atol=0.0)
    wanted = M / 12.0 * np.diag([3.0**2 + 8.0**2, 1.25**2 + 8.0**2, 1.25**2 + 3.0**2])
    np.testing.assert_allclose(wall.inertia, wanted, rtol=1e-14, atol=0.0)
    np.testing.assert_allclose(wall.vertices.min(axis=0), [9.375, 18.5, 30.0], rtol=1e-15, atol=0.0)
    np.testing.assert_allclose(wall.vertices.max(axis=0), [10.625, 21.5, 38.0], rtol=1e-15, atol=0.0)


def test_the_drawn_surface_of_a_box_encloses_the_box() -> None:
    wall = box(thickness=1.1, length=3.3, height=8.7, base=[1.0, 2.0, 3.0], density=DENSITY, name="wall")
    assert_same_mass(polyhedron(wall.vertices, wall.triangles, density=DENSITY, name="wall"), wall, rtol=1e-14)


def test_tetrahedron_closed_form() -> None:
    found = polyhedron(*TETRAHEDRON, density=6.0, name="corner")
    assert found.mass == pytest.approx(1.0, rel=1e-14)
    np.testing.assert_allclose(found.centroid, [0.25, 0.25, 0.25], rtol=1e-14, atol=0.0)
    # int x2 dm = 1/10, int xy dm = 1/20 about the right corner, mass 1
    about_corner = np.full((3, 3), -1.0 / 20.0) + np.eye(3) * (1.0 / 20.0 + 2.0 / 10.0)
    c = np.full(3, 0.25)
    np.testing.assert_allclose(found.inertia, about_corner - (c @ c * np.eye(3) - np.outer(c, c)), rtol=0.0, atol=1e-15)


def test_prism_on_a_regular_polygon_closed_form() -> None:
    n, R, L = 24, 1.7, 5.0
    turns = 2.0 * np.pi * np.arange(n) / n
    drum = profile(np.column_stack([R * np.cos(turns), R * np.sin(turns)]), length=L, density=DENSITY, name="drum")
    area = n / 2.0 * R**2 * np.sin(2.0 * np.pi / n)
    polar = area * R**2 / 6.0 * (2.0 + np.cos(2.0 * np.pi / n))
    M = DENSITY * area * L
    assert drum.mass == pytest.approx(M, rel=1e-13)
    assert drum.inertia[1, 1] == pytest.approx(DENSITY * L * polar, rel=1e-13)
    assert drum.inertia[0, 0] == pytest.approx(DENSITY * L * polar / 2.0 + M * L**2 / 12.0, rel=1e-13)
    np.testing.assert_allclose(drum.centroid, 0.0, rtol=0.0, atol=1e-13)


def test_profile_of_a_triangle_has_the_textbook_product_of_inertia() -> None:
    b, h, L = 2.0, 3.0, 1.5
    wedge = profile([[0, 0], [b, 0], [0, h]], length=L, density=DENSITY, name="wedge")
    assert wedge.inertia[0, 2] == pytest.approx(DENSITY * L * b**2 * h**2 / 72.0, rel=1e-13)  # int xz dA = -b2 h2 / 72
    assert wedge.inertia[1, 1] == pytest.approx(DENSITY * L * (b * h**3 + h * b**3) / 36.0, rel=1e-13)


def test_profile_is_the_body_its_surface_encloses() -> None:
    corners = [[500.0, 3], [502, 3], [502.5, 4], [501, 4.2], [501.2, 9], [500.1, 9], [499.8, 5]]
    pier = profile(corners, length=2.0, density=DENSITY, name="pier")
    assert_same_mass(polyhedron(pier.vertices, pier.triangles, density=DENSITY, name="pier"), pier, rtol=1e-12)


def test_profile_either_way_round_and_closed_or_not_is_one_body() -> None:
    corners = [[0.0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3]]
    forward = profile(corners, length=2.0, density=DENSITY, name="L")
    for other in (corners[::-1], [*corners, corners[0]], corners[3:] + corners[:3]):
        assert_same_mass(profile(other, length=2.0, density=DENSITY, name="L"), forward, rtol=1e-14)


def test_profile_in_the_form_of_an_L_is_two_boxes() -> None:
    corner = profile([[0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3]], length=2.0, density=DENSITY, name="L")
    foot = box(thickness=2.0, length=2.0, height=1.0, base=[1.0, 0.0, 0.0], density=DENSITY, name="foot")
    stem = box(thickness=1.0, length=2.0, height=2.0, base=[0.5, 0.0, 1.0], density=DENSITY, name="stem")
    assert_same_mass(corner, join([foot, stem], name="L"), rtol=1e-14)


def test_a_box_cut_into_boxes_and_joined_is_the_box() -> None:
    whole = box(thickness=1.2, length=3.0, height=9.0, base=[4.0, 5.0, 6.0], density=DENSITY, name="whole")
    parts = [
        box(
            thickness=0.4,
            length=3.0,
            height=4.5,
            base=[3.6 + 0.4 * i, 5.0, 6.0 + 4.5 * k],
            density=DENSITY,
            name="part",
        )
        for i in range(3)
        for k in range(2)
    ]
    found = join(parts, name="whole")
    assert_same_mass(found, whole, rtol=1e-13)
    assert found.triangles.max() == len(found.vertices) - 1 == 47


def test_joined_bodies_of_two_densities_balance_at_the_heavier() -> None:
    heavy = box(thickness=1.0, length=1.0, height=1.0, base=[0.0, 0.0, 0.0], density=3000.0, name="stone")
    light = box(thickness=1.0, length=1.0, height=1.0, base=[4.0, 0.0, 0.0], density=1000.0, name="timber")
    pair = join([heavy, light], name="pair")
    np.testing.assert_allclose(pair.centroid, [1.0, 0.0, 0.5], rtol=1e-15, atol=0.0)
    # each 1/6 m about itself; 3000 at 1 m and 1000 at 3 m from the common centroid
    assert pair.inertia[1, 1] == pytest.approx(4000.0 / 6.0 + 3000.0 * 1.0 + 1000.0 * 9.0, rel=1e-14)


def test_random_convex_body_against_chance() -> None:
    body = TOWER
    rng = np.random.default_rng(3)
    low, high = body.vertices.min(axis=0), body.vertices.max(axis=0)
    points = rng.uniform(low, high, size=(400_000, 3))
    planes = ConvexHull(body.vertices).equations
    inside = points[np.all(points @ planes[:, :3].T + planes[:, 3] <= 0.0, axis=1)]
    assert body.mass == pytest.approx(DENSITY * np.prod(high - low) * len(inside) / len(points), rel=1e-2)  # chance
    np.testing.assert_allclose(body.centroid, inside.mean(axis=0), rtol=0.0, atol=2e-2)  # chance
    spread = np.cov(inside.T)
    wanted = body.mass * (np.trace(spread) * np.eye(3) - spread)
    np.testing.assert_allclose(body.inertia, wanted, rtol=0.0, atol=1e-2 * np.trace(wanted))  # chance


def test_finer_triangles_of_the_same_faces_change_nothing() -> None:
    body = TOWER
    corners = body.vertices[body.triangles]
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    u, v, w = (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0
    fine = np.concatenate([np.stack(each, axis=1) for each in ((a, u, w), (u, b, v), (w, v, c), (u, v, w))])
    triangles = np.arange(3 * len(fine)).reshape(-1, 3)
    assert_same_mass(polyhedron(fine.reshape(-1, 3), triangles, density=DENSITY, name="tower"), body, rtol=1e-13)


def test_turning_a_body_turns_its_inertia_tensor() -> None:
    body, turn = TOWER, Rotation.from_rotvec([0.3, -1.1, 0.7]).as_matrix()
    turned = polyhedron(body.vertices @ turn.T, body.triangles, density=DENSITY, name="tower")
    np.testing.assert_allclose(turned.centroid, turn @ body.centroid, rtol=1e-13, atol=0.0)
    np.testing.assert_allclose(
        turned.inertia, turn @ body.inertia @ turn.T, rtol=0.0, atol=1e-13 * np.trace(body.inertia)
    )


def test_arrays_cannot_be_changed() -> None:
    wall = box(thickness=1.0, length=1.0, height=1.0, base=[0, 0, 0], density=DENSITY, name="wall")
    for array in (wall.centroid, wall.inertia, wall.vertices, wall.triangles):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


BOX = {"thickness": 1.0, "length": 1.0, "height": 1.0, "base": [0.0, 0.0, 0.0], "density": DENSITY, "name": "wall"}


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({"thickness": -1.25}, 'body "wall": thickness is -1.25 m; give a positive'),
        ({"length": 0.0}, "length is 0 m"),
        ({"height": float("nan")}, "height is nan m"),
        ({"height": float("inf")}, "height is inf m"),
        ({"density": 0.0}, "density is 0 kg/m3"),
        ({"base": [0.0, 0.0]}, "base is .0.0, 0.0.; give three finite numbers"),
        ({"base": [0.0, 0.0, float("nan")]}, "base is"),
        ({"base": ["a", "b", "c"]}, "base is"),
    ],
)
def test_box_refuses(change: dict[str, object], text: str) -> None:
    with pytest.raises(GeometryError, match=text):
        box(**{**BOX, **change})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("points", "text"),
    [
        (
            [[0, 0], [1, 1], [1, 0], [0, 1]],
            r'^body "pier": the profile crosses .* at x = 0.5 m, z = 0.5 m; list its corners in order',
        ),
        ([[0, 0], [2, 0], [2, 2], [1, 0], [0, 2]], "crosses or touches itself at x = 1 m, z = 0 m"),
        ([[0, 0], [3, 0], [2, 0], [2, 2]], "crosses or touches itself at x = "),
        ([[0, 0], [1, 1], [2, 2]], "no area, its 3 corners lie on a line; give corners"),
        ([[0, 0], [1, 0], [1, 0], [0, 0]], "2 distinct corners; give three"),
        ([[1, 1], [1, 1], [1, 1]], "no corners"),
        ([], "profile is"),
        ([[0, 0], [1, 0], [1, float("nan")]], "give corners .x, z. of finite numbers"),
        ([[0, 0, 0], [1, 0, 0], [1, 1, 0]], "give corners .x, z."),
        ([[0, 0], [1, 0], [1]], "give corners .x, z."),
    ],
)
def test_profile_refuses(points: list[list[float]], text: str) -> None:
    with pytest.raises(GeometryError, match=text):
        profile(points, length=1.0, density=DENSITY, name="pier")


def test_profile_refuses_a_length_below_zero() -> None:
    with pytest.raises(GeometryError, match="length is -1 m"):
        profile([[0, 0], [1, 0], [1, 1]], length=-1.0, density=DENSITY, name="pier")


def test_joining_nothing_is_refused() -> None:
    with pytest.raises(GeometryError, match='block "pair": it joins no bodies'):
        join([], name="pair")


def test_polyhedron_refuses_no_volume_and_inside_out() -> None:
    points, triangles = TETRAHEDRON
    with pytest.raises(GeometryError, match=r"inside out .volume -0.166667 m3.; flip its normals"):
        polyhedron(points, triangles[:, ::-1], density=DENSITY, name="corner")
    with pytest.raises(GeometryError, match="no volume"):
        polyhedron(points * [1.0, 1.0, 0.0], triangles, density=DENSITY, name="sheet")
    sheet = (points * [1.0, 1.0, 0.0]) @ Rotation.from_rotvec([0.3, 0.2, 0.9]).as_matrix().T + [5e5, 4e6, 100.0]
    with pytest.raises(GeometryError, match="no volume"):
        polyhedron(sheet, triangles, density=DENSITY, name="sheet")
