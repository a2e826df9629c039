"""Elastic spectra and hazard of NTC 2008 and 2018, worked by hand from the formulas; accelerations in g."""

from dataclasses import replace
from math import exp, log, pi

import pytest
from scipy.constants import g

from spectra.errors import SpectrumError
from spectra.ntc import (
    CLAUSES,
    EXCEEDANCE,
    LARGEST_FACTORS,
    SOILS,
    Hazard,
    SoilAndTopography,
    elastic_spectrum,
    hazard_at,
    limit_state_hazard,
    reference_life,
    return_period,
    soil_factor,
    vertical_spectrum,
)

SITE = Hazard(0.261 * g, 2.364, 0.347)
TABLE = (
    Hazard(0.5, 2.4, 0.28, 30),
    Hazard(0.7, 2.35, 0.29, 50),
    Hazard(2.0, 2.4, 0.34, 475),
    Hazard(4, 2.5, 0.4, 2475),
)


@pytest.mark.parametrize("code", list(CLAUSES))
def test_the_clause_names_its_edition(code):
    assert code[-4:] in elastic_spectrum(SITE, place=SoilAndTopography("B"), code=code).clause


@pytest.mark.parametrize(
    ("soil", "weak", "strong"), [("B", 1.2, 1.0), ("C", 1.5, 1.0), ("D", 1.8, 0.9), ("E", 1.6, 1.0)]
)
def test_soil_factors_end_at_their_limits(soil, weak, strong):
    assert soil_factor(Hazard(0.05 * g, 2.4, 0.3), soil) == weak
    assert soil_factor(Hazard(0.7 * g, 2.4, 0.3), soil) == strong


@pytest.mark.parametrize("soil", list(SOILS))
@pytest.mark.parametrize("damping", [0.02, 0.05, 0.2])
def test_branches_meet(soil, damping):
    spectrum = elastic_spectrum(SITE, place=SoilAndTopography(soil))
    for name in ("t_b", "t_c", "t_d"):
        corner = spectrum.parameters[name]
        below, above = spectrum.acceleration([corner * (1 - 1e-9), corner * (1 + 1e-9)], damping=damping)
        assert below == pytest.approx(above, rel=1e-7)


def test_ten_per_cent_damping():
    spectrum = elastic_spectrum(SITE, place=SoilAndTopography("B"))
    assert spectrum.acceleration([0.0, 1.0], damping=0.10) / g == pytest.approx([0.3010, 0.3356 * 0.8165], abs=1e-4)


@pytest.mark.parametrize(("topography", "s_t"), list(LARGEST_FACTORS.items()))
def test_topography_at_the_top_and_half_way_up(topography, s_t):
    level = elastic_spectrum(SITE, place=SoilAndTopography("A")).pga
    assert elastic_spectrum(SITE, place=SoilAndTopography("A", topography)).pga == pytest.approx(s_t * level, rel=1e-12)
    half = elastic_spectrum(SITE, place=SoilAndTopography("A", topography, 0.5)).pga
    assert half == pytest.approx(0.5 * (1 + s_t) * level, rel=1e-12)


def test_displacements_of_long_periods():
    """Soil A: T_E = 4.5 s, T_F = 10 s; d_g = 0.025 a_g T_C T_D."""
    spectrum, d_g = elastic_spectrum(SITE, place=SoilAndTopography("A")), 0.025 * SITE.a_g * 0.347 * (4 * 0.261 + 1.6)
    assert spectrum.displacement([7.25, 10.0, 15.0]) == pytest.approx([d_g * (1 + 2.364) / 2, d_g, d_g], rel=1e-12)
    assert spectrum.displacement(1.0) == pytest.approx(float(spectrum.acceleration(1.0)) / (4 * pi**2), rel=1e-12)


def test_vertical():
    """F_V = 1.35 F_0 sqrt(a_g / g); a_g F_V from 0.05 to 0.15 s, a_g F_V / F_0 at T = 0."""
    spectrum, f_v = vertical_spectrum(SITE, place=SoilAndTopography("D")), 1.35 * 2.364 * 0.261**0.5
    plateau = 0.261 * f_v
    expected = [plateau / 2.364, plateau, plateau, plateau * 0.3, plateau * 0.15 / 4]
    assert spectrum.acceleration([0.0, 0.05, 0.15, 0.5, 2.0]) / g == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(("limit_state", "years"), [("SLO", 30.1), ("SLD", 50.3), ("SLV", 474.6), ("SLC", 974.8)])
def test_return_periods_of_an_ordinary_building(limit_state, years):
    """V_N = 50 years, class II; T_R = -V_R / ln(1 - P_VR)."""
    life = reference_life(50.0, use_class="II")
    assert return_period(limit_state, reference_life=life) == pytest.approx(years, abs=0.06)


@pytest.mark.parametrize(
    ("nominal", "use_class", "life"), [(50, "I", 35), (50, "III", 75), (100, "IV", 200), (10, "II", 35)]
)
def test_reference_lives(nominal, use_class, life):
    assert reference_life(nominal, use_class=use_class) == pytest.approx(life, rel=1e-12)


def test_return_periods_stay_within_the_hazard():
    assert return_period("SLO", reference_life=35.0) == 30.0
    assert return_period("SLC", reference_life=200.0) == 2475.0


def test_hazard_is_logarithmic_between_its_rows():
    share = log(100 / 50) / log(475 / 50)
    found = hazard_at(TABLE, return_period=100)
    assert found.a_g == pytest.approx(0.7 * (2.0 / 0.7) ** share, rel=1e-12)
    assert found.f_0 == pytest.approx(2.35 * exp(share * log(2.4 / 2.35)), rel=1e-12)
    assert found.t_c_star == pytest.approx(0.29 * (0.34 / 0.29) ** share, rel=1e-12)
    assert hazard_at(TABLE, return_period=475).a_g == pytest.approx(2.0, rel=1e-12)


def test_rarer_limit_states_have_more_acceleration():
    given = [limit_state_hazard(TABLE, limit_state=name, nominal_life=50, use_class="II") for name in EXCEEDANCE]
    accelerations = [hazard.a_g for hazard in given]
    assert accelerations == sorted(accelerations)
    assert accelerations[2] == pytest.approx(2.0, rel=1e-3)  # SLV: 474.6 years


@pytest.mark.parametrize(
    ("table", "years", "words"),
    [
        (TABLE[1:], 30.0, "30 years, is outside its rows, 50 to 2475"),
        (TABLE[::-1], 100.0, "do not rise"),
        ((), 100.0, "do not rise"),
        ((SITE,), 100.0, "do not rise"),
        ((TABLE[0], replace(TABLE[1], a_g=0.0)), 40.0, "must be positive"),
    ],
)
def test_hazards_that_do_not_reach_are_refused(table, years, words):
    with pytest.raises(SpectrumError, match=words):
        hazard_at(table, return_period=years)


@pytest.mark.parametrize(
    ("hazard", "place", "words"),
    [
        (replace(SITE, f_0=2.1), SoilAndTopography(), r"f_0 = 2\.1; .*3\.2\.3\.2 has at least 2\.2"),
        (replace(SITE, a_g=-1.0), SoilAndTopography(), "a_g = -1.0"),
        (SITE, SoilAndTopography("S2"), "special analysis"),
        (SITE, SoilAndTopography("F"), "soil = F; choose one of A, B, C, D, E"),
        (SITE, SoilAndTopography("A", "T5"), "topography = T5; choose one of T1, T2, T3, T4"),
        (SITE, SoilAndTopography("A", "T2", 1.1), "relief_position = 1.1"),
    ],
)
@pytest.mark.parametrize("make", [elastic_spectrum, vertical_spectrum])
def test_what_the_tables_have_not_is_refused(make, hazard, place, words):
    with pytest.raises(SpectrumError, match=words):
        make(hazard, place=place)


def test_unknown_names_list_the_known():
    with pytest.raises(SpectrumError, match="SLO, SLD, SLV, SLC"):
        return_period("ULS", reference_life=50.0)
    with pytest.raises(SpectrumError, match="I, II, III, IV"):
        reference_life(50.0, use_class="2")
    with pytest.raises(SpectrumError, match="ntc2008, ntc2018"):
        elastic_spectrum(SITE, place=SoilAndTopography(), code="ntc2030")
