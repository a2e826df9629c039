"""What kind of value each field of a definition takes: a number, a text, a place; read from its annotations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from numbers import Integral
from types import NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from spectra.arrays import is_number

WORDS = {float: "a number", int: "a whole number", str: "a text", bool: "True or False"}
PLACE = "(x, y, z), or (along the direction, up)"
REMEDIES = {
    "at": PLACE,
    "anchor": PLACE,
    "direction": '(x, y, 0), "weakest" or "sweep"',
    "cut": "an elevation [m], a CutPlane or a CutAngle",
    "crack": 'an elevation [m], "sorrentino" or "minimum"',
    "hinges": f"the hinges from A on, each {PLACE}",
    "hinges_negative": f"the hinges from A on, each {PLACE}",
    "restitution": "a number in [0, 1], or the name of a rule",
}
LONGEST = 60  # characters of a value in a message


def type_problems(data: Any, where: str = "") -> Iterator[str]:
    """Yield each field whose value is of another kind than its annotation says, with what to give.

    Parameters
    ----------
    data : a definition, a load, an interface: any frozen dataclass
    where : what stands before the names of its fields
    """
    for name, kind in _kinds(type(data)).items():
        value, key = getattr(data, name), f"{where}{name}"
        if _fits(value, kind):
            yield from _inside(value, key)
        else:
            remedy = PLACE if where and name == "direction" else REMEDIES.get(name)
            yield f"{key} = {repr(value)[:LONGEST]}: give {remedy or _wanted(kind)}"


def _inside(value: Any, key: str) -> Iterator[str]:
    """Look into what a field holds: other data, and rows of them."""
    if is_dataclass(value) and not isinstance(value, type):
        yield from type_problems(value, f"{key}.")
    elif isinstance(value, tuple):
        for number, each in enumerate(value, start=1):
            yield from _inside(each, f"{key}[{number}]")
    elif isinstance(value, Mapping):
        for name, each in value.items():
            yield from _inside(each, f"{key}.{name}")


def _kinds(of: Any) -> dict[str, Any]:
    """Return the annotation of each field of a class."""
    hints = get_type_hints(of)
    return {field.name: hints[field.name] for field in fields(of)}


def _fits(value: Any, kind: Any) -> bool:
    """Tell whether a value is of a kind; which texts are known is left to the checks of values."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin in (Union, UnionType):
        return any(_fits(value, each) for each in inner)
    if origin is Literal:
        return isinstance(value, tuple({type(each) for each in inner}))
    if origin is tuple:
        return isinstance(value, tuple) and _row_fits(value, inner)
    if origin is not None:
        return isinstance(value, origin) and all(_fits(each, inner[1]) for each in value.values())
    if kind in (float, int):
        return is_number(value) and (kind is float or isinstance(value, Integral))
    return kind is Any or isinstance(value, (bool, np.bool_) if kind is bool else kind)


def _row_fits(values: tuple[Any, ...], kinds: tuple[Any, ...]) -> bool:
    if kinds[-1] is Ellipsis:
        return all(_fits(each, kinds[0]) for each in values)
    return len(values) == len(kinds) and all(map(_fits, values, kinds))


def _wanted(kind: Any) -> str:
    """Say what a kind of value is, without the None that leaves it out."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin in (Union, UnionType):
        return " or ".join(dict.fromkeys(_wanted(each) for each in inner if each is not NoneType))
    if origin is Literal:
        return " or ".join(f'"{each}"' for each in inner)
    if origin is tuple and inner[-1] is Ellipsis:
        return f"a list, each {_wanted(inner[0])}"
    if origin is tuple:
        return f"({', '.join(_wanted(each).removeprefix('a ') for each in inner)})"
    if origin is not None:
        return f"a table of names, each {_wanted(inner[1])}"
    name: str = kind.__name__
    return WORDS.get(kind, f"{'an' if name[0] in 'AEIOU' else 'a'} {name}")
