"""Where the sources can be mutated, and what is left alone because no result depends on it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from cosmic_ray.ast import ast_nodes, get_ast
from cosmic_ray.mutating import mutate_code
from cosmic_ray.operators.provider import OperatorProvider

from tests.mutate.text import ReplaceText

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
ELSEWHERE = ("assess/geometry/formats", "records/compilation", "records/catalogue.py", "records/indexing.py")
"""Files, caches and catalogues: what `make fuzz` and `make kill` try."""
ARITHMETIC, BITS, ORDER, SAME = (
    {"Add", "Sub", "Mul", "Div", "Pow"},
    {"BitOr", "BitAnd"},
    set("Lt LtE Gt GtE Eq NotEq".split()),
    {"Is", "IsNot"},
)
ALIKE = (ARITHMETIC, BITS, {*ORDER}, SAME)  # only within one of these: 1.5 << x is killed by whatever calls it
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
    tree = get_ast((ROOT / path).read_text(encoding="utf-8"))
    nodes, found = list(ast_nodes(tree)), dict[tuple[Any, str], list[tuple[str, int]]]()
    at = dict[tuple[Any, str], Any]()
    for name, operator in operators().items():
        positions = ((node, place) for node in nodes for place in operator.mutation_positions(node))
        for occurrence, (node, place) in enumerate(positions):
            if not _left_alone(node, name):
                key = place, name.split("_")[0]
                found.setdefault(key, []).append((name, occurrence))
                at[key] = node
    return [
        Site(path, key[0], _statement(at[key]), _function(at[key]), tuple(mutants)) for key, mutants in found.items()
    ]


def mutated(path: str, operator: str, occurrence: int) -> str | None:
    """The source with the mutant; None where it would not compile, or would compile to the same."""
    source = (ROOT / path).read_text(encoding="utf-8")
    changed = mutate_code(source, operators()[operator], occurrence)
    try:
        return None if changed is None or ast.dump(ast.parse(changed)) == ast.dump(ast.parse(source)) else str(changed)
    except SyntaxError:
        return None


def _left_alone(node: Any, operator: str) -> bool:
    """Whether it is an annotation, a docstring, words of an error, a type, or what only changes the time taken."""
    if node.type == "operator" and node.parent.type in ("parameters", "param"):
        return True
    within = node
    while within is not None:
        parent = within.parent
        if within.type in (
            "annassign",
            "param",
            "funcdef",
            "raise_stmt",
            "atom_expr",
            "decorator",
            "expr_stmt",
            "if_stmt",
        ):
            if _passes(within, node, operator):
                return True
        if node.type == "string" and parent is not None and parent.type == "simple_stmt" and within is node:
            return True
        within = parent
    return False


def _passes(within: Any, node: Any, operator: str) -> bool:
    code = within.get_code(include_prefix=False)
    inside = [child for child in getattr(within, "children", ()) if child.start_pos <= node.start_pos < child.end_pos]
    child = inside[0] if inside else None
    match within.type:
        case "annassign":
            return child is within.children[1]
        case "param":
            return child is not None and child is not within.default and child.type == "tfpdef"
        case "funcdef":
            return within.annotation is not None and child is within.annotation
        case "raise_stmt":
            return operator == "ReplaceText"
        case "atom_expr":
            return (
                within.children[0].type == "name"
                and within.children[0].value in TYPES
                and code.startswith(tuple(f"{each}{opening}" for each in TYPES for opening in "[("))
            )
        case "decorator":
            return code.lstrip("@").split("(")[0].split("\n")[0].strip() in TIME_ONLY
        case "expr_stmt":
            return code.startswith("__")
        case _:
            return code.startswith("if TYPE_CHECKING")


def _statement(node: Any) -> tuple[int, int]:
    """First and last line of the smallest statement around a node; of a compound one, its head."""
    while node.parent is not None and node.type not in ("simple_stmt", "funcdef", "classdef"):
        if node.parent.type in ("if_stmt", "for_stmt", "while_stmt", "with_stmt", "try_stmt") and node.type != "suite":
            break
        node = node.parent
    if node.type in ("funcdef", "classdef"):
        return int(node.start_pos[0]), int(node.start_pos[0])
    return int(node.start_pos[0]), int(node.end_pos[0]) - (node.end_pos[1] == 0)


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
