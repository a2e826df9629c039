"""ASCE 43-05 A.1 by hand: mu_e = mu (1 - 0.4 A_v / g), c_s = 2 mu_e g, delta_s = c_s / (2 pi f_es)^2."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import sliding
from assess.codes.asce43_05 import Asce4305Options
from assess.codes.check import Reason
from assess.codes.context import Context
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Face
from assess.mechanisms.single_block import equivalent_block
from spectra.table import table_spectrum

BLOCK = equivalent_block("w", p=2.0, uplift=0.5, radius=2.0)
PERIOD = np.array([0.0, 0.1, 0.5, 4.0])
SPECTRUM = table_spectrum(PERIOD, np.array([0.4, 1.0, 1.0, 0.125]) * g)
ETA = (10.0 / 15.0) ** 0.5  # of tables, for 10 % damping: EN 1998-1, 3.2.2.2


def context(*, mu: float | None = 0.2, level: float = 0.4 * g, vertical: float = 0.0, face=(0.0, 1.0)) -> Context:
    faces = ((Face(normal=face, friction=mu, remedy="give materials.w.friction"),),) * 2
    return Context(SPECTRUM, (level,), vertical, 0.0, None, hinges=hinge_forces(replace(BLOCK, faces=faces)))


def answer(context: Context, allowable: float | None = None):
    (check,) = sliding.assess_sliding_distance(
        BLOCK.oscillator, context, options=Asce4305Options(allowable_sliding=allowable)
    )
    return check


def period_of(ordinate: float) -> float:
    """Where the falling line of the table, from 1 g at 0.5 s to 0.125 g at 4 s, has an ordinate [g]."""
    return 0.5 + (1.0 - ordinate) / (1.0 - 0.125) * 3.5


def test_best_estimate_by_hand() -> None:
    """mu = 0.2: c_s = 0.4 g, met by 0.4 / eta of the 5 % ordinates."""
    expected = 0.4 * g * (period_of(0.4 / ETA) / (2 * pi)) ** 2
    check = answer(context())
    assert check.demand == pytest.approx(expected, rel=1e-9)
    assert (check.quantity, check.unit) == ("sliding", "m")
    assert (check.verdict, check.reason.key) == ("not-answered", Reason.NO_ALLOWABLE_SLIDING)
    assert "not checked against the printed standard" in check.caveat


def test_vertical_motion_takes_friction_off() -> None:
    """A_v = 0.5 PGA = 0.2 g: mu_e = 0.2 (1 - 0.08) = 0.184."""
    expected = 0.368 * g * (period_of(0.368 / ETA) / (2 * pi)) ** 2
    check = answer(context(vertical=0.5))
    assert check.demand == pytest.approx(expected, rel=1e-9)
    assert {step.symbol: step.value for step in check.steps}["μ_e"] == pytest.approx(0.184, rel=1e-12)


def test_with_an_allowable_it_answers_and_the_pga_at_capacity_slides_just_that_far() -> None:
    check = answer(context(), 0.1)
    assert check.verdict == "fail"
    at_capacity = check.capacity_pga_g * g
    assert answer(context(level=at_capacity), 0.1).demand == pytest.approx(0.1, rel=1e-6)
    assert answer(context(level=0.999 * at_capacity), 0.1).verdict == "pass"


def test_a_spectrum_below_the_coefficient_slides_nothing() -> None:
    """c_s = 1 g, above eta times the plateau."""
    check = answer(context(mu=0.5), 0.1)
    assert (check.demand, check.verdict) == (0.0, "pass")
    assert check.reason.key == Reason.NO_SLIDING


@pytest.mark.parametrize(
    ("where", "verdict", "said"),
    [
        (context(mu=None), "not-answered", "friction at hinge A is not known; give materials.w.friction"),
        (context(face=(0.1, 0.995)), "not-applicable", "level base"),
        (
            replace(context(), actions=("tie 1",)),
            "not-applicable",
            "loaded by its weight alone, but tie 1 also acts on this one",
        ),
        (replace(context(), hinges=()), "not-answered", "an equivalent block has no geometry"),
        (context(mu=0.01), "not-answered", "does not fall below c_s before it ends"),
    ],
)
def test_what_it_is_not_for(where: Context, verdict: str, said: str) -> None:
    check = answer(where, 0.1)
    assert (check.verdict, check.demand) == (verdict, None)
    assert said in check.reason.text


def test_a_block_that_rocks_first_is_told() -> None:
    """mu = 0.56 is above tan 0.5, the multiplier; then A.1 leaves the rocking out."""
    assert [remark.key for remark in answer(context(mu=0.56, level=0.6 * g)).remarks] == ["rocks-before-sliding"]
    assert answer(context()).remarks == ()


def test_harder_shaking_than_the_spectrum_tells_of_fails_where_less_slides_too_far() -> None:
    """At 4 g the table ends before it falls to c_s; at 0.4 g a block slides beyond the allowable already."""
    weak, strong = (answer(context(level=level), 0.1) for level in (0.4 * g, 4.0 * g))
    assert (weak.verdict, strong.verdict, strong.demand) == ("fail", "fail", None)
    assert strong.capacity_pga_g == pytest.approx(weak.capacity_pga_g, rel=1e-12)
    assert strong.reason.key == Reason.SLIDING_BEYOND_BEFORE
    assert answer(context(level=4.0 * g)).verdict == "not-answered"
