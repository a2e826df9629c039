"""Ranges of the values of a key, as they are typed: "100..800 mm^2", "100..800 mm^2 by 50", "2..6", "200, 314 mm^2"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from assess.errors import ProjectError
from assess.project.key_errors import value_text
from assess.project.units import QuantityError, QuantityKind, number_and_unit, si_value
from spectra.arrays import is_number

_NUMBER = r"[+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]{1,3})?"
_RANGE = re.compile(rf"\s*({_NUMBER})\s*\.\.\s*({_NUMBER})\s*(.*?)\s*(?:\bby\s+({_NUMBER})\s*(.*?))?\s*")
VALUES, MOST_VALUES = 8, 200
"""Values of a range whose step is not given, and most values of one."""


def values_of(given: Any, kind: QuantityKind, *, where: str, whole: bool = False) -> tuple[tuple[float, ...], str]:
    """Return the values of a range or list, each once, with their unit.

    Parameters
    ----------
    given : as it is typed, or a list of numbers and quantities
    kind : what they measure
    where : what an error begins with
    whole : whether they are counts

    Raises
    ------
    ProjectError : it is no range, a value is none of its kind, or there are too many
    """
    found = _RANGE.fullmatch(given) if isinstance(given, str) else None
    if found:
        numbers, unit = _spread(found, where=where, given=given, whole=whole)
    else:
        items = given.split(",") if isinstance(given, str) else given
        if not isinstance(items, Sequence) or not items:
            raise ProjectError(f'{where}: {value_text(given)}: no range; write one like "100..800 mm^2" or "2, 3, 4"')
        parts = [_number_and_unit(each, where) for each in items]
        units = [unit for _, unit in parts if unit]
        unit = units[-1] if units else ""
        if len(set(units)) > 1:
            raise ProjectError(f"{where}: {value_text(given)}: values in several units; write all in one")
        numbers = [number for number, _ in parts]
    try:
        for number in numbers:
            si_value(written_value(number, unit), kind)
    except QuantityError as error:
        raise ProjectError(f"{where}: {value_text(given)}: {error}") from None
    if whole and any(number < 0 or not float(number).is_integer() for number in numbers):
        raise ProjectError(f'{where}: {value_text(given)}: a count; write whole numbers from 0, like "2..6"')
    return tuple(dict.fromkeys(numbers)), unit


def written_value(value: float, unit: str) -> Any:
    """Write a value as a project file has it.

    Parameters
    ----------
    value, unit : the number and its unit, "" for none
    """
    return f"{value:.12g} {unit}" if unit else int(value) if float(value).is_integer() else float(f"{value:.12g}")


def unit_size(unit: str, kind: QuantityKind) -> float:
    """Return the size of a unit in SI.

    Parameters
    ----------
    unit : as it is typed, "" for SI
    kind : what it measures
    """
    return si_value(f"1 {unit}", kind) if unit else 1.0


def _number_and_unit(given: Any, where: str) -> tuple[float, str]:
    if is_number(given):
        return float(given), ""
    try:
        number, unit = number_and_unit(str(given))
    except QuantityError as error:
        raise ProjectError(f"{where}: {value_text(given)}: {error}") from None
    return float(number), unit


def _spread(found: re.Match[str], *, where: str, given: str, whole: bool) -> tuple[list[float], str]:
    """Return the values of a range, in its unit."""
    low, high, unit = float(found[1]), float(found[2]), found[3]
    step = float(found[4]) if found[4] else 1.0 if whole else (high - low) / (VALUES - 1)
    if low == high and found[5] in (None, "", unit):
        return [low], unit
    if not low < high or not step > 0.0 or found[5] not in (None, "", unit):
        raise ProjectError(
            f'{where}: {value_text(given)}: write the lesser end first and one unit, like "100..800 mm^2 by 50"'
        )
    number = int((high - low) / step + 1e-9) + 1
    if number > MOST_VALUES:
        raise ProjectError(
            f"{where}: {value_text(given)}: {number} values; write a step that makes {MOST_VALUES} at most"
        )
    values = [float(f"{low + step * place:.12g}") for place in range(number)]
    return (values if abs(values[-1] - high) <= 1e-9 * max(abs(high), 1.0) else [*values, high]), unit
