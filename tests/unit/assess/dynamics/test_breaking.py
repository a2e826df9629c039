"""Histories of a block whose tie breaks on the way: a jump in the table, against scipy's DOP853 with an event there."""

from __future__ import annotations

from math import asin, atan2, cos, hypot, sin

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics.history import Jobs, free_rocking, peaks, trace
from assess.loads.load import Tie
from assess.mechanisms.single_block import single_block
from assess.oscillator import energy
from tests.support.bodies import planar_box
from tests.support.motions import sine
from tests.support.scipy_rocking import event

T, L, H, RHO = 0.8, 2.0, 5.0, 1900.0
M = RHO * T * L * H
R, ALPHA = hypot(T / 2, H / 2), atan2(T, H)
INERTIA = 4.0 / 3.0 * M * R**2
PULL, UP, UNTIL = 9000.0, 4.5, 0.15
AT = 2 * asin(UNTIL / (2 * UP))
WALL = planar_box(T, H, length=L, density=RHO)
TIE = Tie("tie", PULL, (T / 2, UP), direction=(-1.0, 0.0), until=UNTIL)
ROCKER = single_block("w", WALL, loads=(TIE,), sides="one", restitution=(0.0, 0.0)).variants.breaking


def moment(phi, *, held):
    """Weight, and the tie where it holds [N m]."""
    return M * g * R * sin(ALPHA - phi) + PULL * UP * cos(phi) * held


def by_scipy(record, *, stop):
    """Rotation at the samples, stopped and begun again where the moment jumps; uplift found by hand before."""
    ground = lambda t: np.interp(t, record.time, record.acceleration)  # noqa: E731
    first = next(t for t in np.linspace(0.0, stop, 200001) if -ground(t) * M * R * cos(ALPHA) >= moment(0.0, held=True))
    t, state, held, times, rotation = first, [0.0, 0.0], True, [], []
    while t < stop - 1e-12:
        end = min((x for x in (*record.time, stop) if x > t + 1e-13), default=stop)

        def motion(time, y, held=held):
            push = -M * R * cos(ALPHA - y[0]) * ground(time)
            return [y[1], (push - moment(y[0], held=held)) / INERTIA]

        jump = event(0, AT, direction=1 if held else -1, terminal=True)
        out = solve_ivp(motion, (t, end), state, "DOP853", rtol=1e-12, atol=1e-14, events=jump)
        t, state = float(out.t[-1]), out.y[:, -1].tolist()
        if out.status == 1:
            held, state[0] = not held, AT
        else:
            times.append(t)
            rotation.append(state[0])
    return np.array(times), np.array(rotation)


def test_the_jump_stands_in_the_table():
    side = ROCKER.positive
    (jump,) = np.flatnonzero(np.diff(side.rotation) == 0.0)
    assert side.rotation[jump] == pytest.approx(AT, rel=1e-12)
    assert side.restoring[jump] == pytest.approx(moment(AT, held=True), rel=1e-11)
    assert side.restoring[jump + 1] == pytest.approx(moment(AT, held=False), rel=1e-9)


def test_free_motion_keeps_the_energy_of_weight_and_tie():
    """Let go beyond the break, it comes down to the impact with the work of both."""
    start = 0.6 * ALPHA
    assert start > 2 * AT
    found = free_rocking(ROCKER, rotation=start, duration=10.0)
    weight = M * g * R * (1.0 - cos(ALPHA)) - M * g * R * (1.0 - cos(ALPHA - start))
    work = weight + PULL * UP * sin(AT)
    assert float(energy(ROCKER.positive, np.array(start))) == pytest.approx(work, rel=1e-9)
    assert 0.5 * INERTIA * found.impact_velocity[0] ** 2 == pytest.approx(work, rel=1e-9)


@pytest.mark.parametrize("amplitude", [4.2, 4.6, 5.0])
def test_a_history_passes_the_jump_as_scipy_does_with_an_event_there(amplitude):
    record = sine(amplitude, 0.7, cycles=1.5, samples=286)
    path = trace(ROCKER, record, scale=1.0, equation="exact")
    beyond = np.flatnonzero(path.rotation > AT)
    back = np.flatnonzero((path.rotation[1:] == 0.0) & (path.rotation[:-1] > 0.0))
    stop = float(path.time[back[0] - 1]) if back.size else float(path.time[-1])
    times, rotation = by_scipy(record, stop=stop)
    assert beyond.size
    here = np.searchsorted(path.time, times - 1e-9)
    np.testing.assert_allclose(path.rotation[here], rotation, rtol=0.0, atol=2e-7 * ALPHA)  # the instant of uplift


def test_a_tie_that_breaks_helps_less_than_one_that_lasts_and_more_than_none():
    record = sine(1.0, 0.7, cycles=1.5, samples=286)
    held = single_block("w", WALL, loads=(TIE,), sides="one", restitution=(0.0, 0.0)).variants
    scale = np.linspace(1.0, 9.0, 161)
    least = []
    for rocker in (held.collapse, held.breaking, held.starting):
        jobs = Jobs(np.zeros(scale.size, dtype=np.int64), np.zeros(scale.size, dtype=np.int64), scale)
        least.append(scale[peaks([rocker], [record], jobs, equation="exact").overturned].min())
    assert least[0] < least[1] < least[2]
