"""The chapter on sensitivity: which inputs move the answers most, over all mechanisms, and what to survey first."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from math import inf, log
from typing import Literal

from assess.codes.check import Outcome
from assess.codes.procedures import uses_histories
from assess.results import Results, SensitivityResult
from reports.chapters import cells
from reports.document import Block, Column, Field, Figure, Prose, Section, Table, tabulate
from reports.figures import sensitivity
from reports.governing import DAMAGE
from reports.language.texts import Listing, Phrase, Term, Text, Verbatim, listing, quantity, say
from reports.mechanisms import file_stem, mechanism_number, numbered_title, procedure_title

MAX_ROWS = 8
"""Rows of the table."""

MAX_BARS = 10
"""Bars of the figures of the chapter, which is one page."""

FIGURES = 3

CHANGED_OUTCOMES: dict[str, Text] = {"pass": say("passes"), "fail": say("fails")}

METHOD = say(
    "Each value is varied alone, with all others unchanged, and the mechanism is assessed again by every method with "
    "all records. The ranges are those of the project and say nothing about their likelihood; values that change "
    "together can move an answer further. In time histories, an answer that moves the same way at both ends of a range "
    "shows scatter rather than an effect."
)


@dataclass(frozen=True)
class VariedInput:
    """One number of a mechanism.

    rows : all its answers; shown : those that represent them, in one order for all numbers of the mechanism: the PGA at
    capacity and the ratio of the procedure that governs, as far as they are known, and the ratio of the histories
    """

    rows: tuple[SensitivityResult, ...]
    shown: tuple[SensitivityResult, ...]

    @property
    def decisive(self) -> tuple[SensitivityResult, ...]:
        """The rows of the deciding procedures; all rows where none decides."""
        return tuple(row for row in self.rows if row.role == "deciding") or self.rows

    @property
    def number(self) -> SensitivityResult:
        """Any of its rows, for what all share: parameter, key, unit, base, low, high, remark."""
        return self.rows[0]


@dataclass(frozen=True)
class InputEffect:
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
        return any(changes_outcome(row, side) for row in self.varied.decisive for side in BOUNDS)


def sections(results: Results) -> list[Section]:
    """Return the chapter; none where nothing was varied."""
    found = _input_effects(results)
    if not found:
        notes = tuple(_inputs_not_varied(results))
        return [Section(say("Sensitivity"), 0, notes)] if notes else []
    figures = tuple(_figures(results))
    shown = figures[: 2 if sum(bars for _, bars in figures[:2]) <= MAX_BARS else 1]
    blocks: tuple[Block, ...] = (
        Prose((METHOD, *_conclusions(results, found))),
        *(figure for figure, _ in shown),
        _effects_table(results, found),
        *_inputs_not_varied(results),
    )
    return [Section(say("Sensitivity"), 0, blocks, starts_page=True)]


def annex_sections(results: Results) -> list[Section]:
    """Return the figures that the chapter has no room for, for the annex."""
    shown = {block.name for each in sections(results) for block in each.blocks if isinstance(block, Figure)}
    rest = tuple(figure for figure, _ in _figures(results) if figure.name not in shown)
    return [Section(say("Sensitivity of the other mechanisms"), 1, rest)] if rest else []


def panels(ranked: tuple[VariedInput, ...], target: float | None = None) -> tuple[sensitivity.TornadoPanel, ...]:
    """Return the panels of a tornado, one for each answer that is shown. target : of the index of the basis."""
    return tuple(_panel(ranked, place, target) for place in range(len(ranked[0].shown)))


QUANTITIES = {
    "index": say("index"),
    "capacity_pga_g": say("PGA at capacity [g]"),
    "demand_capacity": say("demand / capacity"),
}


def sensitivity_table(results: Results) -> Table:
    """Tabulate every answer of every mechanism with each value at its low and its high end."""
    fields: tuple[Field[SensitivityResult], ...] = (
        (cells.MECHANISM, lambda row: numbered_title(results, row.mechanism)),
        (Column(say("Parameter")), input_name),
        (Column(say("Key")), lambda row: Verbatim(row.key)),
        (cells.UNIT, lambda row: Verbatim(row.unit)),
        (Column(say("Base")), lambda row: row.base),
        (Column(say("Low")), lambda row: row.low),
        (Column(say("High")), lambda row: row.high),
        (cells.PROCEDURE, lambda row: Verbatim(row.procedure)),
        (cells.LIMIT_STATE, lambda row: Verbatim(row.limit_state)),
        (cells.ROLE, lambda row: cells.ROLES[row.role]),
        (cells.LEVEL, lambda row: row.level_pga_g),
        (cells.QUANTITY, lambda row: QUANTITIES.get(row.quantity)),
        (Column(say("At base")), lambda row: row.at_base),
        (Column(say("At low")), lambda row: row.at_low),
        (Column(say("At high")), lambda row: row.at_high),
        (cells.OUTCOME, lambda row: _outcome_text(row.verdict_base)),
        (Column(say("Outcome at low")), lambda row: _outcome_text(row.verdict_low)),
        (Column(say("Outcome at high")), lambda row: _outcome_text(row.verdict_high)),
        (Column(say("Remark")), lambda row: Listing(row.remarks or (Term(row.remark),), "")),
    )
    caption = say(
        "Every check with each value at its low and its high end; there is no ratio where the body overturns."
    )
    return tabulate("sensitivity", caption, fields, results.sensitivity)


PARAMETER_WORDS: Mapping[str, Phrase] = {
    "thickness": say("thickness"),
    "density": say("density"),
    "compressive_strength": say("compressive strength"),
    "stiffness": say("stiffness"),
    "friction": say("friction"),
    "restitution": say("restitution"),
    "tie_force": say("force of the tie"),
    "loads": say("load"),
    "uplift": say("uplift multiplier"),
    "p": say("frequency parameter"),
}

UNIT_DIMENSIONS: Mapping[str, str] = {
    "m": "length",
    "kg": "mass",
    "N": "force",
    "Pa": "stress",
    "Pa/m": "stiffness",
    "kg/m^3": "density",
    "1/s": "angular frequency",
}
"""The dimensions of the units of varied inputs."""


def input_name(row: SensitivityResult) -> Text:
    """Return the name of an input: the parameter, and of what as far as its key tells."""
    word = PARAMETER_WORDS.get(row.parameter, Term(row.parameter))
    if row.key.startswith("materials."):
        material = row.key.removeprefix("materials.").rpartition(".")[0]
        return say("{parameter} of {material}", parameter=word, material=Verbatim(material))
    own = row.key.removeprefix(f"mechanisms.{row.mechanism}.")
    entry, joint = re.match(r"loads\[(\d+)\]", own), re.match(r"interfaces\.([A-D])\.", own)
    if entry:
        return say("{parameter} {number}", parameter=word, number=quantity(int(entry[1])))
    return say("{parameter}, joint {joint}", parameter=word, joint=Verbatim(joint[1])) if joint else word


def value_text(row: SensitivityResult, value: float | None) -> Text:
    """Return a value of an input with its unit."""
    if value is None:
        return say("not known")
    return quantity(value, UNIT_DIMENSIONS.get(row.unit, "ratio"))


def answer_name(row: SensitivityResult) -> Text:
    """Return the name of an answer."""
    if row.quantity == "index":
        return say("index {name}", name=cells.index_symbol(row.index))
    if row.quantity == "capacity_pga_g":
        return say("PGA at capacity")
    return say("D/C at {pga}", pga=quantity(row.level_pga_g or 0.0, "ground acceleration", FIGURES))


def answer_text(row: SensitivityResult, at: InputValue) -> Text:
    """Return an answer in a case, with its unit."""
    found = _answer_value(row, at)
    if found is None:
        return say("not known")
    if found == inf:
        return cells.OVERTURNED
    dimension = "ground acceleration" if row.quantity == "capacity_pga_g" else "ratio"
    return quantity(found, dimension, FIGURES)


InputValue = Literal["base", "low", "high"]
"""The value of a number: as assessed, low or high."""
RangeEnd = Literal["low", "high"]
BOUNDS: tuple[RangeEnd, RangeEnd] = ("low", "high")
INPUT_VALUES: tuple[InputValue, ...] = ("base", *BOUNDS)
NEGLIGIBLE = 2e-3  # of its value: no history repeats better than this when all masses are multiplied by a number


def rank_inputs(rows: Sequence[SensitivityResult]) -> tuple[VariedInput, ...]:
    """Return every varied number of a mechanism, the one with the largest effect on the answers shown first."""
    numbers: dict[tuple[str, str], list[SensitivityResult]] = {}
    for row in rows:
        if row.quantity:
            numbers.setdefault((row.parameter, row.key), []).append(row)
    if not numbers:
        return ()
    keys = [_answer_key(row) for row in _representative_answers(next(iter(numbers.values())))]
    found = [_varied_input(each, keys) for each in numbers.values()]
    return tuple(sorted(found, key=lambda each: [0.0 if is_negligible(row) else -span(row) for row in each.shown]))


def span(row: SensitivityResult) -> float:
    """Return the width of the range of an answer; 0 where it is not known, or overturns in all cases."""
    known = [found for at in INPUT_VALUES if (found := _answer_value(row, at)) is not None]
    return max(known) - min(known) if known and min(known) < inf else 0.0


def is_negligible(row: SensitivityResult) -> bool:
    """Return whether an answer hardly changes."""
    return span(row) <= NEGLIGIBLE * (row.at_base or 0.0)


def changes_outcome(row: SensitivityResult, side: RangeEnd) -> bool:
    """Return whether a verdict changes from pass to fail or back."""
    return {row.verdict_base, _outcome_at(row, side)} == {Outcome.PASS, Outcome.FAIL}


def _input_effects(results: Results) -> list[InputEffect]:
    """Return every input of every mechanism, those that change an outcome first, then by their effect."""
    found = [
        InputEffect(varied, varied.shown[0])
        for _, ranked in _by_mechanism(results)
        for varied in ranked
        if varied.shown
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


def _conclusions(results: Results, found: list[InputEffect]) -> Iterator[Text]:
    """Yield what to survey first, and whether an outcome changes."""
    strong = [each for each in found if each.effect > 0.0]
    if not strong:
        yield say("None of the values moves an answer within its range.")
        return
    first = listing(input_name(each.varied.number) for each in _one_for_each_input(strong)[:2])
    yield say("Survey first: {inputs}. These move the answers most.", inputs=first)
    changing = [each for each in found if each.decides]
    if changing:
        cases = listing(_change(results, each) for each in changing[:MAX_ROWS])
        yield say("The outcome changes within the ranges of {cases}.", cases=cases)
    else:
        yield say("No outcome that decides changes within these ranges.")


def _one_for_each_input(found: list[InputEffect]) -> list[InputEffect]:
    """Return each input once, in the mechanism whose answer it moves most."""
    called = [input_name(each.varied.number) for each in found]
    return [each for place, each in enumerate(found) if called[place] not in called[:place]]


def _change(results: Results, each: InputEffect) -> Text:
    name = mechanism_number(results, each.answer.mechanism)
    return say("{input} ({mechanism})", input=input_name(each.varied.number), mechanism=Verbatim(name))


def _effects_table(results: Results, found: list[InputEffect]) -> Table:
    """Tabulate the inputs with the largest effects over all mechanisms."""
    fields: tuple[Field[InputEffect], ...] = (
        (Column(say("Input")), lambda each: input_name(each.varied.number)),
        (Column(say("Range")), lambda each: _range_text(each.varied.number)),
        (cells.MECHANISM, lambda each: numbered_title(results, each.answer.mechanism)),
        (Column(say("Answer")), lambda each: answer_name(each.answer)),
        (Column(say("At low")), lambda each: answer_text(each.answer, "low")),
        (Column(say("As assessed")), lambda each: answer_text(each.answer, "base")),
        (Column(say("At high")), lambda each: answer_text(each.answer, "high")),
        (cells.OUTCOME, _outcomes_within_range),
    )
    caption = say("The inputs with the largest effects, each in the mechanism whose answer it moves most.")
    return tabulate("influences", caption, fields, _one_for_each_input(found)[:MAX_ROWS], small=True)


def _outcomes_within_range(each: InputEffect) -> Text:
    """Return the outcomes to which deciding checks change within the range of an input."""
    changed = dict.fromkeys(
        outcome
        for bound in BOUNDS
        for row in each.varied.decisive
        if changes_outcome(row, bound) and (outcome := _outcome_at(row, bound))
    )
    return listing((CHANGED_OUTCOMES[each.value] for each in changed), "or") if changed else say("unchanged")


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
            f"{file_stem(name, places[name])}-sensitivity",
            caption,
            partial(sensitivity.draw_tornado, panels(ranked, target)),
        )
        yield figure, len(ranked)


def _panel(ranked: tuple[VariedInput, ...], place: int, target: float | None) -> sensitivity.TornadoPanel:
    first = ranked[0].shown[place]
    bars = tuple(_bar(each, each.shown[place]) for each in ranked)
    dimension = "ground acceleration" if first.quantity == "capacity_pga_g" else "ratio"
    name = (answer_name(first), procedure_title(first.procedure))
    return sensitivity.TornadoPanel(name, dimension, _answer_value(first, "base"), _limit(ranked, first, target), bars)


def _bar(each: VariedInput, row: SensitivityResult) -> sensitivity.TornadoBar:
    lines = (input_name(each.number), _range_text(each.number))
    verdicts = (_changed_outcome(row, "low"), _changed_outcome(row, "high"))
    return sensitivity.TornadoBar(lines, _answer_value(row, "low"), _answer_value(row, "high"), verdicts)


def _limit(
    ranked: tuple[VariedInput, ...], first: SensitivityResult, target: float | None
) -> tuple[float, Text] | None:
    """Return the limit between pass and fail with its name; None where it is not known."""
    if first.quantity == "demand_capacity" or (first.quantity == "index" and first.index == cells.DEMAND_CAPACITY):
        return 1.0, say("limit")
    if first.quantity == "index":
        return None if target is None else (target, say("target"))
    with_level = next((row for row in ranked[0].shown if row.level_pga_g), None)
    level = None if with_level is None else with_level.level_pga_g
    return None if level is None else (level, quantity(level, "ground acceleration", 3))


def _changed_outcome(row: SensitivityResult, side: RangeEnd) -> Text | None:
    """Return the verdict that a check changes to; None where it does not change."""
    verdict = _outcome_at(row, side)
    return cells.OUTCOMES[verdict.value] if verdict is not None and changes_outcome(row, side) else None


def _inputs_not_varied(results: Results) -> list[Block]:
    """Return which inputs are not varied, and why."""
    reasons = {
        (row.mechanism, row.remark): say(
            "{mechanism}, {input}: {remark}.",
            mechanism=Verbatim(mechanism_number(results, row.mechanism)),
            input=input_name(row) if row.parameter else say("all inputs"),
            remark=listing(row.remarks, "") if row.remarks else Term(row.remark),
        )
        for row in results.sensitivity
        if not row.quantity
    }
    return [Prose(tuple(reasons.values()))] if reasons else []


def _outcome_text(outcome: Outcome | None) -> Text | None:
    return None if outcome is None else cells.OUTCOMES[outcome.value]


def _range_text(row: SensitivityResult) -> Text:
    """Return the low and the high value of an input."""
    return say("{low} to {high}", low=value_text(row, row.low), high=value_text(row, row.high))


def _varied_input(rows: Sequence[SensitivityResult], keys: Sequence[tuple[str, str, str, float | None]]) -> VariedInput:
    by_key = {_answer_key(row): row for row in reversed(rows)}
    return VariedInput(tuple(rows), tuple(by_key[each] for each in keys))


def _answer_key(row: SensitivityResult) -> tuple[str, str, str, float | None]:
    """Return quantity, procedure, limit state and level of an answer."""
    return row.quantity, row.procedure, row.limit_state, row.level_pga_g


def _representative_answers(rows: Sequence[SensitivityResult]) -> list[SensitivityResult]:
    """Choose, among the answers of one number, those that represent all.

    These are the index of the deciding answer, and the PGA at capacity of its procedure. Where none decides, they are
    those of the procedure with the least PGA at capacity, at the level nearest to it, and of the histories at this
    level; where no PGA at capacity is known, of the check with the worst ratio. Damage comes before collapse and
    replaces it only where a procedure has nothing else.
    """
    index = [row for row in rows if row.quantity == "index"]
    if index:
        decide = {(row.procedure, row.limit_state) for row in index}
        return [*index, *(r for r in rows if r.quantity == "capacity_pga_g" and (r.procedure, r.limit_state) in decide)]
    ultimate = {row.procedure for row in rows if row.limit_state != DAMAGE}
    rows = [row for row in rows if row.limit_state != DAMAGE or row.procedure not in ultimate]
    ratios = [row for row in rows if row.quantity == "demand_capacity"]
    known = [row for row in rows if row.quantity == "capacity_pga_g" and row.at_base]
    if not known:
        return sorted(ratios, key=lambda row: _answer_value(row, "base") or 0.0)[-1:]
    least = min(known, key=lambda row: row.at_base or inf)
    levels = sorted({row.level_pga_g or 0.0 for row in ratios})
    near = min(levels, key=lambda level: abs(log(level / (least.at_base or level))), default=None)
    there = [row for row in ratios if row.level_pga_g == near]
    own = [row for row in there if (row.procedure, row.limit_state) == (least.procedure, least.limit_state)]
    return [least, *own[:1], *[row for row in there if uses_histories(row.procedure)][:1]]


def _answer_value(row: SensitivityResult, at: InputValue) -> float | None:
    """Return the answer in a case: infinite where the body overturns, None where it is not known."""
    found = {"base": row.at_base, "low": row.at_low, "high": row.at_high}[at]
    return inf if found is None and _outcome_at(row, at) == Outcome.FAIL else found


def _outcome_at(row: SensitivityResult, at: InputValue) -> Outcome | None:
    """Return the verdict in a case; None where it was not assessed."""
    return {"base": row.verdict_base, "low": row.verdict_low, "high": row.verdict_high}[at]
