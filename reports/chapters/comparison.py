"""The chapter that compares the mechanisms: capacities, demands and curves, and where the methods disagree."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import partial
from math import ceil
from statistics import median

from assess.codes.check import Check, Family, Outcome, Reason
from assess.codes.procedures import family_of, uses_histories
from assess.codes.verdict import Decision
from assess.messages.message import Message
from assess.results import MechanismResult, Results, SuiteResult
from assess.results.before import governing_check
from reports import governing
from reports.chapters import annex_envelopes
from reports.chapters.cells import (
    AT_REST,
    CAPACITY_PGA,
    FIGURES,
    MECHANISM,
    METHOD,
    NO_ROCKING,
    OUTCOMES,
    SLIDES,
    capacity_pga_cell,
    margin_cell,
    ratio_cell,
    return_period_text,
    rotation_cell,
    unbounded_text,
)
from reports.document import Block, Cell, Column, Figure, OutcomeCell, Prose, Section, Table
from reports.figures import comparison as figure
from reports.language.texts import Listing, Paragraph, Phrase, Text, count, listing, names, quantity, say
from reports.mechanisms import mechanism_number, numbered_title, procedure_title

MAX_LEVELS = 4
"""Levels besides the site's own in the table; the tables of the spreadsheet have all."""


def sections(results: Results) -> list[Section]:
    """Return the chapter; none without answers to compare."""
    if not results.comparison:
        return []
    blocks: list[Block] = [
        *_prose(introduction(results)),
        *_curves(results),
        ratios_table(results),
        _demands(results),
        *_prose(findings(results)),
        *annex_envelopes.critical_blocks(results),
    ]
    return [Section(say("Comparison of the mechanisms"), 0, tuple(blocks), starts_page=True)]


def ratios_table(results: Results) -> Table:
    """Tabulate demand over capacity of the methods that may decide: at the site's own action and at other levels."""
    own, others = governing.site_pga(results), _evenly_chosen(governing.other_levels(results))
    levels = others if own is None else (own, *others)
    over_site = Column(say("PGA at capacity over the site’s"), "ratio", FIGURES)
    years = Column(say("Return period of the capacity"))
    columns = (MECHANISM, METHOD, *map(_level_column, levels), CAPACITY_PGA, over_site, years)
    rows = tuple(_ratios_row(results, mechanism, levels) for mechanism in results.mechanisms)
    return Table("levels", _ratios_caption(results, others), columns, rows, small=True)


BEYOND_CAPACITY = 1.000001  # times the PGA at capacity: a level that lies beyond it

FAMILY_MEASURES: Mapping[Family, Phrase] = {
    Family.DISPLACEMENT: say(
        "It compares the displacement capacity with the spectral displacement at a secant period."
    ),
    Family.LINEAR: say("It compares the acceleration that starts the motion with the demand reduced by q."),
    Family.ENERGY: say("It replaces the rocking body by an oscillator of equal work with the damping of its impacts."),
    Family.PART: say(
        "It compares the rotation capacity of the wall with the spectral rotation of a part at its floor."
    ),
    Family.TABLE: say("It compares height over thickness with a tabulated limit, whatever the load."),
    Family.ELEMENT: say(
        "It compares the force on a part at its floor, reduced by q_a, with that which starts the motion."
    ),
    Family.HISTORY: say("It follows each record with its impacts, and fails where one overturns the body."),
    Family.SLIDING: say("It estimates how far the body slides without rocking."),
    Family.FRICTION: say("It checks whether friction holds until rocking starts."),
}
"""What each kind of method measures."""


def introduction(results: Results) -> Iterator[Text]:
    """Yield which mechanisms are represented by one of several cases, and where inputs differ."""
    swept = dict.fromkeys(sweep.mechanism for sweep in results.sweeps if sweep.governs)
    if swept:
        which = _mechanism_numbers(results, swept)
        yield say("Each swept mechanism is represented by its most critical case: {mechanisms}.", mechanisms=which)
    carried = [m for m in results.mechanisms if m.amplification.height_m is not None and m.histories]
    if carried and len(carried) < len(results.mechanisms):
        yield say(
            "The time histories of {mechanisms} have the motion at the base of the mechanism, amplified up the "
            "building; those of the others have the ground motion.",
            mechanisms=_mechanism_numbers(results, (m.name for m in carried)),
        )


def findings(results: Results) -> Iterator[Text]:
    """Yield what the comparison shows."""
    if governing.other_levels(results):
        yield say(
            "The levels other than the site’s own action decide nothing: they show how the answers change with the "
            "action. A pass at a higher level is not a margin."
        )
    yield from _passes_beyond_capacity(results)
    yield from _disagreements(results)
    yield from _spread_of_methods(results)
    yield from _overturning(results)


def _prose(sentences: Iterator[Text]) -> list[Block]:
    paragraphs = tuple(sentences)
    return [Prose(paragraphs)] if paragraphs else []


def _curves(results: Results) -> Iterator[Figure]:
    """Yield the figures of several mechanisms on one axis, those for which there is anything to draw."""
    if len(results.mechanisms) < 2:
        return
    if any(governing.capacities(each.checks) for each in results.mechanisms):
        caption = say(
            "Peak ground acceleration at capacity of every mechanism by every method, also where its input allows no "
            "answer; hollow: readings by Mehrotra."
        )
        yield Figure("capacities", caption, partial(figure.draw_capacities, results))
    procedure = figure.curve_procedure(results)
    if not procedure:
        return
    caption = say(
        "Largest rotation over peak ground acceleration of all mechanisms by {method}; mechanisms that differ by their "
        "joints alone share a colour (solid: rigid, dashed: flexible). Beside it their moments over rotation, as a "
        "part of what rigid joints give.",
        method=procedure_title(procedure),
    )
    yield Figure("curves", caption, partial(figure.draw_curves, results))


def _demands(results: Results) -> Figure:
    caption = say(
        "Demand over capacity of every mechanism by every method; right of the line the check fails. Hollow: "
        "readings by Mehrotra; cross: overturning; arrow: beyond the axis or the end of the spectrum."
    )
    return Figure("comparison", caption, partial(figure.draw_demands, results))


def _level_column(level: float) -> Column:
    return Column(say("D/C at {pga}", pga=quantity(level, "ground acceleration", FIGURES)), "ratio", FIGURES)


def _evenly_chosen(levels: tuple[float, ...]) -> tuple[float, ...]:
    """Return as many levels as the page has room for, evenly out of all."""
    return levels[:: ceil(len(levels) / MAX_LEVELS)] if levels else ()


def _has_basis(results: Results) -> bool:
    """Return whether a code is named that decides."""
    return results.verdict is not None and bool(results.verdict.basis)


def _ratios_caption(results: Results, others: tuple[float, ...]) -> Text:
    if not _has_basis(results):
        return say("Demand over capacity, the worst of the methods of codes; none of them decides.")
    if others:
        return say(
            "Demand over capacity of the methods that may decide, the worst of each mechanism. Only the coloured "
            "column, at the site’s own action, counts in the verdict; the other levels are a study."
        )
    return say("Demand over capacity of the methods that may decide, the worst of each mechanism.")


def _ratios_row(results: Results, mechanism: MechanismResult, levels: tuple[float, ...]) -> tuple[Cell, ...]:
    own = governing.site_pga(results)
    mechanism_verdict = governing.verdict_of(results, mechanism)
    worst = [governing.worst_check(_accepted(results, mechanism, level)) for level in levels]
    known = next((check for check in worst if check is not None), None)
    cells = (
        _site_ratio_cell(check, mechanism_verdict.outcome)
        if level == own and mechanism_verdict is not None and _has_basis(results)
        else _ratio_or_reason(check)
        for level, check in zip(levels, worst, strict=True)
    )
    title = None if known is None else procedure_title(known.procedure)
    capacity = None if known is None else capacity_pga_cell(known)
    margin = None if mechanism_verdict is None else margin_cell(mechanism_verdict)
    governs = None if own is None else governing_check(mechanism.checks, pga_g=own)
    years = None if governs is None else return_period_text(governs.return_period_years, governs.return_period_bound)
    return (numbered_title(results, mechanism.name), title, *cells, capacity, margin, years)


def _accepted(results: Results, mechanism: MechanismResult, level: float) -> tuple[Check, ...]:
    """Return the checks at a level of the methods that decide the mechanism; without a basis, all of codes.

    Where no method decides, those of all methods that may.
    """
    checks = governing.code_checks(governing.checks_at_level(mechanism.checks, level))
    verdict, mechanism_verdict = results.verdict, governing.verdict_of(results, mechanism)
    if verdict is None or mechanism_verdict is None or not verdict.methods:
        return checks
    methods = {answer.procedure for answer in mechanism_verdict.answers if answer.procedure} or set(verdict.methods)
    accepted = tuple(check for check in checks if check.procedure in methods)
    return tuple(check for check in accepted if check.limit_state in verdict.limit_states) or accepted


def _site_ratio_cell(check: Check | None, outcome: Decision) -> OutcomeCell:
    """Return the ratio at the site's own action in the colour of the mechanism's outcome."""
    ratio = _ratio_or_reason(check)
    text = quantity(ratio, "ratio", FIGURES) if isinstance(ratio, float) else ratio
    return OutcomeCell(outcome.value, OUTCOMES[outcome.value] if text is None else text)


def _ratio_or_reason(check: Check | None) -> Text | float | None:
    """Return demand over capacity, or why there is none."""
    if check is None:
        return None
    if check.verdict == Outcome.NOT_ANSWERED and check.provisional is None:
        return OUTCOMES[check.verdict.value]
    words = rotation_cell(check)
    at_rest = words in AT_REST
    if check.ratio is None or (at_rest and not check.ratio):
        still = SLIDES if words == SLIDES else NO_ROCKING
        return unbounded_text(check) or (still if at_rest else OUTCOMES[check.verdict.value])
    return ratio_cell(check)


def _mechanism_numbers(results: Results, mechanisms: Iterable[str]) -> Listing:
    return names(mechanism_number(results, name) for name in mechanisms)


def _passes_beyond_capacity(results: Results) -> Iterator[Text]:
    found = [m.name for m in results.mechanisms if any(map(_passes_beyond, governing.code_checks(m.checks)))]
    if found:
        yield say(
            "For {mechanisms} a record that overturns the mechanism at one level is survived at a higher one: the PGA "
            "at capacity is the last before the suite first fails.",
            mechanisms=_mechanism_numbers(results, found),
        )


def _passes_beyond(check: Check) -> bool:
    capacity = check.capacity_pga_g
    beyond = capacity is not None and check.level_pga_g > BEYOND_CAPACITY * capacity
    return beyond and check.verdict == Outcome.PASS and uses_histories(check.procedure)


def _disagreements(results: Results) -> Iterator[Text]:
    """Yield on which mechanisms methods disagree at the site's own action, and what those measure that fail some."""
    apart = [
        m
        for m in results.mechanisms
        if {Outcome.PASS, Outcome.FAIL} <= {c.verdict for c in governing.code_checks_at_site(results, m)}
    ]
    if governing.site_pga(results) is None or not apart:
        return
    yield say(
        "At the site’s own action the methods disagree on {mechanisms}.",
        mechanisms=_mechanism_numbers(results, (m.name for m in apart)),
    )
    answering = dict.fromkeys(
        c.procedure
        for m in apart
        for c in governing.code_checks_at_site(results, m)
        if c.verdict in (Outcome.PASS, Outcome.FAIL)
    )
    failed = {
        procedure: [m.name for m in results.mechanisms if _has_outcome(results, m, procedure, Outcome.FAIL)]
        for procedure in answering
        if any(_has_outcome(results, m, procedure, Outcome.FAIL) for m in apart)
    }
    explained: set[Family | None] = set()
    for procedure, mechanisms in failed.items():
        family = family_of(procedure)
        yield _failing(results, procedure, mechanisms, None if family in explained else family)
        explained.add(family)
    passed: dict[tuple[str, ...], list[str]] = {}
    for procedure in (name for name in answering if name not in failed):
        which = tuple(m.name for m in apart if _has_outcome(results, m, procedure, Outcome.PASS))
        passed.setdefault(which, []).append(procedure)
    for which, procedures in passed.items():
        yield _passing(results, which, procedures, is_all=1 < len(which) == len(apart))


def _passing(results: Results, which: tuple[str, ...], procedures: list[str], *, is_all: bool) -> Text:
    """Return which mechanisms are passed by methods that fail none."""
    methods, mechanisms = listing(map(procedure_title, procedures)), _mechanism_numbers(results, which)
    if is_all:
        return say("All of these are passed by {methods}.", methods=methods)
    if len(which) == 1:
        return say("{mechanism} is passed by {methods}.", mechanism=mechanisms, methods=methods)
    return say("{mechanisms} are passed by {methods}.", mechanisms=mechanisms, methods=methods)


def _has_outcome(results: Results, mechanism: MechanismResult, procedure: str, outcome: Outcome) -> bool:
    """Return whether a check of a mechanism by a procedure has an outcome at the site's own action."""
    checks = governing.code_checks_at_site(results, mechanism)
    return any(check.procedure == procedure and check.verdict == outcome for check in checks)


def _failing(results: Results, procedure: str, mechanisms: list[str], family: Family | None) -> Text:
    """Return which mechanisms a method fails, and what its family measures, if it was not told before."""
    which = _mechanism_numbers(results, mechanisms)
    sentence = say("{method} fails {mechanisms}.", method=procedure_title(procedure), mechanisms=which)
    return sentence if family is None else Paragraph((sentence, FAMILY_MEASURES[family]))


def _spread_of_methods(results: Results) -> Iterator[Text]:
    """Yield how far apart the methods of codes are in PGA at capacity."""
    spreads = []
    for mechanism in results.mechanisms:
        known = governing.capacities(governing.answered_checks(governing.code_checks(mechanism.checks)))
        if len(known) > 1 and min(known.values()) > 0.0:
            low, high = min(known, key=lambda name: known[name]), max(known, key=lambda name: known[name])
            spreads.append((known[high] / known[low], mechanism, low, high))
    if not spreads:
        return
    largest, mechanism, low, high = max(spreads, key=lambda spread: spread[0])
    if len(spreads) == 1:
        yield say(
            "The PGA at capacity by {high} is {largest} times that by {low}.",
            high=procedure_title(high),
            largest=quantity(largest, "ratio", FIGURES),
            low=procedure_title(low),
        )
        return
    yield say(
        "Of each mechanism, the largest PGA at capacity by any method is {middle} times the smallest in the median, "
        "and at most {largest} times ({mechanism}: {high} over {low}).",
        middle=quantity(median(spread[0] for spread in spreads), "ratio", FIGURES),
        largest=quantity(largest, "ratio", FIGURES),
        mechanism=numbered_title(results, mechanism.name),
        high=procedure_title(high),
        low=procedure_title(low),
    )


def _overturning(results: Results) -> Iterator[Text]:
    """Yield how many records overturn which mechanisms."""
    fallen = [
        say(
            "{mechanism} at {levels}",
            mechanism=numbered_title(results, mechanism.name),
            levels=Listing(tuple(_overturned_at_level(suite) for suite in mechanism.suites if suite.overturned), ""),
        )
        for mechanism in results.mechanisms
        if any(suite.overturned for suite in mechanism.suites)
    ]
    if fallen:
        yield say("Records overturn {cases}. No other history overturns a mechanism.", cases=listing(fallen))
    elif any(mechanism.suites for mechanism in results.mechanisms):
        yield _none_overturns(results)
    factored = [
        say("{mechanism}: {reason}", mechanism=numbered_title(results, mechanism.name), reason=reason)
        for mechanism in results.mechanisms
        for reason in _factored_reasons(mechanism)
    ]
    if factored:
        yield say("These levels are without a confidence factor; with it {cases}.", cases=Listing(tuple(factored), ""))


def _factored_reasons(mechanism: MechanismResult) -> list[Message]:
    """Return how many records overturn a mechanism at levels times FC, each count once."""
    found = (each.reason for each in mechanism.checks if each.reason.key == Reason.RECORDS_OVERTURN_FACTORED)
    return list({reason.text: reason for reason in found}.values())


def _overturned_at_level(suite: SuiteResult) -> Text:
    return say(
        "{pga} ({number} of {all})",
        pga=quantity(suite.level_pga_g, "ground acceleration", FIGURES),
        number=count(suite.overturned),
        all=count(suite.n),
    )


def _none_overturns(results: Results) -> Text:
    """Return that no record overturns, but for the procedures that run records at another PGA than their level."""
    checks = [check for mechanism in results.mechanisms for check in mechanism.checks]
    fallen = dict.fromkeys(c.procedure for c in checks if uses_histories(c.procedure) and governing.is_overturned(c))
    if not fallen:
        return say("No record overturns a mechanism at the levels requested.")
    return say(
        "No record overturns a mechanism at the levels requested; with the confidence factor, or at the PGA of another "
        "limit state, records do: {methods}.",
        methods=listing(map(procedure_title, fallen)),
    )
