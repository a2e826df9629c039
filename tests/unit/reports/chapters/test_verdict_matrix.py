"""The matrix of page 1 has a row for each mechanism and no more columns than a page holds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from assess.codes.check import NumericalSpread, Outcome, Reason, reason_message
from assess.codes.verdict import Index
from assess.results import Results
from reports.chapters import comparison, recommendations, verdict
from reports.chapters.cells import margin_text
from reports.document import OutcomeCell, Table
from tests.support.letters import letters, rows
from tests.support.sample_results import with_verdict

JudgedAt = Callable[[Results, float], Results]
PROCEDURES = ("ntc2018-linear", "ntc2018-nonlinear", "ntc2018-history", "nzsee2017-face-loaded", "asce41-13-ht")


def matrix(results: Results) -> Table:
    assert results.verdict is not None
    return verdict.matrix(results, results.verdict)


def headings(results: Results) -> list[str]:
    return [letters(column.label) for column in matrix(results).columns]


def with_more(results: Results, procedures: tuple[str, ...], ratio: float = 2.5) -> Results:
    """The results with checks of more procedures on the first mechanism, at the site's own action."""
    assert results.verdict is not None
    first = results.mechanisms[0]
    like = next(check for check in first.checks if check.level_pga_g == results.verdict.action.pga_g)
    more = tuple(replace(like, procedure=name, role="comparison", ratio=ratio) for name in procedures)
    return replace(results, mechanisms=(replace(first, checks=first.checks + more), *results.mechanisms[1:]))


def test_each_mechanism_has_a_row_with_its_number(results: Results) -> None:
    assert [row[0] for row in rows(matrix(results))] == ["M1 Wall 6, eroded base", "M2 parapet"]


def test_the_deciding_answer_alone_has_a_colour(results: Results, judged_at: JudgedAt) -> None:
    table = matrix(judged_at(results, 0.45))
    for row, outcome in zip(table.rows, ("pass", "fail"), strict=True):
        graded = [cell.outcome for cell in row[2:] if isinstance(cell, OutcomeCell)]
        assert graded.count(outcome) == 1
        assert set(graded) <= {outcome, "comparison"}


def test_readings_of_the_thesis_have_no_column(results: Results) -> None:
    assert not any("thesis" in heading for heading in headings(results))


def test_a_method_that_answers_for_nobody_has_no_column(results: Results) -> None:
    silent = with_more(results, ("asce41-13-ht",))
    first = silent.mechanisms[0]
    checks = tuple(
        replace(each, verdict=Outcome.NOT_APPLICABLE) if each.procedure == "asce41-13-ht" else each
        for each in first.checks
    )
    silent = replace(silent, mechanisms=(replace(first, checks=checks), *silent.mechanisms[1:]))
    assert not any("ASCE 41-13" in heading for heading in headings(silent))


def test_many_methods_share_a_column_with_the_largest_of_their_answers(results: Results) -> None:
    many = with_more(results, PROCEDURES)
    table = matrix(many)
    assert len(table.columns) == verdict.MAX_COLUMNS
    assert letters(table.columns[-1].label) == "Largest D/C of the other methods"
    assert rows(table)[0][-1].startswith("2.5 (")
    assert rows(table)[1][-1] != ""


def test_the_index_of_the_code_has_a_column_unless_it_is_the_ratio(results: Results) -> None:
    assert "ζ_E" not in headings(results)
    indexed = with_verdict(results, index=Index("zeta_E", 0.8))
    assert headings(indexed)[3] == "ζ_E"


def test_words_stand_for_answers_without_a_number(results: Results) -> None:
    like = results.mechanisms[0].checks[0]
    assert letters(verdict.ratio_text(replace(like, verdict=Outcome.PASS, ratio=0.0))) == "no rocking"
    assert letters(verdict.ratio_text(replace(like, verdict=Outcome.PASS, ratio=4e-5))) == "below 0.001"
    assert letters(verdict.ratio_text(replace(like, verdict=Outcome.NOT_ANSWERED))) == "not answered"
    fallen = replace(like, verdict=Outcome.FAIL, ratio=None, demand=None, reason=reason_message(Reason.OVERTURNS))
    assert letters(verdict.ratio_text(fallen)) == "overturns"
    beyond = replace(fallen, reason=reason_message(Reason.BEYOND_SPECTRUM))
    assert letters(verdict.ratio_text(beyond)) == "beyond the spectrum"


@pytest.mark.parametrize(
    ("ratio", "margin", "shown"), [(0.4591, 1.196, ("0.5", "1.2", "–")), (0.9613, 0.983, ("0.96", "0.98", "1.02"))]
)
def test_histories_have_no_more_digits_than_stand(
    results: Results, judged_at: JudgedAt, ratio: float, margin: float, shown: tuple[str, str, str]
) -> None:
    """Histories decide the second mechanism, of which one figure of the ratio stands."""
    judged = judged_at(results, 0.45)
    assert judged.verdict is not None
    pga, (first, second) = judged.verdict.action.pga_g, judged.mechanisms
    numerical = NumericalSpread(9, 500, 1, 1.0, 0.8 * ratio, ratio, margin * pga, 1.16 * margin * pga)
    deciding = judged.verdict.mechanisms[1].answers[0].procedure
    changes = {"ratio": ratio, "demand": 0.1, "rotation_ratio": 0.3, "numerical": numerical}
    checks = tuple(
        replace(each, **changes, capacity_pga_g=margin * pga) if each.procedure == deciding else each  # type: ignore[arg-type]
        for each in second.checks
    )
    own = replace(judged.verdict.mechanisms[1], margin=margin, margin_most=1.16 * margin)
    spread = with_verdict(
        replace(judged, mechanisms=(first, replace(second, checks=checks))),
        mechanisms=(judged.verdict.mechanisms[0], own),
    )
    row = rows(matrix(spread))[1]
    assert shown[0] in row
    assert row[2].endswith(f"{shown[1]} × the site’s")
    assert " to " in row[2]
    text = margin_text(own, judged.verdict.action)
    assert text is not None
    assert letters(text) == row[2]
    compared = rows(comparison.ratios_table(spread))[1]
    assert compared[-2] == shown[1]
    (lacking,) = (b for b in recommendations.sections(spread)[0].blocks if isinstance(b, Table))
    held, factor = rows(lacking)[-1][1], rows(lacking)[-1][3]
    assert held == row[2].partition(",")[0]
    assert factor == shown[2]
