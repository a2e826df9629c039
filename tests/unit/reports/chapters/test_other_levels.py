"""Levels besides the site's own are a study, apart from the verdict."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from assess.codes.check import Outcome
from assess.results import Results
from reports.assessment import assessment
from reports.chapters import other_levels


def test_the_study_tells_what_the_accepted_methods_say_at_other_levels(results: Results) -> None:
    table = other_levels.table(results)
    heads = [column.label for column in table.columns]
    assert heads == ["Mechanism", "PGA", "asce43-05 spectrum", "asce43-05 history", "Largest ratio"]
    rows = {(row[0], row[1]): row[2:] for row in table.rows}
    assert len(rows) == 4
    assert rows["parapet", 0.2] == ("pass", "pass", 0.37)
    assert rows["parapet", 0.45] == ("fail", "fail", "overturned")
    assert rows["Wall 6, eroded base", 0.45] == ("pass", "not-answered", 0.84)


def test_without_a_basis_all_readings_of_codes_stand_in_the_study(results: Results) -> None:
    headings = [column.heading for column in other_levels.table(replace(results, verdict=None)).columns]
    assert "dmi2008 linear" in headings
    assert not any("thesis" in heading for heading in headings)


def test_the_chapter_is_absent_where_the_sites_own_action_is_alone(
    results: Results, judged_at: Callable[[Results, float], Results]
) -> None:
    assert other_levels.TITLE in {section.title for section in assessment(results).sections}
    alone = replace(
        results,
        mechanisms=tuple(
            replace(m, checks=tuple(c for c in m.checks if c.level_pga_g == 0.067)) for m in results.mechanisms
        ),
    )
    assert other_levels.chapter(judged_at(alone, 0.067)) == []


def test_a_pass_above_the_pga_at_capacity_is_explained(results: Results) -> None:
    first = results.mechanisms[0]
    passing = replace(first.checks[0], verdict=Outcome.PASS, level_pga_g=0.3, capacity_pga_g=0.28)
    assert other_levels.passes_beyond_capacity(replace(results, mechanisms=(replace(first, checks=(passing,)),)))[
        0
    ].startswith("Wall 6")
    below = replace(passing, capacity_pga_g=0.31)
    assert other_levels.passes_beyond_capacity(replace(results, mechanisms=(replace(first, checks=(below,)),))) == ()
