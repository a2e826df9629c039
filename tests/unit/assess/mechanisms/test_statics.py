"""The vertical forces of hinges as compressions: a force at a support is taken by that support alone."""

from __future__ import annotations

import pytest
from scipy.constants import g

from assess.geometry.planar import planar_body_from_values
from assess.loads.load import Force
from assess.mechanisms.chain import Chain, RigidBlock
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.hinge_forces import hinge_compressions
from tests.support.bodies import PORTAL_HINGES

COLUMN, BEAM = RigidBlock(6400.0, (0.4, 2.0), 9000.0), RigidBlock(6440.0, (2.3, 4.35), 11000.0)
FAR = RigidBlock(6400.0, (4.2, 2.0), 9000.0)
BLOCKS = (COLUMN, BEAM, FAR)
HINGES, BACK = PORTAL_HINGES


def test_a_portal_presses_on_all_its_hinges_with_what_stands_on_them() -> None:
    a, b, c, d = hinge_compressions(Chain(BLOCKS, HINGES))
    assert min(a, b, c, d) > 0.0
    assert b + c == pytest.approx(BEAM.mass * g, rel=1e-12)
    assert (a - b, d - c) == pytest.approx((COLUMN.mass * g, FAR.mass * g), rel=1e-12)


@pytest.mark.parametrize(("place", "block"), [(0, 0), (3, 2)])
def test_a_lift_at_a_support_is_taken_from_that_support_and_pulls_where_it_is_larger(place: int, block: int) -> None:
    before = hinge_compressions(Chain(BLOCKS, HINGES))
    lift = 1.5 * before[place]
    expected = [force - lift * (number == place) for number, force in enumerate(before)]
    after = hinge_compressions(Chain(BLOCKS, HINGES, (Force("lift", (0.0, lift), HINGES[place], block),)))
    assert after == pytest.approx(expected, rel=1e-9)
    assert after[place] < 0.0


def test_a_support_that_would_have_to_pull_is_told() -> None:
    lift = 1.5 * hinge_compressions(Chain(BLOCKS, HINGES))[3]
    bodies = [
        planar_body_from_values(mass=each.mass, centroid=each.centroid, inertia=each.inertia, name="b")
        for each in (COLUMN, BEAM, FAR)
    ]
    loads = (Force("lift", (0.0, lift), HINGES[3], 2),)
    told = four_hinge("m", bodies, hinges=HINGES, sides="one", loads=loads).warnings
    assert [each.values["hinge"] for each in told if each.key == "hinge-in-tension"] == ["D"]


def test_the_top_of_a_wall_that_slides_passes_on_nothing() -> None:
    wall = (RigidBlock(1000.0, (0.2, 1.0), 100.0), RigidBlock(1000.0, (0.2, 3.0), 100.0))
    chain = Chain(wall, ((0.4, 0.0), (0.0, 2.0), (0.4, 4.0)))
    assert hinge_compressions(chain) == pytest.approx((2000.0 * g, 1000.0 * g, 0.0), rel=1e-12)
