"""Every number of a document, as it is kept, as a locale writes it and read back, and the numbers of results."""

from __future__ import annotations

import bisect
import dataclasses
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite, pi
from statistics import median
from typing import Any

import numpy as np
from scipy.constants import g

from assess.messages.message import Quantity
from assess.results import MechanismResult, Results
from reports import governing
from reports.assessment import assessment
from reports.chapters.declaration import WITHIN_ROUNDING
from reports.document import Column, Document, Figure, Table
from reports.language.locale import UNITS, Locale
from reports.render.table_text import cell_text
from spectra.arrays import FloatArray

FIXED = (WITHIN_ROUNDING,)
"""Numbers of the program that a sentence names: below which difference a control is within rounding."""


@dataclass(frozen=True)
class Shown:
    """A number of a document. size: of its unit; where: the words around it."""

    value: float
    size: float
    text: str
    where: str


def shown_numbers(document: Document, locale: Locale) -> Iterator[Shown]:
    """Yield the numbers of all texts, tables and captions of a document; figures are drawn from the same results."""
    for block in (*document.blocks, *document.data):
        if isinstance(block, Table):
            yield from _of_table(block, locale)
        yield from (_of_quantity(each, locale, type(block).__name__) for each in quantities(block))
    for section in document.sections:
        yield from (_of_quantity(each, locale, "title") for each in quantities(section.title))


def quantities(node: object) -> Iterator[Quantity]:
    """Yield every quantity below a node of a document."""
    if isinstance(node, Quantity):
        yield node
    elif isinstance(node, Figure):
        yield from quantities(node.caption)
    elif dataclasses.is_dataclass(node) and not isinstance(node, type):
        for field in dataclasses.fields(node):
            yield from quantities(getattr(node, field.name))
    elif isinstance(node, Mapping):
        for each in node.values():
            yield from quantities(each)
    elif isinstance(node, list | tuple):
        for each in node:
            yield from quantities(each)


def _of_quantity(found: Quantity, locale: Locale, where: str) -> Shown:
    unit = UNITS[locale.system][found.dimension].unit_for(found.value)
    return Shown(found.value, unit.size, locale.text(found), where)


def _of_table(table: Table, locale: Locale) -> Iterator[Shown]:
    for row in table.rows:
        for cell, column in zip(row, table.columns, strict=True):
            if isinstance(cell, int | float) and not isinstance(cell, bool):
                yield Shown(float(cell), _size(column, locale), cell_text(cell, column, locale), table.name)


def _size(column: Column, locale: Locale) -> float:
    return locale.table_unit(column.dimension).size if column.dimension else 1.0


def misread(shown: Shown, *, point: str) -> bool:
    """Return whether a number as it is written is more than half a unit of its last digit off."""
    if not isfinite(shown.value):
        return False
    read = read_number(shown.text, point=point)
    return abs(read.value - shown.value / shown.size) > 0.5 * read.last_digit * (1 + 1e-9)


def numbers_of(results: Results) -> FloatArray:
    """Return every number of results, as it is and as a report may give it: without sign, in g, in percent, counted.

    Rising, each once [n].
    """
    plain = np.unique(np.abs(np.fromiter(_numbers(results), np.float64)))
    changed = [plain * factor for factor in (1.0, g, 1.0 / g, 100.0, pi / 180.0)]
    return np.unique(np.concatenate([*changed, 1.0 - plain[plain < 1.0]]))


def _numbers(results: Results) -> Iterator[float]:
    left: list[object] = [results]
    while left:
        node = left.pop()
        if isinstance(node, int | float):
            if not isinstance(node, bool):
                yield float(node)
        elif isinstance(node, list | tuple):
            left.extend(node)
        elif isinstance(node, Mapping):
            left.extend(node.values())
        elif dataclasses.is_dataclass(node):
            left.extend(getattr(node, field.name) for field in dataclasses.fields(node))


def derived_numbers(results: Results) -> list[float]:
    """Return the numbers that a report works out from results.

    By how much capacities differ, how many times as large one must be, and what joints carry at peaks.
    """
    capacities = [
        [check.capacity_pga_g for check in mechanism.checks if check.capacity_pga_g and check.reading == "letter"]
        for mechanism in results.mechanisms
    ]
    quotients = [one / other for found in capacities for one in found for other in found]
    widest = [max(found) / min(found) for found in map(_of_each_procedure, results.mechanisms) if len(found) > 1]
    decided = () if results.verdict is None else results.verdict.mechanisms
    wanted = [1.0 / each.margin for each in decided if each.margin]
    pressed = [number for mechanism in results.mechanisms for number in _at_peaks(mechanism)]
    return sorted([*quotients, *([median(widest)] if widest else []), *wanted, *pressed])


def _of_each_procedure(mechanism: MechanismResult) -> list[float]:
    """Return the PGA at capacity of a mechanism by each method of a code [g], those that it withstands at all."""
    return [
        each
        for each in governing.capacities(governing.answered_checks(governing.code_checks(mechanism.checks))).values()
        if each > 0.0
    ]


def _at_peaks(mechanism: MechanismResult) -> Iterator[float]:
    """Yield stress, resultant, open and crushed share (also in percent) of each joint at the peak of each history."""
    sides = (mechanism.oscillator, mechanism.oscillator_negative)
    rest = [side.equilibrium_rad for side in sides if side is not None]
    peaks = {abs(one.max_rotation_rad) + more for one in mechanism.histories if one.max_rotation_rad for more in rest}
    curves: list[dict[str, Any]] = [each["curve"] for each in mechanism.interfaces if each["curve"] is not None]
    for curve in curves:
        for key in ("peak_stress_pa", "resultant_m", "open_share", "crushed_share"):
            for value in np.interp(sorted(peaks), curve["mechanism_rotation_rad"], curve[key]):
                yield from (float(value), 100.0 * float(value))


def is_known(value: float, known: Sequence[float]) -> bool:
    """Return whether a number is one of those known, to rounding."""
    place = bisect.bisect_left(known, abs(value) * (1 - 1e-12) - 1e-300)
    return not isfinite(value) or (place < len(known) and known[place] <= abs(value) * (1 + 1e-12) + 1e-300)


def strange_numbers(results: Results, shown: Iterable[Shown] | None = None) -> set[tuple[str, str]]:
    """Return the numbers of a full report, with where they are, that are not of its results.

    What is not in results is worked out from them, is a small whole number, a count or a place in a list, or is a fixed
    number of the program, said in a sentence.

    shown : the numbers of that report, where they are known already
    """
    if shown is None:
        document = assessment(results, detail="full")
        shown = shown_numbers(document, document.writer)
    known = np.sort(np.concatenate([numbers_of(results), derived_numbers(results), FIXED])).tolist()
    return {
        (each.where, each.text)
        for each in shown
        if not is_known(each.value, known) and not (each.value == int(each.value) and 0 <= each.value < 1000)
    }


_NUMBER = re.compile(r"(−?)(\d+)(?:([.,])(\d+))?(?:×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?")
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@dataclass(frozen=True)
class WrittenNumber:
    """A number as it is read. last_digit: what one unit of its last digit is worth, of a whole number of its zeros."""

    value: float
    last_digit: float


def read_number(text: str, *, point: str = ".") -> WrittenNumber:
    """Return the number that a text begins with; raises ValueError where it begins with none."""
    found = _NUMBER.match(text)
    if found is None or (found[3] is not None and found[3] != point):
        raise ValueError(f"{text!r} does not begin with a number")
    sign, whole, _, decimals, power = found.groups()
    scale = 10.0 ** int((power or "⁰").translate(_RAISED))
    value = float(f"{whole}.{decimals or '0'}") * scale * (-1 if sign else 1)
    zeros = len(whole) - len(whole.rstrip("0")) if decimals is None and value else 0
    return WrittenNumber(value, 10.0 ** (zeros - len(decimals or "")) * scale)
