"""Recommendations come from the results: factors, missing inputs, sensitivity, the list of possible mechanisms."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from assess.codes.check import Outcome
from assess.codes.verdict import Decision
from assess.messages.message import Quantity
from assess.results import ChecklistItem, ReportMatter, Results, SensitivityResult
from reports.chapters import recommendations
from tests.support.letters import letters, table_of, text_of
from tests.support.sample_results import with_verdict

JudgedAt = Callable[[Results, float], Results]
THICKNESS = SensitivityResult(
    mechanism="parapet",
    parameter="thickness",
    remark="",
    unit="m",
    base=0.6,
    low=0.55,
    high=0.65,
    quantity="index",
    at_base=0.9,
    at_low=0.7,
    at_high=1.05,
    verdict_base=Outcome.FAIL,
    verdict_low=Outcome.FAIL,
    verdict_high=Outcome.PASS,
    role="deciding",
    index="zeta_E",
)


def values(cells: tuple[object, ...]) -> tuple[object, ...]:
    """The numbers of cells."""
    return tuple(cell.value if isinstance(cell, Quantity) else cell for cell in cells)


def test_mechanisms_that_fail_have_the_factor_they_lack_the_worst_first(results: Results) -> None:
    assert results.verdict is not None
    margins = {"wall-6": 0.8, "parapet": 0.5}
    failing = tuple(
        replace(
            one,
            outcome=Decision.FAIL,
            margin=margins[one.mechanism],
            answers=tuple(replace(each, outcome=Decision.FAIL, index=None) for each in one.answers),
        )
        for one in results.verdict.mechanisms
    )
    made = with_verdict(results, mechanisms=failing, outcome=Decision.FAIL)
    worst, other = table_of(recommendations.sections(made), "lacking").rows
    assert [letters(row[0]) for row in (worst, other)] == ["M2 parapet", "M1 Wall 6, eroded base"]  # type: ignore[arg-type]
    assert values(worst[1:]) == pytest.approx((0.5 * 0.067, 0.067, 2.0))
    assert values(other[1:]) == pytest.approx((0.8 * 0.067, 0.067, 1.25))
    assert "requires strengthening" not in text_of(recommendations.sections(made))


def test_a_factor_that_is_not_known_is_left_out(results: Results, judged_at: JudgedAt) -> None:
    """The body overturns: neither a ratio nor a margin below one tells what it lacks."""
    ((_, held, reached, factor),) = table_of(recommendations.sections(judged_at(results, 0.45)), "lacking").rows
    assert held is not None
    assert (reached, factor) == (None, None)


def test_a_pass_requires_no_strengthening(results: Results) -> None:
    assert "no mechanism examined requires strengthening" in text_of(recommendations.sections(results))


def test_a_value_that_changes_the_answer_is_surveyed_first(results: Results) -> None:
    told = text_of(recommendations.sections(replace(results, sensitivity=(THICKNESS,))))
    assert "thickness of M2 parapet, which changes the answer: ζ_E is 0.7 at 0.55 m and 1.05 at 0.65 m" in told
    assert "sensitivity = true" not in told


def test_a_value_that_changes_nothing_is_named_as_the_strongest(results: Results) -> None:
    stays = replace(THICKNESS, verdict_high=Outcome.FAIL, at_high=0.95)
    weaker = replace(stays, parameter="density", at_low=0.88, at_high=0.92)
    told = text_of(recommendations.sections(replace(results, sensitivity=(weaker, stays))))
    assert "thickness of M2, which moves the deciding answer most" in told
    assert "density" not in told


def test_scatter_is_no_reason_to_survey(results: Results) -> None:
    flat = replace(THICKNESS, at_low=0.9001, at_high=0.8999, verdict_high=Outcome.FAIL)
    assert "thickness" not in text_of(recommendations.sections(replace(results, sensitivity=(flat,))))


def test_without_a_study_what_to_survey_is_not_known(results: Results) -> None:
    told = text_of(recommendations.sections(results))
    assert "which a sensitivity study would show: none was made" in told
    assert "[analysis]" not in told


def test_what_lies_at_the_limit_is_surveyed(results: Results) -> None:
    assert results.verdict is not None
    near = tuple(replace(one, at_the_limit=one.mechanism == "parapet") for one in results.verdict.mechanisms)
    told = text_of(recommendations.sections(with_verdict(results, mechanisms=near)))
    assert "thickness and position of the hinges of M2: the answer is at the limit" in told


def test_what_was_not_examined_comes_next(results: Results) -> None:
    items = (
        ChecklistItem("gable", None, "not-examined", spoken_for=False),
        ChecklistItem("in-plane", None, "not-examined", spoken_for=False),
        ChecklistItem("corner", None, "absent"),
    )
    told = text_of(
        recommendations.sections(replace(results, report=ReportMatter(building_type="house", checklist=items)))
    )
    assert "with this program, or to be ruled out with a reason: overturning of gables" in told
    assert "walls in their plane: damage of walls in their plane" in told
    assert "corner" not in told
