"""Page 2: where the mechanisms are in the building, the list of those that it can have, revisions and photographs."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from assess.codes.checklists import CHECKLISTS, item_name
from assess.results import ChecklistItem, Results, TieLinkName, TieOutcome
from assess.results.provenance import Revision
from reports.chapters.cells import DEMAND_CAPACITY
from reports.chapters.front_matter import photograph
from reports.document import Block, Cell, Column, Field, Figure, Prose, Section, Table, nonempty, tabulate
from reports.figures import key_plan
from reports.figures.key_plan import BuildingScene
from reports.language.texts import Date, Phrase, Term, Text, Verbatim, count, listing, say, say_count
from reports.mechanisms import mechanism_list, tie_number


def sections(results: Results, building: BuildingScene | None) -> list[Section]:
    """Return the page, after it the revisions where they are given, and the photographs as a chapter of their own.

    building : the bodies of all mechanisms, None where none has geometry
    """
    blocks = (
        *plan(results, building),
        *nonempty(ties_table(results)),
        *nonempty(links_table(results)),
        *_checklist_blocks(results),
    )
    return [
        Section(say("Key plan and list of mechanisms"), 0, blocks, starts_page=True),
        *_revisions(results),
        *_photographs(results),
    ]


def plan(results: Results, building: BuildingScene | None) -> list[Block]:
    """Return the key plan with the mechanisms that it cannot show, or why there is none."""
    if building is None:
        return [Prose((say("The mechanisms are given by parameters, without geometry: there is no key plan."),))]
    model = key_plan.model_of_key_plan(building)
    figure = Figure("key-plan", key_plan.key_plan_caption(building), partial(key_plan.draw_key_plan, building), model)
    undrawn = [each.name for each in results.mechanisms if each.name not in building.mechanisms]
    if not undrawn:
        return [figure]
    mechanisms = mechanism_list(results, undrawn)
    return [
        figure,
        Prose((say("Given by parameters, without geometry, and not drawn: {mechanisms}.", mechanisms=mechanisms),)),
    ]


TIE_OUTCOMES: Mapping[TieOutcome, Phrase] = {
    "elastic": say("elastic"),
    "holds": say("holds"),
    "yields": say("yields"),
    "gone": say("gone"),
    "slack": say("slack"),
    "not counted": say("not counted"),
    "not known": say("not known"),
}
LINKS: Mapping[TieLinkName, Phrase] = {
    "bar": say("bar"),
    "thread": say("thread"),
    "plate": say("plate"),
    "bearing": say("bearing"),
    "punching": say("punching"),
    "sliding": say("sliding units"),
    "between": say("wall between"),
    "far end": say("far end"),
    "far wall": say("far wall"),
    "anchorage": say("anchorage"),
    "strength": say("strength"),
}
NUMBER = Column(say("Tie"), share=0.07)


def ties_table(results: Results) -> Table:
    """Tabulate the ties of the building, a row for each mechanism that one holds; no rows without ties."""
    caption = say(
        "Ties, and what becomes of them at the rotation that the deciding method demands at the site’s own action."
    )
    columns = (
        NUMBER,
        Column(say("Holds")),
        Column(say("As")),
        Column(say("At the demand")),
        Column(say("Elongation"), "length", 3),
        Column(say("of which plastic"), "length", 3),
        Column(say("Pull"), "force", 3),
        Column(say("D/C"), figures=3),
        Column(say("Governing link")),
    )
    rows: list[tuple[Cell, ...]] = []
    for place, tie in enumerate(results.ties, start=1):
        number, drawn = Verbatim(tie_number(place)), Verbatim(tie.body) if tie.body else None
        rows += [
            (
                number,
                mechanism_list(results, [each.mechanism]),
                Verbatim(each.load),
                TIE_OUTCOMES[each.outcome],
                each.elongation_m,
                each.plastic_m,
                each.pull_n,
                None if each.governing is None else each.governing.ratio,
                None if each.governing is None else LINKS[each.governing.name],
            )
            for each in tie.held
        ] or [(number, None, drawn, TIE_OUTCOMES["not counted"], *[None] * 5)]
    return Table("ties", caption, columns, tuple(rows), small=True)


def links_table(results: Results) -> Table:
    """Tabulate pull over design strength of each link of each tie; no rows without links."""
    names = list(dict.fromkeys(link.name for tie in results.ties for each in tie.held for link in each.links))
    caption = say(
        "D/C of each link of the ties: the pull at the demand over its design strength, of the bar A · f_y / 1.05. A "
        "bar that yields has 1.05, as is meant of a ductile tie; above 1 any other link is exceeded. Links without a "
        "value have no limit, or are not answered."
    )
    columns = (NUMBER, Column(say("Holds")), *(Column(LINKS[name], figures=3) for name in names))
    rows: list[tuple[Cell, ...]] = []
    for place, tie in enumerate(results.ties, start=1):
        for each in tie.held:
            ratios = {link.name: link.ratio for link in each.links}
            held = mechanism_list(results, [each.mechanism])
            if ratios:
                rows.append((Verbatim(tie_number(place)), held, *(ratios.get(name) for name in names)))
    return Table("tie-links", caption, columns, tuple(rows), small=True)


def checklist_table(results: Results) -> Table:
    """Tabulate the items of the list, those that are absent in grey."""
    items = results.report.checklist
    fields: list[Field[ChecklistItem]] = [
        (Column(say("Possible mechanism"), share=0.45), lambda item: item_text(results, item)),
        (Column(say("Here")), lambda item: item_outcome(results, item)),
    ]
    if any(item.number is not None for item in items):
        fields.insert(0, (Column(say("No."), share=0.06), _item_number))
    caption = _checklist_caption(results)
    return tabulate("checklist", caption, fields, items, muted=lambda item: item.outcome == "absent", small=True)


def item_text(results: Results, item: ChecklistItem) -> Text:
    """Return what an item of the list is called."""
    return Term(item_name(results.report.building_type, item.key))


def item_outcome(results: Results, item: ChecklistItem) -> Text:
    """Return what became of an item."""
    if item.outcome == "absent":
        return say("absent")
    numbers = mechanism_list(results, item.mechanisms)
    if item.outcome == "examined":
        return say("examined ({mechanisms})", mechanisms=numbers) if item.mechanisms else say("examined")
    return _not_examined(item, numbers)


def not_examined_text(results: Results) -> Text | None:
    """Return the items that are possible and were not examined, the first of many; None where there are none."""
    struck = [say("{mechanism} (struck out)", mechanism=Verbatim(name)) for name, _ in results.report.struck_out]
    if not results.report.checklist:
        unknown = say("not stated: the project does not say which mechanisms the building can have")
        return listing([*struck, unknown]) if struck else unknown
    items = [*struck, *(item_text(results, item) for item in results.report.not_examined)]
    if not items:
        return None
    shown = items if len(items) <= MAX_NAMED + 1 else items[:MAX_NAMED]
    more = len(items) - len(shown)
    return listing([*shown, say_count("{number} other", "{number} others", more)] if more else shown)


def checklist_meaning(results: Results) -> Text:
    """Return what the list means for the index of the building."""
    if not results.report.checklist:
        return say(
            "The project does not say which mechanisms a building of this type can have: the verdict holds for the "
            "mechanisms examined and says nothing of others."
        )
    number = results.report.number_left_out
    index = None if results.verdict is None else results.verdict.index
    if index is None:
        return _meaning_without_index(number)
    if not number:
        return say(
            "Every mechanism of this list is examined or absent. The index of the building is that of its local "
            "mechanisms; the response of the building as a whole is not part of this report."
        )
    if index.name == DEMAND_CAPACITY:
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


def _revisions(results: Results) -> list[Section]:
    given = results.report.revisions
    if not given:
        return []
    fields: tuple[Field[Revision], ...] = (
        (Column(say("Revision"), share=0.12), lambda each: Verbatim(each.number)),
        (Column(say("Date"), share=0.16), lambda each: Date(each.date)),
        (Column(say("Description")), lambda each: Verbatim(each.description)),
        (Column(say("By"), share=0.22), lambda each: Verbatim(each.author)),
    )
    return [Section(say("Revisions"), 1, (tabulate("revisions", say("Issues of this report."), fields, given),))]


def _photographs(results: Results) -> list[Section]:
    pictures = results.report.figures
    blocks = tuple(photograph(each, f"photograph-{place:02d}") for place, each in enumerate(pictures, start=1))
    return [Section(say("Photographs"), 0, blocks)] if blocks else []


MAX_NAMED = 6  # items that page 1 names
IN_PLANE = frozenset(each.key for items in CHECKLISTS.values() for each in items if each.in_plane)


def _checklist_blocks(results: Results) -> list[Block]:
    """Return the list, and what it means for the index of the building."""
    struck = [
        say("Struck out: {mechanism}: {reason}", mechanism=Verbatim(name), reason=Verbatim(reason))
        for name, reason in results.report.struck_out
    ]
    table = [checklist_table(results)] if results.report.checklist else []
    return [*table, *(Prose((each,)) for each in struck), Prose((checklist_meaning(results),))]


def _checklist_caption(results: Results) -> Text:
    if results.report.building_type == "church":
        return say("Mechanisms that a church can have, by the numbers of the Italian survey form.")
    return say("Local mechanisms that a house can have.")


def _item_number(item: ChecklistItem) -> Cell:
    return None if item.number is None else count(item.number)


def _not_examined(item: ChecklistItem, numbers: Text) -> Text:
    if item.reason and item.mechanisms:
        reason = Verbatim(item.reason)
        return say("possible, examined in part ({mechanisms}): {reason}", mechanisms=numbers, reason=reason)
    if item.reason:
        return say("possible, not examined: {reason}", reason=Verbatim(item.reason))
    if item.key in IN_PLANE:
        return say("possible, not examined: this program does not assess walls in their plane")
    return say("not stated; counts as possible, not examined")


def _meaning_without_index(number: int) -> Text:
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
