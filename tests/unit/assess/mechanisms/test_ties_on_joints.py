"""Ties that stretch on a wall whose joint deforms: rest, limits, rupture, and a history by another integrator."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

import assess
from assess.errors import MechanismError
from assess.interfaces.contact import Interface
from records.record import make_record
from tests.unit.assess.mechanisms.test_stretching_ties import BAR, HEIGHT, MOST, STIFFNESS, THICKNESS, facade

TAUT = STIFFNESS * (1 + 10e3 / (STIFFNESS * 10.0))  # E A over the length free of stress, with 10 kN in 10 m


def on_joints(stiffness: float = 1e10, sides: str = "one", **changes: Any) -> assess.Block:
    wall = assess.box(thickness=THICKNESS, length=4.0, height=HEIGHT, density=2000.0)
    bar = {**BAR, "strength": 2 * MOST, "fracture_strain": 0.1, **changes}
    load = assess.TieLoad(**{"force": 10e3, "at": [0, 0, 5.5], "anchor": [-10, 0, 5.5], "evidence": "tests", **bar})
    joint = Interface(model="flexible", stiffness=stiffness, strength=np.inf)
    return assess.single_block(wall, direction=[1, 0, 0], sides=sides, loads=[load], interface=joint)


@pytest.mark.parametrize("sides", ["one", "two"])
def test_on_stiff_joints_it_holds_as_on_rigid_ones(sides: str) -> None:
    rigid = replace(facade(evidence="tests").rocking, negative=None)
    for stiffness, off in ((1e10, 0.02), (1e12, 2e-3)):
        found = on_joints(stiffness, sides).rocking.positive
        for phi in (0.004, 0.03, 0.06):
            expected = float(rigid.positive.restoring_spline(phi))
            assert float(found.restoring_spline(phi)) == pytest.approx(expected, rel=off)


@pytest.mark.parametrize("sides", ["one", "two"])
@pytest.mark.parametrize("stiffness", [1e9, 1e10])
def test_on_joints_it_rests_where_its_pretension_leans_the_wall(stiffness: float, sides: str) -> None:
    """Held from both sides it rests without a moment; against what stops it inwards the pretension presses it."""
    found = on_joints(stiffness, sides).rocking
    held = 10e3 * 5.5 if sides == "one" else 0.0
    assert found.positive.restoring[0] == pytest.approx(held, abs=1e-6 * 10e3)
    law = found.memory.ties[0]
    assert law.stiffness * law.elongation[0][0] == pytest.approx(10e3, rel=1e-9)


def test_a_history_on_joints_follows_an_independent_integrator() -> None:
    """Out and back after yielding, by DOP853 on the joints' table and the tie's law over the block's own geometry."""
    block = on_joints(1e10, "one")
    table = block.rocking.bare.positive
    push = make_record("push", -0.8 * g * np.sin(np.linspace(0.0, np.pi, 41)), 0.01)
    push = make_record("push", np.r_[push.acceleration, np.zeros(80)], 0.01)
    path = assess.respond(block, push, scale=1.0)

    def pull(phi: float, plastic: float) -> tuple[float, float]:
        x, z, step = -THICKNESS / 2, 5.5, 1e-6
        far = [np.hypot(10.0 - x + x * np.cos(p) + z * np.sin(p), z * np.cos(p) - x * np.sin(p) - z)
               for p in (phi - step, phi, phi + step)]  # fmt: skip
        e = far[1] - 10.0 + 10e3 / TAUT
        return float(np.clip(TAUT * (e - plastic), 0.0, MOST)), float((far[2] - far[0]) / (2 * step))

    def rates(t: float, y: np.ndarray, plastic: float) -> list[float]:
        force, rate = pull(y[0], plastic)
        ground = float(np.interp(t, push.time, push.acceleration))
        moment = float(table.restoring_spline(y[0])) + force * rate + float(table.excitation_spline(y[0])) * ground
        slope = float(table.inertia_spline(y[0], 1))
        return [y[1], -(moment + slope / 2 * y[1] ** 2) / float(table.inertia_spline(y[0]))]

    start = int(np.flatnonzero(path.rotation > 0.0)[0])
    peak = int(path.rotation.argmax())
    begin = [path.rotation[start], path.velocity[start]]
    out = solve_ivp(rates, (start * 0.01, peak * 0.01 + 0.02), begin, args=(0.0,), method="DOP853", rtol=1e-10,
                    atol=1e-13, max_step=1e-3, dense_output=True, events=lambda t, y, p: y[1])  # fmt: skip
    np.testing.assert_allclose(path.rotation[start:peak], out.sol(0.01 * np.arange(start, peak))[0], atol=2e-8)
    top = float(out.t_events[0][-1])
    far, _ = pull(float(out.sol(top)[0]), 0.0)
    assert far == MOST  # it yields
    x, z, phi = -THICKNESS / 2, 5.5, float(out.sol(top)[0])
    plastic = (np.hypot(10.0 - x + x * np.cos(phi) + z * np.sin(phi), z * np.cos(phi) - x * np.sin(phi) - z)
               - 10.0 + (10e3 - MOST) / TAUT)  # fmt: skip
    back = solve_ivp(rates, (top, 0.01 * peak + 0.1), out.sol(top), args=(plastic,), method="DOP853", rtol=1e-10,
                     atol=1e-13, max_step=1e-3, dense_output=True)  # fmt: skip
    later = np.arange(peak + 1, peak + 9)
    assert (path.rotation[later] > 0.0).all()
    np.testing.assert_allclose(path.rotation[later], back.sol(0.01 * later)[0], atol=2e-8)


def test_on_joints_a_tie_that_is_not_level_is_refused() -> None:
    with pytest.raises(MechanismError, match="level within 10 degrees, and tie 1 is no such tie"):
        on_joints(anchor=[-10, 0, 0.5], length=11.2).rocking  # noqa: B018


def test_where_its_anchorage_fails_the_curve_falls_back_on_that_of_the_wall_alone() -> None:
    found = on_joints(strength=0.5 * MOST).mechanism.variants.breaking
    assert found is not None
    phi = found.positive.rotation
    (jump,) = phi[1:][np.diff(phi) == 0.0][np.abs(np.diff(found.positive.restoring))[np.diff(phi) == 0.0] > 1e4]
    assert 5.5 * jump == pytest.approx((0.5 * MOST - 10e3) / STIFFNESS, rel=0.01)
    beyond = phi > 1.01 * jump
    np.testing.assert_allclose(found.positive.restoring[beyond], found.bare.positive.restoring[beyond], rtol=1e-12)


def test_on_joints_a_slack_tie_pulls_from_its_slack_on() -> None:
    """At rest it has no force and its law begins at minus the slack; on stiff joints its curve is that on rigid ones.

    It holds the wall beyond the end of the table, which counts as overturned where it would without the tie.
    """
    held = on_joints(1e12, force=None, slack=0.02).rocking
    law, e = held.memory.ties[0], 0.02
    assert law.elongation[0][0] == pytest.approx(-e, rel=1e-12)
    rigid = facade(force=None, slack=e, evidence="tests").rocking
    for phi in (0.002, 0.02, 0.06):
        ours, theirs = (
            float(each.positive.restoring_spline(phi) - each.bare.positive.restoring_spline(phi))
            for each in (held, rigid)
        )
        assert ours == pytest.approx(theirs, rel=2e-3, abs=1.0)
    assert held.positive.unstable == pytest.approx(held.bare.positive.unstable, rel=1e-12)
