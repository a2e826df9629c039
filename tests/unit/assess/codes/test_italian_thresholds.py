"""Which actions are in which curve, and what ends the displacement capacity, worked by hand on a slender block.

On it lambda = tan(alpha - phi) and d = R (sin alpha - sin(alpha - phi)), so d0 = R sin alpha.
"""

from __future__ import annotations

from dataclasses import replace
from math import asin, pi, sin, sqrt, tan

import pytest
from scipy.constants import g

from assess.codes import dmi2008, ntc2018
from assess.codes.context import Context
from assess.codes.italian_limit_states import ItalianOptions
from assess.oscillator import LocalLimit
from spectra import ntc
from tests.support.answered import step_values
from tests.support.blocks import both, pulled, thrust
from tests.support.straight import ALPHA, D0, RADIUS, SLENDER, displacement

LC1 = 1.35
SPECTRUM = ntc.elastic_spectrum(ntc.Hazard(0.2 * g, 2.4, 0.35), place=ntc.SoilAndTopography("B"))


def moment(lam):
    """Restoring moment of a multiplier of the block at rest [N m]."""
    return lam * g * float(SLENDER.positive.excitation[0])


def check_of(procedure=ntc2018.assess_nonlinear, *, rocker=None, state="SLV", **more):
    context = Context(SPECTRUM, (SPECTRUM.pga,), 0.0, 0.0, None, **more)
    (check,) = procedure(rocker or SLENDER, context, options=ItalianOptions(limit_states=(state,)))
    return check


def ending(share, kind="break", branch="positive"):
    return LocalLimit(kind, "tie", branch, share * ALPHA)


def tied(lam, share):
    return both(pulled(SLENDER.positive, moment(lam), until=share * ALPHA), SLENDER)


def test_a_break_that_takes_more_than_half_of_the_largest_acceleration_limits_slv():
    """lambda 0.1 + 0.2 at rest, 0.08 after the break at 0.2 alpha: less than 0.15. a(d_SLV) still has the tie."""
    check = check_of(breaking=tied(0.2, 0.2), limits=(ending(0.2), ending(0.2, branch="negative")))
    assert check.capacity == pytest.approx(displacement(0.2), rel=1e-9)
    held = tan(0.8 * ALPHA) + moment(0.2) / (g * SLENDER.mass * RADIUS * sin(pi / 2 - 0.8 * ALPHA))
    assert step_values(check)["a(d_SLV)"] == pytest.approx(held * g / LC1, rel=1e-6)
    assert step_values(check)["λ / λ_max"] == pytest.approx(tan(0.8 * ALPHA) / (tan(ALPHA) + 0.2), rel=1e-6)


def test_a_smaller_loss_limits_nothing_and_the_curve_goes_on_without_the_tie():
    """lambda 0.1 + 0.05 at rest, 0.08 after the break: more than 0.075."""
    limits = (ending(0.2), ending(0.2, branch="negative"))
    check = check_of(breaking=tied(0.05, 0.2), limits=limits)
    plain = check_of()
    assert check.capacity == pytest.approx(0.4 * D0, rel=1e-9)
    assert step_values(check)["a(d_SLV)"] == pytest.approx(step_values(plain)["a(d_SLV)"], rel=1e-6)


def test_a_break_beyond_the_share_of_d0_limits_nothing():
    """Broken beyond d_SLV the tie is in a(d_SLV), and makes the period shorter."""
    limits = (ending(0.7), ending(0.7, branch="negative"))
    check, plain = check_of(breaking=tied(0.2, 0.7), limits=limits), check_of()
    assert check.capacity == plain.capacity
    assert step_values(check)["T_SLV"] < step_values(plain)["T_SLV"]


def test_slc_is_limited_by_a_seat_and_not_by_a_break():
    limits = (ending(0.2), ending(0.3, "seat"))
    check = check_of(state="SLC", breaking=tied(0.2, 0.2), limits=limits)
    assert check.capacity == pytest.approx(displacement(0.3), rel=1e-9)
    assert check.branch == "positive"
    T = 1.56 * pi * sqrt(check.capacity / step_values(check)["a(d_SLC)"])
    assert step_values(check)["T_SLC"] == pytest.approx(T, rel=1e-9)


def test_a_seat_limits_slv_of_either_edition_too():
    seats = (ending(0.1, "seat"), ending(0.1, "seat", "negative"))
    assert check_of(limits=seats).capacity == pytest.approx(displacement(0.1), rel=1e-9)
    assert check_of(dmi2008.assess_nonlinear, limits=seats).capacity == pytest.approx(displacement(0.1), rel=1e-9)


def test_an_inward_tie_and_an_outward_thrust_of_one_size_leave_d0_to_the_thrust():
    """Neither shown to last: sin(alpha - phi) = 0.04 R-wise, so d0 = R (sin alpha - 0.04).

    alpha0 is the block's in the linear check; no bound of the non-linear one, where it is 1 - 0.4 of that.
    """
    rocker, half = SLENDER, 0.4 * sin(ALPHA)
    driven = thrust(rocker.positive, half * g * rocker.mass * RADIUS)
    check = check_of(rocker=both(driven, rocker), starting=rocker)
    assert step_values(check)["d0*"] == pytest.approx(RADIUS * (sin(ALPHA) - half), rel=1e-6)
    assert driven.overturning == pytest.approx(ALPHA - asin(half), rel=1e-5)
    assert step_values(check)["α0"] == pytest.approx(0.6 * tan(ALPHA), rel=1e-9)
    first = check_of(ntc2018.assess_linear, rocker=both(driven, rocker), starting=rocker)
    assert step_values(first)["α0"] == pytest.approx(tan(ALPHA), rel=1e-9)
    assert step_values(check)["a(d_SLV)"] < 0.6 * tan(ALPHA) * g / LC1


def test_curves_are_paired_by_the_name_of_the_branch():
    """A tie on one side only: the mechanism without it is symmetric, and the other side is the worse."""
    rocker = SLENDER
    starting = replace(rocker, negative=pulled(rocker.positive, moment(0.2), until=10 * ALPHA))
    one_way = replace(rocker, positive=starting.negative, negative=rocker.positive)
    for state, worse in ((starting, "positive"), (one_way, "negative")):
        check = check_of(ntc2018.assess_linear, starting=state)
        assert check.branch == worse
        assert check.capacity == pytest.approx(tan(ALPHA) * g / LC1, rel=1e-9)
    limited = check_of(limits=(ending(0.1, "seat", "negative"),))
    assert (limited.branch, limited.capacity) == ("negative", pytest.approx(displacement(0.1), rel=1e-9))


def test_the_confidence_factor_divides_no_displacement():
    known = [check_of(crushing=True, knowledge={"ntc2018": level}) for level in ("LC1", "LC2", "LC3")]
    assert [check.capacity for check in known] == [known[0].capacity] * 3
    factors = [step_values(check)["a0*"] * FC for check, FC in zip(known, (1.35, 1.2, 1.0), strict=True)]
    assert factors == pytest.approx([tan(ALPHA) * g] * 3, rel=1e-9)
    assert [step_values(check)["FC"] for check in known] == [1.35, 1.2, 1.0]
