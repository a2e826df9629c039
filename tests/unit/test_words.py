"""Words of the house: functions are verbs or nouns, docstrings open with a sentence, arguments stand one to a line."""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest

from tests.support.places import SOURCES

PACKAGES = ("assess", "records", "reports", "spectra")
PARTICIPLE = re.compile(r"(ed|en|ing)$")
PREDICATES = {"is", "has", "are", "can", "must", "looks"}  # a question: is_abandoned, must_be_given
TERMS = {
    "between": "a preposition: what lies between two",
    "building": "a noun",
    "broaden": "a verb",
    "children": "a noun; matplotlib's name",
    "compiled": "a decorator: what the function below it is",
    "crossing": "a noun: where lines cross",
    "crushing": "a noun of the field: the limit state of a joint",
    "damping": "a noun of the field",
    "heading": "a noun",
    "inlined": "a decorator: what the function below it is",
    "landing": "a noun: the end of a flight",
    "linearised": "the equation that is used: rock_linearised beside rock_exact",
    "listing": "a noun: texts in a row",
    "meaning": "a noun",
    "miniseed": "the name of a format",
    "overburden": "a noun of the field",
    "pen": "a noun",
    "processing": "a noun of the field: what was done to a record",
    "ranking": "a noun",
    "reading": "a noun",
    "ring": "a noun",
    "rocking": "a noun of the field",
    "sliding": "a noun of the field",
    "springing": "a noun of the field: where an arch begins",
    "thicken": "a verb",
    "warning": "a noun",
}
AFTER_A_VERB = {
    "damaged",
    "deciding",
    "missing",
    "squared",
    "unused",
}  # remove_damaged, merge_missing, integrate_squared
PHRASES = {"as", "longest", "mechanism", "rotation"}  # as_given, mechanism_as_given, rotation_reaching


@cache
def trees() -> Mapping[Path, ast.Module]:
    """The syntax of every module, by its path from the root."""
    paths = sorted(path for package in PACKAGES for path in (SOURCES / package).rglob("*.py"))
    return {path.relative_to(SOURCES): ast.parse(path.read_text(encoding="utf-8")) for path in paths}


def is_participle(name: str) -> bool:
    """Whether a name is a participle, or ends with one that is neither a term nor what a verb before it is about."""
    first, *more = name.split("_")
    last = more[-1] if more else first
    if not PARTICIPLE.search(last) or last in TERMS or (more and first in PREDICATES | PHRASES):
        return False
    return not (more and last in AFTER_A_VERB)


def test_no_function_is_named_by_a_participle() -> None:
    """Of public functions, and public methods of classes that are no properties."""
    found = set()
    for path, tree in trees().items():
        inner = (each for one in tree.body if isinstance(one, ast.ClassDef) for each in one.body)
        for node in (*tree.body, *inner):
            if isinstance(node, ast.FunctionDef) and not node.name.startswith("_") and is_participle(node.name):
                properties = [each for each in node.decorator_list if "property" in ast.unparse(each)]
                found |= set() if properties else {f"{path} {node.name}"}
    assert found == set()


@pytest.mark.parametrize("name", ["settled", "told", "checked_periods", "overturning_rotation", "remove_damaged"])
def test_what_a_participle_is(name: str) -> None:
    assert is_participle(name) == (name == "settled")


def test_every_docstring_opens_with_a_sentence() -> None:
    nodes = ((path, node) for path, tree in trees().items() for node in ast.walk(tree))
    kinds = ast.Module | ast.ClassDef | ast.FunctionDef
    texts = ((path, node, ast.get_docstring(node) or "") for path, node in nodes if isinstance(node, kinds))
    found = {f"{path}: {text.splitlines()[0]}" for path, _, text in texts
             if text and not re.search(r"[.?:]$", text.split("\n\n")[0].strip())}  # fmt: skip
    assert found == set()


def is_overload(node: ast.FunctionDef) -> bool:
    """Tell whether it gives a type alone; the function itself has the docstring."""
    return any(isinstance(each, ast.Name) and each.id == "overload" for each in node.decorator_list)


def test_arguments_of_what_other_rooms_import_are_told() -> None:
    used = imported_elsewhere()
    found = set()
    for path, tree in trees().items():
        for node in tree.body:
            if isinstance(node, ast.FunctionDef) and (path, node.name) in used and not is_overload(node):
                arguments = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
                if len(arguments) > 1 and "Parameters\n----" not in (ast.get_docstring(node) or ""):
                    found.add(f"{path}:{node.lineno} {node.name}")
    assert found == set()


def room(path: Path) -> tuple[str, ...]:
    """A folder of assess, a module at its root, or another package as a whole."""
    parts = path.with_suffix("").parts
    return parts[:2] if parts[0] == "assess" else parts[:1]


def imported_elsewhere() -> set[tuple[Path, str]]:
    """Functions by module and name that another room imports, by themselves or through their module."""
    found: set[tuple[Path, str]] = set()
    for path, tree in trees().items():
        modules: dict[str, Path] = {}
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module:
                folder = Path(*node.module.split("."))
                source = next(
                    (each for each in (folder.with_suffix(".py"), folder / "__init__.py") if each in trees()), None
                )
                for name in node.names:
                    if (module := folder / f"{name.name}.py") in trees():
                        modules[name.asname or name.name] = module
                    elif source is not None and room(source) != room(path):
                        found.add((source, name.name))
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in modules:
                module = modules[node.value.id]
                if room(module) != room(path):
                    found.add((module, node.attr))
    return found
