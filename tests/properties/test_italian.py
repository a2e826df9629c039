"""What must hold for the Italian procedures whatever the wall."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.constants import g

from assess.codes import dmi2008, ntc2018
from assess.codes.context import Building, StatedFirstMode
from assess.codes.italian_limit_states import ItalianOptions
from assess.mechanisms.single_block import equivalent_block
from spectra import ntc
from tests.support.answered import context_at, ratio_of
from tests.support.blocks import both, pulled

SPECTRUM = ntc.elastic_spectrum(ntc.Hazard(0.25 * g, 2.4, 0.35), place=ntc.SoilAndTopography("C"))
HOUSE = Building(9.0, 3, 0.3, 0.05)
site = partial(context_at, SPECTRUM, levels=(0.25 * g,), building=HOUSE)
EVERY = pytest.mark.parametrize(
    "procedure", [ntc2018.assess_linear, ntc2018.assess_nonlinear, dmi2008.assess_linear, dmi2008.assess_nonlinear]
)
BY_DISPLACEMENT = pytest.mark.parametrize("procedure", [ntc2018.assess_nonlinear, dmi2008.assess_nonlinear])
SLENDER, RADIUS = st.floats(0.06, 0.5), st.floats(1.0, 4.0)


def wall(slender, radius):
    return equivalent_block("w", p=np.sqrt(0.75 * g / radius), uplift=slender, radius=radius).oscillator


@EVERY
@given(elevation=st.sampled_from([0.0, 4.0, 9.0]), slender=SLENDER, radius=RADIUS)
def test_a_lower_action_never_worsens(procedure, elevation, slender, radius):
    levels = tuple((np.geomspace(0.02, 1.5, 9) * g).tolist())
    checks = procedure(wall(slender, radius), site(elevation=elevation, levels=levels), options=ItalianOptions())
    assert [ratio_of(check) for check in checks] == sorted(ratio_of(check) for check in checks)
    for check in checks:
        assert (check.verdict == "pass") is (check.level_pga_g <= check.capacity_pga_g * (1 + 1e-9))


@EVERY
def test_a_larger_d0_at_the_ground_never_worsens(procedure):
    """Walls of one slenderness, larger and larger: periods beyond T_B, where S_e does not rise."""
    for slender in (0.06, 0.15, 0.3):
        ratios = [
            ratio_of(procedure(wall(slender, radius), site(), options=ItalianOptions())[0])
            for radius in np.geomspace(0.5, 12.0, 12)
        ]
        assert all(after <= before * (1 + 1e-9) for before, after in pairwise(ratios))


@BY_DISPLACEMENT
@given(slender=SLENDER, radius=RADIUS)
def test_a_tie_that_is_not_shown_to_last_never_changes_the_displacement_capacity(procedure, slender, radius):
    """It is in the curve of activation alone: d_SLV, a(d_SLV), T_SLV and the demand stay as they are."""
    rocker = wall(slender, radius)
    (plain,) = procedure(rocker, site(), options=ItalianOptions())
    for share in (0.01, 0.03, 0.3, 3.0):
        force = share * g * rocker.mass * radius
        starting = both(pulled(rocker.positive, force, until=1.4 * slender), rocker)
        (held,) = procedure(rocker, site(starting=starting), options=ItalianOptions())
        assert held.capacity == plain.capacity
        names = ("d0*", "a(d_SLV)", "T_SLV", "a_s*", "T_s")
        for one, other in zip(held.steps, plain.steps, strict=True):
            assert one.symbol not in names or one.value == other.value


@BY_DISPLACEMENT
@given(slender=SLENDER, radius=RADIUS)
def test_a_seat_never_raises_and_a_lower_factor_never_changes_what_decides(procedure, slender, radius):
    rocker = wall(slender, radius)
    (plain,) = procedure(rocker, site(), options=ItalianOptions())
    deciding, informing = procedure(rocker, site(), options=ItalianOptions(confidence_factor=1.0))
    assert replace(deciding) == plain
    assert informing.informs
    assert not deciding.informs


@given(slender=SLENDER, radius=RADIUS, T1=st.floats(0.15, 1.2))
def test_no_building_of_the_range_asks_more_than_the_range(slender, radius, T1):
    rocker, elevation = wall(slender, radius), 9.0
    ranged = site(elevation=elevation)
    at = replace(ranged, building=replace(HOUSE, period=T1), levels=(2.0 * g,))
    (whole,) = ntc2018.assess_nonlinear(rocker, at, options=ItalianOptions())
    for softening in np.linspace(1.5, 2.0, 6):
        mode = {"SLV": StatedFirstMode(softening * T1, 0.10, "one of them")}
        (one,) = ntc2018.assess_nonlinear(
            rocker, replace(at, building=replace(HOUSE, period=T1, limit_states=mode)), options=ItalianOptions()
        )
        assert one.ratio <= whole.ratio * (1 + 1e-5)
        assert one.capacity_pga_g >= whole.capacity_pga_g * (1 - 1e-5)
