"""The list of possible mechanisms says what became of each item, and what that means for the index."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.codes.verdict import Index
from assess.results import ChecklistItem, ReportMatter, Results
from reports.chapters import key_plan
from tests.support.letters import letters, lines, rows
from tests.support.sample_results import with_verdict

GABLE = ChecklistItem("gable", None, "examined", ("parapet",))
CORNER = ChecklistItem("corner", None, "absent")
LEAF = ChecklistItem("outer-leaf", None, "not-examined", reason="no core <b>drilled</b>")
CHIMNEY = ChecklistItem("chimney", None, "not-examined", spoken_for=False)
IN_PLANE = ChecklistItem("in-plane", None, "not-examined", spoken_for=False)


def house(results: Results, *items: ChecklistItem) -> Results:
    return replace(results, report=ReportMatter(building_type="house", checklist=items))


@pytest.mark.parametrize(
    ("item", "said"),
    [
        (GABLE, "examined (M2)"),
        (CORNER, "absent"),
        (LEAF, "possible, not examined: no core <b>drilled</b>"),
        (CHIMNEY, "not stated; counts as possible, not examined"),
        (IN_PLANE, "possible, not examined: this program does not assess walls in their plane"),
        (replace(LEAF, mechanisms=("wall-6",), reason="north only"), "possible, examined in part (M1): north only"),
    ],
)
def test_each_item_says_what_became_of_it(results: Results, item: ChecklistItem, said: str) -> None:
    assert letters(key_plan.item_outcome(house(results, item), item)) == said


def test_a_church_has_the_numbers_of_the_form(results: Results) -> None:
    items = (ChecklistItem("facade", 1, "absent"), ChecklistItem("apse", 16, "absent"))
    church = replace(results, report=ReportMatter(building_type="church", checklist=items))
    table = key_plan.checklist_table(church)
    assert rows(table) == [["1", "overturning of the façade", "absent"], ["16", "overturning of the apse", "absent"]]
    assert table.muted == {0, 1}


@pytest.mark.parametrize(
    ("items", "said"),
    [
        ((GABLE, CORNER), "Every mechanism of this list is examined or absent."),
        ((GABLE, LEAF), "1 possible mechanism was not examined and may have a lower one"),
        ((CHIMNEY, LEAF), "2 possible mechanisms were not examined"),
    ],
)
def test_the_index_is_at_most_where_something_is_left(
    results: Results, items: tuple[ChecklistItem, ...], said: str
) -> None:
    share = with_verdict(results, index=Index("zeta_E", 0.4))
    assert said in letters(key_plan.checklist_meaning(house(share, *items)))


def test_a_ratio_is_at_least(results: Results) -> None:
    ratio = with_verdict(results, index=Index("D/C", 0.4))
    assert "at least the largest" in letters(key_plan.checklist_meaning(house(ratio, LEAF)))


@pytest.mark.parametrize(
    ("items", "said"),
    [
        ((GABLE,), "Every mechanism of this list is examined or absent. The response of the building"),
        ((GABLE, LEAF), "1 possible mechanism was not examined: the verdict says nothing of it."),
    ],
)
def test_what_is_left_bounds_no_index_where_there_is_none(
    results: Results, items: tuple[ChecklistItem, ...], said: str
) -> None:
    without = with_verdict(results, index=None)
    for each in (without, replace(results, verdict=None)):
        words = letters(key_plan.checklist_meaning(house(each, *items)))
        assert words.startswith(said)
        assert "index" not in words


def test_without_a_list_the_page_says_that_nobody_gave_one(results: Results) -> None:
    bare = replace(results, mechanisms=results.mechanisms[1:])
    said = lines(key_plan.sections(bare, None))
    assert any("does not say which mechanisms" in line for line in said)
    assert any("there is no key plan" in line for line in said)


def test_many_items_are_counted_on_page_1(results: Results) -> None:
    many = tuple(replace(CHIMNEY, key=key) for key in ("gable", "corner", "parapet", "chimney", "outer-leaf") * 2)
    said = key_plan.not_examined_text(house(results, *many))
    assert said is not None
    assert letters(said).endswith("and 4 others")
    assert key_plan.not_examined_text(house(results, GABLE, CORNER)) is None
