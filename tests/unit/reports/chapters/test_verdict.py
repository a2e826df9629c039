"""Page 1 says what the verdict of the results says, all of it or where the rest is, and nothing else."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from assess.codes.question import Missing
from assess.codes.verdict import Decision, Index, Override
from assess.messages.message import Message, Quantity, Severity, note, warning
from assess.results import ChecklistItem, ReportMatter, ResolvedValue, Results
from reports.chapters import annex_inputs, cells, recommendations, scope, site, verdict
from reports.document import Banner, FileLines
from reports.language.locale import Locale
from tests.support.letters import letters, lines, text_of
from tests.support.sample_results import with_verdict

JudgedAt = Callable[[Results, float], Results]
WEAK = Missing("materials.old stone.disintegration", "whether it may disintegrate", 'disintegration = "excluded"')


def condition(number: int) -> Message:
    return Message(f"condition-{number}", Severity.NOTE, "", f"condition {number} is shown to hold")


def banner(results: Results) -> Banner:
    found = verdict.sections(results)[0].blocks[0]
    assert isinstance(found, Banner)
    return found


@pytest.mark.parametrize(
    ("pga_g", "outcome", "said"),
    [
        (0.067, "pass", "All 2 mechanisms examined hold at the site’s own action, PGA 0.067 g."),
        (0.45, "fail", "1 of 2 mechanisms examined fails at the site’s own action, PGA 0.45 g."),
    ],
)
def test_the_banner_is_the_verdict_at_the_sites_own_action(
    results: Results, judged_at: JudgedAt, pga_g: float, outcome: str, said: str
) -> None:
    """At 0.45 g linear analysis fails both; it is no method of the basis and decides nothing."""
    found = banner(judged_at(results, pga_g))
    assert (found.outcome, letters(found.headline), found.near) == (outcome, said, False)


def test_one_mechanism_is_not_all_of_them(results: Results) -> None:
    assert results.verdict is not None
    alone = with_verdict(results, mechanisms=results.verdict.mechanisms[:1])
    assert letters(banner(alone).headline).startswith("The one mechanism examined holds")


@pytest.mark.parametrize(
    ("outcome", "said"),
    [
        (Decision.FAIL, "The one mechanism examined fails at the site’s own action, PGA"),
        (Decision.INCOMPLETE, "The one mechanism examined has no deciding answer at the site’s own action, PGA"),
    ],
)
def test_one_mechanism_is_not_counted(results: Results, outcome: Decision, said: str) -> None:
    assert results.verdict is not None
    alone = with_verdict(results, mechanisms=results.verdict.mechanisms[:1], outcome=outcome)
    assert letters(banner(alone).headline).startswith(said)


def test_a_target_below_full_safety_is_not_the_sites_own_action(results: Results, judged_at: JudgedAt) -> None:
    """A wall of 40 %NBS passes at 34 %NBS, without holding at the action of the site."""
    lowered = with_verdict(judged_at(results, 0.067), basis="nzsee2017", target=34.0, index=Index("%NBS", 40.0, "C"))
    assert letters(banner(lowered).headline) == (
        "All 2 mechanisms examined reach the target at the site’s own action, PGA 0.067 g: at least 34 %NBS."
    )
    words = text_of(recommendations.sections(lowered))
    assert "No mechanism examined requires strengthening to reach the target." in words
    assert "At the site’s own action no mechanism" not in words


def test_a_basis_of_the_engineer_has_no_limit_state(results: Results) -> None:
    assert results.verdict is not None
    own = with_verdict(results, basis="own", limit_states=("own",), clauses=(("By agreement.", ""),))
    said = text_of(verdict.sections(own))
    assert "Code: By agreement." in said
    assert "Limit state" not in said
    assert "own" not in letters(site.sections(own)[0].blocks[0].paragraphs[0]).replace("site’s own", "")  # type: ignore[union-attr]


def test_what_lies_at_the_limit_says_so_unless_it_is_incomplete(results: Results) -> None:
    assert banner(with_verdict(results, at_the_limit=True)).near
    assert not banner(with_verdict(results, at_the_limit=True, outcome=Decision.INCOMPLETE)).near


def test_the_basis_names_titles_action_target_and_index(results: Results) -> None:
    known = with_verdict(results, index=Index("zeta_E", 0.8312))
    project = {**results.project, "building.use_class": ResolvedValue("III", True)}
    said = lines(verdict.sections(replace(known, project=project)))
    assert "Code: ASCE/SEI 43-05" in said
    assert "Limit state: DBE (design basis earthquake)" in said
    assert "Site’s own action: PGA 0.067 g, stated for DBE, return period not stated, class of use III" in said
    assert "Methods that may decide: ASCE 43-05, response history and ASCE 43-05, approximate method" in said
    assert "Target: ζ_E of at least 1" in said
    assert "Index of the building: at most ζ_E = 0.831; local mechanisms only" in said


def test_the_target_has_its_measure_where_no_index_is_known(results: Results) -> None:
    said = lines(verdict.sections(with_verdict(results, index=None)))
    assert "Target: D/C of at most 1" in said
    assert not any(line.startswith("Index of the building") for line in said)


def test_a_ratio_is_bounded_from_below(results: Results) -> None:
    said = lines(verdict.sections(with_verdict(results, index=Index("D/C", 0.5))))
    assert "Index of the building: at least D/C = 0.5; local mechanisms only" in said


def test_the_code_has_its_national_annex(results: Results) -> None:
    given = replace(results, report=ReportMatter(national_annex="UNI EN 1998-1"))
    assert "Code: ASCE/SEI 43-05, national annex: UNI EN 1998-1" in lines(verdict.sections(given))


def test_an_incomplete_verdict_lists_what_is_missing_in_words_and_the_annex_the_lines_to_paste(
    results: Results,
) -> None:
    lacking = with_verdict(
        results, outcome=Decision.INCOMPLETE, missing=(WEAK,), provisional=Decision.FAIL, conditions=()
    )
    said = lines(verdict.sections(lacking))
    assert "old stone: disintegration: whether it may disintegrate" in said
    assert "With the safe value of all that is missing, the verdict would be: fail." in said
    pasted = FileLines(('[materials."old stone"]', 'disintegration = "excluded"'))
    assert pasted in annex_inputs.sections(lacking)[0].blocks
    signed = (*verdict.sections(lacking), *recommendations.sections(lacking))
    assert not any(isinstance(block, FileLines) for section in signed for block in section.blocks)


def test_one_key_of_several_mechanisms_is_one_line(results: Results) -> None:
    why = "whether the masonry may disintegrate"
    keys = [f"mechanisms.{each.name}.disintegration" for each in results.mechanisms]
    lacking = tuple(Missing(key, why, 'disintegration = "excluded"') for key in keys)
    made = with_verdict(results, outcome=Decision.INCOMPLETE, missing=lacking)
    assert f"Disintegration of the masonry of all mechanisms: {why}" in lines(verdict.sections(made))
    other = with_verdict(results, outcome=Decision.INCOMPLETE, missing=lacking[1:])
    assert f"Disintegration of the masonry (M2): {why}" in lines(verdict.sections(other))


def test_a_condition_of_another_version_keeps_its_own_words(results: Results) -> None:
    old = Message("top-held", Severity.NOTE, "", "the top of parapet is held", {"mechanism": "parapet"})
    assert cells.condition_texts(results, [old]) == [old]


def test_what_a_verdict_hangs_on_is_said_without_a_key(results: Results) -> None:
    parapet = results.mechanisms[1]
    key = f"mechanisms.{parapet.name}.loads[1].force"
    force = Override(key, '"20 kN"', "", Decision.FAIL, source="pull-out test")
    (said,) = (
        line for line in lines(verdict.sections(with_verdict(results, overrides=(force,)))) if "pull-out" in line
    )
    assert said.startswith(f"force of {parapet.loads[0].name} (M2): 20 kN (pull-out test); without it")


def test_what_passes_asks_for_nothing(results: Results) -> None:
    assert not any(isinstance(block, FileLines) for block in verdict.sections(results)[0].blocks)


def test_many_conditions_are_all_in_the_report(results: Results) -> None:
    many = with_verdict(results, conditions=tuple(map(condition, range(20))))
    first, rest = lines(verdict.sections(many)), lines(scope.sections(many))
    assert "and 16 others, under Scope and limits" in first
    assert all(f"condition {number} is shown to hold" in rest for number in range(20))


def test_what_the_project_vouches_for_counts_among_the_conditions(results: Results) -> None:
    """Five conditions and two premises are a list that page 1 shortens, so that all of them stand under Scope."""
    tied = replace(results.mechanisms[1].loads[0], lasting="to collapse", seat_m=0.1)
    last = replace(results.mechanisms[1], loads=(tied,))
    several = replace(results, mechanisms=(results.mechanisms[0], last))
    many = with_verdict(several, conditions=tuple(map(condition, range(6))))
    assert "and 4 others, under Scope and limits" in text_of(verdict.sections(many))
    assert "have the seats that the project gives" in text_of(scope.sections(many))


def test_a_list_is_not_shortened_by_one_point(results: Results) -> None:
    five = with_verdict(results, conditions=tuple(map(condition, range(5))))
    assert sum("is shown to hold" in line for line in lines(verdict.sections(five))) == 5


def test_one_condition_of_several_mechanisms_is_one_line_with_their_numbers(results: Results) -> None:
    """Keys of the mechanisms within it become words, which are the same for both."""
    held = (note("not-drawn", keys=f"mechanisms.{each.name}.p") for each in results.mechanisms)
    (said,) = [
        line for line in lines(verdict.sections(with_verdict(results, conditions=tuple(held)))) if "drawn" in line
    ]
    assert said.startswith("all mechanisms: a pass is valid only if these are as stated")
    assert said.endswith(": Frequency parameter p")
    (top,) = cells.condition_texts(
        results,
        [
            note(
                "top-held",
                mechanism=results.mechanisms[1].name,
                foot=Quantity(2e3, "force"),
                force=Quantity(5e3, "force"),
            )
        ],
    )
    assert "M2 is held at its top" in Locale().text(top)


def test_one_warning_of_several_mechanisms_is_one_line_with_their_numbers(results: Results) -> None:
    told = tuple(warning("ground-motion", f"mechanisms.{name}") for name in ("parapet", "wall-6"))
    said = lines(verdict.sections(replace(results, warnings=told)))
    assert f"all mechanisms: {told[0].text}" in said
    alone = lines(verdict.sections(replace(results, warnings=told[:1])))
    assert f"M2: {told[0].text}" in alone


def test_notes_are_no_warnings(results: Results) -> None:
    told = (replace(condition(1), severity=Severity.NOTE),)
    assert not any("condition 1" in line for line in lines(verdict.sections(replace(results, warnings=told))))


def test_mechanisms_that_are_possible_and_not_examined_are_named(results: Results) -> None:
    items = (ChecklistItem("gable", None, "not-examined"), ChecklistItem("corner", None, "absent"))
    matter = ReportMatter(building_type="house", checklist=items)
    assert "Possible, not examined: overturning of gables" in lines(verdict.sections(replace(results, report=matter)))


def test_page_1_says_where_nobody_listed_what_is_possible(results: Results) -> None:
    assert any(line.startswith("Possible, not examined: not stated") for line in lines(verdict.sections(results)))


def test_results_without_a_verdict_say_so(results: Results) -> None:
    assert "no verdict" in lines(verdict.sections(replace(results, verdict=None)))[0]
