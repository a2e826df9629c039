"""The contact against an independent one: regions clipped by shapely, discs by scipy's quadrature, roots by brentq."""

from __future__ import annotations

from dataclasses import fields
from math import acos, cos, inf, isinf, nan, pi, sin

import numpy as np
import pytest
import shapely
from scipy.integrate import quad
from scipy.optimize import brentq

from assess.errors import InterfaceError
from assess.interfaces.contact import Contact, JointLaw, contact, out_of_plane_warning, semi_flexible_shift, thresholds
from assess.interfaces.section import ContactSection, annulus, circle, hollow_rectangle, mirror, polygon, rectangle
from tests.support.bodies import in_joint_frame

K, F = 3e8, 2.5e6
LAW = JointLaw(K, F)
AGREE = 1e-9

HOLES = [[(0, 0), (0.9, 0.2), (0.4, 1.1)], [(1.5, -0.5), (2, 0), (1.6, 0.8)]]
REGIONS = {
    "triangle": shapely.Polygon([(0, 0), (3, 0), (0, 1.5)]),
    "U": shapely.Polygon([(0, 0), (3, 0), (3, 2), (2.2, 2.1), (2, 0.7), (1, 0.6), (0.8, 2.3), (0, 2)]),
    "pierced": shapely.Polygon([(-1, -2), (2.5, -1.2), (3, 1.9), (0.3, 2.8)], holes=HOLES),
    "two parts": shapely.MultiPolygon([shapely.box(0, 0, 1, 2), shapely.box(2, 0.5, 2.4, 3)]),
}
DIRECTIONS = [(1.0, 0.0), (-3.0, 4.0)]
DISCS = {"circle": (0.75, 0.0), "thick ring": (0.75, 0.4), "thin ring": (2.0, 1.9)}


# ------------------------------------------------------------------------------------------------- independent answers


def moments(region):
    """1, x, y, x^2, x y over a region, by its triangles."""
    triangles = shapely.get_coordinates(shapely.get_parts(shapely.constrained_delaunay_triangles(region)))
    corners = triangles.reshape(-1, 4, 2)[:, :3]
    areas = np.abs(np.cross(*(np.diff(corners, axis=1).transpose(1, 0, 2) @ np.eye(2, 3)))[:, 2]) / 2
    x, y = ((corners + np.roll(corners, 1, axis=1)) / 2).transpose(2, 0, 1)  # at mid-sides: exact for quadratics
    return np.array([areas @ each.mean(axis=1) for each in (np.ones_like(x), x, y, x**2, x * y)])


class Clipped:
    """What a face carries, from the region left of the depths where it opens and where it is crushed."""

    def __init__(self, region):
        self.region = region
        self.low_x, self.low_y, self.high_x, self.high_y = region.bounds
        self.depth, self.area = self.high_x, region.area

    def upto(self, z):
        if z <= 0.0:
            return np.zeros(5)
        return moments(self.region.intersection(shapely.box(-1.0, self.low_y - 1.0, z, self.high_y + 1.0)))

    def carried(self, u, phi, law):
        """Force, moment about the edge, moment about the centroid's line, crushed and open area."""
        elastic, sums = u / phi, np.zeros(3)
        for reach, sign in ((elastic, 1.0), (elastic - law.strength / law.stiffness / phi, -1.0)):
            a, x, y, xx, xy = self.upto(reach)
            sums += (
                sign
                * law.stiffness
                * phi
                * np.array([reach * a - x, reach * x - xx, reach * y - xy] if a else [0.0] * 3)
            )
        crushed = self.upto(elastic - law.strength / law.stiffness / phi)[0]
        return *sums, crushed, self.area - self.upto(elastic)[0]


class Rings:
    """The same for a disc without a concentric one, by quadrature over the angle at the centre."""

    def __init__(self, outer, inner):
        self.outer, self.inner = outer, inner
        self.depth, self.area = 2 * outer, pi * (outer**2 - inner**2)

    def over(self, z, power):
        total = 0.0
        for radius, sign in ((self.outer, 1.0), (self.inner, -1.0)):
            reach = np.clip((self.outer - z) / radius, -1.0, 1.0) if radius else 1.0
            part = quad(lambda t, r=radius: power(self.outer - r * cos(t)) * 2 * (r * sin(t)) ** 2, 0.0, acos(reach),
                        epsabs=1e-14, epsrel=1e-13)[0]  # fmt: skip
            total += sign * part
        return total

    def carried(self, u, phi, law):
        elastic, sums = u / phi, np.zeros(3)
        plastic = elastic - law.strength / law.stiffness / phi
        for reach, sign in ((elastic, 1.0), (plastic, -1.0)):
            if reach > 0.0:
                sums += sign * law.stiffness * phi * np.array(
                    [self.over(reach, lambda x, r=reach: r - x), self.over(reach, lambda x, r=reach: (r - x) * x), 0.0]
                )  # fmt: skip
        return *sums, self.over(max(plastic, 0.0), lambda x: 1.0), self.area - self.over(elastic, lambda x: 1.0)


def expected(face, *, law, force, phi):
    """Closing, resultant, sideways, crushed and open area."""
    most = (
        law.strength / law.stiffness if law.strength < inf else force / law.stiffness / face.area
    ) + phi * face.depth
    u = brentq(lambda u: face.carried(u, phi, law)[0] / force - 1.0, 0.0, most, xtol=1e-18, rtol=1e-14)
    carried, moment, across, crushed, opened = face.carried(u, phi, law)
    return u, moment / carried, across / carried, crushed, opened


def rotations(section: ContactSection, force: float) -> list[float]:
    """All regimes of the force: full and elastic; full and crushed, or partial and elastic; partial and crushed."""
    first, second = sorted(thresholds(section, LAW, normal_force=force))
    return [0.03 * first, 0.9 * first, 0.5 * (first + second), 1.1 * second, 20 * second]


def agrees(section: ContactSection, face, *, share: float) -> None:
    force = share * F * section.area
    phi = rotations(section, force)
    found = contact(section, LAW, normal_force=force, rotation=phi)
    for n, rotation in enumerate(phi):
        u, a_f, side, crushed, opened = expected(face, law=LAW, force=force, phi=rotation)
        D = section.depth
        assert found.closure[n] == pytest.approx(u, rel=AGREE, abs=0.0)
        assert found.resultant[n] == pytest.approx(a_f, rel=AGREE, abs=0.0)
        assert found.out_of_plane_eccentricity[n] == pytest.approx(side, rel=AGREE, abs=AGREE * D)
        assert found.crushed_area[n] == pytest.approx(crushed, rel=AGREE, abs=AGREE * section.area)
        assert found.open_area[n] == pytest.approx(opened, rel=AGREE, abs=AGREE * section.area)
        assert found.depth[n] == pytest.approx(min(u / rotation, D), rel=AGREE, abs=0.0)
        assert found.crushed_depth[n] == pytest.approx(max((u - F / K) / rotation, 0.0), rel=1e-8, abs=AGREE * D)
        assert found.peak_stress[n] == pytest.approx(min(K * u, F), rel=AGREE, abs=0.0)


@pytest.mark.parametrize("share", [0.04, 0.3, 0.62, 0.97])
@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("name", REGIONS)
def test_polygons(name, direction, share):
    agrees(polygon(REGIONS[name], direction=direction), Clipped(in_joint_frame(REGIONS[name], direction)), share=share)


@pytest.mark.parametrize("share", [0.01, 0.3, 0.62, 0.97])
@pytest.mark.parametrize("name", DISCS)
def test_discs(name, share):
    outer, inner = DISCS[name]
    section = annulus(2 * outer, inner=2 * inner) if inner else circle(2 * outer)
    agrees(section, Rings(outer, inner), share=share)


@pytest.mark.parametrize("name", REGIONS)
def test_joint_without_limit_of_strength(name):
    section, face = polygon(REGIONS[name], direction=(0.3, 1.0)), Clipped(in_joint_frame(REGIONS[name], (0.3, 1.0)))
    law, force = JointLaw(K), 1e6
    for phi in thresholds(section, law, normal_force=force)[0] * np.array([0.2, 1.5, 40.0]):
        found = contact(section, law, normal_force=force, rotation=phi)
        u, a_f, side, _, opened = expected(face, law=JointLaw(K, 1e99), force=force, phi=phi)
        assert (found.closure[0], found.resultant[0]) == pytest.approx((u, a_f), rel=AGREE, abs=0.0)
        assert found.out_of_plane_eccentricity[0] == pytest.approx(side, abs=AGREE)
        assert found.open_area[0] == pytest.approx(opened, rel=AGREE, abs=AGREE)
        assert found.peak_stress[0] == pytest.approx(K * u, rel=AGREE, abs=0.0)
        assert found.crushed_area[0] == found.crushed_depth[0] == 0.0


# ----------------------------------------------------------------------------------------------------------- thresholds

SECTIONS = {
    "rectangle": rectangle(1.2, 3.0),
    "hollow": hollow_rectangle(6.0, 8.0, inner=(3.6, 5.6), direction=(1.0, 0.4)),
    "circle": circle(1.5),
    "ring": annulus(1.5, inner=1.1),
    **{name: polygon(region, direction=(1.0, 0.3)) for name, region in REGIONS.items()},
}
every_section = pytest.mark.parametrize("section", SECTIONS.values(), ids=SECTIONS.keys())


@every_section
@pytest.mark.parametrize("share", [0.02, 0.4, 0.6, 0.98])
def test_thresholds_are_where_the_contact_opens_and_crushes(section, share):
    force = share * F * section.area
    opening, crushing = thresholds(section, LAW, normal_force=force)
    at_opening, at_crushing = (
        contact(section, LAW, normal_force=force, rotation=phi * np.array([1 - 1e-6, 1.0, 1 + 1e-6]))
        for phi in (opening, crushing)
    )
    assert at_opening.depth[0] == section.depth > at_opening.depth[2]
    assert at_opening.depth[1] == pytest.approx(section.depth, rel=1e-12, abs=0.0)
    assert at_crushing.peak_stress[0] < F == at_crushing.peak_stress[2]
    assert at_crushing.peak_stress[1] == pytest.approx(F, rel=1e-12, abs=0.0)
    assert (opening < crushing) == (share < 1 - section.centroid / section.depth)


@every_section
def test_shift_of_the_semi_flexible_hinge(section):
    """The resultant where crushing starts, whatever the stiffness."""
    force = 0.3 * F * section.area
    for k in (1e6, 1e12):
        law = JointLaw(k, F)
        _, crushing = thresholds(section, law, normal_force=force)
        found = contact(section, law, normal_force=force, rotation=crushing).resultant[0]
        assert semi_flexible_shift(section, law, normal_force=force) == pytest.approx(found, rel=1e-10, abs=0.0)
    assert semi_flexible_shift(section, JointLaw(inf, F), normal_force=force) == pytest.approx(
        found, rel=1e-10, abs=0.0
    )
    assert semi_flexible_shift(section, JointLaw(K), normal_force=force) == 0.0


# --------------------------------------------------------------------------------------------------------------- limits


@every_section
@pytest.mark.parametrize("phi", [0.0, 1e-300, 1e-17, 1e-12])
def test_at_rest_nothing_is_lost(section, phi):
    """At rest the resultant is at the centroid; turning by phi moves it by k I phi / N."""
    force = 0.4 * F * section.area
    found = contact(section, LAW, normal_force=force, rotation=phi)
    assert found.resultant[0] == pytest.approx(section.centroid, rel=1e-8 if phi == 1e-12 else 1e-13, abs=0.0)
    assert found.instantaneous_centre[0] == pytest.approx(section.centroid, rel=1e-13, abs=0.0)
    assert found.closure[0] == pytest.approx(force / (K * section.area), rel=1e-8 if phi == 1e-12 else 1e-13, abs=0.0)
    assert (found.depth[0], found.open_area[0], found.crushed_area[0]) == (section.depth, 0.0, 0.0)


def test_small_rotations_of_a_rectangle_to_the_last_digits():
    b, l, force = 1.2, 3.0, 1e6  # noqa: E741
    phi = np.geomspace(1e-12, 1e-3, 10)
    found = contact(rectangle(b, l), JointLaw(K), normal_force=force, rotation=phi * force / (K * b**2 * l))
    np.testing.assert_allclose(found.resultant, b / 2 - b * phi / 12, rtol=1e-15)
    np.testing.assert_allclose(found.closure, force / (K * b * l) * (1.0 + phi / 2), rtol=1e-15)


@every_section
def test_rigid_joints_are_the_limit_of_stiff_ones(section):
    """The plastic block of a joint with strength, its edge without: areas as well as places."""
    force, phi = 0.3 * F * section.area, 0.01
    block = contact(section, JointLaw(inf, F), normal_force=force, rotation=phi)
    stiff = contact(section, JointLaw(1e7 * F, F), normal_force=force, rotation=phi)
    for each in fields(Contact):
        found, limit = getattr(stiff, each.name)[0], getattr(block, each.name)[0]
        assert found == pytest.approx(limit, rel=1e-4, abs=1e-5), each.name
    assert block.crushed_area[0] == pytest.approx(force / F, rel=1e-13, abs=0.0)
    edge = contact(section, JointLaw(), normal_force=force, rotation=phi)
    assert (edge.resultant[0], edge.depth[0], edge.closure[0], edge.crushed_area[0]) == (0.0, 0.0, 0.0, 0.0)
    assert isinf(edge.peak_stress[0])
    assert edge.open_area[0] == section.area


def test_rigid_block_of_a_rectangle():
    b, l, force = 1.2, 3.0, 1e6  # noqa: E741
    found = contact(rectangle(b, l), JointLaw(strength=F), normal_force=force, rotation=[0.0, 0.1])
    np.testing.assert_allclose(found.crushed_depth, force / (F * l), rtol=1e-14)
    np.testing.assert_allclose(found.resultant, force / (F * l) / 2, rtol=1e-14)
    assert thresholds(rectangle(b, l), JointLaw(strength=F), normal_force=force) == (0.0, 0.0)
    assert thresholds(rectangle(b, l), JointLaw(), normal_force=force) == (0.0, inf)


@pytest.mark.parametrize("stiffness", np.geomspace(1e9, 1e15, 7))
def test_almost_all_crushed_and_the_far_edge_still_pressed(stiffness):
    """Only the last g of the depth is elastic, down to 4e-8 of it: half of what lets the far edge open."""
    b, l, f, phi = 1.3, 2.7, 2.1e6, 0.013  # noqa: E741
    g = 0.5 * f / (stiffness * phi)
    missing = stiffness * phi * l * g**2 / 2
    force = f * b * l - missing
    found = contact(rectangle(b, l), JointLaw(stiffness, f), normal_force=force, rotation=phi)
    moment = f * l * b**2 / 2 - missing * (b - g / 3)
    assert found.open_area[0] == 0.0
    assert found.depth[0] == b
    assert found.crushed_depth[0] == pytest.approx(b - g, rel=1e-9, abs=0.0)
    assert found.resultant[0] == pytest.approx(moment / force, rel=1e-12, abs=0.0)


def test_parts_that_do_not_touch_between_which_the_contact_opens():
    """Two piers: while the gap alone opens, all force is on the near one, whose resultant does not move to its edge."""
    piers = polygon(shapely.MultiPolygon([shapely.box(0, 0, 1, 2), shapely.box(3, 0, 4, 2)]), direction=(1.0, 0.0))
    force = 1e5
    phi = force / K * np.array([1.0, 1.5]) / (2 * (2.0 - 0.5))  # the near pier alone: opens at u = 2 phi ... 1.33 phi
    found = contact(piers, JointLaw(K), normal_force=force, rotation=phi)
    u = force / (K * 2.0) + 0.5 * phi
    np.testing.assert_allclose(found.closure, u, rtol=1e-13)
    np.testing.assert_allclose(found.open_area, 2.0, rtol=1e-13)
    np.testing.assert_allclose(found.resultant, 0.5 - K * phi * 2.0 / 12 / force, rtol=1e-12)


def test_plastic_block_that_ends_in_a_gap():
    """Where the near pier just carries the force, any depth in the gap is a solution: still the pier's middle.

    What the far pier takes goes with the square of the contact's depth in it, so rounding hides 1e-8 of that.
    """
    piers = polygon(shapely.MultiPolygon([shapely.box(0, 0, 1, 2), shapely.box(3, 0, 4, 2)]), direction=(1.0, 0.0))
    for law in (JointLaw(strength=F), JointLaw(1e12, F)):
        found = contact(piers, law, normal_force=2.0 * F, rotation=0.01)
        assert found.resultant[0] == pytest.approx(0.5, rel=1e-9, abs=0.0)
        assert found.crushed_area[0] == pytest.approx(2.0, rel=1e-9, abs=0.0)
        assert 1.0 - 1e-7 <= found.depth[0] <= 3.0 + 1e-7


# --------------------------------------------------------------------------------------------------------------- arrays


def test_forces_that_change_with_the_rotation():
    section, phi = SECTIONS["pierced"], np.array([1e-4, 0.03, 2e-3, 0.0, 0.5])
    forces = F * section.area * np.array([0.2, 0.9, 0.2, 0.5, 0.01])
    together = contact(section, LAW, normal_force=forces, rotation=phi)
    for n in range(5):
        alone = contact(section, LAW, normal_force=forces[n], rotation=phi[n])
        for each in fields(Contact):
            found, one = getattr(together, each.name)[n], getattr(alone, each.name)[0]
            assert found == pytest.approx(one, rel=1e-12, abs=1e-13), each.name
    at_one = contact(section, LAW, normal_force=forces, rotation=0.01)
    assert at_one.rotation.shape == at_one.resultant.shape == (5,)


def test_result_is_read_only():
    found = contact(SECTIONS["ring"], LAW, normal_force=1e5, rotation=[0.0, 0.01])
    for each in fields(found):
        with pytest.raises(ValueError, match="read-only"):
            getattr(found, each.name)[0] = 1.0


# --------------------------------------------------------------------------------------------- doubts, errors


def test_section_askew_is_doubted_with_the_size():
    section = SECTIONS["hollow"]
    found = contact(section, LAW, normal_force=1e6, rotation=0.01)
    text = str(out_of_plane_warning(section, found, interface="A"))
    assert f"{abs(found.out_of_plane_eccentricity[0]):.3g} m" in text
    assert "along the axis of rotation" in text


@pytest.mark.parametrize("section", [rectangle(1.0, 2.0), rectangle(1.0, 2.0, direction=(0, 1)), circle(1.0)])
def test_section_symmetric_about_the_plane_of_motion_is_not_doubted(section):
    found = contact(section, LAW, normal_force=1e5, rotation=[0.0, 0.1])
    assert out_of_plane_warning(section, found, interface="A") is None


SQUARE = rectangle(1.0, 1.0)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"normal_force": 0.0}, "normal force is 0 N"),
        ({"normal_force": -7e3}, "would have to pull with 7000 N"),
        ({"normal_force": nan}, "normal force is nan N"),
        ({"normal_force": inf}, "normal force is inf N"),
        ({"normal_force": F}, "2.5e+06 N, is 1 times what it can carry, 2.5e+06 N"),
        ({"normal_force": [1.0, 2 * F]}, "is 2 times what it can carry"),
        ({"law": JointLaw(0.0, F)}, "stiffness is 0 Pa/m"),
        ({"law": JointLaw(-1.0, F)}, "stiffness is -1 Pa/m"),
        ({"law": JointLaw(nan, F)}, "stiffness is nan Pa/m"),
        ({"law": JointLaw(K, 0.0)}, "strength is 0 Pa"),
        ({"law": JointLaw(K, nan)}, "strength is nan Pa"),
        ({"rotation": -0.1}, "rotation is -0.1 rad"),
        ({"rotation": [0.0, nan]}, "rotation is nan rad"),
        ({"rotation": inf}, "rotation is inf rad"),
    ],
)
def test_what_cannot_be_is_told_in_one_line(given, says):
    case = {"law": LAW, "normal_force": 1e5, "rotation": 0.01, **given}
    law = case.pop("law")
    with pytest.raises(InterfaceError) as told:
        contact(SQUARE, law, **case, where='mechanism "w": interface A')
    assert says in str(told.value)
    assert str(told.value).startswith('mechanism "w": interface A: ')
    assert "\n" not in str(told.value)


@pytest.mark.parametrize("verb", [thresholds, semi_flexible_shift])
def test_thresholds_refuse_the_same(verb):
    for force in (0.0, 2 * F, nan):
        with pytest.raises(InterfaceError, match="its normal force"):
            verb(SQUARE, LAW, normal_force=force, where="w")


def test_mirrored_section_is_the_other_sense_of_rotation():
    region = REGIONS["U"]
    one, other = polygon(region, direction=(1.0, 0.3)), polygon(region, direction=(-1.0, -0.3))
    phi = np.linspace(0.0, 0.05, 9)
    found = contact(mirror(one), LAW, normal_force=2e6, rotation=phi)
    wanted = contact(other, LAW, normal_force=2e6, rotation=phi)
    for each in fields(Contact):
        np.testing.assert_allclose(getattr(found, each.name), getattr(wanted, each.name), rtol=1e-11, atol=1e-12)
