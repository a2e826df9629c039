"""One line of a calculation sheet; its numbers are put into its formula by `substitute`, never written twice."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from math import pi
from typing import Literal

from scipy.constants import g

from assess.messages.message import DIMENSIONS
from assess.short_repr import ShortRepr

Bound = Literal["", "<=", ">="]
CONSTANTS: Mapping[str, float] = {"g": g, "π": pi}
_PART = r"(?:[^\W²³]|[*'′₀-₉])"  # what a symbol may be made of, so that none is found inside another
_BETWEEN = re.compile(r"(?<=[\d²³)π]) (?=[\d√(])")  # a product written side by side, once numbers stand there


@dataclass(frozen=True)
class Input:
    """A symbol of a formula with its value, in the unit of its dimension (`assess.messages.message.UNITS`)."""

    symbol: str
    value: float
    dimension: str


@dataclass(frozen=True, repr=False)
class Step(ShortRepr):
    """One line of a calculation sheet: the formula, the numbers put into it, and the result.

    inputs : the symbols of the formula; `substituted` is made from them (see `step`)
    bound : "<=" or ">=" where the value is only an upper or a lower bound
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

    def __post_init__(self) -> None:
        if not self.dimension:
            object.__setattr__(self, "dimension", DIMENSIONS.get(self.unit, self.unit))


Given = Mapping[str, float | tuple[float, str]]
"""Values by symbol: a ratio, or (value, unit)."""


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
) -> Step:
    """Return the line of a calculation sheet with the given values put into its formula.

    Parameters
    ----------
    symbol, description, clause : as the sheet prints them
    formula : in terms of the symbols of `given`
    value : the result, in `unit`; None where there is no finite value
    unit : of the result
    given : the value of each symbol of the formula; symbols that are not in it are printed after it
    remark : words in place of numbers where the formula has none to put in, as "curve" or "geometry"
    bound : "<=" or ">=" where `value` is a bound

    Returns
    -------
    Step
    """
    inputs = tuple(_input(name, each) for name, each in (given or {}).items())
    substituted = substitute(formula, inputs) if inputs else remark or _plain(value)
    if inputs and remark:
        substituted = f"{substituted}, {remark}"
    return Step(symbol, description, clause, formula, substituted, value, unit, bound, inputs)


def substitute(formula: str, inputs: tuple[Input, ...]) -> str:
    """Return the formula with numbers for its symbols, and g as a number; other symbols follow with their values."""
    values = {each.symbol: each.value for each in inputs}
    absent = [each for each in inputs if not _pattern([each.symbol]).search(formula)]
    known = {**{name: value for name, value in CONSTANTS.items() if name == "g"}, **values}
    put = _pattern(list(known)).sub(lambda found: _number(found[0], known[found[0]]), formula)
    put = _BETWEEN.sub(" · ", put)
    beside = ", ".join(f"{each.symbol} = {_plain(each.value)}" for each in absent)
    if len(absent) == len(inputs):  # nothing to put in: the values alone
        return beside
    return f"{put}, {beside}" if beside else put


def _pattern(symbols: list[str]) -> re.Pattern[str]:
    longest = sorted(map(re.escape, symbols), key=len, reverse=True)
    return re.compile(rf"(?<!{_PART})({'|'.join(longest)})(?!{_PART})")


def _number(symbol: str, value: float) -> str:
    return f"{value:.6g}" if symbol == "g" and value == g else _plain(value)


def _plain(value: float | None) -> str:
    return "none" if value is None else f"{value:.5g}"


def _input(symbol: str, given: float | tuple[float, str]) -> Input:
    value, unit = given if isinstance(given, tuple) else (given, "-")
    return Input(symbol, float(value), DIMENSIONS.get(unit, unit))
