"""Shares of a body's weight against beams and an independent minimisation; overburden against statics."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.constants import g
from scipy.optimize import minimize

from assess.errors import GeometryError
from assess.geometry.contact import ContactArea
from assess.geometry.solid import join
from assess.loads.bearing import bearing_contacts, overburden, share_of, shares, support
from tests.support.solids import cuboid


def resting(area, x, y) -> ContactArea:
    return ContactArea(area, np.array([x, y, 3.0]), np.array([0.0, 0.0, 1.0]), bearing=True)


FRONT, REAR = cuboid((0, 0, 0), (0.6, 5, 4), "front"), cuboid((6, 1, 0), (7, 3, 4), "rear")


@pytest.mark.parametrize("off", [1.0, 2.5, 4.0])
def test_a_beam_on_two_walls_by_the_lever_rule(off):
    heavy = cuboid((off, 1, 4.3), (off + 1, 3, 5), "heap", 3000.0)
    beam = cuboid((0.2, 1, 4), (6.5, 3, 4.3), "beam")
    floor = join([beam, heavy], name="floor")
    found = support(floor, block=[FRONT], others=[REAR])
    ends = 0.4, 6.25  # middles of both contacts: 0.2 to 0.6, 6 to 6.5
    assert set(found.others) == {"rear"}
    expected = (ends[1] - floor.centroid[0]) / (ends[1] - ends[0])
    assert share_of(found, centroid=floor.centroid) == pytest.approx(expected, rel=1e-9)
    turned_round = support(floor, block=[REAR], others=[FRONT])
    assert share_of(turned_round, centroid=floor.centroid) == pytest.approx(1 - expected, rel=1e-9)


def test_shares_of_several_contacts_are_the_least_of_all_that_are_in_equilibrium():
    """Contacts that yield in proportion to their area store the least energy, sum r^2 / A."""
    rng = np.random.default_rng(5)
    A, at = rng.uniform(0.2, 1.0, 5), rng.uniform(-3, 3, (5, 2))
    centroid = np.array([0.3, -0.2, 9.0])
    balance = [
        {"type": "eq", "fun": lambda r: r.sum() - 1},
        {"type": "eq", "fun": lambda r: r @ at - centroid[:2]},
    ]
    least = minimize(lambda r: (r**2 / A).sum(), A / A.sum(), constraints=balance, tol=1e-14)
    r = shares([resting(a, *p) for a, p in zip(A, at, strict=True)], centroid=centroid)
    np.testing.assert_allclose(r, least.x, atol=1e-6)  # as near as the minimiser comes
    assert r.sum() == pytest.approx(1.0, rel=1e-12)
    np.testing.assert_allclose(r @ at, centroid[:2], atol=1e-12)


def test_a_single_contact_carries_all_and_a_contact_that_would_hold_down_nothing():
    assert shares([resting(0.3, 1.0, 2.0)], centroid=np.array([5.0, 5.0, 0.0])) == pytest.approx([1.0])
    overhanging = [resting(0.3, 0.0, 0.0), resting(0.3, 2.0, 0.0)]
    np.testing.assert_allclose(shares(overhanging, centroid=np.array([3.0, 0.0, 0.0])), [-0.5, 1.5], rtol=1e-12)


def test_faces_it_only_pushes_against_carry_nothing():
    floor = cuboid((0.2, 1, 4), (6, 3, 4.3), "floor")  # on the front wall, against the face of the rear one
    rear = cuboid((6, 0, 0), (7, 5, 8), "rear")
    found = support(floor, block=[FRONT], others=[rear])
    assert not found.others["rear"].bearing
    assert bearing_contacts(found).others == {}


def test_overburden_of_two_floors_is_what_a_beam_and_a_free_body_bring():
    beam = cuboid((0, 1, 4), (7, 3, 4.3), "beam")
    heap = cuboid((0.1, 4, 4), (0.5, 4.8, 5), "heap")
    found = overburden([beam, heap], block=[FRONT], others=[REAR])
    on_front = beam.mass * (6.5 - 3.5) / (6.5 - 0.3)
    assert found.force == pytest.approx(g * (on_front + heap.mass), rel=1e-9)
    y = (on_front * 2.0 + heap.mass * 4.4) / (on_front + heap.mass)
    np.testing.assert_allclose(found.at, (0.3, y, 4.0), atol=1e-9)


def test_a_share_that_a_gap_of_three_centimetres_would_change_is_told():
    """A wall halfway below the beam, 3 cm short of it: on it the beam would put much of its weight."""
    beam, near = cuboid((0, 1, 4), (7, 3, 4.3), "beam"), cuboid((3, 1, 0), (3.5, 3, 3.97), "near")
    found = overburden([beam], block=[FRONT], others=[REAR, near])
    share, (least, most) = found.unsure["beam"]
    assert share == most == pytest.approx((6.5 - 3.5) / (6.5 - 0.3), rel=1e-9)
    areas, at = np.array([1.2, 2.0, 1.0]), np.array([0.3, 6.5, 3.25])  # by springs in proportion to the areas
    middle = areas @ at / areas.sum()
    turned = (3.5 - middle) / (areas @ (at - middle) ** 2)
    assert least == pytest.approx(1.2 * (1 / areas.sum() + (0.3 - middle) * turned), rel=1e-9)
    assert overburden([beam], block=[FRONT], others=[REAR]).unsure == {}


def test_what_an_overburden_shares_with_the_wall_is_the_wall_s():
    """A slab 0.3 m thick let into the wall by 0.1 m of its height, over 0.6 x 2 m, presses with what is left."""
    slab = cuboid((0, 1, 3.9), (0.6, 3, 4.2), "slab")
    density = slab.mass / (0.6 * 2.0 * 0.3)
    found = overburden([slab], block=[FRONT], others=[])
    assert found.force == pytest.approx(g * density * 0.6 * 2.0 * 0.2, rel=1e-9)


def test_a_body_that_would_lift_off_is_no_overburden():
    """It leans out beyond the far wall, so that it lies on that one alone."""
    out = join([cuboid((0.3, 1, 4), (7, 3, 4.3), "beam"), cuboid((8, 1, 4), (9, 3, 9), "heap", 9e3)], name="crane")
    with pytest.raises(GeometryError, match='"crane": by statics it lifts off the block'):
        overburden([out], block=[FRONT], others=[REAR])


@pytest.mark.parametrize(
    ("bodies", "words"),
    [
        ([cuboid((3, 1, 4), (5, 3, 4.3), "beam")], '"beam": it does not bear on the block; it lies 2.4 m away'),
        ([cuboid((0.6, 1, 3), (5, 3, 3.3), "beam")], "does not bear"),
        ([cuboid((0.6, 1, 4), (5, 3, 4.3), "beam")], "along an edge"),
        ([cuboid((-1, -1, -1), (5, 6, 0), "ground")], "the block stands on it"),
        ([], "no bodies"),
    ],
)
def test_bodies_that_do_not_stand_on_the_block_are_refused_by_name(bodies, words):
    with pytest.raises(GeometryError, match=words):
        overburden(bodies, block=[FRONT], others=[])
