"""How a project file reads a value that is no table, by the marks of its declaration: a number, a place, a name.

Each mark of `assess.declaration` becomes what pydantic knows: a type that reads the value, or a check of it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from functools import cache, partial
from typing import Annotated, Any, Literal, TypeVar, get_args, get_origin

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    Strict,
    StrictStr,
    Tag,
    WithJsonSchema,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from assess.declaration import (
    Annotation,
    Forms,
    IsDirection,
    IsHorizontal,
    IsInputFile,
    IsName,
    IsPlace,
    Mark,
    Number,
    Scatters,
    Several,
)
from assess.project.key_errors import error_at
from assess.project.units import INFINITE, KINDS, QuantityForm, key_value
from assess.project.values import PATTERN_MARK, InputFile
from spectra.arrays import is_number

T = TypeVar("T")
READ_BY = (Number, IsPlace, IsDirection, IsHorizontal, IsInputFile, IsName)
"""The marks that say how a value is read."""
UNCERTAIN_MARK = "or { mean, cov }"
"""Stands in the schema of a marked key until `with_uncertain_numbers` has replaced it."""
SCHEMA_BOUNDS = {"above": "exclusiveMinimum", "least": "minimum", "below": "exclusiveMaximum", "most": "maximum"}
"""The bounds of a number by their names in `assess.declaration.BOUNDS` and in a JSON Schema."""


@cache
def type_read_by(mark: Mark, value: Annotation) -> Annotation:
    """Return how a file reads a value of a type by a mark of READ_BY."""
    match mark:
        case Number(dimension=""):
            schema = WithJsonSchema({"type": "integer", **_schema_bounds(mark)})
            return Annotated[value, Strict(), AfterValidator(partial(_require, mark)), schema, mark]
        case Number():
            return _number_or_word(value, mark)
        case IsPlace() | IsDirection():
            return _row_of(get_args(value)[0], mark)
        case IsHorizontal():
            return _vector_or_word(value, mark)
        case IsInputFile():
            return InputFile
    return Annotated[StrictStr, AfterValidator(partial(_require, mark))]


def checks_of(mark: Any, value: Annotation) -> Iterator[Any]:
    """Yield what checks a value of a type by a mark that does not say how it is read, and the mark itself."""
    yield mark
    match mark:
        case Scatters():
            yield _SCATTERS
        case Forms():
            yield BeforeValidator(partial(_one_form, mark, value))
        case Several():
            yield Field(min_length=mark.least or None, max_length=mark.most)
    if isinstance(mark, Mark) and type(mark).fault is not Mark.fault:
        yield AfterValidator(partial(_require, mark))


def quantity_schema(kind: str) -> dict[str, Any]:
    """Return the schema of a key that holds a quantity of a kind in KINDS."""
    return {"type": ["number", "string"], PATTERN_MARK: [kind, "quantity"]}


def _row_of(number: Annotation, mark: Mark) -> Annotation:
    """Return what reads two or three numbers, which must be what a mark says."""
    rows: Annotation = tuple.__class_getitem__((_read_number(number), ...))
    return Annotated[rows, _row(mark), Field(min_length=2, max_length=3), AfterValidator(partial(_require, mark))]


def _read_number(number: Annotation) -> Annotation:
    """Return how a file reads a number that a declaration names, such as Coordinate."""
    mark, *others = number.__metadata__
    found = type_read_by(mark, number.__origin__)
    return Annotated[found, *(check for each in others for check in checks_of(each, found))] if others else found


def _number_or_word(value: Annotation, number: Number) -> Annotation:
    """Return how a file reads a quantity; its kind stands beside, so that the type of a key tells its unit."""
    words = _words_of(value)
    count = next((len(get_args(part)) for part in get_args(value) if get_origin(part) is tuple), 0)

    def read(given: Any) -> Any:
        if isinstance(given, str) and given in words:
            return given
        if isinstance(given, list | tuple) and len(given) == count > 0:
            return tuple(_quantity(each, number) for each in given)
        if number.form and not is_number(given) and not _may_be_number(given):
            raise ValueError(number.form)
        return _require(number, _quantity(given, number))

    return Annotated[
        value, BeforeValidator(read), _schema_of_number(number, words, count), KINDS[number.dimension], number
    ]


def _may_be_number(value: Any) -> bool:
    return isinstance(value, str) and re.search(r"[0-9]|inf", value.lower()) is not None


def _schema_of_number(number: Number, words: tuple[str, ...], count: int) -> WithJsonSchema:
    kind = KINDS[number.dimension]
    quantity = quantity_schema(number.dimension)
    bounded = quantity | _schema_bounds(number)
    if words or count:
        forms: list[dict[str, Any]] = [bounded]
        if count:
            forms.append({"type": "array", "items": quantity, "minItems": count, "maxItems": count})
        return WithJsonSchema({"anyOf": [*forms, *([{"enum": list(words)}] if words else [])]})
    form: QuantityForm = "quantity or infinite" if number.infinite else "quantity"
    said = f'{kind.name}: a number in {kind.symbol}, or a string with its unit like "{kind.example}"'
    said += f', or the weight of it like "{kind.weighing}", by standard gravity' if kind.weight else ""
    return WithJsonSchema({**bounded, "description": said, PATTERN_MARK: [number.dimension, form]})


def _schema_bounds(number: Number) -> dict[str, float]:
    bounds = {word: getattr(number, name) for name, word in SCHEMA_BOUNDS.items()}
    return {word: bound for word, bound in bounds.items() if bound is not None}


def _quantity(value: Any, number: Number) -> float:
    if number.infinite and (value == math.inf or (isinstance(value, str) and value.strip().lower() in INFINITE)):
        return math.inf
    kind = KINDS[number.dimension]
    return 0.0 if number.rounded and isinstance(value, float) and abs(value) < kind.range[0] else key_value(value, kind)


def _vector_or_word(value: Annotation, mark: IsHorizontal) -> Annotation:
    """Return how a file reads a horizontal direction, or a word in its place."""
    vector, word = get_args(value)
    size = len(get_args(vector))

    def is_row(given: Any) -> Any:
        if not isinstance(given, list | tuple) or len(given) != size:
            raise ValueError(mark.form)
        return given

    def is_word(given: Any) -> Any:
        if given not in get_args(word):
            raise ValueError(mark.form)
        return given

    numbers: Annotation = tuple.__class_getitem__(tuple(map(_read_number, get_args(vector))))
    read: Annotation = Annotated[numbers, BeforeValidator(is_row), AfterValidator(partial(_require, mark))]
    return Annotated[
        Annotated[read, Tag("<given>")] | Annotated[word, BeforeValidator(is_word), Tag("<word>")],
        Discriminator(lambda given: "<word>" if isinstance(given, str) else "<given>"),
    ]


def _require(mark: Mark, value: T) -> T:
    """Return a value in which a mark finds no fault; raise ValueError with the fault else."""
    if fault := mark.fault(value):
        raise ValueError(fault)
    return value


def _one_form(forms: Forms, kind: Annotation, value: Any) -> Any:
    """Return a table, or one of the words that stand in its place."""
    if isinstance(value, dict) or value in _words_of(kind):
        return value
    raise error_at((), forms.remedy(value))


def _words_of(kind: Annotation) -> tuple[str, ...]:
    return tuple(each for part in get_args(kind) if get_origin(part) is Literal for each in get_args(part))


def _row(mark: Mark) -> BeforeValidator:
    """Return a check that a value is a list, of the form that a mark asks for."""

    def check(value: Any) -> Any:
        if not isinstance(value, list | tuple):
            raise ValueError(mark.form)
        return _require(mark, value)

    return BeforeValidator(check)


class _ScatterSchema:
    """Stands behind the mark of a key whose number may be `{ mean, cov }`, for the schema."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        return {**handler(schema), UNCERTAIN_MARK: True}


_SCATTERS = _ScatterSchema()
