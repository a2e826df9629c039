"""What is wrong with data of Python by what their classes declare (`assess.declaration`), in the words of the files."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import is_dataclass
from functools import reduce
from numbers import Integral
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from assess.declaration import Mark, annotations_of, one_of
from spectra.arrays import is_number

KINDS = {
    float: ("a number", "give one in SI units"),
    int: ("a whole number", "write one without decimal point"),
    str: ("a text", "write it in quotes"),
    bool: ("a truth value", "give True or False"),
}
"""What a value of each kind is called, as in the messages of project files, and the remedy in Python."""
LONGEST = 60  # characters of a value in a message


def declared_problems(data: Any, where: str = "", *, forms: Mapping[str, str] | None = None) -> Iterator[str]:
    """Yield each field whose value is not what is declared, with what to give, and then those that do not go together.

    Parameters
    ----------
    data : a definition, a load, an interface: any frozen dataclass
    where : what stands before the names of its fields
    forms : what to give in place of a value of another form, by field, where neither a mark nor the type says it well
    """
    kind: type = type(data)
    for name, annotation in annotations_of(kind).items():
        value, key = getattr(data, name), f"{where}{name}"
        if reason := value_fault(value, annotation, (forms or {}).get(name, "")):
            yield f"{key} = {text_of_value(value)}: {reason}"
        else:
            yield from _nested_problems(value, key, forms)
    for key, reason in data.faults() if hasattr(data, "faults") else ():
        path: tuple[str | int, ...] = (key,) if isinstance(key, str) else key
        value = reduce(_step_down, path, data)
        shown = value is not None and not isinstance(value, tuple | Mapping) and not is_dataclass(value)
        yield f"{where}{_path_text(path)}{f' = {text_of_value(value)}' if shown else ''}: {reason}"


def argument_problems(function: Callable[..., object], given: Mapping[str, Any]) -> Iterator[str]:
    """Yield each argument whose value is not what the signature of a function declares, with what to give.

    Parameters
    ----------
    function : whose arguments are annotated with the marks of a declaration
    given : values of its arguments, by their names
    """
    annotations = get_type_hints(function, include_extras=True)
    for name, value in given.items():
        if reason := value_fault(value, annotations[name]):
            yield f"{name} = {text_of_value(value)}: {reason}"


def value_fault(value: Any, annotation: Any, form: str = "") -> str:
    """Return what is wrong with a value by its annotation, and what to give; empty if nothing is.

    Parameters
    ----------
    value : as it was given
    annotation : its type, with the marks of a declaration
    form : the words for a value of another form; "" for those of its type
    """
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        marks = [mark for mark in inner[1:] if isinstance(mark, Mark)]
        form = next((each for mark in marks if (each := mark.remedy(value))), form)
        own = () if value is None else (mark.fault(value) for mark in marks)
        return value_fault(value, inner[0], form) or next(filter(None, own), "")
    if origin in (Union, UnionType):
        kinds = [each for each in inner if each is not NoneType]
        if value is None and len(kinds) < len(inner):
            return ""
        fitting = [each for each in kinds if _fits(value, each)]
        if len(kinds) > 1 and not fitting:
            return form or f"not {_kind_text(annotation)}; give one of them"
        words = form or ("" if len(kinds) == 1 else f"not {_kind_text(annotation)}; give one of them")
        return value_fault(value, fitting[0] if fitting else kinds[0], words)
    if origin is tuple and isinstance(value, tuple):
        if inner[-1] is not Ellipsis and len(value) != len(inner):
            return form or _other_kind(annotation)
        entries = inner[:1] * len(value) if inner[-1] is Ellipsis else inner
        return next(filter(None, (value_fault(*each, form) for each in zip(value, entries, strict=True))), "")
    if origin is Literal:
        return "" if _fits(value, annotation) and value in inner else form or f"not allowed; write {one_of(inner)}"
    return "" if _fits(value, annotation) else form or _other_kind(annotation)


def text_of_value(value: Any) -> str:
    """Write a value of Python on one line, shortened if it is long."""
    return f"{value:g}" if is_number(value) else repr(value)[:LONGEST]


def _step_down(value: Any, step: str | int) -> Any:
    """Return what stands one step below; hinges are a list, and named."""
    if isinstance(value, Mapping):
        return value[step]
    if isinstance(value, tuple):
        return value["ABCD".index(step) if isinstance(step, str) else step]
    return getattr(value, str(step))


def _path_text(path: tuple[str | int, ...]) -> str:
    return "".join(f"[{step + 1}]" if isinstance(step, int) else f".{step}" for step in path).lstrip(".")


def _nested_problems(value: Any, key: str, forms: Mapping[str, str] | None) -> Iterator[str]:
    """Look into what a field holds: other data, and rows of them."""
    if is_dataclass(value) and not isinstance(value, type):
        yield from declared_problems(value, f"{key}.", forms=forms)
    elif isinstance(value, tuple):
        for number, each in enumerate(value, start=1):
            yield from _nested_problems(each, f"{key}[{number}]", forms)
    elif isinstance(value, Mapping):
        for name, each in value.items():
            yield from _nested_problems(each, f"{key}.{name}", forms)


def _fits(value: Any, kind: Any) -> bool:
    """Tell whether a value is of a kind; which texts are known is left to the checks of values."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return _fits(value, inner[0])
    if origin in (Union, UnionType):
        return any(_fits(value, each) for each in inner)
    if origin is Literal:
        return any(type(value) is int if isinstance(each, int) else isinstance(value, type(each)) for each in inner)
    if origin is tuple:
        return isinstance(value, tuple) and _row_fits(value, inner)
    if origin is not None:
        return isinstance(value, origin) and all(
            _fits(name, inner[0]) and _fits(each, inner[1]) for name, each in value.items()
        )
    if kind in (float, int):
        return is_number(value) and (kind is float or isinstance(value, Integral))
    return kind is Any or isinstance(value, (bool, np.bool_) if kind is bool else kind)


def _row_fits(values: tuple[Any, ...], kinds: tuple[Any, ...]) -> bool:
    if kinds[-1] is Ellipsis:
        return all(_fits(each, kinds[0]) for each in values)
    return len(values) == len(kinds) and all(map(_fits, values, kinds))


def _other_kind(kind: Any) -> str:
    """Say that a value is of another kind, and what to give."""
    inner = get_args(kind)
    if get_origin(kind) is tuple and inner[-1] is Ellipsis:
        return f"not a list; give one, each {_kind_text(inner[0])}"
    return f"not {_kind_text(kind)}; {KINDS.get(kind, ('', 'give one'))[1]}"


def _kind_text(kind: Any) -> str:
    """Say what a kind of value is, without the None that leaves it out."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return _kind_text(inner[0])
    if origin in (Union, UnionType):
        return " or ".join(dict.fromkeys(_kind_text(each) for each in inner if each is not NoneType))
    if origin is Literal:
        return one_of(inner)
    if origin is tuple and inner[-1] is Ellipsis:
        return f"a list, each {_kind_text(inner[0])}"
    if origin is tuple:
        return f"({', '.join(_kind_text(each).removeprefix('a ') for each in inner)})"
    if origin is not None:
        return f"a table of names, each {_kind_text(inner[1])}"
    name: str = kind.__name__
    return KINDS[kind][0] if kind in KINDS else f"{'an' if name[0] in 'AEIOU' else 'a'} {name}"
