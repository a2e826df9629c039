"""A table sampled from the elastic spectrum of EN 1998-1 gives that spectrum back at other damping."""

import numpy as np
import pytest

from spectra.table import table_spectrum

A_G, S, T_B, T_C, T_D = 2.0, 1.2, 0.15, 0.5, 2.0  # type 1, ground B


def elastic(T: np.ndarray, eta: float) -> np.ndarray:
    """EN 1998-1:2004 eqs. (3.2)-(3.5)."""
    rising = 1.0 + T / T_B * (2.5 * eta - 1.0)
    falling = 2.5 * eta * np.minimum(1.0, T_C / np.maximum(T, T_C)) * np.minimum(1.0, T_D / np.maximum(T, T_D))
    return A_G * S * np.where(T < T_B, rising, falling)


@pytest.mark.parametrize("damping", [0.02, 0.05, 0.1, 0.2, 0.4])
def test_every_point_follows_the_code(damping: float) -> None:
    T = np.concatenate([np.linspace(0.0, T_B, 16), np.linspace(T_B, 4.0, 100)[1:]])
    eta = max((10.0 / (5.0 + 100.0 * damping)) ** 0.5, 0.55)
    spectrum = table_spectrum(T, elastic(T, 1.0))
    np.testing.assert_allclose(spectrum.acceleration(T, damping=damping), elastic(T, eta), rtol=1e-12)
