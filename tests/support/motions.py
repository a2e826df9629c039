"""Ground motions of tests: noise, the same for the same seed."""

from __future__ import annotations

import numpy as np

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
