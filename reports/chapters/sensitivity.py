"""How the verdict of a mechanism depends on uncertain numbers: sentences, tornado figure and table."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import partial
from math import inf

from assess.codes.check import Outcome
from assess.results import Results, SensitivityResult
from reports.chapters.check_tables import OVERTURNED
from reports.chapters.sensitivity_ranking import (
    SIDES,
    Case,
    Side,
    VariedInput,
    answer_value,
    fails,
    flips,
    is_negligible,
    rank_inputs,
    span,
    verdict_at,
)
from reports.document import Block, Cell, Column, Figure, Section, Table, Text
from reports.figures import tornado
from reports.language.lettering import truncate
from reports.language.measures import number, unit_word
from reports.language.numerals import numeral

WORDS = {
    "compressive_strength": "compressive strength",
    "tie_force": "force of the tie",
    "loads": "load",
    "uplift": "uplift multiplier",
    "p": "frequency parameter",
}
LARGE = {
    "Pa": ((1e9, "GPa"), (1e4, "MPa")),
    "Pa/m": ((1e8, "GPa/m"),),
    "N": ((1e3, "kN"),),
    "kg/m^3": ((0.0, "kg/m³"),),
}
SIZES = {"GPa": 1e9, "MPa": 1e6, "GPa/m": 1e9, "kN": 1e3}
VERDICT_WORDS: dict[Outcome | None, str] = {
    Outcome.PASS: "pass",
    Outcome.FAIL: "FAIL",
    Outcome.NOT_ANSWERED: "not answered",
    Outcome.NOT_APPLICABLE: "n/a",
    None: "not known",
}
MOST = 8  # checks that are named in a sentence
INTENT = (
    "Each of these values is varied alone, with all others unchanged, and the mechanism is assessed again "
    "by all code procedures with all records. The ranges are those of the project and say nothing about "
    "their likelihood; values that change together can move the answer further. Time histories scatter: "
    "where both ends of a range move their ratio the same way, that is scatter rather than an effect."
)


def chapter(results: Results, mechanism: str, *, called: str, name: str) -> list[Section]:
    """Return the sensitivity of one mechanism; none where nothing was varied."""
    rows = tuple(row for row in results.sensitivity if row.mechanism == mechanism)
    found = rank_inputs(rows)
    blocks: list[Block] = []
    if found:
        paragraphs = (INTENT, *sentences(found, truncate(called, 60)))
        blocks += [Text(paragraphs), figure(found, name=name), table(found, name=name)]
    notes = tuple(remarks(rows, found))
    blocks += [Text(notes)] if notes else []
    return [Section("Sensitivity", 1, tuple(blocks))] if blocks else []


def data(results: Results) -> tuple[Table, ...]:
    """Tabulate every answer of every mechanism, for the spreadsheet and the CSV files."""
    if not results.sensitivity:
        return ()
    columns = (
        *(Column(label) for label in ("Mechanism", "Parameter", "Key", "Unit")),
        *(Column(label, kind="number") for label in ("Base", "Low", "High")),
        *(Column(label) for label in ("Procedure", "Limit state", "Role")),
        Column("PGA", "g", "number"),
        Column("Quantity"),
        *(Column(label, kind="number") for label in ("At base", "At low", "At high")),
        *(Column(label, kind="verdict") for label in ("Verdict", "Verdict at low", "Verdict at high")),
        Column("Remark"),
    )
    rows = tuple(
        (
            *(row.mechanism, row.parameter, row.key, row.unit, row.base, row.low, row.high),
            *(
                row.procedure,
                row.limit_state,
                row.role,
                row.level_pga_g,
                row.quantity,
                row.at_base,
                row.at_low,
                row.at_high,
            ),
            *(row.verdict_base, row.verdict_low, row.verdict_high, row.remark),
        )
        for row in results.sensitivity
    )
    caption = "Every check with each value at its low and its high end; there is no ratio where the body overturns."
    return (Table("sensitivity", caption, columns, rows),)


def sentences(found: Sequence[VariedInput], called: str) -> tuple[str, ...]:
    """Return the findings: whether the verdict changes, and what affects each answer most."""
    return (
        verdict_stability(found, called),
        *flipping_checks(found),
        *map(partial(strongest_influence, found), range(len(found[0].shown))),
    )


def verdict_stability(found: Sequence[VariedInput], called: str) -> str:
    """State whether the deciding answer changes; where nothing decides, whether any check does at any level."""
    changed = [
        f"{quantity_name(each.number)} at {value_text(each.number, side)} ({'FAIL' if failing else 'pass'})"
        for each in found
        for side in SIDES
        if is_assessed(each, side) and (failing := fails(each.decisive, side)) != fails(each.decisive, "base")
    ]
    if changed:
        return f"The verdict of {called} changes with {'; '.join(changed)}."
    decided, failing = found[0].decisive != found[0].rows, fails(found[0].decisive, "base")
    if decided:
        stands = "the deciding answer fails" if failing else "the deciding answer does not fail"
    else:
        stands = "some check fails" if failing else "no check fails"
    return f"The verdict of {called} does not change within these ranges: {stands} throughout."


def is_assessed(each: VariedInput, side: Side) -> bool:
    """Return whether the case of one side could be assessed."""
    return any(verdict_at(row, side) is not None for row in each.rows)


def flipping_checks(found: Sequence[VariedInput]) -> Iterator[str]:
    """Yield the checks whose verdict changes, in one sentence."""
    changes = [
        f"{row.procedure} at {level_text(row)} g with {quantity_name(row)} at {value_text(row, side)} "
        f"({VERDICT_WORDS[row.verdict_base]} → {VERDICT_WORDS[verdict_at(row, side)]})"
        for each in found
        for row in each.rows
        for side in SIDES
        if row.quantity != "index" and flips(row, side)
    ]
    if changes:
        more = f"; and {len(changes) - MOST} more, see the table sensitivity" if len(changes) > MOST else ""
        yield f"Checks whose verdict changes: {'; '.join(changes[:MOST])}{more}."


def strongest_influence(found: Sequence[VariedInput], place: int) -> str:
    """Describe the number that affects one of the answers most, its effect, and the numbers that hardly do."""
    rows = [each.shown[place] for each in found]
    most = max(rows, key=span)
    what = f"{answer_name(most)} ({most.procedure})"
    if is_negligible(most):
        return f"None of them affects the {what}, which is {answer_text(most, 'base')}."
    ends = " and ".join(f"{answer_text(most, side)} at {value_text(most, side)}" for side in SIDES)
    still = [quantity_name(row) for row in rows if is_negligible(row)]
    rest = f"; it hardly changes with {', '.join(still)}" if still else ""
    assessed_as = answer_text(most, "base")
    return f"The {quantity_name(most)} affects the {what} most: {ends}, against {assessed_as} as assessed{rest}."


def answer_name(row: SensitivityResult) -> str:
    """Return the name of an answer."""
    if row.quantity == "index":
        return f"index {row.index}".replace("zeta_E", "ζ_E")
    return "PGA at capacity" if row.quantity == "capacity_pga_g" else f"demand over capacity at {level_text(row)} g"


def level_text(row: SensitivityResult) -> str:
    """Return the peak ground acceleration of a ratio [g]."""
    return numeral(row.level_pga_g or 0.0, digits=3)


def answer_text(row: SensitivityResult, at: Case) -> str:
    """Return an answer in words, with its unit."""
    found = answer_value(row, at)
    if found is None:
        return "not known"
    if found == inf:
        return OVERTURNED
    return numeral(found, digits=3) + (" g" if row.quantity == "capacity_pga_g" else "")


def value_text(row: SensitivityResult, side: Side) -> str:
    """Return the low or the high value of a number with its unit."""
    return " ".join(value_and_unit(row, row.low if side == "low" else row.high)).rstrip()


def value_and_unit(row: SensitivityResult, value: float | None) -> tuple[str, str]:
    """Return a value of a number, and its unit in a size that suits it."""
    if value is None:
        return "not known", ""
    size = abs(row.base or value)
    unit = next((name for least, name in LARGE.get(row.unit, ()) if size >= least), row.unit)
    shown = number(value / SIZES.get(unit, 1.0), unit, figures=4, style="round")
    return shown, "" if unit == "-" else unit_word(unit)


def quantity_name(row: SensitivityResult) -> str:
    """Return the name of a number: the parameter, and of what as far as its key tells."""
    word = WORDS.get(row.parameter, row.parameter)
    if row.key.startswith("materials."):
        return f"{word} of {truncate(row.key.removeprefix('materials.').rpartition('.')[0], 30)}"
    own = row.key.removeprefix(f"mechanisms.{row.mechanism}.")
    entry, joint = re.match(r"loads\[(\d+)\]", own), re.match(r"interfaces\.([A-D])\.", own)
    if entry:
        return f"{word}, entry {entry[1]} of loads"
    return f"{word}, joint {joint[1]}" if joint else word


def remarks(rows: Sequence[SensitivityResult], found: Sequence[VariedInput]) -> Iterator[str]:
    """Yield the remarks on single inputs, and which are not varied and why."""
    yield from (f"{quantity_name(each.number)}: {each.number.remark}." for each in found if each.number.remark)
    for row in rows:
        if not row.quantity:
            yield f"{quantity_name(row)}: {row.remark}.".removeprefix(": ")


def figure(found: Sequence[VariedInput], *, name: str) -> Figure:
    """Return the tornado figure: a panel for each answer that is shown."""
    caption = (
        "Effect of each value, varied one at a time, the largest first; its low and high values are given "
        "beside its name. The dashed line separates pass from fail; an arrow marks a body that overturns."
    )
    return Figure(f"{name}-sensitivity", caption, partial(tornado.draw, panels(found)))


def panels(found: Sequence[VariedInput]) -> tuple[tornado.Panel, ...]:
    """Return the panels of the tornado, one for each answer that is shown."""
    names = [(quantity_name(each.number), range_text(each.number)) for each in found]
    beside = next((row for row in found[0].shown if row.quantity == "demand_capacity"), None)
    made = []
    for place, first in enumerate(found[0].shown):
        rows = [each.shown[place] for each in found]
        bars = tuple(
            tornado.Bar(
                name,
                answer_value(row, "low"),
                answer_value(row, "high"),
                (new_verdict(row, "low"), new_verdict(row, "high")),
            )
            for name, row in zip(names, rows, strict=True)
        )
        limit = (1.0, "limit") if first.quantity == "demand_capacity" else None
        limit = (1.0, "1") if first.quantity == "index" else limit
        if limit is None and beside is not None and beside.level_pga_g:
            limit = (beside.level_pga_g, f"{level_text(beside)} g")
        unit = "g" if first.quantity == "capacity_pga_g" else "-"
        name = (f"{answer_name(first)} [{unit}]", first.procedure)
        made.append(tornado.Panel(name, answer_value(first, "base"), limit, bars))
    return tuple(made)


def range_text(number: SensitivityResult) -> str:
    """Return the low to the high value of a number, with its unit once."""
    (low, _), (high, unit) = value_and_unit(number, number.low), value_and_unit(number, number.high)
    return f"{low} to {high} {unit}".rstrip()


def new_verdict(row: SensitivityResult, side: Side) -> str:
    """Return the verdict that a check changes to; empty where it does not change."""
    return VERDICT_WORDS[verdict_at(row, side)] if flips(row, side) else ""


def table(found: Sequence[VariedInput], *, name: str) -> Table:
    """Tabulate the values of the tornado."""
    columns = (
        Column("Number"),
        Column("Unit"),
        *(Column(label, kind="number") for label in ("Low", "High")),
        Column("Answer"),
        *(Column(label, kind="number") for label in ("At low", "As assessed", "At high")),
        *(Column(label, kind="verdict") for label in ("Verdict at low", "Verdict at high")),
    )
    caption = (
        "Each value at its low and its high end. The other procedures and levels are in the table "
        "sensitivity of the spreadsheet."
    )
    return Table(f"{name}-sensitivity", caption, columns, tuple(_row(row) for each in found for row in each.shown))


def _row(row: SensitivityResult) -> tuple[Cell, ...]:
    unit = ", g" if row.quantity == "capacity_pga_g" else ""
    answer = f"{answer_name(row)}{unit}, {row.procedure}"
    found = (answer_value(row, "low"), answer_value(row, "base"), answer_value(row, "high"))
    cells = (OVERTURNED if each == inf else each for each in found)
    return (quantity_name(row), row.unit, row.low, row.high, answer, *cells, row.verdict_low, row.verdict_high)
