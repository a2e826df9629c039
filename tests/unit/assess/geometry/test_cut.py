"""Cuts: what lies above against closed forms and other ways to the same part, and the section it stands on."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from assess.errors import GeometryError
from assess.geometry import mesh
from assess.geometry.boolean import intersect, shortest_distance
from assess.geometry.cut import Division, divide, inclined_plane, level_plane, split_upright
from assess.geometry.planar import base_of_section, lowest_corners, planar_body, slope_across, turns_about_a_corner
from assess.geometry.solid import (
    DRAWN_TRIANGLES,
    Solid,
    box,
    drawn_surface,
    join,
    polyhedron,
    profile,
    scale_along,
    scale_density,
)
from assess.geometry.surface import find_edges, volume
from tests.support.solids import (
    assert_same_mass,
    inside_out,
    irregular_tower,
    moved_solid,
    refine_mesh,
    surfaces_of,
)

DENSITY = 1900.0
TOWER = irregular_tower(density=DENSITY)
WALL = {"thickness": 1.0, "length": 3.0, "height": 8.2, "base": (0.0, 0.0, 0.0), "density": DENSITY, "name": "wall"}
HALF_TURN = Rotation.from_matrix(np.diag([-1.0, 1.0, -1.0]))  # what lay below a plane lies above its image
TAPERED = [[-1.0, 0.0], [1.0, 0.0], [0.4, 9.0], [-0.4, 9.0]]
T_SHAPE = [[0.0, 0], [1, 0], [1, 2], [1.5, 2], [1.5, 4], [-0.5, 4], [-0.5, 2], [0, 2]]
L_SHAPE = [[0.0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3]]


def wall(**changes) -> Solid:
    return box(**(WALL | changes))


def prism(corners) -> Solid:
    return profile(corners, length=2.0, density=DENSITY, name="prism")


CAVITY = wall(length=1.0, height=4.0, base=(0.2, 0.1, 1.0))
HOLLOW = polyhedron(  # a box of 2 x 3 x 6 m around a closed cavity of 1 x 1 x 4 m
    *surfaces_of(wall(thickness=2.0, height=6.0), inside_out(CAVITY)), density=DENSITY, name="hollow"
)


def cut(solid: Solid, plane, *more: Solid) -> Division:
    return divide([solid, *more], plane, where='mechanism "m"')


def plane_of(point, normal):
    return inclined_plane(point, normal, where='mechanism "m"')


def upper_part(solid: Solid, plane) -> Solid:
    (part,) = cut(solid, plane).above
    return part


def test_level_cut_of_a_box_is_a_lower_box() -> None:
    upper = cut(wall(), level_plane(4.77))
    assert_same_mass(upper.above[0], wall(height=8.2 - 4.77, base=(0.0, 0.0, 4.77)), rtol=1e-12)
    assert upper.above[0].name == "wall"
    body = planar_body(upper.above[0], direction=[1, 0, 0])
    ring = [(-0.5, 4.77), (0.5, 4.77), (0.5, 8.2), (-0.5, 8.2), (-0.5, 4.77)]
    np.testing.assert_allclose(body.outline[0], ring, rtol=1e-15)
    assert base_of_section(upper.foot, direction=[1, 0, 0]) == ((-0.5, 4.77), (0.5, 4.77))
    assert base_of_section(upper.foot, direction=[0, 2, 0]) == ((-1.5, 4.77), (1.5, 4.77))


def test_box_cut_along_a_plane_inclined_both_ways_by_closed_form() -> None:
    """Above z = h + a x + b y: the integrals over the base of powers of H and of h + a x + b y."""
    t, w, H, h, a, b = 1.0, 3.0, 8.2, 4.0, 0.5, -0.3
    found = upper_part(wall(), plane_of([0, 0, h], [-a, -b, 1.0]))
    A, xx, yy = t * w, t**2 / 12.0, w**2 / 12.0
    s2 = a * a * xx + b * b * yy
    V = A * (H - h)
    centre = np.array([-A * a * xx, -A * b * yy, A * (H * H - h * h - s2) / 2.0]) / V
    x2, z2 = A * (H - h) * xx, A * (H**3 - h**3 - 3.0 * h * s2) / 3.0
    assert found.mass == pytest.approx(DENSITY * V, rel=1e-12)
    np.testing.assert_allclose(found.centroid, centre, rtol=0.0, atol=1e-12)
    J = DENSITY * (x2 + z2 - V * (centre[0] ** 2 + centre[2] ** 2))
    assert found.inertia[1, 1] == pytest.approx(J, rel=1e-11)


@pytest.mark.parametrize("slope", [0.0, 1e-8, 1e-4, 0.3, -0.8, 4.0])
def test_tapered_prism_cut_level_and_inclined(slope: float) -> None:
    """The part above z = 4 + slope x is itself a prism, whose corners are where the plane meets the sloping sides."""
    half, taper = 1.0 - 0.6 * 4.0 / 9.0, slope * 0.6 / 9.0
    ends = [(x, 4.0 + slope * x) for x in (-half / (1.0 - taper), half / (1.0 + taper))]
    upper = cut(prism(TAPERED), plane_of([0.0, 7.0, 4.0], [-slope, 0.0, 1.0]))
    assert_same_mass(upper.above[0], prism([*ends, *TAPERED[2:]]), rtol=1e-11)
    np.testing.assert_allclose(base_of_section(upper.foot, direction=[1, 0, 0]), ends, rtol=0.0, atol=1e-11)
    mirrored = [(-x, z) for x, z in ends[::-1]]
    np.testing.assert_allclose(base_of_section(upper.foot, direction=[-1, 0, 0]), mirrored, rtol=0.0, atol=1e-11)
    assert slope_across(upper.foot, direction=[1, 0, 0]) < 1e-11


def test_length_of_the_normal_and_place_of_the_point_do_not_count() -> None:
    wanted = cut(TOWER, plane_of([3.0, -2.0, 6.0], [0.3, -0.2, 1.0]))
    for factor, along in ((1e-9, 0.0), (7.0, 3.0), (1e9, -40.0)):
        point = np.array([3.0, -2.0, 6.0]) + along * np.array([1.0, 0.0, -0.3])
        found = cut(TOWER, plane_of(point, np.array([0.3, -0.2, 1.0]) * factor))
        assert_same_mass(found.above[0], wanted.above[0], rtol=1e-12)


@pytest.mark.parametrize("solid", [wall(), TOWER, HOLLOW, prism(L_SHAPE)], ids=lambda solid: solid.name)
@pytest.mark.parametrize("normal", [(0.0, 0.0, 1.0), (0.4, 0.0, 1.0), (-0.5, 0.7, 1.0), (1.0, 0.0, 0.01)])
def test_what_lies_above_and_below_is_the_whole(solid: Solid, normal: tuple[float, ...]) -> None:
    point = solid.centroid + np.array([0.01, 0.02, 0.03])
    upper = upper_part(solid, plane_of(point, normal))
    turned = upper_part(
        moved_solid(solid, HALF_TURN, density=DENSITY),
        plane_of(point * [-1.0, 1.0, -1.0], np.array(normal) * [1.0, -1.0, 1.0]),
    )
    assert_same_mass(join([upper, moved_solid(turned, HALF_TURN, density=DENSITY)], name=solid.name), solid, rtol=1e-11)
    assert np.all((upper.vertices - point) @ normal > -1e-11)


def test_a_cut_of_a_cut_is_the_higher_cut() -> None:
    sloping = [plane_of([3.0, -2.0, z], [0.3, 0.1, 1.0]) for z in (4.0, 6.0)]
    for first, second in ((level_plane(2.0), level_plane(4.0)), (level_plane(1.0), sloping[1]), sloping):
        once, twice = cut(TOWER, second), cut(upper_part(TOWER, first), second)
        assert_same_mass(twice.above[0], once.above[0], rtol=1e-11)
        bases = [base_of_section(each.foot, direction=[0.6, 0.8, 0]) for each in (once, twice)]
        np.testing.assert_allclose(*bases, rtol=0.0, atol=1e-10)
    again = cut(upper_part(TOWER, level_plane(4.0)), level_plane(4.0))  # touches: nothing is left to remove
    assert_same_mass(again.above[0], upper_part(TOWER, level_plane(4.0)), rtol=1e-15)


def test_turning_the_body_and_the_plane_changes_nothing() -> None:
    normal, turn = np.array([0.3, 0.1, 1.0]), Rotation.from_rotvec([0.0, 0.0, 2.1]).as_matrix()
    still = cut(TOWER, plane_of([3.0, -2.0, 6.0], normal))
    solid = polyhedron(TOWER.vertices @ turn.T, TOWER.triangles, density=DENSITY, name="tower")
    moved = cut(solid, plane_of(turn @ [3.0, -2.0, 6.0], turn @ normal))
    here, there = np.array([1.0, 0.0, 0.0]), turn @ [1.0, 0.0, 0.0]
    bodies = planar_body(still.above[0], direction=here), planar_body(moved.above[0], direction=there)
    assert bodies[1].inertia == pytest.approx(bodies[0].inertia, rel=1e-12)
    np.testing.assert_allclose(bodies[1].centroid, bodies[0].centroid, rtol=0.0, atol=1e-12)
    bases = base_of_section(still.foot, direction=here), base_of_section(moved.foot, direction=there)
    np.testing.assert_allclose(*bases, rtol=0.0, atol=1e-11)


def test_opening_leaves_two_piers_and_a_base_from_one_to_the_other() -> None:
    portal = prism([[0.0, 0], [1, 0], [1, 3], [3, 3], [3, 0], [4, 0], [4, 5], [0, 5]])
    for elevation, area in ((1.2, 2 * 1.8 + 8.0), (3.0, 8.0)):
        upper = cut(portal, level_plane(elevation))
        assert upper.above[0].mass == pytest.approx(DENSITY * 2.0 * area, rel=1e-12)
        found = base_of_section(upper.foot, direction=[1, 0, 0])
        np.testing.assert_allclose(found, ((0.0, elevation), (4.0, elevation)), rtol=0.0, atol=1e-14)
    at_lintel = cut(portal, level_plane(3.0)).foot[:, 0]  # it lies on the piers, not on the opening
    np.testing.assert_allclose(np.unique(at_lintel.round(12)), [0.0, 1.0, 3.0, 4.0])


def test_cavity_is_cut_to_a_hollow_section() -> None:
    upper = cut(HOLLOW, level_plane(2.0))
    assert upper.above[0].mass == pytest.approx(DENSITY * (2 * 3 * 4 - 1 * 1 * 3), rel=1e-12)
    assert base_of_section(upper.foot, direction=[1, 0, 0]) == ((-1.0, 2.0), (1.0, 2.0))
    assert len(upper.foot) == 8


def test_section_of_an_L_is_that_of_its_stem_above_the_step() -> None:
    for elevation, right, area in ((0.4, 2.0, 3.2), (1.0, 1.0, 2.0), (1.7, 1.0, 1.3)):
        upper = cut(prism(L_SHAPE), level_plane(elevation))
        assert base_of_section(upper.foot, direction=[1, 0, 0])[1] == (right, elevation)
        assert upper.above[0].mass == pytest.approx(DENSITY * 2.0 * area, rel=1e-12)
        assert upper.above[0].vertices[:, 0].max() == right  # nothing of the step stays as a film


@pytest.mark.parametrize("off", [0.0, 1e-8, -1e-8, 1e-6, -1e-6])
def test_overhang_in_the_plane_of_the_cut_does_not_widen_the_base(off: float) -> None:
    """The underside of a corbel rests on nothing, also where rounding of the file puts it beside the plane."""
    upper = cut(prism(T_SHAPE), level_plane(2.0 + off))
    assert upper.above[0].mass == pytest.approx(DENSITY * 2.0 * 4.0, rel=2e-6)  # the plane moves by a millionth
    found = base_of_section(upper.foot, direction=[1, 0, 0])
    np.testing.assert_allclose(found, ((0.0, 2.0 + off), (1.0, 2.0 + off)), rtol=0.0, atol=1e-12)


def test_bodies_above_are_kept_below_dropped_and_between_cut() -> None:
    plinth = wall(thickness=2.0, height=1.0, name="plinth")
    shaft = wall(height=5.0, base=(0.0, 0.0, 1.0), name="shaft")
    cornice = wall(thickness=1.6, height=0.5, base=(0.0, 0.0, 6.0), name="cornice")
    upper = cut(plinth, level_plane(3.0), shaft, cornice)
    assert [body.name for body in upper.above] == ["shaft", "cornice"]
    assert upper.above[1] is cornice
    assert_same_mass(upper.above[0], wall(height=3.0, base=(0.0, 0.0, 3.0)), rtol=1e-12)
    assert base_of_section(upper.foot, direction=[1, 0, 0]) == ((-0.5, 3.0), (0.5, 3.0))
    for elevation, kept in ((1.0, (shaft, cornice)), (6.0, (cornice,))):  # at the joints
        at_joint = cut(plinth, level_plane(elevation), shaft, cornice)
        assert len(at_joint.above) == len(kept)
        assert all(found is wanted for found, wanted in zip(at_joint.above, kept, strict=True))
        assert base_of_section(at_joint.foot, direction=[1, 0, 0]) == ((-0.5, elevation), (0.5, elevation))


def test_two_bodies_side_by_side_share_the_section() -> None:
    buttress = wall(thickness=0.5, base=(0.75, 0.0, 0.0), height=6.0, density=2400.0, name="buttress")
    upper = cut(wall(), plane_of([0.0, 0.0, 3.0], [-0.5, 0.0, 1.0]), buttress)
    assert upper.above[1].mass == pytest.approx(2400.0 * 0.5 * 3.0 * (6.0 - 3.0 - 0.5 * 0.75), rel=1e-12)
    ends = base_of_section(upper.foot, direction=[1, 0, 0])
    np.testing.assert_allclose(ends, ((-0.5, 2.75), (1.0, 3.5)), rtol=0.0, atol=1e-12)


def test_mesh_far_from_the_origin(tmp_path: Path) -> None:
    near, shift = prism(TAPERED), np.array([5e5, 4e6, 100.0])
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in (near.vertices + shift).tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (near.triangles + 1).tolist()]
    (tmp_path / "pier.obj").write_text("\n".join(lines))
    far = mesh.load_solid(tmp_path / "pier.obj", density=DENSITY, name="pier")
    for normal in ([0.0, 0.0, 1.0], [-0.3, 0.2, 1.0]):
        wanted = cut(near, plane_of([0.0, 0.0, 4.0], normal))
        found = cut(far, plane_of(shift + np.array([0.0, 0.0, 4.0]), normal))
        assert found.above[0].mass == pytest.approx(wanted.above[0].mass, rel=1e-8)  # coordinates resolve 5e-10 m
        np.testing.assert_allclose(found.above[0].centroid - shift, wanted.above[0].centroid, rtol=0.0, atol=1e-8)
        bases = [base_of_section(each.foot, direction=[1, 0, 0]) for each in (found, wanted)]
        np.testing.assert_allclose(np.array(bases[0]) - [5e5, 100.0], bases[1], rtol=0.0, atol=1e-8)


def test_a_mesh_in_single_precision_is_cut_at_its_joint() -> None:
    """4.77 m is 4.7699999809 m there: the sliver between must neither become the section nor stay."""
    exact = prism([[0.0, 0], [1, 0], [1, 4.77], [1.3, 4.77], [1.3, 9], [-0.3, 9], [-0.3, 4.77], [0, 4.77]])
    rounded = polyhedron(exact.vertices.astype(np.float32), exact.triangles, density=DENSITY, name="T")
    upper = cut(rounded, level_plane(4.77))
    assert upper.above[0].mass == pytest.approx(DENSITY * 2.0 * 1.6 * 4.23, rel=1e-6)  # single precision
    found = base_of_section(upper.foot, direction=[1, 0, 0])
    np.testing.assert_allclose(found, ((0.0, 4.77), (1.0, 4.77)), rtol=0.0, atol=1e-12)


def test_plane_at_the_base_removes_nothing() -> None:
    upper = cut(wall(), level_plane(0.0))
    assert upper.above[0].mass == wall().mass
    assert base_of_section(upper.foot, direction=[1, 0, 0]) == planar_body(wall(), direction=[1, 0, 0]).base


def test_section_askew_and_section_that_slopes_across_are_noticed() -> None:
    level_foot, sloping = cut(wall(), level_plane(4.0)).foot, cut(wall(), plane_of([0, 0, 4.0], [0.0, -0.1, 1.0])).foot
    assert not turns_about_a_corner(level_foot, direction=[1, 0, 0])
    assert turns_about_a_corner(level_foot, direction=[1, 0.1, 0])
    assert not turns_about_a_corner(lowest_corners([wall()]), direction=[1, 0, 0])
    assert slope_across(level_foot, direction=[1, 0, 0]) == 0.0
    assert slope_across(sloping, direction=[1, 0, 0]) == pytest.approx(0.3, rel=1e-12)
    assert slope_across(sloping, direction=[0, 1, 0]) == pytest.approx(0.0, abs=1e-14)
    found = base_of_section(sloping, direction=[1, 0, 0])
    np.testing.assert_allclose(found, ((-0.5, 4.0), (0.5, 4.0)), rtol=0.0, atol=1e-13)


GAP = (wall(height=2.0), wall(height=2.0, base=(0.0, 0.0, 3.0), name="floating"))


@pytest.mark.parametrize(
    ("solids", "plane", "text"),
    [
        ([wall()], level_plane(9.0), 'mechanism "m": the cut at z = 9 m misses the body, which ends at z = 8.2 m'),
        ([wall()], level_plane(-1.0), "the cut at z = -1 m misses the body, which begins at z = 0 m"),
        ([wall()], level_plane(8.2), "the cut at z = 8.2 m leaves nothing of the body, which ends at z = 8.2 m"),
        ([wall()], plane_of([0, 0, 20], [3, 0, 4]), r"through .0, 0, 20. m with normal .0.6, 0, 0.8. misses the body"),
        ([wall()], plane_of([0, 0, -5], [3, 0, 4]), "misses the body, which begins at z = 0 m"),
        ([wall()], plane_of([-0.5, 0, 0], [0.5, 0, 1]), "passes through no masonry"),
        (GAP, level_plane(2.5), "the cut at z = 2.5 m passes through no masonry; what lies above begins at z = 3 m"),
    ],
)
def test_cuts_that_leave_no_mechanism_are_refused(solids, plane, text: str) -> None:
    with pytest.raises(GeometryError, match=text):
        divide(solids, plane, where='mechanism "m"')


@pytest.mark.parametrize(
    ("point", "normal", "text"),
    [
        ([0, 0, 0], [1, 0, 0], 'mechanism "m": the normal of the cut is .1, 0, 0.; give one that points up'),
        ([0, 0, 0], [0, 0, -1], "points up"),
        ([0, 0, 0], [0, 0, 0], "points up"),
        ([0, 0, float("nan")], [0, 0, 1], "three finite numbers"),
        ([0, 0, 0], [0, 1], "three finite numbers"),
    ],
)
def test_planes_refused(point, normal, text: str) -> None:
    with pytest.raises(GeometryError, match=text):
        plane_of(point, normal)


def test_surface_that_is_no_solid_is_refused() -> None:
    body = wall()
    torn = Solid("torn", body.mass, body.centroid, body.inertia, body.vertices, body.triangles[:-1])
    with pytest.raises(GeometryError, match='mechanism "m": body "torn" cannot be cut'):
        cut(torn, level_plane(4.0))


def test_both_sides_make_the_whole():
    for plane in (level_plane(3.3), inclined_plane([0.0, 0.0, 4.0], [0.3, 0.2, 1.0], where="m")):
        parts = divide([TOWER], plane, where="m")
        mass = sum(part.mass for part in (*parts.above, *parts.below))
        centroid = sum(part.mass * part.centroid for part in (*parts.above, *parts.below)) / mass
        assert mass == pytest.approx(TOWER.mass, rel=1e-12)
        np.testing.assert_allclose(centroid, TOWER.centroid, rtol=0.0, atol=1e-12)
        assert max(part.centroid[2] for part in parts.below) < min(part.centroid[2] for part in parts.above)


def test_what_two_bodies_share():
    one, other = wall(), wall(base=(0.8, 1.0, 3.0))  # 0.2 m x 2 m x 5.2 m in common
    shared = intersect(one, other)
    assert shared.volume == pytest.approx(0.2 * 2.0 * 5.2, rel=1e-9)
    assert shared.share == pytest.approx(shared.volume / 24.6, rel=1e-9)
    normals = np.cross(shared.corners[:, 1] - shared.corners[:, 0], shared.corners[:, 2] - shared.corners[:, 0]) / 2.0
    of_other = normals[shared.of_second].sum(axis=0)  # left, near and under side of the other body
    np.testing.assert_allclose(of_other, (-2.0 * 5.2, -0.2 * 5.2, -0.2 * 2.0), rtol=1e-9)
    assert intersect(one, wall(base=(2.0, 0.0, 0.0))) is None
    assert intersect(one, wall(base=(1.0, 0.0, 0.0))) is None  # they only touch


def test_distance_of_two_bodies():
    assert shortest_distance(wall(), wall(base=(4.0, 6.0, 0.0))) == pytest.approx(np.hypot(3.0, 3.0), rel=1e-9)
    assert shortest_distance(wall(), wall(base=(0.5, 0.0, 0.0))) == 0.0


def test_halves_of_a_body_about_an_upright_plane():
    body = TOWER
    normal = np.array([0.6, 0.8, 0.0])
    behind, before = split_upright(body, point=body.centroid, normal=normal)
    assert behind.mass + before.mass == pytest.approx(body.mass, rel=1e-9)
    centre = (behind.mass * behind.centroid + before.mass * before.centroid) / body.mass
    np.testing.assert_allclose(centre, body.centroid, atol=1e-9)
    reach = float(body.centroid @ normal)
    assert (behind.vertices @ normal).max() == pytest.approx(reach, abs=1e-9)
    assert (before.vertices @ normal).min() == pytest.approx(reach, abs=1e-9)


def test_a_cut_is_found_once_for_a_body_and_a_plane() -> None:
    """The body itself, and not one like it, at the same plane: of a body of twice the density the mass is twice."""
    wall = box(thickness=0.5, length=2.0, height=4.0, base=(0.0, 0.0, 0.0), density=1800.0, name="wall")
    heavy = replace(wall, mass=2.0 * wall.mass, inertia=2.0 * wall.inertia)
    found = divide([wall], level_plane(1.0), where="wall")
    assert divide([wall], level_plane(1.0), where="wall") is found
    assert divide([wall], level_plane(1.5), where="wall").above[0].mass == pytest.approx(wall.mass * 2.5 / 4.0)
    assert divide([heavy], level_plane(1.0), where="wall").above[0].mass == pytest.approx(2.0 * found.above[0].mass)
    with pytest.raises(ValueError, match="read-only"):
        found.foot[0] = 0.0


FINE = refine_mesh(prism(TAPERED), 5)  # of 12,288 triangles


@pytest.mark.parametrize("normal", [(0.0, 0.0, 1.0), (-0.4, 0.1, 1.0)])
def test_a_part_of_a_fine_mesh_is_drawn_with_a_part_of_a_simpler_one(normal: tuple[float, ...]) -> None:
    plane = plane_of((0.0, 0.0, 3.0), normal)
    parts = cut(FINE, plane)
    for part in (*parts.above, *parts.below):
        vertices, triangles = drawn_surface(part)
        assert len(part.triangles) > DRAWN_TRIANGLES > len(triangles)
        assert find_edges(triangles).closed
        assert volume(vertices, triangles) == pytest.approx(volume(part.vertices, part.triangles), rel=0.02)
        height = (vertices - plane.point) @ plane.normal
        assert min(abs(height.min()), abs(height.max())) < 1e-12
    again = cut(parts.above[0], level_plane(6.0)).above[0]
    assert again.drawn is not None
    assert volume(*again.drawn) == pytest.approx(volume(again.vertices, again.triangles), rel=0.02)


def test_a_part_of_a_coarse_mesh_is_drawn_as_it_is() -> None:
    (part,) = cut(TOWER, level_plane(4.0)).above
    assert part.drawn is None
    assert drawn_surface(part)[1] is part.triangles


def test_what_is_drawn_follows_a_change_of_shape_and_not_of_density() -> None:
    (part,) = cut(FINE, level_plane(1.0)).above
    assert drawn_surface(scale_density(part, 2.0)) == drawn_surface(part)
    wider = scale_along(part, direction=(1.0, 0.0, 0.0), middle=0.0, factor=2.0)
    assert volume(*drawn_surface(wider)) == pytest.approx(2.0 * volume(*drawn_surface(part)), rel=0.02)


def test_a_thin_plate_of_a_fine_mesh_is_drawn_with_its_own_surface() -> None:
    plate = refine_mesh(wall(thickness=0.02), 5)
    (part,) = cut(plate, level_plane(4.0)).above
    for each in (plate, part):
        assert volume(*drawn_surface(each)) == pytest.approx(volume(each.vertices, each.triangles), rel=1e-9)
