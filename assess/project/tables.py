"""What reads one of several tables of a project file, each made of the class of plain data that it stands for."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from functools import reduce
from operator import or_
from typing import Annotated, Any

from pydantic import Discriminator, Tag

from assess.project.key_errors import quote_names
from assess.project.section import table_of


def table_by_kind(kinds: Mapping[str, Any], *, what: str) -> Any:
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


def table_by_code(codes: Mapping[str, Sequence[Any]], class_of: Callable[[str, Collection[str]], Any]) -> Any:
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
