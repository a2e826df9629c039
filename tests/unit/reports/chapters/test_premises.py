"""What the verdict rests on besides the calculation."""

from __future__ import annotations

from dataclasses import replace

from assess.codes.calculation_sheet import step
from assess.results import LoadResult, MechanismResult, ResolvedValue, Results
from reports.chapters import verdict, verdict_texts
from tests.support.letters import letters, lines

TIE = LoadResult("tie 1", "tie", 0, (0.0, 6.0), None, None, (-20e3, 0.0), "given", lasting="to collapse")
BEAM = LoadResult("floor", "mass", 0, (0.0, 6.0), 800.0, True, None, "given", seat_m=0.2)


def with_factor(mechanism: MechanismResult, factor: float | None) -> MechanismResult:
    """Return the mechanism with deciding checks that state a confidence factor."""
    steps = (
        () if factor is None else (step("FC", "confidence factor", "C8.5.4", "of the level of knowledge", factor, "-"),)
    )
    return replace(mechanism, checks=tuple(replace(check, role="deciding", steps=steps) for check in mechanism.checks))


def with_factors(results: Results, *factors: float | None, **project: ResolvedValue) -> Results:
    made = tuple(map(with_factor, results.mechanisms, factors))
    levels = {key.replace("__", "."): value for key, value in project.items()}
    return replace(results, mechanisms=made, project={**results.project, **levels})


def test_confidence_factors_are_told_by_mechanism(results: Results) -> None:
    assert (
        letters(verdict_texts.knowledge_text(with_factors(results, 1.35, 1.35)))
        == "confidence factor FC = 1.35 for all mechanisms"
    )
    assert (
        letters(verdict_texts.knowledge_text(with_factors(results, 1.35, 1.2)))
        == "confidence factor FC = 1.35 for M1, confidence factor FC = 1.2 for M2"
    )
    assert verdict_texts.knowledge_text(with_factors(results, None, None)) is None


def test_the_knowledge_level_stands_before_its_factor(results: Results) -> None:
    code = next(check.procedure.partition("-")[0] for check in results.mechanisms[0].checks)
    made = with_factors(results, 1.35, 1.35, **{f"procedures__{code}__knowledge_level": ResolvedValue("LC1", True)})
    level, factor = verdict_texts.mechanism_knowledge(made, made.mechanisms[0]) or ("", 0.0)
    assert letters(verdict_texts.factor_text(level, factor)) == "LC1, confidence factor FC = 1.35"


def test_what_the_user_vouches_for_is_on_page_1(results: Results) -> None:
    first, *others = with_factors(results, 1.35, 1.35).mechanisms
    project = {**results.project, "materials.stone.disintegration": ResolvedValue("excluded", True)}
    made = replace(results, mechanisms=(replace(first, loads=(TIE, BEAM)), *others), project=project)
    told = lines(verdict.sections(made))
    assert "the masonry does not disintegrate, as the project states for stone" in told
    assert "ties and forces of M1 last up to collapse, as the project states" in told
    assert "the loads that rest on M1 have the seats that the project gives" in told


def test_sound_masonry_is_no_condition_where_no_code_asks_for_it(results: Results) -> None:
    project = {**results.project, "materials.stone.disintegration": ResolvedValue("excluded", True)}
    assert not list(verdict_texts.stated_premises(replace(with_factors(results, None, None), project=project)))
