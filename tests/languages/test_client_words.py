"""What a client reads has words: no key of the project file, no line to type, in the signed pages of any example."""

from __future__ import annotations

import re
from dataclasses import asdict
from string import Formatter

import pytest

from assess.examples import EXAMPLES
from assess.messages.message import note
from assess.messages.texts import TEXTS
from reports.assessment import assessment
from reports.document import Equations, Sheet
from reports.language.client_texts import CLIENT_TERMS, CLIENT_TEXTS
from reports.language.locale import Locale
from reports.render.table_text import equations_line
from tests.languages.fixed_terms import fixed_terms
from tests.languages.test_reports import texts_in
from tests.support.examples import example_results
from tests.support.letters import letters

KEY = re.compile(
    r"(?<![\w/.])[a-z][a-z0-9]*(?:[-_][a-z0-9]+)*(?:\.[\w\-*]+|\[\d+\])+(?![\w/])"  # mechanisms.wall.loads[1]
    r"|(?<![\w./])[a-z]{2,}[0-9]*(?:_[a-z0-9]{2,})+"  # floor_vertical_ratio
    r"|(?<![\w._])[a-z][a-z-]{2,} = "  # tied = true
)
TABLE = re.compile(r"\[(?:building|site|verdict|records|analysis|report)\]")
FILES = (".ply", ".json", ".pdf", ".toml", ".csv", ".ifc")


@pytest.mark.parametrize("language", ["en", "it"])
@pytest.mark.parametrize("name", [name for name in EXAMPLES if EXAMPLES[name].file == "project.toml"])
def test_signed_pages_have_no_key_of_the_project_file(name: str, language: str) -> None:
    if EXAMPLES[name].models():
        pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    results = example_results(name)
    document = assessment(results, detail="main")
    locale = Locale(language, titles=document.numbers)
    own = str([each.value for each in results.project.values()]) + str(asdict(results.report))
    told = (locale.text(text) for text in texts_in(document.sections) if not isinstance(text, Sheet))
    blocks = (block for section in document.sections for block in section.blocks if isinstance(block, Equations))
    found = {match[0] for text in told for match in KEY.finditer(text)}
    assert not [block for block in blocks if TABLE.search(equations_line(block.steps, locale, str))]
    assert {each for each in found if each not in own and not each.endswith(FILES)} == set()


def test_words_for_a_client_replace_messages_that_have_the_same_gaps() -> None:
    for key, phrase in CLIENT_TEXTS.items():
        gaps, known = (
            {gap for _, gap, _, _ in Formatter().parse(text) if gap} for text in (phrase.english, TEXTS[key])
        )
        assert gaps <= known, key
        assert not KEY.search(phrase.english.replace("{", "").replace("}", "")) or "_d0" in phrase.english, key
    assert set(CLIENT_TERMS) <= set(fixed_terms())


def test_keys_and_methods_in_a_message_are_named() -> None:
    said = note("not-drawn", keys="mechanisms.W0a.p, mechanisms.W0a.radius")
    assert letters(said, Locale()).endswith("vouches for them: Frequency parameter p and Radius R")
    assert str(said.text).endswith("mechanisms.W0a.p, mechanisms.W0a.radius")
    load = note("missing-source", key="mechanisms.wall.loads[2].tied")
    assert letters(load, Locale()).endswith("connection of load 2")
