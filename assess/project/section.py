"""What the tables of a project file are made of: the class they share, and how they follow from what is declared.

The class is frozen, strict about its keys, and clear about a wrong or absent one. What a key is annotated with by
`assess.declaration` becomes the pydantic type that reads it, and a class of plain data becomes a table.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, asdict, fields, is_dataclass
from functools import cache, partial, reduce
from inspect import get_annotations
from operator import or_
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, TypeVar, Union, cast, get_args, get_origin

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    StrictBool,
    StrictStr,
    Tag,
    ValidationInfo,
    create_model,
    model_validator,
)
from pydantic.fields import FieldInfo
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from assess.declaration import (
    ITS_KIND,
    Annotation,
    Evidence,
    FileDefault,
    Mark,
    Name,
    NotAKey,
    Number,
    annotations_of,
    descriptions,
    marks_of,
    meanings_of,
    one_of,
    unknown_key,
)
from assess.project.key_errors import error_at, errors_at
from assess.project.reading import READ_BY, checks_of, type_read_by
from assess.project.values import WrittenQuantity
from assess.results.run import Distribution

D = TypeVar("D")
JUDGED = "tables whose keys have been judged"
"""The key of a validation's context with the identities of tables whose unknown and missing keys are known."""


class ProjectSection(BaseModel):
    """One table of the project file, its keys annotated as in a declaration (`assess.declaration`).

    `other_keys` are keys of another form of the same table, each with what is wrong about it here; `evidence` says who
    vouches for those of its keys that are not marked themselves.
    """

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        defer_build=True,
        model_title_generator=lambda table: table.__name__.removesuffix("Section"),
    )
    other_keys: ClassVar[Mapping[str, str]] = {}
    evidence: ClassVar[Evidence | None] = None

    def __init_subclass__(cls, **more: Any) -> None:
        """Read what the keys are annotated with as a project file writes it, before pydantic does."""
        super().__init_subclass__(**more)
        found = get_annotations(cls, eval_str=True)
        cls.__annotations__ = {key: _file_type(annotation) for key, annotation in found.items()}

    @classmethod
    @cache
    def table_keys(cls) -> Mapping[str, FieldInfo]:
        """Return the keys as the file writes them; `from` is the alias of a field, as Python reserves the word."""
        return {field.alias or name: field for name, field in cls.model_fields.items()}

    @classmethod
    @cache
    def names_and_keys(cls) -> tuple[tuple[str, str], ...]:
        """Return the name of each field with its key as the file writes it."""
        return tuple(zip(cls.model_fields, cls.table_keys(), strict=True))

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
        if key in cls.other_keys:
            return cls.other_keys[key]
        return unknown_key(key, cls.table_keys())

    @property
    def plain(self) -> Any:
        """The data that the table stands for: itself, where it is made of no class."""
        return self

    def entries(self) -> dict[str, Any]:
        """Return every key of the table with its value, defaults included."""
        return {key: getattr(self, name) for name, key in self.names_and_keys()}

    def has_key(self, key: str) -> bool:
        """Return whether the user wrote `key`, so that its default is not used."""
        return key in self.model_fields_set


def field_marks(field: FieldInfo) -> Iterator[Any]:
    """Yield what a key is annotated with, at whatever depth of its type."""
    for mark in (*field.metadata, *marks_of(field.annotation)):
        yield from field_marks(mark) if isinstance(mark, FieldInfo) else (mark,)


class OrValue:
    """The mark of a key at which one value may stand in place of its table.

    annotation : of that value; forms : its JSON Schemas
    """

    def __init__(self, annotation: Annotation, *forms: JsonSchemaValue) -> None:
        self.field, self.forms = FieldInfo.from_annotated_attribute(_file_type(annotation), None), forms

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        table = handler(schema)
        return {"anyOf": [*table.get("anyOf", [table]), *self.forms]}


EVIDENCE = "x-evidence"
"""The keyword of the schema that says who vouches for a key, and which way it helps a wall."""


def _file_type(annotation: Any) -> Any:
    """Return how a project file reads what is annotated: each mark of a declaration as pydantic knows it.

    Truth values are true or false and nothing like them. Marks around what may be absent bear on what is there.
    """
    origin, parts = get_origin(annotation), get_args(annotation)
    if annotation is bool:
        return StrictBool
    if origin is Annotated:
        return _marked_type(annotation.__origin__, annotation.__metadata__)
    if origin is Literal and all(isinstance(each, int) for each in parts):
        return Annotated[annotation, BeforeValidator(partial(_whole_number_of, parts))]
    if is_dataclass(annotation):
        return table_of(cast(Any, annotation))
    if origin not in (Union, UnionType, tuple, dict, Mapping):
        return annotation
    read = tuple(map(_file_type, parts))
    if origin in (Union, UnionType):
        changed = any(one is not other for one, other in zip(read, parts, strict=True))
        return _either(read) if changed else annotation
    return (dict if origin is Mapping else origin).__class_getitem__(read)


def _whole_number_of(choices: tuple[int, ...], value: Any) -> Any:
    """Return a value that is one of several whole numbers, and not only equal to it as 1.0 or true."""
    if type(value) is not int or value not in choices:
        raise ValueError(f"not allowed; write {one_of(choices)}")
    return value


def _marked_type(value: Annotation, marks: tuple[Any, ...]) -> Annotation:
    if NoneType in get_args(value) and all(isinstance(each, Mark) for each in marks):
        there = reduce(or_, (each for each in get_args(value) if each is not NoneType))
        found = _file_type(Annotated[there, *marks])
        return found if any(isinstance(each, FileDefault) for each in marks) else found | None
    read_by = next((each for each in marks if isinstance(each, READ_BY)), None)
    found = _file_type(value) if read_by is None else type_read_by(read_by, value)
    checks = [check for each in marks if each is not read_by for check in checks_of(each, value)]
    return Annotated[found, *checks] if checks else found


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


class DeclaredSection(ProjectSection):
    """A table with the keys of a class, and its `kind` where that has one."""

    declares: ClassVar[type[Any]]
    file_keys: ClassVar[type[ProjectSection] | None] = None

    if TYPE_CHECKING:

        def __getattr__(self, key: str) -> Any: ...

    @classmethod
    def own_meanings(cls) -> dict[str, str]:
        """Return the sentences of the class that the table is made of, and of the keys beside it."""
        declared: type[Any] | None = vars(cls).get("declares")
        if declared is None:
            return descriptions(cls)
        more = cls.file_keys.meanings() if cls.file_keys else {}
        return {"kind": f'"{getattr(declared, "kind", "")}"', **meanings_of(declared), **more}

    @property
    def plain(self) -> Any:
        """The data that the table stands for, with the keys that were given."""
        declared: type = self.declares
        given = annotations_of(declared).keys() & self.model_fields_set
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


def fill(kind: type[D], section: ProjectSection, **given: Any) -> D:
    """Return plain data of a kind with the values that a table has under the same names, and those given beside."""
    own = {field.name for field in fields(kind)} - set(given)  # type: ignore[arg-type]
    return kind(**{name: getattr(section, name) for name in own if hasattr(section, name)}, **given)


@cache
def table_of(
    declared: Any, base: type[DeclaredSection] = DeclaredSection, file_keys: type[ProjectSection] | None = None
) -> type[DeclaredSection]:
    """Return the table of a project file with the keys of a frozen class, by what they declare.

    base : what else the table can do; file_keys : the keys that only a file has, and `first`, those
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
    for name, given in file_keys.model_fields.items() if file_keys else ():
        evidence = [each for each in marks_of(annotations_of(declared).get(name)) if isinstance(each, Evidence)]
        reads: Any = given.annotation
        keys[name] = (Annotated[reads, *evidence] if evidence else reads, given)
    keys = {key: keys[key] for key in (*getattr(file_keys, "first", ()), *keys)}
    name = f"{declared.__name__.removesuffix('Options')}Section"
    table = create_model(name, __base__=base, __doc__=declared.__doc__, __module__=__name__, **keys)
    table.declares, table.file_keys = declared, file_keys
    table.other_keys = getattr(declared, "other_keys", {})
    return table


def default_table(declared: Any, *, alias: str | None = None) -> Any:
    """Return the default of a key whose table is made of a class: a table in which nothing is given."""
    return Field(default_factory=table_of(declared), alias=alias)


SCATTER = Evidence("measured", "none", "nothing", judged="the verdict takes the mean; the scatter stands beside it")
MEAN = Evidence("defines", "either", "as at its key", judged="it is the value of its key")


class UncertainNumber(ProjectSection):
    """A number that is not well known; without [analysis.uncertainty] its mean is used."""

    evidence = SCATTER

    mean: Annotated[WrittenQuantity, MEAN]
    """its mean, written as at any key, like "0.60 m\""""
    cov: Annotated[float, Number("ratio", above=0, below=1)] | None = None
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
