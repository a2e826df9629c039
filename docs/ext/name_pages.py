"""Pages of the public names of Python: one for each of `assess.__all__`, made from its docstring."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from typing import Any

import assess
from docs.ext.docstring import DocstringSection, split
from docs.ext.markdown import cell, escape

FOLDER = "names"
WIDEST = 88  # columns of a signature on one line
LONGEST_DEFAULT = 40  # characters of a default that is shown


def pages() -> dict[str, str]:
    """Return each page by its name, as Markdown."""
    return {f"{FOLDER}/{file_name(name)}.md": _page(name, getattr(assess, name)) for name in assess.__all__}


def file_name(name: str) -> str:
    """Return the name of a page's file; `Block` and `block` must differ where files ignore case."""
    return f"class-{name.lower()}" if name[0].isupper() else name


def _page(name: str, value: Any) -> str:
    lines = [f"# `{name}`", ""]
    if isinstance(value, float):
        return "\n".join((*lines, f"Standard gravity, {value} m/s²: `0.25 * assess.g` is 0.25 g in SI.", ""))
    lines += ["```python", signature(name, value), "```", ""]
    for part in split(inspect.getdoc(value) or ""):
        lines += _part(part)
    if inspect.isclass(value):
        lines += _members(value)
    return "\n".join((*lines, ""))


def signature(name: str, value: Any) -> str:
    """Return how a name is called, one argument to a line where one line is too short."""
    found = inspect.signature(value)
    result = found.return_annotation
    end = "" if result in (inspect.Signature.empty, None, "None") else f" -> {_type(result)}"
    words = list(_arguments(found))
    line = f"assess.{name}({', '.join(words)}){end}"
    if len(line) <= WIDEST:
        return line
    return f"assess.{name}(\n" + "".join(f"    {word},\n" for word in words) + f"){end}"


def _arguments(found: inspect.Signature) -> Iterator[str]:
    starred = False
    for each in found.parameters.values():
        if each.kind is each.KEYWORD_ONLY and not starred:
            starred = True
            yield "*"
        kind = f": {_type(each.annotation)}" if each.annotation is not each.empty else ""
        default = repr(each.default)
        given = "" if each.default is each.empty else f" = {default if len(default) <= LONGEST_DEFAULT else '...'}"
        yield f"{each.name}{kind}{given}"


def _type(annotation: Any) -> str:
    return annotation if isinstance(annotation, str) else getattr(annotation, "__name__", str(annotation))


def _part(part: DocstringSection) -> list[str]:
    title = [f"## {part.title}", ""] if part.title else []
    rows = [f"| `{name}` | {cell(escape(text))} |" for name, text in part.items]
    table = ["| name | what it is |", "|---|---|", *rows, ""] if rows else []
    return [*title, *(f"{escape(text)}\n" for text in part.paragraphs), *table]


def _members(value: type) -> list[str]:
    """Return a table of the properties and methods of a class."""
    rows = [
        f"| `{name}{'()' if inspect.isfunction(member) else ''}` | {cell(escape(_first(member)))} |"
        for name, member in inspect.getmembers(value)
        if not name.startswith("_") and inspect.getdoc(member) and _is_own(member)
    ]
    return ["## Properties and methods", "", "| name | what it is |", "|---|---|", *rows, ""] if rows else []


def _is_own(member: Any) -> bool:
    return inspect.isfunction(member) or isinstance(member, property) or hasattr(member, "attrname")


def _first(member: Any) -> str:
    return " ".join((inspect.getdoc(member) or "").split("\n\n")[0].split())
