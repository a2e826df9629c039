"""Livesley 1978, IJNME 12:1853: limit analysis of blocks as a linear programme over the forces in their joints.

Static theorem: the multiplier at which an arch starts to move is the largest one for which forces in all joints balance
every voussoir, none of them in tension and none outside its joint (Heyman 1966). The program searches mechanisms
instead, the kinematic theorem: both must agree. No sliding: the force along a joint is free.
"""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from assess.errors import MechanismError
from assess.mechanisms.four_hinge import weakest_hinges
from tests.validation.derive.arches import filled, largest_multiplier, lopsided, mirrored, pointed, ring

ARCHES = {
    "7 voussoirs": ring(7),
    "16 voussoirs": ring(16),
    "thick": ring(12, thickness=0.3),
    "shallow": ring(9, opening=100),
    "semicircle": ring(11, thickness=0.18, opening=180),
    "filled": filled(),
    "stilted": pointed([5, 4.2, 4, 4, 4, 4.2, 6.0], [6, 5.2, 5, 5, 5, 5.3, 7.4], np.linspace(pi - 0.1, 0.2, 7)),
    **{f"lopsided {seed}": lopsided(seed) for seed in range(12)},
}


@pytest.mark.parametrize(("voussoirs", "joints"), ARCHES.values(), ids=ARCHES)
def test_least_mechanism_is_the_largest_balanced_multiplier(voussoirs, joints):
    expected = largest_multiplier(voussoirs, joints)
    assert expected > 0.01
    assert weakest_hinges(voussoirs, joints, name="arch").multiplier == pytest.approx(expected, rel=1e-9)


def test_the_other_way_too():
    """Pushed to the left: the programme on the mirror image."""
    for seed in range(6):
        voussoirs, joints = lopsided(seed)
        image, turned = mirrored(voussoirs, joints)
        expected = largest_multiplier(image, turned)
        assert weakest_hinges(image, turned, name="arch").multiplier == pytest.approx(expected, rel=1e-9)
        assert abs(expected / largest_multiplier(voussoirs, joints) - 1) > 1e-3


@pytest.mark.parametrize("thickness", [0.02, 0.07, 0.1])
def test_an_arch_that_does_not_stand_is_refused(thickness):
    """Semicircles below 0.1075 R fall by their own weight (Heyman 1966): no forces balance them at multiplier 0."""
    voussoirs, joints = ring(24, thickness=thickness, opening=180)
    assert largest_multiplier(voussoirs, joints) is None
    with pytest.raises(MechanismError, match='"arch": already falling: its own weight opens joints'):
        weakest_hinges(voussoirs, joints, name="arch")


def test_an_arch_that_barely_stands():
    """A little above 0.1075 R; many joints, as with few of them it stands thinner."""
    voussoirs, joints = ring(48, thickness=0.109, opening=180)
    expected = largest_multiplier(voussoirs, joints)
    assert 0.0 < expected < 0.01
    assert weakest_hinges(voussoirs, joints, name="arch").multiplier == pytest.approx(expected, rel=1e-7)
