"""A report in Italian: nothing of the program's is left in English, nothing of the user's is changed."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from pypdf import PdfReader
from reports.language.translation import Translator, translate_document
from reports.missing_translations import missing_sentences

import assess.examples
from assess.project.build import build
from assess.project.schema import load
from assess.results import Resolved, Results
from assess.study.run import run
from reports.assessment import assessment
from reports.document import Document, Figure, Sheet, Table, Text
from reports.language.catalogue import catalogue, parse_catalogue
from reports.render.pdf import write_pdf
from reports.render.vector import Letters, trace_figure

SMALL = parse_catalogue(
    {
        "unchanged": ["PGA"],
        "furniture": {},
        "sentences": {
            "a": {
                "{0} fails from PGA {1} g.": "{0}: non soddisfatta da PGA {1} g.",
                "a wall": "una parete",
                "Mechanism {0} is {1}.": "Il meccanismo {0} è {1}.",
                "fail": "no",
                "Records: {0}.": "Accelerogrammi: {0}.",
            }
        },
        "phrases": {
            "a": {"{0} and {1}": "{0} e {1}", "{0}, {1}": "{0}, {1}", "{0}. {1}": "{0}. {1}"},
            "b": {
                "{0} at {1} g ({2} of {3})": "{0} a {1} g ({2} su {3})",
                "{0} of {1}": "{0} di {1}",
                "{0} at {1}": "{0} a {1}",
            },
        },
    },
    language="it",
)


@pytest.fixture(scope="module")
def document(results: Results) -> Document:
    return replace(assessment(results), language="it")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("North fails from PGA 0.3 g.", "North: non soddisfatta da PGA 0.3 g."),
        ("Mechanism North is a wall.", "Il meccanismo North è una parete."),
        ("North, a wall and 3.5", "North, una parete e 3.5"),
        ("a wall and what nobody knows", "a wall and what nobody knows"),
        ("3 at 0.3 g (2 of 7) and 6 at 0.3 g (1 of 7)", "3 a 0.3 g (2 su 7) e 6 a 0.3 g (1 su 7)"),
        ("Records: nobody knows.", "Accelerogrammi: nobody knows."),
        ("Mechanism North is a wall. a wall", "Il meccanismo North è una parete. una parete"),
        ("", ""),
        ("12.5 kN/m² · φ", "12.5 kN/m² · φ"),
    ],
)
def test_sentences_gaps_and_lists(text: str, said: str) -> None:
    assert Translator(SMALL, frozenset({"North"})).translate(text) == said


@pytest.mark.parametrize(
    "name",
    [
        "a wall",
        "fail",
        "X fails from PGA 3 g.",
        "A and B",
        "{0}",
        "<b>x</b>",
        "a" * 10_000,
        "\U000f0000",
        "g",
        "=1+1",
        "x\ny z",
    ],
)
def test_a_name_is_never_changed(name: str) -> None:
    say = Translator(SMALL, frozenset({name})).translate
    assert say(name) == name
    assert name in say(f"{name} fails from PGA 0.3 g.")
    assert name in say(f"Mechanism {name} is a wall.")


def test_a_name_cut_short_or_broken_into_lines_is_kept() -> None:
    say = Translator(SMALL, frozenset({"A and B, of the north-east tower"})).translate
    assert say("A and B, of the nor… and a wall") == "A and B, of the nor… e una parete"
    assert say("A and B, of the\nnorth-\neast tower") == "A and B, of the\nnorth-\neast tower"


def test_english_is_left_as_it_is(results: Results) -> None:
    made = assessment(results)
    assert translate_document(made) is made


def test_nothing_of_the_fixture_is_left_in_english_but_what_it_invents(results: Results) -> None:
    """Its editions, reasons, steps and trails are no sentences of the program's; the names of its loads are markup."""
    invented = ("fewer than 5", "knowledge level LC1", "17.5-1", "non-stationary", "Appendix A", "Circolare 617", "<b>")
    steps = ("above the hinge", "factor of the weight", "equivalent damping", "demand over capacity")
    loads = ("floor <beam>", "=cmd()", "floor beam")
    known = (*invented, *steps, *loads)
    assert [text for text in missing_sentences(results, language="it") if not any(own in text for own in known)] == []


def test_nothing_of_a_real_run_is_left_in_english() -> None:
    found = run(build(load(Path(assess.examples.__file__).parent / "projects" / "single_wall" / "project.toml")))
    assert missing_sentences(found, language="it") == ()
    english = re.compile(r"\b(the|of|and|which|with|from|over|each|every)\b")
    shown = translate_document(replace(assessment(found), language="it"))
    assert [text for text in sentences(shown) if english.search(text)] == []


def sentences(document: Document) -> Iterator[str]:
    """Titles, paragraphs and captions."""
    yield from (section.title for section in document.sections)
    for block in document.blocks:
        if isinstance(block, Text):
            yield from block.paragraphs
        elif isinstance(block, Table | Sheet | Figure):
            yield block.caption


def test_numbers_and_names_are_those_of_the_english_report(document: Document) -> None:
    shown = translate_document(document)
    assert [shape(table) for table in document.tables] == [shape(table) for table in shown.tables]
    assert [sheet.name for sheet in document.sheets] == [sheet.name for sheet in shown.sheets]
    values = [[line.value for line in sheet.lines] for sheet in document.sheets]
    assert values == [[line.value for line in sheet.lines] for sheet in shown.sheets]


def shape(table: Table) -> tuple[object, ...]:
    """What a translation leaves of a table: names, kinds of columns, and every cell that is no text."""
    numbers = tuple(cell for row in table.rows for cell in row if not isinstance(cell, str))
    return (table.name, table.muted, tuple(column.kind for column in table.columns), numbers)


def test_hostile_labels_stand_as_they_are_in_every_table(results: Results) -> None:
    label = "overturned, <i>fails</i> and the records"
    mechanisms = tuple(replace(mechanism, label=label) for mechanism in results.mechanisms)
    made = replace(assessment(replace(results, mechanisms=mechanisms)), language="it")
    table = next(table for table in translate_document(made).tables if table.name == "verdicts")
    assert {row[0] for row in table.rows} == {label}
    assert any(label in section.title for section in translate_document(made).sections)


def test_given_values_are_not_translated(results: Results) -> None:
    project = {**results.project, "site.note": Resolved("the records", True)}
    made = translate_document(replace(assessment(replace(results, project=project)), language="it"))
    table = next(table for table in made.tables if table.name == "values")
    assert ("site.note", "the records", "dato") in table.rows


def test_figures_are_drawn_in_the_language(document: Document) -> None:
    drawn = {figure.name: figure for figure in translate_document(document).figures}
    letters = {mark.text for mark in trace_figure(drawn["spectrum"].draw()).marks if isinstance(mark, Letters)}
    assert {"periodo T [s]", "obiettivo"} <= letters
    assert "target" not in letters


def test_the_pdf_says_its_own_words_in_the_language(document: Document, tmp_path: Path) -> None:
    short = replace(document, sections=document.sections[:2])
    reader = PdfReader(write_pdf(translate_document(short), tmp_path / "report.pdf"))
    text = "\n".join(page.extract_text() for page in reader.pages)
    assert reader.trailer["/Root"]["/Lang"] == "it"
    assert all(word in text for word in ("Indice", "Esito", "pagina 1 di", "Tabella 1."))
    assert not re.search(r"\bpage \d|Contents|\bPASS\b|\bFAIL\b", text)


def test_every_pair_of_the_catalogue_is_found_again() -> None:
    """What stands in the catalogue is translated as it stands there, with marks in its gaps."""
    known = catalogue("it")
    say = Translator(known, frozenset()).translate
    for templates in known.by_word.values():
        for each in templates:
            gaps = [f"7{place}" for place in range(len(each.gaps))]
            filled = "".join(piece + gap for piece, gap in zip(each.fixed, [*gaps, ""], strict=True))
            assert say(filled) == each.fill(dict(zip(each.gaps, gaps, strict=True))), filled
