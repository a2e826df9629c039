"""Bodies in the plane of motion: inertia, base, outline."""

import itertools

import numpy as np
import pytest
import shapely
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from assess.errors import GeometryError
from assess.geometry.planar import PlanarBody, join_planar, planar_body, planar_body_from_values
from assess.geometry.solid import box, join, profile
from tests.support.solids import irregular_tower, moved_solid, solid_box

DENSITY = 1900.0
TOWER = irregular_tower(seed=11, corners=30, density=DENSITY)
L_CORNERS = [[0.0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3]]


def area(body: PlanarBody) -> float:
    return sum(shapely.Polygon(ring).area for ring in body.outline)


def test_box_along_its_thickness() -> None:
    wall = box(thickness=1.25, length=3.0, height=8.0, base=[10.0, 20.0, 30.0], density=DENSITY, name="wall")
    body = planar_body(wall, direction=[1, 0, 0])
    assert body.mass == wall.mass
    assert body.centroid == (10.0, 34.0)
    assert body.inertia == pytest.approx(wall.mass * (1.25**2 + 8.0**2) / 12.0, rel=1e-14)
    assert body.base == ((9.375, 30.0), (10.625, 30.0))
    assert body.outline == (((9.375, 30.0), (10.625, 30.0), (10.625, 38.0), (9.375, 38.0), (9.375, 30.0)),)


def test_box_along_its_length_and_backwards() -> None:
    wall = box(thickness=1.25, length=3.0, height=8.0, base=[10.0, 20.0, 30.0], density=DENSITY, name="wall")
    along = planar_body(wall, direction=[0, 1, 0])
    assert along.base == ((18.5, 30.0), (21.5, 30.0))
    assert along.inertia == pytest.approx(wall.mass * (3.0**2 + 8.0**2) / 12.0, rel=1e-14)
    assert planar_body(wall, direction=[-1, 0, 0]).base == ((-10.625, 30.0), (-9.375, 30.0))


def test_box_seen_over_its_corner() -> None:
    wall = box(thickness=2.0, length=2.0, height=8.0, base=[0.0, 0.0, 0.0], density=DENSITY, name="pier")
    body = planar_body(wall, direction=[1, 1, 0])
    assert body.base is not None
    np.testing.assert_allclose(body.base, [(-np.sqrt(2.0), 0.0), (np.sqrt(2.0), 0.0)], rtol=1e-15, atol=0.0)
    assert body.inertia == pytest.approx(wall.mass * (2.0**2 + 8.0**2) / 12.0, rel=1e-14)  # a square has no axes
    assert len(body.outline[0]) == 5
    assert area(body) == pytest.approx(2.0 * np.sqrt(2.0) * 8.0, rel=1e-14)


def test_inertia_is_that_of_the_mass_seen_from_the_side() -> None:
    """J = int (x2 + z2) dm with x along the direction: products of inertia with their sign."""
    wedge = profile([[0, 0], [3, 0], [0, 4]], length=2.0, density=DENSITY, name="wedge")
    slanted = moved_solid(wedge, Rotation.from_rotvec([0.0, 0.0, 0.6]), density=DENSITY)
    rng = np.random.default_rng(5)
    u, v = rng.uniform(size=(2, 500_000))
    x, z = np.where(u + v > 1.0, 1.0 - u, u) * 3.0, np.where(u + v > 1.0, 1.0 - v, v) * 4.0
    y = rng.uniform(-1.0, 1.0, size=x.size)
    points = np.column_stack([x, y, z]) @ Rotation.from_rotvec([0.0, 0.0, 0.6]).as_matrix().T
    direction = np.array([0.8, 0.6, 0.0])
    wanted = slanted.mass * (np.var(points @ direction) + np.var(points[:, 2]))
    assert planar_body(slanted, direction=direction).inertia == pytest.approx(wanted, rel=5e-3)  # half a million points


def test_turning_body_and_direction_together_changes_nothing() -> None:
    body = TOWER
    still = planar_body(body, direction=[1.0, 0.0, 0.0])
    for angle in (0.3, 2.0, -2.7):
        moved = planar_body(
            moved_solid(body, Rotation.from_rotvec([0.0, 0.0, angle]), density=DENSITY),
            direction=[np.cos(angle), np.sin(angle), 0.0],
        )
        assert moved.inertia == pytest.approx(still.inertia, rel=1e-12)
        np.testing.assert_allclose(moved.centroid, still.centroid, rtol=0.0, atol=1e-12)
        assert area(moved) == pytest.approx(area(still), rel=1e-12)
        np.testing.assert_allclose(moved.outline[0], still.outline[0], rtol=0.0, atol=1e-12)


def test_length_of_the_direction_does_not_count() -> None:
    body = TOWER
    wanted = planar_body(body, direction=[0.6, 0.8, 0.0])
    for factor in (1e-200, 7.0, 1e200):
        found = planar_body(body, direction=[0.6 * factor, 0.8 * factor, 0.0])
        assert found.inertia == pytest.approx(wanted.inertia, rel=1e-14)


def test_outline_of_a_convex_body_is_the_hull_of_its_shadow() -> None:
    body = TOWER
    direction = np.array([0.28, 0.96, 0.0])
    shadow = np.column_stack([body.vertices @ direction, body.vertices[:, 2]])
    found = planar_body(body, direction=direction)
    assert len(found.outline) == 1
    hull = ConvexHull(shadow)
    assert area(found) == pytest.approx(hull.volume, rel=1e-13)
    assert len(found.outline[0]) == len(hull.vertices) + 1
    assert shapely.LinearRing(found.outline[0]).is_ccw


def test_outline_of_an_L_is_its_profile_from_the_side_and_a_rectangle_from_the_front() -> None:
    wall = profile(L_CORNERS, length=2.0, density=DENSITY, name="L")
    side, front = planar_body(wall, direction=[1, 0, 0]), planar_body(wall, direction=[0, 1, 0])
    assert side.outline == (((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0), (0.0, 0.0)),)
    assert front.outline == (((-1.0, 0.0), (1.0, 0.0), (1.0, 3.0), (-1.0, 3.0), (-1.0, 0.0)),)
    assert planar_body(wall, direction=[-1, 0, 0]).outline[0][0] == (-2.0, 0.0)


def test_outline_far_from_the_origin_keeps_its_corners() -> None:
    wall = box(thickness=1.25, length=3.0, height=8.0, base=[5e5, 4e6, 100.0], density=DENSITY, name="wall")
    ring = planar_body(wall, direction=[0, 1, 0]).outline[0]
    assert ring == ((3999998.5, 100.0), (4000001.5, 100.0), (4000001.5, 108.0), (3999998.5, 108.0), (3999998.5, 100.0))


def test_outline_of_bodies_apart_touching_and_overlapping() -> None:
    for shift, rings, wanted in ((3.0, 2, 4.0), (1.0, 1, 4.0), (0.5, 1, 3.0)):
        body = planar_body(
            join([solid_box((1.0, 1.0, 2.0)), solid_box((1.0, 1.0, 2.0), (shift, 0.0, 0.0))], name="piers"),
            direction=[1, 0, 0],
        )
        assert len(body.outline) == rings
        assert area(body) == pytest.approx(wanted, rel=1e-14)
        assert all(len(ring) == 5 for ring in body.outline)


def test_outline_has_no_holes() -> None:
    """A portal seen from the front keeps its opening out of the list: the ring is the outer border."""
    bars = [(0.0, 0.0, 1.0, 4.0), (3.0, 0.0, 1.0, 4.0), (1.5, 0.0, 4.0, 0.5), (1.5, 3.5, 4.0, 0.5)]
    parts = [
        box(thickness=t, length=1.0, height=h, base=[x, 0.0, z], density=DENSITY, name="bar") for x, z, t, h in bars
    ]
    body = planar_body(join(parts, name="frame"), direction=[1, 0, 0])
    assert body.outline == (((-0.5, 0.0), (3.5, 0.0), (3.5, 4.0), (-0.5, 4.0), (-0.5, 0.0)),)


def test_base_of_a_body_on_an_edge_has_no_width() -> None:
    wedge = profile([[0, 0], [1, 2], [-1, 2]], length=2.0, density=DENSITY, name="wedge")
    assert planar_body(wedge, direction=[1, 0, 0]).base == ((0.0, 0.0), (0.0, 0.0))
    assert planar_body(wedge, direction=[0, 1, 0]).base == ((-1.0, 0.0), (1.0, 0.0))


def test_base_holds_vertices_within_rounding_of_the_lowest() -> None:
    foot = profile([[0, 0], [1.0, 1e-7], [1.0, 8], [0, 8]], length=2.0, density=DENSITY, name="rounded")
    tilted = profile([[0, 0], [1.0, 1e-3], [1.0, 8], [0, 8]], length=2.0, density=DENSITY, name="tilted")
    assert planar_body(foot, direction=[1, 0, 0]).base == ((0.0, 0.0), (1.0, 0.0))
    assert planar_body(tilted, direction=[1, 0, 0]).base == ((0.0, 0.0), (0.0, 0.0))


def test_joining_in_the_plane_is_joining_in_space() -> None:
    foot = box(thickness=2.0, length=2.0, height=1.0, base=[1.0, 0.0, 0.0], density=DENSITY, name="foot")
    stem = box(thickness=1.0, length=2.0, height=2.0, base=[0.5, 0.3, 1.0], density=800.0, name="stem")
    direction = [0.6, 0.8, 0.0]
    space = planar_body(join([foot, stem], name="L"), direction=direction)
    plane = join_planar([planar_body(each, direction=direction) for each in (foot, stem)], name="L")
    assert plane.mass == pytest.approx(space.mass, rel=1e-14)
    np.testing.assert_allclose(plane.centroid, space.centroid, rtol=0.0, atol=1e-14)
    assert plane.inertia == pytest.approx(space.inertia, rel=1e-14)
    np.testing.assert_allclose(plane.base, space.base, rtol=0.0, atol=1e-14)


def test_joining_a_body_without_geometry() -> None:
    wall = planar_body(
        box(thickness=1.0, length=1.0, height=2.0, base=[0.0, 0.0, 0.0], density=1000.0, name="wall"),
        direction=[1, 0, 0],
    )
    load = planar_body_from_values(mass=2000.0, centroid=(1.0, 3.0), inertia=0.0, name="load")
    for bodies in itertools.permutations((wall, load)):
        pair = join_planar(bodies, name="pair")
        assert pair.centroid == pytest.approx((0.5, 2.0), rel=1e-15)
        assert pair.inertia == pytest.approx(2000.0 * 5.0 / 12.0 + 4000.0 * (0.25 + 1.0), rel=1e-14)
        assert (pair.base, pair.outline) == (wall.base, wall.outline)
    assert join_planar([load], name="load").base is None
    with pytest.raises(GeometryError, match="joins no bodies"):
        join_planar([], name="pair")


def test_direct_values_stand_as_given() -> None:
    body = planar_body_from_values(mass=1200.0, centroid=(0.2, 6.1), inertia=35.0, name="bell")
    assert body == PlanarBody("bell", 1200.0, (0.2, 6.1), 35.0, (), None)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ({"mass": 0.0}, 'body "bell": mass is 0 kg'),
        ({"mass": float("inf")}, "mass is inf kg"),
        ({"inertia": -1.0}, "inertia is -1 kg m2"),
        ({"centroid": (0.0, float("nan"))}, "centroid is"),
        ({"centroid": (0.0, 0.0, 0.0)}, "give two finite numbers"),
    ],
)
def test_direct_values_refused(change: dict[str, object], text: str) -> None:
    given = {"mass": 1200.0, "centroid": (0.2, 6.1), "inertia": 35.0, "name": "bell", **change}
    with pytest.raises(GeometryError, match=text):
        planar_body_from_values(**given)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "direction", [[0, 0, 0], [0, 0, 1], [1, 0, 0.1], [1, 0], [float("nan"), 0, 0], [float("inf"), 0, 0]]
)
def test_directions_refused(direction: list[float]) -> None:
    wall = box(thickness=1.0, length=1.0, height=2.0, base=[0.0, 0.0, 0.0], density=DENSITY, name="wall")
    with pytest.raises(GeometryError, match=r"direction is .* give a horizontal vector such as .1, 0, 0."):
        planar_body(wall, direction=direction)
