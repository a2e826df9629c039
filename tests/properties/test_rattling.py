"""Rattling never stalls: random oscillators under random motions at scales from a whisper to a hundred.

What a job may cost is a small multiple of its samples and its impacts, which are physics. Steps are counted, in plain
Python, so that no clock decides; seconds are measured by tools/benchmarks/bench_dynamics.py.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable

import numpy as np
import pytest
from scipy.constants import g

from assess.dynamics.history import _RUNS, Jobs, peaks
from assess.dynamics.kernel import exact, joints, linearised
from assess.dynamics.kernel.columns import IMPACTS
from assess.dynamics.kernel.march import make_march
from assess.dynamics.packing import Equation, pack
from assess.geometry.planar import planar_body_from_values
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.single_block import single_block
from assess.oscillator import Oscillator, RockingBlock, plain_branch
from records.record import Record, make_record

MOST = {"rigid": 16.0, "linearised": 5.0, "on joints": 30.0}
"""Steps for each sample and impact. Seen are 10.7, 3.3 and 22.3: white noise up to 100 m/s2 asks for the most, as the
error of a step is held at 1e-10 while the ground changes by several overturning accelerations in an interval."""
KINDS: dict[str, Equation] = {"rigid": "exact", "linearised": "linearised", "on joints": "exact"}


def rigid(rng: np.random.Generator) -> Oscillator:
    """A block, one time in three with a wall behind it; every kind of bounce, also none and without loss."""
    alpha, p, restitution = rng.uniform(0.05, 0.4), rng.uniform(0.8, 4.0), rng.choice([0.0, 0.3, 0.7, 0.9, 0.99, 1.0])
    side = plain_branch(RockingBlock(1.0, 1.0, alpha, g / p**2), restitution=restitution)
    return Oscillator(side, side if rng.random() < 2 / 3 else None, 1.0)


def on_a_joint(rng: np.random.Generator) -> Oscillator:
    """A wall of 6 m by 1 m on a joint of 0.03 to 20 GPa/m."""
    mass, joint = (
        21600.0,
        Joint((-1.0, 0.0), rectangle(1.0, 2.0), JointLaw(10 ** rng.uniform(7.5, 10.3), 1.5e6), "flexible"),
    )
    body = planar_body_from_values(mass=mass, centroid=(0.0, 3.0), inertia=mass * 37 / 12, name="wall")
    wall = single_block("w", body, hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0))
    restitution = rng.uniform(0.6, 1.0)
    return add_joints(wall, (joint,), (joint,), restitution=(restitution, restitution)).oscillator


def motion(rng: np.random.Generator, npts: int) -> Record:
    """Square waves, white noise, a sine, smooth noise, or a sine that ends as a push held."""
    t, noise = np.arange(npts) * 0.01, rng.standard_normal(npts)
    smooth = np.convolve(rng.standard_normal(npts + 20), np.hanning(21), mode="valid")
    sine, held = np.sin(2 * np.pi * rng.uniform(0.2, 20.0) * t), np.where(t < 0.005 * npts, np.sin(6 * t), -0.5)
    kinds = (np.sign(noise), noise, sine, smooth, held)
    shape = kinds[rng.integers(len(kinds))]
    return make_record("any", shape / np.abs(shape).max(), float(rng.choice([0.005, 0.01])))


def problem(kind: str, *, jobs: int, npts: int) -> tuple[list[Oscillator], list[Record], Jobs]:
    rng = np.random.default_rng(2026)
    make = on_a_joint if kind == "on joints" else rigid
    bodies, motions = [make(rng) for _ in range(12)], [motion(rng, npts) for _ in range(24)]
    scale = 10.0 ** rng.uniform(-4.0, 2.0, jobs) * rng.choice([-1.0, 1.0], jobs)
    return bodies, motions, Jobs(rng.integers(0, len(bodies), jobs), rng.integers(0, len(motions), jobs), scale)


@pytest.mark.parametrize("kind", KINDS)
def test_ten_thousand_jobs_end_with_numbers(kind: str) -> None:
    bodies, motions, jobs = problem(kind, jobs=10_000, npts=200)
    found = peaks(bodies, motions, jobs, equation=KINDS[kind], threads=1)
    assert np.isfinite(found.max_ratio).all()
    assert 500 < found.overturned.sum() < 9_500
    assert found.uplifted.sum() > 2_000
    assert (found.max_ratio[~found.uplifted] == 0.0).all()


def counted(step: Callable[..., object], count: list[int]) -> Callable[..., object]:
    def one(*arguments: object) -> object:
        count[0] += 1
        return step(*arguments)

    return one


def print_steps(kind: str) -> None:
    """Of each job: steps of the kernel outside its quick path (on joints also in it), samples, impacts.

    In plain Python, without numba.
    """
    count = [0]
    joints.evaluate_force = counted(joints.evaluate_force, count)
    step = counted(exact.exact_step, count)
    exact.march_exact = make_march(exact.exact_advance, step, exact.exact_potential)
    step = counted(linearised.linearised_step, count)
    linearised.march_linearised = make_march(linearised.linearised_advance, step, linearised.linearised_potential)
    bodies, motions, jobs = problem(kind, jobs=150, npts=100)
    run = _RUNS[KINDS[kind]]([pack(body, KINDS[kind]) for body in bodies], motions, 1e-10)
    for k in range(jobs.scale.size):
        count[0], found = 0, np.empty((1, 8))
        columns = (column[k : k + 1] for column in (jobs.oscillator, jobs.motion, jobs.scale))
        samples = run(*columns, 0.0, found, np.empty((0, 3)), np.zeros((1, 4)))
        print(count[0], samples, int(found[0, IMPACTS]))  # noqa: T201


@pytest.fixture(scope="module")
def counts() -> dict[str, np.ndarray]:
    """Steps, samples and impacts of each job of every kind, counted by a process of its own without numba."""
    program = f"import sys; sys.path.insert(0, {os.path.dirname(__file__)!r})\n"
    program += "from test_rattling import KINDS, print_steps\n"
    program += "for kind in KINDS: print_steps(kind); print()"
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
    blocks = done.stdout.strip().split("\n\n")
    rows = [[line.split() for line in block.splitlines()] for block in blocks]
    return {kind: np.array(each, dtype=float).T for kind, each in zip(KINDS, rows, strict=True)}


@pytest.mark.parametrize("kind", KINDS)
def test_steps_are_few_for_samples_and_impacts(kind: str, counts: dict[str, np.ndarray]) -> None:
    steps, samples, impacts = counts[kind]
    cost = steps / (samples + impacts)
    moving = cost[steps > 0]
    assert moving.size > 30
    assert cost.max() < MOST[kind]
    assert cost.max() < 20.0 * np.median(moving)
