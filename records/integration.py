"""Velocity and displacement of the ground, exact for acceleration that is linear between samples."""

from __future__ import annotations

import numpy as np

from records.record import Record
from spectra.arrays import FloatArray


def velocity(record: Record) -> FloatArray:
    """Return the velocity of the ground at each sample [n] [m/s], from rest.

    As recorded: an offset of the baseline becomes a drift; correct the record first (records/processing.py).
    """
    a = record.acceleration
    return _cumulative_sum(0.5 * record.dt * (a[:-1] + a[1:]))


def displacement(record: Record) -> FloatArray:
    """Return the displacement of the ground at each sample [n] [m], from rest. As `velocity`."""
    a, v, h = record.acceleration, velocity(record), record.dt
    return _cumulative_sum(h * v[:-1] + h**2 / 6.0 * (2.0 * a[:-1] + a[1:]))


def largest_velocity(record: Record) -> float:
    """Return the largest |velocity| [m/s], at the samples or between two where the acceleration passes through zero."""
    a, b, v = record.acceleration[:-1], record.acceleration[1:], velocity(record)
    passes = a * b < 0.0
    until = record.dt * a[passes] / (a - b)[passes]
    return float(max(np.max(np.abs(v)), np.max(np.abs(v[:-1][passes] + 0.5 * a[passes] * until), initial=0.0)))


def largest_displacement(record: Record) -> float:
    """Return the largest |displacement| [m], at the samples or between, where v + a t + j t^2 / 2 is zero."""
    a, v, d = record.acceleration[:-1], velocity(record)[:-1], displacement(record)
    j = np.diff(record.acceleration) / record.dt
    with np.errstate(divide="ignore", invalid="ignore"):
        q = -(a + np.copysign(np.sqrt(a**2 - 2.0 * j * v), a))  # nan where the velocity is nowhere zero
        roots = np.array([q / j, 2.0 * v / q])
    t = np.where((roots > 0.0) & (roots < record.dt), roots, 0.0)
    return float(max(np.abs(d[-1]), np.max(np.abs(d[:-1] + t * (v + t * (a / 2.0 + t * j / 6.0))))))


def integrate_squared(record: Record) -> FloatArray:
    """Integrate the squared acceleration up to each sample [n] [m2/s3]."""
    a, b = record.acceleration[:-1], record.acceleration[1:]
    return _cumulative_sum(record.dt / 3.0 * (a**2 + a * b + b**2))


def integrate_absolute(record: Record) -> FloatArray:
    """Integrate the absolute acceleration up to each sample [n] [m/s]; a step that changes sign is two triangles."""
    a, b = record.acceleration[:-1], record.acceleration[1:]
    total = np.abs(a) + np.abs(b)
    crossing = (a**2 + b**2) / np.where(total > 0.0, total, 1.0)
    return _cumulative_sum(0.5 * record.dt * np.where(a * b < 0.0, crossing, total))


def _cumulative_sum(steps: FloatArray) -> FloatArray:
    """Return the running sum from 0, one longer than `steps`."""
    return np.concatenate(([0.0], np.cumsum(steps)))
