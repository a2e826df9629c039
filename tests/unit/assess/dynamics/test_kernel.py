"""Both equations of the kernel against scipy's DOP853 with exact events, restarted at every sample and every event.

Well-conditioned means here: the largest rotation does not come after so many impacts that the errors of the two
integrators have grown together beyond what is asserted. Each impact multiplies an error in time by up to a few units
and each 1 / p by e, so a case counts as well-conditioned when shaking the scale by 1e-12 moves its maximum by less
than 1e-9, relative; every case below is asserted to be.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics.history import Peaks, peaks, product
from assess.dynamics.kernel import ground
from assess.oscillator import Oscillator
from records.record import Record, make_record
from tests.support.blocks import block, unlike_block
from tests.support.motions import noise, sine
from tests.support.places import PEER, needs_real_records
from tests.support.scipy_rocking import Side, event, exact_side, linearised_side, table_side


@dataclass
class PeakResponse:
    ratio: float = 0.0
    time: float = 0.0
    impacts: int = 0
    overturned: bool = False
    passed: float = math.nan


def reference(sides: tuple[Side, ...], record: Record, scale: float) -> PeakResponse:
    """The same march by DOP853, on its own feet: no code of the kernel."""
    ground, dt = scale * record.acceleration, record.dt
    found, peaked = PeakResponse(), set()
    at, phi, v = -1, 0.0, 0.0
    spans = [(i * dt, (i + 1) * dt, ground[i], ground[i + 1]) for i in range(record.npts - 1)]
    tail = (record.npts - 1) * dt
    spans += [(tail + i * 0.25, tail + (i + 1) * 0.25, 0.0, 0.0) for i in range(200)]
    for start, end, a0, a1 in spans:
        t, slope = start, (a1 - a0) / (end - start)
        if start >= tail and at < 0:
            return found
        while t < end:
            a = a0 + slope * (t - start)
            if at < 0:
                for n, side in enumerate(sides):
                    s = 1 - 2 * n
                    excess, rise = -s * a - side.threshold, -s * slope
                    if excess > 0 or excess + rise * (end - t) > 0:
                        at, t = n, t + max(0.0, -excess / rise if rise > 0 else 0.0)
                        break
                if at < 0:
                    break
                continue
            side, s = sides[at], 1 - 2 * at

            out = solve_ivp(
                lambda x, y, of=side.acceleration, a=s * (a0 - slope * start), b=s * slope: [y[1], of(*y, a + b * x)],
                (t, end), [phi, v], method="DOP853", rtol=3e-14, atol=1e-15 * side.unstable,
                events=[
                    event(0, direction=-1, terminal=True),
                    event(1, direction=-1),
                    event(0, side.unstable, direction=1),
                ],
            )  # fmt: skip
            for x, y in zip(out.t_events[1], out.y_events[1], strict=True):
                if start >= tail:
                    peaked.add(at)
                if y[0] / side.unstable > found.ratio:
                    found.ratio, found.time = y[0] / side.unstable, x
            if out.t_events[2].size:
                found.passed = out.t_events[2][-1]
            if start >= tail and len(peaked) == len(sides):
                return found
            t, (phi, v) = out.t[-1], out.y[:, -1]
            if out.t_events[0].size:
                t, phi, v = out.t_events[0][0], 0.0, -side.restitution * out.y_events[0][0][1]
                found.impacts += 1
                at = (at + 1) % len(sides)
                still = all(-(1 - 2 * n) * (a0 + slope * (t - start)) <= e.threshold for n, e in enumerate(sides))
                if v < sides[at].slow and still:
                    at, v = -1, 0.0
            elif phi >= side.end:
                found.overturned = True
                return found
    return found


def one(oscillator: Oscillator, record: Record, scale: float, equation: str = "exact") -> Peaks:
    return peaks([oscillator], [record], product(1, 1, [scale]), equation=equation, threads=1)


LINEARISED, BLOCK, TABLE = 1e-12, 1e-10, 1e-8
"""Relative error of the largest rotation that is allowed. What is seen is 1e-14, 5e-12 and 4e-10: of the steps, of the
tolerance 1e-10 to a step, and of the table, whose cubics go over into another coordinate."""


def agree(ours: Peaks, theirs: PeakResponse, nearby: Peaks, *, rtol: float) -> None:
    assert bool(ours.overturned[0]) == theirs.overturned
    assert ours.impacts[0] == theirs.impacts
    if theirs.overturned:
        assert ours.overturning_time[0] == pytest.approx(theirs.passed, abs=1e-8)
        return
    assert nearby.max_ratio[0] == pytest.approx(ours.max_ratio[0], rel=1e-9), "not a well-conditioned case"
    assert ours.max_ratio[0] == pytest.approx(theirs.ratio, rel=rtol)
    assert ours.time_of_max[0] == pytest.approx(theirs.time, abs=max(rtol, 1e-11))


CASES = {
    "sine, stands": (sine(4.0, 1.4), 1.0, 2.0, 0.2, 0.9, 2),
    "sine, reversed, overturns after the record": (sine(4.0, 1.0), -1.0, 2.0, 0.2, 0.9, 2),
    "sine, overturns": (sine(8.0, 0.7), 1.0, 2.0, 0.2, 0.9, 2),
    "sine, overturns after an impact": (sine(3.5, 0.64), 1.0, 2.0, 0.2, 0.9, 2),
    "three sines, one-sided": (sine(4.0, 1.3, cycles=3.0), 1.0, 2.0, 0.2, 0.4, 1),
    "coarse sine": (sine(5.0, 1.0, cycles=2.0, samples=12), 1.0, 2.0, 0.2, 0.85, 2),
    "noise 1": (noise(1, peak=3.6, npts=300, smooth=25, bell=0.5), 1.0, 1.6, 0.25, 0.85, 2),
    "noise 2, overturns": (noise(2, peak=4.0, npts=300, smooth=25, bell=0.5), -1.0, 2.5, 0.2, 0.7, 2),
    "noise 3, one-sided": (noise(3, peak=5.0, npts=300, smooth=25, bell=0.5), 1.0, 1.5, 0.2, 0.5, 1),
}


@pytest.mark.parametrize("case", CASES)
def test_exact_equation_is_that_of_dop853(case: str) -> None:
    record, scale, p, alpha, restitution, sides = CASES[case]
    body = block(p, alpha, restitution, sides=sides)
    theirs = reference((exact_side(p, alpha, restitution),) * sides, record, scale)
    agree(one(body, record, scale), theirs, one(body, record, scale * (1 + 1e-12)), rtol=BLOCK)


@pytest.mark.parametrize("case", CASES)
def test_linearised_equation_is_that_of_dop853(case: str) -> None:
    record, scale, p, alpha, restitution, sides = CASES[case]
    body = block(p, alpha, restitution, sides=sides)
    theirs = reference((linearised_side(body.positive),) * sides, record, scale)
    agree(
        one(body, record, scale, "linearised"),
        theirs,
        one(body, record, scale * (1 + 1e-12), "linearised"),
        rtol=LINEARISED,
    )


def test_a_pulse_from_a_later_time_on_is_the_polynomial_of_that_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(ground, "ground_at", ground.ground_at.py_func)
    powers = (0.7, -1.3, 0.4, 2.1, -0.6, 0.9)
    shifted = Polynomial(powers)(Polynomial([0.35, 1.0])).coef
    np.testing.assert_allclose(ground.shift.py_func(powers, 0.35), shifted, rtol=1e-13)
    np.testing.assert_allclose(ground.shift.py_func(powers[:2], 0.35), [0.7 - 1.3 * 0.35, -1.3], rtol=1e-13)


@needs_real_records
@pytest.mark.parametrize("scale", [1.0, -1.0])
def test_exact_equation_under_a_real_record(scale: float) -> None:
    text = (PEER / "A-ELC180.AT2").read_text().splitlines()
    record = make_record("A-ELC180", g * np.array(" ".join(text[4:]).split(), dtype=float)[:1500] * 1.75, 0.01)
    theirs = reference((exact_side(2.0, 0.12, 0.8),) * 2, record, scale)
    assert theirs.impacts > 5
    body = block(2.0, 0.12, 0.8)
    agree(one(body, record, scale), theirs, one(body, record, scale * (1 + 1e-12)), rtol=BLOCK)


@pytest.mark.parametrize("scale", [1.0, -1.0, 1.4])
def test_unlike_branches_with_varying_inertia(scale: float) -> None:
    body, record = unlike_block(), sine(4.5, 0.8, cycles=2.0, samples=30)
    theirs = reference(tuple(table_side(b) for b in body.branches), record, scale)
    assert theirs.impacts > 0
    agree(one(body, record, scale), theirs, one(body, record, scale * (1 + 1e-12)), rtol=TABLE)


@pytest.mark.parametrize("scale", [1.0, -0.6])
def test_a_jump_in_the_table_is_crossed_as_by_small_steps(scale: float) -> None:
    """DOP853 knows nothing of the jump; its error control takes it in tiny steps, so agreement is looser."""
    body, record = unlike_block(jump=True), sine(6.0, 0.8, cycles=1.5, samples=30)
    theirs = reference(tuple(table_side(b) for b in body.branches), record, scale)
    ours = one(body, record, scale)
    assert max(theirs.ratio, ours.max_ratio[0]) > body.positive.rotation[20] / body.positive.overturning
    assert bool(ours.overturned[0]) == theirs.overturned
    assert ours.impacts[0] == theirs.impacts
    if theirs.overturned:
        assert ours.overturning_time[0] == pytest.approx(theirs.passed, abs=1e-7)
    else:
        assert ours.max_ratio[0] == pytest.approx(theirs.ratio, rel=1e-7)
