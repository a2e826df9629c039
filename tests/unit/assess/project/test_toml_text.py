"""The text of a project file with other values: comments stay, and what is read back is what was asked."""

from __future__ import annotations

import copy
import tomllib
from typing import Any

import pytest

from assess.project.toml_text import value_text, whole_text, with_changes

TEXT = '''#:schema ./project.schema.json
title = "A \\"wall\\" # no comment"  # the title
"strange key".b = 'x'

[mechanisms.facade]  # the front
direction = [1, 0,
  0,  # up
]
loads = [
  # the tie
  { kind = "tie", area = "314 mm^2", at = [-0.3, 0, 5.5] },  # d20
]
note = """
[not.a.table]
a = 1 """

[[analysis.sweep]]
key = "one"
[[analysis.sweep]]
key = "two"

[bodies]
wall = { material = "stone", box = { thickness = 0.6, length = 8.0 } }
date = 2026-01-02 03:04:05
'''


def change(path: tuple[str | int, ...], value: Any) -> dict[str, Any]:
    tables: Any = copy.deepcopy(tomllib.loads(TEXT))
    node = tables
    for step in path[:-1]:
        node = node.setdefault(step, {}) if isinstance(node, dict) else node[step]
    if isinstance(node, list) and path[-1] == len(node):
        node.append(value)
    else:
        node[path[-1]] = value
    return tables  # type: ignore[no-any-return]


@pytest.mark.parametrize(
    ("path", "value", "line"),
    [
        (("mechanisms", "facade", "loads", 0, "area"), "452 mm^2", 'area = "452 mm^2", at'),
        (("mechanisms", "facade", "loads", 0, "length"), "10 m", '5.5], length = "10 m" },  # d20'),
        (("mechanisms", "facade", "loads", 1), {"kind": "tie"}, '5.5] },\n  { kind = "tie" },  # d20'),
        (("mechanisms", "facade", "direction", 1), 1, "[1, 1,"),
        (("mechanisms", "facade", "cut"), 1.5, "[mechanisms.facade]  # the front\ncut = 1.5\n"),
        (("analysis", "sweep", 1, "key"), "three", 'key = "three"'),
        (("analysis", "sweep", 2), {"key": "four"}, '[[analysis.sweep]]\nkey = "four"'),
        (("bodies", "wall", "box", "thickness"), 0.7, "thickness = 0.7, length"),
        (("bodies", "tab\there"), {"a.b": float("inf")}, '"tab\\there" = { "a.b" = inf }'),
        (("verdict", "limit_state"), "SLC", '[verdict]\nlimit_state = "SLC"'),
        (("strange key", "b"), "y", '"strange key".b = "y"'),
        (("title",), "wall", 'title = "wall"  # the title'),
    ],
)
def test_one_value_changes_and_comments_stay(path: tuple[str | int, ...], value: Any, line: str) -> None:
    after = change(path, value)
    text, kept = with_changes(TEXT, after)
    assert kept
    assert tomllib.loads(text) == after
    assert line in text
    assert all(comment in text for comment in ("#:schema", "# the tie", "# d20", "# up", "# the front"))


def test_what_cannot_be_changed_in_place_is_written_anew() -> None:
    after = {"title": "a", "bodies": {"wall": {"x": [1, "two"]}}}
    text, kept = with_changes(TEXT, after)
    assert not kept
    assert tomllib.loads(text) == after


def test_a_whole_file_is_read_back() -> None:
    tables = tomllib.loads(TEXT)
    assert tomllib.loads(whole_text(tables)) == tables
    assert value_text({"a": [True, 1, 0.1, "\x7f"]}) == '{ a = [true, 1, 0.1, "\\u007f"] }'


READY = """\
title = "a"
# The site.
# [site.spectrum]
# code = "ntc2018"
# soil = "B"             # and topography
# [report.sources]
# "materials.stone.disintegration" = "measured: …"
[materials.stone]
density = 1800
# disintegration = "excluded"

[report]
author = "b"
"""


def test_what_a_comment_holds_ready_is_filled_in() -> None:
    """The file as an engineer with an editor would have it: each comment gone, and nothing said twice."""
    after: Any = tomllib.loads(READY)
    after["site"] = {"spectrum": {"code": "ec8", "soil": "C", "a_g": "0.2 g"}, "limit_state": "SLV"}
    after["report"] |= {"sources": {"materials.stone.disintegration": "measured: core"}, "office": "c"}
    after["materials"]["stone"]["disintegration"] = "excluded"
    text, kept = with_changes(READY, after)
    assert kept
    assert (
        text
        == """\
title = "a"
# The site.
[site.spectrum]
a_g = "0.2 g"
code = "ec8"
soil = "C"
[report.sources]
"materials.stone.disintegration" = "measured: core"
[materials.stone]
density = 1800
disintegration = "excluded"

[report]
office = "c"
author = "b"


[site]
limit_state = "SLV"
"""
    )


def test_a_table_of_its_own_is_written_with_a_head_at_the_end() -> None:
    """So that a head of it that stands in no comment can be written later as anywhere."""
    before = '[report]\nauthor = "b"\n# [report.sources]\nclient = "d"\n\n[bodies]\nwall = { x = 1 }\n'
    after = tomllib.loads(before) | {"report": {"author": "b", "client": "d", "sources": {"a.b": "measured: c"}}}
    text, kept = with_changes(before, after)
    assert kept
    assert text == before + '\n\n[report.sources]\n"a.b" = "measured: c"\n'
