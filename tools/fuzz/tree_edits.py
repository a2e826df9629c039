"""Edits of trees of keys and values, drawn by hypothesis: project files in TOML, results.json."""

from __future__ import annotations

import copy
import json
import tomllib
from collections.abc import Callable, Iterator
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from tools.fuzz.fuzz_input import Edit, FuzzInput, rewritten

Path = tuple[str | int, ...]
NUMBERS = (
    *(0, -0.0, -1, 1, 1e-300, 1e300, -1e300, 10**30, -(10**30), 2**63, 1e-9, 1e9, 0.5, 3),
    *(float("nan"), float("inf"), float("-inf"), True, False),
)
TEXTS = (
    *("", " ", "nan", "inf m", "1,25 m", "1.5 kN", "1.25", "1.25 m m", "9**9**9 m", "1e400 m", "-2 m", "0 g", "2 %"),
    *(
        "3 ft",
        "1 inch",
        "20 kN/m^3",
        "1.2.3 m",
        "1 m; 2 m",
        "١ m",
        "½ m",
        "1\u200b.5 m",
        "\u202e1 m",
        "\x00",
        "x" * 5000,
    ),
    *("../../../etc/passwd", "/etc/passwd", "/dev/zero", "a/\n/b", "=cmd|'/c calc'!A1", "<b>&amp;", "$x$", "{0}", "%s"),
    *("C:\\x", "~root", "none", "positive", "sweep", "minimum", "records/*", "**/*", "wall.stl", "\ud7ff", "😀"),
)
VALUES = st.one_of(
    st.sampled_from(NUMBERS),
    st.sampled_from(TEXTS),
    st.floats(),
    st.integers(),
    st.text(st.characters(exclude_categories=("Cs",)), max_size=12),
    st.sampled_from(([], {}, [[]], [{}], [1, 2], [1, "a", {}], {"a": {"b": {}}}, {"value": 1, "given": True})),
    st.integers(1, 400).map(lambda depth: _deep(depth)),
)
KEYS = st.one_of(
    st.sampled_from(("", " ", "kind", "mass", "Kind", "kınd", "a.b", '"', "\u202e", "=x", "../x", "<b>", "x" * 3000)),
    st.text(st.characters(exclude_categories=("Cs",)), max_size=6),
)
FACTORS = (10.0, 0.1, -1.0, 1.0 + 1e-6, 1e3, 1e-3, 0.0)


def _deep(depth: int) -> Any:
    tree: Any = 1
    for _ in range(depth):
        tree = [tree]
    return tree


def places(tree: Any, at: Path = ()) -> Iterator[Path]:
    """Every place in a tree but its root; of long lists the first three."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree[:3]) if isinstance(tree, list) else ()
    for key, value in items:
        yield (*at, key)
        yield from places(value, (*at, key))


@st.composite
def changed(draw: st.DrawFn, tree: Any, listed: list[Path]) -> tuple[Any, str, str]:
    """A tree with one change at one of the places `listed`: the tree, the place, and what was done."""
    new = copy.deepcopy(tree)
    path = draw(st.sampled_from(listed))
    parent = new
    for step in path[:-1]:
        parent = parent[step]
    key, old = path[-1], parent[path[-1]]
    verb = draw(st.sampled_from(("value", "value", "value", "scaled", "type", "remove", "rename", "double", "other")))
    if verb == "remove":
        del parent[key]
    elif verb in ("rename", "double"):
        name: Any = draw(KEYS)
        if isinstance(parent, dict):
            parent[name] = copy.deepcopy(old) if verb == "double" else parent.pop(key)
        else:
            parent.insert(0, copy.deepcopy(old))
    elif verb == "other":  # what stands at another place of the tree
        parent[key] = copy.deepcopy(_at(tree, draw(st.sampled_from(listed))))
    elif verb == "scaled" and isinstance(old, int | float):
        parent[key] = old * draw(st.sampled_from(FACTORS))
    elif verb == "type":
        parent[key] = draw(st.sampled_from((str(old), [old], {"value": old}, None if _none_goes(tree) else "null")))
    else:
        parent[key] = draw(VALUES)
    what = f"{verb}: {str(old)[:40]!r} -> {str(_if_there(parent, key))[:60]!r}"
    return new, ".".join(map(str, path)), what


def _if_there(parent: Any, key: Any) -> Any:
    """What stands at a key now."""
    there = key in parent if isinstance(parent, dict) else key < len(parent)
    return parent[key] if there else "nothing"


def _none_goes(tree: Any) -> bool:
    """Whether the tree is of JSON, which has null; projects have no such key."""
    return "schema_version" in tree


def _at(tree: Any, path: Path) -> Any:
    for step in path:
        tree = tree[step]
    return tree


def drawn(strategy: st.SearchStrategy[Any], *, start: int, count: int) -> list[Any]:
    """`count` values of a strategy, or fewer where it has no more; the same for the same `start`."""
    found: list[Any] = []

    @seed(start)
    @settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(strategy)
    def keep(value: Any) -> None:
        found.append(value)

    keep()
    return found


def toml_edits(case: FuzzInput, *, start: int, count: int) -> list[tuple[Edit, ...]]:
    """Structured edits of a project file."""
    return _edits(case, tomllib.loads(case.data.decode()), toml, start=start, count=count)


def json_edits(case: FuzzInput, *, start: int, count: int) -> list[tuple[Edit, ...]]:
    """Structured edits of a file of JSON."""
    return _edits(
        case, json.loads(case.data), lambda tree: json.dumps(tree, ensure_ascii=False), start=start, count=count
    )


def _edits(case: FuzzInput, tree: Any, text: Callable[[Any], str], *, start: int, count: int) -> list[tuple[Edit, ...]]:
    found = []
    for new, where, what in drawn(changed(tree, sorted(places(tree), key=str)), start=start, count=count):
        data = text(new).encode("utf-8", "surrogatepass")
        found.append(rewritten(case, data, where=where, what=what))
    return found


def toml(tree: dict[str, Any]) -> str:
    """A tree as TOML: tables of tables below the top, the rest inline."""
    plain = [f"{_key(key)} = {_inline(value)}\n" for key, value in tree.items() if not isinstance(value, dict)]
    tables = [
        f"\n[{_key(key)}]\n" + "".join(f"{_key(name)} = {_inline(each)}\n" for name, each in value.items())
        for key, value in tree.items()
        if isinstance(value, dict)
    ]
    return "".join((*plain, *tables))


def _key(name: str) -> str:
    return name if name.isascii() and name.replace("-", "").replace("_", "").isalnum() else _quoted(name)


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _inline(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(name)} = {_inline(each)}" for name, each in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_inline, value)) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, int | float) else _quoted(str(value))
