"""Speed of both rocking kernels beside scipy's DOP853 at an error of 1e-8 in the largest rotation; cost of compiling.

Run as a script. Everything is measured in one run, on one core, on a violent artificial record made here: the ratios
travel better from machine to machine than the nanoseconds.
"""

from __future__ import annotations

import math
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics.history import Equation, peaks, product
from assess.dynamics.kernel import REST
from assess.oscillator import Branch, Oscillator, linearise
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
    form = linearise(block().positive)
    p2, phi_ov, gain = form.p**2, form.overturning, form.excitation / form.inertia
    return lambda phi, v, a: p2 * (phi - phi_ov) - gain * a, g * form.multiplier, REST * form.p * phi_ov


def by_scipy(equation: Equation, record: Record, tolerance: float) -> float:
    """Largest rotation [rad] by DOP853 with events, restarted at every sample because the motion has a kink there."""
    accelerate, threshold, slow = of_equation(equation)
    samples, dt = record.acceleration, record.dt
    sign, phi, v, largest = 0, 0.0, 0.0, 0.0
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
                (t, dt), (phi, v), method="DOP853", rtol=tolerance, atol=tolerance * ALPHA, events=(impact, peak),
            )  # fmt: skip
            largest = max([largest, *(y[0] for y in out.y_events[1])])
            t, (phi, v) = float(out.t[-1]), out.y[:, -1]
            if out.t_events[0].size:
                sign, phi, v = -sign, 0.0, -RESTITUTION * v
                if v < slow and abs(a0 + slope * t) <= threshold:
                    sign = 0
    return float(largest)


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


def nanoseconds(equation: Equation, record: Record, jobs: int = 100) -> float:
    """Per record step on one core, the best of seven."""
    some = product(1, 1, np.ones(jobs))
    best = math.inf
    for _ in range(7):
        start = time.perf_counter()
        peaks([block()], [record], some, equation=equation, threads=1)
        best = min(best, time.perf_counter() - start)
    return 1e9 * best / (jobs * (record.npts - 1))


def row(equation: Equation) -> str:
    """One line of the table."""
    record = violent()
    found = peaks([block()], [record], product(1, 1, 1.0), equation=equation)
    if found.overturned[0]:
        raise RuntimeError("the block overturned: choose a weaker motion, so that there is a maximum to compare")
    ours = abs(found.max_rotation[0])
    best = by_scipy(equation, record, 3e-14)
    for tolerance in 10.0 ** -np.arange(4.0, 13.0):
        start = time.perf_counter()
        theirs = by_scipy(equation, record, float(tolerance))
        seconds = time.perf_counter() - start
        if abs(theirs / best - 1.0) <= 1e-8:
            break
    step, scipy_step = nanoseconds(equation, record), 1e9 * seconds / (record.npts - 1)
    return (
        f"{equation:<12}{found.max_ratio[0]:>8.4f}{found.impacts[0]:>9d}{step:>11.1f}{abs(ours / best - 1.0):>12.1e}"
        f"{scipy_step:>13.0f}{tolerance:>9.0e}{abs(theirs / best - 1.0):>12.1e}{scipy_step / step:>9.0f}"
        f"{cold_seconds(equation):>12.1f}"
    )


def main() -> None:
    """The table."""
    print(  # noqa: T201
        f"{'equation':<12}{'ratio':>8}{'impacts':>9}{'ns/step':>11}{'error':>12}"
        f"{'DOP853 ns':>13}{'rtol':>9}{'error':>12}{'quicker':>9}{'compile s':>12}"
    )
    equations: tuple[Equation, ...] = ("linearised", "exact")
    for equation in equations:
        print(row(equation))  # noqa: T201


if __name__ == "__main__":
    main()
