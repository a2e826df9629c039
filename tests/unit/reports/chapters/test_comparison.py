"""The comparison: the site's own action apart from other levels, and what methods say against each other."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from assess.codes.check import Family, Outcome, PgaCurve
from assess.results import Results
from reports.chapters import comparison
from reports.document import Figure, OutcomeCell
from reports.language.locale import Locale
from tests.support.letters import cell_letters, lines_of
from tests.support.sample_results import with_verdict

EN = Locale()


def test_only_the_sites_own_action_is_coloured(results: Results) -> None:
    table = comparison.ratios_table(results)
    assert [EN.text(column.label).replace("\u00a0", " ") for column in table.columns][2:5] == [
        "D/C at 0.067 g",
        "D/C at 0.2 g",
        "D/C at 0.45 g",
    ]
    for row in table.rows:
        assert isinstance(row[2], OutcomeCell)
        assert not any(isinstance(cell, OutcomeCell) for cell in row[3:])
    assert cell_letters(table.rows[1][0]) == "M2 parapet"
    assert [cell_letters(cell) for cell in table.rows[1][3:5]] == ["0.37", "overturns"]


def test_the_methods_that_may_decide_stand_in_the_table(
    results: Results, judged_at: Callable[[Results, float], Results]
) -> None:
    row = comparison.ratios_table(judged_at(results, 0.45)).rows[1]
    assert isinstance(row[2], OutcomeCell)
    assert (row[2].outcome, cell_letters(row[2])) == ("fail", "overturns")
    nameless = comparison.ratios_table(with_verdict(results, basis="", methods=()))
    assert not any(isinstance(cell, OutcomeCell) for row in nameless.rows for cell in row)
    without = comparison.ratios_table(replace(results, verdict=None))
    assert not any(isinstance(cell, OutcomeCell) for row in without.rows for cell in row)
    assert len(without.columns) == len(without.rows[0])


def test_many_levels_are_thinned_out(results: Results) -> None:
    wall = results.mechanisms[0]
    levels = [0.1 + 0.01 * place for place in range(23)]
    checks = (*wall.checks, *(replace(wall.checks[0], level_pga_g=level) for level in levels))
    many = replace(results, mechanisms=(replace(wall, checks=checks),))
    assert len(comparison.ratios_table(many).columns) <= 2 + 1 + comparison.MAX_LEVELS + 3


def test_disagreement_names_who_fails_by_which_method(
    results: Results, judged_at: Callable[[Results, float], Results]
) -> None:
    judged = judged_at(results, 0.45)
    said = lines_of(comparison.findings(judged))
    assert "At the site’s own action the methods disagree on M1" in said
    assert "DMI 2008, linear fails M1 and M2. It compares the acceleration that starts the motion" in said
    agreed = tuple(
        replace(m, checks=tuple(replace(c, verdict=Outcome.PASS) for c in m.checks)) for m in judged.mechanisms
    )
    assert "disagree" not in lines_of(comparison.findings(replace(judged, mechanisms=agreed)))


@pytest.mark.parametrize(("capacity", "explained"), [(0.28, True), (0.31, False)])
def test_a_pass_above_the_pga_at_capacity_is_explained(results: Results, capacity: float, explained: bool) -> None:
    first = results.mechanisms[0]
    passing = replace(first.checks[4], verdict=Outcome.PASS, level_pga_g=0.3, capacity_pga_g=capacity)
    made = replace(results, mechanisms=(replace(first, checks=(passing,)),))
    assert ("For M1 a record that overturns" in lines_of(comparison.findings(made))) == explained


def test_overturning_records_are_counted(results: Results) -> None:
    said = lines_of(comparison.findings(results))
    assert "Records overturn M2 parapet at 0.45 g (1 of 5). No other history overturns a mechanism." in said
    standing = replace(results, mechanisms=results.mechanisms[:1])
    assert "No record overturns a mechanism at the levels requested." in lines_of(comparison.findings(standing))


def test_swept_mechanisms_are_represented_by_a_case(results: Results) -> None:
    assert lines_of(comparison.introduction(results)).startswith(
        "Each swept mechanism is represented by its most critical case: M2."
    )


def test_every_family_of_methods_has_a_sentence_on_what_it_measures() -> None:
    assert set(comparison.FAMILY_MEASURES) == set(Family)


def test_there_is_no_chapter_without_answers(results: Results) -> None:
    assert comparison.sections(replace(results, comparison=())) == []


def test_a_method_without_an_answer_passes_nothing(results: Results) -> None:
    """Of two mechanisms on which methods disagree a method may answer one alone."""
    wall, parapet = results.mechanisms
    assert results.verdict is not None
    first = replace(wall.checks[0], level_pga_g=results.verdict.action.pga_g, reading="letter", informs=False)
    one = replace(first, procedure="ntc2018-linear", verdict=Outcome.FAIL)
    two = replace(first, procedure="ntc2018-nonlinear", verdict=Outcome.PASS)
    silent = replace(first, procedure="ntc2018-history", verdict=Outcome.NOT_ANSWERED)
    passed = replace(silent, verdict=Outcome.PASS)
    apart = (replace(wall, checks=(one, two, silent)), replace(parapet, checks=(one, two, passed)))
    said = lines_of(comparison.findings(replace(results, mechanisms=apart)))
    assert "All of these are passed by NTC 2018, non-linear kinematic." in said
    assert "M2 is passed by NTC 2018, response history." in said
    assert "NTC 2018, linear kinematic fails M1 and M2." in said


def test_a_method_is_named_with_every_mechanism_that_it_fails(results: Results) -> None:
    """Methods disagree on M1 alone, but M2 fails as well."""
    wall, parapet = results.mechanisms
    assert results.verdict is not None
    first = replace(wall.checks[0], level_pga_g=results.verdict.action.pga_g, reading="letter", informs=False)
    one = replace(first, procedure="ntc2018-linear", verdict=Outcome.FAIL)
    two = replace(first, procedure="ntc2018-nonlinear", verdict=Outcome.PASS)
    failed = replace(two, verdict=Outcome.FAIL)
    apart = (replace(wall, checks=(one, two)), replace(parapet, checks=(one, failed)))
    said = lines_of(comparison.findings(replace(results, mechanisms=apart)))
    assert "the methods disagree on M1." in said
    assert "NTC 2018, linear kinematic fails M1 and M2." in said
    assert "M1 is passed by NTC 2018, non-linear kinematic." in said


def test_a_figure_without_anything_to_draw_is_left_out(results: Results) -> None:
    """A tabled limit of slenderness has neither a PGA at capacity nor a curve over the PGA."""
    bare = tuple(
        replace(
            each,
            checks=tuple(replace(c, pga_curve=PgaCurve((), ()), capacity_pga_g=None) for c in each.checks),
        )
        for each in results.mechanisms
    )
    (section,) = comparison.sections(replace(results, mechanisms=bare))
    assert [block.name for block in section.blocks if isinstance(block, Figure)] == ["comparison", "critical"][
        : 1 + (results.critical is not None)
    ]


def test_a_method_without_an_answer_is_not_compared(results: Results) -> None:
    """The ground motion unamplified at a height may fail a mechanism: the PGA at its capacity is no capacity."""
    said = lines_of(comparison.findings(results))
    assert "PGA at capacity" in said
    silent = tuple(
        replace(
            each,
            checks=tuple(replace(c, verdict=Outcome.NOT_ANSWERED) for c in each.checks if c.reading == "letter"),
        )
        for each in results.mechanisms
    )
    assert "PGA at capacity by" not in lines_of(comparison.findings(replace(results, mechanisms=silent)))
