"""What the verdict rests on besides the calculation."""

from __future__ import annotations

from dataclasses import replace

from assess.codes.calculation_sheet import step
from assess.results import LoadResult, ResolvedValue, Results
from reports.chapters import verdict
from reports.chapters.cells import factor_text, knowledge_text, mechanism_knowledge, stated_premises
from tests.support.letters import letters, lines
from tests.support.sample_results import with_project

TIE = LoadResult("tie 1", "tie", 0, (0.0, 6.0), None, None, (-20e3, 0.0), "given", lasting="to collapse")
EXCLUDED = {"materials__stone__disintegration": ResolvedValue("excluded", True)}
BEAM = LoadResult("floor", "mass", 0, (0.0, 6.0), 800.0, True, None, "given", seat_m=0.2)


def with_factors(results: Results, *factors: float | None) -> Results:
    """Return results whose deciding checks state a confidence factor, one for each mechanism."""
    made = []
    for mechanism, factor in zip(results.mechanisms, factors, strict=True):
        line = ("FC", "confidence factor", "C8.5.4", "of the level of knowledge", factor, "-")
        steps = () if factor is None else (step(*line),)
        checks = tuple(replace(check, role="deciding", steps=steps) for check in mechanism.checks)
        made.append(replace(mechanism, checks=checks))
    return replace(results, mechanisms=tuple(made))


def test_confidence_factors_are_told_by_mechanism(results: Results) -> None:
    assert (
        letters(knowledge_text(with_factors(results, 1.35, 1.35))) == "confidence factor FC = 1.35 for all mechanisms"
    )
    assert (
        letters(knowledge_text(with_factors(results, 1.35, 1.2)))
        == "confidence factor FC = 1.35 for M1, confidence factor FC = 1.2 for M2"
    )
    assert knowledge_text(with_factors(results, None, None)) is None


def test_the_knowledge_level_stands_before_its_factor(results: Results) -> None:
    made = with_project(
        with_factors(results, 1.35, 1.35), procedures__ntc2018__knowledge_level=ResolvedValue("LC1", True)
    )
    first = made.mechanisms[0]
    italian = replace(first, checks=tuple(replace(check, procedure="ntc2018-linear") for check in first.checks))
    level, factor = mechanism_knowledge(made, italian) or ("", 0.0)
    assert letters(factor_text(level, factor)) == "LC1, confidence factor FC = 1.35"


def test_what_the_user_vouches_for_is_on_page_1(results: Results) -> None:
    sound = with_project(with_factors(results, 1.35, 1.35), **EXCLUDED)
    first, *others = sound.mechanisms
    made = replace(sound, mechanisms=(replace(first, loads=(TIE, BEAM)), *others))
    told = lines(verdict.sections(made))
    assert "the masonry does not disintegrate, as the project states for stone" in told
    assert "ties and forces of M1 last up to collapse, as the project states" in told
    assert "the loads that rest on M1 have the seats that the project gives" in told


def test_sound_masonry_is_no_condition_where_no_code_asks_for_it(results: Results) -> None:
    sound = with_project(with_factors(results, None, None), **EXCLUDED)
    assert not list(stated_premises(sound))
