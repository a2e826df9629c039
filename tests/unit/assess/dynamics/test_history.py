"""Jobs, traces and errors of rocking histories."""

from __future__ import annotations

import dataclasses
from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics.history import Jobs, free_rocking, peaks, product, trace
from assess.dynamics.kernel.columns import BLOCK
from assess.errors import MechanismError
from assess.oscillator import Oscillator
from records.record import make_record
from tests.support.blocks import block
from tests.support.motions import sine
from tests.support.scipy_rocking import event


def test_product_makes_every_combination_once() -> None:
    jobs = product(2, 3, [1.0, -1.0])
    made = list(zip(jobs.oscillator.tolist(), jobs.motion.tolist(), jobs.scale.tolist(), strict=True))
    assert made == [(o, m, s) for o in range(2) for m in range(3) for s in (1.0, -1.0)]


@pytest.mark.parametrize("equation", ["exact", "linearised"])
def test_a_trace_reaches_the_peak(equation: str) -> None:
    motion = make_record("pulse and rest", np.r_[sine(3.0, 1.25).acceleration, np.zeros(200)], 0.008)
    found = peaks([block(nodes=65)], [motion], product(1, 1, [1.0]), equation=equation)
    history = trace(block(nodes=65), motion, scale=1.0, equation=equation)
    assert history.time.size == motion.npts
    near = np.searchsorted(history.time, found.time_of_max[0])
    assert history.rotation[near] == pytest.approx(found.max_rotation[0], rel=1e-2)
    assert np.abs(history.rotation).max() <= abs(found.max_rotation[0])
    middle = slice(near - 20, near - 1)
    steps = np.diff(history.rotation[middle]) / motion.dt
    np.testing.assert_allclose(steps, 0.5 * (history.velocity[middle][1:] + history.velocity[middle][:-1]), rtol=1e-2)


def test_a_trace_from_a_release_is_the_hyperbolic_cosine_of_the_linearised_equation() -> None:
    """phi = phi_ov - (phi_ov - phi_0) cosh(p t) until the impact, 0.9 of the velocity after it (Housner 1963)."""
    still = make_record("still ground", np.zeros(401), 0.005)
    history = trace(block(nodes=65), still, scale=1.0, equation="linearised", release=0.15)
    form = block(nodes=65).positive.linearised
    swing = form.overturning - (form.overturning - 0.15) * np.cosh(form.p * history.time)
    before = swing > 0.0
    assert 50 < before.sum() < history.time.size - 50
    np.testing.assert_allclose(history.rotation[before], swing[before], rtol=1e-10)
    after = np.flatnonzero(~before)[0]
    t = np.arccosh(form.overturning / (form.overturning - 0.15)) / form.p
    speed = 0.9 * form.p * np.sqrt(0.15 * (2 * form.overturning - 0.15))
    x = form.p * (history.time[after] - t)
    expected = form.overturning * (1.0 - np.cosh(x)) + speed / form.p * np.sinh(x)
    assert history.rotation[after] == pytest.approx(-expected, rel=1e-9)


def test_a_body_that_would_dip_below_rest_between_two_samples_has_hit_the_ground() -> None:
    """It falls with p dt = 0.005 for one interval; in the next the ground throws it up again, too late by 4e-6."""
    body = block(nodes=65)
    form = body.positive.linearised
    dt, thrown = 0.005, 12.0  # of 1 / p, and times what lifts the block
    motion = make_record("thrown", [0.0, 0.0, -thrown * form.multiplier * g, 0.0], dt / form.p)
    history = trace(body, motion, scale=1.0, equation="linearised", release=1.75e-5 * form.overturning)
    y = 1.0 - (1.0 - 1.75e-5) * np.cosh(dt)
    assert history.rotation[1] == pytest.approx(y * form.overturning, rel=1e-9)

    t, v, sides = 0.0, -(1.0 - 1.75e-5) * np.sinh(dt), []
    while t < dt:
        sides.append(s := -1.0 if sides and sides[-1] > 0.0 else 1.0)
        out = solve_ivp(lambda x, u, s=s: [u[1], u[0] - 1.0 + s * thrown * x / dt], (t, dt), [y, v], method="DOP853",
                        rtol=3e-14, atol=1e-18, events=[event(0, direction=-1, terminal=True)])  # fmt: skip
        t, (y, v) = out.t[-1], (out.y[0, -1], out.y[1, -1])
        if out.t_events[0].size:
            y, v = 0.0, -form.restitution * v
    assert sides == [1.0, -1.0, 1.0]
    assert history.rotation[2] == pytest.approx(y * form.overturning, rel=1e-6)


@pytest.mark.parametrize("equation", ["exact", "linearised"])
def test_a_trace_ends_where_the_body_has_overturned(equation: str) -> None:
    motion = make_record("pulse and rest", np.r_[sine(9.0, 1.25).acceleration, np.zeros(2000)], 0.008)
    found = peaks([block(nodes=65)], [motion], product(1, 1, [1.0]), equation=equation)
    history = trace(block(nodes=65), motion, scale=1.0, equation=equation)
    assert found.overturned[0]
    assert found.overturning_time[0] < history.time[-1] < motion.time[-1]
    assert np.interp(found.overturning_time[0], history.time, np.abs(history.rotation)) == pytest.approx(0.2, rel=1e-3)


def test_results_are_read_only() -> None:
    found = peaks([block(nodes=65)], [sine(3.0, 1.25)], product(1, 1, [1.0]), equation="exact")
    with pytest.raises(ValueError, match="read-only"):
        found.max_ratio[0] = 1.0


def test_no_jobs_no_peaks() -> None:
    empty = np.empty(0, dtype=np.int64)
    assert (
        peaks([block(nodes=65)], [sine(3.0, 1.25)], Jobs(empty, empty, np.empty(0)), equation="exact").max_ratio.size
        == 0
    )


@pytest.mark.parametrize(
    ("jobs", "message"),
    [
        (
            replace(product(1, 1, [1.0]), oscillator=np.ones(1, dtype=np.int64)),
            r"jobs\[0\]: oscillator 1, but there are 1",
        ),
        (replace(product(1, 1, [1.0]), motion=-np.ones(1, dtype=np.int64)), r"jobs\[0\]: motion -1, but there are 1"),
        (product(1, 1, [np.nan]), r"jobs\[0\]: scale nan"),
        (Jobs(np.zeros(2, dtype=np.int64), np.zeros(1, dtype=np.int64), np.ones(1)), "one of each for every job"),
    ],
)
def test_jobs_that_name_nothing(jobs: Jobs, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        peaks([block(nodes=65)], [sine(3.0, 1.25)], jobs, equation="exact")


def test_an_unknown_equation_lists_the_known() -> None:
    with pytest.raises(ValueError, match="exact, linearised"):
        peaks([block(nodes=65)], [sine(3.0, 1.25)], product(1, 1, [1.0]), equation="cubic")  # type: ignore[arg-type]


@pytest.mark.parametrize("equation", ["exact", "linearised"])
@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"restitution": 1.2}, "restitution 1.2"),
        ({"overturning": 0.0}, "overturning rotation 0"),
        ({"inertia": np.zeros(65)}, "inertia"),
        ({"restoring": -np.ones(65)}, "already falling|stiffness|work"),
    ],
)
def test_branches_that_cannot_rock(equation: str, changes: dict[str, object], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        peaks([block(nodes=65, **changes)], [sine(3.0, 1.25)], product(1, 1, [1.0]), equation=equation)


@pytest.mark.parametrize("equation", ["exact", "linearised"])
def test_a_record_that_starts_beyond_uplift_and_reverses_within_a_step_lifts_the_side_it_pushes_first(
    equation: str,
) -> None:
    """A body that is the same both ways answers the reversed record with the mirrored motion."""
    motion = make_record("reversal", np.array([4.0, -9.0, 0.0, 0.0]), 0.05)
    found = peaks([block(nodes=65)], [motion], product(1, 1, [1.0, -1.0]), equation=equation)
    assert found.max_rotation[0] == -found.max_rotation[1] != 0.0
    assert found.impacts[0] == found.impacts[1]


@pytest.mark.parametrize("equation", ["exact", "linearised"])
def test_one_strong_sample_lifts_the_body_wherever_it_stands(equation: str) -> None:
    """Stretches at rest are passed by the extremes of many samples: within them, at their ends, and after the last."""
    body, samples, dt = block(nodes=65), 3 * BLOCK + 6, 0.01
    threshold = (
        min(side.restoring[0] / side.excitation[0] for side in body.branches)
        if equation == "exact"
        else (g * min(side.linearised.multiplier for side in body.branches))
    )
    for strong, lifts in ((1.01, True), (0.99, False)):
        motions = [make_record(f"strong at {k}", strong * threshold * np.eye(samples)[k], dt) for k in range(samples)]
        found = peaks([body], motions, product(1, samples, [1.0, -1.0]), equation=equation, threads=1)
        assert found.uplifted.tolist() == [lifts] * (2 * samples)
        if lifts:
            time = found.time_of_max.reshape(samples, 2)
            np.testing.assert_allclose(np.diff(time[1:-1], axis=0), dt, rtol=1e-6)


@pytest.mark.parametrize("polarity", [1.0, -1.0])
def test_the_larger_ratio_is_found_where_the_joints_of_two_sides_lower_phi_ov_unlike(polarity: float) -> None:
    """The smaller share of a side's own unstable rotation can be the larger ratio to the rigid phi_ov."""
    plain, lowered = (block(nodes=65, overturning_flexible=0.2, overturning=rigid).positive for rigid in (0.2, 0.6))
    motion = make_record("pulse and rest", np.r_[sine(3.0, 1.25).acceleration, np.zeros(200)], 0.008)
    for oscillator in (Oscillator(plain, lowered, 1.0), Oscillator(lowered, plain, 1.0)):
        found = peaks([oscillator], [motion], product(1, 1, [polarity]), equation="exact")
        rotation = trace(oscillator, motion, scale=polarity, equation="exact").rotation
        of = [rotation.max() / oscillator.branches[0].overturning, -rotation.min() / oscillator.branches[1].overturning]
        assert found.max_ratio[0] == pytest.approx(max(of), rel=1e-3)
        assert np.sign(found.max_rotation[0]) == 1 - 2 * np.argmax(of)


def test_restitutions_that_together_add_energy_are_refused() -> None:
    """Turning faster about a nearer hinge is no gain of energy, coming back as fast is."""
    phi = np.linspace(0.0, 0.3, 65)
    near, far = block(nodes=65).positive, block(nodes=65, inertia=np.full_like(phi, g / 2.0)).positive
    with pytest.raises(MechanismError, match=r"1\.35 and 0\.9.*product must be at most 1"):
        peaks(
            [Oscillator(dataclasses.replace(far, restitution=1.35), near, 1.0)],
            [sine(3.0, 1.25)],
            product(1, 1, [1.0]),
            equation="exact",
        )
    slower = dataclasses.replace(near, restitution=0.7)
    peaks(
        [Oscillator(dataclasses.replace(far, restitution=1.35), slower, 1.0)],
        [sine(3.0, 1.25)],
        product(1, 1, [1.0]),
        equation="exact",
    )


@pytest.mark.parametrize("rotation", [-0.1, 0.0, np.nan, np.inf])
def test_a_release_is_at_a_positive_rotation(rotation: float) -> None:
    with pytest.raises(ValueError, match="release at"):
        free_rocking(block(nodes=65), rotation=rotation, duration=1.0)
