"""What follows from the results: what would make a mechanism pass, what to survey first, what is left to check."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assess.codes.check import Family
from assess.codes.procedures import family_of
from assess.codes.verdict import Decision, MechanismVerdict, Verdict
from assess.results import Results, SensitivityResult
from reports.chapters import cells, key_plan
from reports.chapters.sensitivity import (
    BOUNDS,
    answer_text,
    changes_outcome,
    input_name,
    is_negligible,
    span,
    value_text,
)
from reports.document import Block, BulletList, Cell, Column, Prose, Section, Table, nonempty
from reports.language.texts import Text, listing, quantity, say
from reports.mechanisms import mechanism_list, numbered_title


def sections(results: Results) -> list[Section]:
    """Return the chapter."""
    verdict = results.verdict
    if verdict is None:
        return []
    blocks: list[Block] = [
        *_failing(results, verdict),
        *_missing(results, verdict),
        *_titled(say("To be shown, since a pass depends on it:"), cells.condition_texts(results, verdict.conditions)),
        *_titled(say("To survey first:"), list(survey(results, verdict))),
        *_titled(say("To examine next:"), list(_next_checks(results))),
    ]
    if verdict.outcome == Decision.PASS:
        nothing = say("At the site’s own action no mechanism examined requires strengthening.")
        to_target = say("No mechanism examined requires strengthening to reach the target.")
        blocks.insert(0, Prose((to_target if cells.has_reduced_target(verdict) else nothing,)))
    return [Section(say("Recommendations"), 0, tuple(blocks))]


def survey(results: Results, verdict: Verdict) -> Iterator[Text]:
    """Yield the number that moves the deciding answer of each mechanism most, and what lies at the limit."""
    near = [one.mechanism for one in verdict.mechanisms if one.at_the_limit]
    if near:
        yield say(
            "thickness and position of the hinges of {mechanisms}: the answer is at the limit, within 5 % or within "
            "what the tolerance of the survey changes",
            mechanisms=mechanism_list(results, near),
        )
    yield from _strongest_inputs(results)
    if not results.sensitivity:
        yield say("what moves the answers most, which a sensitivity study would show: none was made")


def _titled(title: Text, points: Sequence[Text]) -> list[Block]:
    return [Prose((title,)), BulletList(tuple(points))] if points else []


def _missing(results: Results, verdict: Verdict) -> list[Block]:
    """Return what is missing in a verdict that is not open: that of an open one is on page 1."""
    if verdict.outcome == Decision.INCOMPLETE:
        return []
    return _titled(say("To be given for the mechanisms without an answer:"), cells.missing_texts(results, verdict))


def _failing(results: Results, verdict: Verdict) -> list[Block]:
    """Return by how much the mechanisms that fail must resist more, the worst first."""
    failing = [one for one in verdict.mechanisms if one.outcome == Decision.FAIL]
    if not failing:
        return []
    words = say(
        "The table gives the factor by which the PGA that each failing mechanism bears has to grow, by the method "
        "that decides. Works that provide it (ties, anchorage, restraint of thrusts, more thickness) are to be "
        "designed, and the mechanism is to be assessed again with them: they change the mechanism, not only its "
        "resistance."
    )
    ordered = sorted(failing, key=lambda one: -(cells.required_increase(one, verdict) or 0.0))
    columns = (
        cells.MECHANISM,
        Column(say("Holds up to PGA"), "ground acceleration", 3),
        Column(say("PGA to be reached"), "ground acceleration", 3),
        Column(say("Factor needed"), "ratio", 3),
    )
    caption = say("What the failing mechanisms lack.")
    rows = tuple(_failing_row(results, one, verdict) for one in ordered)
    if any(_is_too_slender(one) for one in failing):
        slender = say(
            "What fails by a table of slenderness needs more thickness or less height between what holds it; its page "
            "says how slender it may be."
        )
        return [Prose((words, slender)), *nonempty(Table("lacking", caption, columns, rows, small=True))]
    return [Prose((words,)), *nonempty(Table("lacking", caption, columns, rows, small=True))]


def _is_too_slender(mechanism_verdict: MechanismVerdict) -> bool:
    failing = (each for each in mechanism_verdict.answers if each.outcome == Decision.FAIL)
    return any(family_of(each.procedure) == Family.TABLE for each in failing)


def _failing_row(results: Results, mechanism_verdict: MechanismVerdict, verdict: Verdict) -> tuple[Cell, ...]:
    title, margin = numbered_title(results, mechanism_verdict.mechanism), mechanism_verdict.margin
    factor = cells.required_increase(mechanism_verdict, verdict)
    shown = (
        None
        if factor is None
        else quantity(factor, "ratio", cells.required_increase_figures(mechanism_verdict, factor))
    )
    if margin is None:
        return title, None, None, shown
    reached = None if factor is None else margin * verdict.action.pga_g * factor
    return title, cells.capacity_pga_text(mechanism_verdict, margin, verdict.action), reached, shown


def _strongest_inputs(results: Results) -> Iterator[Text]:
    """Yield the values that change a deciding answer; of other mechanisms those that move the answer most."""
    decisive = [row for row in results.sensitivity if row.quantity == "index" and not is_negligible(row)]
    changing = [row for row in decisive if any(changes_outcome(row, side) for side in BOUNDS)]
    yield from (_change(results, row) for row in changing)
    decided = {row.mechanism for row in changing}
    strongest: dict[Text, list[str]] = {}
    for mechanism in (each.name for each in results.mechanisms if each.name not in decided):
        rows = [row for row in decisive if row.mechanism == mechanism]
        if rows:
            strongest.setdefault(input_name(max(rows, key=span)), []).append(mechanism)
    for parameter, owners in strongest.items():
        yield say(
            "{parameter} of {mechanisms}, which moves the deciding answer most, without changing it within its range",
            parameter=parameter,
            mechanisms=mechanism_list(results, owners),
        )


def _change(results: Results, row: SensitivityResult) -> Text:
    return say(
        "{parameter} of {mechanism}, which changes the answer: {index} is {at_low} at {low} and {at_high} at {high}",
        parameter=input_name(row),
        mechanism=numbered_title(results, row.mechanism),
        index=cells.index_symbol(row.index),
        low=value_text(row, row.low),
        high=value_text(row, row.high),
        at_low=answer_text(row, "low"),
        at_high=answer_text(row, "high"),
    )


def _next_checks(results: Results) -> Iterator[Text]:
    """Yield the mechanisms that are possible and were not examined: by this program, and by others."""
    items = results.report.not_examined
    out_of_plane = [item for item in items if item.key not in key_plan.IN_PLANE]
    in_plane = [item for item in items if item.key in key_plan.IN_PLANE]
    if out_of_plane:
        named = listing(key_plan.item_text(results, item) for item in out_of_plane)
        yield say("with this program, or to be ruled out with a reason: {items}", items=named)
    if in_plane:
        named = listing(key_plan.item_text(results, item) for item in in_plane)
        yield say("by another method, as this program does not assess walls in their plane: {items}", items=named)
    if not results.report.checklist:
        yield say("the mechanisms that a building of this type can have besides those of this report")
