"""The block that every program rocks, its motion, and what is compared of a history of its rotation."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from records.pulses import PULSE_SHAPES, pulse_record
from records.record import Record, make_record
from tools.benchmarks.bench_dynamics import ALPHA, P

RADIUS = 3 * g / (4 * P**2)  # m, from hinge to centroid
WIDTH, HEIGHT = 2 * RADIUS * math.sin(ALPHA), 2 * RADIUS * math.cos(ALPHA)  # m
DENSITY = 2000.0  # kg/m3
MASS = DENSITY * WIDTH * HEIGHT  # kg, 1 m deep
INERTIA = MASS * (WIDTH**2 + HEIGHT**2) / 12  # kg m2, about the centroid
RESTITUTION = 1 - 1.5 * math.sin(ALPHA) ** 2  # Housner 1963: angular momentum about the new hinge is kept
STEP, PERIOD, AMPLITUDE = 0.005, 0.73, 3.0 * g * math.tan(ALPHA)  # s, s, m/s2
LENGTH = 5.0  # s
SMALLEST = 0.02
"""Of the largest swing: smaller ones are rattling about rest."""


@dataclass(frozen=True)
class Ran:
    """Peaks of the rotation in their order [rad], without sign, and the steps that were taken; none if it stopped."""

    swings: tuple[float, ...]
    steps: int


def pulse() -> Record:
    """Return one cycle of a sine of three times what starts the block, and rest after it."""
    motion = pulse_record(PULSE_SHAPES["sine"], frequency=1 / PERIOD, amplitude=AMPLITUDE, dt=STEP).acceleration
    return make_record("sine", np.append(motion, np.zeros(round(LENGTH / STEP) + 1 - motion.size)), STEP)


def sampled(record: Record, step: float) -> np.ndarray:
    """Return the ground's acceleration at the steps of a program [m/s2]."""
    steps = round((record.npts - 1) * record.dt / step)
    return np.interp(np.arange(steps) * step, np.arange(record.npts) * record.dt, record.acceleration)


def swings(rotation: Iterable[float]) -> tuple[float, ...]:
    """Return the largest rotation between changes of sign [rad]; rattling about rest is no swing."""
    history = np.asarray(list(rotation))
    parts = np.split(history, np.flatnonzero(np.diff(np.sign(history))) + 1)
    peaks = np.array([np.abs(part).max() for part in parts if part.size])
    return tuple(peaks[peaks > SMALLEST * peaks.max()].tolist())
