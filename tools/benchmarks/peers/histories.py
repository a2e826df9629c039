"""A rocking history under a record: the program beside scipy's `solve_ivp` with events."""

from __future__ import annotations

from functools import partial

import numpy as np
from scipy.integrate import solve_ivp

from assess.dynamics.history import peaks, product
from assess.dynamics.packing import Equation
from records.record import Record, make_record
from tools.benchmarks.bench_dynamics import (
    ALPHA,
    RESTITUTION,
    block,
    earthquakes,
    of_equation,
    swings_by_scipy,
    violent,
)
from tools.benchmarks.peers.measure import Program, Table, duration, least, measure, off, order

TIGHTEST = 3e-14
"""Tolerance of the reference, DOP853 at the limit of double precision."""
METHODS = (("DOP853", 1e-6), ("DOP853", 1e-10), ("RK45", 1e-6), ("RK45", 1e-10))
STRETCHES = (2, 8, 32)
"""Lengths of the growth, in records of the table at half their strength."""


def largest_by_us(equation: Equation, record: Record, tolerance: float, jobs: int = 1) -> float:
    """Return the largest rotation [rad] of so many equal jobs, on one core, preparing the oscillator included."""
    found = peaks([block()], [record], product(1, 1, np.ones(jobs)), equation=equation, threads=1, tolerance=tolerance)
    return abs(float(found.max_rotation[0]))


def largest_by_scipy(equation: Equation, record: Record, tolerance: float, method: str = "DOP853") -> float:
    """Return the largest rotation [rad] by `solve_ivp`."""
    return max(map(abs, swings_by_scipy(equation, record, tolerance, method=method)))


def largest_in_one_go(equation: Equation, record: Record, tolerance: float, method: str) -> float:
    """Return the largest rotation [rad] by `solve_ivp` from event to event, the ground between samples by `interp`."""
    accelerate, threshold, slow = of_equation(equation)
    times, samples = np.arange(record.npts) * record.dt, record.acceleration
    t, v, sign, largest = 0.0, 0.0, 0, 0.0
    impact, peak = (lambda _, y: y[0]), (lambda _, y: y[1])
    impact.terminal, impact.direction, peak.direction = True, -1, -1  # type: ignore[attr-defined]
    while t < times[-1]:
        if sign == 0:
            t, sign = uplift(times, samples, t, threshold)
            if sign == 0:
                break
            v = 0.0
        out = solve_ivp(
            lambda t, y, s=sign: (y[1], accelerate(y[0], y[1], s * np.interp(t, times, samples))),
            (t, times[-1]), (0.0, v), method=method, rtol=tolerance, atol=tolerance * ALPHA, max_step=record.dt,
            events=(impact, peak),
        )  # fmt: skip
        largest = max([largest, *(abs(float(y[0])) for y in out.y_events[1])])
        t, sign, v = float(out.t[-1]), -sign, -RESTITUTION * float(out.y[1, -1])
        if v < slow and abs(np.interp(t, times, samples)) <= threshold:
            sign = 0
    return largest


def uplift(times: np.ndarray, samples: np.ndarray, start: float, threshold: float) -> tuple[float, int]:
    """Return when the ground next passes the threshold [s], and to which side the block lifts; 0 if it never does."""
    first = int(np.searchsorted(times, start, side="right"))
    later = np.flatnonzero(np.abs(samples[first:]) > threshold)
    if not later.size:
        return start, 0
    i = first + int(later[0])
    t0, a0 = max(start, times[i - 1]), float(np.interp(max(start, times[i - 1]), times, samples))
    level = np.copysign(threshold, samples[i])
    share = 0.0 if abs(a0) > threshold else (level - a0) / (samples[i] - a0)
    return float(t0 + share * (times[i] - t0)), -1 if samples[i] > 0 else 1


BATCH = 1000
"""Histories that are asked for at once, as the program is used: what prepares the call is shared."""
WAYS = (("", largest_by_scipy, METHODS), (", in one go", largest_in_one_go, METHODS[1:3]))


def table(equation: Equation, *, rounds: int, seconds: float, npts: int) -> Table:
    """Compare on 5 ms samples of a violent motion that does not overturn the block."""
    record = violent(npts)
    reference = largest_by_scipy(equation, record, TIGHTEST)
    setting = "1e-10" if equation == "exact" else "closed form"
    programs = [
        Program("this program", setting, partial(largest_by_us, equation, record, 1e-10)),
        Program("this program, one of 1,000", setting, partial(largest_by_us, equation, record, 1e-10, BATCH), BATCH),
    ]
    if equation == "exact":
        programs.append(Program("this program", "1e-6", partial(largest_by_us, equation, record, 1e-6)))
    programs += [
        Program(f"solve_ivp, {method}{how}", f"{tolerance:.0e}", partial(largest, equation, record, tolerance, method))
        for how, largest, settings in WAYS
        for method, tolerance in settings
    ]  # fmt: skip
    rows = measure(programs, partial(off, reference), rounds=rounds, seconds=seconds)
    return Table(
        f"A rocking history, {equation} equation",
        f"Largest rotation of a rectangular block under {npts:,} samples of 5 ms up to 1 g. The motion is linear "
        "between samples, so `solve_ivp` starts anew at each, or goes on over all with steps of 5 ms at most; its "
        "events are impact and peak. Reference: DOP853 at 3e-14, anew at each sample. Within 5 ms tolerances of 1e-6 "
        "and 1e-10 are met by the same step, so they cost and err alike.",
        ("error of the largest rotation",),
        rows,
        _growth(equation, npts=npts, rounds=rounds),
    )  # fmt: skip


def _growth(equation: Equation, *, npts: int, rounds: int) -> tuple[str, ...]:
    """Return the cost of a step, and its growth with the length and with the number of records."""
    once = 0.5 * violent(npts).acceleration
    motions = [make_record("again and again", np.tile(once, times), 0.005) for times in STRETCHES]
    if peaks([block()], motions[-1:], product(1, 1, 1.0), equation=equation).overturned[0]:
        raise RuntimeError("the block overturned: the time of a history that ends early says nothing of its length")
    lengths = [float(each.npts) for each in motions]
    ours = [least(partial(largest_by_us, equation, each, 1e-10, 100), rounds=rounds) / 100 for each in motions]
    theirs = duration(partial(largest_by_scipy, equation, motions[0], 1e-6), 1)
    many, counts = earthquakes(100), (1, 10, 100)
    runs = [
        least(partial(peaks, [block()], many[:n], product(1, n, 3.0), equation=equation, threads=1), rounds=rounds)
        for n in counts
    ]
    return (
        f"A step more of the record costs this program {1e9 * np.polyfit(lengths, ours, 1)[0]:.0f} ns, and DOP853 at "
        f"1e-6 {1e6 * theirs / lengths[0]:,.0f} µs; from {lengths[0]:,.0f} to {lengths[-1]:,.0f} samples the time of "
        f"this program grows to the power {order(lengths, ours):.2f}.",
        f"1, 10 and 100 records of {many[0].npts:,} samples take this program "
        + ", ".join(f"{1e3 * each:.3g}" for each in runs)
        + " ms.",
    )
