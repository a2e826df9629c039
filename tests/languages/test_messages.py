"""No message holds an English sentence that was composed: its values are numbers, names, terms and other messages."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from assess.examples import EXAMPLES, copy_example
from assess.messages.message import Message
from assess.messages.texts import TEXTS
from assess.project.build import build
from assess.project.project_file import load
from assess.results.json import dumps, loads
from assess.study.run import run_study
from tests.languages.fixed_terms import objects_in
from tests.support.examples import example_results
from tests.support.places import SOURCES

FOLDERS = ("assess", "records", "spectra")
MAKERS = frozenset({"message", "warning", "note", "reason_message"})
WORDS = re.compile(r"[a-z]{2,} [a-z]{2,}")
QUOTED = frozenset(
    {
        ("direction-left-out", "why"),  # an error of the mechanism in that direction
        ("not-assessed-low", "why"),  # an error of the case
        ("not-assessed-high", "why"),
        ("annex-left-aside", "why"),  # an error of the file
        ("file-not-read", "why"),  # an error of the file
        ("flatfile-columns-missing", "known"),  # names of columns
    }
)
"""Keys and values that quote errors or files as they are."""


def composed(data: object) -> set[tuple[str, str, str]]:
    """Keys and values of messages that hold words."""
    return {
        (each.key, name, value)
        for each in objects_in(data, Message)
        for name, value in each.values.items()
        if isinstance(value, str) and WORDS.search(value) and (each.key, name) not in QUOTED
    }


@pytest.mark.parametrize("name", [name for name in EXAMPLES if not EXAMPLES[name].models()])
def test_no_message_of_results_holds_a_sentence(name: str) -> None:
    results = example_results(name)
    assert next(objects_in(results, Message), None) is not None
    assert composed(results) == set()


@pytest.mark.parametrize("name", ["single_wall", "lnec_houses"])
def test_messages_of_results_json_are_those_of_the_run(name: str, tmp_path: Path) -> None:
    """Run without the scan; the results of single_wall above hold its messages."""
    project = copy_example(name, tmp_path / name)
    project.write_text(project.read_text(encoding="utf-8").replace("[analysis]", "[analysis]\nscan = false"))
    results = run_study(build(load(project)))
    assert composed(results) == set()
    assert set(objects_in(loads(dumps(results)), Message)) == set(objects_in(results, Message))


def test_a_sentence_in_a_message_is_found() -> None:
    inner = Message("mesh", "note", "", "", {"step": "2 holes of this mesh closed"})
    assert composed((Message("of-record", "note", "", "", {"what": inner}),)) == {
        ("mesh", "step", "2 holes of this mesh closed")
    }


def made(tree: ast.AST) -> Iterator[tuple[ast.Call, str, ast.AST]]:
    """The values of each message that a module makes."""
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        if isinstance(call.func, ast.Name) and call.func.id in MAKERS:
            yield from ((call, each.arg or "", each.value) for each in call.keywords)
            for given in (each for each in call.args if isinstance(each, ast.Dict)):
                for key, value in zip(given.keys, given.values, strict=True):
                    yield call, str(getattr(key, "value", "")), value


def written(value: ast.AST) -> str:
    """The letters of a literal, with gaps left blank; those of a choice, one after the other."""
    if isinstance(value, ast.JoinedStr):
        return "".join(written(part) or "\0" for part in value.values)
    if isinstance(value, ast.IfExp):
        return f"{written(value.body)}\0{written(value.orelse)}"
    return value.value if isinstance(value, ast.Constant) and isinstance(value.value, str) else ""


@pytest.mark.parametrize("folder", FOLDERS)
def test_no_message_is_made_with_a_sentence(folder: str) -> None:
    found = set()
    for file in sorted((SOURCES / folder).rglob("*.py")):
        for call, name, value in made(ast.parse(file.read_text(encoding="utf-8"))):
            if re.search(r"[a-z]{2,} |[a-z]{2,}\0| [a-z]{2,}", written(value)) and name not in {"where", "severity"}:
                found.add(f"{file.relative_to(SOURCES)}:{call.lineno} {name}")
    assert found == set()


def test_no_text_of_a_message_is_only_a_gap() -> None:
    assert not [key for key, text in TEXTS.items() if re.fullmatch(r"\{\w+\}", text)]
