"""Candidates of suites made up of random spectra, about those of a target and smooth over the periods."""

from __future__ import annotations

from typing import Any

import numpy as np

from records.candidates import PERIODS, Candidate
from spectra.asce7 import design_spectrum

TARGET = design_spectrum(s_ds=5.0, s_d1=2.0, t_l=6.0)


def candidate(number: int, *, seed: int | None = None, digits: float = 0.0, **more: Any) -> Candidate:
    """Return a candidate of an earthquake of its own.

    Parameters
    ----------
    seed : of its spectrum, `number` if none is given
    digits : by how much of itself its spectrum is off that of the others of its number
    more : fields in place of those made up
    """
    rng = np.random.default_rng(number if seed is None else seed)
    smooth = np.interp(np.arange(PERIODS.size), np.linspace(0, PERIODS.size - 1, 9), rng.normal(0.0, 0.5, 9))
    spectrum = TARGET.acceleration(PERIODS) * np.exp(rng.normal(0.0, 1.0) + smooth)
    spectrum = spectrum * (1.0 + digits * np.cos(np.arange(PERIODS.size)))
    fields: dict[str, Any] = {
        "path": f"{number}.AT2",
        "position": 0,
        "id": str(number),
        "event": f"event {number}",
        "station": f"station {number}",
        "component": "000",
        "date": "",
        "place": "",
        "magnitude": 5.0 + number % 3,
        "distance": 1e4 * (number + 1),
        "vs30": None if number % 2 else 400.0,
        "nga": None,
        "dt": 0.01,
        "npts": 2000,
        "measures": {"pga": float(spectrum[0]), "d5_95": 10.0},
        "spectrum": spectrum,
    }
    return Candidate(**{**fields, **more})
