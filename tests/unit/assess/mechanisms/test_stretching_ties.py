"""Ties that stretch: their moment over rotation, yield, rupture and anchorage, against virtual work by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.constants import g

import assess
from assess.errors import AssessError, MechanismError
from assess.loads.load import Tie
from assess.mechanisms.branch_table import rigid_branch
from assess.mechanisms.chain import Chain, RigidBlock

MASS, THICKNESS, HEIGHT = 285e3 / g, 0.6, 6.0  # a wall of 285 kN
AREA, YOUNG, YIELD, LENGTH, STRAIN = 314e-6, 210e9, 235e6, 10.0, 0.02
STIFFNESS, MOST = YOUNG * AREA / LENGTH, AREA * YIELD
BAR = {"area": AREA, "young_modulus": YOUNG, "yield_stress": YIELD, "length": LENGTH, "fracture_strain": STRAIN}
AT, ANCHOR = (-0.3, 5.5), (-10.3, 5.0)


def tie(**changes: Any) -> Tie:
    made = Tie("tie 1", 10e3, AT, anchor=ANCHOR, length=LENGTH, fracture_strain=STRAIN, strength=2 * MOST)
    return replace(made, stiffness=STIFFNESS, yield_force=MOST, evidence="tests", **changes)


def chain(*ties: Tie) -> Chain:
    inertia = MASS / 12 * (THICKNESS**2 + HEIGHT**2)
    block = RigidBlock(MASS, (0.0, HEIGHT / 2), inertia)
    return Chain((block,), ((THICKNESS / 2, 0.0),), ties)


def lengthening(phi: np.ndarray) -> np.ndarray:
    """The distance of the tie's ends less that at rest, the block turned about its edge."""
    x, z = AT[0] - THICKNESS / 2, AT[1]
    there = THICKNESS / 2 + x * np.cos(phi) + z * np.sin(phi), z * np.cos(phi) - x * np.sin(phi)
    return np.asarray(
        np.hypot(there[0] - ANCHOR[0], there[1] - ANCHOR[1]) - np.hypot(AT[0] - ANCHOR[0], AT[1] - ANCHOR[1])
    )


def test_its_moment_is_the_work_of_its_force() -> None:
    """Over a step of rotation the restoring moment grows by the tie's force times its lengthening over that step."""
    held, free = (rigid_branch(chain(*ties), restitution=1.0, name="wall") for ties in ((tie(),), ()))
    phi, step = held.rotation[held.rotation < 0.03][1:], 1e-6
    bare = np.interp(phi, free.rotation, free.restoring)  # a sine over 257 nodes: to 1e-6
    slope = (lengthening(phi + step) - lengthening(phi - step)) / (2 * step)
    pull = np.minimum(10e3 + STIFFNESS * lengthening(phi), MOST)
    assert pull[0] < MOST == pull[-1]
    np.testing.assert_allclose(np.interp(phi, held.rotation, held.restoring) - bare, pull * slope, rtol=2e-4)


def test_at_rest_it_pulls_with_its_pretension() -> None:
    held, free = (rigid_branch(chain(*ties), restitution=1.0, name="wall") for ties in ((tie(),), ()))
    along, up = np.array([ANCHOR[0] - AT[0], ANCHOR[1] - AT[1]]) / np.hypot(10.0, 0.5)
    arm = -along * AT[1] + up * (AT[0] - THICKNESS / 2)
    assert held.restoring[0] - free.restoring[0] == pytest.approx(10e3 * arm, rel=1e-12)


def test_the_net_stiffness_is_zero_at_weight_times_height_over_the_square_of_the_arm() -> None:
    """k_cr = W h_G / h_t^2 of a level tie, 24 kN/m for 285 kN, 3 m and 6 m: softer, it does not straighten the wall."""
    critical = 285e3 * 3.0 / 6.0**2
    assert critical == pytest.approx(23.75e3)
    for share, sign in ((0.9, -1.0), (1.1, 1.0)):
        soft = replace(tie(), at=(0.3, 6.0), anchor=(-9.7, 6.0), pull=1e-3, stiffness=share * critical, yield_force=1e9)
        branch = rigid_branch(chain(soft), restitution=1.0, name="wall")
        assert np.sign(branch.restoring_spline(1e-4, 1)) == sign


@pytest.mark.parametrize(
    ("strength", "gone"), [(1.25, (MOST - 10e3) / STIFFNESS + LENGTH * STRAIN), (1.24, (MOST - 10e3) / STIFFNESS)]
)
def test_it_stretches_only_where_its_anchorage_has_a_quarter_to_spare(strength: float, gone: float) -> None:
    assert tie(strength=strength * MOST).elongation == pytest.approx(gone, rel=1e-12)


@pytest.mark.parametrize("degrees", [30.0, 60.0])
def test_a_tie_askew_to_the_motion_holds_with_what_lies_in_its_plane(degrees: float) -> None:
    """Of 10 kN at 60 degrees in plan 5 kN hold; per metre of the wall it lengthens by cos 60 and pulls by cos2 60 k."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    wall = assess.box(thickness=THICKNESS, length=5.0, height=HEIGHT, density=2000.0)
    moments = []
    for bar in (BAR, None):
        given = {**BAR, "strength": 2 * MOST} if bar else {}
        load = assess.TieLoad(force=10e3, at=(-0.3, 0, 5.5), anchor=(-0.3 - 10 * c, 10 * s, 5.5), **given)
        block = assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=[load])
        held = rigid_branch(block.mechanism.positive, restitution=1.0, name="wall")
        free = rigid_branch(replace(block.mechanism.positive, loads=()), restitution=1.0, name="wall")
        phi = 1e-4
        assert held.restoring[0] - free.restoring[0] == pytest.approx(10e3 * c * 5.5, rel=1e-9)
        moments.append(float(held.restoring_spline(phi)) - float(free.restoring_spline(phi)))
    stretched = moments[0] - moments[1]
    k = YOUNG * AREA / LENGTH * (1 + 10e3 / (YOUNG * AREA))
    x, z = -0.6, 5.5
    u = x * np.cos(phi) + z * np.sin(phi) - x
    e = np.sqrt((10 * c + u) ** 2 + (10 * s) ** 2 + (z * np.cos(phi) - x * np.sin(phi) - z) ** 2) - 10
    assert e == pytest.approx(c * u, rel=1e-3)
    assert stretched == pytest.approx(k * c**2 * u * z, rel=2e-3)


def test_an_anchorage_weaker_than_the_bar_ends_it() -> None:
    weak = tie(strength=0.5 * MOST)
    assert weak.elongation == pytest.approx((0.5 * MOST - 10e3) / STIFFNESS)
    branch = rigid_branch(chain(weak), restitution=1.0, name="wall")
    jumps = branch.rotation[1:][np.diff(branch.rotation) == 0.0]
    assert lengthening(jumps[-1:])[0] == pytest.approx(weak.elongation, rel=1e-9)


SLACK = 0.02


def test_a_slack_tie_pulls_from_its_slack_on() -> None:
    """L0 is the distance of its ends and the slack; it yields, and breaks, by the slack later than a taut one."""
    slack = tie(pull=0.0, slack=SLACK)
    assert slack.elongation == pytest.approx(SLACK + MOST / STIFFNESS + LENGTH * STRAIN, rel=1e-12)
    held, free = (rigid_branch(chain(*ties), restitution=1.0, name="wall") for ties in ((slack,), ()))
    assert held.restoring[0] == free.restoring[0]
    phi, step = held.rotation[held.rotation < 0.03][1:], 1e-6
    slope = (lengthening(phi + step) - lengthening(phi - step)) / (2 * step)
    pull = np.clip(STIFFNESS * (lengthening(phi) - SLACK), 0.0, MOST)
    assert 0.0 == pull[0] < MOST == pull[-1]
    added = np.interp(phi, held.rotation, held.restoring) - np.interp(phi, free.rotation, free.restoring)
    np.testing.assert_allclose(added, pull * slope, rtol=2e-4, atol=1e-6 * 285e3 * 0.3)
    nodes = lengthening(held.rotation)  # the table has a node where it becomes taut, and where it yields
    for mark in (SLACK, SLACK + MOST / STIFFNESS):
        assert np.abs(nodes - mark).min() < 1e-12


@pytest.mark.parametrize(
    ("force", "slack", "free"),
    [(10e3, 0.0, LENGTH / (1 + 10e3 / (YOUNG * AREA))), (None, SLACK, LENGTH + SLACK), (None, 0.0, LENGTH)],
)
def test_its_length_free_of_stress_is_less_by_pretension_and_more_by_slack(
    force: Any, slack: float, free: float
) -> None:
    load = facade(force=force, slack=slack, evidence="tests").mechanism.positive.loads[0]
    assert isinstance(load, Tie)
    assert load.length == pytest.approx(free, rel=1e-12)
    assert load.stiffness == pytest.approx(YOUNG * AREA / free, rel=1e-12)
    memory = facade(force=force, slack=slack, evidence="tests").mechanism.variants.of_histories[0].memory
    assert memory is not None
    assert memory.ties[0].elongation[0][0] == pytest.approx((force or 0.0) / load.stiffness - slack, rel=1e-12)
    assert memory.ties[0].gone == pytest.approx(MOST / load.stiffness + 0.1 * free, rel=1e-12)


def facade(**changes: Any) -> assess.Block:
    wall = assess.box(thickness=THICKNESS, length=4.0, height=HEIGHT, density=2000.0)
    load = assess.TieLoad(
        at=[0, 0, 5.5],
        anchor=[-10, 0, 5.5],
        **{"force": 10e3, **BAR, "strength": 2 * MOST, "fracture_strain": 0.1, **changes},
    )
    return assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=[load])


def test_histories_have_a_tie_that_a_source_vouches_for() -> None:
    record = assess.artificial_records(assess.spectrum("ec8", a_g=0.35 * g, ground_type="C"), count=1, seed=1)[0]
    held, unknown = facade(evidence="tests"), facade()
    assert held.mechanism.variants.of_histories[0].memory is not None
    assert not assess.respond(held, record, scale=1.0).overturned
    assert assess.respond(unknown, record, scale=1.0).overturned


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"yield_stress": None}, "yield_stress"),
        ({"length": None}, "length"),
        ({"until": "collapse"}, "ends by its own law"),
        ({"slack": 0.01}, "a slack tie has no pretension"),
        ({"force": None, "slack": -0.01}, "0 or more"),
        ({"area": None, "young_modulus": None, "yield_stress": None, "force": None}, "pulls with its pretension"),
        ({"area": None, "young_modulus": None, "yield_stress": None, "slack": 0.01}, "of a tie that stretches"),
        ({"anchor": None, "direction": [-1, 0, 0]}, "towards its fixed end"),
    ],
)
def test_keys_that_do_not_go_together(changes: dict[str, Any], words: str) -> None:
    given = {"force": 10e3, "at": [0, 0, 5.5], "anchor": [-10, 0, 5.5], **BAR, **changes}
    wall = assess.box(thickness=THICKNESS, length=4.0, height=HEIGHT, density=2000.0)
    with pytest.raises(AssessError, match=words):
        assess.single_block(wall, direction=[1, 0, 0], loads=[assess.TieLoad(**given)])


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"fracture_strain": 10.0}, "0.4"),
        ({"young_modulus": 210e6}, "1 to 300 GPa"),
        ({"yield_stress": 2350e6}, "50 to 1500 MPa"),
        ({"area": 314.0}, "20,000 mm"),
        ({"length": 100.0}, "its ends lie 10 m apart"),
        ({"length": 0.05}, "its ends lie 10 m apart"),
        ({"strength": 5e3}, "above what bar and anchorage bear, 5 kN"),
    ],
)
def test_a_bar_that_nobody_makes_or_that_the_drawing_contradicts_is_refused(
    changes: dict[str, Any], words: str
) -> None:
    with pytest.raises(AssessError, match=words):
        facade(**changes)


def test_a_wall_that_its_tie_alone_would_hold_has_no_more_capacity_of_displacement() -> None:
    held = facade(evidence="tests", fracture_strain=0.3).mechanism.variants.deciding
    assert held.memory is not None
    assert held.positive.overturning == pytest.approx(np.arctan2(THICKNESS, HEIGHT), rel=1e-9)


def test_a_floor_that_holds_elastically_is_a_bar_of_its_stiffness_that_breaks_at_its_strength() -> None:
    """Of E A / L = 5 MN/m and an anchorage of 20 kN, which fails before the bar yields."""
    wall = assess.box(thickness=THICKNESS, length=4.0, height=HEIGHT, density=2000.0)
    place = {"at": [0, 0, 5.5], "anchor": [-10, 0, 5.5], "slack": 0.002, "strength": 20e3, "evidence": "tests"}
    area, length = 5e6 * 10.0 / YOUNG, 10.0
    bar = {**BAR, "area": area, "length": length - 0.002}  # free of stress 10 m
    floor, like = (
        assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=[assess.TieLoad(**place, **each)])
        for each in ({"stiffness": 5e6}, bar)
    )
    one, other = (each.mechanism.variants.breaking for each in (floor, like))
    np.testing.assert_allclose(one.positive.restoring, other.positive.restoring, rtol=1e-12)
    assert one.memory.ties[0].gone == pytest.approx(other.memory.ties[0].gone, rel=1e-12)
    (load,) = floor.mechanism.positive.loads
    assert load.elongation == pytest.approx(0.002 + 20e3 / 5e6)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"area": 1e-3}, "stands for a restraint of no bar"),
        ({"strength": None}, "strength: missing"),
        ({"stiffness": 5.0}, "1 kN/m to 1 GN/m"),
        ({"force": 30e3}, "above its strength, 20 kN"),
    ],
)
def test_what_does_not_go_with_a_stiffness(changes: dict[str, Any], words: str) -> None:
    given = {"at": [0, 0, 5.5], "anchor": [-10, 0, 5.5], "stiffness": 5e6, "strength": 20e3, **changes}
    wall = assess.box(thickness=THICKNESS, length=4.0, height=HEIGHT, density=2000.0)
    with pytest.raises(AssessError, match=words):
        assess.single_block(wall, direction=[1, 0, 0], loads=[assess.TieLoad(**given)])


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"at": [0, 1.0, 5.5], "anchor": [-10, 1.0, 5.5]}, r"loads\[2\].at: a tie with the ends of loads\[1\]"),
        ({"at": [0, 2.6, 5.5], "anchor": [-10, 2.6, 5.5]}, r"loads\[2\].at: 0.6 m beside the block that it holds"),
    ],
)
def test_a_tie_stated_twice_or_beside_its_wall_is_refused(more: dict[str, Any], words: str) -> None:
    """Twice it would count twice; a wall 4 m long reaches to 2 m from its middle."""
    wall = assess.box(thickness=THICKNESS, length=4.0, height=HEIGHT, density=2000.0)
    first = assess.TieLoad(at=[0, 1.0, 5.5], anchor=[-10, 1.0, 5.5], stiffness=5e6, strength=20e3)
    second = assess.TieLoad(**more, stiffness=5e6, strength=20e3)
    with pytest.raises(MechanismError, match=words):
        assess.single_block(wall, direction=[1, 0, 0], loads=[first, second])
    apart = assess.TieLoad(at=[0, -1.0, 5.5], anchor=[-10, -1.0, 5.5], stiffness=5e6, strength=20e3)
    assert len(assess.single_block(wall, direction=[1, 0, 0], loads=[first, apart]).mechanism.positive.loads) == 2
