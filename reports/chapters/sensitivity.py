"""How the verdict of a mechanism moves with numbers that are not well known: sentences, tornado figure and table."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import partial
from math import inf

from assess.codes.check import Outcome
from assess.results import Results, SensitivityResult
from reports.chapters.sensitivity_ranking import (
    SIDES,
    At,
    Side,
    Varied,
    fails,
    flips,
    is_still,
    span,
    value,
    varied,
    verdict,
)
from reports.chapters.tables import OVERTURNED
from reports.document import Block, Cell, Column, Figure, Section, Table, Text
from reports.figures import tornado
from reports.language.lettering import shortened
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
SAID: dict[Outcome | None, str] = {
    Outcome.PASS: "pass",
    Outcome.FAIL: "FAIL",
    Outcome.NOT_ANSWERED: "not answered",
    Outcome.NOT_APPLICABLE: "n/a",
    None: "not known",
}
MOST = 8  # checks that are named in a sentence
INTENT = (
    "Each of these numbers is varied alone, all others staying as they are, and the mechanism is assessed again by all "
    "procedures of codes, with all records. The ranges are those of the project and say nothing of how likely they "
    "are; numbers that change together can move the answer farther. Time histories scatter: where both ends of a range "
    "move their ratio the same way, that is scatter rather than an effect."
)


def chapter(results: Results, mechanism: str, *, called: str, name: str) -> list[Section]:
    """The sensitivity of one mechanism, nothing where there is none; called: in sentences; name: begins its names."""
    rows = tuple(row for row in results.sensitivity if row.mechanism == mechanism)
    found = varied(rows)
    blocks: list[Block] = []
    if found:
        said = (INTENT, *sentences(found, shortened(called, 60)))
        blocks += [Text(said), figure(found, name=name), table(found, name=name)]
    remarks = tuple(remarks_of(rows, found))
    blocks += [Text(remarks)] if remarks else []
    return [Section("Sensitivity", 1, tuple(blocks))] if blocks else []


def data(results: Results) -> tuple[Table, ...]:
    """Every answer of every mechanism, for the spreadsheet and the CSV files."""
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
    caption = "Every check with each number at its low and its high value; there is no ratio where the body overturns."
    return (Table("sensitivity", caption, columns, rows),)


def sentences(found: Sequence[Varied], called: str) -> tuple[str, ...]:
    """What the numbers say: whether the verdict changes, what moves each answer most."""
    return (overall(found, called), *single_checks(found), *map(partial(strongest, found), range(len(found[0].shown))))


def overall(found: Sequence[Varied], called: str) -> str:
    """Whether what decides the mechanism changes; where nothing does, whether any check does at any level."""
    changed = [
        f"{quantity_name(each.number)} at {at(each.number, side)} ({'FAIL' if fails(each.telling, side) else 'pass'})"
        for each in found
        for side in SIDES
        if assessed(each, side) and fails(each.telling, side) != fails(each.telling, "base")
    ]
    if changed:
        return f"The verdict of {called} changes with {'; '.join(changed)}."
    decided, failing = found[0].telling != found[0].rows, fails(found[0].telling, "base")
    if decided:
        stands = "what decides fails" if failing else "what decides does not fail"
    else:
        stands = "some check fails" if failing else "no check fails"
    return f"The verdict of {called} does not change within these ranges: {stands} throughout."


def assessed(each: Varied, side: Side) -> bool:
    """Whether the case of one side could be assessed."""
    return any(verdict(row, side) is not None for row in each.rows)


def single_checks(found: Sequence[Varied]) -> Iterator[str]:
    """The checks whose verdict turns."""
    told = [
        f"{row.procedure} at {level(row)} g with {quantity_name(row)} at {at(row, side)} "
        f"({SAID[row.verdict_base]} → {SAID[verdict(row, side)]})"
        for each in found
        for row in each.rows
        for side in SIDES
        if row.quantity != "index" and flips(row, side)
    ]
    if told:
        more = f"; and {len(told) - MOST} more, see the table sensitivity" if len(told) > MOST else ""
        yield f"Checks whose verdict turns: {'; '.join(told[:MOST])}{more}."


def strongest(found: Sequence[Varied], place: int) -> str:
    """Which number moves one of the answers that are shown most, from what to what, and which hardly do."""
    rows = [each.shown[place] for each in found]
    most = max(rows, key=span)
    what = f"{words_of(most)} ({most.procedure})"
    if is_still(most):
        return f"None of them moves the {what}, which is {answer(most, 'base')}."
    ends = " and ".join(f"{answer(most, side)} at {at(most, side)}" for side in SIDES)
    still = [quantity_name(row) for row in rows if is_still(row)]
    rest = f"; it hardly moves with {', '.join(still)}" if still else ""
    assessed_as = answer(most, "base")
    return f"The {quantity_name(most)} moves the {what} most: {ends}, beside {assessed_as} as assessed{rest}."


def words_of(row: SensitivityResult) -> str:
    """What an answer is."""
    if row.quantity == "index":
        return f"index {row.index}".replace("zeta_E", "ζ_E")
    return "PGA at capacity" if row.quantity == "capacity_pga_g" else f"demand over capacity at {level(row)} g"


def level(row: SensitivityResult) -> str:
    """The peak ground acceleration that a ratio is of [g]."""
    return numeral(row.level_pga_g or 0.0, digits=3)


def answer(row: SensitivityResult, at: At) -> str:
    """An answer in words, with its unit."""
    found = value(row, at)
    if found is None:
        return "not known"
    if found == inf:
        return OVERTURNED
    return numeral(found, digits=3) + (" g" if row.quantity == "capacity_pga_g" else "")


def at(row: SensitivityResult, side: Side) -> str:
    """The low or the high value of a number with its unit."""
    return " ".join(measured(row, row.low if side == "low" else row.high)).rstrip()


def measured(row: SensitivityResult, value: float | None) -> tuple[str, str]:
    """A value of a number, and its unit in the size that suits the number."""
    if value is None:
        return "not known", ""
    size = abs(row.base or value)
    unit = next((name for least, name in LARGE.get(row.unit, ()) if size >= least), row.unit)
    shown = number(value / SIZES.get(unit, 1.0), unit, figures=4, style="round")
    return shown, "" if unit == "-" else unit_word(unit)


def quantity_name(row: SensitivityResult) -> str:
    """What a number is called: the parameter, and of what, as far as its key tells."""
    word = WORDS.get(row.parameter, row.parameter)
    if row.key.startswith("materials."):
        return f"{word} of {shortened(row.key.removeprefix('materials.').rpartition('.')[0], 30)}"
    own = row.key.removeprefix(f"mechanisms.{row.mechanism}.")
    entry, joint = re.match(r"loads\[(\d+)\]", own), re.match(r"interfaces\.([A-D])\.", own)
    if entry:
        return f"{word}, entry {entry[1]} of loads"
    return f"{word}, joint {joint[1]}" if joint else word


def remarks_of(rows: Sequence[SensitivityResult], found: Sequence[Varied]) -> Iterator[str]:
    """What is said of single numbers, and which are not varied and why."""
    yield from (f"{quantity_name(each.number)}: {each.number.remark}." for each in found if each.number.remark)
    for row in rows:
        if not row.quantity:
            yield f"{quantity_name(row)}: {row.remark}.".removeprefix(": ")


def figure(found: Sequence[Varied], *, name: str) -> Figure:
    """The tornado: a panel for each answer that is shown."""
    caption = (
        "What each number moves, one at a time, the widest first; its low and high value stand beside its name. Dashed "
        "is where passing and failing part; an arrow is a body that overturns."
    )
    return Figure(f"{name}-sensitivity", caption, partial(tornado.draw, panels(found)))


def panels(found: Sequence[Varied]) -> tuple[tornado.Panel, ...]:
    """The answers that are shown, with the names of the numbers."""
    names = [(quantity_name(each.number), ranges(each.number)) for each in found]
    beside = next((row for row in found[0].shown if row.quantity == "demand_capacity"), None)
    made = []
    for place, first in enumerate(found[0].shown):
        rows = [each.shown[place] for each in found]
        bars = tuple(
            tornado.Bar(name, value(row, "low"), value(row, "high"), (turned(row, "low"), turned(row, "high")))
            for name, row in zip(names, rows, strict=True)
        )
        limit = (1.0, "limit") if first.quantity == "demand_capacity" else None
        limit = (1.0, "1") if first.quantity == "index" else limit
        if limit is None and beside is not None and beside.level_pga_g:
            limit = (beside.level_pga_g, f"{level(beside)} g")
        unit = "g" if first.quantity == "capacity_pga_g" else "-"
        said = (f"{words_of(first)} [{unit}]", first.procedure)
        made.append(tornado.Panel(said, value(first, "base"), limit, bars))
    return tuple(made)


def ranges(number: SensitivityResult) -> str:
    """Low to high value of a number, with its unit once."""
    (low, _), (high, unit) = measured(number, number.low), measured(number, number.high)
    return f"{low} to {high} {unit}".rstrip()


def turned(row: SensitivityResult, side: Side) -> str:
    """What a verdict turns to, empty where it stays."""
    return SAID[verdict(row, side)] if flips(row, side) else ""


def table(found: Sequence[Varied], *, name: str) -> Table:
    """What the tornado shows, in numbers."""
    columns = (
        Column("Number"),
        Column("Unit"),
        *(Column(label, kind="number") for label in ("Low", "High")),
        Column("Answer"),
        *(Column(label, kind="number") for label in ("At low", "As assessed", "At high")),
        *(Column(label, kind="verdict") for label in ("Verdict at low", "Verdict at high")),
    )
    caption = (
        "Each number at its low and its high value. The other procedures and levels stand in the table sensitivity of "
        "the spreadsheet."
    )
    return Table(f"{name}-sensitivity", caption, columns, tuple(_row(row) for each in found for row in each.shown))


def _row(row: SensitivityResult) -> tuple[Cell, ...]:
    unit = ", g" if row.quantity == "capacity_pga_g" else ""
    said = f"{words_of(row)}{unit}, {row.procedure}"
    found = (value(row, "low"), value(row, "base"), value(row, "high"))
    cells = (OVERTURNED if each == inf else each for each in found)
    return (quantity_name(row), row.unit, row.low, row.high, said, *cells, row.verdict_low, row.verdict_high)
