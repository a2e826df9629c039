"""What Italian checks lack, which factor decides, and what a missing input would make of the answer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.check import Outcome, Reason
from assess.codes.context import Building, Context, SiteHazard
from assess.codes.italian_limit_states import ItalianOptions
from assess.codes.ntc2018_clauses import floor_demand, ultimate_modes
from assess.mechanisms.single_block import equivalent_block
from assess.oscillator import OpenSeat
from spectra import ntc
from spectra.table import table_spectrum
from tests.support.answered import checks_of, context_at, step_values

SPECTRA = {
    state: ntc.elastic_spectrum(ntc.Hazard(a_g * g, 2.4, 0.35), place=ntc.SoilAndTopography())
    for state, a_g in (("SLD", 0.02), ("SLV", 0.05), ("SLC", 0.06))
}
FLOOR = OpenSeat("floor", "positive", np.linspace(0.0, 0.3, 301), 6.0 * np.linspace(0.0, 0.3, 301))
PROCEDURES = ("ntc2018-linear", "ntc2018-nonlinear")


WALL = equivalent_block("w", p=1.6, uplift=0.2, radius=3.0).oscillator


def italian_checks(procedure="ntc2018-nonlinear", *, state="SLV", factor=None, spectrum=None, building=None, **more):
    used = spectrum or SPECTRA["SLV"]
    options = ItalianOptions(confidence_factor=factor, limit_states=(state,))
    return checks_of(procedure, WALL, context_at(used, (used.pga,), building=building, **more), options)


@pytest.mark.parametrize("level", [None, "LC1", "LC2", "LC3"])
@pytest.mark.parametrize("procedure", PROCEDURES)
def test_without_crushing_the_factor_is_that_of_lc1_whatever_the_level(procedure, level):
    (check,) = italian_checks(procedure, knowledge={} if level is None else {"ntc2018": level})
    assert (step_values(check)["FC"], check.verdict, check.informs) == (1.35, Outcome.PASS, False)


def test_a_lower_factor_is_shown_and_never_decides_and_a_larger_one_does():
    deciding, informing = italian_checks(factor=1.1)
    assert (step_values(deciding)["FC"], deciding.informs) == (1.35, False)
    assert (step_values(informing)["FC"], informing.informs) == (1.1, True)
    assert "lower-confidence-factor" in [each.key for each in informing.remarks]
    (larger,) = italian_checks(factor=1.5)
    assert (step_values(larger)["FC"], larger.informs) == (1.5, False)
    assert [step_values(each)["FC"] for each in italian_checks(factor=1.35)] == [1.35]


def test_crushing_without_a_level_is_not_answered_and_says_what_lc1_would():
    (check,) = italian_checks(crushing=True)
    assert (check.verdict, check.provisional) == (Outcome.NOT_ANSWERED, Outcome.PASS)
    assert (check.reason.key, check.reason.where) == (Reason.KNOWLEDGE_UNKNOWN, "procedures.ntc2018.knowledge_level")
    assert step_values(check)["FC"] == 1.35
    (known,) = italian_checks(crushing=True, knowledge={"ntc2018": "LC2"})
    assert (known.verdict, step_values(known)["FC"]) == (Outcome.PASS, 1.2)
    (other,) = italian_checks(crushing=True, knowledge={"dmi2008": "LC2"})
    assert other.verdict == Outcome.NOT_ANSWERED


def test_without_a_seat_slc_is_not_answered_and_slv_passes_on_that_condition():
    (slc,) = italian_checks(state="SLC", open_seats=(FLOOR,))
    assert (slc.verdict, slc.provisional, slc.reason.key) == (
        Outcome.NOT_ANSWERED,
        None,
        Reason.SEAT_UNKNOWN,
    )
    (slv,) = italian_checks(open_seats=(FLOOR,))
    assert slv.verdict == Outcome.PASS
    (condition,) = slv.conditions
    assert condition.key == "seats-hold"
    moved = condition.values["seats"].values["moved"].value
    assert moved == pytest.approx(6.0 * slv.capacity_rotation_ratio * WALL.branches[0].overturning, rel=1e-6)
    assert moved > 1.5 * slv.capacity  # 6 m up, where the centre of masses is 2.9 m up
    assert italian_checks()[0].conditions == ()


def test_everything_that_is_missing_is_said_at_once():
    (check,) = italian_checks(state="SLC", open_seats=(FLOOR,), crushing=True)
    told = {check.reason.key, *(each.key for each in check.remarks)}
    assert {Reason.KNOWLEDGE_UNKNOWN, Reason.SEAT_UNKNOWN} <= told


def test_a_single_spectrum_answers_for_the_limit_state_it_is_declared_for():
    assert italian_checks(limit_state="SLV")[0].verdict == Outcome.PASS
    (slc,) = italian_checks(state="SLC", limit_state="SLV")
    assert (slc.verdict, slc.provisional, slc.reason.key) == (
        Outcome.NOT_ANSWERED,
        None,
        Reason.OTHER_LIMIT_STATE,
    )
    (sld,) = italian_checks("ntc2018-linear", state="SLD", limit_state="SLV")  # a stronger action than its own
    assert (sld.verdict, sld.provisional) == (Outcome.NOT_ANSWERED, Outcome.PASS)
    assert italian_checks(state="SLC")[0].verdict == Outcome.PASS  # nobody says: the verdict asks for site.limit_state


def test_a_hazard_that_does_not_reach_a_limit_state_does_not_answer_it():
    short = SiteHazard({state: SPECTRA[state] for state in ("SLD", "SLV")}, (30.0, 475.0), (0.02 * g, 0.05 * g))
    (check,) = italian_checks(state="SLC", hazard=short)
    assert (check.verdict, check.provisional, check.reason.where) == (
        Outcome.NOT_ANSWERED,
        None,
        "site.spectrum.hazard",
    )


def test_each_limit_state_is_judged_at_its_own_action():
    hazard = SiteHazard(SPECTRA, (30.0, 475.0, 975.0), (0.02 * g, 0.05 * g, 0.06 * g))
    (sld,) = italian_checks("ntc2018-linear", state="SLD", hazard=hazard)
    assert sld.demand == pytest.approx(0.02 * g, rel=1e-12)
    assert sld.safety_index == pytest.approx(sld.capacity_pga_g / 0.02, rel=1e-12)
    assert italian_checks("ntc2018-linear", hazard=hazard)[0].demand == pytest.approx(0.05 * g / 2, rel=1e-12)


@pytest.mark.parametrize("procedure", PROCEDURES)
def test_a_table_that_ends_before_the_building_s_periods_answers_nothing(procedure):
    """T_1 0.9 s; softened up to 1.8 s, of which b = 1.1 times, 1.98 s, is asked."""
    house = Building(9.0, 3, 0.9, 0.05)
    for end, linear_answers, nonlinear_answers in ((0.8, False, False), (1.9, True, False), (9.0, True, True)):
        spectrum = table_spectrum([0.0, 0.1, 0.5, end], [0.05 * g, 0.1 * g, 0.1 * g, 0.01 * g])
        (check,) = italian_checks(procedure, spectrum=spectrum, building=house, elevation=9.0)
        answered = linear_answers if procedure == "ntc2018-linear" else nonlinear_answers
        assert (check.verdict != Outcome.NOT_ANSWERED) is answered
        assert answered or check.reason.key == Reason.SPECTRUM_TOO_SHORT


def test_above_the_ground_a_table_is_asked_for_its_largest_displacement_up_to_the_period():
    """A table with a resonance at 1.5 s, beyond T_1', where C7.2.5 keeps the floor above the ground."""
    spectrum = table_spectrum([0.0, 0.1, 1.3, 1.5, 1.7, 6.0], [g, 2 * g, g, 6 * g, 0.1 * g, 0.01 * g])
    context = Context(spectrum, (spectrum.pga,), 0.0, 1.0, Building(9.0, 3, 0.1, 0.05))
    table, read_at_T = (
        floor_demand(at, ultimate_modes(at, "SLV"), T0=0.0, T=3.0, damping=0.08)
        for at in (context, replace(context, spectrum=replace(spectrum, code="ntc2018")))
    )
    assert table.period == pytest.approx(1.5, abs=0.02)
    assert read_at_T.period == 3.0
    assert table.largest > 2 * read_at_T.largest
