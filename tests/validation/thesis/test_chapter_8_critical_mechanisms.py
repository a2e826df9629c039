"""Thesis 8.3.1: the critical walls of Casa Grande over the frequency of one-sine pulses, from Tables 8.2 and 8.3.

Unscaled: W0a below 1.2 Hz, W6 above. Scaled (Table 8.3 by SRSS): W0a below 0.6 Hz, W6 from there to 3.0 Hz, W0b above.
The scaled lower change is met with the spectral acceleration of the pulse in 3.47 (0.64 Hz), not with the relative
acceleration as 3.47 is printed (1.1 Hz). The upper one is not: W6 stays critical up to 3.7 Hz, then comes W4, and W0b
only above 5.4 Hz. There all need pulses of 2.5 g or more, and at high frequencies the bounds go with lambda / p^2 over
the scale factor; lambda / p^2 of W4 and W0b is the same within the two digits of the table. Unscaled, W0a and W6 change
places for a moment about 3.1 Hz, where the impact branch of W6 ends.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.amplification import FirstMode, Srss, factor_3_47, factor_over_frequency
from assess.dynamics.critical import Band, critical
from assess.dynamics.envelope import envelope
from assess.mechanisms.oscillation import oscillator
from assess.project.build import build
from assess.project.schema import load
from records.pulses import SHAPES

PROJECT = Path(__file__).parents[3] / "assess" / "examples" / "projects" / "casa_grande_table" / "project.toml"
SCALED = {"W0b": (7.72, 4.73, 4.98), "W1": (6.22, 4.66, 3.11), "W4": (6.16, 4.20, 3.76), "W6": (2.50, 6.01, 4.77)}
SINE = SHAPES["sine"]
FREQUENCY = np.geomspace(0.2, 10.0, 80)


def bands(factor) -> list[tuple[str, float, float]]:
    study = build(load(PROJECT))
    names = [mechanism.name for mechanism in study.mechanisms]
    grid = np.array([0.0, 30.0 * g])
    bounds = [
        envelope(oscillator(m), SINE, FREQUENCY, grid, equation="linearised", factor=factor(m.name)).lower_bound
        for m in study.mechanisms
    ]
    found: tuple[Band, ...] = critical(FREQUENCY, np.array(bounds)).bands
    return [(names[band.mechanism], band.start, band.end) for band in found if band.mechanism is not None]


def scaled(of, name: str) -> np.ndarray:
    if name not in SCALED:
        return np.ones_like(FREQUENCY)
    frequency, effective, height = SCALED[name]
    return of(Srss(FirstMode(frequency, effective), height), FREQUENCY)


def test_unscaled() -> None:
    (first, _, change), (second, _, end), *_ = bands(lambda name: np.ones_like(FREQUENCY))
    assert (first, second) == ("W0a", "W6")
    assert change == pytest.approx(1.2, abs=0.06)
    assert end > 2.9


def test_scaled() -> None:
    (first, _, change), (second, _, end), *others = bands(partial(scaled, factor_over_frequency))
    assert (first, second) == ("W0a", "W6")
    assert change == pytest.approx(0.6, abs=0.06)
    assert end == pytest.approx(3.0, rel=0.25)
    assert others[-1][0] == "W0b"


def test_as_3_47_is_printed_the_change_is_elsewhere() -> None:
    _, change = bands(partial(scaled, factor_3_47))[0][1:]
    assert change > 1.0
