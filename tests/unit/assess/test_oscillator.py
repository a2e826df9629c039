"""What an oscillator and a mechanism say of themselves in a session."""

from __future__ import annotations

from math import sqrt, tan

import numpy as np
import pytest
from scipy.constants import g

from assess.dynamics.history import peaks, product
from assess.geometry.planar import planar_body_from_values
from assess.mechanisms.single_block import single_block
from assess.oscillator import Oscillator, RockingBlock, interpolant, plain_branch
from records.record import make_record

BLOCK = RockingBlock(1200.0, 3.0, 0.14, 4.0 / 3.0 * 1200.0 * 9.0)


def rocking(sides: int) -> Oscillator:
    side = plain_branch(BLOCK, restitution=0.9)
    return Oscillator(side, side if sides == 2 else None, BLOCK.mass)


def test_a_plain_block_has_its_own_parameters() -> None:
    found = rocking(2)
    assert found.p == pytest.approx(sqrt(BLOCK.mass * g * BLOCK.radius / BLOCK.inertia), rel=1e-9)
    assert found.slenderness == pytest.approx(BLOCK.slenderness, rel=1e-12)
    assert found.multiplier == pytest.approx(tan(BLOCK.slenderness), rel=1e-12)


@pytest.mark.parametrize(("sides", "text"), [(2, "two-sided"), (1, "one-sided")])
def test_an_oscillator_is_one_line(sides: int, text: str) -> None:
    assert repr(rocking(sides)) == f"Oscillator(p=1.566 1/s, slenderness=0.14 rad, {text}, 1200 kg)"


def test_data_with_long_arrays_are_one_line() -> None:
    body = planar_body_from_values(mass=1200.0, centroid=(0.0, 3.0), inertia=4000.0, name="wall")
    made = single_block("wall", body, hinge=(0.4, 0.0), hinge_negative=(-0.4, 0.0))
    found = peaks([made.oscillator], [make_record("noise", np.ones(4000), 0.01)], product(1, 1, 1.0), equation="exact")
    assert repr(made) == "Mechanism('wall', single-block, two-sided, 1200 kg)"
    assert repr(made.positive) == "Chain(1 block, hinges A (0.4, 0) m, 0 loads)"
    assert repr(made.oscillator.positive).startswith("Branch(257 rotations to ")
    for data in (made, made.positive, made.oscillator, made.oscillator.positive, made.variants, found):
        assert len(repr(data)) < 400
        assert "\n" not in repr(data)


def test_what_is_derived_is_derived_once() -> None:
    body = planar_body_from_values(mass=1200.0, centroid=(0.0, 3.0), inertia=4000.0, name="wall")
    made = single_block("wall", body, hinge=(0.4, 0.0), hinge_negative=(-0.4, 0.0))
    assert made.oscillator is made.oscillator is made.variants.starting
    assert made.oscillator.positive.linearised is made.oscillator.positive.linearised


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("width", [1.0, 1e-9])
def test_three_nodes_are_a_parabola_however_near_they_lie(width: float) -> None:
    x = width * np.array([0.0, 0.4, 1.0])
    found = interpolant(1.0 + x if width == 1.0 else x, (x / width) ** 2)
    at = width * 0.7
    assert float(found(1.0 + at if width == 1.0 else at)) == pytest.approx(0.49, rel=1e-9)
