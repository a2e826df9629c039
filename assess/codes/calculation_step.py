"""One line of a calculation sheet; its numbers are put into its formula by `substitute`, never written twice."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import pi
from typing import Literal

from scipy.constants import g

from assess.messages.message import DIMENSIONS
from assess.short_repr import ShortRepr

Bound = Literal["", "<=", ">="]
CONSTANTS: Mapping[str, float] = {"g": g, "π": pi}
INPUT_FIGURES, RESULT_FIGURES = 7, 4
"""Significant figures at which formula and inputs as printed give the result as printed."""
UNANSWERED = "not answered: the reason of the check says why"
_PART = r"(?:[^\W²³]|[*'′₀-₉])"  # what a symbol may be made of, so that none is found inside another
_BETWEEN = re.compile(r"(?<=[\d¹²³⁰⁴-⁹)π]) (?=[\d√(])")  # a product written side by side, once numbers stand there


@dataclass(frozen=True)
class Input:
    """A symbol of a formula with its value, in the unit of its dimension (`assess.messages.message.UNITS`)."""

    symbol: str
    value: float
    dimension: str


@dataclass(frozen=True, repr=False)
class Step(ShortRepr):
    """One line of a calculation sheet: the formula, the numbers put into it, and the result.

    description, clause, remark : fixed English terms
    formula : of the symbols of `inputs`; without inputs a fixed English term, or the definition of what was read
    inputs : the symbols of the formula; `substituted` is made from them (see `step`)
    bound : "<=" or ">=" where the value is only an upper or a lower bound
    at : where a value was read that no formula gives: the period and damping of an ordinate, the points of a table on
        either side, the rotation of the largest
    subject : what the line is about in the user's own words, as the name of a load
    """

    symbol: str
    description: str
    clause: str
    formula: str
    substituted: str
    value: float | None
    unit: str
    bound: Bound = ""
    inputs: tuple[Input, ...] = ()
    dimension: str = ""
    remark: str = ""
    at: tuple[Input, ...] = ()
    subject: str = ""

    def __post_init__(self) -> None:
        if not self.dimension:
            object.__setattr__(self, "dimension", DIMENSIONS.get(self.unit, self.unit))


Given = Mapping[str, float | tuple[float, str]]
"""Values by symbol: a ratio, or (value, unit)."""
Write = Callable[[float], str]
"""What writes a number of a formula."""


def write_plain(value: float) -> str:
    """Write a number to `INPUT_FIGURES`."""
    return f"{value:.{INPUT_FIGURES}g}"


def step(
    symbol: str,
    description: str,
    clause: str,
    formula: str,
    value: float | None,
    unit: str = "-",
    *,
    given: Given | None = None,
    remark: str = "",
    bound: Bound = "",
    at: Given | None = None,
    subject: str = "",
) -> Step:
    """Return the line of a calculation sheet with the given values put into its formula.

    Parameters
    ----------
    symbol, description, clause : as the sheet prints them; description and clause are literals, which never vary
    formula : in terms of the symbols of `given`
    value : the result, in `unit`; None where there is no finite value
    unit : of the result
    given : the value of each symbol of the formula; symbols that are not in it are printed after it
    remark : a literal: why the value is what it is, where the formula does not say
    bound : "<=" or ">=" where `value` is a bound
    at : where the value, or an input, was read
    subject : name or reason of the project file that the line is about

    Returns
    -------
    Step
    """
    inputs = tuple(_input(name, each) for name, each in (given or {}).items())
    places = tuple(_input(name, each) for name, each in (at or {}).items())
    said = (substitute(formula, inputs) if inputs else "", values_text(places), remark)
    substituted = ", ".join(part for part in said if part) or _plain(value)
    return Step(
        symbol,
        description,
        clause,
        formula,
        substituted,
        value,
        unit,
        bound,
        inputs,
        remark=remark,
        at=places,
        subject=subject,
    )


def substitute(formula: str, inputs: tuple[Input, ...], write: Write = write_plain) -> str:
    """Return the formula with numbers for its symbols, and g as a number; other symbols follow with their values.

    Parameters
    ----------
    formula : of the symbols of `inputs`
    inputs : with their values
    write : a number as it is to be printed

    Returns
    -------
    str
    """
    values = {each.symbol: each.value for each in inputs}
    absent = tuple(each for each in inputs if not _pattern([each.symbol]).search(formula))
    known = {**{name: value for name, value in CONSTANTS.items() if name == "g"}, **values}
    put = _pattern(list(known)).sub(lambda found: _operand(found, write(known[found[0]])), formula)
    put = _BETWEEN.sub(" · ", put)
    beside = values_text(absent, write)
    if len(absent) == len(inputs):  # nothing to put in: the values alone
        return beside
    return f"{put}, {beside}" if beside else put


def values_text(inputs: tuple[Input, ...], write: Write = write_plain) -> str:
    """Return symbols with their values, as "T = 0.5, ξ = 0.05".

    Parameters
    ----------
    inputs : to write
    write : a number as it is to be printed
    """
    return ", ".join(f"{each.symbol} = {write(each.value)}" for each in inputs)


def _operand(found: re.Match[str], number: str) -> str:
    """Return a number for a symbol; a negative one in brackets, unless it opens the formula or a bracket."""
    before, after = found.string[: found.start()], found.string[found.end() :]
    opens = before in ("", "(") or before.endswith(("(", "|"))
    alone = opens and not after.startswith(("²", "³", "^"))
    return number if number[:1] not in "-−" or alone else f"({number})"


def _pattern(symbols: list[str]) -> re.Pattern[str]:
    longest = sorted(map(re.escape, symbols), key=len, reverse=True)
    return re.compile(rf"(?<!{_PART})({'|'.join(longest)})(?!{_PART})")


def _plain(value: float | None) -> str:
    return "none" if value is None else write_plain(value)


def _input(symbol: str, given: float | tuple[float, str]) -> Input:
    value, unit = given if isinstance(given, tuple) else (given, "-")
    return Input(symbol, float(value), DIMENSIONS.get(unit, unit))
