"""What all tables of a project file share: frozen, strict about their keys, and clear about a wrong or absent one."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any, ClassVar

from pydantic import BaseModel, ConfigDict, GetJsonSchemaHandler, model_validator
from pydantic.fields import FieldInfo
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticCustomError

from assess.project.descriptions import descriptions


def wrong(key: str | tuple[str | int, ...], reason: str) -> PydanticCustomError:
    """Return an error at `key`, one or more steps below the table that is being read."""
    return PydanticCustomError(
        "project", "{reason}", {"key": (key,) if isinstance(key, str) else key, "reason": reason}
    )


def quote_names(names: Mapping[str, Any] | tuple[str, ...]) -> str:
    """Write names in quotes, for a sentence."""
    return ", ".join(f'"{name}"' for name in names)


class Section(BaseModel):
    """One table of the project file.

    `elsewhere` are keys of another form of the same table, each with what is wrong about it here.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")
    elsewhere: ClassVar[Mapping[str, str]] = {}

    @classmethod
    def table_keys(cls) -> dict[str, FieldInfo]:
        """Return the keys as the file writes them; `from` is the alias of a field, as Python reserves the word."""
        return {field.alias or name: field for name, field in cls.model_fields.items()}

    @classmethod
    def meanings(cls) -> dict[str, str]:
        """Return what each key means: the field's description, or the sentence below it."""
        below: dict[str, str] = {}
        for table in reversed(cls.__mro__):
            below |= descriptions(table) if issubclass(table, Section) else {}
        said = {name: field.description or below.get(name) for name, field in cls.model_fields.items()}
        return {cls.model_fields[name].alias or name: text for name, text in said.items() if text}

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        found = handler(schema)
        properties = handler.resolve_ref_schema(found)["properties"]
        for key, text in cls.meanings().items():
            properties[key]["description"] = text
        return found

    @model_validator(mode="before")
    @classmethod
    def _keys_are_known(cls, values: Any) -> Any:
        if isinstance(values, dict):
            for key in values:
                if key not in cls.table_keys():
                    raise wrong(key, cls._unknown(key))
            for key, field in cls.table_keys().items():
                if field.is_required() and key not in values:
                    raise wrong(key, f"missing; {cls.meanings()[key]}")
        return values

    @classmethod
    def _unknown(cls, key: str) -> str:
        if key in cls.elsewhere:
            return cls.elsewhere[key]
        near = get_close_matches(key, cls.table_keys(), n=1)
        return (
            f'unknown key; did you mean "{near[0]}"?'
            if near
            else f"unknown key; known here: {', '.join(cls.table_keys())}"
        )

    def entries(self) -> dict[str, Any]:
        """Return every key of the table with its value, defaults included."""
        return {field.alias or name: getattr(self, name) for name, field in type(self).model_fields.items()}

    def has_key(self, key: str) -> bool:
        """Return whether the user wrote `key`, so that its default is not used."""
        return key in self.model_fields_set
