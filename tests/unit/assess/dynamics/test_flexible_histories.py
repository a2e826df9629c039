"""Histories on flexible joints: no threshold at rest, impacts at rest, tables with kinks; against scipy's DOP853."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from math import cos, sin, sqrt

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics.history import free_rocking, peaks, product, trace
from assess.dynamics.packing import canonical_form
from assess.interfaces.contact import JointLaw
from assess.loads.load import Force
from assess.oscillator import Oscillator, energy, interpolant
from records.record import make_record
from tests.support.bodies import wall_on_joints
from tests.support.motions import noise

B, H, L = 1.0, 6.0, 2.0
MASS, J = 1800.0 * B * H * L, 1800.0 * B * H * L * (B**2 + H**2) / 12
W, LAW = MASS * g, JointLaw(2e8, 1.5e6)
SHAKING = {"peak": 2.4, "npts": 160, "dt": 0.025, "smooth": 12, "bell": 1.0}


BODIES = {
    "flexible": {},
    "semi-flexible": {"model": "semi-flexible"},
    "leaning": {"loads": (Force("F", (0.0, -4e4), (0.15, 5.5)),)},
}
EVERY = pytest.mark.parametrize("body", BODIES, indirect=True)


@cache
def body_named(name: str) -> Oscillator:
    joint = {"law": LAW, "length": L, "restitution": (0.92, 0.92)} | BODIES[name]
    return wall_on_joints(B, H, **joint).oscillator


@pytest.fixture
def body(request) -> Oscillator:
    return body_named(request.param)


@dataclass(frozen=True)
class IntegratedHistory:
    """By scipy: largest |rotation| over that of overturning, impacts, and signed rotation and velocity at samples."""

    largest: float
    impacts: int
    path: np.ndarray


def by_scipy(body, record, tolerance=1e-12):
    """Restarted at samples, at impacts and at kinks of no account: each branch's equation with events at rest."""
    forms = [[interpolant(s.rotation, v) for v in (s.inertia, s.restoring, s.excitation)] for s in body.branches]
    rates = [form[0].derivative() for form in forms]
    ground, dt = record.acceleration, record.dt
    sign, phi, v, largest, impacts, path = 0, 0.0, 0.0, 0.0, 0, [(0.0, 0.0)]
    scale = body.positive.unstable
    impact, top = (lambda t, y: y[0]), (lambda t, y: y[1])
    impact.terminal, impact.direction, top.direction = True, -1, -1
    for i in range(record.npts - 1):
        t, slope = 0.0, (ground[i + 1] - ground[i]) / dt
        while t < dt:
            if sign == 0:
                sign = 1 if ground[i] + slope * 1e-9 < 0.0 else -1
            side = 0 if sign > 0 else 1
            (inertia, restoring, excitation), rate = forms[side], rates[side]

            def motion(at, y, sign=sign, i=i, slope=slope, I_=inertia, R=restoring, X=excitation, dI=rate):
                push = -X(y[0]) * sign * (ground[i] + slope * at)
                return y[1], (push - R(y[0]) - 0.5 * dI(y[0]) * y[1] ** 2) / I_(y[0])

            out = solve_ivp(motion, (t, dt), (phi, v), method="DOP853", rtol=tolerance, atol=tolerance * scale,
                            events=(impact, top), max_step=dt / 4)  # fmt: skip
            largest = max([largest, *(y[0] / body.branches[side].unstable for y in out.y_events[1])])
            t, (phi, v) = float(out.t[-1]), out.y[:, -1]
            if out.t_events[0].size:
                impacts, v = impacts + 1, -body.branches[side].restitution * v
                phi, sign = 0.0, -sign
        path.append((sign * phi, sign * v))
    return IntegratedHistory(float(largest), impacts, np.array(path))


@EVERY
def test_a_record_against_scipy(body):
    record = noise(3, **SHAKING)
    expected = by_scipy(body, record)
    found = trace(body, record, scale=1.0, equation="exact")
    limit = body.positive.unstable
    assert 0.05 < np.abs(expected.path[:, 0]).max() / limit < 0.9
    assert expected.impacts >= 5
    np.testing.assert_allclose(found.rotation, expected.path[:, 0], rtol=0, atol=1e-7 * limit)
    np.testing.assert_allclose(found.velocity, expected.path[:, 1], rtol=0, atol=1e-6 * limit)


@EVERY
def test_the_largest_rotation_against_scipy(body):
    shaken = noise(4, **SHAKING)
    record = make_record("then still", np.r_[shaken.acceleration, np.zeros(60)], shaken.dt)
    expected = by_scipy(body, record).largest
    found = peaks([body], [record], product(1, 1, 1.0), equation="exact")
    assert not found.overturned[0]
    rotation = float(found.max_rotation[0])
    ratio = abs(rotation) / body.branches[0 if rotation > 0.0 else 1].unstable
    assert found.time_of_max[0] < record.time[-1]
    assert ratio == pytest.approx(expected, rel=1e-7)


# ------------------------------------------------------------------------------------------- a block by its formulas


def shift_and_pivot(s):
    """a_f (thesis 6.2-6.7), the middle of the elastic zone, and its derivative with respect to the slope s."""
    k, f = LAW.stiffness, LAW.strength
    if s <= 2 * W / (k * B**2 * L):
        return B / 2 - k * s * L * B**3 / (12 * W), B / 2, 0.0
    if s <= f**2 * L / (2 * k * W):
        a = sqrt(2 * W / (k * s * L))
        return a / 3, a / 2, -a / (4 * s)
    return (W / (f * L) + f**3 * L / (12 * k**2 * s**2 * W)) / 2, W / (f * L), 0.0


def swing(t, y):
    """Free motion of the wall: the foot's edge keeps its x and sinks as the joint closes."""
    phi, rate = y
    s, c = sin(phi), cos(phi)
    a, p, slope = shift_and_pivot(s)
    x1, x2 = B / 2 * s + H / 2 * c, B / 2 * c - H / 2 * s
    z1, z2 = B / 2 * c - H / 2 * s - p * c, -B / 2 * s - H / 2 * c + p * s - slope * c * c
    inertia, half = J + MASS * (x1**2 + z1**2), MASS * (x1 * x2 + z1 * z2)
    moment = W * (B / 2 * c - H / 2 * s - a * c)
    return rate, -(moment + half * rate**2) / inertia


def test_free_rocking_of_a_block_by_its_formulas():
    """No table: closed forms of the contact and of the motion; impacts by restitution. Six swings."""
    found = free_rocking(body_named("flexible"), rotation=0.1, duration=20.0)
    impact = lambda t, y: y[0]  # noqa: E731
    impact.terminal, impact.direction = True, -1
    top = lambda t, y: y[1]  # noqa: E731
    top.direction = -1
    start, state = 0.0, (0.1, 0.0)
    for number in range(6):
        out = solve_ivp(swing, (start, start + 20.0), state, method="DOP853", rtol=1e-11, atol=1e-13,
                        events=(impact, top), max_step=0.01)  # fmt: skip
        start, velocity = out.t_events[0][0], out.y_events[0][0][1]
        assert found.impact_time[number] == pytest.approx(start, rel=2e-6)
        assert abs(found.impact_velocity[number]) == pytest.approx(-velocity, rel=2e-6)
        if number:
            assert abs(found.peak_rotation[number - 1]) == pytest.approx(out.y_events[1][0][0], rel=5e-6)
        state = (0.0, -0.92 * velocity)


@EVERY
def test_energy_is_kept_without_loss_over_many_cycles(body):
    """Restitution 1: after a hundred impacts every peak stores the energy of the first, to 1e-6."""
    lossless = replace(body, positive=replace(body.positive, restitution=1.0),
                       negative=replace(body.negative, restitution=1.0))  # fmt: skip
    found = free_rocking(lossless, rotation=0.5 * body.positive.unstable, duration=200.0)
    assert found.impact_time.size > 100
    start = float(energy(body.positive, np.array(0.5 * body.positive.unstable)))
    ahead, back = (energy(side, np.abs(found.peak_rotation[sign * found.peak_rotation > 0.0]))
                   for side, sign in ((body.positive, 1.0), (body.negative, -1.0)))  # fmt: skip
    np.testing.assert_allclose(ahead, start, rtol=1e-6)
    np.testing.assert_allclose(back, start, rtol=1e-6)


OPENS = 2 * W / (LAW.stiffness * B**2 * L)  # the rotation at which the flexible joint opens (thesis 6.2)


def hour(rotation, **tolerance):
    """Of free motion without loss: stored energy at each peak over that of the release, and the number of peaks."""
    body = body_named("flexible")
    side = replace(body.positive, restitution=1.0)
    found = free_rocking(Oscillator(side, side, MASS), rotation=rotation, duration=3600.0, **tolerance)
    assert found.peak_time[-1] > 3596.0
    start = float(energy(side, np.array(rotation)))
    return energy(side, np.abs(found.peak_rotation)) / start, found.peak_time.size


@pytest.mark.parametrize(("rotation", "peaks_at_least"), [(0.5 * OPENS, 12_000), (5.0 * OPENS, 8_500), (0.08, 2_000)])
def test_an_hour_of_free_vibration_keeps_its_energy(rotation, peaks_at_least):
    """In full contact, opening, and up to half of overturning.

    At the tolerance of histories, 1e-10 of phi_ov, it loses more, as it may: 12,000 half cycles of some 10 steps make
    1e5 errors of one sign. Next test: there is no loss but this, which goes away with the tolerance.
    """
    stored, peaks_found = hour(rotation)
    assert peaks_found > peaks_at_least
    np.testing.assert_allclose(stored, 1.0, rtol=0, atol=1e-8)


def test_energy_lost_in_an_hour_goes_with_the_tolerance():
    """Or faster, in steps, as an interval is halved until the error is allowed: of a harmonic motion, and of one that
    opens the joint. At that of histories 1e-6 of the energy of a swing in full contact, 1e-8 of what overturns."""
    tolerances = np.array([1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13])
    lost, opening = (np.array([abs(hour(size * OPENS, tolerance=tolerance)[0][-1] - 1.0) for tolerance in tolerances])
                     for size in (0.5, 5.0))  # fmt: skip
    assert 0.85 < np.polyfit(np.log10(tolerances), np.log10(lost), 1)[0] < 1.6
    assert 0.7 < np.polyfit(np.log10(tolerances), np.log10(opening), 1)[0] < 1.15
    assert lost[2] < 1e-6
    assert opening[2] < 2e-5
    side = body_named("flexible").positive
    swing, most = (float(energy(side, np.array(rotation))) for rotation in (0.5 * OPENS, side.unstable))
    assert lost[2] * swing / most < 1e-8


@EVERY
def test_peaks_of_free_rocking_store_what_restitution_leaves(body):
    """Each peak has eta^2 of the energy of the one before, whatever the inertia on the way."""
    found = free_rocking(body, rotation=0.6 * body.positive.unstable, duration=12.0)
    stored = [float(energy(body.positive if peak > 0.0 else body.negative, np.array(abs(peak))))
              for peak in found.peak_rotation[:5]]  # fmt: skip
    start = float(energy(body.positive, np.array(0.6 * body.positive.unstable)))
    np.testing.assert_allclose(stored, start * 0.92 ** (2 * np.arange(1, 6)), rtol=1e-7)


def test_small_motion_is_that_of_the_elastic_frequency():
    """A quarter of a cycle from release to impact, far below the rotation at which the joint opens."""
    body = body_named("flexible")
    K, inertia = LAW.stiffness * L * B**3 / 12 - W * H / 2, J + MASS * (H / 2) ** 2
    found = free_rocking(body, rotation=1e-5, duration=1.0)
    assert found.impact_time[0] == pytest.approx(np.pi / 2 * sqrt(inertia / K), rel=1e-4)


def test_any_shaking_moves_a_wall_on_a_flexible_joint():
    """No threshold: gentle ground, far below what starts a rigid one, gives a static answer, B a / K."""
    slow = make_record("slow", -0.01 * np.sin(np.linspace(0.0, np.pi, 400)), 0.05)
    found = peaks([body_named("flexible")], [slow], product(1, 1, [1.0]), equation="exact")
    K = LAW.stiffness * L * B**3 / 12 - W * H / 2
    assert found.uplifted[0]
    assert abs(found.max_rotation[0]) == pytest.approx(MASS * H / 2 * 0.01 / K, rel=0.1)


def test_the_ratio_is_to_overturning_of_the_rigid_wall():
    found = peaks([body_named("flexible")], [noise(3, **SHAKING)], product(1, 1, 1.0), equation="exact")
    rigid = body_named("flexible").positive.overturning
    assert found.max_ratio[0] == pytest.approx(abs(found.max_rotation[0]) / rigid, rel=1e-12)
    assert body_named("flexible").positive.overturning_flexible < 0.95 * rigid


@EVERY
def test_a_kink_whose_two_nodes_differ_by_rounding_is_no_jump(body):
    """The same history, to the tolerance, and no slower for ending its steps there."""
    twice = np.flatnonzero(np.diff(body.positive.rotation) == 0.0)
    assert twice.size
    restoring = body.positive.restoring.copy()
    restoring[twice + 1] += 1e-15 * restoring.max()
    rough = replace(body, positive=replace(body.positive, restoring=restoring))
    np.testing.assert_array_equal(canonical_form(rough.positive).smooth, canonical_form(body.positive).smooth)
    assert np.ptp(canonical_form(rough.positive).smooth[:, 0]) == 0
