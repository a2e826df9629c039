"""Both equations of the kernel against scipy's DOP853 with exact events, restarted at every sample and every event.

Well-conditioned means here: the largest rotation does not come after so many impacts that the errors of the two
integrators have grown together beyond what is asserted. Each impact multiplies an error in time by up to a few units
and each 1 / p by e, so a case counts as well-conditioned when shaking the scale by 1e-12 moves its maximum by less
than 1e-9, relative; every case below is asserted to be.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics.history import Jobs, Peaks, peaks
from assess.dynamics.kernel.events import REST
from assess.oscillator import Branch, Oscillator, interpolant
from records.record import Record, make_record
from tests.support.blocks import block
from tests.support.motions import noise
from tests.support.places import PEER, needs_real_records


@dataclass(frozen=True)
class Side:
    """One side for the reference: its acceleration(phi, v, ground in its own sign) and what its events need."""

    acceleration: Callable[[float, float, float], float]
    threshold: float
    overturning: float
    end: float
    restitution: float
    slow: float


@dataclass
class Found:
    ratio: float = 0.0
    time: float = 0.0
    impacts: int = 0
    overturned: bool = False
    passed: float = math.nan


def exact_side(p: float, alpha: float, restitution: float) -> Side:
    """A block by its closed formulas, not by tables."""

    def acceleration(phi: float, v: float, a: float) -> float:
        return -(p**2) * (math.sin(alpha - phi) + a / g * math.cos(alpha - phi))

    rate = math.sqrt(2 * p**2 * (1 - math.cos(alpha))) / alpha  # velocity that reaches alpha, over alpha
    return Side(acceleration, g * math.tan(alpha), alpha, 1.5 * alpha, restitution, REST * rate * alpha)


def linearised_side(member: Branch, largest: float) -> Side:
    form = member.linearised
    p, phi_ov, per_inertia = form.p, form.overturning, form.excitation / form.inertia
    threshold = g * form.multiplier

    def acceleration(phi: float, v: float, a: float) -> float:
        return p**2 * (phi - phi_ov) - per_inertia * a

    return Side(
        acceleration, threshold, phi_ov, phi_ov * (1 + largest / threshold), form.restitution, REST * p * phi_ov
    )


def table_side(member: Branch) -> Side:
    """Any table, by scipy's evaluation of its spline."""
    inertia, moment, excitation = (
        interpolant(member.rotation, values) for values in (member.inertia, member.restoring, member.excitation)
    )

    def acceleration(phi: float, v: float, a: float) -> float:
        forces = moment(phi) + excitation(phi) * a + 0.5 * inertia(phi, 1) * v**2
        return float(-forces / inertia(phi))

    work = moment.antiderivative()(member.overturning)
    slow = REST * math.sqrt(2 * work / member.inertia[0])
    threshold = float(member.restoring[0] / member.excitation[0])
    return Side(acceleration, threshold, member.overturning, member.rotation[-1], member.restitution, slow)


def reference(sides: tuple[Side, ...], record: Record, scale: float) -> Found:
    """The same march by DOP853, on its own feet: no code of the kernel."""
    ground, dt = scale * record.acceleration, record.dt
    found, peaked = Found(), set()
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

            def impact(_: float, y: np.ndarray) -> float:
                return float(y[0])

            def peak(_: float, y: np.ndarray) -> float:
                return float(y[1])

            def passage(_: float, y: np.ndarray, phi_ov: float = side.overturning) -> float:
                return float(y[0]) - phi_ov

            impact.terminal, impact.direction, peak.direction, passage.direction = True, -1, -1, 1
            out = solve_ivp(
                lambda x, y, of=side.acceleration, a=s * (a0 - slope * start), b=s * slope: [y[1], of(*y, a + b * x)],
                (t, end), [phi, v], method="DOP853", rtol=3e-14, atol=1e-15 * side.overturning,
                events=[impact, peak, passage],
            )  # fmt: skip
            for x, y in zip(out.t_events[1], out.y_events[1], strict=True):
                if start >= tail:
                    peaked.add(at)
                if y[0] / side.overturning > found.ratio:
                    found.ratio, found.time = y[0] / side.overturning, x
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


def sine(amplitude: float, frequency: float, periods: float = 1.0, n: int = 100, dt: float | None = None) -> Record:
    steps = round(periods * n)
    t = np.arange(steps + 1) / n
    return make_record("sine", -amplitude * np.sin(2 * np.pi * t), 1.0 / (n * frequency) if dt is None else dt)


def one(oscillator: Oscillator, record: Record, scale: float, equation: str = "exact") -> Peaks:
    return peaks([oscillator], [record], Jobs(*(np.array([x]) for x in (0, 0, scale))), equation=equation, threads=1)


LINEARISED, BLOCK, TABLE = 1e-12, 1e-10, 1e-8
"""Relative error of the largest rotation that is allowed. What is seen is 1e-14, 5e-12 and 4e-10: of the steps, of the
tolerance 1e-10 to a step, and of the table, whose cubics go over into another coordinate."""


def agree(ours: Peaks, theirs: Found, nearby: Peaks, *, rtol: float) -> None:
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
    "three sines, one-sided": (sine(4.0, 1.3, 3.0), 1.0, 2.0, 0.2, 0.4, 1),
    "coarse sine": (sine(5.0, 1.0, 2.0, n=12), 1.0, 2.0, 0.2, 0.85, 2),
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
    theirs = reference((linearised_side(body.positive, record.pga),) * sides, record, scale)
    agree(
        one(body, record, scale, "linearised"),
        theirs,
        one(body, record, scale * (1 + 1e-12), "linearised"),
        rtol=LINEARISED,
    )


@needs_real_records
@pytest.mark.parametrize("scale", [1.0, -1.0])
def test_exact_equation_under_a_real_record(scale: float) -> None:
    text = (PEER / "A-ELC180.AT2").read_text().splitlines()
    record = make_record("A-ELC180", g * np.array(" ".join(text[4:]).split(), dtype=float)[:1500] * 1.75, 0.01)
    theirs = reference((exact_side(2.0, 0.12, 0.8),) * 2, record, scale)
    assert theirs.impacts > 5
    body = block(2.0, 0.12, 0.8)
    agree(one(body, record, scale), theirs, one(body, record, scale * (1 + 1e-12)), rtol=BLOCK)


def frame(jump: bool = False, sides: int = 2) -> Oscillator:
    """Branches that differ, with inertia that varies; optionally a moment that drops where a tie goes slack."""

    def make(alpha: float, p: float, slope: float, restitution: float) -> Branch:
        phi = np.linspace(0.0, 1.5 * alpha, 65)
        if jump:
            phi = np.sort(np.append(phi, phi[20]))
        inertia = g / p**2 * (1.0 + slope * phi + 2.0 * phi**2)
        moment, excitation = g * np.sin(alpha - phi), np.cos(alpha - phi) * (1.0 + 0.3 * phi)
        if jump:
            moment[:21] += 0.2 * moment[0]
        return Branch(phi, inertia, moment, excitation, 0 * phi + 1, 0 * phi + 1, restitution, alpha, alpha)

    return Oscillator(make(0.25, 1.8, 2.0, 0.8), make(0.2, 2.1, -1.0, 0.9) if sides == 2 else None, 1.0)


@pytest.mark.parametrize("scale", [1.0, -1.0, 1.4])
def test_unlike_branches_with_varying_inertia(scale: float) -> None:
    body, record = frame(), sine(4.5, 0.8, 2.0, n=30)
    theirs = reference(tuple(table_side(b) for b in body.branches), record, scale)
    assert theirs.impacts > 0
    agree(one(body, record, scale), theirs, one(body, record, scale * (1 + 1e-12)), rtol=TABLE)


@pytest.mark.parametrize("scale", [1.0, -0.6])
def test_a_jump_in_the_table_is_crossed_as_by_small_steps(scale: float) -> None:
    """DOP853 knows nothing of the jump; its error control takes it in tiny steps, so agreement is looser."""
    body, record = frame(jump=True), sine(6.0, 0.8, 1.5, n=30)
    theirs = reference(tuple(table_side(b) for b in body.branches), record, scale)
    ours = one(body, record, scale)
    assert max(theirs.ratio, ours.max_ratio[0]) > body.positive.rotation[20] / body.positive.overturning
    assert bool(ours.overturned[0]) == theirs.overturned
    assert ours.impacts[0] == theirs.impacts
    if theirs.overturned:
        assert ours.overturning_time[0] == pytest.approx(theirs.passed, abs=1e-7)
    else:
        assert ours.max_ratio[0] == pytest.approx(theirs.ratio, rel=1e-7)
