"""What the summary says in words follows from the checks."""

from __future__ import annotations

from dataclasses import replace

import pytest
from reports.language.lists import list_names

from assess.codes.check import Outcome
from assess.codes.registry import PROCEDURES
from assess.results import Results
from reports.chapters import conclusions


def with_margins(results: Results, *margins: float | None) -> Results:
    """The results with these PGAs at capacity over the site's in the verdicts of the mechanisms."""
    found = results.verdict
    assert found is not None
    pairs = zip(found.mechanisms, margins, strict=True)
    return replace(results, verdict=replace(found, mechanisms=tuple(replace(one, margin=m) for one, m in pairs)))


def test_the_critical_mechanism_holds_the_least_by_what_decides(results: Results) -> None:
    first, second = results.mechanisms
    said = conclusions.conclusions(with_margins(results, 3.0, 2.0))[0]
    assert said.startswith(
        f"The critical mechanism is {conclusions.short_title(second)}: it holds up to 0.134 g = 2.00 x the site's, "
    )
    assert "by asce43-05-history; next is" in said
    assert f"next is {conclusions.short_title(first)} with 0.201 g = 3.00 x the site's, by asce43-05-spectrum" in said


def test_where_no_margin_is_known_no_mechanism_is_critical(results: Results) -> None:
    assert conclusions.ranking(with_margins(results, None, None)) == []
    assert conclusions.ranking(replace(results, verdict=None)) == []


def test_disagreement_names_who_fails_and_who_passes(results: Results) -> None:
    assert "disagree" not in " ".join(conclusions.conclusions(results))  # at the site's own action
    said = " ".join(conclusions.disagreements(results, (0.45,)))
    assert "For comparison: at PGA 0.45 g the procedures disagree on" in said
    assert "dmi2008-linear fails" in said
    assert "asce43-05-spectrum and dmi2008-nonlinear pass all of these" in said
    assert "dmi2008-linear checks the acceleration that starts the motion" in said
    assert "dmi2008-nonlinear compares the displacement" in said


def test_nothing_is_said_of_agreement(results: Results) -> None:
    passing = tuple(
        replace(m, checks=tuple(replace(c, verdict=Outcome.PASS, demand=0.0, ratio=0.0) for c in m.checks))
        for m in results.mechanisms
    )
    assert "disagree" not in " ".join(conclusions.disagreements(replace(results, mechanisms=passing), (0.2, 0.45)))


@pytest.mark.parametrize(
    ("names", "said"),
    [([], ""), (["a"], "a"), (["a", "b"], "a and b"), (list("abcdefghij"), "a, b, c, d, e, f and 4 others")],
)
def test_long_lists_are_shortened(names: list[str], said: str) -> None:
    assert list_names(names) == said


def test_no_record_overturns_is_not_said_of_procedures_with_a_motion_of_their_own(results: Results) -> None:
    first = results.mechanisms[0]
    check = replace(first.checks[0], procedure="ntc2018-history", limit_state="SLV", verdict=Outcome.FAIL, demand=None)
    standing = tuple(replace(suite, overturned=0) for suite in first.suites)
    found = replace(results, mechanisms=(replace(first, suites=standing, checks=(check,)),))
    said = " ".join(conclusions.conclusions(found))
    assert "no record overturns a mechanism at the levels requested; ntc2018-history" in said


def test_every_procedure_has_a_sentence_on_what_it_measures() -> None:
    assert [
        name for name in PROCEDURES if not name.endswith("-thesis") and not conclusions.describe_procedure(name)
    ] == []
