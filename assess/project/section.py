"""What the tables of a project file are made of: the class they share, and how they follow from what is declared.

The class is frozen, strict about its keys, and clear about a wrong or absent one. What a key is annotated with by
`assess.declaration` becomes the pydantic type that reads it, and a class of plain data becomes a table.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import MISSING, asdict, fields, is_dataclass
from functools import cache, partial, reduce
from inspect import get_annotations
from operator import or_
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, TypeVar, Union, cast, get_args, get_origin

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    Strict,
    StrictBool,
    StrictStr,
    Tag,
    ValidationInfo,
    WithJsonSchema,
    create_model,
    model_validator,
)
from pydantic.fields import FieldInfo
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticCustomError

from assess.declaration import (
    ITS_KIND,
    Coordinate,
    Evidence,
    FileDefault,
    Forms,
    IsDirection,
    IsHorizontal,
    IsInputFile,
    IsName,
    IsPlace,
    Mark,
    Name,
    NotAKey,
    Number,
    Ratio,
    Scatters,
    Several,
    annotations_of,
    descriptions,
    marks_of,
    meanings_of,
    unknown_key,
)
from assess.messages.message import escape_text
from assess.project.units import INFINITE, KINDS, QuantityForm, key_value
from assess.project.values import PATTERN_MARK, InputFile, WrittenQuantity
from assess.results.run import Distribution

KeyPath = tuple[str | int, ...]
"""A key by its steps from the top of the file; items of lists are counted from 0."""
_LONGEST = 60  # characters of a value in an error
JUDGED = "tables whose keys have been judged"
"""The key of a validation's context with the identities of tables whose unknown and missing keys are known."""


class ProjectSection(BaseModel):
    """One table of the project file, its keys annotated as in a declaration (`assess.declaration`).

    `elsewhere` are keys of another form of the same table, each with what is wrong about it here; `evidence` says who
    vouches for those of its keys that are not marked themselves.
    """

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        defer_build=True,
        model_title_generator=lambda table: table.__name__.removesuffix("Section"),
    )
    elsewhere: ClassVar[Mapping[str, str]] = {}
    evidence: ClassVar[Evidence | None] = None

    def __init_subclass__(cls, **more: Any) -> None:
        """Read what the keys are annotated with as a project file writes it, before pydantic does."""
        super().__init_subclass__(**more)
        found = get_annotations(cls, eval_str=True)
        cls.__annotations__ = {key: _file_type(annotation) for key, annotation in found.items()}

    @classmethod
    def table_keys(cls) -> dict[str, FieldInfo]:
        """Return the keys as the file writes them; `from` is the alias of a field, as Python reserves the word."""
        return {field.alias or name: field for name, field in cls.model_fields.items()}

    @classmethod
    def meanings(cls) -> dict[str, str]:
        """Return what each key means: the field's description, or the sentence below it."""
        below: dict[str, str] = {}
        for table in reversed(cls.__mro__):
            below |= table.own_meanings() if issubclass(table, ProjectSection) else {}
        meanings = {name: field.description or below.get(name) for name, field in cls.model_fields.items()}
        return {cls.model_fields[name].alias or name: text for name, text in meanings.items() if text}

    @classmethod
    def own_meanings(cls) -> dict[str, str]:
        """Return the sentences below the keys that the class itself declares."""
        return descriptions(cls)

    @classmethod
    def evidence_of_keys(cls) -> dict[str, Evidence]:
        """Return who vouches for each key, as it is marked or else as its table says."""
        found: dict[str, Evidence] = {}
        for key, field in cls.table_keys().items():
            said = (mark for mark in (*field_marks(field), cls.evidence) if isinstance(mark, Evidence))
            if evidence := next(said, None):
                found[key] = evidence
        return found

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        found = handler(schema)
        properties = handler.resolve_ref_schema(found)["properties"]
        for key, text in cls.meanings().items():
            properties[key]["description"] = text
        for key, evidence in cls.evidence_of_keys().items():
            properties[key][EVIDENCE] = {
                name: text for name, text in asdict(evidence).items() if text and name != "safe"
            }
        return found

    @model_validator(mode="before")
    @classmethod
    def _keys_are_known(cls, values: Any, info: ValidationInfo) -> Any:
        if isinstance(values, dict) and id(values) not in (info.context or {}).get(JUDGED, ()):
            known = cls.table_keys()
            unknown = [(key, cls._unknown(key)) for key in values if key not in known]
            missing = [
                (key, f"missing; {cls.meanings()[key]}")
                for key, field in known.items()
                if field.is_required() and key not in values and not any(f'"{key}"' in reason for _, reason in unknown)
            ]
            if unknown or missing:
                raise errors_at((*unknown, *missing), unknown=tuple(key for key, _ in unknown))
        return values

    @classmethod
    def _unknown(cls, key: str) -> str:
        if key in cls.elsewhere:
            return cls.elsewhere[key]
        return unknown_key(key, cls.table_keys())

    @property
    def plain(self) -> Any:
        """The data that the table stands for: itself, where it is made of no class."""
        return self

    def entries(self) -> dict[str, Any]:
        """Return every key of the table with its value, defaults included."""
        return {field.alias or name: getattr(self, name) for name, field in type(self).model_fields.items()}

    def has_key(self, key: str) -> bool:
        """Return whether the user wrote `key`, so that its default is not used."""
        return key in self.model_fields_set


def field_marks(field: FieldInfo) -> Iterator[Any]:
    """Yield what a key is annotated with, at whatever depth of its type."""
    for mark in (*field.metadata, *marks_of(field.annotation)):
        yield from field_marks(mark) if isinstance(mark, FieldInfo) else (mark,)


def error_at(key: str | tuple[str | int, ...], reason: str) -> PydanticCustomError:
    """Return an error at `key`, one or more steps below the table that is being read."""
    return PydanticCustomError(
        "project", "{reason}", {"key": (key,) if isinstance(key, str) else key, "reason": reason}
    )


def errors_at(
    faults: Sequence[tuple[str | tuple[str | int, ...], str]], *, unknown: tuple[str, ...] = ()
) -> PydanticCustomError:
    """Return one error for several keys of the table that is being read, each with its reason.

    unknown : those of the keys that no table of the kind has
    """
    (key, reason), *others = faults
    more = [((each,) if isinstance(each, str) else each, text) for each, text in others]
    context = {"key": (key,) if isinstance(key, str) else key, "reason": reason, "more": more, "unknown": unknown}
    return PydanticCustomError("project", "{reason}", context)


def quote_names(names: Mapping[str, Any] | tuple[str, ...]) -> str:
    """Write names in quotes, for a sentence."""
    return ", ".join(f'"{name}"' for name in names)


def key_text(key: KeyPath) -> str:
    """Write a key as users do: `mechanisms.W1.hinges.A[2]`."""
    text = "".join(f"[{step + 1}]" if isinstance(step, int) else f".{escape_text(step)}" for step in key)
    return text.lstrip(".")


def value_text(value: Any) -> str:
    """Write a value on one line, shortened if it is long."""
    text = escape_text(json.dumps(value, ensure_ascii=False, default=str))
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def look_up(raw: Mapping[str, Any], key: KeyPath) -> tuple[bool, Any]:
    """Whether the file holds `key`, and its value."""
    value: Any = raw
    for step in key:
        try:
            value = value[step]
        except (KeyError, IndexError, TypeError):
            return False, None
    return True, value


T = TypeVar("T")
EVIDENCE = "x-evidence"
"""The keyword of the schema that says who vouches for a key, and which way it helps a wall."""
UNCERTAIN_MARK = "or { mean, cov }"
"""Stands in the schema of a marked key until `with_uncertain_numbers` has replaced it."""


def quantity_schema(kind: str) -> dict[str, Any]:
    """Return the schema of a key that holds a quantity of a kind in KINDS."""
    return {"type": ["number", "string"], PATTERN_MARK: [kind, "quantity"]}


def _described(kind: str, form: QuantityForm = "quantity") -> WithJsonSchema:
    k = KINDS[kind]
    words = f'{k.name}: a number in {k.symbol}, or a string with its unit like "{k.example}"'
    words += f', or the weight of it like "{k.weighing}", by standard gravity' if k.weight else ""
    return WithJsonSchema({**quantity_schema(kind), "description": words, PATTERN_MARK: [kind, form]})


READ_BY = (Number, IsPlace, IsDirection, IsInputFile, IsName)
"""The marks that say how a value is read."""


def _file_type(annotation: Any) -> Any:
    """Return how a project file reads what is annotated: each mark of a declaration as pydantic knows it.

    Truth values are true or false and nothing like them. Marks around what may be absent bear on what is there.
    """
    origin, parts = get_origin(annotation), get_args(annotation)
    if annotation is bool:
        return StrictBool
    if origin is Annotated:
        value, marks = annotation.__origin__, annotation.__metadata__
        if NoneType in get_args(value) and all(isinstance(each, Mark) for each in marks):
            there = reduce(or_, (each for each in get_args(value) if each is not NoneType))
            found = _file_type(Annotated[there, *marks])
            return found if any(isinstance(each, FileDefault) for each in marks) else found | None
        read_by = next((each for each in marks if isinstance(each, READ_BY)), None)
        beside = [each for each in marks if each is not read_by]
        beside += [_SCATTERS] * any(isinstance(each, Scatters) for each in marks)
        beside += [BeforeValidator(partial(_one_form, each, value)) for each in marks if isinstance(each, Forms)]
        beside += [_several(each) for each in marks if isinstance(each, Several)]
        beside += [
            AfterValidator(partial(_faultless, each))
            for each in marks
            if each is not read_by and isinstance(each, Mark) and type(each).fault is not Mark.fault
        ]
        found = _file_type(value) if read_by is None else _read_by(read_by, value)
        return Annotated[found, *beside] if beside else found
    if is_dataclass(annotation):
        return table_of(cast(Any, annotation))
    if origin not in (Union, UnionType, tuple, dict, Mapping):
        return annotation
    read = tuple(map(_file_type, parts))
    if origin in (Union, UnionType):
        changed = any(one is not other for one, other in zip(read, parts, strict=True))
        return _either(read) if changed else annotation
    return (dict if origin is Mapping else origin).__class_getitem__(read)


def _either(forms: tuple[Any, ...]) -> Any:
    """Return what reads one of several forms; tables are told apart from other values, and from one another by keys."""
    tables = [each for each in forms if isinstance(each, type) and issubclass(each, DeclaredSection)]
    others = [each for each in forms if each not in tables and each is not NoneType]
    if not tables or (len(tables) == 1 and not others):
        return reduce(or_, forms)

    def tag(value: Any) -> str:
        if not isinstance(value, dict | DeclaredSection):
            return "<value>"
        keys = set(value) if isinstance(value, dict) else set(type(value).model_fields)
        return _tag(max(tables, key=lambda table: len(keys & set(table.model_fields))))

    tagged: list[Any] = [Annotated[each, Tag(_tag(each))] for each in tables]
    if others:
        tagged.insert(forms.index(others[0]), Annotated[reduce(or_, others), Tag("<value>")])
    found: Any = Annotated[reduce(or_, tagged), Discriminator(tag)]
    return found | None if NoneType in forms else found


def _tag(table: type[DeclaredSection]) -> str:
    """Name a table among several forms by the words of its class, such as <cut angle>."""
    return f"<{' '.join(re.findall('[A-Z][a-z]+', table.declares.__name__)).lower()}>"


@cache
def _read_by(mark: Mark, value: Any) -> Any:
    """Return how a file reads a value of a type by a mark that says what it is."""
    match mark:
        case Number(dimension=""):
            return Annotated[value, Strict(), _bounds(mark)]
        case Number():
            return _number_type(value, mark)
        case IsPlace():
            return _file_type(Annotated[tuple[Coordinate, ...], _row_of(mark), Field(min_length=2, max_length=3)])
        case IsDirection():
            return _file_type(Annotated[tuple[Ratio, ...], _row_of(mark), Field(min_length=2, max_length=3)])
        case IsInputFile():
            return InputFile
    return Annotated[StrictStr, AfterValidator(lambda text: _faultless(mark, text))]


def _number_type(value: Any, number: Number) -> Any:
    """Return how a file reads a quantity; its kind stands beside, so that the type of a key tells its unit."""
    kind = KINDS[number.dimension]
    if value is float and not number.beyond:
        form: QuantityForm = "quantity or infinite" if number.infinite else "quantity"
        read = BeforeValidator(lambda given: _quantity(given, number))
        bounds = _bounds(number)
        found = Annotated[float, read, _described(number.dimension, form), kind]
        return found if bounds is None else Annotated[found, bounds]
    words = _words_of(value)
    count = next((len(get_args(part)) for part in get_args(value) if get_origin(part) is tuple), 0)

    def read_any(given: Any) -> Any:
        if isinstance(given, str) and words and not any(each.isdigit() for each in given):
            if given in words:
                return given
            raise ValueError(number.form)
        if isinstance(given, list | tuple) and count:
            if len(given) != count:
                raise ValueError(number.form)
            return tuple(_quantity(each, number) for each in given)
        return _faultless(number, _quantity(given, number))

    quantity = quantity_schema(number.dimension)
    forms: list[dict[str, Any]] = [quantity]
    if count:
        forms.append({"type": "array", "items": quantity, "minItems": count, "maxItems": count})
    forms += [{"enum": list(words)}] * bool(words)
    form = "quantity or infinite" if number.infinite else "quantity"
    schema = WithJsonSchema({"anyOf": forms}) if len(forms) > 1 else _described(number.dimension, form)
    return Annotated[value, BeforeValidator(read_any), schema, kind, number]


def _quantity(value: Any, number: Number) -> float:
    if number.infinite and (value == math.inf or (isinstance(value, str) and value.strip().lower() in INFINITE)):
        return math.inf
    kind = KINDS[number.dimension]
    return 0.0 if number.rounded and isinstance(value, float) and abs(value) < kind.range[0] else key_value(value, kind)


def _bounds(number: Number) -> Any:
    """Return the bounds of a number for pydantic; None if it has none."""
    bounds = {"gt": number.above, "ge": number.least, "lt": number.below, "le": number.most}
    given: dict[str, Any] = {word: bound for word, bound in bounds.items() if bound is not None}
    return Field(**given) if given else None


def _faultless(mark: Mark, value: T) -> T:
    """Return a value in which a mark finds no fault; raise ValueError with the fault else."""
    if fault := mark.fault(value):
        raise ValueError(fault)
    return value


def _several(mark: Several) -> Any:
    return Field(min_length=mark.least or None, max_length=mark.most)


def _one_form(forms: Forms, kind: Any, value: Any) -> Any:
    """Return a table, or one of the words that stand in its place."""
    if isinstance(value, dict | ProjectSection) or value in _words_of(kind):
        return value
    raise error_at((), forms.remedy(value))


def _words_of(kind: Any) -> tuple[str, ...]:
    return tuple(each for part in get_args(kind) if get_origin(part) is Literal for each in get_args(part))


def _row_of(mark: Mark) -> BeforeValidator:
    """Return a check that a value is a list, of the form that a mark asks for."""

    def check(value: Any) -> Any:
        if not isinstance(value, list | tuple):
            raise ValueError(mark.form)
        return _faultless(mark, value)

    return BeforeValidator(check)


class _ScatterSchema:
    """Stands behind the mark of a key whose number may be `{ mean, cov }`, for the schema."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        return {**handler(schema), UNCERTAIN_MARK: True}


_SCATTERS = _ScatterSchema()


class DeclaredSection(ProjectSection):
    """A table with the keys of a class, and its `kind` where that has one."""

    declares: ClassVar[type[Any]]
    beside: ClassVar[type[ProjectSection] | None] = None

    if TYPE_CHECKING:

        def __getattr__(self, key: str) -> Any: ...

    @classmethod
    def own_meanings(cls) -> dict[str, str]:
        """Return the sentences of the class that the table is made of, and of the keys beside it."""
        declared: type[Any] | None = vars(cls).get("declares")
        if declared is None:
            return descriptions(cls)
        beside = cls.beside.meanings() if cls.beside else {}
        return {"kind": f'"{getattr(declared, "kind", "")}"', **meanings_of(declared), **beside}

    @property
    def plain(self) -> Any:
        """The data that the table stands for, with the keys that were given."""
        given = {field.name for field in fields(self.declares)} & self.model_fields_set
        return self.declares(**{key: plain_data(getattr(self, key)) for key in given})

    @model_validator(mode="after")
    def _keys_go_together(self) -> DeclaredSection:
        if faults := tuple(self.plain.faults()) if hasattr(self.declares, "faults") else ():
            raise errors_at(faults)
        return self


def plain_data(value: Any) -> Any:
    """Return what a value of a project file stands for, each table in it as the data that it is made of."""
    if isinstance(value, ProjectSection):
        return value.plain
    if isinstance(value, tuple):
        return tuple(map(plain_data, value))
    return {key: plain_data(each) for key, each in value.items()} if isinstance(value, dict) else value


@cache
def table_of(
    declared: Any, base: type[DeclaredSection] = DeclaredSection, beside: type[ProjectSection] | None = None
) -> type[DeclaredSection]:
    """Return the table of a project file with the keys of a frozen class, by what they declare.

    base : what else the table can do; beside : the keys that only a file has, and `first`, those
        that its results list before all others
    """
    keys: dict[str, Any] = (
        {"kind": (Annotated[Literal[declared.kind], ITS_KIND], ...)} if hasattr(declared, "kind") else {}
    )
    for field in fields(declared):
        annotation = annotations_of(declared)[field.name]
        marks = {type(mark): mark for mark in marks_of(annotation)}
        if NotAKey in marks:
            continue
        if FileDefault in marks:
            default = marks[FileDefault].value
        elif field.default_factory is not MISSING:
            made = field.default_factory
            default = Field(default_factory=table_of(made) if is_dataclass(made) else made)
        else:
            default = ... if field.default is MISSING else field.default
        keys[field.name] = (annotation, default)
    for name, given in beside.model_fields.items() if beside else ():
        evidence = [each for each in marks_of(annotations_of(declared).get(name)) if isinstance(each, Evidence)]
        reads: Any = given.annotation
        keys[name] = (Annotated[reads, *evidence] if evidence else reads, given)
    keys = {key: keys[key] for key in (*getattr(beside, "first", ()), *keys)}
    name = f"{declared.__name__.removesuffix('Options')}Section"
    table = create_model(name, __base__=base, __doc__=declared.__doc__, __module__=__name__, **keys)
    table.declares, table.beside = declared, beside
    table.elsewhere = getattr(declared, "elsewhere", {})
    return table


def default_table(declared: Any, *, alias: str | None = None) -> Any:
    """Return the default of a key whose table is made of a class: a table in which nothing is given."""
    return Field(default_factory=table_of(declared), alias=alias)


A_POINT = _row_of(IsPlace())


Direction = Annotated[tuple[Ratio, Ratio, Ratio], AfterValidator(partial(_faultless, IsHorizontal()))]


def _sweep(text: str) -> str:
    if text != "sweep":
        raise ValueError(IsHorizontal.form)
    return text


SoughtDirection = Annotated[
    Annotated[Direction, Tag("<given>")] | Annotated[Literal["sweep"], BeforeValidator(_sweep), Tag("<sought>")],
    Discriminator(lambda value: "<sought>" if isinstance(value, str) else "<given>"),
]


SCATTER = Evidence("measured", "none", "nothing", judged="the verdict takes the mean; the scatter stands beside it")
MEAN = Evidence("defines", "either", "as at its key", judged="it is the value of its key")


class UncertainNumber(ProjectSection):
    """A number that is not well known; without [analysis.uncertainty] its mean is used."""

    evidence = SCATTER

    mean: Annotated[WrittenQuantity, MEAN]
    """its mean, written as at any key, like "0.60 m\""""
    cov: Annotated[Ratio, Field(gt=0, lt=1)] | None = None
    """coefficient of variation, standard deviation over mean, like 0.05; or give sd"""
    sd: WrittenQuantity | None = None
    """standard deviation in the unit of the key, like "2 cm", in place of cov"""
    distribution: Distribution | None = None
    """"lognormal" (if absent; of coordinates "normal"), "normal" or "uniform" over mean (1 ± √3 cov)"""
    group: Annotated[Name, StrictStr] | None = None
    """numbers of one group vary together; each by itself if absent"""

    @model_validator(mode="after")
    def _one_scatter(self) -> UncertainNumber:
        if (self.cov is None) == (self.sd is None):
            raise error_at("cov", "give either cov, a share of the mean like 0.05, or sd, in the unit of the mean")
        return self
