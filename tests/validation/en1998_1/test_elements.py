"""EN 1998-1, 4.3.5: alpha S = 0.3 (0.25 g on ground B) at heights and periods worked by hand; a parapet on a roof."""

from __future__ import annotations

import dataclasses
from functools import partial

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.check import Reason
from assess.codes.context import Building, Wall
from assess.codes.en1998_1 import EC8_ELEMENT, TIED, Ec8Options, amplification, assess_element, joint_period
from assess.mechanisms.single_block import equivalent_block
from spectra.asce7 import design_spectrum
from spectra.ec8 import elastic_spectrum
from spectra.table import table_spectrum
from tests.support.answered import checks_of, context_at, step_values

SPECTRUM = elastic_spectrum(a_g=0.25 * g, ground_type="B")
HOUSE = Building(height=10.0, storeys=3, period=0.4, damping=0.05)
PARAPET = equivalent_block("parapet", p=3.0, uplift=0.2, radius=0.8).oscillator  # lambda = tan 0.2 = 0.20271

parapet_checks = partial(checks_of, EC8_ELEMENT.name, PARAPET)
at_height = partial(context_at, SPECTRUM, (0.3 * g,), building=HOUSE)


@pytest.mark.parametrize(
    ("height", "ratio", "coefficient"), [(0.0, 0.0, 0.300), (5.0, 0.5, 0.930), (10.0, 1.0, 1.650), (10.0, 0.0, 0.750)]
)
def test_seismic_coefficient(height, ratio, coefficient) -> None:
    assert 0.3 * amplification(ratio, at_height(height)) == pytest.approx(coefficient, rel=1e-12)


def test_a_parapet_on_the_roof() -> None:
    """T_a up to 6.2 x 1 / 0.3 sqrt(2200 / 0.15e9) = 0.07915 s, T_a/T_1 = 0.19787.

    S_a = 0.3 (6 / 1.64342 - 0.5) = 0.94528.
    F_a / W_a = 0.94528 x 1.5 / 1 = 1.41793 beside lambda = 0.20271: D/C 6.9949; PGA at capacity 0.3 / 6.9949 g.
    """
    standing = at_height(10.0, wall=Wall(1.0, 0.3))
    (check,) = assess_element(PARAPET, standing, options=Ec8Options(importance_factor=1.5))
    assert (check.demand, check.capacity) == pytest.approx((1.41793, 0.20271), rel=1e-4)
    assert check.ratio == pytest.approx(6.9949, rel=1e-4)
    assert check.capacity_pga_g == pytest.approx(0.3 / 6.9949, rel=1e-4)
    assert check.uplift_pga_g == pytest.approx(0.20271 / 3.15095, rel=1e-4)
    assert step_values(check)["S_a(0)"] == pytest.approx(0.3 * 2.5, rel=1e-12)
    assert (check.verdict, check.reading, check.input_at) == ("fail", "letter", "mechanism base")


def test_a_gable_that_a_tie_holds_has_twice_the_behaviour_factor_in_that_direction() -> None:
    """The parapet above, tied: F_a / W_a = 0.94528 / 2 = 0.47264 forwards; 0.94528 backwards, as the tie is slack."""
    tied = at_height(10.0, wall=Wall(1.0, 0.3), held={"positive": 0.5})
    forwards = dataclasses.replace(PARAPET, negative=None)
    (held,) = assess_element(forwards, tied, options=Ec8Options())
    assert held.demand == pytest.approx(0.47264, rel=1e-4)
    assert step_values(held)["q_a"] == 2.0
    assert next(step.remark for step in held.steps if step.symbol == "q_a") == TIED
    (weak,) = assess_element(forwards, dataclasses.replace(tied, held={"positive": 0.47}), options=Ec8Options())
    assert weak.demand == pytest.approx(0.94528, rel=1e-4)  # the ties resist less than what would remain
    apart = dataclasses.replace(PARAPET, negative=dataclasses.replace(PARAPET.positive))
    (both,) = assess_element(apart, tied, options=Ec8Options())
    assert (both.branch, both.demand) == ("negative", pytest.approx(0.94528, rel=1e-4))
    ways = dataclasses.replace(tied, held={"positive": 0.5, "negative": 0.5})
    (braced,) = assess_element(PARAPET, ways, options=Ec8Options())
    assert braced.demand == pytest.approx(0.47264, rel=1e-4)


def test_a_wall_between_floors_at_the_mean_of_its_supports() -> None:
    """From 2 to 4 m of 10 m: z/H = 0.3; T_a up to 2.2 x 4 / 0.3 x 0.0038297 = 0.11234 s, T_a/T_1 = 0.28084; q_a = 2.

    S_a = 0.3 (3.9 / 1.51719 - 0.5) = 0.62117.
    """
    spanning = at_height(2.0, support="spanning", wall=Wall(2.0, 0.3), rise=2.0)
    (check,) = assess_element(PARAPET, spanning, options=Ec8Options())
    assert check.demand == pytest.approx(0.310583, rel=1e-5)
    (own,) = assess_element(PARAPET, spanning, options=Ec8Options(behaviour_factor=1.0))
    assert own.demand == pytest.approx(0.621166, rel=1e-5)


def soft():
    """The parapet on joints that answer at once: its restoring moment rises from zero within 0.05 rad."""
    plain = PARAPET.positive
    risen = plain.restoring * (1.0 - np.exp(-plain.rotation / 0.05))
    bent = dataclasses.replace(plain, restoring=risen, overturning_flexible=plain.overturning)
    return dataclasses.replace(PARAPET, positive=bent, negative=None)


def test_an_element_that_vibrates_has_its_own_period() -> None:
    """T_a = T_1 / 4 on the roof: 3 x 2 / (1 + 0.75^2) - 0.5 = 3.34; unknown building or size: resonance, 2.5 at z = 0.

    T_a = 2 pi sqrt(I / k), k = restoring(0) / 0.05 of the rigid one; a wall that is so low hardly bends.
    """
    branch = soft().positive
    stiffness = PARAPET.positive.restoring[0] / 0.05
    by_hand = 2 * np.pi * np.sqrt(branch.inertia[0] / stiffness)
    assert joint_period(branch) == pytest.approx(by_hand, rel=1e-4)
    house = dataclasses.replace(HOUSE, period=4.0 * joint_period(branch))
    low = Wall(0.05, 1.0)
    (check,) = assess_element(soft(), at_height(10.0, building=house, wall=low), options=Ec8Options())
    assert check.demand == pytest.approx(0.3 * 3.34, rel=1e-6)
    assert check.uplift_pga_g is None
    for lacking in ({"building": None, "wall": low}, {"building": house}):
        (unknown,) = assess_element(soft(), at_height(0.0, **lacking), options=Ec8Options())
        assert unknown.demand == pytest.approx(0.3 * 2.5, rel=1e-12)


def test_above_ground_without_a_building_it_can_fail_but_not_pass() -> None:
    for level, verdict in ((0.05 * g, "not-answered"), (0.3 * g, "fail")):
        (check,) = parapet_checks(dataclasses.replace(at_height(5.0, building=None), levels=(level,)))
        assert check.verdict == verdict
    (above,) = parapet_checks(dataclasses.replace(at_height(11.0), levels=(0.01 * g,)))
    assert (above.verdict, above.reason.key) == ("not-answered", Reason.ABOVE_BUILDING)


def test_on_a_spectrum_of_another_family_it_says_so() -> None:
    american = dataclasses.replace(at_height(), spectrum=design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=6.0))
    (check,) = assess_element(PARAPET, american, options=Ec8Options())
    assert "one of asce7-16" in check.caveat


def test_a_wall_that_carries_floors_has_no_accepted_method() -> None:
    (check,) = parapet_checks(dataclasses.replace(at_height(10.0), levels=(0.01 * g,), carries_floors=True))
    assert (check.verdict, check.reason.key) == ("not-answered", Reason.CARRIES_FLOORS)
    (light,) = parapet_checks(dataclasses.replace(at_height(10.0), levels=(0.01 * g,)))
    assert light.verdict == "pass"


def test_on_a_table_alpha_s_has_to_be_given_by_name() -> None:
    """A table that begins at 0.24 g: with alpha S = 0.3 g the answer is that of the spectrum that begins with it."""
    table = table_spectrum(np.array([0.0, 0.15, 0.5]), np.array([0.24, 0.75, 0.75]) * g)
    on_table = dataclasses.replace(at_height(10.0), spectrum=table, levels=(0.24 * g,))
    (silent,) = assess_element(PARAPET, on_table, options=Ec8Options())
    assert (silent.verdict, silent.reason.key) == ("not-answered", Reason.NOT_BY_NAME)
    (named,) = assess_element(PARAPET, on_table, options=Ec8Options(alpha_s=0.3 * g))
    (code,) = assess_element(PARAPET, at_height(10.0), options=Ec8Options())
    assert (named.ratio, named.verdict) == (pytest.approx(code.ratio, rel=1e-12), code.verdict)
    assert named.capacity_pga_g == pytest.approx(0.8 * code.capacity_pga_g, rel=1e-12)
