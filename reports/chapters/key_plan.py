"""Page 2: where the mechanisms are in the building, which ones it can have besides, revisions and photographs."""

from __future__ import annotations

from functools import partial

from assess.results import Results
from reports.chapters import checklist
from reports.chapters.front_matter import photograph
from reports.chapters.mechanism_list import mechanism_list
from reports.document import Block, Column, Figure, Prose, Section, Table
from reports.figures import key_plan
from reports.figures.building import Building
from reports.language.texts import Verbatim, say


def sections(results: Results, building: Building | None) -> list[Section]:
    """Return the page, after it the revisions where they are given, and the photographs as a chapter of their own.

    building : the bodies of all mechanisms, None where none has geometry
    """
    blocks = (*plan(results, building), *checklist.blocks(results))
    return [
        Section(say("Key plan and list of mechanisms"), 0, blocks, starts_page=True),
        *_revisions(results),
        *_photographs(results),
    ]


def plan(results: Results, building: Building | None) -> list[Block]:
    """Return the key plan with the mechanisms that it cannot show, or why there is none."""
    if building is None:
        return [Prose((say("The mechanisms are given by parameters, without geometry: there is no key plan."),))]
    model = key_plan.model_of_key_plan(building)
    figure = Figure("key-plan", key_plan.caption(building), partial(key_plan.draw, building), model)
    undrawn = [each.name for each in results.mechanisms if each.name not in building.mechanisms]
    if not undrawn:
        return [figure]
    mechanisms = mechanism_list(results, undrawn)
    return [
        figure,
        Prose((say("Given by parameters, without geometry, and not drawn: {mechanisms}.", mechanisms=mechanisms),)),
    ]


def _revisions(results: Results) -> list[Section]:
    given = results.report.revisions
    if not given:
        return []
    columns = (
        Column(say("Revision"), share=0.12),
        Column(say("Date"), share=0.16),
        Column(say("Description")),
        Column(say("By"), share=0.22),
    )
    rows = tuple(
        (Verbatim(each.number), Verbatim(each.date), Verbatim(each.description), Verbatim(each.author))
        for each in given
    )
    return [Section(say("Revisions"), 1, (Table("revisions", say("Issues of this report."), columns, rows),))]


def _photographs(results: Results) -> list[Section]:
    pictures = results.report.figures
    blocks = tuple(photograph(each, f"photograph-{place:02d}") for place, each in enumerate(pictures, start=1))
    return [Section(say("Photographs"), 0, blocks)] if blocks else []
