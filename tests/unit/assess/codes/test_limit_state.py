"""Limit states on their own spectra, safety index and return period."""

from __future__ import annotations

from math import exp, log

import pytest
from scipy.constants import g

from assess.codes import dmi2008, ntc2018
from assess.codes.context import Context, SiteHazard
from assess.codes.italian_limit_states import ItalianOptions, pga_ratio, return_period
from assess.mechanisms.single_block import equivalent_block
from spectra import ntc

ROWS = ((30, 0.08), (50, 0.10), (475, 0.25), (975, 0.33), (2475, 0.45))


def spectrum(a_g):
    return ntc.elastic_spectrum(ntc.Hazard(a_g * g, 2.4, 0.3), place=ntc.SoilAndTopography())


def site(*, levels=(0.25 * g,)):
    spectra = {"SLD": spectrum(0.10), "SLV": spectrum(0.25), "SLC": spectrum(0.33)}
    hazard = SiteHazard(spectra, tuple(float(years) for years, _ in ROWS), tuple(pga * g for _, pga in ROWS))
    return Context(spectra["SLV"], levels, 0.0, 0.0, None, hazard=hazard)


WALL = equivalent_block("w", p=1.8, uplift=0.15, radius=2.4).oscillator


def test_each_limit_state_has_its_own_pga_and_the_level_multiplies_all():
    damage, life = ntc2018.assess_linear(
        WALL, site(levels=(0.125 * g,)), options=ItalianOptions(limit_states=("SLD", "SLV"))
    )
    assert damage.level_pga_g == life.level_pga_g == pytest.approx(0.125, rel=1e-12)
    assert damage.demand == pytest.approx(0.05 * g, rel=1e-12)  # 0.10 g · 0.125 / 0.25
    assert life.demand == pytest.approx(0.125 / 2 * g, rel=1e-12)
    assert damage.safety_index == pytest.approx(damage.capacity_pga_g / 0.05, rel=1e-12)
    assert {damage.steps[0].symbol, life.steps[0].symbol} == {"PGA_SLD", "PGA_SLV"}


def test_without_hazard_every_limit_state_has_the_pga_of_the_level():
    alone = Context(spectrum(0.25), (0.2 * g,), 0.0, 0.0, None)
    assert pga_ratio(None, alone.spectrum, "SLD") == 1.0
    (damage,) = ntc2018.assess_linear(WALL, alone, options=ItalianOptions(limit_states=("SLD",)))
    assert damage.demand == pytest.approx(0.2 * g, rel=1e-12)
    assert damage.return_period_years is None
    assert "that of the level" in damage.steps[0].description


def test_return_period_is_linear_in_logarithms_between_rows():
    hazard = site().hazard
    halfway = exp((log(0.10) + log(0.25)) / 2) * g
    assert return_period(hazard, halfway) == (pytest.approx((50 * 475) ** 0.5, rel=1e-12), "")
    for years, pga in ROWS:
        assert return_period(hazard, pga * g) == (pytest.approx(years, rel=1e-9), "")


def test_return_period_beyond_the_hazard_is_a_bound():
    hazard = site().hazard
    assert return_period(hazard, 0.01 * g) == (30.0, "<=")
    assert return_period(hazard, 2.0 * g) == (2475.0, ">=")


def test_return_period_on_soft_soil_is_the_least():
    """S a_g may fall between two rows; the first crossing counts."""
    hazard = SiteHazard({}, (30.0, 100.0, 475.0, 2475.0), (1.0, 3.0, 2.5, 4.0))
    assert return_period(hazard, 2.8)[0] < 100.0
    assert 475.0 < return_period(hazard, 3.5)[0] < 2475.0


def test_clamped_return_period_is_said_so():
    stocky = equivalent_block("w", p=1.8, uplift=0.7, radius=2.4).oscillator
    (check,) = ntc2018.assess_linear(stocky, site(), options=ItalianOptions())
    assert (check.return_period_years, check.return_period_bound) == (2475.0, ">=")
    assert (check.steps[-1].value, check.steps[-1].bound) == (2475.0, ">=")
    assert check.steps[-1].remark == "or more: the hazard ends there"


def test_older_edition_is_rated_where_the_site_gives_its_hazard():
    (check,) = dmi2008.assess_linear(WALL, site(), options=ItalianOptions())
    assert check.safety_index == pytest.approx(1 / check.ratio, rel=1e-12)
    assert check.return_period_years is not None


def test_older_edition_has_an_index_on_a_single_spectrum_too():
    (check,) = dmi2008.assess_linear(
        WALL, Context(spectrum(0.25), (0.2 * g,), 0.0, 0.0, None), options=ItalianOptions()
    )
    assert check.safety_index == pytest.approx(1 / check.ratio, rel=1e-12)
    assert check.return_period_years is None
