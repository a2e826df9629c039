"""Design spectra of ASCE 7 with published or hand-worked numbers; ordinates in g."""

import pytest
from scipy.constants import g

from spectra.asce7 import design_spectrum


@pytest.mark.parametrize(("period", "ordinate"), [(0.0, 0.4), (0.136, 1.0), (0.68, 1.0), (1.0, 0.68), (10.0, 0.0544)])
def test_site_class_d_of_a_high_hazard_site(period: float, ordinate: float) -> None:
    """S_S = 1.5, S_1 = 0.6, site class D, T_L = 8 s: S_DS = 1.0, S_D1 = 0.68 by ASCE 7-16 §11.4."""
    spectrum = design_spectrum(s_ds=1.0 * g, s_d1=0.68 * g, t_l=8.0)
    assert spectrum.acceleration(period) / g == pytest.approx(ordinate, rel=1e-12)


@pytest.mark.parametrize(("period", "ordinate"), [(0.0, 0.0667), (0.064, 0.1667), (0.32, 0.1667), (2.0, 0.0267)])
def test_casa_grande_by_ibc_2009(period: float, ordinate: float) -> None:
    """Table 8.4 of the thesis: S_S = 0.25, S_1 = 0.08, site class B, T_L = 6 s; tolerance: half its last digit."""
    spectrum = design_spectrum(s_ds=0.25 * g * 2 / 3, s_d1=0.08 * g * 2 / 3, t_l=6.0, code="ibc2009")
    assert spectrum.acceleration(period) / g == pytest.approx(ordinate, abs=5e-5)
    assert spectrum.parameters["t_0"] == pytest.approx(0.064, rel=1e-12)
    assert spectrum.parameters["t_s"] == pytest.approx(0.32, rel=1e-12)
