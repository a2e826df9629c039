"""Ground motions of noise, the same for the same number."""

from __future__ import annotations

import numpy as np

from records.record import Earthquake, Record, make_record


def motion(number: int) -> Record:
    """A motion of 10 s with the name and magnitude of its earthquake."""
    random = np.random.default_rng(number)
    wide = np.hanning(11 + 8 * number)
    shake = np.convolve(random.normal(0.0, 1.0, 500) * np.hanning(500), wide, mode="same")
    quake = Earthquake(time=f"198{number}-10-18", magnitude=6.0 + 0.2 * number)
    return make_record(
        "x", shake / wide.sum(), 0.02, event=f"Quake {number}", station="S", component="000", earthquake=quake
    )
