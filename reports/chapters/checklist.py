"""The list of mechanisms that a building of this type can have: examined, absent, or possible and not examined."""

from __future__ import annotations

from assess.codes.checklists import CHECKLISTS, item_name
from assess.results import ChecklistItem, Results
from reports.chapters.index_text import RATIO
from reports.chapters.mechanism_list import mechanism_list
from reports.document import Block, Cell, Column, Prose, Table
from reports.language.texts import Term, Text, Verbatim, count, listing, say, say_count

MANY = 6  # items that page 1 names
IN_PLANE = frozenset(each.key for items in CHECKLISTS.values() for each in items if each.in_plane)


def blocks(results: Results) -> list[Block]:
    """Return the list, and what it means for the index of the building."""
    return [*([table(results)] if results.report.checklist else []), Prose((meaning(results),))]


def table(results: Results) -> Table:
    """Tabulate the items of the list, those that are absent in grey."""
    items = results.report.checklist
    numbered = any(item.number is not None for item in items)
    columns = [Column(say("No."), share=0.06)] if numbered else []
    columns += [Column(say("Possible mechanism"), share=0.45), Column(say("Here"))]
    rows = tuple(
        (*((_number(item),) if numbered else ()), name_of(results, item), state(results, item)) for item in items
    )
    absent = frozenset(place for place, item in enumerate(items) if item.outcome == "absent")
    return Table("checklist", _caption(results), tuple(columns), rows, absent, small=True)


def _caption(results: Results) -> Text:
    if results.report.building_type == "church":
        return say("Mechanisms that a church can have, by the numbers of the Italian survey form.")
    return say("Local mechanisms that a house can have.")


def _number(item: ChecklistItem) -> Cell:
    return None if item.number is None else count(item.number)


def name_of(results: Results, item: ChecklistItem) -> Text:
    """Return what an item of the list is called."""
    return Term(item_name(results.report.building_type, item.key))


def state(results: Results, item: ChecklistItem) -> Text:
    """Return what became of an item."""
    if item.outcome == "absent":
        return say("absent")
    numbers = mechanism_list(results, item.mechanisms)
    if item.outcome == "examined":
        return say("examined ({mechanisms})", mechanisms=numbers) if item.mechanisms else say("examined")
    return _not_examined(item, numbers)


def _not_examined(item: ChecklistItem, numbers: Text) -> Text:
    if item.reason and item.mechanisms:
        reason = Verbatim(item.reason)
        return say("possible, examined in part ({mechanisms}): {reason}", mechanisms=numbers, reason=reason)
    if item.reason:
        return say("possible, not examined: {reason}", reason=Verbatim(item.reason))
    if item.key in IN_PLANE:
        return say("possible, not examined: this program does not assess walls in their plane")
    return say("not stated; counts as possible, not examined")


def not_examined_text(results: Results) -> Text | None:
    """Return the items that are possible and were not examined, the first of many; None where there are none."""
    if not results.report.checklist:
        return say("not stated: the project does not say which mechanisms the building can have")
    items = results.report.not_examined
    if not items:
        return None
    kept = items if len(items) <= MANY + 1 else items[:MANY]
    shown = [name_of(results, item) for item in kept]
    more = len(items) - len(kept)
    return listing([*shown, say_count("{number} other", "{number} others", more)] if more else shown)


def meaning(results: Results) -> Text:
    """Return what the list means for the index of the building."""
    if not results.report.checklist:
        return say(
            "The project file does not say which mechanisms a building of this type can have (building_type in "
            "[report]): the verdict holds for the mechanisms examined and says nothing of others."
        )
    number = len(results.report.not_examined)
    index = None if results.verdict is None else results.verdict.index
    if index is None:
        return _of_no_index(number)
    if not number:
        return say(
            "Every mechanism of this list is examined or absent. The index of the building is that of its local "
            "mechanisms; the response of the building as a whole is not part of this report."
        )
    if index.name == RATIO:
        return say_count(
            "The ratio D/C of the building is at least the largest one of the mechanisms examined: {number} possible "
            "mechanism was not examined and may have a larger one.",
            "The ratio D/C of the building is at least the largest one of the mechanisms examined: {number} possible "
            "mechanisms were not examined, and one of them may have a larger one.",
            number,
        )
    return say_count(
        "The index of the building is at most the least one of the mechanisms examined: {number} possible mechanism "
        "was not examined and may have a lower one.",
        "The index of the building is at most the least one of the mechanisms examined: {number} possible mechanisms "
        "were not examined, and one of them may have a lower one.",
        number,
    )


def _of_no_index(number: int) -> Text:
    """Return what the list means where the building has no index. number: of mechanisms not examined."""
    if not number:
        return say(
            "Every mechanism of this list is examined or absent. The response of the building as a whole is not part "
            "of this report."
        )
    return say_count(
        "{number} possible mechanism was not examined: the verdict says nothing of it.",
        "{number} possible mechanisms were not examined: the verdict says nothing of them.",
        number,
    )
