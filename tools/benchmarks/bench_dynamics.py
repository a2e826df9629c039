"""Speed of rocking dynamics beside the targets set for it, in one table from one run; run as a script.

One core: nanoseconds of its time for a step of the record, best of several, on a violent artificial record made here,
up to five times what starts the block. The cost of a step:

linearised   about 30 multiplications where nothing happens, so some 5 ns; an event (impact, peak, uplift) costs some
             ten times that, for a root found on the arc. It grows with the number of events, not with the time step
block        one look at a cubic and its derivatives, some 25 ns, as long as the error of an interval is below the
             tolerance; beyond, an interval takes n steps, and n grows as tolerance^(-1/5) and as dt
tables       the same; on joints each passage through rest crosses the table's finest segments, where the moment turns
             within 1e-5 rad: more passages and stiffer joints cost more

Where a target is missed, this is why. A step is a chain: the next one needs y, y' and y'' of the last, so it costs the
latency of some five products in a row and of the comparisons that let it pass, 15 to 20 cycles or 5 ns, however wide a
processor is; only jobs side by side could share that, which is not done, as events part them. An event costs four or
five turns of Newton's method with two polynomials each, some 50 ns. On joints a passage through rest takes the moment
from its elastic line to its plateau over four decades of rotation, in many steps whatever their order, and a body on
joints never rests: at 10 GPa/m and 1e-10 three steps for each interval of the record were counted, each of twice the
latency of a rigid table's. A lower bound is looked
for in up to 300 amplitudes, 1 % apart; a coarser scan would step over thin bands.

All cores: batches of jobs and envelopes, in seconds. A batch of a tenth of the jobs is scaled, and says so. The error
stands beside the speed: of the linearised equation and the block against scipy's DOP853 at rtol 3e-14; of tables
against the same table at a tolerance of 1e-15; of envelopes against `assess.dynamics.sine_branches`.
"""

from __future__ import annotations

import math
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from scipy.constants import g
from scipy.integrate import solve_ivp

import assess
from assess.dynamics.history import _RUNS, Jobs, Peaks, peaks, product
from assess.dynamics.kernel.columns import FOUND
from assess.dynamics.kernel.events import REST
from assess.dynamics.packing import Equation, pack
from assess.dynamics.pulses import envelope, find_critical
from assess.dynamics.sine_branches import least_overturning_amplitude
from assess.geometry.planar import planar_body_from_values
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.single_block import single_block
from assess.oscillator import Branch, Memory, Oscillator, RockingBlock, plain_branch
from records.pulses import PULSE_SHAPES
from records.record import Record, make_record

P, ALPHA, RESTITUTION = 1.5, 0.2, 0.85
Acceleration = Callable[[float, float, float], float]  # phi, phi', ground acceleration in the branch's sign


def block() -> Oscillator:
    """A rectangular block of M R = 1 kg m."""
    phi = np.linspace(0.0, 1.5 * ALPHA, 257)
    one = np.ones_like(phi)
    moment, excitation = g * np.sin(ALPHA - phi), np.cos(ALPHA - phi)
    side = Branch(phi, g / P**2 * one, moment, excitation, one, one, RESTITUTION, ALPHA, ALPHA)
    return Oscillator(side, side, 1.0)


def violent(npts: int = 4000, dt: float = 0.005) -> Record:
    """20 s of band-limited noise under an envelope, up to 1 g, five times what starts the block."""
    frequency = np.fft.rfftfreq(npts, dt)
    band = np.exp(-0.5 * np.log(np.maximum(frequency, 1e-9) / 1.5) ** 2 / 0.4**2)
    phase = np.random.default_rng(11).uniform(0.0, 2 * np.pi, band.size)
    t = np.arange(npts) * dt
    motion = np.fft.irfft(band * np.exp(1j * phase), npts) * (t / 4.0) ** 2 * np.exp(2.0 - t / 2.0)
    return make_record("violent", 1.0 * g * motion / np.abs(motion).max(), dt)


def of_equation(equation: Equation) -> tuple[Acceleration, float, float]:
    """The block's acceleration by closed formulas, its threshold [m/s2] and its speed of rest [rad/s]."""
    if equation == "exact":
        slow = REST * P * math.sqrt(2 * (1 - math.cos(ALPHA)))
        by_g = 1 / g
        return (
            lambda phi, v, a: -(P**2) * (math.sin(ALPHA - phi) + a * by_g * math.cos(ALPHA - phi)),
            g * math.tan(ALPHA),
            slow,
        )
    form = block().positive.linearised
    p2, phi_ov, gain = form.p**2, form.overturning, form.excitation / form.inertia
    return lambda phi, v, a: p2 * (phi - phi_ov) - gain * a, g * form.multiplier, REST * form.p * phi_ov


def by_scipy(equation: Equation, record: Record, tolerance: float) -> float:
    """Largest rotation [rad] by DOP853."""
    return max(map(abs, swings_by_scipy(equation, record, tolerance)), default=0.0)


def swings_by_scipy(
    equation: Equation,
    record: Record,
    tolerance: float,
    *,
    method: str = "DOP853",
    restitution: float = RESTITUTION,
) -> list[float]:
    """Signed peaks of the rotation [rad] with events, restarted at every sample because the motion has a kink there."""
    accelerate, threshold, slow = of_equation(equation)
    samples, dt = record.acceleration, record.dt
    sign, phi, v, found = 0, 0.0, 0.0, []
    impact, peak = (lambda _, y: y[0]), (lambda _, y: y[1])
    impact.terminal, impact.direction, peak.direction = True, -1, -1  # type: ignore[attr-defined]
    for i in range(record.npts - 1):
        t, a0, slope = 0.0, samples[i], (samples[i + 1] - samples[i]) / dt
        while t < dt:
            a = a0 + slope * t
            if sign == 0:
                if max(abs(a), abs(samples[i + 1])) <= threshold:
                    break
                if abs(a) <= threshold:
                    t = (math.copysign(threshold, samples[i + 1]) - a0) / slope
                sign, phi, v = -1 if a0 + slope * t > 0 else 1, 0.0, 0.0
            out = solve_ivp(
                lambda t, y, s=sign, a0=a0, slope=slope: (y[1], accelerate(y[0], y[1], s * (a0 + slope * t))),
                (t, dt), (phi, v), method=method, rtol=tolerance, atol=tolerance * ALPHA, events=(impact, peak),
            )  # fmt: skip
            found += [sign * float(y[0]) for y in out.y_events[1]]
            t, (phi, v) = float(out.t[-1]), out.y[:, -1]
            if out.t_events[0].size:
                sign, phi, v = -sign, 0.0, -restitution * v
                if v < slow and abs(a0 + slope * t) <= threshold:
                    sign = 0
    return found


def cold_seconds(equation: Equation) -> float:
    """Compiling one equation with an empty cache, in a fresh process; a second, warm process is subtracted."""
    program = (
        f"import time; from {Path(__file__).stem} import block, violent; from assess.dynamics.history import *;"
        "b, r, j = block(), violent(), product(1, 1, 1.0); t = time.perf_counter();"
        f"peaks([b], [r], j, equation={equation!r}); print(time.perf_counter() - t)"
    )
    with tempfile.TemporaryDirectory() as cache:
        path = os.pathsep.join([str(Path(__file__).parent), *sys.path])
        environment = {**os.environ, "NUMBA_CACHE_DIR": cache, "PYTHONPATH": path}
        command = [sys.executable, "-c", program]
        cold, warm = (float(subprocess.check_output(command, env=environment)) for _ in range(2))
    return cold - warm


@dataclass(frozen=True)
class Row:
    """One line of the table."""

    what: str
    cost: float
    unit: str
    target: str = ""
    error: str = ""

    def __str__(self) -> str:
        return f"{self.what:<72}{self.cost:>10.4g} {self.unit:<8}{self.target:>12}{self.error:>12}"


def best(work: Callable[[], object], *, times: int, clock: Callable[[], float] = time.perf_counter) -> float:
    """Seconds, the best of `times` after one that warms up."""
    seconds = []
    for _ in range(times + 1):
        start = clock()
        work()
        seconds.append(clock() - start)
    return min(seconds[1:])


def histories(body: Oscillator, record: Record, equation: Equation, tolerance: float, jobs: int) -> Peaks:
    """As many equal jobs, on one core."""
    scales = product(1, 1, np.ones(jobs))
    return peaks([body], [record], scales, equation=equation, tolerance=tolerance, threads=1)


def nanoseconds(body: Oscillator, record: Record, equation: Equation, tolerance: float, jobs: int = 100) -> float:
    """For a step of the record on one core, without what preparing a call costs."""
    many, few = (
        best(partial(histories, body, record, equation, tolerance, n), times=7, clock=time.process_time)
        for n in (jobs, 1)
    )
    return 1e9 * (many - few) / ((jobs - 1) * (record.npts - 1))


def steps_and_scipy(equation: Equation, target: str) -> list[Row]:
    """The kernel on the violent record, and DOP853 at an error of 1e-8 in the largest rotation, which is less."""
    record = violent()
    found = histories(block(), record, equation, 1e-10, 1)
    if found.overturned[0]:
        raise RuntimeError("the block overturned: choose a weaker motion, so that there is a maximum to compare")
    exact = by_scipy(equation, record, 3e-14)
    for tolerance in 10.0 ** -np.arange(4.0, 13.0):
        start = time.process_time()
        theirs = by_scipy(equation, record, float(tolerance))
        seconds = time.process_time() - start
        if abs(theirs / exact - 1.0) <= 1e-8:
            break
    ours, scipy_step = nanoseconds(block(), record, equation, 1e-10), 1e9 * seconds / (record.npts - 1)
    name = "block, exact, 1e-10" if equation == "exact" else "linearised"
    error = f"{abs(abs(found.max_rotation[0]) / exact - 1.0):.1e}"
    return [
        Row(f"{name}, violent, {found.impacts[0]} impacts", ours, "ns/step", target, error),
        Row(
            f"  solve_ivp, DOP853, rtol {tolerance:.0e}", scipy_step, "ns/step", "", f"{abs(theirs / exact - 1.0):.1e}"
        ),
        Row("  times as quick", scipy_step / ours, "x", ">= 4000"),
        Row("  compiling with an empty cache", cold_seconds(equation), "s"),
    ]


def wall(stiffness: float) -> Oscillator:
    """6 m high, 1 m thick, on a joint of this stiffness [Pa/m] that crushes at 1.5 MPa."""
    mass, joint = 21600.0, Joint((-1.0, 0.0), rectangle(1.0, 2.0), JointLaw(stiffness, 1.5e6), "flexible")
    body = planar_body_from_values(mass=mass, centroid=(0.0, 3.0), inertia=mass * 37 / 12, name="wall")
    rigid = single_block("w", body, hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0))
    return add_joints(rigid, (joint,), (joint,), restitution=(0.9, 0.9)).oscillator


def frame() -> Oscillator:
    """Branches that differ, whose inertia varies."""

    def side(alpha: float, p: float, slope: float) -> Branch:
        phi = np.linspace(0.0, 1.5 * alpha, 500)
        one, inertia = np.ones_like(phi), g / p**2 * (1.0 + slope * phi + 2.0 * phi**2)
        return Branch(phi, inertia, g * np.sin(alpha - phi), np.cos(alpha - phi), one, one, RESTITUTION, alpha, alpha)

    return Oscillator(side(0.25, 1.5, 1.0), side(0.2, 1.6, -0.5), 1.0)


def held(ties: int) -> Memory:
    """A wall 6 m high and 0.6 m thick with ties of 20 mm in all that yield, shared out on so many bars."""
    block = assess.box(thickness=0.6, length=4.0, height=6.0, density=2000.0)
    bars = [
        assess.TieLoad(
            force=10e3 / ties, at=[0, y / 4, 5.5], anchor=[-10, y / 4, 5.5], area=314e-6 / ties, young_modulus=210e9,
            yield_stress=235e6, length=10.0, fracture_strain=0.1, strength=120e3 / ties, evidence="assumed",
        )
        for y in range(ties)
    ]  # fmt: skip
    made = assess.single_block(block, direction=[1, 0, 0], loads=bars)
    memory = made.mechanism.variants.of_histories[0].memory
    assert memory is not None
    return memory


def tied() -> list[Row]:
    """A step of a wall held by ties, beside that of the same wall without."""
    record, rows, plain = violent(), [], 0.0
    for ties in (0, 1, 4):
        memory = held(max(ties, 1))
        body = memory.bare if ties == 0 else Oscillator(memory.bare.positive, memory.bare.negative, 1.0, memory=memory)
        found = histories(body, record, "exact", 1e-10, 1)
        cost = nanoseconds(body, record, "exact", 1e-10, 30)
        plain = plain or cost
        what = f"wall with {ties} ties, {found.impacts[0]} impacts, {cost / plain:.1f} x"
        rows.append(Row(what, cost, "ns/step", "<= 3 x" if ties == 1 else ""))
    return rows


def tables() -> list[Row]:
    """Rigid and on joints, at the default tolerance and a looser one."""
    bodies = {"rigid, inertia varies": frame()} | {f"joint of {k} GPa/m": wall(1e9 * k) for k in (0.2, 1.0, 10.0)}
    record, rows = violent(), []
    quiet = make_record("quieter", 0.6 * record.acceleration, record.dt)
    for name, body in bodies.items():
        exact = histories(body, quiet, "exact", 1e-15, 1)
        for tolerance, target in ((1e-10, ""), (1e-8, "<= 90")):
            found = histories(body, quiet, "exact", tolerance, 1)
            error = abs(found.max_ratio[0] / exact.max_ratio[0] - 1.0)
            state = "overturns" if exact.overturned[0] else f"{exact.max_ratio[0]:.2f} phi_ov"
            cost = nanoseconds(body, quiet, "exact", tolerance, 30)
            rows.append(Row(f"table, {name}, {tolerance:.0e}, {state}", cost, "ns/step", target, f"{error:.1e}"))
    return rows


def blocks(count: int, seed: int = 1) -> list[Oscillator]:
    """Rectangular blocks of alpha 0.08 to 0.3 and p 1 to 4."""
    rng = np.random.default_rng(seed)
    sides = [
        plain_branch(RockingBlock(1.0, 1.0, a, g / p**2), restitution=1.0 - 1.5 * math.sin(a) ** 2)
        for a, p in zip(rng.uniform(0.08, 0.3, count), rng.uniform(1.0, 4.0, count), strict=True)
    ]
    return [Oscillator(side, side, 1.0) for side in sides]


def earthquakes(count: int, npts: int = 2001) -> list[Record]:
    """Smooth noise under a bell, 20 s, with peaks of 0.05 to 0.35 g."""
    rng, bell = np.random.default_rng(3), np.sin(np.linspace(0.0, np.pi, npts))
    made = []
    for number in range(count):
        raw = bell * np.convolve(rng.standard_normal(npts + 24), np.hanning(25), mode="valid")
        made.append(make_record(str(number), rng.uniform(0.05, 0.35) * g * raw / np.abs(raw).max(), 0.01))
    return made


def batches(share: int = 10) -> list[Row]:
    """1,000 records x 100 oscillators x 2,000 steps, by a `share`-th of the records, on all cores."""
    motions, rigid = earthquakes(1000 // share), blocks(100)
    jointed = [wall(10.0**k) for k in np.linspace(8.0, 10.0, 10)]
    rows = []
    for name, bodies, equation, tolerance, target in (
        ("linearised", rigid, "linearised", 1e-10, "<= 1"),
        ("block, 1e-10", rigid, "exact", 1e-10, "<= 4"),
        ("rigid tables, 1e-8", [frame()] * 100, "exact", 1e-8, "<= 8"),
        ("joints of 0.1 to 10 GPa/m, 1e-8", jointed * 10, "exact", 1e-8, "<= 8"),
    ):
        jobs = product(len(bodies), len(motions), 1.0)
        found: list[Peaks] = []
        run = partial(peaks, bodies, motions, jobs, equation=equation, tolerance=tolerance)  # type: ignore[arg-type]
        seconds = best(lambda run=run, found=found: found.append(run()), times=2)  # type: ignore[misc]
        rocked, fell = found[0].uplifted.mean(), found[0].overturned.mean()
        what = f"2e8 steps, {name} ({rocked:.0%} rock, {fell:.0%} fall; 1/{share})"
        rows.append(Row(what, share * seconds, "s", target))
        rows.append(Row("  a step, all cores", 1e9 * seconds / (jobs.scale.size * 2000), "ns"))
    return rows


def envelopes() -> list[Row]:
    """Maps of 200 x 200, and lower bounds of 20 mechanisms at 200 frequencies, on all cores."""
    form = block().positive.linearised
    unit, per_hertz = g * form.multiplier, 2 * math.pi / form.p
    frequency, amplitude = np.linspace(0.2, 10.0, 200) / per_hertz, np.linspace(0.0, 12.0, 200) * unit
    rows = []
    for equation, target in (("linearised", "<= 0.05"), ("exact", "<= 0.5")):
        work = partial(envelope, block(), PULSE_SHAPES["sine"], frequency, amplitude, equation=equation)  # type: ignore[arg-type]
        rows.append(Row(f"envelope 200 x 200 with its lower bound, {equation}", best(work, times=3), "s", target))
    known = np.isfinite(
        lowest := envelope(block(), PULSE_SHAPES["sine"], frequency, amplitude, equation="linearised").lower_bound
    )
    known &= frequency * per_hertz >= 1.5
    closed = np.array([least_overturning_amplitude(f * per_hertz, RESTITUTION) for f in frequency[known]])
    rows[0] = Row(
        rows[0].what, rows[0].cost, "s", rows[0].target, f"{np.abs(lowest[known] / unit / closed - 1).max():.1e}"
    )
    mechanisms, highest = blocks(20, seed=7), np.array([3.0 * g])

    def bounds() -> None:
        found = [
            envelope(each, PULSE_SHAPES["sine"], frequency, highest, equation="linearised").lower_bound
            for each in mechanisms
        ]
        find_critical(frequency, np.array(found))

    return [*rows, Row("lower bounds, 20 mechanisms x 200 frequencies", best(bounds, times=3), "s", "<= 0.1")]


def rattling(count: int = 3000) -> list[Row]:
    """The slowest of many random jobs over the median of those that move, each timed alone, the best of three.

    White noise and square waves at scales from 1e-4 to 100; cost for each sample and each impact.
    """
    rng, rows = np.random.default_rng(9), []
    noise = [rng.standard_normal(1000) for _ in range(10)]
    motions = [make_record(f"noise {k}", each / np.abs(each).max(), 0.01) for k, each in enumerate(noise)]
    motions += [make_record(f"square {k}", np.sign(each), 0.01) for k, each in enumerate(noise)]
    jointed = [wall(10.0**k) for k in np.linspace(8.0, 10.3, 20)]
    for name, bodies, equation in (("linearised", blocks(20), "linearised"), ("block", blocks(20), "exact"), ("joints", jointed, "exact")):  # fmt: skip  # noqa: E501
        run = _RUNS[equation]([pack(body, equation) for body in bodies], motions, 1e-10)  # type: ignore[index,arg-type]
        jobs = Jobs(rng.integers(0, 20, count), rng.integers(0, 20, count), 10.0 ** rng.uniform(-4, 2, count))
        cost = np.array([seconds_each(run, jobs, job) for job in range(count)])
        moving = cost[~np.isnan(cost)]
        what = f"slowest of {moving.size:,} random jobs that move over the median, {name}"
        rows.append(Row(what, float(moving.max() / np.median(moving)), "x", "<= 20"))
    return rows


def seconds_each(run: Callable[..., int], jobs: Jobs, job: int) -> float:
    """Of one job, for each sample and impact; nan where it stays at rest."""
    one, found, nothing, events = slice(job, job + 1), np.empty((1, FOUND)), np.empty((0, 3)), np.zeros((1, 4))
    shortest, samples = math.inf, 0
    for _ in range(3):
        start = time.perf_counter()
        samples = run(jobs.oscillator[one], jobs.motion[one], jobs.scale[one], 0.0, found, nothing, events)
        shortest = min(shortest, time.perf_counter() - start)
    return shortest / (samples + found[0, 3]) if found[0, 6] > 0.0 else math.nan


def main() -> None:
    """The table."""
    print(f"{'what':<72}{'cost':>10} {'':<8}{'target':>12}{'error':>12}    {os.cpu_count()} cores")  # noqa: T201
    parts: tuple[Callable[[], list[Row]], ...] = (
        partial(steps_and_scipy, "linearised", "<= 15"),
        partial(steps_and_scipy, "exact", "<= 60"),
        tables,
        tied,
        batches,
        envelopes,
        rattling,
    )
    for part in parts:
        for row in part():
            print(row, flush=True)  # noqa: T201


if __name__ == "__main__":
    main()
