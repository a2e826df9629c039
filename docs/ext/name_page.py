"""Pages of the public names of Python: one for each of `assess.__all__`, made from its docstring."""

from __future__ import annotations

import inspect
from collections.abc import Iterator, Mapping
from dataclasses import is_dataclass
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

import assess
from assess.declaration import IsPlace, Number, annotations_of, descriptions, marks_of
from assess.project.units import KINDS
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
        lines += [*_fields(value), *_members(value)]
    return "\n".join((*lines, ""))


def signature(name: str, value: Any) -> str:
    """Return how a name is called, one argument to a line where one line is too short."""
    found = inspect.signature(value)
    result, declared = found.return_annotation, annotations_of(value) if _is_declared(value) else {}
    end = "" if result in (inspect.Signature.empty, None, "None") else f" -> {_type(result)}"
    words = list(_arguments(found, {key: _plain(annotation) for key, annotation in declared.items()}))
    line = f"assess.{name}({', '.join(words)}){end}"
    if len(line) <= WIDEST:
        return line
    return f"assess.{name}(\n" + "".join(f"    {word},\n" for word in words) + f"){end}"


def _arguments(found: inspect.Signature, declared: Mapping[str, str]) -> Iterator[str]:
    starred = False
    for each in found.parameters.values():
        if each.kind is each.KEYWORD_ONLY and not starred:
            starred = True
            yield "*"
        kind = f": {declared.get(each.name) or _type(each.annotation)}" if each.annotation is not each.empty else ""
        default = repr(each.default)
        given = "" if each.default is each.empty else f" = {default if len(default) <= LONGEST_DEFAULT else '...'}"
        yield f"{each.name}{kind}{given}"


def _type(annotation: Any) -> str:
    return annotation if isinstance(annotation, str) else getattr(annotation, "__name__", str(annotation))


def _is_declared(value: Any) -> bool:
    """Return whether a class declares its fields, with a sentence below each."""
    return inspect.isclass(value) and is_dataclass(value) and bool(descriptions(value))


def _plain(annotation: Any) -> str:
    """Return a type without its marks, as Python writes it."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return _plain(parts[0])
    if origin in (Union, UnionType):
        return " | ".join(map(_plain, parts))
    if origin is not None:
        name = getattr(origin, "__name__", "Literal")
        return f"{name}[{', '.join(repr(each) if origin is Literal else _plain(each) for each in parts)}]"
    return {NoneType: "None", Ellipsis: "..."}.get(annotation) or _type(annotation)


def _fields(value: type) -> list[str]:
    """Return a table of the fields that a class declares, each with its SI unit and the sentence below it."""
    if not _is_declared(value):
        return []
    sentences = descriptions(value)
    rows = [
        f"| `{key}` | {_unit(annotation)} | {cell(escape(' '.join(sentences.get(key, '').split())))} |"
        for key, annotation in annotations_of(value).items()
    ]
    return ["| name | unit | what it is |", "|---|---|---|", *rows, ""]


def _unit(annotation: Any) -> str:
    """Return the SI unit of a number or a place; a project file has units of its own."""
    marks = list(marks_of(annotation))
    if any(isinstance(mark, IsPlace) for mark in marks):
        return "m"
    dimension = next((mark.dimension for mark in marks if isinstance(mark, Number)), "")
    return KINDS[dimension].symbol.replace("no unit", "").replace("^2", "²") if dimension else ""


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
