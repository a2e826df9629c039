"""ASCE 43-05 above the ground: whether a check tells that its motion is the ground's, by where its input acts."""

from __future__ import annotations

import pytest
from scipy.constants import g

from assess.codes import asce43_05, sliding
from assess.codes.asce43_05 import Asce4305Options
from assess.codes.asce43_05_history import assess_history
from assess.codes.context import Context
from assess.codes.histories import SuiteResponse
from assess.mechanisms.single_block import equivalent_block
from spectra import ntc

SUITE = SuiteResponse(0.2 * g, (0.1, 0.2, 0.1, 0.3, 0.2), "positive")
SPECTRUM = ntc.elastic_spectrum(ntc.Hazard(0.25 * g, 2.4, 0.3), place=ntc.SoilAndTopography())


def checks(elevation: float, histories_at: str):
    wall = equivalent_block("w", p=1.8, uplift=0.15, radius=2.4).oscillator
    context = Context(SPECTRUM, (0.2 * g,), 0.0, elevation, None, (SUITE,), histories_at=histories_at)
    procedures = (asce43_05.assess_spectrum, assess_history, sliding.assess_sliding_distance)
    return [check for procedure in procedures for check in procedure(wall, context, options=Asce4305Options())]


@pytest.mark.parametrize(
    ("elevation", "histories_at", "told"),
    [
        (0.0, "ground", [False, False, False]),
        (4.77, "ground", [True, True, True]),
        (4.77, "mechanism base", [True, False, True]),
    ],
)
def test_the_remark_stands_where_the_motion_of_the_ground_judges_a_mechanism_at_height(elevation, histories_at, told):
    found = checks(elevation, histories_at)
    assert ["ground-motion" in [remark.key for remark in check.remarks] for check in found] == told
    assert [check.steps[0].symbol == "z" for check in found] == told
    assert [check.steps[0].value for check in found if check.steps[0].symbol == "z"] == [elevation] * sum(told)


def test_the_answer_is_that_of_the_ground():
    ground, above = checks(0.0, "ground"), checks(4.77, "ground")
    assert [(check.demand, check.verdict) for check in ground] == [(check.demand, check.verdict) for check in above]
