"""Project files and commands that the documents show are read: whole ones as they are, parts within a small project."""

from __future__ import annotations

import re
import shlex
import tomllib
from collections.abc import Mapping
from typing import Any

import pytest
import typer.main
from jsonschema import Draft202012Validator

from assess.cli.app import app
from assess.project.project_file import json_schema, load
from tests.support.places import MANUAL, ROOT, fenced
from tests.support.projects import as_editors_see, tables_toml

FOLLOWED = ROOT / "docs" / "tutorial"  # these pages are run as a whole: test_tutorials.py
MADE = ROOT / "docs" / "reference"  # of parts of shipped projects, and of helps: test_reference.py
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(page for page in MANUAL if MADE not in page.parents)]
AROUND = """
title = "Around a part"
[materials]
stone = { density = 2200, young_modulus = "3 GPa" }
[bodies]
wall = { material = "stone", box = { thickness = 0.5, length = 3.0, height = 4.0 } }
floor = { material = "stone", box = { thickness = 3.0, length = 3.0, height = 0.2, base = [1.5, 0, 4] } }
roof = { material = "stone", box = { thickness = 3.0, length = 3.0, height = 0.2, base = [1.5, 0, 5] } }
nave = { material = "stone", box = { thickness = 3.0, length = 3.0, height = 0.2, base = [1.5, 0, 6] } }
[mechanisms]
wall = { kind = "single-block", blocks = ["wall"] }
apse = { kind = "single-block", blocks = ["wall"] }
parapet = { kind = "single-block", blocks = ["wall"] }
pinnacle = { kind = "single-block", blocks = ["wall"] }
storey = { kind = "two-block", blocks = ["wall"] }
"""


BLOCKS = [
    pytest.param(text, id=f"{page.name}:{line}")
    for page in PAGES
    if FOLLOWED not in page.parents
    for line, text in fenced(page.read_text(encoding="utf-8"), "toml")
]
COMMANDS = [
    pytest.param(command, id=f"{page.name}:{number}")
    for page in PAGES
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1)
    if re.match(r" {4}(\$ )?assess ", line)
    for command in line.partition("#")[0].replace("$ ", "").split(";")
]
"""Lines of indented blocks that call the program."""


def merge(into: dict[str, Any], what: Mapping[str, Any]) -> dict[str, Any]:
    """Return a table with the keys of another put into it, table by table."""
    both = dict(into)
    for key, value in what.items():
        both[key] = merge(both[key], value) if isinstance(value, dict) and isinstance(both.get(key), dict) else value
    return both


def whole(text: str) -> dict[str, Any]:
    """A project that holds a block: the block itself, or a small project with the block in it or in its first wall."""
    given, around = tomllib.loads(text), tomllib.loads(AROUND)
    if "mechanisms" in given:
        return given
    if any(
        isinstance(value, dict) and not key.startswith(("interface", "amplification", "side_walls"))
        for key, value in given.items()
    ):
        return merge(around, given)
    return merge(around, {"mechanisms": {"storey" if "interfaces" in given else "wall": given}})


@pytest.mark.parametrize("text", BLOCKS)
def test_project_files_are_read(text, tmp_path):
    (tmp_path / "records").mkdir()
    (tmp_path / "records" / "one.AT2").write_text("a record")
    (tmp_path / "nga_west2.csv").write_text("a flatfile")
    file = tmp_path / "project.toml"
    file.write_text(tables_toml(**whole(text)), encoding="utf-8")
    assert load(file).content.mechanisms


@pytest.mark.parametrize("text", BLOCKS)
def test_an_editor_finds_no_fault_in_them(text, schema):
    assert [fault.message for fault in schema.iter_errors(as_editors_see(whole(text)))] == []


@pytest.fixture(scope="module")
def schema():
    """The schema of project files, as editors read it."""
    return Draft202012Validator(json_schema())


@pytest.mark.parametrize("line", COMMANDS)
def test_commands_and_their_options_exist(line):
    command: Any = typer.main.get_command(app)
    words = shlex.split(re.sub(r"[\[\]|]", " ", line.partition(">")[0]))[1:]
    while words and hasattr(command, "commands") and words[0] in command.commands:
        command = command.commands[words.pop(0)]
    assert not hasattr(command, "commands"), line
    options = {option for parameter in command.params for option in parameter.opts}
    assert [word for word in words if word.startswith("-") and word not in options and word != "--help"] == []
