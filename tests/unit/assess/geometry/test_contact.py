"""Contacts of bodies against areas and centroids computed by hand, wherever the bodies stand and however meshed."""

from __future__ import annotations

from math import cos, radians, tan

import numpy as np
import pytest
import shapely
from scipy.spatial.transform import Rotation

from assess.geometry.contact import find_contact
from assess.geometry.solid import profile
from tests.support.solids import cuboid, moved_solid, refine_mesh

WALL = cuboid((-0.3, -2, 0), (0.3, 2, 4), "wall")
CASES = {  # body; area, centroid, bearing
    "on top, overhanging": (cuboid((-1, -1, 4), (0.1, 3, 4.2)), 0.4 * 3, (-0.1, 0.5, 4), True),
    "gap of 5 mm under it": (cuboid((-1, -1, 4.005), (0.1, 3, 4.2)), 0.4 * 3, (-0.1, 0.5, 4), True),
    "sunk in by 5 mm": (cuboid((-1, -1, 3.995), (0.1, 3, 4.2)), 0.4 * 3, (-0.1, 0.5, 4), True),
    "against the face": (cuboid((0.3, -1, 2), (5, 1, 2.2)), 2 * 0.2, (0.3, 0, 2.1), False),
    "5 mm off the face": (cuboid((0.305, -1, 2), (5, 1, 2.2)), 2 * 0.2, (0.3, 0, 2.1), False),
    "5 mm into the face": (cuboid((0.295, -1, 2), (5, 1, 2.2)), 2 * 0.2, (0.3, 0, 2.1), False),
    "built in by 0.2 m": (cuboid((0.1, -1, 2), (5, 1, 2.2)), 0.2 * 2, (0.2, 0, 2), True),
    "right through": (cuboid((-1, -1, 2), (5, 1, 2.2)), 0.6 * 2, (0, 0, 2), True),
    "the wall ends inside it": (cuboid((-1, -1, 3.9), (5, 1, 4.2)), 0.6 * 2, (0, 0, 3.9), True),
}


@pytest.mark.parametrize("case", CASES)
def test_area_centroid_and_bearing(case):
    body, area, centroid, bearing = CASES[case]
    contact = find_contact(WALL, body)
    assert contact is not None
    assert contact.bearing is bearing
    assert contact.area == pytest.approx(area, rel=1e-9)
    np.testing.assert_allclose(contact.centroid, centroid, atol=1e-9)
    np.testing.assert_allclose(contact.normal, (0, 0, 1) if bearing else (1, 0, 0), atol=1e-9)


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("degrees", [30.0, 135.0])
def test_turned_and_far_from_the_origin(case, degrees):
    body, area, centroid, bearing = CASES[case]
    turn, shift = Rotation.from_euler("z", degrees, degrees=True), np.array([4.5e5, 4.1e6, 120.0])
    contact = find_contact(moved_solid(WALL, turn, shift), moved_solid(body, turn, shift))
    assert contact is not None
    assert contact.bearing is bearing
    assert contact.area == pytest.approx(area, rel=1e-6)  # coordinates of 4e6 m resolve 1e-9 m
    np.testing.assert_allclose(contact.centroid - shift, turn.apply(centroid), atol=1e-6)


@pytest.mark.parametrize("case", CASES)
def test_a_finer_mesh_touches_alike(case):
    body, area, centroid, bearing = CASES[case]
    contact = find_contact(refine_mesh(WALL, 3), refine_mesh(body, 2))
    assert contact is not None
    assert contact.bearing is bearing
    assert contact.area == pytest.approx(area, rel=1e-6)
    np.testing.assert_allclose(contact.centroid, centroid, atol=1e-6)


@pytest.mark.parametrize(
    "body",
    [
        cuboid((0.32, -1, 2), (5, 1, 2.2)),  # 2 cm off
        cuboid((0.3, -1, 4), (5, 1, 4.2)),  # along an edge
        cuboid((-1, -3, -0.3), (1, 3, 0)),  # the wall stands on it
        cuboid((-1, -3, -0.3), (1, 3, 0.1)),  # the wall stands in it
        cuboid((3, 3, 0), (4, 4, 1)),
    ],
)
def test_what_does_not_load_the_wall(body):
    assert find_contact(WALL, body) is None


def test_the_tolerance_is_the_users():
    body = cuboid((0.32, -1, 2), (5, 1, 2.2))
    assert find_contact(WALL, body, tolerance=0.03).area == pytest.approx(0.4, rel=1e-9)
    assert find_contact(WALL, cuboid((0.305, -1, 2), (5, 1, 2.2)), tolerance=0.001) is None


def test_on_a_ledge_it_bears_though_it_also_leans_on_the_face_above():
    stepped = profile([[0, 0], [1, 0], [1, 3], [0.6, 3], [0.6, 6], [0, 6]], length=4.0, density=1000.0, name="wall")
    contact = find_contact(stepped, cuboid((0.6, -1, 3), (5, 1, 3.3)))
    assert contact.bearing
    assert contact.area == pytest.approx(0.4 * 2, rel=1e-9)
    np.testing.assert_allclose(contact.centroid, (0.8, 0, 3), atol=1e-9)


@pytest.mark.parametrize(("degrees", "bearing"), [(10.0, False), (20.0, True), (60.0, True)])
def test_a_battered_face_bears_only_where_it_leans_enough(degrees, bearing):
    """A face that leans back by the angle from the vertical, and a beam whose end is cut to it."""
    back = tan(radians(degrees))
    wall = profile([[0, 0], [-2, 0], [-2 - 2 * back, 2], [-2 * back, 2]], length=2.0, density=1000.0, name="wall")
    beam = profile(
        [[-back, 1], [4, 1], [4, 1.5], [-1.5 * back, 1.5]], length=1.0, density=1000.0, name="beam"
    )  # its end lies on the face
    contact = find_contact(wall, beam)
    assert contact.bearing is bearing
    assert contact.area == pytest.approx(0.5 / cos(radians(degrees)), rel=1e-9)
    np.testing.assert_allclose(contact.centroid, (-1.25 * back, 0, 1.25), atol=1e-9)


@pytest.mark.parametrize("slope", [0.02, 0.08])
def test_a_body_that_leans_off_touches_as_far_as_the_tolerance_reaches(slope):
    """A wedge of air opens from x = 0: the distance is slope x, so faces meet over 0.01 / slope."""
    top = cuboid((0, -1, 0), (3, 1, 1), "wall")
    body = profile([[0, 1], [3, 1 + 3 * slope], [3, 3], [0, 3]], length=2.0, density=1000.0, name="body")
    width = 0.01 / slope
    contact = find_contact(top, body)
    assert contact.area == pytest.approx(2.0 * width, rel=1e-9)
    assert contact.centroid[0] == pytest.approx(width / 2, rel=1e-9)


def test_a_rafter_on_the_edge_of_a_wall_bears_along_that_edge():
    """Its underside rises by 0.8 from the inner edge, x = 0.3: within 0.01 above the top over 0.0125 m."""
    rafter = profile([[0.3, 4], [-3, 6.64], [-3, 6.9], [0.3, 4.26]], length=3.0, density=500.0, name="rafter")
    contact = find_contact(WALL, rafter)
    assert contact.bearing
    assert contact.area == pytest.approx(3.0 * 0.0125, rel=1e-9)
    assert contact.centroid[0] == pytest.approx(0.3 - 0.0125 / 2, rel=1e-9)


@pytest.mark.parametrize("tolerance", [0.0095, 0.0105, 0.1, 0.3])
@pytest.mark.parametrize("gap", [0.0, 0.0094])
def test_a_contact_is_the_same_at_any_tolerance_that_finds_it(tolerance, gap):
    """A rafter that slopes by 0.8, let down onto the edge: a joint of 0.01 m is left over 0.01 / 0.8 of the top.

    The floor that is built in 0.3 m below the top of the wall bears there, and not on the top.
    """
    rafter = profile([[0.3, 4], [-3, 6.64], [-3, 6.9], [0.3, 4.26]], length=3.0, density=500.0, name="rafter")
    contact = find_contact(WALL, moved_solid(rafter, Rotation.identity(), [0, 0, gap]), tolerance=tolerance)
    assert contact.area == pytest.approx(3.0 * 0.01 / 0.8, rel=1e-6)
    np.testing.assert_allclose(contact.centroid, (0.3 - 0.01 / 0.8 / 2, 0, 4), atol=1e-6)
    floor = find_contact(WALL, cuboid((0.1, -1, 3.75), (5, 1, 3.9)), tolerance=tolerance)
    assert floor.area == pytest.approx(0.2 * 2, rel=1e-9)
    np.testing.assert_allclose(floor.centroid, (0.2, 0, 3.75), atol=1e-9)


def test_any_two_footprints_meet_in_their_intersection():
    rng = np.random.default_rng(3)
    for _ in range(20):
        polygons = [
            shapely.MultiPoint(rng.normal(size=(7, 2)) + rng.normal(scale=0.3, size=2)).convex_hull for _ in range(2)
        ]
        corners = [np.array(p.exterior.coords)[:-1] for p in polygons]
        lower, upper = (profile(c, length=1.0, density=1.0, name="p") for c in corners)
        lying = Rotation.from_matrix([[1, 0, 0], [0, 0, 1], [0, -1, 0]])  # x, y, z to x, z, -y
        below, above = moved_solid(lower, lying, [0, 0, -0.5]), moved_solid(upper, lying, [0, 0, 0.5])
        shared = polygons[0].intersection(polygons[1])
        contact = find_contact(below, above)
        assert contact.area == pytest.approx(shared.area, rel=1e-9)
        np.testing.assert_allclose(contact.centroid[:2], (shared.centroid.x, shared.centroid.y), atol=1e-9)


def test_large_meshes_touch_as_their_boxes_do():
    wall, floor = refine_mesh(WALL, 5), refine_mesh(CASES["against the face"][0], 4)
    assert len(wall.triangles) + len(floor.triangles) > 1.5e4
    contact = find_contact(wall, floor)
    assert contact.area == pytest.approx(0.4, rel=1e-6)
