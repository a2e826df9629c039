"""A sweep of the project file, [analysis.sweep], as one whole project file for each of its values.

The value is put at its key in what the file says and the whole is read through the schema again, so a case is
checked like any project.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from assess.errors import ProjectError
from assess.project.key_text import error_line, key_text, value_text
from assess.project.keys import Given, Key, Place, one_number, place_of, places_of, value_at, with_value
from assess.project.quantity_text import QuantityError, number_and_unit
from assess.project.sections.content import Content
from assess.project.sections.sweeps import Sweep


@dataclass(frozen=True)
class Variant:
    """The project file with one value of a sweep: the number typed, the case named for errors, and what it says."""

    value: float
    name: str
    content: Content


@dataclass(frozen=True)
class Variation:
    """One sweep.

    Attributes
    ----------
    where : the table, for errors; key : what is swept, as the user wrote it; path : its steps
    unit : of the values, as the user wrote it, or SI where they are plain numbers; "-" for none
    variants : one for each value, in the user's order
    """

    where: str
    key: str
    path: Key
    unit: str
    variants: tuple[Variant, ...]


def variations(content: Content, raw: Mapping[str, Any], folder: Path) -> tuple[Variation, ...]:
    """Return every sweep of the project, with the `content` read from the `raw` file in `folder`.

    Raises ProjectError for a key that is unknown or not a number, and for the first case that breaks the schema.
    """
    sweeps = content.analysis.sweeps
    if not sweeps:
        return ()
    places = places_of(content)
    single = isinstance(content.analysis.sweep, Sweep)
    names = ["analysis.sweep"] if single else [f"analysis.sweep[{i}]" for i in range(1, len(sweeps) + 1)]
    return tuple(
        _variation(sweep, place_of(sweep.key, places, where=where), content, raw, folder, where=where)
        for sweep, where in zip(sweeps, names, strict=True)
    )


def _variation(
    sweep: Sweep, place: Place, content: Content, raw: Mapping[str, Any], folder: Path, *, where: str
) -> Variation:
    variants, units = [], []
    for given in sweep.values or _range(sweep, where=where):
        name = f"{where}: {sweep.key} = {value_text(given)}"
        read = read_case(with_value(raw, place.path, given, content), folder, place.path, given, name=name)
        number, unit = _typed(given, where=name)
        units.append(unit)
        if unit != units[0]:
            raise ProjectError(f"{name}: not in the unit of the first value; write all in one unit")
        variants.append(Variant(number, name, read))
    symbol = "-" if place.kind is None else place.kind.symbol.replace("no unit", "-")
    return Variation(where, sweep.key, place.path, units[0] or symbol, tuple(variants))


def _range(sweep: Sweep, *, where: str) -> tuple[Given, ...]:
    """Return evenly spaced values in the unit of both ends."""
    assert sweep.start is not None  # the schema asks for all three
    assert sweep.to is not None
    assert sweep.count is not None
    low, unit = _typed(sweep.start, where=f"{where}.from: {value_text(sweep.start)}")
    high, other = _typed(sweep.to, where=f"{where}.to: {value_text(sweep.to)}")
    if unit != other:
        raise ProjectError(f"{where}.to: {value_text(sweep.to)}: not in the unit of from; write both in one unit")
    if low == high:
        raise ProjectError(f"{where}.to: {value_text(sweep.to)}: the same as from; give another, or values = [ … ]")
    numbers = [float(f"{number:.12g}") for number in np.linspace(low, high, sweep.count).tolist()]
    if isinstance(sweep.start, int) and isinstance(sweep.to, int) and all(map(float.is_integer, numbers)):
        return tuple(map(int, numbers))
    return tuple(f"{number:.12g} {unit}" if unit else number for number in numbers)


def _typed(value: Given, *, where: str) -> tuple[float, str]:
    """Return the number and the unit that the user wrote."""
    if not isinstance(value, str):
        return float(value), ""
    try:
        number, unit = number_and_unit(value)
    except QuantityError as error:
        remedy = "" if "; write " in str(error) else "; write a number, or one with its unit"
        raise ProjectError(f"{where}: {error}{remedy}") from None
    return float(number), unit


def read_case(raw: Mapping[str, Any], folder: Path, path: Key, value: Any, *, name: str) -> Content:
    """Read the content of one case, `raw` with the number `value` at `path`; name: of the case, for errors."""
    try:
        content = Content.model_validate(raw, context={"folder": folder})
    except ValidationError as error:
        said = f"{key_text(path)}: {value_text(value)}: "  # by the name of the case already
        raise ProjectError(f"{name}: {error_line(error, raw=raw).removeprefix(said)}") from None
    if not one_number(value_at(content, path)):
        raise ProjectError(f"{name}: not a number; only numbers can be swept")
    return content
