"""Sets of artificial records against the rules of EN 1998-1:2004, 3.2.3.1.2."""

import numpy as np
import pytest

from records.response import response_spectrum
from records.synthetic import artificial_records
from spectra.table import table_spectrum

GROUNDS = {"1-B": (1.2, 0.15, 0.5, 2.0), "1-D": (1.35, 0.2, 0.8, 2.0), "2-A": (1.0, 0.05, 0.25, 1.2)}


@pytest.mark.parametrize("ground", list(GROUNDS))
def test_a_set_of_three_meets_the_clause(ground: str) -> None:
    """(4)a at least 3; b mean zero-period ordinate >= a_g S; c no mean ordinate below 90 % of the spectrum."""
    S, T_B, T_C, T_D = GROUNDS[ground]
    a_g, T = 1.5, np.unique(np.concatenate([[0.0, T_B, T_C, T_D], np.linspace(0.0, 4.0, 161)]))
    falling = 2.5 * np.minimum(1.0, T_C / np.maximum(T, T_C)) * np.minimum(1.0, T_D / np.maximum(T, T_D))
    target = table_spectrum(T, a_g * S * np.where(T < T_B, 1.0 + 1.5 * T / T_B, falling))
    suite = artificial_records(target, count=3, seed=7)
    assert np.mean([record.pga for record in suite]) >= a_g * S * (1 - 1e-12)
    band = np.geomspace(0.05, 4.0, 500)
    mean = np.mean([response_spectrum(record, band) for record in suite], axis=0)
    assert np.min(mean / target.acceleration(band)) >= 0.90
