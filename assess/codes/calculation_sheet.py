"""The lines of calculation sheets: a formula with its numbers put into it, and readings of a mechanism's table.

Numbers are put into formulas by `substitute`, never written twice. Between the nodes of a table lies a cubic spline.
Where a straight line between the neighbouring nodes, or Simpson's rule with few ordinates, comes to the same within
`TOLERANCE`, the line is that formula with its numbers; elsewhere it names the points between which the spline was read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import isclose, pi
from typing import TYPE_CHECKING, Literal

import numpy as np

from assess.messages.message import DIMENSIONS
from assess.oscillator import Branch, linear_multiplier, multiplier
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray
from spectra.gravity import g

if TYPE_CHECKING:
    from scipy.interpolate import PPoly

Bound = Literal["", "<=", ">="]
CONSTANTS: Mapping[str, float] = {"g": g, "π": pi}

INPUT_FIGURES, RESULT_FIGURES = 7, 4
"""Significant figures at which formula and inputs as printed give the result as printed."""
UNANSWERED = "not answered: the reason of the check says why"
_PART = r"(?:[^\W²³]|[*'′₀-₉])"  # what a symbol may be made of, so that none is found inside another
_BETWEEN = re.compile(r"(?<=[\d¹²³⁰⁴-⁹)π]) (?=[\d√(])")  # a product written side by side, once numbers stand there


@dataclass(frozen=True)
class SymbolValue:
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
    inputs: tuple[SymbolValue, ...] = ()
    dimension: str = ""
    remark: str = ""
    at: tuple[SymbolValue, ...] = ()
    subject: str = ""

    def __post_init__(self) -> None:
        if not self.dimension:
            object.__setattr__(self, "dimension", DIMENSIONS.get(self.unit, self.unit))


Given = Mapping[str, float | tuple[float, str]]
"""Values by symbol: a ratio, or (value, unit)."""

NumberWriter = Callable[[float], str]
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
    inputs = tuple(_symbol_value(name, each) for name, each in (given or {}).items())
    places = tuple(_symbol_value(name, each) for name, each in (at or {}).items())
    written = (substitute(formula, inputs) if inputs else "", values_text(places), remark)
    substituted = ", ".join(part for part in written if part) or ("none" if value is None else write_plain(value))
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


def substitute(formula: str, inputs: tuple[SymbolValue, ...], write: NumberWriter = write_plain) -> str:
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
    absent = tuple(each for each in inputs if not _holds(formula, each.symbol))
    known = {**{name: value for name, value in CONSTANTS.items() if name == "g"}, **values}
    put = _pattern(tuple(known)).sub(lambda found: _operand(found, write(known[found[0]])), formula)
    put = _BETWEEN.sub(" · ", put)
    beside = values_text(absent, write)
    if len(absent) == len(inputs):  # nothing to put in: the values alone
        return beside
    return f"{put}, {beside}" if beside else put


def values_text(inputs: tuple[SymbolValue, ...], write: NumberWriter = write_plain) -> str:
    """Return symbols with their values, as "T = 0.5, ξ = 0.05".

    Parameters
    ----------
    inputs : to write
    write : a number as it is to be printed
    """
    return ", ".join(f"{each.symbol} = {write(each.value)}" for each in inputs)


def multiplier_step(symbol: str, description: str, clause: str, branch: Branch) -> Step:
    """Write the multiplier at rest, or on flexible joints the largest of the curve [-].

    Parameters
    ----------
    symbol, description, clause : as the sheet prints them
    branch : the direction of rocking

    Returns
    -------
    Step
    """
    found, along = linear_multiplier(branch), multiplier(branch)
    if found <= float(along[0]):
        at_rest = {
            "V'(0) − M": (float(branch.restoring[0]), "N m"),
            "B0": (float(branch.excitation[0]), "kg m"),
        }
        return step(symbol, description, clause, "(V'(0) − M) / (g B0)", found, given=at_rest)
    standing = np.where(branch.rotation <= branch.unstable, along, -np.inf)
    place = int(np.argmax(standing))
    given: Given = {
        "R_m": (float(branch.restoring[place]), "N m"),
        "B_m": (float(branch.excitation[place]), "kg m"),
    }
    at = {"φ_m": (float(branch.rotation[place]), "rad")}
    return step(symbol, description, clause, "R_m / (g B_m)", found, given=given, remark=EVERY_POINT, at=at)


TOLERANCE = 5e-6  # relative: a tenth of half a unit of the fourth figure
STRIPS = (2, 4, 8, 16)  # of Simpson's rule
SPLINE = "cubic spline between the neighbouring points of the table"
INTEGRAL = "integral of the cubic spline through the table"
Point = tuple[float, float]
EVERY_POINT = "largest of all points of the table"


@dataclass(frozen=True)
class TableColumn:
    """A column of the table of a branch: how a line writes it and its argument, its unit, its nodes and its spline."""

    letter: str
    unit: str
    rotation: FloatArray
    values: FloatArray
    spline: PPoly
    integral: PPoly


def moment_column(branch: Branch) -> TableColumn:
    """Return the restoring moment R [N m]."""
    return TableColumn("R", "N m", branch.rotation, branch.restoring, branch.restoring_spline, branch.energy_spline)


def excitation_column(branch: Branch) -> TableColumn:
    """Return the excitation B [kg m]."""
    return TableColumn(
        "B", "kg m", branch.rotation, branch.excitation, branch.excitation_spline, branch.excitation_integral
    )


def integral_step(
    symbol: str, description: str, clause: str, column: TableColumn, end: float, unit: str, *, upper: str = "φ"
) -> Step:
    """Write the integral of a column from rest to a rotation.

    Parameters
    ----------
    symbol, description, clause : as of `step`
    column : what is integrated
    end : rotation up to which [rad]
    unit : of the integral
    upper : symbol of that rotation

    Returns
    -------
    By Simpson's rule with the fewest ordinates that come to the integral; else a reading with its end.
    """
    value = float(column.integral(end))
    for strips in STRIPS:
        ordinates = np.asarray(column.spline(np.linspace(0.0, end, strips + 1)))
        weights = np.array([1.0, *([4.0, 2.0] * strips)[: strips - 1], 1.0])
        if isclose(end / (3.0 * strips) * float(weights @ ordinates), value, rel_tol=TOLERANCE):
            names = [f"{column.letter}_{number}" for number in range(strips + 1)]
            terms = [
                name if weight == 1.0 else f"{weight:g} {name}" for weight, name in zip(weights, names, strict=True)
            ]
            given: Given = {
                upper: (end, "rad"),
                **{name: (each, column.unit) for name, each in zip(names, ordinates.tolist(), strict=True)},
            }
            formula = f"{upper} / {3 * strips} ({' + '.join(terms)})"
            return step(symbol, description, clause, formula, value, unit, given=given)
    return step(
        symbol,
        description,
        clause,
        "∫ R dφ" if column.letter == "R" else "∫ B dφ",
        value,
        unit,
        remark=INTEGRAL,
        at={upper: (end, "rad"), "n": float(np.searchsorted(column.rotation, end))},
    )


def reading_step(
    symbol: str,
    description: str,
    clause: str,
    column: TableColumn,
    rotation: float,
    *,
    value: float | None = None,
    argument: str = "φ",
) -> Step:
    """Write the value of a column at a rotation.

    Parameters
    ----------
    symbol, description, clause : as of `step`
    column : what is read
    rotation : where [rad]
    value : that was read; None for that of the spline
    argument : symbol of the rotation
    """
    found = float(column.spline(rotation)) if value is None else value
    (x1, y1), (x2, y2) = neighbours(column, rotation)
    given = {argument: (rotation, "rad"), **_neighbour_values(column, rotation)}
    letter = column.letter
    if x2 > x1 and isclose(y1 + (y2 - y1) * (rotation - x1) / (x2 - x1), found, rel_tol=TOLERANCE):
        formula = f"{letter}_1 + ({letter}_2 − {letter}_1) ({argument} − φ_1) / (φ_2 − φ_1)"
        return step(symbol, description, clause, formula, found, column.unit, given=given)
    return step(symbol, description, clause, "table of the mechanism", found, column.unit, remark=SPLINE, at=given)


def instability_step(symbol: str, description: str, clause: str, branch: Branch) -> Step:
    """Write the rotation at which the restoring moment of the table falls to zero.

    Parameters
    ----------
    symbol, description, clause : as of `step`
    branch : the direction of rocking
    """
    column, value = moment_column(branch), branch.unstable
    (x1, y1), (x2, y2) = neighbours(column, value)
    given = _neighbour_values(column, value)
    if y1 > y2 and isclose(x1 + y1 * (x2 - x1) / (y1 - y2), value, rel_tol=TOLERANCE):
        formula = "φ_1 + R_1 (φ_2 − φ_1) / (R_1 − R_2)"
        return step(symbol, description, clause, formula, value, "rad", given=given)
    return step(symbol, description, clause, "restoring moment = 0", value, "rad", remark=SPLINE, at=given)


def neighbours(column: TableColumn, rotation: float) -> tuple[Point, Point]:
    """Return the points of a table on either side of a rotation [rad]; before a jump where it lies on one."""
    nodes = column.rotation
    high = int(np.clip(np.searchsorted(nodes, rotation, side="left"), 1, nodes.size - 1))
    first, last = ((float(nodes[at]), float(column.values[at])) for at in (high - 1, high))
    return first, last


def _operand(found: re.Match[str], number: str) -> str:
    """Return a number for a symbol; a negative one in brackets, unless it opens the formula or a bracket."""
    before, after = found.string[: found.start()], found.string[found.end() :]
    opens = before in ("", "(") or before.endswith(("(", "|"))
    unbracketed = opens and not after.startswith(("²", "³", "^"))
    return number if number[:1] not in "-−" or unbracketed else f"({number})"


@lru_cache(maxsize=4096)
def _holds(formula: str, symbol: str) -> bool:
    """Return whether a symbol stands in a formula."""
    return _pattern((symbol,)).search(formula) is not None


@lru_cache(maxsize=4096)
def _pattern(symbols: tuple[str, ...]) -> re.Pattern[str]:
    longest = sorted(map(re.escape, symbols), key=len, reverse=True)
    return re.compile(rf"(?<!{_PART})({'|'.join(longest)})(?!{_PART})")


def _symbol_value(symbol: str, given: float | tuple[float, str]) -> SymbolValue:
    value, unit = given if isinstance(given, tuple) else (given, "-")
    return SymbolValue(symbol, float(value), DIMENSIONS.get(unit, unit))


def _neighbour_values(column: TableColumn, rotation: float) -> dict[str, float | tuple[float, str]]:
    (x1, y1), (x2, y2) = neighbours(column, rotation)
    letter, unit = column.letter, column.unit
    return {"φ_1": (x1, "rad"), f"{letter}_1": (y1, unit), "φ_2": (x2, "rad"), f"{letter}_2": (y2, unit)}
