"""Only the limits that apply to these results are told, and everything that was not compared with a print is."""

from __future__ import annotations

from dataclasses import replace

from assess.codes.check import Outcome
from assess.messages.message import note
from assess.results import ResolvedValue, Results
from reports.chapters import scope
from tests.support.letters import letters, lines, lines_of, rows
from tests.support.sample_results import with_mechanisms


def test_notes_of_the_engineer_are_signed(results: Results) -> None:
    made = replace(results, project={"notes": ResolvedValue("The attic was not seen.", given=True)})
    assert "Notes: The attic was not seen." in lines(scope.sections(made))


def test_limits_of_histories_need_histories(results: Results) -> None:
    assert "One rocking history cannot be predicted" in lines_of(scope.applicable_limits(results))
    assert "history" not in lines_of(scope.applicable_limits(with_mechanisms(results, histories=())))


def test_the_linearised_equation_is_told_of_those_that_use_it(results: Results) -> None:
    assert "The histories of M2 solve the linearised equation" in lines_of(scope.applicable_limits(results))


def test_sliding_is_assumed_where_it_was_not_checked(results: Results) -> None:
    wall, parapet = results.mechanisms
    assert "Friction is assumed to be sufficient for all mechanisms" in letters(scope.sliding(results))
    slid = replace(wall.checks[0], procedure="sliding", verdict=Outcome.PASS)
    some = replace(results, mechanisms=(replace(wall, checks=(*wall.checks, slid)), parapet))
    assert "sufficient for M2; it was not checked" in letters(scope.sliding(some))
    unanswered = replace(slid, verdict=Outcome.NOT_ANSWERED)
    none = replace(results, mechanisms=(replace(wall, checks=(*wall.checks, unanswered)), parapet))
    assert "sufficient for all mechanisms" in letters(scope.sliding(none))


def test_ground_motion_above_the_ground_names_mechanism_and_method(results: Results) -> None:
    wall, parapet = results.mechanisms
    remark = note("ground-motion", "")
    low = replace(wall.checks[0], procedure="dmi2008-linear", remarks=(remark,))
    said = lines_of(
        scope.applicable_limits(replace(results, mechanisms=(replace(wall, checks=(*wall.checks, low)), parapet)))
    )
    assert "acts unamplified on M1, which are above the ground, in these methods: DMI 2008, linear." in said
    assert "unamplified" not in lines_of(scope.applicable_limits(results))


def test_each_caveat_is_told_once_with_its_methods(results: Results) -> None:
    said = [line for line in lines(scope.sections(results)) if "clauses not checked" in line]
    assert said == ["DMI 2008, linear; DMI 2008, capacity spectrum: clauses not checked against the printed standard"]


def test_what_the_basis_could_not_compare_is_told(results: Results) -> None:
    assert results.verdict is not None
    assert set(results.verdict.uncompared) <= set(lines(scope.sections(results)))


def test_methods_say_their_part_and_those_that_decide_come_first(results: Results) -> None:
    table = scope.methods_table(results)
    parts = [row[2] for row in rows(table)]
    assert parts[0] == "decides"
    assert "never decides: reading by Mehrotra" in parts
    assert table.muted == {place for place, part in enumerate(parts) if part != "decides"}
    assert len(rows(table)) == len({check.procedure for each in results.mechanisms for check in each.checks})


def test_references_are_those_of_these_results(results: Results) -> None:
    cited = [letters(text) for text in scope.cited_works(results)]
    assert len(set(cited)) == len(cited)
    assert any("ASCE/SEI 7-16" in text for text in cited)
    assert not any("NZSEE" in text or "Zhang" in text for text in cited)
