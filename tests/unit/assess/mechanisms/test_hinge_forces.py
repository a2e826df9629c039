"""Forces at the hinges when a mechanism starts to rock, against equilibrium by hand."""

from __future__ import annotations

from dataclasses import replace
from math import cos, sin

import pytest
from scipy.constants import g

from assess.loads.load import Force, PointMass, Tie
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Face, Mechanism
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from assess.oscillator import HingeForces
from tests.support.bodies import body_at

LEVEL, ROOF = Face(friction=0.6), Face(normal=(0.0, -1.0), friction=0.6)


def forces(mechanism: Mechanism, *faces: Face) -> dict[str, HingeForces]:
    return {each.hinge: each for each in hinge_forces(replace(mechanism, faces=(faces, faces)))}


def block(*loads, **more) -> Mechanism:
    """A block of 1000 kg, 0.8 m thick, 4 m high."""
    return single_block(
        "m", body_at(1000.0, 0.0, 2.0), hinge=(0.4, 0.0), hinge_negative=(-0.4, 0.0), loads=loads, **more
    )


def spanning(*loads) -> Mechanism:
    """Two blocks of 1000 kg and 0.4 x 2 m on each other, held at the top."""
    halves, hinges = (body_at(1000.0, 0.0, 1.0), body_at(1000.0, 0.0, 3.0)), ((0.2, 0.0), (-0.2, 2.0), (0.2, 4.0))
    return two_block("m", *halves, hinges=hinges, sides="one", loads=loads)


def test_a_block_needs_the_friction_of_its_own_slenderness() -> None:
    """lambda = b / h, H = lambda W, V = W."""
    for each in forces(block(), LEVEL).values():
        assert (each.horizontal, each.vertical) == pytest.approx((-0.2 * 1000 * g, 1000 * g), rel=1e-12)
        assert each.required_friction == pytest.approx(0.2, rel=1e-12)
        assert each.acceleration == pytest.approx(0.2 * g, rel=1e-12)


def test_a_tie_takes_its_pull_off_the_hinge() -> None:
    """lambda = (W b + P z) / (W h); at the hinge lambda W - P; and at rest the base holds against the pull."""
    pull, weight = 300.0, 1000 * g
    tied = forces(block(Tie("t", pull, (0.0, 3.0), direction=(-1.0, 0.0))), LEVEL)["A"]
    pushed = (weight * 0.4 + pull * 3.0) / 2.0
    assert tied.acceleration == pytest.approx(pushed / 1000, rel=1e-12)
    assert tied.horizontal == pytest.approx(-(pushed - pull), rel=1e-12)
    assert (tied.resting.shear, tied.resting.normal) == pytest.approx((pull, weight), rel=1e-9)


def test_a_mass_that_is_not_bearing_pushes_without_pressing() -> None:
    """A floor at mid-height doubles the push: lambda = b / 2h for the block with as much mass beside it."""
    found = forces(block(PointMass("floor", 1000.0, (0.0, 2.0), bearing=False)), LEVEL)["A"]
    assert found.acceleration == pytest.approx(0.1 * g, rel=1e-12)
    assert (found.horizontal, found.vertical) == pytest.approx((-0.1 * 2000 * g, 1000 * g), rel=1e-12)
    assert found.resting.shear == pytest.approx(0.0, abs=1e-9)


def test_a_crack_that_slopes_turns_the_same_forces() -> None:
    slope = 0.3
    found = forces(block(), Face(normal=(sin(slope), cos(slope))))["A"]
    W = 1000 * g
    assert found.starting.normal == pytest.approx(W * (cos(slope) - 0.2 * sin(slope)), rel=1e-12)
    assert found.starting.shear == pytest.approx(-W * (sin(slope) + 0.2 * cos(slope)), rel=1e-12)


def test_a_wall_held_at_the_top() -> None:
    """With w the weight of a block: lambda = 0.4, H_A = -0.5 w, H_B = -0.1 w, H_C = -0.3 w; V_A = 2 w, V_B = w.

    Upper block about B: 2 H_C = 0.2 w + lambda w. Lower one about A: lambda w + 2 (lambda w - H_C) = 0.6 w.
    """
    w = 1000 * g
    found = forces(spanning(), LEVEL, LEVEL, ROOF)
    assert [found[name].horizontal / w for name in "ABC"] == pytest.approx([-0.5, -0.1, -0.3], rel=1e-12)
    assert [found[name].vertical / w for name in "ABC"] == pytest.approx([2.0, 1.0, 0.0], rel=1e-12)
    assert [found[name].required_friction for name in "ABC"] == [pytest.approx(0.25), pytest.approx(0.1), None]
    assert [found[name].held for name in "ABC"] == [False, False, True]
    assert found["A"].acceleration == pytest.approx(0.4 * g, rel=1e-12)


def test_what_stands_on_the_top_of_a_wall_presses_there() -> None:
    """A load N at C adds N to V of A and B. Virtual work: it sinks with C as C does."""
    load, w = 5000.0, 1000 * g
    found = forces(spanning(Force("roof", (0.0, -load), (0.2, 4.0), 1)), LEVEL, LEVEL, ROOF)
    assert [found[name].vertical for name in "ABC"] == pytest.approx([2 * w + load, w + load, -load], rel=1e-12)
    top = found["C"]
    assert top.starting.normal == pytest.approx(load, rel=1e-12)
    # upper block about B: 2 H = lambda w + 0.2 w + 0.4 N
    assert -2 * top.horizontal == pytest.approx(top.acceleration / g * w + 0.2 * w + 0.4 * load, rel=1e-12)


def test_a_portal_of_light_posts_leans_on_them_along_their_diagonals() -> None:
    """A post without weight passes on a force along the line of its two hinges: |H| / V is its slenderness."""
    posts, beam = body_at(1e-9, 0.2, 1.5), body_at(4000.0, 2.5, 3.2)
    far = body_at(1e-9, 4.8, 1.5)
    hinges = ((0.4, 0.0), (0.0, 3.0), (4.6, 3.0), (5.0, 0.0))
    found = forces(four_hinge("m", [posts, beam, far], hinges=hinges, sides="one"), *[LEVEL] * 4)
    assert [each.required_friction for each in found.values()] == pytest.approx([0.4 / 3.0] * 4, rel=1e-9)
    assert found["A"].vertical + found["D"].vertical == pytest.approx(4000 * g, rel=1e-9)
    assert found["B"].vertical == pytest.approx(found["A"].vertical, rel=1e-9)
    assert found["C"].horizontal == pytest.approx(found["D"].horizontal, rel=1e-9)


def test_a_chain_at_rest_is_taken_without_shear_and_with_its_normal_force() -> None:
    for each in forces(spanning(), LEVEL, LEVEL, ROOF).values():
        assert (each.resting.shear, each.resting.normal) == (0.0, each.starting.normal)


def test_an_equivalent_block_has_no_faces_and_so_no_forces() -> None:
    assert hinge_forces(block()) == ()
