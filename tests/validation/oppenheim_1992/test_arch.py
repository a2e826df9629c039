"""Oppenheim 1992, EESD 21:1005: an arch of 157.5 degrees, R = 10 m, t/R = 0.15, in seven voussoirs.

It starts to move at 0.370 g. With joints elsewhere, 8 or 16 voussoirs, it does so at 0.3538 g.
"""

from __future__ import annotations

from math import asin, cos, pi, radians, sin

import numpy as np
import pytest

from assess.errors import ProjectError
from assess.mechanisms.chain import RigidBlock, mirror_point
from assess.mechanisms.four_hinge import weakest_hinges
from assess.oscillator import multiplier
from tests.support.projects import block, mechanism_of, project_toml
from tests.validation.derive.arches import sectors as arch

R, T, ANGLE = 10.0, 1.5, radians(157.5)
INNER, OUTER = R - T / 2, R + T / 2


@pytest.mark.parametrize(("count", "published", "digits"), [(7, 0.370, 5e-4), (8, 0.3538, 5e-5), (16, 0.3538, 5e-5)])
def test_least_multiplier_of_analytic_voussoirs(count, published, digits):
    assert weakest_hinges(*arch(count), name="arch").multiplier == pytest.approx(published, abs=digits)


@pytest.mark.parametrize(("count", "joints"), [(7, (0, 3, 5, 7)), (8, (0, 3, 6, 8)), (16, (0, 6, 12, 16))])
def test_hinges_alternate_between_intrados_and_extrados_from_springing_to_springing(count, joints):
    found = weakest_hinges(*arch(count), name="arch")
    assert found.joints == joints
    assert [float(np.hypot(*at)) for at in found.hinges] == pytest.approx([INNER, OUTER, INNER, OUTER], rel=1e-12)


def test_more_joints_never_make_it_stronger():
    values = [weakest_hinges(*arch(count), name="arch").multiplier for count in (4, 8, 16, 32)]
    assert values == sorted(values, reverse=True)


def test_choices_looked_at_in_portions_are_all_looked_at(monkeypatch):
    whole = weakest_hinges(*arch(16), name="arch")
    monkeypatch.setattr("assess.mechanisms.four_hinge.CHOICES_AT_ONCE", 7)
    assert weakest_hinges(*arch(16), name="arch") == whole


@pytest.mark.parametrize("count", [81, 10_000])
def test_more_voussoirs_than_can_be_searched_are_refused(tmp_path, count):
    with pytest.raises(ProjectError, match=r"joints\.count: .*must be 80 or less"):
        project(tmp_path, radial(count))
    with pytest.raises(ProjectError, match=r"joints: .*81"):
        project(tmp_path, [[[0, 0], [1, k]] for k in range(82)])


def test_the_order_of_the_ends_of_joints_does_not_matter():
    voussoirs, joints = arch(7)
    turned = weakest_hinges(voussoirs, [joint[::-1] for joint in joints], name="arch")
    assert turned == weakest_hinges(voussoirs, joints, name="arch")


def ring(*, pieces=280):
    """The arch's profile, of short chords; corners lie at every joint of 7 and 8 voussoirs."""
    angles = pi / 2 + np.linspace(ANGLE / 2, -ANGLE / 2, pieces + 1)
    outside = [(OUTER * cos(a), OUTER * sin(a)) for a in angles]
    return [*outside, *((INNER * cos(a), INNER * sin(a)) for a in angles[::-1])]


PROFILE = {"length": 2.0, "profile": [[float(x), float(z)] for x, z in ring()]}


def project(folder, joints, *, body=PROFILE, direction=(1, 0, 0)):
    own = block("arch", kind="four-hinge", hinges="minimum", direction=direction, joints=joints)
    text = project_toml(site=None, bodies={"arch": {"material": "brick", **body}}, mechanisms={"arch": own})
    return mechanism_of(folder, text)


def radial(count, *, centre=(0, 0)):
    return {"centre": centre, "first": "168.75 deg", "last": "11.25 deg", "count": count}


@pytest.mark.parametrize(("count", "published", "digits"), [(7, 0.370, 5e-4), (8, 0.3538, 1e-4)])
def test_profile_of_a_project_file(tmp_path, count, published, digits):
    mechanism = project(tmp_path, radial(count))
    rocker = mechanism.oscillator
    analytic = weakest_hinges(*arch(count), name="arch")
    for side in rocker.branches:
        assert multiplier(side)[0] == pytest.approx(published, abs=digits)
        assert multiplier(side)[0] == pytest.approx(analytic.multiplier, rel=1e-4)  # chords for arcs
    np.testing.assert_allclose(mechanism.positive.hinges, analytic.hinges, rtol=0.0, atol=1e-9)
    for one, other in zip(mechanism.positive.hinges, mechanism.negative.hinges, strict=True):
        assert one == pytest.approx(other, abs=1e-9)  # a symmetric arch is alike each way
    assert mechanism.restitution[0] == pytest.approx(mechanism.restitution[1], rel=1e-9)
    assert f"uplift multiplier {multiplier(rocker.positive)[0]:.4g}" in str(mechanism.warnings[0])


def test_mesh_of_a_project_file_in_another_place_and_direction(tmp_path):
    """The same arch as an OBJ in millimetres along y, with its centre off the origin; joints are in its own plane."""
    corners = ring(pieces=56)
    n = len(corners)
    lines = [f"v {1000 * y!r} {1000 * (3.0 + x)!r} {1000 * (1.5 + z)!r}" for y in (1.0, -1.0) for x, z in corners]
    for k in range(n):
        j = (k + 1) % n
        lines += [f"f {k + 1} {j + 1} {n + j + 1}", f"f {k + 1} {n + j + 1} {n + k + 1}"]
    half = n // 2
    for k in range(half - 1):
        a, b, c, d = k, k + 1, n - 2 - k, n - 1 - k
        lines += [f"f {a + 1} {d + 1} {c + 1}", f"f {a + 1} {c + 1} {b + 1}"]
        lines += [f"f {n + a + 1} {n + c + 1} {n + d + 1}", f"f {n + a + 1} {n + b + 1} {n + c + 1}"]
    (tmp_path / "arch.obj").write_text("\n".join(lines) + "\n")
    body = {"mesh": "arch.obj", "mesh_unit": "mm"}
    mechanism = project(tmp_path, radial(7, centre=(3.0, 1.5)), body=body, direction=(0, 2, 0))
    assert multiplier(mechanism.oscillator.positive)[0] == pytest.approx(0.370, abs=1e-3)
    expected = [(x + 3.0, z + 1.5) for x, z in weakest_hinges(*arch(7), name="arch").hinges]
    np.testing.assert_allclose(mechanism.positive.hinges, expected, rtol=0.0, atol=1e-5)
    back = [(x - 3.0, z + 1.5) for x, z in weakest_hinges(*arch(7), name="arch").hinges]
    np.testing.assert_allclose(mechanism.negative.hinges, back, rtol=0.0, atol=1e-5)


def test_the_weakest_mirrors_with_the_arch():
    """A lopsided arch: heavier to the right; to be pushed to the left is to push its mirror image to the right."""
    voussoirs, joints = arch(9)
    heavy = [RigidBlock(each.mass * (1 + k / 9), each.centroid, each.inertia) for k, each in enumerate(voussoirs)]
    image = [RigidBlock(each.mass, mirror_point(each.centroid), each.inertia) for each in heavy[::-1]]
    flipped = [(mirror_point(a), mirror_point(b)) for a, b in joints[::-1]]
    assert weakest_hinges(heavy, joints, name="a").multiplier != pytest.approx(
        weakest_hinges(image, flipped, name="a").multiplier
    )


def test_joints_of_a_wrong_centre_are_told_and_blamed(tmp_path):
    """Joints that do not point to the centre of the ring leave its feet behind and cut it askew."""
    askew = project(tmp_path, radial(8, centre=(0, 5)))
    assert "% of the arch lies beyond its first and last joint" in str(askew.warnings[0])
    assert askew.warnings[1].key == "joint-askew"
    assert any("stops at its first impact" in text for text in map(str, askew.warnings))
    told = project(tmp_path, radial(8, centre=(0, 2))).warnings[0].text
    left = asin(2 * cos(radians(11.25)) / 10) / radians(78.75)  # of each half, on the mean radius of 10 m
    assert float(told.split(" %")[0]) == pytest.approx(100 * left, rel=0.05)
    assert all(text.startswith("hinges of") for text in map(str, project(tmp_path, radial(8)).warnings))
