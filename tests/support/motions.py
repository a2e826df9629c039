"""Ground motions of tests: noise, the same for the same seed."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from records.pulses import PulseShape
from records.record import Record, make_record


def noise(
    seed: int = 1, *, peak: float = 4.0, npts: int = 600, dt: float = 0.02, smooth: int = 15, bell: float = 0.0
) -> Record:
    """Return smoothed white noise.

    Parameters
    ----------
    peak : largest acceleration [m/s2]; npts : samples; dt : time step [s]
    smooth : samples of the Hann window that it is smoothed by
    bell : power of the half sine that shapes it; 0 leaves it stationary
    """
    raw = np.convolve(np.random.default_rng(seed).standard_normal(npts + smooth - 1), np.hanning(smooth), mode="valid")
    if bell:
        raw = raw * np.sin(np.linspace(0.0, np.pi, npts)) ** bell
    return make_record(f"noise {seed}", peak * raw / np.abs(raw).max(), dt)


def white_noise(seed: int = 5, *, npts: int = 400, dt: float = 0.01) -> Record:
    """Return white noise of variance 1 (m/s2)2."""
    return make_record("noise", np.random.default_rng(seed).normal(size=npts), dt)


def sine(amplitude: float, frequency: float, *, cycles: float = 1.0, samples: int = 100) -> Record:
    """Return a sine that first pushes a block on [m/s2, Hz], with so many samples to a cycle."""
    phase = np.arange(round(cycles * samples) + 1) / samples
    return make_record("sine", -amplitude * np.sin(2 * np.pi * phase), 1.0 / (samples * frequency))


def write_noise(file: Path, *, duration: float = 12.0, seed: int = 3, amplitude: float = 1.0) -> None:
    """Write smoothed white noise under a half sine, of a duration [s] at 100 Hz, as a CSV record."""
    t = np.arange(0.0, duration, 0.01)
    noise = np.random.default_rng(seed).normal(size=t.size)
    smooth = np.convolve(noise, np.hanning(15), mode="same") * np.sin(np.pi * t / duration)
    write_record(file, t, amplitude * smooth)


def write_record(file: Path, time: np.ndarray, acceleration: np.ndarray) -> None:
    """Write a CSV record of samples at so many seconds, of an acceleration [m/s2]."""
    rows = "\n".join(f"{x:.6g},{y:.6f}" for x, y in zip(time, acceleration, strict=True))
    file.write_text(f"time [s],acceleration [m/s2]\n{rows}\n")


def pulse_id(pulse: PulseShape) -> str:
    """Return the id of a test of a pulse shape."""
    return pulse.name if pulse.gamma is None else f"{pulse.name}-{pulse.gamma}-{pulse.nu}"
