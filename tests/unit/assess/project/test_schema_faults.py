"""The JSON Schema accepts what it accepted, and its faults lie at the key that is wrong."""

from __future__ import annotations

import copy
import json
import tomllib
from collections.abc import Iterator
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from assess.examples import source
from assess.project.project_file import json_schema, with_located_faults, with_quantity_patterns, with_uncertain_numbers
from assess.project.sections.content import Content
from tests.support.projects import as_editors_see

NEEDED = {"format", "title", "mechanisms"}
MANY = {"bodies", "materials", "mechanisms"}


@pytest.fixture(scope="module")
def located() -> Draft202012Validator:
    Draft202012Validator.check_schema(json_schema())
    return Draft202012Validator(json_schema())


@pytest.fixture(scope="module")
def plain() -> Draft202012Validator:
    return Draft202012Validator(with_quantity_patterns(with_uncertain_numbers(Content.model_json_schema())))


def example(name: str) -> dict[str, Any]:
    tables = tomllib.loads((source(name) / "project.toml").read_text(encoding="utf-8"))
    seen: dict[str, Any] = as_editors_see(tables)
    return seen


def steps(node: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the path of every value of a tree."""
    for key, each in node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ():
        yield (*path, key)
        yield from steps(each, (*path, key))


def changed(tree: dict[str, Any], path: tuple[Any, ...], value: Any) -> dict[str, Any]:
    """Return a tree with another value at a path; without it where the value is None."""
    made = copy.deepcopy(tree)
    *above, last = path
    node: Any = made
    for step in above:
        node = node[step]
    if value is None:
        del node[last]
    else:
        node[last] = value
    return made


def around(tree: dict[str, Any], path: tuple[Any, ...]) -> dict[str, Any]:
    """Return what a project needs with the table of a path, of several of a kind that one alone: soon validated."""
    kept = {key: tree[key] for key in tree if key in NEEDED or key == path[0]}
    for kind in MANY & kept.keys():
        own = path[1] if path[0] == kind and len(path) > 1 else next(iter(kept[kind]))
        kept[kind] = {own: kept[kind][own]}
    return kept


def test_what_a_project_needs_is_kept() -> None:
    assert set(json_schema()["required"]) <= NEEDED


@pytest.mark.parametrize("name", ["single_wall", "house", "san_leonardo_spire"])
@pytest.mark.parametrize("value", [None, "0.6", "ec8", 7, {"unknown": 1}])
def test_the_same_is_accepted(
    name: str, value: Any, located: Draft202012Validator, plain: Draft202012Validator
) -> None:
    tree = example(name)
    trees = [changed(around(tree, path), path, value) for path in steps(tree)]
    assert [located.is_valid(each) for each in trees] == [plain.is_valid(each) for each in trees]


@pytest.mark.parametrize(
    ("path", "value", "place"),
    [
        ("bodies.wall.box.thickness", "0.6", "bodies.wall.box.thickness"),
        ("bodies.wall.bocks", 1, "bodies.wall"),
        ("bodies.wall", {"material": "brick"}, "bodies.wall"),
        ("mechanisms.wall.kind", "singel-block", "mechanisms.wall.kind"),
        ("mechanisms.wall.sides", "three", "mechanisms.wall.sides"),
        ("mechanisms.wall.loads", [{"kind": "tie", "force": "3", "at": [0, 0, 1]}], "mechanisms.wall.loads[0].force"),
        ("mechanisms.wall.loads", [{"kind": "tei"}], "mechanisms.wall.loads[0].kind"),
        ("mechanisms.wall.amplification", {"method": "srss", "height": "3"}, "mechanisms.wall.amplification.height"),
        ("mechanisms.wall.amplification", {"method": "SRSS"}, "mechanisms.wall.amplification.method"),
        ("site.spectrum.s_ds", "0.5", "site.spectrum.s_ds"),
        ("site.spectrum.code", "asce7", "site.spectrum.code"),
        ("site.spectrum", {"code": "asce7-16", "s_s": "1 g"}, "site.spectrum"),
        ("building.height", "9", "building.height"),
    ],
)
def test_a_fault_lies_at_the_key_that_is_wrong(
    path: str, value: Any, place: str, located: Draft202012Validator
) -> None:
    faults = list(located.iter_errors(changed(example("single_wall"), tuple(path.split(".")), value)))
    assert {fault.json_path for fault in faults} == {f"$.{place}"}


def test_tables_that_no_key_tells_apart_stay_a_choice() -> None:
    tables = {"A": {"properties": {"x": {}}}, "B": {"properties": {"x": {}, "y": {}}}}
    choice = {"$defs": tables, "oneOf": [{"$ref": "#/$defs/A"}, {"$ref": "#/$defs/B"}]}
    assert with_located_faults({"$defs": tables, "properties": {"z": choice}})["properties"]["z"]["oneOf"]


def test_every_table_of_a_choice_is_offered_to_the_editor() -> None:
    bodies = json_schema()["properties"]["bodies"]["additionalProperties"]
    assert [each.get("$ref", "").rpartition("/")[2] for each in bodies["anyOf"]] == [
        "MeshBody", "BoxBody", "ProfileBody", "DirectBody", "",
    ]  # fmt: skip
    assert "null" not in json.dumps(json_schema())
