"""Every function that the pages on theory name is in the file that they name."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NAMED = re.compile(r"`([\w/]+\.py): (\w+)`")
PAGES = sorted((ROOT / "docs" / "theory").glob("*.md"))


@cache
def names_of(file: str) -> frozenset[str]:
    """The functions, classes and constants of a module."""
    found = set()
    for node in ast.walk(ast.parse((ROOT / file).read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found |= {target.id for target in targets if isinstance(target, ast.Name)}
    return frozenset(found)


@pytest.mark.parametrize("page", PAGES, ids=[page.stem for page in PAGES])
def test_every_function_named_exists(page: Path) -> None:
    named = NAMED.findall(page.read_text(encoding="utf-8"))
    assert named or page.stem == "index"
    assert [(file, name) for file, name in named if name not in names_of(file)] == []
