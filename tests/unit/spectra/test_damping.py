"""Damping factors against the rows of their tables and the printed formula."""

import pytest

from spectra.damping import asce7_b_factor, ec8_eta
from spectra.errors import SpectrumError

TABLE_18_7_1 = [
    (0.02, 0.8),
    (0.05, 1.0),
    (0.10, 1.2),
    (0.20, 1.5),
    (0.30, 1.8),
    (0.40, 2.1),
    (0.50, 2.4),
    (0.60, 2.7),
    (0.70, 3.0),
    (0.80, 3.3),
    (0.90, 3.6),
    (1.00, 4.0),
]


@pytest.mark.parametrize(("damping", "factor"), TABLE_18_7_1)
def test_b_factor_has_the_rows_of_the_table(damping: float, factor: float) -> None:
    assert asce7_b_factor(damping) == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize(
    ("damping", "factor"), [(0.0, 0.8), (0.01, 0.8), (1.5, 4.0), (0.035, 0.9), (0.15, 1.35), (0.95, 3.8)]
)
def test_b_factor_is_linear_between_rows_and_held_beyond_them(damping: float, factor: float) -> None:
    assert asce7_b_factor(damping) == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize(
    ("damping", "eta"), [(0.05, 1.0), (0.0, 2.0**0.5), (0.20, 0.4**0.5), (0.29, 0.55), (0.9, 0.55)]
)
def test_eta_is_the_formula_down_to_its_floor(damping: float, eta: float) -> None:
    assert ec8_eta(damping) == pytest.approx(eta, rel=1e-12)


@pytest.mark.parametrize("rule", [asce7_b_factor, ec8_eta])
@pytest.mark.parametrize("damping", [-0.01, float("nan"), float("inf")])
def test_impossible_damping_is_refused(rule, damping: float) -> None:
    with pytest.raises(SpectrumError, match="damping ratio"):
        rule(damping)
