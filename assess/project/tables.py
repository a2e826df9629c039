"""Tables of a project file made of the classes of plain data that they stand for."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import MISSING, fields, is_dataclass
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, get_args, get_origin

from pydantic import Discriminator, Tag, create_model, model_validator

from assess.declaration import FileDefault, NotAKey, annotations_of, marks_of, meanings_of
from assess.project.section import ProjectSection, error_at, quote_names


class DeclaredSection(ProjectSection):
    """A table with the keys of a class, and its `kind` where that has one."""

    declares: ClassVar[type[Any]]
    if TYPE_CHECKING:

        def __getattr__(self, key: str) -> Any: ...

    @classmethod
    def own_meanings(cls) -> dict[str, str]:
        """Return the sentences of the class that the table is made of."""
        kind = vars(cls).get("declares")
        return {} if kind is None else {"kind": f'"{getattr(kind, "kind", "")}"', **meanings_of(kind)}

    @property
    def plain(self) -> Any:
        """The data that the table stands for, with the keys that were given."""
        return self.declares(**{key: _plain(getattr(self, key)) for key in self.model_fields_set - {"kind"}})

    @model_validator(mode="after")
    def _keys_go_together(self) -> DeclaredSection:
        for key, reason in self.plain.faults() if hasattr(self.declares, "faults") else ():
            raise error_at(key, reason)
        return self


def table_of(declared: type[Any]) -> type[DeclaredSection]:
    """Return the table of a project file with the keys of a frozen class, by what they declare."""
    kind: type = declared
    keys: dict[str, Any] = {"kind": (Literal[declared.kind], ...)} if hasattr(declared, "kind") else {}
    for field, annotation in zip(fields(declared), annotations_of(kind).values(), strict=True):
        marks = {type(mark): mark for mark in marks_of(annotation)}
        if NotAKey not in marks:
            default = ... if field.default is MISSING else field.default
            keys[field.name] = (_with_tables(annotation), marks[FileDefault].value if FileDefault in marks else default)
    name = f"{declared.__name__}Section"
    table = create_model(name, __base__=DeclaredSection, __doc__=declared.__doc__, __module__=__name__, **keys)
    table.declares, table.elsewhere = declared, getattr(declared, "elsewhere", {})
    return table


def table_by_kind(kinds: Mapping[str, type[Any]], *, what: str) -> Any:
    """Return what reads one of several tables, told apart by their key `kind`; what : they are, for an error."""
    tables = [Annotated[table_of(kind), Tag(f"<{name}>")] for name, kind in kinds.items()]

    def tag(values: Any) -> str | None:
        kind = values.get("kind") if isinstance(values, dict) else None
        return f"<{kind}>" if isinstance(kind, str) and kind in kinds else None

    reason = f"not a supported {what}; write one of {quote_names(tuple(kinds))}"
    context: dict[str, Any] = {"key": ("kind",), "reason": reason}
    discriminator = Discriminator(
        tag, custom_error_type="project", custom_error_message="{reason}", custom_error_context=context
    )
    return Annotated[reduce(or_, tables), discriminator]


def table_by_code(
    codes: Mapping[str, Sequence[type[Any]]], class_of: Callable[[str, Collection[str]], type[Any]]
) -> Any:
    """Return what reads one of several tables, told apart by their key `code` and by keys that only one has.

    Parameters
    ----------
    codes : the classes of the tables of each code, each with its short name `form`
    class_of : that of a code among them, by the keys that are given
    """
    kinds = dict.fromkeys(kind for of_code in codes.values() for kind in of_code)
    tables = [Annotated[table_of(kind), Tag(f"<{kind.form}>")] for kind in kinds]

    def tag(values: Any) -> str | None:
        code = values.get("code") if isinstance(values, dict) else None
        return f"<{class_of(code, values).form}>" if isinstance(code, str) and code in codes else None

    context: dict[str, Any] = {"key": ("code",), "names": quote_names(tuple(codes))}
    discriminator = Discriminator(
        tag, custom_error_type="choice", custom_error_message="write one of {names}", custom_error_context=context
    )
    return Annotated[reduce(or_, tables), discriminator]


def _plain(value: Any) -> Any:
    """Return what a value of a table stands for, if that is a table or rows of them."""
    if isinstance(value, tuple):
        return tuple(map(_plain, value))
    return value.plain if isinstance(value, DeclaredSection) else value


def _with_tables(annotation: Any) -> Any:
    """Return an annotation with the table of each class of data in rows."""
    if get_origin(annotation) is Annotated:
        return Annotated[_with_tables(annotation.__origin__), *annotation.__metadata__]
    if get_origin(annotation) is tuple:
        return tuple.__class_getitem__(tuple(map(_with_tables, get_args(annotation))))
    return table_of(annotation) if isinstance(annotation, type) and is_dataclass(annotation) else annotation
