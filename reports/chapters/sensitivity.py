"""The chapter on sensitivity: which inputs move the answers most, over all mechanisms, and what to survey first."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from math import inf

from assess.results import Results, SensitivityResult
from reports.chapters.cells import MECHANISM, OUTCOMES
from reports.chapters.index_text import RATIO
from reports.chapters.sensitivity_ranking import (
    SIDES,
    Side,
    VariedInput,
    answer_value,
    flips,
    is_negligible,
    rank_inputs,
    span,
    verdict_at,
)
from reports.chapters.varied_values import answer_name, answer_text, input_name, range_text
from reports.document import Block, Cell, Column, Figure, Prose, Section, Table
from reports.figures import tornado
from reports.language.texts import Term, Text, Verbatim, listing, quantity, say
from reports.titles import file_stem, mechanism_number, numbered_title, procedure_title

MOST = 8
"""Rows of the table."""
MANY_BARS = 10
"""Bars of the figures of the chapter, which is one page."""
CHANGED: dict[str, Text] = {"pass": say("passes"), "fail": say("fails")}
METHOD = say(
    "Each value is varied alone, with all others unchanged, and the mechanism is assessed again by every method with "
    "all records. The ranges are those of the project and say nothing about their likelihood; values that change "
    "together can move an answer further. In time histories, an answer that moves the same way at both ends of a range "
    "shows scatter rather than an effect."
)


@dataclass(frozen=True)
class Influence:
    """An input of a mechanism, and the answer of that mechanism which represents it."""

    varied: VariedInput
    answer: SensitivityResult

    @property
    def effect(self) -> float:
        """Width of the range of the answer over its value as assessed; infinite where the body overturns."""
        base = self.answer.at_base
        if is_negligible(self.answer):
            return 0.0
        return span(self.answer) / base if base else inf

    @property
    def decides(self) -> bool:
        """Whether the outcome of a deciding check changes within the range."""
        return any(flips(row, side) for row in self.varied.decisive for side in SIDES)


def sections(results: Results) -> list[Section]:
    """Return the chapter; none where nothing was varied."""
    found = influences(results)
    if not found:
        notes = tuple(_unvaried(results))
        return [Section(say("Sensitivity"), 0, notes)] if notes else []
    figures = tuple(_figures(results))
    shown = figures[: 2 if sum(bars for _, bars in figures[:2]) <= MANY_BARS else 1]
    blocks: tuple[Block, ...] = (
        Prose((METHOD, *conclusions(results, found))),
        *(figure for figure, _ in shown),
        table(results, found),
        *_unvaried(results),
    )
    return [Section(say("Sensitivity"), 0, blocks, starts_page=True)]


def others(results: Results) -> list[Section]:
    """Return the figures that the chapter has no room for, for the annex."""
    shown = {block.name for each in sections(results) for block in each.blocks if isinstance(block, Figure)}
    rest = tuple(figure for figure, _ in _figures(results) if figure.name not in shown)
    return [Section(say("Sensitivity of the other mechanisms"), 1, rest)] if rest else []


def influences(results: Results) -> list[Influence]:
    """Return every input of every mechanism, those that change an outcome first, then by their effect."""
    found = [
        Influence(varied, varied.shown[0]) for _, ranked in _by_mechanism(results) for varied in ranked if varied.shown
    ]
    return sorted(found, key=lambda each: (not each.decides, -each.effect))


def _by_mechanism(results: Results) -> Iterator[tuple[str, tuple[VariedInput, ...]]]:
    """Yield the ranked inputs of each mechanism that has any, the most critical mechanism first."""
    verdicts = () if results.verdict is None else results.verdict.mechanisms
    margins = {one.mechanism: inf if one.margin is None else one.margin for one in verdicts}
    for mechanism in sorted(results.mechanisms, key=lambda each: margins.get(each.name, inf)):
        ranked = rank_inputs([row for row in results.sensitivity if row.mechanism == mechanism.name])
        if ranked:
            yield mechanism.name, ranked


def conclusions(results: Results, found: list[Influence]) -> Iterator[Text]:
    """Yield what to survey first, and whether an outcome changes."""
    strong = [each for each in found if each.effect > 0.0]
    if not strong:
        yield say("None of the values moves an answer within its range.")
        return
    first = listing(input_name(each.varied.number) for each in one_for_each_input(strong)[:2])
    yield say("Survey first: {inputs}. These move the answers most.", inputs=first)
    changing = [each for each in found if each.decides]
    if changing:
        cases = listing(_change(results, each) for each in changing[:MOST])
        yield say("The outcome changes within the ranges of {cases}.", cases=cases)
    else:
        yield say("No outcome that decides changes within these ranges.")


def one_for_each_input(found: list[Influence]) -> list[Influence]:
    """Return each input once, in the mechanism whose answer it moves most."""
    called = [input_name(each.varied.number) for each in found]
    return [each for place, each in enumerate(found) if called[place] not in called[:place]]


def _change(results: Results, each: Influence) -> Text:
    name = mechanism_number(results, each.answer.mechanism)
    return say("{input} ({mechanism})", input=input_name(each.varied.number), mechanism=Verbatim(name))


def table(results: Results, found: list[Influence]) -> Table:
    """Tabulate the inputs with the largest effects over all mechanisms."""
    columns = (
        Column(say("Input")),
        Column(say("Range")),
        MECHANISM,
        Column(say("Answer")),
        *(Column(label) for label in (say("At low"), say("As assessed"), say("At high"))),
        Column(say("Outcome")),
    )
    caption = say("The inputs with the largest effects, each in the mechanism whose answer it moves most.")
    rows = tuple(_row(results, each) for each in one_for_each_input(found)[:MOST])
    return Table("influences", caption, columns, rows, small=True)


def _row(results: Results, each: Influence) -> tuple[Cell, ...]:
    row = each.answer
    changed = dict.fromkeys(
        verdict
        for side in SIDES
        for one in each.varied.decisive
        if flips(one, side) and (verdict := verdict_at(one, side))
    )
    outcome = listing((CHANGED[verdict.value] for verdict in changed), "or") if changed else say("unchanged")
    answers = (answer_text(row, "low"), answer_text(row, "base"), answer_text(row, "high"))
    number = each.varied.number
    return (
        input_name(number),
        range_text(number),
        numbered_title(results, row.mechanism),
        answer_name(row),
        *answers,
        outcome,
    )


def _figures(results: Results) -> Iterator[tuple[Figure, int]]:
    """Yield the tornado of each mechanism with its number of bars, the most critical mechanism first."""
    places = {mechanism.name: place for place, mechanism in enumerate(results.mechanisms, start=1)}
    target = None if results.verdict is None else results.verdict.target
    for name, ranked in _by_mechanism(results):
        caption = say(
            "{mechanism}: effect of each value, varied one at a time. The dashed line separates pass from fail; an "
            "arrow marks a body that overturns.",
            mechanism=numbered_title(results, name),
        )
        figure = Figure(
            f"{file_stem(name, places[name])}-sensitivity", caption, partial(tornado.draw, panels(ranked, target))
        )
        yield figure, len(ranked)


def panels(ranked: tuple[VariedInput, ...], target: float | None = None) -> tuple[tornado.Panel, ...]:
    """Return the panels of a tornado, one for each answer that is shown. target : of the index of the basis."""
    return tuple(_panel(ranked, place, target) for place in range(len(ranked[0].shown)))


def _panel(ranked: tuple[VariedInput, ...], place: int, target: float | None) -> tornado.Panel:
    first = ranked[0].shown[place]
    bars = tuple(_bar(each, each.shown[place]) for each in ranked)
    dimension = "ground acceleration" if first.quantity == "capacity_pga_g" else "ratio"
    name = (answer_name(first), procedure_title(first.procedure))
    return tornado.Panel(name, dimension, answer_value(first, "base"), _limit(ranked, first, target), bars)


def _bar(each: VariedInput, row: SensitivityResult) -> tornado.Bar:
    lines = (input_name(each.number), range_text(each.number))
    verdicts = (_new_verdict(row, "low"), _new_verdict(row, "high"))
    return tornado.Bar(lines, answer_value(row, "low"), answer_value(row, "high"), verdicts)


def _limit(
    ranked: tuple[VariedInput, ...], first: SensitivityResult, target: float | None
) -> tuple[float, Text] | None:
    """Return the limit between pass and fail with its name; None where it is not known."""
    if first.quantity == "demand_capacity" or (first.quantity == "index" and first.index == RATIO):
        return 1.0, say("limit")
    if first.quantity == "index":
        return None if target is None else (target, say("target"))
    beside = next((row for row in ranked[0].shown if row.level_pga_g), None)
    level = None if beside is None else beside.level_pga_g
    return None if level is None else (level, quantity(level, "ground acceleration", 3))


def _new_verdict(row: SensitivityResult, side: Side) -> Text | None:
    """Return the verdict that a check changes to; None where it does not change."""
    verdict = verdict_at(row, side)
    return OUTCOMES[verdict.value] if verdict is not None and flips(row, side) else None


def _unvaried(results: Results) -> list[Block]:
    """Return which inputs are not varied, and why."""
    told = {
        (row.mechanism, row.remark): say(
            "{mechanism}, {input}: {remark}.",
            mechanism=Verbatim(mechanism_number(results, row.mechanism)),
            input=input_name(row) if row.parameter else say("all inputs"),
            remark=listing(row.remarks, "") if row.remarks else Term(row.remark),
        )
        for row in results.sensitivity
        if not row.quantity
    }
    return [Prose(tuple(told.values()))] if told else []
