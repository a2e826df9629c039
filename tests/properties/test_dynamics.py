"""What must hold for rocking histories of every oscillator by either equation."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.constants import g

from assess.dynamics.history import _RUNS, Equation, Peaks, _job_slices, free_rocking, peaks, product, trace
from assess.dynamics.packing import pack
from assess.oscillator import Oscillator, energy, interpolant
from records.record import Record, make_record
from tests.support.blocks import block, branch
from tests.support.motions import noise
from tests.support.strategies import motions, oscillators

EQUATIONS: tuple[Equation, ...] = ("exact", "linearised")
BOTH = pytest.mark.parametrize("equation", EQUATIONS)


BODIES = {
    "block": Oscillator(branch(2.0, 0.2, 0.9), branch(2.0, 0.2, 0.9), 1.0),
    "one-sided": Oscillator(branch(1.6, 0.15, 0.4), None, 1.0),
    "unlike sides": Oscillator(branch(1.8, 0.25, 0.8), branch(2.2, 0.15, 0.95), 1.0),
    "swelling": Oscillator(branch(1.8, 0.25, 0.8, swell=3.0), branch(2.2, 0.2, 0.9, swell=-1.5), 1.0),
    "no rebound": Oscillator(branch(1.8, 0.2, 0.0), branch(1.8, 0.2, 0.0), 1.0),
    "no loss": Oscillator(branch(1.8, 0.2, 1.0), branch(1.8, 0.2, 1.0), 1.0),
    "no loss, one-sided": Oscillator(branch(1.8, 0.2, 1.0), None, 1.0),
}
EVERY = pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)


def run(bodies: list[Oscillator], motions: list[Record], scales: object, equation: Equation, **more: float) -> Peaks:
    return peaks(bodies, motions, product(len(bodies), len(motions), scales), equation=equation, **more)


@BOTH
@EVERY
def test_energy_of_free_motion_never_grows(body: Oscillator, equation: Equation) -> None:
    """Kinetic energy and the potential of the equation used, sampled through impacts; none is lost in between."""
    phi_ov = body.positive.overturning if equation == "exact" else body.positive.linearised.overturning
    still = make_record("shock", np.r_[np.full(6, -6.0), np.zeros(2000)], 0.01)
    found = trace(body, still, scale=1.0, equation=equation)
    assert 0.0 < np.abs(found.rotation).max() < phi_ov
    total = np.zeros(found.time.size)
    for sign, side in zip((1.0, -1.0), body.branches, strict=False):
        on, phi = sign * found.rotation > 0.0, np.abs(found.rotation)
        if equation == "exact":
            inertia, potential = interpolant(side.rotation, side.inertia)(phi), energy(side, phi)
        else:
            form = side.linearised
            inertia, potential = form.inertia, form.stiffness * (form.overturning * phi - phi**2 / 2)
        total[on] = (0.5 * inertia * found.velocity**2 + potential)[on]
    early = slice(7, np.flatnonzero(total > 1e-2 * total[7])[-1])  # later hops are shorter than a sample
    outward = (np.sign(found.rotation) * found.velocity)[early]
    kept = (found.rotation[early][1:] * found.rotation[early][:-1] > 0.0) & (
        np.diff(outward) < 0.0
    )  # no impact between
    steps = np.diff(total[early]) / total[7]
    assert np.count_nonzero(kept) > 20
    assert np.abs(steps[kept]).max() < 1e-9
    if np.ptp([side.inertia[0] for side in body.branches]) == 0.0 and equation == "exact":
        assert steps.max() < 1e-9  # nor at impacts, where the inertia at rest is the same on both sides
    if body.positive.restitution == 1.0:
        assert np.abs(steps).max() < 1e-8


@BOTH
@EVERY
def test_velocity_after_an_impact_is_less_by_the_restitution(body: Oscillator, equation: Equation) -> None:
    """The peak after an impact follows from the velocity before it by the energy of the branch that follows."""
    found = free_rocking(body, rotation=0.6 * body.positive.overturning, duration=4.0, equation=equation)
    for velocity, peak in zip(found.impact_velocity, found.peak_rotation, strict=False):
        before = body.branches[0 if velocity < 0.0 else -1]
        after = body.branches[0 if peak > 0.0 else -1]
        assert np.sign(peak) == (np.sign(velocity) if body.negative is not None else 1.0)
        form, left = after.linearised, abs(velocity) * before.restitution
        phi = np.abs(peak)
        stored = energy(after, phi) if equation == "exact" else form.stiffness * (form.overturning * phi - phi**2 / 2)
        inertia = after.inertia[0] if equation == "exact" else form.inertia
        assert stored == pytest.approx(0.5 * inertia * left**2, rel=1e-8)


@BOTH
@given(body=oscillators(two_sided=True), motion=motions())
def test_mirrored_oscillator_is_reversed_polarity(body: Oscillator, motion: Record, equation: Equation) -> None:
    assert body.negative is not None
    mirrored = Oscillator(body.negative, body.positive, body.mass)
    ours, theirs = run([body], [motion], [1.0, 0.8], equation), run([mirrored], [motion], [-1.0, -0.8], equation)
    np.testing.assert_array_equal(ours.max_rotation, -theirs.max_rotation)
    np.testing.assert_array_equal(ours.impacts, theirs.impacts)
    np.testing.assert_array_equal(ours.overturning_time, theirs.overturning_time)


@BOTH
@given(alpha=st.floats(0.1, 0.35), restitution=st.floats(0.0, 1.0), motion=motions())
def test_froude_similarity(alpha: float, restitution: float, motion: Record, equation: Equation) -> None:
    """A block 4 times as large (p half) under the motion stretched by 2 in time makes the same rotations."""
    slow = make_record(motion.id, motion.acceleration, 2.0 * motion.dt)
    ours = run([block(2.0, alpha, restitution)], [motion], 1.0, equation)
    theirs = run([block(1.0, alpha, restitution)], [slow], 1.0, equation)
    np.testing.assert_allclose(theirs.max_rotation, ours.max_rotation, rtol=1e-12)
    np.testing.assert_allclose(theirs.time_of_max, 2.0 * ours.time_of_max, rtol=1e-12)
    np.testing.assert_array_equal(theirs.impacts, ours.impacts)


@BOTH
def test_small_angles_tend_to_the_linearised_equation(equation: Equation) -> None:
    """Slenderness 1e-4: both equations agree to its square."""
    alpha = 1e-4
    body = Oscillator(branch(2.0, alpha, 0.9), branch(2.0, alpha, 0.9), 1.0)
    pulse = make_record("pulse", -2.0 * g * alpha * np.sin(np.linspace(0.0, 2 * np.pi, 41)), 0.015)
    exact, linear = run([body], [pulse], 1.0, "exact"), run([body], [pulse], 1.0, "linearised")
    assert exact.max_ratio[0] > 0.01
    assert linear.max_ratio[0] == pytest.approx(exact.max_ratio[0], rel=1e-6)


@BOTH
def test_as_many_threads_as_wanted_give_the_same_bytes(equation: Equation, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("assess.dynamics.history.CHUNK_STEPS", 2000)
    motions, scales = [noise(seed) for seed in range(4)], np.linspace(0.3, 2.0, 5)
    assert len(_job_slices(product(len(BODIES), 4, scales), motions, threads=2)) > 10
    single, double = (run(list(BODIES.values()), motions, scales, equation, threads=threads) for threads in (1, 2))
    assert all(getattr(single, name).tobytes() == getattr(double, name).tobytes() for name in vars(single))


@BOTH
def test_sampling_finer_along_the_same_lines_changes_nothing(equation: Equation) -> None:
    """Every interval divided into 7: the same motion, other steps, events elsewhere in them."""
    coarse = noise(3, peak=2.8, npts=150, dt=0.04)
    fine_time = np.linspace(0.0, coarse.time[-1], 7 * (coarse.npts - 1) + 1)
    fine = make_record("fine", np.interp(fine_time, coarse.time, coarse.acceleration), coarse.dt / 7)
    for body in (BODIES["block"], BODIES["swelling"], BODIES["one-sided"]):
        ours, theirs = run([body], [coarse], 1.0, equation), run([body], [fine], 1.0, equation)
        assert ours.impacts[0] > 0
        assert not ours.overturned[0]
        assert ours.max_ratio[0] == pytest.approx(theirs.max_ratio[0], rel=1e-7)


def test_error_goes_with_the_tolerance() -> None:
    """Long intervals, so that the tolerance and not the sample rules the step: the error is in proportion."""
    body = BODIES["swelling"]
    motion = make_record("slow", -3.2 * np.sin(np.linspace(0.0, 2 * np.pi, 7)), 0.2)
    tolerances = 10.0 ** -np.arange(5.0, 12.0)
    found = np.array([run([body], [motion], 1.0, "exact", tolerance=t).max_ratio[0] for t in tolerances])
    best = run([body], [motion], 1.0, "exact", tolerance=1e-14).max_ratio[0]
    errors = np.abs(found / best - 1.0)
    assert errors[0] > 1e-6
    assert errors[-1] < 1e-9
    assert 0.9 < np.polyfit(np.log10(tolerances), np.log10(errors), 1)[0] < 1.1


@BOTH
@pytest.mark.parametrize("scale", [1.0, 30.0, 1e4])
def test_rattling_never_stalls(equation: Equation, scale: float) -> None:
    """Random square-wave motion on every body, also where the ground presses it on its wall; 1 s each at most."""
    rng = np.random.default_rng(7)
    motions = [make_record(f"square {i}", 3.0 * np.sign(rng.standard_normal(80)), 0.05) for i in range(3)]
    motions += [noise(i, peak=2.5, npts=100) for i in range(3)]
    motions += [make_record("held", np.r_[-4.0, -4.0, np.full(98, 1.9)], 0.02)]
    found = run(list(BODIES.values()), motions, [scale, -scale], equation)
    assert np.isfinite(found.max_ratio).all()
    assert found.uplifted.any()
    assert (found.max_ratio[~found.uplifted] == 0.0).all()


@BOTH
@EVERY
def test_quiet_motion_leaves_it_at_rest(body: Oscillator, equation: Equation) -> None:
    threshold = min(side.restoring[0] / side.excitation[0] for side in body.branches)
    for ground in ([0.0, 0.0], 0.97 * threshold * np.sin(np.arange(200.0))):
        found = run([body], [make_record("quiet", ground, 0.01)], [1.0, -1.0, 0.0], equation)
        assert not found.uplifted.any()
        assert not found.overturned.any()
        assert found.max_rotation.tolist() == found.time_of_max.tolist() == found.impacts.tolist() == [0, 0, 0]


PROGRAM = """
import json, sys
sys.path.insert(0, {folder!r})
import numpy as np
from assess.dynamics.history import peaks, product
from {module} import BODIES, noise
motions = [noise(seed, npts=60, peak=5.0) for seed in (1, 2)]
for equation in ("exact", "linearised"):
    found = peaks(list(BODIES.values()), motions, product(len(BODIES), 2, [1.0]), equation=equation)
    print(json.dumps([found.max_rotation.tolist(), found.impacts.tolist(), found.overturned.tolist()]))
"""


def test_as_plain_python_it_gives_the_compiled_answers() -> None:
    """The whole kernel without numba. Products and sums are then rounded one by one; impacts widen the difference."""
    program = PROGRAM.format(folder=os.path.dirname(__file__), module="test_dynamics")
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    motions = [noise(seed, npts=60, peak=5.0) for seed in (1, 2)]
    for equation, line in zip(EQUATIONS, done.stdout.splitlines(), strict=True):
        rotation, impacts, overturned = json.loads(line)
        found = run(list(BODIES.values()), motions, [1.0], equation)
        np.testing.assert_allclose(np.abs(rotation), np.abs(found.max_rotation), rtol=1e-8)  # peaks can be alike
        assert impacts == found.impacts.tolist()
        assert overturned == found.overturned.tolist()
        assert found.impacts.sum() > 10


@pytest.mark.study  # what py_func calls is compiled anew, 10 s; the test above runs all of it as plain Python
@BOTH
def test_entry_point_as_py_func_gives_the_compiled_bytes(equation: Equation) -> None:
    body, motion = BODIES["swelling"], noise(3, npts=80, peak=5.0)
    kernel_run = _RUNS[equation]([pack(body, equation)], [motion], 1e-11)
    found, first = np.empty((2, 1, 8)), np.zeros(1, dtype=np.int64)
    for call, row in zip((kernel_run.func, kernel_run.func.py_func), found, strict=True):
        call(*kernel_run.args, first, first, np.ones(1), 0.0, row, np.empty((0, 3)), np.zeros((1, 4)))
    np.testing.assert_array_equal(found[0], found[1])
    assert found[0, 0, 0] > 0.0
