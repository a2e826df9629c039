"""The chapter that compares the mechanisms: capacities, demands, curves, the site's own action and other levels."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import ceil

from assess.codes.check import Check
from assess.codes.standing_figures import ratio_figures
from assess.codes.verdict import MechanismVerdict
from assess.messages.message import Quantity
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import annex_envelopes, comparison_words
from reports.chapters.cells import (
    CAPACITY_PGA,
    FIGURES,
    MECHANISM,
    METHOD,
    NO_LASTING,
    NO_ROCKING,
    OUTCOMES,
    capacity_pga_cell,
    rotation_cell,
    unbounded_text,
)
from reports.chapters.index_text import margin_cell
from reports.document import Block, Cell, Column, Figure, Graded, Prose, Section, Table
from reports.figures import comparison as figure
from reports.language.texts import Phrase, Text, quantity, say
from reports.titles import numbered_title, procedure_title

MOST = 5
"""Levels besides the site's own in the table; the tables of the spreadsheet have all."""


def sections(results: Results) -> list[Section]:
    """Return the chapter; none without answers to compare."""
    if not results.comparison:
        return []
    blocks: list[Block] = [
        *_prose(comparison_words.introduction(results)),
        *_curves(results),
        table(results),
        _demands(results),
        *_prose(comparison_words.findings(results)),
        *annex_envelopes.critical_blocks(results),
    ]
    return [Section(say("Comparison of the mechanisms"), 0, tuple(blocks), starts_page=True)]


def _prose(sentences: Iterator[Text]) -> list[Block]:
    told = tuple(sentences)
    return [Prose(told)] if told else []


def _curves(results: Results) -> Iterator[Figure]:
    """Yield the figures of several mechanisms on one axis, those for which there is anything to draw."""
    if len(results.mechanisms) < 2:
        return
    if any(governing.capacities(each.checks) for each in results.mechanisms):
        caption = say(
            "Peak ground acceleration at capacity of every mechanism by every method, also where its input allows no "
            "answer; hollow: thesis readings."
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
        "Demand over capacity of every mechanism by every method; right of the line the check fails. Hollow: thesis "
        "readings; cross: overturning; arrow: beyond the axis or the end of the spectrum."
    )
    return Figure("comparison", caption, partial(figure.draw_demands, results))


def table(results: Results) -> Table:
    """Tabulate demand over capacity of the methods that may decide: at the site's own action and at other levels."""
    own, others = governing.site_pga(results), _some(governing.other_levels(results))
    levels = others if own is None else (own, *others)
    ratios = (_level_column(level) for level in levels)
    columns = (
        MECHANISM,
        METHOD,
        *ratios,
        CAPACITY_PGA,
        Column(say("PGA at capacity over the site’s"), "ratio", FIGURES),
    )
    rows = tuple(_row(results, mechanism, levels) for mechanism in results.mechanisms)
    return Table("levels", _caption(results, others), columns, rows, small=True)


def _level_column(level: float) -> Column:
    return Column(say("D/C at {pga}", pga=quantity(level, "ground acceleration", FIGURES)), "ratio", FIGURES)


def _some(levels: tuple[float, ...]) -> tuple[float, ...]:
    """Return as many levels as the page has room for, evenly out of all."""
    return levels[:: ceil(len(levels) / MOST)] if levels else ()


def _has_basis(results: Results) -> bool:
    """Return whether a code is named that decides."""
    return results.verdict is not None and bool(results.verdict.basis)


def _caption(results: Results, others: tuple[float, ...]) -> Text:
    if not _has_basis(results):
        return say("Demand over capacity, the worst of the methods of codes; none of them decides.")
    if others:
        return say(
            "Demand over capacity of the methods that may decide, the worst of each mechanism. Only the coloured "
            "column, at the site’s own action, counts in the verdict; the other levels are a study."
        )
    return say("Demand over capacity of the methods that may decide, the worst of each mechanism.")


def _row(results: Results, mechanism: MechanismResult, levels: tuple[float, ...]) -> tuple[Cell, ...]:
    own = governing.site_pga(results)
    found = governing.verdict_of(results, mechanism)
    worst = [governing.worst(_accepted(results, mechanism, level)) for level in levels]
    known = next((check for check in worst if check is not None), None)
    cells = (
        _own_cell(check, found) if level == own and found is not None and _has_basis(results) else _ratio(check)
        for level, check in zip(levels, worst, strict=True)
    )
    title = None if known is None else procedure_title(known.procedure)
    capacity = None if known is None else capacity_pga_cell(known)
    margin = None if found is None else margin_cell(found)
    return (numbered_title(results, mechanism.name), title, *cells, capacity, margin)


def _accepted(results: Results, mechanism: MechanismResult, level: float) -> tuple[Check, ...]:
    """Return the checks at a level of the methods that decide the mechanism; without a basis, all of codes.

    Where no method decides, those of all methods that may.
    """
    checks = governing.code_checks(governing.at_level(mechanism.checks, level))
    verdict, own = results.verdict, governing.verdict_of(results, mechanism)
    if verdict is None or own is None or not verdict.methods:
        return checks
    methods = {answer.procedure for answer in own.answers if answer.procedure} or set(verdict.methods)
    accepted = tuple(check for check in checks if check.procedure in methods)
    return tuple(check for check in accepted if check.limit_state in verdict.limit_states) or accepted


def _own_cell(check: Check | None, found: MechanismVerdict) -> Graded:
    """Return the ratio at the site's own action in the colour of the mechanism's outcome."""
    ratio = _ratio(check)
    text = quantity(ratio, "ratio", FIGURES) if isinstance(ratio, float) else ratio
    return Graded(found.outcome.value, OUTCOMES[found.outcome.value] if text is None else text)


def _ratio(check: Check | None) -> Phrase | Quantity | float | None:
    """Return demand over capacity, or why there is none."""
    if check is None:
        return None
    at_rest = rotation_cell(check) in (NO_ROCKING, NO_LASTING)
    if check.ratio is None or (at_rest and not check.ratio):
        return unbounded_text(check) or (NO_ROCKING if at_rest else OUTCOMES[check.verdict.value])
    figures = ratio_figures(check, most=FIGURES)
    return check.ratio if figures == FIGURES else quantity(check.ratio, "ratio", figures)
