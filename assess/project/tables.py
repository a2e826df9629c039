"""Tables of a project file made of the classes of plain data that they stand for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, fields
from functools import reduce
from operator import or_
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Tag, create_model, model_validator

from assess.declaration import FileDefault, NotAKey, annotations_of, descriptions, marks_of
from assess.project.section import ProjectSection, error_at, quote_names


class DeclaredSection(ProjectSection):
    """A table with the keys of a class, and its `kind` where that has one."""

    declares: ClassVar[type[Any]]

    @classmethod
    def own_meanings(cls) -> dict[str, str]:
        """Return the sentences of the class that the table is made of."""
        kind = vars(cls).get("declares")
        return {} if kind is None else {"kind": f'"{getattr(kind, "kind", "")}"', **descriptions(kind)}

    @property
    def plain(self) -> Any:
        """The data that the table stands for, with the keys that were given."""
        return self.declares(**{key: getattr(self, key) for key in self.model_fields_set - {"kind"}})

    @model_validator(mode="after")
    def _keys_go_together(self) -> DeclaredSection:
        for key, reason in self.plain.faults():
            raise error_at(key, reason)
        return self


def _table_of(declared: type[Any]) -> type[DeclaredSection]:
    """Return the table of a project file with the keys of a frozen class, by what they declare."""
    kind: type = declared
    keys: dict[str, Any] = {"kind": (Literal[declared.kind], ...)} if hasattr(declared, "kind") else {}
    for field, annotation in zip(fields(declared), annotations_of(kind).values(), strict=True):
        marks = {type(mark): mark for mark in marks_of(annotation)}
        if NotAKey not in marks:
            default = ... if field.default is MISSING else field.default
            keys[field.name] = (annotation, marks[FileDefault].value if FileDefault in marks else default)
    name = f"{declared.__name__}Section"
    table = create_model(name, __base__=DeclaredSection, __doc__=declared.__doc__, __module__=__name__, **keys)
    table.declares = declared
    return table


def table_by_kind(kinds: Mapping[str, type[Any]], *, what: str) -> Any:
    """Return what reads one of several tables, told apart by their key `kind`; what : they are, for an error."""
    tables = [Annotated[_table_of(kind), Tag(f"<{name}>")] for name, kind in kinds.items()]

    def tag(values: Any) -> str | None:
        kind = values.get("kind") if isinstance(values, dict) else None
        return f"<{kind}>" if isinstance(kind, str) and kind in kinds else None

    reason = f"not a supported {what}; write one of {quote_names(tuple(kinds))}"
    context: dict[str, Any] = {"key": ("kind",), "reason": reason}
    discriminator = Discriminator(
        tag, custom_error_type="project", custom_error_message="{reason}", custom_error_context=context
    )
    return Annotated[reduce(or_, tables), discriminator]
