"""Sections against shapely's areas, chords and moments, and closed forms of textbook shapes."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, radians, sin

import numpy as np
import pytest
import shapely
from shapely.affinity import rotate, scale, translate

from assess.errors import GeometryError
from assess.geometry.cut import divide, heading, inclined_plane, level_plane
from assess.geometry.solid import box, profile
from assess.interfaces.kernel.columns import BEGIN, SUM_A, SUM_S, SUM_T, V0, V1, V2, W0, W1, A, S, T
from assess.interfaces.section import ContactSection, annulus, circle, hollow_rectangle, mirror, polygon, rectangle
from tests.support.bodies import in_joint_frame

EXACT = 1e-13
L_SHAPE = shapely.Polygon([(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)])
U_SHAPE = shapely.Polygon([(0, 0), (3, 0), (3, 2), (2.2, 2.1), (2, 0.7), (1, 0.6), (0.8, 2.3), (0, 2)])
HOLES = [[(0, 0), (0.9, 0.2), (0.4, 1.1)], [(1.5, -0.5), (2, 0), (1.6, 0.8)]]
PIERCED = shapely.Polygon([(-1, -2), (2.5, -1.2), (3, 1.9), (0.3, 2.8)], holes=HOLES)
REGIONS = {
    "triangle": shapely.Polygon([(0, 0), (3, 0), (0, 1.5)]),
    "L": L_SHAPE,
    "U": U_SHAPE,
    "pierced": PIERCED,
    "two parts": shapely.MultiPolygon([shapely.box(0, 0, 1, 2), shapely.box(2, 0.5, 2.4, 3)]),
    "part within a hole": shapely.MultiPolygon(
        [
            shapely.box(-3, -2, 3, 2).difference(shapely.box(-2, -1, 2, 1)),
            shapely.Point(0.3, 0.1).buffer(0.5, quad_segs=3),
        ]
    ),
}
DIRECTIONS = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (3.0, -4.0), (-0.3, -0.2)]
every_region = pytest.mark.parametrize("name", REGIONS)
every_direction = pytest.mark.parametrize("direction", DIRECTIONS)


def integral(region, power):
    """Of depth * offset^0 etc. over a region by triangles and a rule exact for quadratics."""
    total = 0.0
    for triangle in shapely.get_parts(shapely.constrained_delaunay_triangles(region)):
        corners = shapely.get_coordinates(triangle)[:3]
        middles = (corners + np.roll(corners, 1, axis=0)) / 2
        total += triangle.area * np.mean([power(x, y) for x, y in middles])
    return total


def width(section: ContactSection, x: float) -> float:
    p = section.pieces
    i = int(np.searchsorted(p[1:-1, BEGIN], x, side="right"))
    return float(p[i, W0] + p[i, W1] * (x - p[i, BEGIN]))


# ----------------------------------------------------------------------------------------------------------- polygons


@every_region
@every_direction
def test_whole_section(name, direction):
    region = in_joint_frame(REGIONS[name], direction)
    section = polygon(REGIONS[name], direction=direction)
    low_x, low_y, high_x, high_y = region.bounds
    assert section.depth == pytest.approx(high_x - low_x, rel=EXACT, abs=0.0)
    assert section.breadth == pytest.approx(high_y - low_y, rel=EXACT, abs=0.0)
    assert section.area == pytest.approx(region.area, rel=EXACT, abs=0.0)
    assert section.centroid == pytest.approx(region.centroid.x, rel=EXACT, abs=0.0)


@every_region
@every_direction
def test_widths_are_chords(name, direction):
    region = in_joint_frame(REGIONS[name], direction)
    section = polygon(REGIONS[name], direction=direction)
    for x in section.depth * np.random.default_rng(1).random(25):
        chord = shapely.LineString([(x, -9.0), (x, 9.0)]).intersection(region).length
        assert width(section, x) == pytest.approx(chord, rel=1e-12, abs=1e-13)


@every_region
@every_direction
def test_moments_up_to_each_knot(name, direction):
    """A, S, T by clipping; and their sums over depth, which are moments of the distance to the knot."""
    region = in_joint_frame(REGIONS[name], direction)
    for row in polygon(REGIONS[name], direction=direction).pieces[1:]:
        z = row[BEGIN]
        part = region.intersection(shapely.box(-1.0, -9.0, z, 9.0))
        expected = [
            integral(part, power)
            for power in (
                lambda x, y: 1.0,
                lambda x, y: x,
                lambda x, y: y,
                lambda x, y: z - x,  # noqa: B023
                lambda x, y: (z - x) * x,  # noqa: B023
                lambda x, y: (z - x) * y,  # noqa: B023
            )
        ]
        np.testing.assert_allclose(row[[A, S, T, SUM_A, SUM_S, SUM_T]], expected, rtol=1e-12, atol=1e-13)


@every_region
@every_direction
def test_mirrored_is_the_opposite_direction(name, direction):
    found = mirror(polygon(REGIONS[name], direction=direction))
    expected = polygon(REGIONS[name], direction=(-direction[0], -direction[1]))
    assert (found.depth, found.breadth) == pytest.approx((expected.depth, expected.breadth), rel=EXACT, abs=0.0)
    assert (found.area, found.centroid) == pytest.approx((expected.area, expected.centroid), rel=EXACT, abs=0.0)
    np.testing.assert_allclose(found.pieces[:, BEGIN], expected.pieces[:, BEGIN], rtol=0.0, atol=1e-14 * found.depth)
    for x in found.depth * np.random.default_rng(2).random(9):
        assert width(found, x) == pytest.approx(width(expected, x), rel=1e-12, abs=1e-12)
    np.testing.assert_allclose(found.pieces[:, A:], expected.pieces[:, A:], rtol=1e-12, atol=1e-13)


@every_region
def test_mirrored_twice_is_the_same(name):
    section = polygon(REGIONS[name], direction=(1.0, 0.7))
    again = mirror(mirror(section))
    np.testing.assert_allclose(again.pieces, section.pieces, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("degrees", [0.0, 90.0, 31.7, 200.0])
def test_turning_and_moving_region_and_direction_alike_changes_nothing(degrees):
    direction = cos(radians(degrees)), sin(radians(degrees))
    moved = translate(rotate(PIERCED, degrees, origin=(0, 0)), -400.0, 250.0)
    found, expected = polygon(moved, direction=direction), polygon(PIERCED, direction=(1.0, 0.0))
    assert found.area == pytest.approx(expected.area, rel=1e-11, abs=0.0)
    np.testing.assert_allclose(found.pieces[:, BEGIN], expected.pieces[:, BEGIN], rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(found.pieces[:, A:], expected.pieces[:, A:], rtol=1e-11, atol=1e-11)


def test_reflected_across_the_plane_of_motion_only_the_side_changes_sign():
    reflected = scale(PIERCED, 1.0, -1.0, origin=(0, 0))
    found, expected = polygon(reflected, direction=(1.0, 0.0)), polygon(PIERCED, direction=(1.0, 0.0))
    np.testing.assert_allclose(found.pieces[:, [A, S]], expected.pieces[:, [A, S]], rtol=1e-12, atol=1e-13)
    across = [V0, V1, V2, T, SUM_T]
    np.testing.assert_allclose(found.pieces[:, across], -expected.pieces[:, across], rtol=1e-11, atol=1e-11)


def test_offsets_are_positive_to_the_left():
    """Rocking towards +x, what lies ahead of the centroid of this wedge lies at greater y: to the left."""
    wedge = shapely.Polygon([(0, 0), (2, 2), (1, 1.6), (0, 1)])
    assert polygon(wedge, direction=(1.0, 0.0)).pieces[-2, T] > 0.0


def test_corners_in_either_order_and_repeated_are_the_same():
    once = polygon(U_SHAPE, direction=(1.0, 0.2))
    corners = shapely.get_coordinates(U_SHAPE)[::-1]
    again = polygon(shapely.Polygon(np.repeat(corners, 2, axis=0)), direction=(1.0, 0.2))
    np.testing.assert_allclose(again.pieces, once.pieces, rtol=EXACT, atol=EXACT)


def test_length_of_the_direction_does_not_matter():
    once = polygon(U_SHAPE, direction=(3.0, 4.0))
    for size in (1e-200, 1e200):
        found = polygon(U_SHAPE, direction=(3.0 * size, 4.0 * size))
        np.testing.assert_allclose(found.pieces, once.pieces, rtol=EXACT, atol=EXACT)


# ------------------------------------------------------------------------------------------------------ named shapes


def test_rectangle():
    section = rectangle(1.2, 3.5)
    assert (section.depth, section.breadth, section.centroid) == pytest.approx((1.2, 3.5, 0.6), rel=EXACT, abs=0.0)
    assert section.area == pytest.approx(1.2 * 3.5, rel=EXACT, abs=0.0)
    assert rectangle(1.2, 3.5, direction=(0.0, -1.0)).depth == pytest.approx(3.5, rel=EXACT, abs=0.0)
    diagonal = rectangle(3.0, 4.0, direction=(4.0, -3.0))
    assert (diagonal.depth, diagonal.breadth) == pytest.approx((24 / 5, 5.0), rel=EXACT, abs=0.0)


def test_hollow_rectangle_is_the_polygon_with_a_hole():
    ring = shapely.box(-3, -4, 3, 4).difference(shapely.box(-1.8, -2.8, 1.8, 2.8))
    found = hollow_rectangle(6.0, 8.0, inner=(3.6, 5.6), direction=(1.0, 1.0))
    np.testing.assert_allclose(found.pieces, polygon(ring, direction=(1.0, 1.0)).pieces, rtol=EXACT, atol=EXACT)


@pytest.mark.parametrize("section", [circle(1.5), annulus(1.5, inner=0.9)])
def test_discs(section):
    inner = 0.45 if len(section.discs) == 2 else 0.0
    assert (section.depth, section.breadth, section.centroid) == (1.5, 1.5, 0.75)
    assert section.area == pytest.approx(pi * (0.75**2 - inner**2), rel=EXACT, abs=0.0)
    assert mirror(section) is section


def test_section_is_read_only():
    for table in (rectangle(1.0, 2.0).pieces, circle(1.0).discs):
        with pytest.raises(ValueError, match="read-only"):
            table[0, 0] = 1.0


# ---------------------------------------------------------------------------------------------- section of a mesh's cut


@pytest.mark.parametrize(("direction", "depth"), [((1, 0, 0), 1.0), ((0, 1, 0), 3.0)])
def test_outline_of_a_level_cut(direction, depth):
    wall = box(thickness=1.0, length=3.0, height=4.0, base=(7.0, -5.0, 0.0), density=1.0, name="wall")
    plane = level_plane(2.0)
    region = divide([wall], plane, where="m").region
    section = polygon(region, direction=heading(plane, direction))
    assert (section.depth, section.area) == (
        pytest.approx(depth, rel=1e-12, abs=0.0),
        pytest.approx(3.0, rel=1e-12, abs=0.0),
    )


def test_compressed_edge_of_a_cut_is_the_foremost():
    """An L in plan, whose legs differ, so that each direction has its own depth and centroid."""
    corners = shapely.get_coordinates(L_SHAPE)[:-1]
    flat = profile(corners, length=2.0, density=1.0, name="L")  # stands in x-z
    turn = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    upright = replace(flat, vertices=flat.vertices @ turn.T)
    plane = level_plane(0.2)
    region = divide([upright], plane, where="m").region
    for direction in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0.3, 0.8, 0)):
        expected = polygon(scale(L_SHAPE, 1.0, -1.0, origin=(0, 0)), direction=direction[:2])
        found = polygon(region, direction=heading(plane, direction))
        assert (found.depth, found.centroid) == pytest.approx((expected.depth, expected.centroid), rel=1e-9, abs=0.0)


@pytest.mark.parametrize("slope", [0.3, -0.3])
def test_outline_of_an_inclined_cut_is_as_long_as_the_crack(slope):
    wall = box(thickness=1.0, length=3.0, height=4.0, base=(0.0, 0.0, 0.0), density=1.0, name="wall")
    plane = inclined_plane((0.0, 0.0, 2.0), (slope, 0.0, 1.0), where="m")
    section = polygon(divide([wall], plane, where="m").region, direction=heading(plane, (1, 0, 0)))
    assert section.depth == pytest.approx(np.hypot(1.0, slope), rel=1e-9, abs=0.0)
    assert section.breadth == pytest.approx(3.0, rel=1e-9, abs=0.0)


# ------------------------------------------------------------------------------------------------------------- errors

with np.errstate(invalid="ignore"):
    UNKNOWN = shapely.Polygon([(0, 0), (1, 0), (2, np.nan)])
BOWTIE = shapely.Polygon([(0, 0), (1, 1), (1, 0), (0, 1)])


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: rectangle(0.0, 1.0), "width is 0 m"),
        (lambda: rectangle(1.0, np.nan), "length is nan m"),
        (lambda: rectangle(1.0, np.inf), "length is inf m"),
        (lambda: circle(-1.0), "diameter is -1 m"),
        (lambda: annulus(1.0, inner=1.0), "hole, 1 m, is not less than its own, 1 m"),
        (lambda: annulus(1.0, inner=0.0), "inner diameter is 0 m"),
        (lambda: hollow_rectangle(1.0, 2.0, inner=(0.5, 2.5)), "length of its hole, 2.5 m"),
        (lambda: hollow_rectangle(1.0, 2.0, inner=(0.5, np.nan)), "length is nan m"),
        (lambda: polygon(BOWTIE, direction=(1, 0)), "its sides cross or touch one another"),
        (lambda: polygon(shapely.Polygon(), direction=(1, 0)), "area is 0 m2"),
        (lambda: polygon(shapely.Polygon([(0, 0), (1, 0), (2, 1e-14)]), direction=(1, 0)), "corners that enclose one"),
        (lambda: polygon(UNKNOWN, direction=(1, 0)), "not two finite numbers"),
        (lambda: rectangle(1.0, 2.0, direction=(0.0, 0.0)), "direction is [0.0, 0.0]"),
        (lambda: rectangle(1.0, 2.0, direction=(np.inf, 0.0)), "direction is"),
        (lambda: rectangle(1.0, 2.0, direction=(1.0, 0.0, 0.0)), "give two finite numbers"),
    ],
)
def test_bad_shapes_are_told(make, says):
    with pytest.raises(GeometryError) as told:
        make()
    assert says in str(told.value)
    assert "\n" not in str(told.value)
