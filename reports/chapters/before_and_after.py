"""The page that sets the state before the works beside the one after: what each mechanism holds, and which is weakest.

Mechanisms are one where they have one name; those of one state alone are named as new, or as not examined any more.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import chain

from assess.codes.works import SAME_INDEX
from assess.results import CapacitiesResult, CapacityResult, Results
from assess.results.before import state_of
from reports.chapters import cells
from reports.document import Block, Cell, Column, Facts, Field, Figure, OutcomeCell, Prose, Section, Table, tabulate
from reports.figures import before_and_after as figure
from reports.language.texts import Text, Verbatim, listing, quantity, say
from reports.mechanisms import procedure_title, title_in_either_state

NOT_EXAMINED = say("not examined")
StateOfMechanism = tuple[str, Text, CapacityResult | None]
"""A mechanism by its name, which state, and what it holds there."""


def sections(results: Results) -> list[Section]:
    """Return the page; none where the project names no state before."""
    before, after = results.before, state_of(results)
    if before is None or after is None:
        return []
    caption = say(
        "PGA up to which each mechanism holds before and after the works, by the method that decides; the line is the "
        "site’s own action. Where there is no bar, it is not known."
    )
    blocks: tuple[Block, ...] = (
        Facts(tuple(_facts(results, before, after))),
        states_table(results),
        Figure("before-and-after", caption, partial(figure.draw_states, results)),
        Prose(tuple(findings(results, before, after))),
        *_differences(before),
    )
    return [Section(say("Before and after the works"), 0, blocks, starts_page=True)]


def states_table(results: Results) -> Table:
    """Tabulate what each mechanism holds, before and after the works; no rows without a state before."""
    before, after = results.before, state_of(results)
    fields: list[Field[StateOfMechanism]] = [
        (Column(say("Mechanism"), share=0.22), lambda row: title_in_either_state(results, row[0])),
        (Column(say("State")), lambda row: row[1]),
        (Column(say("Verdict")), lambda row: _outcome_cell(row[2])),
        (Column(_index_title(after)), lambda row: _index_cell(row[2])),
        (Column(say("Holds up to PGA"), "ground acceleration", 3), lambda row: _pga_cell(row[2])),
        (Column(say("Return period of the capacity")), lambda row: _years_cell(row[2])),
        (Column(say("Deciding method")), lambda row: _method_cell(row[2])),
    ]
    caption = say("Each mechanism before and after the works, both at the site’s own action.")
    rows = [] if before is None or after is None else list(_rows(before, after))
    return tabulate("before-and-after", caption, fields, rows, small=True)


def _differences(before: CapacitiesResult) -> Iterator[Table]:
    """Yield the table of what differs of the building and of its loads; none where nothing does."""
    if before.differences:
        caption = say(
            "What differs between the two states: values of the building, which are to be the same, and works."
        )
        columns = (Column(say("Where"), share=0.45), Column(say("Message")))
        rows = tuple((Verbatim(each.where), each) for each in before.differences)
        yield Table("differences-before", caption, columns, rows, small=True)


def findings(results: Results, before: CapacitiesResult, after: CapacitiesResult) -> Iterator[Text]:
    """Yield which mechanism is the weakest now, whose index falls, which are new, and which are not examined any more.

    Parameters
    ----------
    results : of the state after
    before, after : the two states
    """
    if before.weakest and after.weakest == before.weakest:
        yield say("{mechanism} stays the weakest.", mechanism=title_in_either_state(results, after.weakest))
    elif before.weakest and after.weakest:
        yield say(
            "The weakest was {before}; it is {after} now.",
            before=title_in_either_state(results, before.weakest),
            after=title_in_either_state(results, after.weakest),
        )
    falls = [each.mechanism for each in after.mechanisms if _falls(before.of(each.mechanism), each)]
    if falls:
        yield say("The works lower the index of {mechanisms}.", mechanisms=_titles(results, falls))
    elif before.index is not None and after.index is not None:
        yield say("The works lower no index that is known in both states.")
    new = [each.mechanism for each in after.mechanisms if before.of(each.mechanism) is None]
    if new:
        yield say("Not examined before the works: {mechanisms}.", mechanisms=_titles(results, new))
    gone = [each.mechanism for each in before.mechanisms if after.of(each.mechanism) is None]
    if gone:
        yield say("Examined before the works alone: {mechanisms}.", mechanisms=_titles(results, gone))
    if before.suite and after.suite and before.suite != after.suite:
        yield say("Histories decide in both states, by other records or scale factors: the spectrum alone is the same.")


def _facts(results: Results, before: CapacitiesResult, after: CapacitiesResult) -> Iterator[tuple[Text, Text]]:
    """Yield the works, the index of the building in both states with the target, and the results compared with."""
    verdict = results.verdict
    works = cells.works_text(results)
    if works is not None:
        yield say("Works"), works
    for label, state in ((say("Before"), before), (say("After"), after)):
        outcome: Text = cells.outcome_text(state.outcome)
        if state.index is not None:
            outcome = say("{outcome}, at most {index}", outcome=outcome, index=cells.index_text(state.index))
        yield label, outcome
    target = None if verdict is None else cells.target_text(verdict)
    if target is not None:
        yield say("Target"), target
    title = before.title or before.path
    words = say("{title}, stamp {stamp}", title=Verbatim(title), stamp=Verbatim(before.stamp))
    yield say("State before, by the same hazard"), words if before.stamp else Verbatim(title)


def _rows(before: CapacitiesResult, after: CapacitiesResult) -> Iterator[StateOfMechanism]:
    for name in dict.fromkeys(each.mechanism for each in chain(after.mechanisms, before.mechanisms)):
        yield name, say("before"), before.of(name)
        yield name, say("after"), after.of(name)


def _falls(before: CapacityResult | None, after: CapacityResult) -> bool:
    if before is None or before.index is None or after.index is None or before.index.name != after.index.name:
        return False
    one, other = before.index.value, after.index.value
    if after.index.name == cells.DEMAND_CAPACITY:
        one, other = other, one
    return other < one * (1.0 - SAME_INDEX)


def _titles(results: Results, names: list[str]) -> Text:
    return listing(title_in_either_state(results, name) for name in names)


def _outcome_cell(found: CapacityResult | None) -> Cell:
    if found is None:
        return NOT_EXAMINED
    return OutcomeCell(found.outcome.value, cells.outcome_text(found.outcome, near=found.at_the_limit))


def _index_title(after: CapacitiesResult | None) -> Text:
    known = [each.index.name for each in (() if after is None else after.mechanisms) if each.index is not None]
    return cells.index_symbol(known[0]) if known else say("Index")


def _index_cell(found: CapacityResult | None) -> Cell:
    if found is None or found.index is None:
        return None
    return quantity(found.index.value, figures=found.index.figures)


def _pga_cell(found: CapacityResult | None) -> Cell:
    return None if found is None else found.capacity_pga_g


def _years_cell(found: CapacityResult | None) -> Cell:
    return None if found is None else cells.return_period_text(found.return_period_years, found.return_period_bound)


def _method_cell(found: CapacityResult | None) -> Cell:
    return procedure_title(found.procedure) if found is not None and found.procedure else None
