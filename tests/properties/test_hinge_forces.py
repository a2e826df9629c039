"""What must hold for the forces at the hinges of every mechanism of the shipped examples."""

from __future__ import annotations

import pytest
from scipy.constants import g

from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Mechanism
from tests.support.examples import example_study

EXAMPLES = ("single_wall", "nepal_monuments", "san_leonardo_church", "san_leonardo_spire", "san_leonardo_tower")


@pytest.fixture(scope="module")
def mechanisms() -> list[Mechanism]:
    return [each for name in EXAMPLES for each in example_study(name, swept=False).mechanisms]


def test_supports_carry_the_weight_and_the_push_of_the_ground(mechanisms: list[Mechanism]) -> None:
    """None of these has loads: sum H = -M a and sum V = M g, over A and D."""
    seen = 0
    for mechanism in mechanisms:
        for branch in ("positive", "negative"):
            own = [each for each in hinge_forces(mechanism) if each.branch == branch]
            ends = [each for each in own if each.hinge[0] in "AD"]
            weight = mechanism.positive.mass * g
            if own:
                push = weight * own[0].acceleration / g
                assert sum(each.horizontal for each in ends) == pytest.approx(-push, rel=1e-9)
                assert sum(each.vertical for each in ends) == pytest.approx(weight, rel=1e-9)
                seen += 1
    assert seen >= 12


def test_faces_resolve_the_force_and_do_not_change_it(mechanisms: list[Mechanism]) -> None:
    found = [each for mechanism in mechanisms for each in hinge_forces(mechanism)]
    for each in found:
        size = each.horizontal**2 + each.vertical**2
        assert each.starting.normal**2 + each.starting.shear**2 == pytest.approx(size, rel=1e-9)
    assert any(abs(each.face[0]) > 0.1 for each in found)


def test_equivalent_blocks_have_none(mechanisms: list[Mechanism]) -> None:
    for mechanism in mechanisms:
        assert bool(hinge_forces(mechanism)) == (mechanism.kind != "equivalent-block")
