"""Outcomes under analytic pulses against scipy's DOP853, whose ground is the shape itself and not the kernel's pieces.

The threshold found with the kernel is sharp: at 1e-7 below it DOP853 sees the body stand, at 1e-7 above it overturn.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, minimize_scalar

from assess.dynamics.kernel.events import REST
from assess.dynamics.packing import Equation
from assess.dynamics.pulses import PIECES, PulseJobs, envelope, make_pulse_solver, pulse_outcomes, pulse_polynomials
from assess.interfaces.contact import JointLaw
from assess.oscillator import Oscillator, RockingBlock, plain_branch
from records.pulses import PULSE_SHAPES, PulseShape, mavroeidis_papageorgiou
from tests.support.blocks import unlike_block
from tests.support.bodies import wall_on_joints
from tests.support.scipy_rocking import Side, event, linearised_side, table_side

PLAIN = plain_branch(RockingBlock(1.0, 1.0, 0.2, g / 4.0), restitution=0.85)
BLOCK, ONE_SIDED, FRAME, WALL = (
    Oscillator(PLAIN, PLAIN, 1.0),
    Oscillator(replace(PLAIN, restitution=0.4), None, 1.0),
    unlike_block(),
    # 6 m high, 1 m thick, on a joint of 0.2 GPa/m that crushes at 1.5 MPa
    wall_on_joints(1.0, 6.0, JointLaw(2e8, 1.5e6), length=2.0, restitution=(0.92, 0.92)).oscillator,
)
SYSTEMS: dict[str, tuple[Oscillator, Equation]] = {
    "linearised": (BLOCK, "linearised"),
    "linearised, unlike": (FRAME, "linearised"),
    "block": (BLOCK, "exact"),
    "block, one-sided": (ONE_SIDED, "exact"),
    "unlike branches": (FRAME, "exact"),
    "on a joint": (WALL, "exact"),
}


def formula(shape: PulseShape) -> Callable[[float], float]:
    """The shape by its textbook formula over the phase, without its ends."""
    if shape.name == "ricker":
        return lambda x: (1 - x * x / 2) * math.exp(-x * x / 4)
    if shape.name == "ricker-antisymmetric":
        top = math.sqrt(3 - math.sqrt(6))
        peak = top * (3 - top**2) * math.exp(-(top**2) / 2)
        return lambda x: (x / math.sqrt(3)) * (x * x / 3 - 3) * math.exp(-x * x / 6) / peak
    if shape.name != "mavroeidis-papageorgiou":
        return math.cos if shape.name == "cosine" else math.sin
    gamma, nu = float(shape.gamma or 0.0), float(shape.nu or 0.0)

    def slope(x: float) -> float:
        """Of v = 1/2 [1 + cos(x / gamma)] cos(x + nu)."""
        return -0.5 * (math.sin(x / gamma) / gamma * math.cos(x + nu) + (1 + math.cos(x / gamma)) * math.sin(x + nu))

    grid = np.linspace(shape.start, shape.end, 20_001)
    k = int(np.argmax([abs(slope(x)) for x in grid]))
    top = minimize_scalar(
        lambda x: -abs(slope(x)), bounds=(grid[k - 1], grid[k + 1]), method="bounded", options={"xatol": 1e-12}
    )
    return lambda x: -slope(x) / top.fun


def lifting(sides: tuple[Side, ...], ground: Callable[[float], float], t: float, end: float) -> tuple[int, float]:
    """The next side that lifts and when: the ground on a fine grid, then brentq; -1 where none does."""
    grid = np.linspace(t, end, 501).tolist()
    first = (-1, end)
    for n, side in enumerate(sides):
        over = np.array([-(1 - 2 * n) * ground(x) - side.threshold for x in grid])
        k = int(np.argmax(over > 0.0))
        if over[k] > 0.0:
            when = t if k == 0 else brentq(lambda x, n=n, s=side: -(1 - 2 * n) * ground(x) - s.threshold, grid[k - 1], grid[k], xtol=1e-15)  # fmt: skip  # noqa: E501
            if when < first[1]:
                first = (n, when)
    return first


def by_scipy(system: str, shape: PulseShape, frequency: float, amplitude: float) -> tuple[bool, int]:
    """Whether it overturns, and its impacts while the pulse lasts."""
    oscillator, equation = SYSTEMS[system]
    sides = tuple(map(linearised_side if equation == "linearised" else table_side, oscillator.branches))
    end, omega = shape.duration(frequency), 2 * math.pi * frequency
    unit = formula(shape)
    ground = lambda t: amplitude * unit(shape.start + omega * t)  # noqa: E731
    t, at, phi, v, impacts, swings = 0.0, -1, 0.0, 0.0, 0, 0
    while t < end or at >= 0:
        if at < 0:
            at, t = lifting(sides, ground, t, end)
            phi, v = 0.0, 0.0
            if at < 0:
                return False, impacts
        side, s, free = sides[at], 1 - 2 * at, t >= end
        limit = side.unstable if free else side.end
        if phi >= limit and v >= 0.0:
            return True, impacts

        events = event(0, direction=-1, terminal=True), event(0, limit, direction=1, terminal=True)
        out = solve_ivp(
            lambda x, y, of=side.acceleration, s=s, still=free: [y[1], of(y[0], y[1], 0.0 if still else s * ground(x))],
            (t, t + 60.0) if free else (t, end), [phi, v], method="DOP853", rtol=1e-12,
            atol=1e-14 * side.unstable, events=events, max_step=math.inf if free else end / 20,
        )  # fmt: skip
        t, (phi, v) = out.t[-1], out.y[:, -1]
        if out.t_events[1].size:
            return True, impacts
        if out.t_events[0].size:
            t, v, phi = out.t_events[0][0], -side.restitution * out.y_events[0][0][1], 0.0
            impacts, swings = impacts + (not free), swings + free
            at = (at + 1) % len(sides)
            lifted = not free and any(-(1 - 2 * n) * ground(t) > e.threshold for n, e in enumerate(sides))
            if (v < sides[at].slow and not lifted) or v < 1e-12 * sides[at].slow / REST:
                at = -1
            if swings > 4:
                return False, impacts
        elif free:
            return bool(phi > side.unstable), impacts
    return False, impacts


FREQUENCY = {"on a joint": 0.5}


@pytest.mark.parametrize(
    "shape", [*PULSE_SHAPES.values(), mavroeidis_papageorgiou(gamma=3.0, nu=1.0)], ids=lambda s: s.name
)
@pytest.mark.parametrize("system", SYSTEMS)
def test_the_least_pulse_that_overturns_is_that_of_dop853(system: str, shape: PulseShape) -> None:
    oscillator, equation = SYSTEMS[system]
    f = FREQUENCY.get(system, 0.7)
    found = envelope(oscillator, shape, np.array([f]), np.array([0.0, 30.0]), equation=equation, threads=1)
    bound, polarity = float(found.lower_bound[0]), int(found.polarity[0])
    below, above = (by_scipy(system, shape, f, polarity * bound * (1 + by)) for by in (-1e-7, 1e-7))
    assert (below[0], above[0]) == (False, True)
    if oscillator.negative is None or oscillator is FRAME:
        assert not by_scipy(system, shape, f, -polarity * bound * (1 - 1e-7))[0]


@pytest.mark.parametrize("system", SYSTEMS)
def test_outcomes_and_impacts_over_the_amplitude(system: str) -> None:
    """Also far above the bound, in safe islands, and below uplift; both polarities."""
    oscillator, equation = SYSTEMS[system]
    shape, f = PULSE_SHAPES["ricker-antisymmetric"], FREQUENCY.get(system, 0.7)
    amplitudes = np.array([0.5, 1.9, 2.3, 2.9, 4.0, 7.0]) * np.array([[1.0], [-1.0]])
    none = np.zeros(amplitudes.size, dtype=np.int64)
    jobs = PulseJobs(none, none, amplitudes.ravel())
    found = pulse_outcomes([oscillator], shape, np.array([f]), jobs, equation=equation, threads=1)
    theirs = [by_scipy(system, shape, f, float(a)) for a in amplitudes.ravel()]
    assert found.overturned.tolist() == [fell for fell, _ in theirs]
    assert 0 < sum(found.overturned) < amplitudes.size
    stood = ~found.overturned
    assert found.impacts[stood].tolist() == [impacts for fell, impacts in theirs if not fell]
    assert found.impacts.max() > 0


@pytest.mark.parametrize("shape", PULSE_SHAPES.values(), ids=PULSE_SHAPES)
def test_pieces_are_the_shape_to_1e_12_of_its_peak(shape: PulseShape) -> None:
    """Of a sine (2 pi / 100)^6 / 46080 = 1.3e-12; shapes of quicker harmonics or curvature have somewhat more."""
    pieces, width = pulse_polynomials(shape)
    assert width <= 2 * math.pi / PIECES * (1 + 1e-12)
    assert len(pieces) * width == pytest.approx(shape.end - shape.start, rel=1e-14)
    inside = np.array([0.0, 0.2, 0.5, 0.77]) * width
    theta = shape.start + width * np.arange(len(pieces))[:, None] + inside
    value = sum(pieces[:, [m]] * inside**m for m in range(6))
    np.testing.assert_allclose(value, shape.value(theta), rtol=0, atol=1.4e-12 if "sine" in shape.name else 2e-11)


def test_the_same_whatever_the_threads_and_the_order() -> None:
    rng = np.random.default_rng(5)
    frequency = np.array([0.3, 0.9, 2.0])
    jobs = PulseJobs(rng.integers(0, 2, 9000), rng.integers(0, 3, 9000), rng.uniform(-8.0, 8.0, 9000))
    run = [
        make_pulse_solver([BLOCK, FRAME], PULSE_SHAPES["cosine"], frequency, equation="linearised", threads=n)
        for n in (1, 2)
    ]
    one, two = run[0](jobs), run[1](jobs)
    order = rng.permutation(9000)
    mixed = run[0](PulseJobs(jobs.oscillator[order], jobs.frequency[order], jobs.amplitude[order]))
    for name in ("uplifted", "overturned", "impacts"):
        np.testing.assert_array_equal(getattr(one, name), getattr(two, name))
        np.testing.assert_array_equal(getattr(one, name)[order], getattr(mixed, name))
    assert 0 < one.overturned.sum() < 9000


def test_uplifted_where_the_ground_exceeds_the_threshold() -> None:
    threshold = g * math.tan(0.2)
    for name, polarity in (("half-sine", 1.0), ("half-sine", -1.0), ("ricker", 1.0), ("cosine", -1.0)):
        amplitude = polarity * threshold * np.array([1 - 1e-9, 1 + 1e-9])
        none = np.zeros(2, dtype=np.int64)
        jobs = PulseJobs(none, none, amplitude)
        found = pulse_outcomes([BLOCK], PULSE_SHAPES[name], np.array([1.0]), jobs, equation="exact", threads=1)
        assert found.uplifted.tolist() == [False, True], name


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_a_frequency_that_is_none_is_named(bad: float) -> None:
    with pytest.raises(ValueError, match=r"frequency\[1\] = .* Hz.* positive"):
        make_pulse_solver([BLOCK], PULSE_SHAPES["sine"], np.array([1.0, bad]), equation="linearised")


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_an_amplitude_that_is_none_is_named(bad: float) -> None:
    run = make_pulse_solver([BLOCK], PULSE_SHAPES["sine"], np.array([1.0]), equation="exact")
    none = np.zeros(3, dtype=np.int64)
    with pytest.raises(ValueError, match=r"jobs\[2\]: amplitude .* finite"):
        run(PulseJobs(none, none, np.array([1.0, 2.0, bad])))


@pytest.mark.parametrize(("name", "oscillators", "frequencies"), [("oscillator", [0, 1], [0, 0]), ("frequency", [0, 0], [0, -1])])  # fmt: skip  # noqa: E501
def test_a_job_that_names_nothing_is_named(name: str, oscillators: list[int], frequencies: list[int]) -> None:
    run = make_pulse_solver([BLOCK], PULSE_SHAPES["sine"], np.array([1.0]), equation="exact")
    with pytest.raises(ValueError, match=rf"jobs\[1\]: {name}"):
        run(PulseJobs(np.array(oscillators), np.array(frequencies), np.ones(2)))


@pytest.mark.parametrize("shape", ["sine", "cosine"])
def test_the_weaker_side_lifts_in_whichever_half_pushes_it(shape: str) -> None:
    """Its sides start to rock at about 0.25 g and 0.2 g: under 0.225 g the second alone does, by each polarity."""
    none = np.zeros(2, dtype=np.int64)
    jobs = PulseJobs(none, none, 0.225 * g * np.array([1.0, -1.0]))
    found = pulse_outcomes([FRAME], PULSE_SHAPES[shape], np.array([1.0]), jobs, equation="linearised", threads=1)
    assert found.uplifted.tolist() == [True, True]
