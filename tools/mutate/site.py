"""Where the sources can be mutated, and what is left alone because no result depends on it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
TARGETS = (
    "assess/oscillator.py",
    "assess/mechanisms",
    "assess/interfaces",
    "assess/loads",
    "assess/geometry",
    "assess/dynamics",
    "assess/amplification",
    "assess/codes",
    "assess/risk",
    "spectra",
    "records",
)
ELSEWHERE = ("assess/geometry/formats", "records/compilation", "records/catalogue.py")
"""Files, caches and catalogues: what `make fuzz` and `make kill` try."""
ALIKE = (
    {"Add", "Sub", "Mul", "Div", "Pow"},
    {"BitOr", "BitAnd"},
    {"Lt", "LtE", "Gt", "GtE", "Eq", "NotEq"},
    {"Is", "IsNot"},
)
"""One is replaced by another of its group only: 1.5 << x is killed by whatever calls it."""
NODES = {"ReplaceBinaryOperator": "operator", "ReplaceComparisonOperator": "comparison", "NumberReplacer": "number"}
"""Types of nodes by the name of the operators that look at no others."""
TIME_ONLY = ("cache", "lru_cache", "compiled", "inlined", "reachable", "entry", "njit", "cache_on_disk")
"""Decorators that change how long a function takes, or from where it can be called, never what it returns."""
TYPES = ("Literal", "Callable", "Mapping", "Sequence", "Iterator", "Iterable", "NDArray", "TypeVar", "cast")


@dataclass(frozen=True)
class Site:
    """A place of a source with what can be put there: pairs of an operator's name and its occurrence in the file."""

    path: str
    place: tuple[tuple[int, int], tuple[int, int]]
    statement: tuple[int, int]  # its first and last line
    function: str  # "" outside functions
    mutants: tuple[tuple[str, int], ...]


@cache
def operators() -> dict[str, Any]:
    """Cosmic Ray's without arguments that change a result of this program, and ours, by name."""
    from cosmic_ray.operators.provider import OperatorProvider

    from tools.mutate.text import ReplaceText

    given = OperatorProvider()
    taken = {name: given[name]() for name in given if not given[name].arguments() and _kept(name)}
    return {**taken, "ReplaceText": ReplaceText()}


def _kept(name: str) -> bool:
    what, *pair = name.split("_")
    if what in ("ReplaceBinaryOperator", "ReplaceComparisonOperator"):
        return any(set(pair) <= group for group in ALIKE)
    return not name.startswith("ReplaceUnaryOperator") or "Invert" not in pair


def files() -> list[str]:
    """The sources, by path from the root."""
    found = (
        path for each in TARGETS for path in ([ROOT / each] if each.endswith(".py") else (ROOT / each).rglob("*.py"))
    )
    names = sorted(path.relative_to(ROOT).as_posix() for path in found)
    return [name for name in names if not name.startswith(ELSEWHERE)]


def sites(path: str) -> list[Site]:
    """The places of one file."""
    from cosmic_ray.ast import ast_nodes, get_ast

    by_type, places = dict[str, list[Any]](), dict[tuple[Any, str], tuple[Any, list[tuple[str, int]]]]()
    every = list(ast_nodes(get_ast((ROOT / path).read_text(encoding="utf-8"))))
    for node in every:
        by_type.setdefault(node.type, []).append(node)
    for name, operator in operators().items():
        family = name.split("_")[0]
        nodes = by_type.get(NODES[family], []) if family in NODES else every
        positions = ((node, place) for node in nodes for place in operator.mutation_positions(node))
        for occurrence, (node, place) in enumerate(positions):
            if not _left_alone(node, name):
                places.setdefault((place, family), (node, []))[1].append((name, occurrence))
    return [
        Site(path, place, _statement(node), _function(node), tuple(mutants))
        for (place, _), (node, mutants) in places.items()
    ]


def mutated(path: str, operator: str, occurrence: int) -> str | None:
    """The source with the mutant; None where it would not compile, or would compile to the same."""
    from cosmic_ray.mutating import mutate_code

    source = (ROOT / path).read_text(encoding="utf-8")
    changed = mutate_code(source, operators()[operator], occurrence)
    try:
        return None if changed is None or ast.dump(ast.parse(changed)) == ast.dump(ast.parse(source)) else str(changed)
    except SyntaxError:
        return None


def _left_alone(node: Any, operator: str) -> bool:
    """Whether it is an annotation, a docstring, words of an error, a type, or what only changes the time taken."""
    parent = node.parent.type if node.parent is not None else ""
    bare = (node.type, parent) == ("string", "simple_stmt") or (node.type == "operator" and parent.startswith("param"))
    around = list[Any]([node])
    while around[-1].parent is not None:
        around.append(around[-1].parent)
    return bare or any(_without_result(each, node, operator) for each in around)


def _without_result(around: Any, node: Any, operator: str) -> bool:
    """Whether a part of the tree says that the node in it changes no result."""
    match around.type:
        case "annassign":
            return _holds(around.children[1], node)
        case "param":
            return around.annotation is not None and _holds(around.annotation, node)
        case "funcdef":
            return around.annotation is not None and _holds(around.annotation, node)
        case "raise_stmt":
            return operator == "ReplaceText"
        case "atom_expr":
            return str(around.children[0].get_code(include_prefix=False)) in TYPES
        case "argument":
            return str(around.children[0].get_code(include_prefix=False)) == "strict"  # that lengths agree is asserted
        case "decorator":
            return str(around.get_code()).strip().lstrip("@").split("(")[0].strip() in TIME_ONLY
        case "expr_stmt":
            return str(around.children[0].get_code(include_prefix=False)).startswith("__")
        case "if_stmt":
            return str(around.children[1].get_code()).strip() == "TYPE_CHECKING"
        case _:
            return False


def _holds(part: Any, node: Any) -> bool:
    return bool(part.start_pos <= node.start_pos < part.end_pos)


def _statement(node: Any) -> tuple[int, int]:
    """First and last line of the smallest statement around a node; of a compound one, the node's own."""
    around = node
    while around.parent is not None and around.type not in ("simple_stmt", "suite", "file_input"):
        around = around.parent
    around = around if around.type == "simple_stmt" else node
    first = int(around.start_pos[0])
    return first, first if around.type.endswith(("_stmt", "def")) and around.type != "simple_stmt" else int(
        around.end_pos[0]
    )


def _function(node: Any) -> str:
    names = list[str]()
    child = node
    while child.parent is not None:
        if child.parent.type in ("funcdef", "classdef") and (
            child.type == "suite" or child.parent.type == "classdef" or names
        ):
            names.append(child.parent.name.value)
        child = child.parent
    return ".".join(reversed(names))


def all_sites() -> Iterator[Site]:
    """The places of all sources."""
    for path in files():
        yield from sites(path)
