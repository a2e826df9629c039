"""The reference made from the program: every key, command and name is on its page."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import assess
from assess.project.project_file import json_schema
from docs.ext import command_pages, key_pages, name_pages
from docs.ext.docstring import split
from docs.ext.markdown import escape
from docs.ext.schema_tables import places

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def keys() -> dict[str, str]:
    return key_pages.pages()


def test_every_table_of_the_schema_has_its_keys_in_the_reference(keys):
    schema, text = json_schema(), "\n".join(keys.values())
    tables = {place.table.__name__: place.table for place in places()}
    defined = {name: table["properties"] for name, table in schema["$defs"].items() if "properties" in table}
    assert {name for name in defined if not name.startswith("UncertainNumber")} <= set(tables)
    for name in defined.keys() & tables.keys():
        for key in defined[name]:
            assert f"[`{key}`]{{#{schema['$defs'][name]['title'].lower()}-" in text, (name, key)
    for key in schema["properties"]:
        assert f"[`{key}`]" in keys["keys/project.md"], key


def test_a_key_shows_its_unit_its_bounds_and_its_default(keys):
    rows = dict(re.findall(r"^\| \[`(\w+)`\]\{#box-\w+\} \|(.*)$", keys["keys/bodies.md"], re.MULTILINE))
    assert "length [m]" in rows["thickness"]
    assert "above 0" in rows["thickness"]
    assert "**required**" in rows["thickness"]
    (damping,) = re.findall(r"^\| \[`damping`\]\{#ec8spectrum-damping\} \|(.*)$", keys["keys/site.md"], re.MULTILINE)
    assert damping.endswith("| number, above 0, below 1 | 0.05 |")


def test_choices_are_those_of_the_schema(keys):
    (row,) = re.findall(r"^\| \[`ground_type`\].*$", keys["keys/site.md"], re.MULTILINE)
    choices = json_schema()["$defs"]["Ec8SpectrumSection"]["properties"]["ground_type"]["enum"]
    assert [f'"{choice}"' for choice in choices] == re.findall(r'`("\w+")`', row.split(" | ")[2])


@pytest.mark.parametrize("shown", command_pages.commands(), ids=lambda shown: shown.name)
def test_every_option_of_a_command_is_on_its_page(shown):
    page = command_pages.pages()[f"commands/{'-'.join(shown.words)}.md"]
    for parameter in shown.command.params:
        for option in parameter.opts if parameter.param_type_name == "option" else ():
            assert getattr(parameter, "hidden", False) or option in page, option
    assert command_pages.first_sentence(shown).split(",")[0] in page


def test_every_public_name_has_a_page_with_its_arguments():
    pages = name_pages.pages()
    assert len(pages) == len(assess.__all__)
    assert "`thickness` | size along x" in pages["names/box.md"]
    assert pages["names/box.md"].count("# ") >= 3
    assert "    mass: float,\n" in pages["names/class-massload.md"]
    assert "| `seat` | m | of a bearing mass: how far its point" in pages["names/class-massload.md"]


def test_a_docstring_is_split_into_sentences_and_names():
    first, second = split("Do it.\n\nParameters\n----------\na, b : one\n    and more\nc : three [m]")
    assert first.paragraphs == ("Do it.",)
    assert second.items == (("a, b", "one and more"), ("c", "three [m]"))


def test_text_is_shown_as_it_stands():
    assert escape("F_V of `a_g` [m]") == r"F\_V of `a_g` \[m\]"


def test_every_page_made_is_in_a_table_of_contents(keys):
    listed = (ROOT / "docs" / "reference" / "keys.md").read_text(encoding="utf-8")
    assert [name for name in keys if f"../made/{name.removesuffix('.md')}\n" not in listed] == []
