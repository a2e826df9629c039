"""The page of both states: its numbers are those of the results, and it names what changed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.results import Results
from reports.chapters import before_and_after
from reports.chapters.cells import return_period_text
from reports.document import OutcomeCell
from reports.language.locale import Locale
from reports.language.texts import Quantity
from tests.support.facade import with_ties

ENGLISH, ITALIAN = Locale(), Locale("it")


def words(results: Results, locale: Locale = ENGLISH) -> str:
    """What the page says below its figure."""
    (page,) = before_and_after.sections(results)
    return " ".join(map(locale.text, page.blocks[3].paragraphs))


def test_the_page_lists_what_differs_of_the_two_states():
    (page,) = before_and_after.sections(with_ties())
    table = page.blocks[-1]
    assert [row[0].text for row in table.rows] == [f"mechanisms.facade.loads[{n}]" for n in (1, 2)]


def test_results_without_a_state_before_have_no_such_page():
    assert before_and_after.sections(replace(with_ties(), before=None)) == []
    assert before_and_after.states_table(replace(with_ties(), before=None)).rows == ()


def test_each_mechanism_has_a_row_for_each_state_with_the_numbers_of_the_results():
    results = with_ties()
    rows = before_and_after.states_table(results).rows
    assert [ENGLISH.text(row[1]) for row in rows] == ["before", "after"] * 2
    held = {each.mechanism: each for each in results.before.mechanisms}
    assert rows[0][4] == held["facade"].capacity_pga_g
    assert rows[0][2] == OutcomeCell("fail", rows[0][2].text)
    assert isinstance(rows[0][3], Quantity)
    assert rows[0][3].value == held["facade"].index.value
    (verdict,) = [each for each in results.verdict.mechanisms if each.mechanism == "facade"]
    assert rows[1][4] == pytest.approx(verdict.margin * results.verdict.action.pga_g)


def test_the_page_names_the_weakest_and_that_no_index_falls():
    assert words(with_ties()) == (
        "The weakest was M1 Façade, from its foot; it is M2 Gable above the eaves now. "
        "The works lower no index that is known in both states."
    )
    assert words(with_ties(), ITALIAN).startswith("Il più debole era M1 Façade, from its foot; ora è M2")


def test_new_and_gone_mechanisms_and_indices_that_fall_are_named():
    results = with_ties()
    facade, gable = results.before.mechanisms
    better = replace(facade, index=replace(facade.index, value=3.0))
    before = replace(results.before, mechanisms=(better, replace(gable, mechanism="parapet", label="Old parapet")))
    said = words(replace(results, before=before))
    assert "The works lower the index of M1 Façade, from its foot." in said
    assert "Not examined before the works: M2 Gable above the eaves." in said
    assert "Examined before the works alone: Old parapet." in said
    rows = before_and_after.states_table(replace(results, before=before)).rows
    assert [ENGLISH.text(row[2]) for row in rows if not isinstance(row[2], OutcomeCell)] == ["not examined"] * 2


def test_histories_of_both_states_by_other_records_are_told():
    results = with_ties()
    before = replace(results.before, suite=(("a", 1.0),))
    history = [
        replace(check, procedure="ntc2018-history") if check.role == "deciding" else check
        for check in results.mechanisms[0].checks
    ]
    after = replace(results, mechanisms=(replace(results.mechanisms[0], checks=tuple(history)), results.mechanisms[1]))
    assert "by other records or scale factors" in words(replace(after, before=before))
    assert "by other records" not in words(replace(results, before=before))


@pytest.mark.parametrize(
    ("years", "bound", "shown"),
    [
        (None, "", "not known"),
        (266.7, "", "267 years"),
        (2475.0, ">=", "2475 years or more"),
        (30.0, "<=", "30 years or less"),
    ],
)
def test_the_return_period_of_a_capacity_is_a_bound_beyond_the_hazard_and_unknown_without_one(years, bound, shown):
    assert ENGLISH.text(return_period_text(years, bound)).replace("\N{NO-BREAK SPACE}", " ") == shown


def test_the_figure_has_axes_units_and_both_states():
    (page,) = before_and_after.sections(with_ties())
    figure = page.blocks[2].draw(ENGLISH)
    (axes,) = figure.axes
    assert axes.get_xlabel() == "peak ground acceleration at capacity [g]"
    bars = [bar.get_width() for container in axes.containers for bar in container]
    after = [each.margin * with_ties().verdict.action.pga_g for each in with_ties().verdict.mechanisms]
    assert bars == pytest.approx([each.capacity_pga_g for each in with_ties().before.mechanisms] + after)
