"""What must hold for every contact: regions of one or two parts, with holes, in every regime."""

from __future__ import annotations

from itertools import pairwise
from math import cos, log2, pi, sin

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely.affinity import rotate, scale, translate

from assess.interfaces.contact import JointLaw, contact, thresholds
from assess.interfaces.section import annulus, circle, hollow_rectangle, mirror, polygon, rectangle
from tests.support.strategies import regions

K, F = 3e8, 2.5e6
LAW = JointLaw(K, F)
DIRECTION = (1.0, 0.0)
NAMED = {
    "rectangle": rectangle(1.2, 3.0),
    "hollow": hollow_rectangle(6.0, 8.0, inner=(3.6, 5.6), direction=(1.0, 0.4)),
    "circle": circle(1.5),
    "ring": annulus(1.5, inner=1.1),
}
SHARE = st.floats(0.03, 0.95)  # of the force that a section can carry
every_named = pytest.mark.parametrize("section", NAMED.values(), ids=NAMED.keys())


def upto(of, z):
    """1, x and x^2 over a region's depths up to z, x = 0 foremost in +x; by its triangles."""
    if z <= 0.0:
        return np.zeros(3)
    low, high = of.bounds[1] - 1, of.bounds[3] + 1
    part = of.intersection(shapely.box(of.bounds[2] - z, low, of.bounds[2] + 1, high))
    corners = shapely.get_coordinates(shapely.get_parts(shapely.constrained_delaunay_triangles(part)))
    (ax, ay), (bx, by), (cx, cy) = corners.reshape(-1, 4, 2)[:, :3].transpose(1, 2, 0)
    areas = np.abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2
    x = of.bounds[2] - np.array([ax + bx, bx + cx, cx + ax]) / 2  # at mid-sides: exact for quadratics
    return np.array([areas @ each.mean(axis=0) for each in (np.ones_like(x), x, x**2)])


def force(of, law, u, phi):
    """Of the stress clip(k (u - phi x), 0, f) [N]."""
    total = 0.0
    for reach, sign in ((u / phi, 1.0), ((u - law.strength / law.stiffness) / phi, -1.0)):
        a, x, _ = upto(of, reach)
        total += sign * law.stiffness * phi * (reach * a - x)
    return total


def strain_energy(of, law, u, phi):
    """Of the joint, k u^2 / 2 an area up to the strength, then f times what is closed beyond [J]."""
    total = 0.0
    for reach, sign in ((u / phi, 1.0), ((u - law.strength / law.stiffness) / phi, -1.0)):
        a, x, xx = upto(of, reach)
        total += sign * law.stiffness * phi**2 / 2 * (reach**2 * a - 2 * reach * x + xx)
    return total


def rotations(section, N):
    """Two in each of the regimes the force meets [6]."""
    first, second = sorted(thresholds(section, LAW, normal_force=N))
    return np.array(
        [0.3 * first, 0.9 * first, 0.7 * first + 0.3 * second, 0.2 * first + 0.8 * second, 1.3 * second, 9 * second]
    )


def slope(value, at):
    """Derivative by five points, at the step that agrees best with a finer one, as regimes may change near by.

    Its error is near 1e-11 of it; a regime that begins between the points would make it 1e-7.
    """
    found = [_slope(value, at, step=size * at) for size in (1e-3, 3e-4, 1e-4, 3e-5)]
    return min(pairwise(found), key=lambda pair: abs(pair[1] - pair[0]))[0]


def _slope(value, at, *, step):
    return (value(at - 2 * step) - 8 * value(at - step) + 8 * value(at + step) - value(at + 2 * step)) / (12 * step)


# --------------------------------------------------------------------------------------------------------- equilibrium


@given(of=regions(), share=SHARE)
def test_stress_carries_the_force(of, share):
    section = polygon(of, direction=DIRECTION)
    N = share * F * section.area
    found = contact(section, LAW, normal_force=N, rotation=rotations(section, N))
    carried = [force(of, LAW, u, phi) for u, phi in zip(found.closure, found.rotation, strict=True)]
    np.testing.assert_allclose(carried, N, rtol=1e-12)


@given(of=regions(), share=SHARE)
def test_moment_is_the_derivative_of_the_energy(of, share):
    """The joint's strain energy less the work of the force, at equilibrium: its derivative is -N a_f."""
    section = polygon(of, direction=DIRECTION)
    N = share * F * section.area

    def energy(phi):
        u = float(contact(section, LAW, normal_force=N, rotation=phi).closure[0])
        return strain_energy(of, LAW, u, phi) - N * u

    for phi in rotations(section, N):
        found = contact(section, LAW, normal_force=N, rotation=phi)
        assert slope(energy, phi) == pytest.approx(-N * found.resultant[0], rel=1e-9, abs=0.0)


@given(of=regions(), share=st.floats(0.05, 0.3))
def test_restoring_moment_is_the_derivative_of_the_full_potential(of, share):
    """A block on a face that turns by phi, so that depth x closes by u_e - x sin(phi): weight and joint together."""
    section = polygon(of, direction=DIRECTION)
    W, radius, slenderness = share * F * section.area, 4.0, 0.35

    def potential(phi):
        u = float(contact(section, LAW, normal_force=W, rotation=sin(phi)).closure[0])
        return W * (radius * cos(slenderness - phi) - u) + strain_energy(of, LAW, u, sin(phi))

    for phi in (0.02, 0.1, 0.2, 0.3):
        a_f = contact(section, LAW, normal_force=W, rotation=sin(phi)).resultant[0]
        restoring = W * (radius * sin(slenderness - phi) - a_f * cos(phi))  # thesis 6.54
        assert slope(potential, phi) == pytest.approx(restoring, rel=1e-9, abs=1e-9 * W * a_f)


@given(of=regions(), share=SHARE)
def test_closing_follows_the_pivot(of, share):
    section = polygon(of, direction=DIRECTION)
    N = share * F * section.area
    closing = lambda phi: float(contact(section, LAW, normal_force=N, rotation=phi).closure[0])  # noqa: E731
    for phi in rotations(section, N):
        pivot = contact(section, LAW, normal_force=N, rotation=phi).instantaneous_centre[0]
        assert slope(closing, phi) == pytest.approx(pivot, rel=1e-8, abs=0.0)


# ---------------------------------------------------------------------------------------------------- order, symmetries


EVERY_SECTION = st.sampled_from(list(NAMED.values())) | regions().map(lambda of: polygon(of, direction=DIRECTION))


@given(section=EVERY_SECTION, share=SHARE)
def test_contact_goes_one_way(section, share):
    """The resultant moves to the edge (the energy is convex), the contact opens and crushes, the edge sinks."""
    N = share * F * section.area
    phi = thresholds(section, LAW, normal_force=N)[0] * np.geomspace(1e-3, 1e5, 400)
    found = contact(section, LAW, normal_force=N, rotation=phi)
    slack = 1e-14 * section.depth
    assert np.all(np.diff(found.resultant) <= slack)
    assert np.all(np.diff(found.depth) <= slack)
    assert np.all(np.diff(found.closure) > 0.0)
    assert np.all(np.diff(found.crushed_depth) >= -slack)
    assert np.all((found.resultant > 0.0) & (found.resultant < section.depth))
    assert np.all((found.crushed_depth <= found.instantaneous_centre) & (found.instantaneous_centre <= found.depth))
    assert np.all(found.crushed_area + found.open_area <= section.area * (1 + 1e-14))
    assert np.all(found.peak_stress <= F)


@given(section=EVERY_SECTION, share=SHARE)
def test_what_is_missing_to_the_strength_is_a_contact_too(section, share):
    """f - sigma is the stress of the mirrored section under the force missing to f A."""
    N, whole = share * F * section.area, F * section.area
    phi = rotations(section, N)
    one = contact(section, LAW, normal_force=N, rotation=phi)
    other = contact(mirror(section), LAW, normal_force=whole - N, rotation=phi)
    moment = whole * section.centroid - (whole - N) * (section.depth - other.resultant)
    np.testing.assert_allclose(N * one.resultant, moment, rtol=1e-11, atol=1e-12 * whole * section.depth)
    np.testing.assert_allclose(
        N * one.out_of_plane_eccentricity,
        (whole - N) * other.out_of_plane_eccentricity,
        atol=1e-11 * whole * section.breadth,
    )
    np.testing.assert_allclose(one.crushed_area, other.open_area, atol=1e-11 * section.area)


@given(section=EVERY_SECTION, share=SHARE)
def test_only_force_over_strength_and_strength_over_stiffness_and_rotation_matter(section, share):
    N = share * F * section.area
    phi = rotations(section, N)
    found = contact(section, LAW, normal_force=N, rotation=phi)
    other = contact(section, JointLaw(K * 700.0, F * 7.0), normal_force=N * 7.0, rotation=phi / 100.0)
    np.testing.assert_allclose(other.resultant, found.resultant, rtol=1e-12)


@given(of=regions(), size=st.sampled_from([1e-3, 1e3]))
def test_larger_contact_of_the_same_shape(of, size):
    """Lengths times s: the same stresses, hence s^2 the force, at the rotation k phi s = the same."""
    small, large = (polygon(scale(of, s, s, origin=(0, 0)), direction=DIRECTION) for s in (1.0, size))
    N = 0.3 * F * small.area
    phi = rotations(small, N)
    found = contact(small, LAW, normal_force=N, rotation=phi)
    other = contact(large, LAW, normal_force=N * size**2, rotation=phi / size)
    np.testing.assert_allclose(other.resultant, size * found.resultant, rtol=1e-12)
    np.testing.assert_allclose(
        other.out_of_plane_eccentricity, size * found.out_of_plane_eccentricity, rtol=1e-10, atol=1e-12 * size
    )


@given(of=regions(), angle=st.floats(0, 360), by=st.tuples(st.floats(-30, 30), st.floats(-30, 30)))
def test_turned_and_moved_alike_nothing_changes(of, angle, by):
    moved = translate(rotate(of, angle, origin=(0, 0)), *by)
    one = polygon(of, direction=DIRECTION)
    other = polygon(moved, direction=(cos(np.radians(angle)), sin(np.radians(angle))))
    N = 0.3 * F * one.area
    phi = rotations(one, N)
    found, again = (contact(section, LAW, normal_force=N, rotation=phi) for section in (one, other))
    np.testing.assert_allclose(again.resultant, found.resultant, rtol=1e-11)
    np.testing.assert_allclose(again.out_of_plane_eccentricity, found.out_of_plane_eccentricity, rtol=1e-9, atol=1e-12)


# ------------------------------------------------------------------------------------------------------------ the rates


def orders(errors):
    """Powers with which errors fall as the quantity doubles."""
    return [log2(abs(coarse / fine)) for coarse, fine in pairwise(errors)]


@every_named
def test_stiff_joint_tends_to_the_plastic_block_with_the_square_of_its_stiffness(section):
    N, phi = 0.2 * F * section.area, 0.05
    block = contact(section, JointLaw(strength=F), normal_force=N, rotation=phi).resultant[0]
    k = 200 * F / (phi * section.depth) * 2.0 ** np.arange(4)
    errors = [contact(section, JointLaw(each, F), normal_force=N, rotation=phi).resultant[0] - block for each in k]
    assert orders(errors) == pytest.approx([2.0] * 3, abs=0.02)


def test_stiff_elastic_joint_tends_to_the_edge():
    """A rectangle with the root of its stiffness; a circle, whose width itself begins as a root, with the power 2/5."""
    for section, power in ((NAMED["rectangle"], 0.5), (NAMED["circle"], 0.4)):
        found = [
            contact(section, JointLaw(k), normal_force=1e5, rotation=0.05).resultant[0]
            for k in 1e14 * 2.0 ** np.arange(4)
        ]
        assert orders(found) == pytest.approx([power] * 3, abs=1e-3)


def test_strong_rigid_joint_tends_to_the_edge():
    """The plastic block is as deep as the strength is low; in a circle, with the power 2/3."""
    for section, power in ((NAMED["rectangle"], 1.0), (NAMED["circle"], 2 / 3)):
        found = [
            contact(section, JointLaw(strength=f), normal_force=1e5, rotation=0.05).resultant[0]
            for f in 1e10 * 2.0 ** np.arange(4)
        ]
        assert orders(found) == pytest.approx([power] * 3, abs=1e-3)


@every_named
def test_strong_joint_is_elastic_once_the_strength_is_not_reached(section):
    phi = np.geomspace(1e-6, 1e-2, 30)
    elastic = contact(section, JointLaw(K), normal_force=1e5, rotation=phi)
    strong = contact(section, JointLaw(K, 1.001 * float(elastic.peak_stress.max())), normal_force=1e5, rotation=phi)
    np.testing.assert_allclose(strong.resultant, elastic.resultant, rtol=1e-14)


@pytest.mark.parametrize("share", [0.05, 0.3, 0.8])
def test_polygon_of_many_sides_tends_to_the_circle(share):
    """With the square of their number; of 400 sides it is within 1e-4."""
    N, disc = share * F * pi * 0.75**2, circle(1.5)
    phi = rotations(disc, N)
    exact = contact(disc, LAW, normal_force=N, rotation=phi).resultant
    errors = []
    for n in (100, 200, 400):
        angles = np.linspace(0, 2 * pi, n, endpoint=False)
        of = shapely.Polygon(0.75 * np.column_stack([np.cos(angles), np.sin(angles)]))
        errors.append(contact(polygon(of, direction=DIRECTION), LAW, normal_force=N, rotation=phi).resultant - exact)
    for coarse, fine in pairwise(errors):
        np.testing.assert_allclose(np.log2(np.abs(coarse / fine)), 2.0, atol=0.1)
    np.testing.assert_allclose(errors[-1], 0.0, atol=1e-4 * 0.75)
