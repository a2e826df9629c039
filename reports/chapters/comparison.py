"""The chapter that compares the mechanisms: capacities, demands, curves, the site's own action and other levels."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import ceil

from assess.codes.check import Check
from assess.codes.verdict import MechanismVerdict
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import annex_envelopes, comparison_words
from reports.chapters.cells import MECHANISM, METHOD, NO_LASTING, NO_ROCKING, OUTCOMES, rotation_cell, unbounded_text
from reports.chapters.check_cells import CAPACITY_PGA, FIGURES
from reports.document import Block, Cell, Column, Figure, Graded, Prose, Section, Table
from reports.figures import comparison as figure
from reports.language.texts import Text, quantity, say
from reports.titles import numbered_title, procedure_title

MOST = 5
"""Levels besides the site's own in the table; the tables of the spreadsheet have all."""


def sections(results: Results) -> list[Section]:
    """Return the chapter; none without answers to compare."""
    if not results.comparison:
        return []
    blocks: list[Block] = [
        *_prose(comparison_words.introduction(results)),
        *_figures(results),
        table(results),
        *_prose(comparison_words.findings(results)),
        *annex_envelopes.critical_blocks(results),
    ]
    return [Section(say("Comparison of the mechanisms"), 0, tuple(blocks), starts_page=True)]


def _prose(sentences: Iterator[Text]) -> list[Block]:
    told = tuple(sentences)
    return [Prose(told)] if told else []


def _figures(results: Results) -> Iterator[Figure]:
    if len(results.mechanisms) > 1:
        caption = say(
            "Peak ground acceleration at capacity of every mechanism by every method; hollow: thesis readings."
        )
        yield Figure("capacities", caption, partial(figure.draw_capacities, results))
        caption = say(
            "Largest rotation over peak ground acceleration of all mechanisms by the method that decides; mechanisms "
            "that differ by their joints alone share a colour (solid: rigid, dashed: flexible). Beside it "
            "their moments over rotation, as a part of what rigid joints give."
        )
        yield Figure("curves", caption, partial(figure.draw_curves, results))
    caption = say(
        "Demand over capacity of every mechanism by every method; right of the line the check fails. Hollow: thesis "
        "readings; cross: overturning; arrow: beyond the axis or the end of the spectrum."
    )
    yield Figure("comparison", caption, partial(figure.draw_demands, results))


def table(results: Results) -> Table:
    """Tabulate demand over capacity of the methods that may decide: at the site's own action and at other levels."""
    own, others = governing.site_pga(results), _some(governing.other_levels(results))
    levels = others if own is None else (own, *others)
    ratios = (Column(say("D/C at {pga}", pga=quantity(level, "ground acceleration", FIGURES))) for level in levels)
    columns = (MECHANISM, METHOD, *ratios, CAPACITY_PGA, Column(say("Over the site’s own")))
    rows = tuple(_row(results, mechanism, levels) for mechanism in results.mechanisms)
    return Table("levels", _caption(own, others), columns, rows, small=True)


def _some(levels: tuple[float, ...]) -> tuple[float, ...]:
    """Return as many levels as the page has room for, evenly out of all."""
    return levels[:: ceil(len(levels) / MOST)] if levels else ()


def _caption(own: float | None, others: tuple[float, ...]) -> Text:
    if own is not None and others:
        return say(
            "Demand over capacity of the methods that may decide, the worst of each mechanism. Only the coloured "
            "column, at the site’s own action, counts in the verdict; the other levels are a study."
        )
    return say("Demand over capacity of the methods that may decide, the worst of each mechanism.")


def _row(results: Results, mechanism: MechanismResult, levels: tuple[float, ...]) -> tuple[Cell, ...]:
    own = governing.site_pga(results)
    worst = [governing.worst(_accepted(results, mechanism, level)) for level in levels]
    verdicts = () if results.verdict is None else results.verdict.mechanisms
    found = next((one for one in verdicts if one.mechanism == mechanism.name), None)
    known = next((check for check in worst if check is not None), None)
    cells = (
        _own_cell(check, found) if level == own and found is not None else _ratio(check)
        for level, check in zip(levels, worst, strict=True)
    )
    margin = None if found is None or found.margin is None else quantity(found.margin, "ratio", FIGURES)
    title = None if known is None else procedure_title(known.procedure)
    capacity = None if known is None else known.capacity_pga_g
    return (numbered_title(results, mechanism.name), title, *cells, capacity, margin)


def _accepted(results: Results, mechanism: MechanismResult, level: float) -> tuple[Check, ...]:
    """Return the checks at a level that may decide: by their method and limit state; without a basis, all of codes."""
    checks = governing.code_checks(governing.at_level(mechanism.checks, level))
    found = results.verdict
    if found is None or not found.methods:
        return checks
    accepted = tuple(check for check in checks if check.procedure in found.methods)
    return tuple(check for check in accepted if check.limit_state in found.limit_states) or accepted


def _own_cell(check: Check | None, found: MechanismVerdict) -> Cell:
    """Return the ratio at the site's own action in the colour of the mechanism's outcome."""
    text = None if check is None else _ratio(check)
    return Graded(found.outcome.value, OUTCOMES[found.outcome.value] if text is None else text)


def _ratio(check: Check | None) -> Text | None:
    """Return demand over capacity as text: a number, or why there is none."""
    if check is None:
        return None
    at_rest = rotation_cell(check) in (NO_ROCKING, NO_LASTING)
    if check.ratio is None or (at_rest and not check.ratio):
        return unbounded_text(check) or (NO_ROCKING if at_rest else OUTCOMES[check.verdict.value])
    return quantity(check.ratio, "ratio", FIGURES)
