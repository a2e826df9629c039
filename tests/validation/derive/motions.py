"""Responses to motions given sample by sample: an oscillator and a block by DOP853."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from math import atan, hypot, pi, sin, sqrt

import numpy as np
from scipy.constants import g
from scipy.integrate import solve_ivp

from tests.validation.derive.rocking import rocked
from tests.validation.derive.yim import DURATION, SINES, STEP

PERIODS = (0.1, 0.3, 1.0, 2.0)


def samples(sines, step, duration):
    times = np.arange(round(duration / step) + 1) * step
    return times, sum(a * np.sin(2 * pi * f * times + phase) for a, f, phase in sines)


def response_spectrum():
    """Pseudo-acceleration of a 5 % oscillator at rest under straight lines between samples, then under none [g]."""
    times, ground = samples(SINES, STEP, DURATION)
    found = {}
    for T in PERIODS:
        w, state, largest = 2 * pi / T, [0.0, 0.0], 0.0
        spans = [(a, b, ground[k], ground[k + 1]) for k, (a, b) in enumerate(pairwise(times))]
        for start, end, first, last in [*spans, (times[-1], times[-1] + T, 0.0, 0.0)]:
            out = solve_ivp(
                lambda t, y, s=start, e=end, p=first, q=last, w=w:
                    [y[1], -(p + (q - p) * (t - s) / (e - s)) - 0.1 * w * y[1] - w * w * y[0]],
                (start, end), state, method="DOP853", rtol=1e-11, atol=1e-14, events=lambda t, y: y[1],
            )  # fmt: skip
            turns = out.y_events[0]
            largest = max(largest, abs(out.y[0]).max(), abs(turns[:, 0]).max() if turns.size else 0.0)
            state = out.y[:, -1]
        found[f"{T:g} s"] = largest * w * w / g
    return {"S_a by T": found}


RECORDED = {
    "first": ((3.0, 0.9, 0.3), (2.0, 2.1, 1.1), (1.2, 3.7, 0.2)),
    "second": ((2.4, 0.6, 1.3), (1.8, 1.9, 0.4), (1.5, 2.9, 2.2)),
    "third": ((3.4, 1.2, 2.1), (1.6, 2.5, 0.9), (0.9, 4.1, 1.7)),
}
RECORD_STEP, RECORD_DURATION, THICKNESS, HEIGHT = 0.05, 8.0, 1.5, 6.0


def printed_samples(name):
    """Samples of a record file, in g with seven digits."""
    _, ground = samples(RECORDED[name], RECORD_STEP, RECORD_DURATION)
    return [float(f"{value / g:.6E}") for value in ground]


@cache
def _rocked(name):
    times, _ = samples(RECORDED[name], RECORD_STEP, RECORD_DURATION)
    ground = np.array(printed_samples(name)) * g
    alpha, R = atan(THICKNESS / HEIGHT), hypot(THICKNESS, HEIGHT) / 2
    return rocked(
        lambda t: float(np.interp(t, times, ground)), times,
        p=sqrt(3 * g / (4 * R)), alpha=alpha, restitution=1 - 1.5 * sin(alpha) ** 2,
    )  # fmt: skip


def histories():
    """A block of 1.5 m by 6 m under three record files: largest |theta| / alpha."""
    found = {name: _rocked(name)[0] for name in RECORDED}
    assert not any(_rocked(name)[2] for name in RECORDED)
    return {"largest θ/α": found}


VALUES = {"oscillators/response_spectrum": response_spectrum, "yim_1980/records": histories}


FREQUENCY, SHARE, SCALE, TAIL = 3.0, 0.75, 0.5, 120
"""First mode [Hz], height of the block over h_e, factor on the first record, samples of rest at its end."""


def raised_samples():
    """Samples of the record file of the raised block, in g with seven digits."""
    _, ground = samples(RECORDED["first"], RECORD_STEP, RECORD_DURATION)
    return [*(float(f"{SCALE * value / g:.6E}") for value in ground), *[0.0] * TAIL]


def raised_history():
    """The block on a floor that moves by a_g + (h / h_e) u'', u of the 5 % first mode at f/1.15: both by DOP853."""
    ground = np.array(raised_samples()) * g
    times = np.arange(ground.size) * RECORD_STEP
    w = 2 * pi * FREQUENCY / 1.15  # the worst of f/1.15, f, 1.15 f
    pieces, state = [], [0.0, 0.0]
    for k, (start, end) in enumerate(pairwise(times)):
        rate = lambda t, y: [y[1], -float(np.interp(t, times, ground)) - 0.1 * w * y[1] - w * w * y[0]]  # noqa: E731
        out = solve_ivp(rate, (start, end), state, method="DOP853", rtol=1e-11, atol=1e-14, dense_output=True)
        pieces.append(out.sol)
        state = out.y[:, -1]
        assert k == len(pieces) - 1

    def floor(t: float) -> float:
        k = min(int(t / RECORD_STEP), len(pieces) - 1)
        u, v = pieces[k](min(max(t, times[k]), times[k + 1]))
        a = float(np.interp(t, times, ground))
        return a + SHARE * (-a - 0.1 * w * v - w * w * u)

    alpha, R = atan(THICKNESS / HEIGHT), hypot(THICKNESS, HEIGHT) / 2
    restitution = 1 - 1.5 * sin(alpha) ** 2
    ratio, _, lost = rocked(floor, times, p=sqrt(3 * g / (4 * R)), alpha=alpha, restitution=restitution, rtol=1e-9)
    assert not lost
    return {"largest θ/α": {"raised": ratio}}


VALUES["oscillators/raised_block"] = raised_history
