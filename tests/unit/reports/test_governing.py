"""Which result decides."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest

from assess.codes.check import BEYOND_SPECTRUM
from assess.results import ComparisonRow, Results
from reports import comparisons, cover, governing, sentences, summary, tables


def test_overturning_governs_before_every_ratio(results: Results) -> None:
    worst = governing.worst(results.mechanisms[1].checks)
    assert worst is not None
    assert (worst.procedure, worst.level_pga_g, worst.demand) == ("asce43-05-history", 0.45, None)


def test_one_check_governs_each_procedure(results: Results) -> None:
    for mechanism in results.mechanisms:
        found = governing.worst_per_procedure(mechanism)
        assert len(found) == 5
        assert {check.level_pga_g for check in found if check.verdict != "not-applicable"} == {0.45}


def test_the_overturning_history_governs(results: Results) -> None:
    found = governing.history(results.mechanisms[1])
    assert found is not None
    assert found[0].overturned
    bare = replace(results.mechanisms[1], histories=())
    assert governing.history(bare) is None


def test_rows_of_the_comparison_that_overturned(results: Results) -> None:
    rows = governing.overturned(results)
    assert [(row.mechanism, row.level_pga_g, row.procedure) for row in rows] == [("parapet", 0.45, "asce43-05-history")]


def test_what_lies_beyond_the_spectrum_is_not_said_to_overturn(results: Results) -> None:
    """The check that governs fails where its spectrum ends: every place that shows it says so."""
    first, *others = results.mechanisms
    worst = replace(first.checks[0], level_pga_g=9.0, demand=None, ratio=None, verdict="fail", reason=BEYOND_SPECTRUM)
    row = ComparisonRow(first.name, 9.0, worst.procedure, None, 0.5, None)
    one = replace(first, checks=(*first.checks, worst))
    made = replace(results, mechanisms=(one, *others), comparison=(*results.comparison, row))
    assert not governing.fell(worst)
    assert row not in governing.overturned(made)
    assert governing.drawn(made)[-1].demand_capacity == inf
    assert governing.drawn(made)[:-1] == results.comparison
    lines = (
        tables.demands(one, name="d").rows[-1],
        next(line for line in tables.brief(made).rows if line[1] == 9.0),
        next(line for line in comparisons.side_by_side(made).rows if line[1] == 9.0),
        next(line for line in comparisons.comparison(made).rows if line[1] == 9.0),
        next(line for line in cover.glance(made).rows if line[3] == 9.0),
        next(line for line in summary.governing_checks(made).rows if line[2] == 9.0),
    )
    assert all("beyond the spectrum" in line and "overturned" not in line for line in lines)
    said = " ".join(sentences.outcome(made))
    assert f"its demand lies beyond the spectrum, by {worst.procedure} at PGA 9 g." in said


@pytest.mark.parametrize(
    ("verdict", "words"),
    [
        ("pass", "every code check passes"),
        ("fail", "2 of them fail"),
        ("not-applicable", "No code procedure"),
    ],
)
def test_outcome_in_words(results: Results, verdict: str, words: str) -> None:
    mechanisms = tuple(
        replace(m, checks=tuple(replace(c, verdict=verdict) for c in m.checks))  # type: ignore[arg-type]
        for m in results.mechanisms
    )
    assert words in " ".join(sentences.outcome(replace(results, mechanisms=mechanisms)))


def test_an_unanswered_check_is_no_pass(results: Results) -> None:
    """All else passes: page 1 says incomplete, how many of how many, and why; the brief table says so too."""
    passing = tuple(
        replace(m, checks=tuple(c if c.verdict == "not-applicable" else replace(c, verdict="pass") for c in m.checks))
        for m in results.mechanisms
    )
    whole = replace(results, mechanisms=passing)
    silent = [c for m in passing for c in governing.of_code(m.checks) if c.verdict == "not-applicable"]
    total = sum(len(governing.of_code(m.checks)) for m in passing)
    text = " ".join(sentences.outcome(whole))
    assert text.startswith(f"Incomplete: {len(silent)} of {total} checks could not be answered.")
    assert f"asce43-05-history: fewer than 5 records: shown as information ({len(silent)} checks)" in text
    assert "every code check" not in text
    assert [row[-1] for row in tables.brief(whole).rows].count("incomplete") == len(silent) > 0


def test_limits_name_what_is_unverified_informative_and_linearised(results: Results) -> None:
    text = " ".join(sentences.limits(results))
    for words in (
        "asce43-05-spectrum-thesis: informative",
        sentences.UNCHECKED,
        "histories of parapet",
        "Judge by the suite",
    ):
        assert words in text
    assert "input at the ground and others" in text


def test_limits_say_where_sliding_was_checked_and_where_not(results: Results) -> None:
    assert "friction at the hinges is taken as sufficient" in " ".join(sentences.limits(results))
    first, second = results.mechanisms
    asked = replace(first.checks[0], procedure="sliding", verdict="pass")
    silent = replace(asked, verdict="not-applicable")
    both = tuple(replace(one, checks=(check,)) for one, check in ((first, asked), (second, silent)))
    text = sentences.sliding(replace(results, mechanisms=both))
    assert text.startswith("Sliding was checked by equilibrium, at every hinge")
    assert "For parapet it was not checked" in text
    assert "it was not checked" not in sentences.sliding(replace(results, mechanisms=both[:1]))


def test_damage_is_no_collapse_where_a_procedure_knows_both(results: Results) -> None:
    check = results.mechanisms[0].checks[0]
    damage = replace(check, procedure="ntc2018-linear", limit_state="SLD", capacity_pga_g=0.1)
    life = replace(check, procedure="ntc2018-linear", limit_state="SLV", capacity_pga_g=0.3)
    assert governing.weakest((damage, life)) == life
    assert governing.capacities((damage, life)) == {"ntc2018-linear": 0.3}
    assert governing.weakest((damage,)) == damage
