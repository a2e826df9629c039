"""The annex of verification: what its headline claims, and which cases count as covering."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.results.provenance import describe_program
from assess.results.verification import (
    CaseResult,
    Coverage,
    QuantityResult,
    Source,
    Tolerance,
    ValueResult,
    VerificationResults,
)
from reports.chapters.verification import sections
from reports.document import Banner, Prose, Table
from reports.language.locale import Locale

SOURCE = Source("Somebody (1963)", "published", "page 3, read in the paper")
VALUES = (ValueResult("", 1.0, 1.0, "pass"),)
QUANTITY = QuantityResult("period", "s", Tolerance("seven digits are printed", relative=1e-6), VALUES)
CASE = CaseResult("a/b", "A case", "Theory.", "Field.", SOURCE, ("tie",), (), (QUANTITY,))
INDICATIVE = replace(CASE, key="c/d", source=replace(SOURCE, standing="indicative"))
FAILING = replace(CASE, key="e/f", fault="no solution")
ANNEX = VerificationResults(1, describe_program(), False, (CASE,))


def banner(*cases, uses=()):
    """Outcome and headline of an annex of these cases, for a project that uses these words."""
    coverage = tuple(Coverage(use, tuple(each.key for each in cases if use in each.uses)) for use in uses)
    found = sections(replace(ANNEX, cases=cases, coverage=coverage))
    (shown,) = [each for each in found[0].blocks if isinstance(each, Banner)]
    return shown.outcome, Locale().text(shown.headline)


def test_headline_counts_evidence_alone():
    assert banner(CASE) == ("pass", "The 1 solved case agrees with what is compared of its source.")
    assert banner(CASE, replace(CASE, key="g"), INDICATIVE) == (
        "pass",
        "The 2 solved cases that are evidence agree with what is compared of their sources; 1 more is indicative.",
    )
    assert banner(INDICATIVE) == ("incomplete", "The 1 solved case is indicative only: it is no evidence.")
    assert banner(CASE, FAILING)[0] == "fail"


@pytest.mark.parametrize(("uses", "outcome"), [(("tie",), "pass"), (("tie", "arch"), "incomplete")])
def test_annex_of_a_project_with_something_uncovered_is_incomplete(uses, outcome):
    assert banner(CASE, uses=uses)[0] == outcome


def test_coverage_marks_cases_that_cover_nothing():
    cases = (CASE, INDICATIVE, FAILING)
    made = replace(ANNEX, cases=cases, coverage=(Coverage("tie", tuple(each.key for each in cases)),))
    tables = [each for section in sections(made) for each in section.blocks if isinstance(each, Table)]
    (table,) = [each for each in tables if each.name == "coverage"]
    assert Locale().text(table.rows[0][1]) == "a/b, c/d (indicative), e/f (fails)"


def test_one_case_is_no_plural():
    blocks = sections(ANNEX)[0].blocks
    said = " ".join(Locale().text(text) for each in blocks if isinstance(each, Prose) for text in each.paragraphs)
    assert "1 value of 1 quantity in 1 case." in said
    assert "1 cases" not in said
