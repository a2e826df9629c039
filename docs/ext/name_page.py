"""The page of the public names of Python, docs/reference/names.md: those of `assess.__all__`, from their docstrings."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import is_dataclass
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

import assess
from assess.declaration import IsPlace, Number, annotations_of, descriptions, marks_of
from assess.project.units import KINDS
from docs.ext.docstring import DocstringSection, split
from docs.ext.key_values import symbol
from docs.ext.markdown import contents, escape

HEAD = """# Names of Python

`import assess` gives these names, in SI units throughout: m, kg, s, N, Pa, rad, m/s². Each is loaded when it is first
used. Errors are those of `assess.errors`, with what is wrong, where, and the remedy. The page is made from the
docstrings.
"""
WIDEST = 88  # columns of a signature on one line
LONGEST_DEFAULT = 40  # characters of a default that is shown


def text() -> str:
    """Return the page as Markdown, what can be called before the classes."""
    named = {_heading(name): name for name in sorted(assess.__all__, key=lambda name: (name[0].isupper(), name))}
    return "\n".join((HEAD, contents(named), *(_section(heading, name) for heading, name in named.items())))


def _heading(name: str) -> str:
    """Return the heading of a name; links ignore case, by which `Run` and `run` differ."""
    return f"class {name}" if name[0].isupper() else name


def _section(heading: str, name: str) -> str:
    lines, value = [f"## {heading}", ""], getattr(assess, name)
    if isinstance(value, float):
        return "\n".join((*lines, f"Standard gravity, {value} m/s²: `0.25 * assess.g` is 0.25 g in SI.", ""))
    lines += ["```python", signature(name, value), "```", ""]
    for part in split(inspect.getdoc(value) or ""):
        lines += _part(part)
    if inspect.isclass(value):
        lines += [*_fields(value), *_members(value)]
    return "\n".join(lines)


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
        stars = {each.VAR_POSITIONAL: "*", each.VAR_KEYWORD: "**"}.get(each.kind, "")
        yield f"{stars}{each.name}{kind}{given}"


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
    """Return a list of the fields that a class declares, each with its SI unit and the sentence below it."""
    if not _is_declared(value):
        return []
    sentences = descriptions(value)
    found = {key: f"{_unit(annotation)}: {sentences.get(key, '')}" for key, annotation in annotations_of(value).items()}
    return _list(found.items())


def _unit(annotation: Any) -> str:
    """Return the SI unit of a number or a place, in brackets; a project file has units of its own."""
    marks = list(marks_of(annotation))
    if any(isinstance(mark, IsPlace) for mark in marks):
        return " [m]"
    dimension = next((mark.dimension for mark in marks if isinstance(mark, Number)), "")
    unit = symbol(KINDS[dimension]) if dimension else ""
    return f" [{unit}]" if unit else ""


def _part(part: DocstringSection) -> list[str]:
    """Return a part of a docstring; what has a heading is a paragraph, or a list, after it."""
    first, *more = part.paragraphs or ("",)
    head = " ".join(word for word in (part.title and f"**{part.title}.**", escape(first)) if word)
    return [f"{each}\n" for each in (head, *map(escape, more)) if each] + _list(
        (name, f": {text}") for name, text in part.items
    )


def _list(items: Iterable[tuple[str, str]]) -> list[str]:
    """Return what names stand for; a unit after the name belongs to it."""
    rows = [f"- `{name}`" + escape(re.sub(r"\s+", " ", text)) for name, text in items]
    return [*rows, ""] if rows else []


def _members(value: type) -> list[str]:
    """Return a list of the properties and methods of a class."""
    found = [
        (f"{name}()" if inspect.isfunction(member) else name, f": {_first(member)}")
        for name, member in inspect.getmembers(value)
        if not name.startswith("_") and name != "faults" and inspect.getdoc(member) and _is_own(member)
    ]
    return ["**Properties and methods.**\n", *_list(found)] if found else []


def _is_own(member: Any) -> bool:
    return inspect.isfunction(member) or isinstance(member, property) or hasattr(member, "attrname")


def _first(member: Any) -> str:
    return (inspect.getdoc(member) or "").split("\n\n")[0]
