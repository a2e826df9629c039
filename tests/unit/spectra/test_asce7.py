"""The two-corner spectrum: shape, hazard, damping, refusals. Published values are in tests/validation/asce7."""

import numpy as np
import pytest
from scipy.constants import g

from spectra.asce7 import EDITIONS, design_spectrum
from spectra.errors import SpectrumError
from spectra.spectrum import scale_to_pga

S_DS, S_D1, T_L = 1.0 * g, 0.68 * g, 8.0


def test_branches_meet_at_the_corners() -> None:
    spectrum = design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L)
    for corner in (0.136, 0.68, 8.0):
        below, above = spectrum.acceleration([corner * (1 - 1e-9), corner * (1 + 1e-9)], damping=0.2)
        assert below == pytest.approx(above, rel=1e-8)


def test_mce_is_one_and_a_half_times_design_at_every_period() -> None:
    T = np.linspace(0.0, 20.0, 500)
    design = design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L)
    mce = design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L, hazard="mce")
    np.testing.assert_allclose(mce.acceleration(T), 1.5 * design.acceleration(T), rtol=1e-14)
    assert (design.clause, mce.clause) == ("ASCE 7-16 §11.4.6", "ASCE 7-16 §11.4.7")


@pytest.mark.parametrize("code", list(EDITIONS))
def test_editions_share_the_shape_and_name_their_own_clauses(code: str) -> None:
    T = np.geomspace(0.01, 20.0, 50)
    here = design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L, code=code)
    np.testing.assert_array_equal(here.acceleration(T), design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L).acceleration(T))
    year = {"asce7-05": "7-05", "ibc2009": "IBC 2009", "asce7-10": "7-10", "asce7-16": "7-16"}[code]
    assert here.code == code
    assert year in here.clause
    assert "not checked against the printed standard" in here.damping_rule


@pytest.mark.parametrize(("damping", "b"), [(0.02, 0.8), (0.1, 1.2), (0.2, 1.5)])
def test_damping_divides_by_b_from_t_0_on_and_leaves_the_ground_alone(damping: float, b: float) -> None:
    spectrum = design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L)
    T = np.array([0.136, 0.3, 0.68, 1.0, 8.0, 10.0])
    np.testing.assert_allclose(spectrum.acceleration(T, damping=damping), spectrum.acceleration(T) / b, rtol=1e-12)
    assert spectrum.acceleration(0.0, damping=damping) == pytest.approx(spectrum.pga, rel=1e-14)
    halfway = 0.5 * (0.4 * S_DS + S_DS / b)
    assert spectrum.acceleration(0.068, damping=damping) == pytest.approx(halfway, rel=1e-12)


def test_scaling_to_a_pga_keeps_the_corners() -> None:
    spectrum = scale_to_pga(design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L), 0.1 * g)
    np.testing.assert_allclose(spectrum.acceleration([0.0, 0.4, 1.0]), [0.1 * g, 0.25 * g, 0.17 * g], rtol=1e-12)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"s_ds": 0.0}, "s_ds = 0.0"),
        ({"s_d1": -1.0}, "s_d1 = -1.0"),
        ({"t_l": float("nan")}, "t_l = nan"),
        ({"s_ds": float("inf")}, "s_ds = inf"),
        ({"t_l": 0.5}, "exceeds t_l"),
        ({"code": "asce7-22"}, "asce7-05, ibc2009, asce7-10, asce7-16"),
        ({"hazard": "rare"}, "design, mce"),
    ],
)
def test_values_outside_the_clause_are_refused(change: dict[str, object], words: str) -> None:
    given = {"s_ds": S_DS, "s_d1": S_D1, "t_l": T_L, **change}
    with pytest.raises(SpectrumError, match=words):
        design_spectrum(**given)


@pytest.mark.parametrize("period", [-0.1, float("nan")])
def test_impossible_periods_are_refused(period: float) -> None:
    with pytest.raises(SpectrumError, match="period"):
        design_spectrum(s_ds=S_DS, s_d1=S_D1, t_l=T_L).acceleration(period)
