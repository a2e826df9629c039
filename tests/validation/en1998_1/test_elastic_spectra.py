"""Elastic spectra of EN 1998-1, worked by hand from the clauses; accelerations in g."""

from math import pi

import numpy as np
import pytest
from scipy.constants import g

from spectra.ec8 import GROUNDS, elastic_spectrum, vertical_spectrum
from spectra.errors import SpectrumError
from spectra.registry import spectrum

EVERY = [(kind, ground) for kind, grounds in GROUNDS.items() for ground in grounds]
B = elastic_spectrum(a_g=0.25 * g, ground_type="B")


def test_ten_per_cent_damping():
    """eta = sqrt(10/15) = 0.8165; the zero-period ordinate stays."""
    assert B.acceleration([0.0, 1.0], damping=0.10) / g == pytest.approx([0.3, 0.375 * (2 / 3) ** 0.5], rel=1e-12)
    assert B.acceleration(1.0, damping=0.5) / g == pytest.approx(0.375 * 0.55, rel=1e-12)


@pytest.mark.parametrize(
    ("kind", "t_b", "t_d"),
    # as in github.com/herrera-mauricio/SynthQuake, +functions/EspectroEuro8.m, but for its type 2, E
    [(1, (0.15, 0.15, 0.20, 0.20, 0.15), 2.0), (2, (0.05, 0.05, 0.10, 0.10, 0.05), 1.2)],
)
def test_ends_of_the_plateau_of_tables_3_2_and_3_3(kind, t_b, t_d):
    """Half-way up to T_B the ordinate is (1 + 2.5) / 2 of a S; it falls by 1 / T before T_D, by 1 / T² beyond."""
    for ground, corner in zip("ABCDE", t_b, strict=True):
        spectrum = elastic_spectrum(a_g=0.1 * g, ground_type=ground, spectrum_type=kind)
        half, constant = spectrum.acceleration([corner / 2, t_d])
        assert half == pytest.approx(1.75 * spectrum.pga, rel=1e-12)
        before, at, beyond = spectrum.acceleration([t_d / 1.2, t_d, t_d * 1.2])
        assert (before, beyond) == pytest.approx((1.2 * at, constant / 1.2**2), rel=1e-12)


@pytest.mark.parametrize(("kind", "ground"), EVERY)
@pytest.mark.parametrize("damping", [0.02, 0.05, 0.2])
def test_branches_meet(kind, ground, damping):
    spectrum, row = elastic_spectrum(a_g=1.0, ground_type=ground, spectrum_type=kind), GROUNDS[kind][ground]
    for corner in (row.t_b, row.t_c, row.t_d):
        below, above = spectrum.acceleration([corner * (1 - 1e-9), corner * (1 + 1e-9)], damping=damping)
        assert below == pytest.approx(above, rel=1e-7)


def test_importance_multiplies_the_reference_acceleration():
    important = elastic_spectrum(a_g=0.25 * g, ground_type="B", importance_factor=1.2)
    np.testing.assert_allclose(important.acceleration([0, 0.3, 3.0]), 1.2 * B.acceleration([0, 0.3, 3.0]), rtol=1e-14)
    assert important.parameters["design_a_g"] == pytest.approx(0.3 * g, rel=1e-14)


def test_displacements_follow_annex_a():
    """9.81 stands for g in the check values: d_g = 0.025 x 0.3 g x 0.5 x 2; S_De(7.5 s) = 1.75 d_g = 0.1288 m."""
    d_g = 0.025 * 0.3 * g
    assert B.displacement(1.0) == pytest.approx(0.375 * g / (4 * pi**2), rel=1e-12)
    assert B.displacement([7.5, 10.0, 20.0]) == pytest.approx([1.75 * d_g, d_g, d_g], rel=1e-12)
    assert B.displacement([7.5, 12.0]) == pytest.approx([0.1288, 0.0736], rel=1e-3)
    assert B.displacement(5.0) == pytest.approx(2.5 * d_g, rel=0.02)  # 0.025 stands for 1 / 4 pi^2
    assert B.displacement(7.5, damping=0.10) == pytest.approx((0.5 + 0.5 * 2.5 * (2 / 3) ** 0.5) * d_g, rel=1e-12)


def test_type_2_has_no_long_periods_in_annex_a():
    spectrum = elastic_spectrum(a_g=1.0, ground_type="A", spectrum_type=2)
    assert spectrum.displacement(8.0) == pytest.approx(2.5 * 0.25 * 1.2 / (4 * pi**2), rel=1e-12)


@pytest.mark.parametrize(("kind", "ratio"), [(1, 0.90), (2, 0.45)])
def test_vertical(kind, ratio):
    """Table 3.4, (3.8)-(3.11): 3.0 for 2.5, T_B = 0.05, T_C = 0.15, T_D = 1.0 s, no soil factor."""
    spectrum = vertical_spectrum(a_g=0.2 * g, ground_type="D", spectrum_type=kind)
    expected = [1.0, 2.0, 3.0, 3.0, 0.9, 0.45, 0.1125]
    found = spectrum.acceleration([0.0, 0.025, 0.05, 0.15, 0.5, 1.0, 2.0]) / g
    assert found == pytest.approx([0.2 * ratio * value for value in expected], rel=1e-12)


@pytest.mark.parametrize("ground", ["S1", "S2"])
def test_grounds_of_a_special_study_are_refused(ground):
    with pytest.raises(SpectrumError, match=r"3\.1\.2\(4\)P"):
        elastic_spectrum(a_g=1.0, ground_type=ground)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"a_g": 0.0}, "a_g = 0.0"),
        ({"importance_factor": float("nan")}, "importance_factor = nan"),
        ({"ground_type": "F"}, "ground_type = F; choose one of A, B, C, D, E"),
        ({"spectrum_type": 3}, "type = 3; write 1"),
    ],
)
@pytest.mark.parametrize("make", [elastic_spectrum, vertical_spectrum])
def test_what_the_tables_have_not_is_refused(make, change, words):
    with pytest.raises(SpectrumError, match=words):
        make(**{"a_g": 1.0, "ground_type": "A", **change})


def test_national_values_for_the_ground():
    """Ground B-R of the German annex of 2011 (from memory): S = 1.25, corners 0.05, 0.25, 2 s; worked by hand."""
    national = {"s": 1.25, "t_b": 0.05, "t_c": 0.25, "t_d": 2.0}
    found = spectrum("ec8", a_g=0.8, ground_type="B", **national)
    expected = [1.0, 1.0 + 0.4 * 1.5, 2.5, 2.5 * 0.25, 2.5 * 0.25 * 2.0 / 9.0]
    np.testing.assert_allclose(found.acceleration([0.0, 0.02, 0.2, 1.0, 3.0]), expected, rtol=1e-12)
    assert found.displacements is None
    with pytest.raises(SpectrumError, match="they must rise"):
        spectrum("ec8", a_g=0.8, ground_type="B", **{**national, "t_d": 0.2})
    with pytest.raises(SpectrumError, match="t_d: missing"):
        spectrum("ec8", a_g=0.8, ground_type="B", s=1.25, t_b=0.05, t_c=0.25)
