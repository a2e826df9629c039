"""The file of each language: what it must hold, and what it must not."""

from __future__ import annotations

import ast
import re
import tomllib
from pathlib import Path

import pytest

import reports
from assess.cli.report import Language
from assess.codes.check import Outcome
from assess.codes.verdict import Decision
from assess.codes.verdict_text import outcome_text
from assess.project.sections.report import Report
from reports.document import Banner
from reports.figures.style import BANNER
from reports.language.catalogue import FOLDER, catalogue, languages, parse_catalogue
from reports.render.page import PAGE

EMPTY = {"unchanged": [], "furniture": {}, "sentences": {}, "phrases": {}}
NUMBER = re.compile(r"\d+(?:\.\d+)*")
OTHERS = languages()[1:]


def test_every_language_can_be_asked_for_and_has_a_name_in_the_pdf() -> None:
    assert [each.value for each in Language] == list(languages())
    assert Report.model_json_schema()["properties"]["language"]["enum"] == list(languages())


@pytest.mark.parametrize("language", OTHERS)
def test_words_that_renderers_ask_for_are_there(language: str) -> None:
    asked = {
        PAGE,
        *(
            Banner(word, "", near=near).word
            for word in BANNER
            for near in (False, True)
            if word != "incomplete" or not near
        ),
        *Outcome,
        *(outcome_text(each, near=near) for each in Decision for near in (False, True)),
        "yes",
        "no",
        "Figure",
        "Table",
        "Sheet",
    }
    for path in Path(reports.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "translate":
                asked |= {each.value for each in node.args if isinstance(each, ast.Constant)}
    assert asked - set(catalogue(language).furniture) == set()


@pytest.mark.parametrize("language", OTHERS)
def test_a_translation_keeps_every_number(language: str) -> None:
    """Clauses, tables, limits: what stands in digits is the same in both; a 1 may be a word."""
    for one, other in pairs(language).items():
        assert digits(one) == digits(other), one


def digits(text: str) -> list[str]:
    return sorted(number for number in NUMBER.findall(re.sub(r"\{\d+\}", "", text)) if number != "1")


@pytest.mark.parametrize("language", OTHERS)
def test_no_pair_of_templates_claims_the_same_sentence(language: str) -> None:
    pieces = [re.sub(r"\{\d+\}", "{}", one) for one in pairs(language)]
    assert {one for one in pieces if pieces.count(one) > 1} == set()


def pairs(language: str) -> dict[str, str]:
    content = tomllib.loads((FOLDER / f"{language}.toml").read_text(encoding="utf-8"))
    tables = [content["furniture"], *content["sentences"].values(), *content["phrases"].values()]
    return {one: other for table in tables for one, other in table.items()}


def test_a_language_without_a_file_is_refused() -> None:
    with pytest.raises(ValueError, match=r'report.language: "tlh" has no catalogue; known are en, it'):
        catalogue("tlh")


def test_a_path_is_no_language() -> None:
    with pytest.raises(ValueError, match="no catalogue"):
        catalogue("../languages/it")


def test_a_sentence_that_stands_twice_is_refused() -> None:
    with pytest.raises(ValueError, match='"At" stands twice'):
        parse_catalogue({**EMPTY, "sentences": {"a": {"At": "A"}, "b": {"At": "Istante"}}}, language="it")
