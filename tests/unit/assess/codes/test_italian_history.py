"""Time histories by the Italian codes: counts and means worked by hand on a slender block."""

from __future__ import annotations

import dataclasses
from functools import partial
from math import sin

import pytest
from scipy.constants import g

from assess.codes import dmi2008, ntc2018
from assess.codes.check import Reason
from assess.codes.context import Context
from assess.codes.histories import SuiteResponse
from assess.codes.italian_histories import required_pga
from assess.codes.italian_limit_states import ItalianOptions
from assess.codes.procedures import apply_procedure
from assess.oscillator import LocalLimit
from spectra.asce7 import design_spectrum
from tests.support.straight import ALPHA, D0, RADIUS, SLENDER, displacement

LEVEL = 0.2 * g
SEVEN = (0.1, 0.2, 0.3, 0.3, 0.4, 0.5, 0.6)


def context(*ratios, pga=LEVEL, levels=(LEVEL,), **more):
    """FC is 1, as crushing is modelled and the level of knowledge is LC3."""
    spectrum, known = design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=6.0), {"dmi2008": "LC3", "ntc2018": "LC3"}
    suites = (SuiteResponse(pga, ratios, "positive"),)
    return Context(spectrum, levels, 0.0, 0.0, None, suites=suites, crushing=True, knowledge=known, **more)


def one(*ratios, state="SLV", **more):
    (check,) = ntc2018.assess_history(SLENDER, context(*ratios, **more), options=ItalianOptions(limit_states=(state,)))
    return check


def test_mean_of_seven_in_displacement():
    check = one(*SEVEN)
    mean = sum(displacement(ratio) / D0 for ratio in SEVEN) / 7
    assert check.ratio == pytest.approx(mean / 0.4, rel=1e-9)
    assert check.capacity == pytest.approx(0.4 * RADIUS * sin(ALPHA), rel=1e-9)
    assert check.demand == pytest.approx(mean * RADIUS * sin(ALPHA), rel=1e-9)
    assert check.verdict == "pass"


def test_collapse_limit_state_allows_six_tenths():
    many = (0.55,) * 7
    assert one(*many).verdict == "fail"
    assert one(*many, state="SLC").verdict == "pass"
    assert one(*many, state="SLC").capacity == pytest.approx(0.6 * RADIUS * sin(ALPHA), rel=1e-9)


def test_fewer_than_seven_records_are_judged_by_the_largest():
    check = one(0.0, 0.0, 0.0, 0.0, 0.0, 0.45)
    assert check.verdict == "fail"
    assert check.ratio == pytest.approx(displacement(0.45) / D0 / 0.4, rel=1e-9)
    assert one(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.45).verdict == "pass"
    assert one(0.45, 0.45).verdict == "not-answered"


def test_record_that_comes_back_from_beyond_d0_fails():
    check = one(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.02)
    assert (check.verdict, check.branch) == ("fail", "positive")
    assert check.ratio > 1
    assert check.reason.key == Reason.RECORDS_BEYOND_COLLAPSE


def test_record_that_overturns_fails():
    check = one(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, None)
    assert (check.verdict, check.demand) == ("fail", None)


def test_confidence_factor_goes_with_the_motion():
    """At LC2 the suite of 1.2 times the PGA is judged, and the PGA at collapse is that of the scan over 1.2."""
    scan = tuple(
        SuiteResponse(pga * g, (ratio,) * 7, "positive") for pga, ratio in ((0.2, 0.1), (0.24, 0.3), (0.3, 0.5))
    )
    at = dataclasses.replace(context(*(0.1,) * 7), incremental=scan, extra_suites=scan[1:2])
    (plain,) = ntc2018.assess_history(SLENDER, at, options=ItalianOptions())
    (less,) = ntc2018.assess_history(
        SLENDER, dataclasses.replace(at, knowledge={"ntc2018": "LC2"}), options=ItalianOptions()
    )
    assert plain.ratio == pytest.approx(displacement(0.1) / D0 / 0.4, rel=1e-9)
    assert less.ratio == pytest.approx(displacement(0.3) / D0 / 0.4, rel=1e-9)
    assert plain.capacity_pga_g == pytest.approx(0.24, rel=1e-9)
    assert less.capacity_pga_g == pytest.approx(0.2, rel=1e-9)
    assert less.safety_index == pytest.approx(1.0, rel=1e-9)


def test_without_crushing_the_suite_of_1_35_times_the_pga_decides_whatever_the_level():
    beside = SuiteResponse(1.35 * LEVEL, (0.3,) * 7, "positive")
    at = dataclasses.replace(context(*(0.1,) * 7), crushing=False, extra_suites=(beside,))
    deciding, informing = ntc2018.assess_history(SLENDER, at, options=ItalianOptions(confidence_factor=1.0))
    assert (deciding.ratio, deciding.informs) == (pytest.approx(displacement(0.3) / D0 / 0.4, rel=1e-9), False)
    assert (informing.ratio, informing.informs) == (pytest.approx(displacement(0.1) / D0 / 0.4, rel=1e-9), True)


def test_mean_is_within_the_seat_or_the_break_where_these_come_before_the_share_of_d0():
    """A seat lost at a quarter of the rotation that overturns: each record is measured by the d_SLV of its branch."""
    seat = LocalLimit("seat", "beam", "positive", 0.25 * ALPHA)
    check = one(*SEVEN, limits=(seat,))
    mean = sum(displacement(ratio) / D0 for ratio in SEVEN) / 7
    assert check.capacity == pytest.approx(displacement(0.25), rel=1e-9)
    assert check.ratio == pytest.approx(mean / (displacement(0.25) / D0), rel=1e-9)
    assert (check.verdict, one(*SEVEN).verdict) == ("fail", "pass")
    other = dataclasses.replace(seat, branch="negative")
    assert one(*SEVEN, limits=(other,)).ratio == pytest.approx(mean / 0.4, rel=1e-9)


def test_a_suite_that_fails_beside_the_levels_ends_the_scan():
    """At FC 1.35 the suite of 0.27 g overturns a body that the scan leaves standing at 0.26 g and at 0.4 g."""
    scan = tuple(SuiteResponse(pga * g, (0.1,) * 7, "positive") for pga in (0.1, 0.2, 0.26, 0.4))
    scan = (*scan, SuiteResponse(0.5 * g, (None,) * 7, "positive"))
    beside = SuiteResponse(0.27 * g, (None, *(0.1,) * 6), "positive")
    at = dataclasses.replace(context(*(0.1,) * 7), incremental=scan, extra_suites=(beside,), crushing=False)
    (check,) = ntc2018.assess_history(SLENDER, at, options=ItalianOptions())
    assert check.verdict == "fail"
    assert check.capacity_pga_g == pytest.approx(0.26 / 1.35, rel=1e-9)
    assert check.safety_index < 1.0


def test_histories_of_the_ground_cannot_pass_a_mechanism_above_it():

    procedure = partial(ntc2018.assess_history, options=ItalianOptions())
    applied = partial(apply_procedure, "ntc2018-history", procedure)
    low = dataclasses.replace(context(*(0.1,) * 7), elevation=5.0)
    (check,) = applied(SLENDER, low)
    assert (check.verdict, check.reason.key) == ("not-answered", Reason.GROUND_MOTION)
    filtered = dataclasses.replace(low, histories_at="mechanism base", transfer="by a filter")
    assert applied(SLENDER, filtered)[0].verdict == "pass"
    assert applied(SLENDER, dataclasses.replace(context(*(0.9,) * 7), elevation=5.0))[0].verdict == "fail"


def test_edition_of_2008_has_one_limit_state_and_the_same_share():
    checks = dmi2008.assess_history(SLENDER, context(*SEVEN), options=ItalianOptions(limit_states=("SLD", "SLV")))
    assert [check.limit_state for check in checks] == ["SLV"]
    assert checks[0].ratio == pytest.approx(one(*SEVEN).ratio, rel=1e-12)


def test_suites_are_needed_at_the_action_of_each_state_times_fc():
    states, rule = ("SLD", "SLV", "SLC"), ntc2018.HISTORY_RULE
    given = {"rule": rule, "options": ItalianOptions(limit_states=states), "crushing": True}
    spectrum = context(0.0).spectrum
    best = required_pga((0.1, 0.2), None, spectrum, **given, knowledge={"ntc2018": "LC3"})
    assert best == (0.1, 0.2, 0.1, 0.2)
    needed = required_pga((0.1, 0.3), None, spectrum, **given, knowledge={"ntc2018": "LC2"})
    assert needed == pytest.approx((0.12, 0.36, 0.12, 0.36), rel=1e-12)
