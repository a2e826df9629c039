"""Site spectra of NZS 1170.5 against its Table 3.1 and numbers worked by hand; accelerations in g."""

import numpy as np
import pytest
from scipy.constants import g

from spectra.errors import SpectrumError
from spectra.nzs1170_5 import SUBSOILS, near_fault_factor, return_period_factor, site_spectrum, vertical_spectrum


def test_class_c_by_hand():
    """Z = 0.4, R = N = 1: C(0) = 0.532, C(0.2) = 1.172, C(1) = 0.4757, C(2) = 0.264, C(4) = 0.099."""
    spectrum = site_spectrum(subsoil="C", z=0.4, r=1.0)
    found = spectrum.acceleration([0.0, 0.05, 0.2, 1.0, 2.0, 4.0]) / g
    assert found == pytest.approx([0.532, 0.852, 1.172, 0.8 * 0.5**0.75, 0.264, 0.099], rel=1e-12)
    assert found[3] == pytest.approx(0.4757, abs=5e-5)


@pytest.mark.parametrize("subsoil", list(SUBSOILS))
def test_branches_meet_within_half_a_per_cent(subsoil):
    """As closely as the published formulas do."""
    spectrum = site_spectrum(subsoil=subsoil, z=0.3, r=1.0)
    for corner in (0.1, SUBSOILS[subsoil].plateau_end, 1.5, 3.0):
        below, above = spectrum.acceleration([corner * (1 - 1e-9), corner * (1 + 1e-9)], damping=0.1)
        assert below == pytest.approx(above, rel=5e-3)


def test_zr_is_taken_up_to_0_7():
    largest = site_spectrum(subsoil="B", z=0.6, r=1.8)
    assert largest.pga / g == pytest.approx(0.7, rel=1e-12)
    assert largest.parameters["zr"] == 0.7
    assert largest.parameters["c_0"] == pytest.approx(largest.pga / g, rel=1e-12)


def test_near_fault():
    """N_max(3 s) = 1.36: 1 + 0.36 x 15 / 18 = 1.30 at 5 km; nothing from 20 km on, or for 250 years and less."""
    near = site_spectrum(subsoil="C", z=0.3, r=1.0, near_fault_distance=5e3)
    far = site_spectrum(subsoil="C", z=0.3, r=1.0)
    ratio = near.acceleration([0.0, 1.5, 3.0, 5.0, 9.0]) / far.acceleration([0.0, 1.5, 3.0, 5.0, 9.0])
    assert ratio == pytest.approx([1.0, 1.0, 1.30, 1.60, 1.60], rel=1e-12)
    published = {0.0: 1.0, 1.5: 1.0, 2.0: 1.12, 3.0: 1.36, 4.0: 1.60, 5.0: 1.72, 8.0: 1.72}  # N_max(T), Table 3.7
    for distance, share in ((0.0, 1.0), (2e3, 1.0), (5e3, 15 / 18), (11e3, 0.5), (20e3, 0.0)):
        expected = [1.0 + share * (N_max - 1.0) for N_max in published.values()]
        assert near_fault_factor([*published], distance=distance, r=1.0) == pytest.approx(expected, rel=1e-12)
    assert near_fault_factor(2.5, distance=1e3, r=1.3) == pytest.approx(1.24, rel=1e-12)
    assert near_fault_factor(5.0, distance=20e3, r=1.3) == 1.0
    assert near_fault_factor(5.0, distance=0.0, r=0.75) == 1.0


@pytest.mark.parametrize(
    ("years", "r"),
    [
        (20, 0.20),
        (25, 0.25),
        (50, 0.35),
        (100, 0.5),
        (250, 0.75),
        (500, 1.0),
        (750, 1.15),
        (1000, 1.3),
        (2000, 1.7),
        (2500, 1.8),
    ],
)
def test_return_period_factors(years, r):
    assert return_period_factor(years) == pytest.approx(r, rel=1e-12)


@pytest.mark.parametrize("years", [19.0, 2501.0, float("nan")])
def test_return_periods_beyond_the_table_are_refused(years):
    with pytest.raises(SpectrumError, match=r"Table 3\.5"):
        return_period_factor(years)


def test_vertical_is_seven_tenths():
    given = {"subsoil": "D", "z": 0.2, "r": 1.0, "near_fault_distance": 4e3}
    T = np.linspace(0.0, 6.0, 50)
    expected = 0.7 * site_spectrum(**given).acceleration(T)
    np.testing.assert_allclose(vertical_spectrum(**given).acceleration(T), expected, rtol=1e-12)


def test_damping_by_the_rule_of_en_1998_1_is_told():
    spectrum = site_spectrum(subsoil="D", z=0.2, r=1.0)
    eta = (10 / 15) ** 0.5
    found = spectrum.acceleration([0.0, 0.1, 2.0], damping=0.10) / (0.2 * g)
    assert found == pytest.approx([1.12, 3.0 * eta, 1.07 * eta], rel=1e-12)
    assert "EN 1998-1" in spectrum.damping_rule


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"subsoil": "F"}, "subsoil = F; choose one of A, B, C, D, E"),
        ({"z": 0.0}, "z = 0.0"),
        ({"r": -1.0}, "r = -1.0"),
        ({"near_fault_distance": -1.0}, "near_fault_distance = -1.0 m"),
    ],
)
def test_what_the_clause_has_not_is_refused(change, words):
    with pytest.raises(SpectrumError, match=words):
        site_spectrum(**{"subsoil": "B", "z": 0.2, "r": 1.0, **change})
