"""The page of a mechanism: what it says of the mechanism, and what governs."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.codes.check import Outcome
from assess.codes.verdict import Decision, Index
from assess.messages.message import Message, Severity
from assess.results import MechanismResult, ResolvedValue, Results
from reports import governing
from reports.chapters import mechanism_page, mechanism_verdict
from reports.chapters.cells import required_increase
from reports.document import Figure, FigureRow, OutcomeCell
from reports.figures.key_plan import building_of
from reports.language.locale import Locale
from tests.support.letters import lines_of
from tests.support.sample_results import with_verdict

US = Locale(system="US")


def described(mechanism: MechanismResult) -> str:
    return lines_of([mechanism_page.description(mechanism)])


def test_the_description_names_kind_sides_direction_and_loads(results: Results) -> None:
    wall, parapet = results.mechanisms
    assert described(replace(wall, direction=(0.0, -1.0, 0.0))).startswith(
        "A single block that rocks to both sides, positive towards −y."
    )
    assert "30° from +x towards +y" in described(replace(wall, direction=(3**0.5 / 2, 0.5, 0.0)))
    assert described(parapet).startswith("An equivalent block, given by its rocking parameters instead of a geometry,")
    assert "rocks to one side only" in described(parapet)
    assert "Loads: floor <beam> and =cmd()." in described(parapet)
    assert "It carries 8 loads." in described(replace(parapet, loads=parapet.loads * 4))


def test_the_x_of_a_sketch_is_told_from_that_of_the_model(results: Results) -> None:
    other = "This x is not the axis of the model."
    wall = results.mechanisms[0]
    along, back = (replace(wall, direction=way) for way in ((1.0, 0.0, 0.0), (-1.0, 0.0, 0.0)))
    assert other not in lines_of([mechanism_page.sketch_caption(along)])
    assert lines_of([mechanism_page.sketch_caption(back)]).endswith(f"as motion starts. {other}")


def test_heights_follow_the_units(results: Results) -> None:
    above = replace(results.mechanisms[0], base_elevation_m=3.048, above_ground=True)
    assert "Its base is 10 ft above the ground." in lines_of([mechanism_page.description(above)], US)
    ground = replace(above, base_elevation_m=0.0, above_ground=False)
    assert "Its base is on the ground." in described(ground)


def test_the_case_that_stands_for_a_sweep_is_named(results: Results) -> None:
    wall, parapet = results.mechanisms
    assert lines_of(mechanism_page.represented_case(results, parapet)) == (
        "Multiplier at uplift: 3 values were studied; this page shows the most critical one: 0.09."
    )
    assert not tuple(mechanism_page.represented_case(results, wall))


def test_warnings_belong_to_the_mechanism_with_the_longest_name(results: Results) -> None:
    wall, parapet = results.mechanisms
    longer = replace(parapet, name="wall-6.b")
    said = (
        Message("a", Severity.WARNING, "mechanisms.wall-6.b.loads[1]", "of the longer one"),
        Message("b", Severity.WARNING, "mechanisms.wall-6", "of the wall"),
        Message("b", Severity.WARNING, "mechanisms.wall-6", "of the wall"),
        Message("c", Severity.NOTE, "mechanisms.wall-6", "a note"),
        Message("d", Severity.WARNING, "records", "of the records"),
    )
    both = replace(results, mechanisms=(wall, longer), warnings=said)
    assert [each.text for each in mechanism_page.mechanism_warnings(both, wall)] == ["of the wall"]
    assert [each.text for each in mechanism_page.mechanism_warnings(both, longer)] == ["of the longer one"]


def test_branches_that_are_alike_share_a_row(results: Results) -> None:
    wall, parapet = results.mechanisms
    assert len(mechanism_page.branch_parameters_table(results, wall, name="n").rows) == 1
    assert wall.oscillator_negative is not None
    other = replace(wall, oscillator_negative=replace(wall.oscillator_negative, radius_m=2.0))
    rows = mechanism_page.branch_parameters_table(results, other, name="n").rows
    assert [row[2] for row in rows] == [2.84, 2.0]
    assert (
        mechanism_page.branch_parameters_table(results, parapet, name="n").rows[0][1] is None
    )  # a unit mass stands for none
    given = {**results.project, "mechanisms.parapet.mass": ResolvedValue(1.0, True)}
    known = replace(results, project=given)
    assert mechanism_page.branch_parameters_table(known, parapet, name="n").rows[0][1] == 1.0


def test_answers_are_those_at_the_sites_own_action_once_each(results: Results) -> None:
    wall = results.mechanisms[0]
    checks = mechanism_page.shown_checks(results, wall)
    assert {check.level_pga_g for check in checks} == {0.067}
    keys = [(check.procedure, check.limit_state) for check in checks]
    assert len(keys) == len(set(keys)) == 5
    table = mechanism_page.answers_table(results, wall, name="n")
    assert table.muted == {4}  # the reading of the thesis comes last
    graded = [row[-1] for row in table.rows]
    assert all(isinstance(each, OutcomeCell) for each in graded)
    roles = [check.role for check in checks]
    colours = [each.outcome for each in graded if isinstance(each, OutcomeCell)]
    assert [colour == "comparison" for colour in colours] == [role != "deciding" for role in roles]


def test_methods_that_do_not_apply_are_named_and_have_no_row(results: Results) -> None:
    wall = results.mechanisms[0]
    checks = tuple(
        replace(check, verdict=Outcome.NOT_APPLICABLE) if check.procedure == "dmi2008-linear" else check
        for check in wall.checks
    )
    changed = replace(wall, checks=checks)
    assert len(mechanism_page.shown_checks(results, changed)) == 4
    (section,) = mechanism_page.sections(results, changed, "01-wall")
    prose = [lines_of(block.paragraphs) for block in section.blocks if hasattr(block, "paragraphs")]
    assert any("Methods that do not apply to this mechanism: DMI 2008, linear." in each for each in prose)


def test_what_governs_is_told_with_its_numbers_and_clause(results: Results, judged_at: object) -> None:
    assert callable(judged_at)
    judged = judged_at(results, 0.45)
    said = lines_of(mechanism_verdict.verdict_sentences(judged, judged.mechanisms[1]))
    assert (
        "ASCE 43-05, response history governs at DBE: overturns: no rotation balances this demand (ASCE/SEI 43-05"
        in said
    )
    judged = judged_at(results, 0.2)
    said = lines_of(mechanism_verdict.verdict_sentences(judged, judged.mechanisms[0]))
    assert "governs at DBE: rotation 0.0259 rad against an allowable 0.07 rad, a ratio of 0.37" in said


def test_a_target_below_full_safety_passes_a_ratio_above_one(results: Results, judged_at: object) -> None:
    """Table and sentences have the outcome of the verdict, and say why."""
    failing = judged_at(results, 0.45)  # type: ignore[operator]
    wall = next(each for each in failing.mechanisms if any(check.role == "deciding" for check in each.checks))
    own = governing.verdict_of(failing, wall)
    assert own is not None
    answers = tuple(replace(each, outcome=Decision.PASS, ratio=1.5) for each in own.answers)
    passing = replace(own, outcome=Decision.PASS, answers=answers)
    found = replace(failing.verdict, basis="nzsee2017", target=34.0, index=Index("%NBS", 40.0), mechanisms=(passing,))
    lowered = replace(failing, verdict=found)
    (deciding, *_), *_ = [
        [cell for cell in row if isinstance(cell, OutcomeCell)]
        for row in mechanism_page.answers_table(lowered, wall, name="a").rows
    ]
    assert (deciding.outcome, lines_of([deciding.text])) == ("pass", "pass")
    assert "It passes, as the target is less than full safety: at least 34 %NBS." in lines_of(
        mechanism_verdict.verdict_sentences(lowered, wall)
    )


def test_a_failure_with_a_ratio_within_one_says_why(results: Results) -> None:
    verdict = results.verdict
    assert verdict is not None
    one = verdict.mechanisms[0]
    reason = Message("fails-below", Severity.NOTE, "", "the PGA scan already fails just above 0.1 g")
    for ratio, outcome in ((0.4, Decision.FAIL), (1.4, Decision.FAIL), (0.4, Decision.PASS)):
        answers = (replace(one.answers[0], ratio=ratio, outcome=outcome, reason=reason),)
        judged = replace(verdict, mechanisms=(replace(one, answers=answers, outcome=outcome), *verdict.mechanisms[1:]))
        said = lines_of(mechanism_verdict.verdict_sentences(replace(results, verdict=judged), results.mechanisms[0]))
        why = "It fails although this ratio is not above 1: the PGA scan already fails just above 0.1 g."
        assert (why in said) == (ratio < 1.0 and outcome == Decision.FAIL)


def test_joints_of_several_models_are_words_of_the_language(results: Results) -> None:
    wall = results.mechanisms[0]
    kinds = ("rigid", "flexible")
    both = replace(wall, interfaces=tuple({"model": kind, "curve": {}, "hinge": "A"} for kind in kinds))
    assert "Joints: rigid, with crushing and flexible;" in described(both)
    italian = lines_of([mechanism_page.description(both)], Locale("it"))
    assert "crushing" not in italian
    assert "flexible" not in italian


def test_where_no_code_decides_nothing_governs(results: Results) -> None:
    nameless = with_verdict(results, basis="")
    assert lines_of(mechanism_verdict.verdict_sentences(nameless, results.mechanisms[0])) == (
        "No code is named that decides: the results of all methods are for comparison only."
    )
    assert not tuple(mechanism_verdict.verdict_sentences(replace(results, verdict=None), results.mechanisms[0]))


def test_a_failure_says_what_it_lacks(results: Results) -> None:
    assert results.verdict is not None
    one = results.verdict.mechanisms[1]
    answer = replace(one.answers[0], outcome=Decision.FAIL, ratio=3.0, index=Index("zeta_E", 0.4))
    failing = replace(one, outcome=Decision.FAIL, answers=(answer,), margin=0.5)
    assert required_increase(failing, replace(results.verdict, target=0.8)) == pytest.approx(2.0)
    by_ratio = replace(failing, answers=(replace(answer, index=Index("D/C", 3.0)),))
    assert required_increase(by_ratio, results.verdict) == pytest.approx(2.0)  # 1 / margin
    unknown = replace(by_ratio, margin=None)
    assert required_increase(unknown, results.verdict) == pytest.approx(3.0)


def test_the_clause_is_that_of_the_comparison(results: Results) -> None:
    check = results.mechanisms[0].checks[0]
    last, before = check.steps[-1], check.steps[-2]
    steps = (*check.steps[:-2], replace(before, value=check.ratio, unit="-", clause="A.2"), replace(last, value=7.0))
    assert mechanism_verdict.comparison_clause(replace(check, steps=steps)) == "A.2"
    assert mechanism_verdict.comparison_clause(replace(check, steps=())) == ""


def test_figures_stand_in_pairs_and_none_is_lost(results: Results) -> None:
    for mechanism, names in zip(
        results.mechanisms,
        (["sketch", "place", "capacity", "pga-rotation"], ["sketch", "capacity", "pga-rotation"]),
        strict=True,
    ):
        (section,) = mechanism_page.sections(results, mechanism, "s", building_of(results))
        rows = [block for block in section.blocks if isinstance(block, FigureRow)]
        alone = [block for block in section.blocks if isinstance(block, Figure)]
        figures = [figure for row in rows for figure in row.figures] + alone
        assert [figure.name for figure in figures] == [f"s-{name}" for name in names]
        assert {len(row.figures) for row in rows} == {2}
        assert section.starts_page
        assert section.mark in ("M1", "M2")
