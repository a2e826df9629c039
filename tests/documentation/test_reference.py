"""The pages made from the program are those of the program as it is, and every key, command and name is on them."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest
from typer.testing import CliRunner

import assess
from assess.cli.app import app
from assess.project.project_file import json_schema
from docs.ext import command_page
from docs.ext.docstring import split
from docs.ext.markdown import escape, heading_link
from docs.ext.pages import DOCS, PAGES
from docs.ext.schema_tables import places, title


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_a_page_is_what_the_program_makes(path):
    assert path.read_text(encoding="utf-8") == PAGES[path](), f"{path} is out of date; run `make pages` and commit it"


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_each_heading_of_a_page_has_a_link_of_its_own(path):
    links = [heading_link(each) for each in re.findall(r"^#+ (.+)$", _prose(path), re.MULTILINE)]
    assert len(links) == len(set(links))
    assert set(re.findall(r"\]\((#[^)]+)\)", _prose(path))) <= set(links)


def _prose(path) -> str:
    """Return a page without its blocks of code."""
    return re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)


@pytest.fixture(scope="module")
def tables() -> dict[str, str]:
    """The part of the page of keys for each table, by the table's heading."""
    headings = re.split(r"^##+ (.+)$", (DOCS / "reference" / "keys.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
    return {heading.lower(): text for heading, text in pairwise(headings[1:])}


def test_every_table_of_the_schema_has_its_keys_in_the_reference(tables):
    schema = json_schema()
    shown = {place.table.__name__: tables[title(place.table).lower()] for place in places()}
    defined = {name: table["properties"] for name, table in schema["$defs"].items() if "properties" in table}
    for name, keys in {**defined, "Content": schema["properties"]}.items():
        assert name.startswith("UncertainNumber") or [key for key in keys if f"| `{key}` |" not in shown[name]] == []


def test_a_key_shows_its_unit_its_bounds_and_its_default(tables):
    (thickness,) = re.findall(r"^\| `thickness` \|.*$", tables["a rectangular block"], re.MULTILINE)
    assert "| length [m], above 0" in thickness
    assert thickness.endswith("| **required** |")
    ec8 = tables["elastic spectrum of en 1998-1 with its recommended values"]
    assert "| `damping` | damping ratio of the spectrum | number, above 0, below 1 | 0.05 |" in ec8


def test_choices_are_those_of_the_schema(tables):
    ec8 = tables["elastic spectrum of en 1998-1 with its recommended values"]
    (row,) = re.findall(r"^\| `ground_type` \|.*$", ec8, re.MULTILINE)
    choices = json_schema()["$defs"]["Ec8SpectrumSection"]["properties"]["ground_type"]["enum"]
    assert [f'"{choice}"' for choice in choices] == re.findall(r'`("\w+")`', row.split(" | ")[2])


def test_a_help_is_what_the_command_prints():
    for shown in command_page.commands():
        words = shown.command_path.split()[1:]
        printed = CliRunner().invoke(app, [*words, "--help"], prog_name="assess", terminal_width=command_page.WIDTH)
        assert printed.output.split() == command_page.help_text(shown).split()


def test_every_public_name_is_shown_with_its_arguments():
    page = (DOCS / "reference" / "names.md").read_text(encoding="utf-8")
    headings = set(re.findall(r"^## (?:class )?(\w+)$", page, re.MULTILINE))
    assert headings == set(assess.__all__)
    assert "- `thickness`: size along x" in page
    assert "    mass: float,\n" in page
    assert "- `seat` [m]: of a bearing mass: how far its point" in page.replace("\\", "")


def test_a_docstring_is_split_into_sentences_and_names():
    first, second = split("Do it.\n\nParameters\n----------\na, b : one\n    and more\nc : three [m]")
    assert first.paragraphs == ("Do it.",)
    assert second.items == (("a, b", "one and more"), ("c", "three [m]"))


def test_text_is_shown_as_it_stands():
    assert escape("F_V of `a_g` [m]") == r"F\_V of `a_g` \[m\]"
