"""Every fixed English term that results can carry, read out of the source, and the objects that results hold.

A term is a literal that reaches a field of the results: an argument of a function that makes lines of calculation
sheets, a keyword such as `caveat` or `damping_rule`, a member of a table, or what `Term(…)` holds. A name is followed
to what is assigned to it in its function, in its module, or in the module that it is imported from.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import TypeVar

from tests.support.places import SOURCES

T = TypeVar("T")

FOLDERS = (
    "assess/codes",
    "assess/loads",
    "assess/mechanisms",
    "assess/model",
    "assess/project",
    "assess/results",
    "assess/study",
    "records",
    "spectra",
)
PLACES: Mapping[str, tuple[int, ...]] = {
    "step": (1, 2, 3),
    "_link_step": (1, 2, 3),
    "instability_step": (1, 2),
    "integral_step": (1, 2),
    "reading_step": (1, 2),
    "multiplier_step": (1, 2),
    "displacement_steps": (1, 2),
    "collapse_steps": (1,),
    "curve_steps": (1, 3),
    "displacement_capacity_steps": (4,),
    "first_mode_steps": (4,),
    "ground_step": (1,),
    "displacement_ratio_step": (1,),
    "acceleration_ratio_steps": (0,),
    "line": (2,),
    "_friction_step": (1,),
    "_governing_step": (),
    "ConfidenceFactor": (1,),
    "DisplacementLimit": (2,),
    "Term": (0,),
    "describe_disagreement": (0, 2),
    "warn_of_difference": (0, 2),
    "caveats_of": tuple(range(6)),
    "check_limit": (1, 3),
    "no_answer": (1, 3),
    "_answered": (1, 3),
    "FreePeriod": (1, 3),
    "UnvariedNumber": (2,),
    "LimitState": (1,),
    "MechanismAmplification": (3,),
    "Construction": (0,),
    "Edition": (0, 1, 2),
    "ItalianEdition": (0, 1, 2),
    "UltimateState": tuple(range(6)),
    "PossibleMechanism": (2,),
    "_number": (2,),
}
"""By the name of a function, its arguments that are terms."""
KEYWORDS = frozenset(
    {
        "remark", "why", "clause", "damping_rule", "damping", "caveat", "edition", "quantity", "limit_state",
        "multiplier", "oscillator", "confidence", "uncompared", "clauses", "design", "mce", "frequency_from",
        "effective_from", "checked_as",
    }
)  # fmt: skip
"""Keywords whose literals are terms, whatever is called with them."""
OF_CALLS: Mapping[str, tuple[str, ...]] = {
    "Edition": ("name",),
    "ItalianEdition": ("name",),
    "HistoryRule": ("clause",),
    "DisplacementLimit": ("clause",),
    "replace": ("description",),
}
"""Further keywords, of single functions."""
IDENTIFIER = re.compile(r"[a-z]+(?:[_-][a-z]+)+")
CONSTANTS: Mapping[str, tuple[str, ...]] = {
    "records/formats/cosmos.py": ("PLACES",),
    "assess/study/amplification.py": (
        *("BY_BUILDING", "BY_MECHANISM", "BY_TABLE", "BY_BODIES", "UNKNOWN"),
        *("FLOOR_FACTORS", "FIRST_MODES", "ASSUMPTIONS", "RAYLEIGH"),
    ),
    "assess/study/checks.py": ("OF_SUITE", "OF_CIRCOLARE", "DAMPING_OF_SUITE", "DAMPING_OF_CIRCOLARE"),
    "spectra/ntc.py": ("CLAUSES",),
    "assess/study/suites.py": ("FITTED_OVER",),
    "assess/project/variables.py": ("AT_MOST_1", "SWEPT"),
    "assess/study/history_controls.py": (
        *("LARGEST_ROTATION", "OVERTURNING_TIME", "OVERTURNING_ROTATION", "ENERGY_BALANCE"),
    ),
    "assess/study/controls.py": ("VERTICAL", "HORIZONTAL", "UPLIFT_MULTIPLIER"),
    "records/compliance/suite.py": ("CAVEAT",),
    "records/selection.py": ("STEPS",),
    "assess/codes/asce41_13.py": ("PLACES", "PERMITTED", "SEISMICITY"),
    "assess/codes/en1998_1.py": ("ELEMENTS", "TIED", "TYPED"),
    "assess/model/directions.py": ("OTHER_SIDE",),
}
"""Constants that reach results by a way that is not followed."""
RETURNED: Mapping[str, tuple[str, ...]] = {
    "assess/study/ground_motion.py": ("source_of",),
    "assess/study/amplification.py": ("given_frequency", "given_effective_height"),
    "assess/codes/asce41_13.py": ("_source",),
    "assess/project/variables.py": ("fixed_thickness_reason",),
}
"""Functions that return terms."""


@cache
def fixed_terms() -> tuple[str, ...]:
    """Every fixed English term that results can carry, each once, in order."""
    files = [file for folder in FOLDERS for file in sorted((SOURCES / folder).rglob("*.py"))]
    found = {term for file in files for term in _of_file(file)}
    return tuple(sorted(term for term in found if any(map(str.isalpha, term)) and not IDENTIFIER.fullmatch(term)))


def objects_in(data: object, kind: type[T]) -> Iterator[T]:
    """Yield every object of a class within data, those that stand in others of the class too."""
    if isinstance(data, kind):
        yield data
    if is_dataclass(data):
        parts: tuple[object, ...] = tuple(getattr(data, each.name) for each in fields(data))
    elif isinstance(data, dict):
        parts = tuple(data.values())
    else:
        parts = tuple(data) if isinstance(data, tuple | list) and not (data and isinstance(data[0], float)) else ()
    for each in parts:
        yield from objects_in(each, kind)


def _of_file(file: Path) -> Iterator[str]:
    tree, name = _tree(file), str(file.relative_to(SOURCES))
    for constant in CONSTANTS.get(name, ()):
        yield from _resolved(ast.Name(constant), file, tree)
    for scope in _scopes(tree):
        if isinstance(scope, ast.FunctionDef) and scope.name in RETURNED.get(name, ()):
            for node in ast.walk(scope):
                if isinstance(node, ast.Return) and node.value is not None:
                    yield from _resolved(node.value, file, scope)
        for call in _calls(scope):
            yield from _of_call(call, file, scope)


def _of_call(call: ast.Call, file: Path, scope: ast.AST) -> Iterator[str]:
    called = call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
    worked = any(each.arg == "given" for each in call.keywords)
    for place in PLACES.get(called, ()):
        formula = called == "step" and place == 3 and worked
        if place < len(call.args) and not formula:
            yield from _resolved(call.args[place], file, scope)
    for each in call.keywords:
        if each.arg in KEYWORDS or each.arg in OF_CALLS.get(called, ()):
            yield from _resolved(each.value, file, scope)


def _resolved(value: ast.AST, file: Path, scope: ast.AST, depth: int = 0) -> Iterator[str]:
    """The literals that an expression may come to."""
    if depth > 6:
        return
    if isinstance(value, ast.Constant):
        if isinstance(value.value, str) and value.value:
            yield value.value
    elif isinstance(value, ast.Name):
        yield from _assigned(value.id, file, scope, depth + 1)
    elif isinstance(value, ast.IfExp):
        for branch in (value.body, value.orelse):
            yield from _resolved(branch, file, scope, depth + 1)
    elif isinstance(value, ast.BoolOp | ast.Tuple | ast.List):
        for part in value.values if isinstance(value, ast.BoolOp) else value.elts:
            yield from _resolved(part, file, scope, depth + 1)
    elif isinstance(value, ast.Dict):
        for part in value.values:
            yield from _resolved(part, file, scope, depth + 1)
    elif isinstance(value, ast.Subscript | ast.Starred):
        yield from _resolved(value.value, file, scope, depth + 1)
    elif isinstance(value, ast.Call) and isinstance(value.func, ast.Attribute) and value.func.attr == "get":
        for part in (value.func.value, *value.args[1:]):
            yield from _resolved(part, file, scope, depth + 1)


def _assigned(name: str, file: Path, scope: ast.AST, depth: int) -> Iterator[str]:
    tree = _tree(file)
    for place in dict.fromkeys((scope, *_functions_around(tree).get(scope, ()), tree)):
        values = _assignments(place, whole=place is not tree).get(name, ())
        if values:
            for value in values:
                yield from _resolved(value, file, scope, depth)
            return
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.module and name in {each.name for each in node.names}:
            other = SOURCES / f"{node.module.replace('.', '/')}.py"
            if other.is_file():
                yield from _assigned(name, other, _tree(other), depth)


@cache
def _functions_around(tree: ast.Module) -> Mapping[ast.AST, list[ast.AST]]:
    """Return the functions that each function stands in, itself among them, the outermost first."""
    around: dict[ast.AST, list[ast.AST]] = {}
    for outer in _scopes(tree):
        for node in ast.walk(outer) if outer is not tree else ():
            if isinstance(node, ast.FunctionDef):
                around.setdefault(node, []).append(outer)
    return around


@cache
def _assignments(scope: ast.AST, *, whole: bool) -> Mapping[str, list[ast.AST]]:
    """Return what is assigned to each name, alone or among others."""
    assigned: dict[str, list[ast.AST]] = {}
    for node in ast.walk(scope) if whole else ast.iter_child_nodes(scope):
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        value = getattr(node, "value", None)
        for target in targets if isinstance(node, ast.Assign | ast.AnnAssign) and value is not None else ():
            if isinstance(target, ast.Name):
                assigned.setdefault(target.id, []).append(value)
            if isinstance(target, ast.Tuple):
                for name, part in _paired(target, value):
                    assigned.setdefault(name, []).append(part)
    return assigned


def _paired(target: ast.Tuple, value: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    branches = (value.body, value.orelse) if isinstance(value, ast.IfExp) else (value,)
    for branch in branches:
        if isinstance(branch, ast.Tuple) and len(branch.elts) == len(target.elts):
            pairs = zip(target.elts, branch.elts, strict=True)
            yield from ((each.id, part) for each, part in pairs if isinstance(each, ast.Name))


def _scopes(tree: ast.Module) -> Iterator[ast.AST]:
    """The module without its functions, and each function with what it holds."""
    yield tree
    yield from (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef))


def _calls(scope: ast.AST) -> Iterator[ast.Call]:
    waiting: list[ast.AST] = list(ast.iter_child_nodes(scope))
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.FunctionDef):
            continue
        if isinstance(node, ast.Call):
            yield node
        waiting += ast.iter_child_nodes(node)


@cache
def _tree(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding="utf-8"))
